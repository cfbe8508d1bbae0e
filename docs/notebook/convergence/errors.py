#!/usr/bin/env python3
"""How far a single run is from fine ones, and what it costs: the table of how-to/settings.md.

usage: errors.py [SCHEME]     (closing-gaps, the default, unless told otherwise; reads runs.csv and
                               default-runs.csv beside it)
Error of b/a: root mean square over runs of the difference from the mean at 20,000 particles per
target by `closing-voids` (5,000 where there is no more). Class: part of the runs that have the most frequent one there.
"""
import collections
import csv
import pathlib
import statistics
import sys

ONCE = ("A", "F", "G", "R22")  # bodies merge at once or graze by

scheme = sys.argv[1] if len(sys.argv) > 1 else "closing-gaps"
runs, reference = collections.defaultdict(list), collections.defaultdict(list)
for name in ("runs.csv", "default-runs.csv"):
    for row in csv.DictReader((pathlib.Path(__file__).parent / name).open(newline="")):
        key = row["case"], int(row["particles_per_target"])
        if row["scheme"] == scheme:
            runs[key].append(row)
        if row["scheme"] == "closing-voids":
            reference[key].append(row)
cases = sorted({case for case, _ in runs})
fine = {}
for case in cases:
    finest = max(n for other, n in reference if other == case and n <= 20000)
    rows = reference[case, finest]
    classes = collections.Counter(row["class"] for row in rows)
    fine[case] = (finest, statistics.mean(float(row["b_over_a_1"]) for row in rows),
                  classes.most_common(1)[0][0])

print("| bodies meet | particles | impacts | core-s | b/a off by | class agrees |\n|---|---|---|---|---|---|")
for name, group in (("once", [c for c in cases if c in ONCE]),
                    ("again", [c for c in cases if c not in ONCE])):
    for n in (400, 1000, 2000, 5000):
        with_finer = [case for case in group if fine[case][0] > n and (case, n) in runs]
        if not with_finer:
            continue
        square, agree, cost = [], [], []
        for case in with_finer:
            rows = runs[case, n]
            square.append(statistics.mean((float(r["b_over_a_1"]) - fine[case][1])**2 for r in rows))
            agree.append(statistics.mean(r["class"] == fine[case][2] for r in rows))
            cost.append(statistics.mean(float(r["core_s"]) for r in rows))
        print(f"| {name} | {n:,} | {len(with_finer)} | {statistics.mean(cost):.0f} | "
              f"{statistics.mean(square)**0.5:.3f} | {statistics.mean(agree):.2f} |")
