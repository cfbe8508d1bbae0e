#!/usr/bin/env python3
"""Fills the tables of README.md beside it from the campaign's database: what stands between marks.

usage: docs/results/page.py EERIE DATABASE        (make.sh calls it)
"""
import collections
import csv
import io
import json
import pathlib
import re
import sqlite3
import statistics
import subprocess
import sys

PAGE = pathlib.Path(__file__).with_name("README.md")
SERIES = [("40 deg, coarse and fine grid (Figs. 2a, 2b)", "1", "40"), ("50 deg (Fig. 4)", "1", "50"), ("30 deg", "1", "30"),
          ("mass ratio 0.5 (Fig. 6)", "0.5", "50"), ("mass ratio 0.25", "0.25", "50")]
COLUMNS = "hash,q,phi_d_deg,v_imp_cm_per_s,theta_imp_deg,fidelity,settings,settled,b_over_a,m_lr_over_m_total,particles_per_target"


def said(*arguments):
    return subprocess.run(arguments, check=True, capture_output=True, text=True).stdout


def table(head, rows):
    lines = ["| " + " | ".join(str(x) for x in row) + " |" for row in [head, *rows]]
    return "\n".join([lines[0], "|" + "---|" * len(head), *lines[1:]])


def short(number):
    return f"{float(number):g}"


def impacts(runs):
    found = collections.defaultdict(list)
    for r in runs:
        found[tuple(short(r[k]) for k in ("q", "phi_d_deg", "v_imp_cm_per_s", "theta_imp_deg"))].append(r)
    return found


def is_eer(runs):
    return statistics.mean(r["b_over_a"] != "" and float(r["b_over_a"]) < 0.3 for r in runs) >= 0.5


def ridges(fits, standard):
    rows = {r["phi_d_deg"]: r for r in fits if r["q"] == 1 and "v_sin_theta_cm_per_s" in r}
    cells = {phi: {k: v for k, v in standard.items() if k[:2] == ("1", phi)} for phi in ("40", "50")}
    eers = {phi: [k for k, v in c.items() if is_eer(v)] for phi, c in cells.items()}
    span = lambda phi, k: "{:g} to {:g}".format(min(float(e[k]) for e in eers[phi]), max(float(e[k]) for e in eers[phi]))
    fit = lambda phi: "{v_sin_theta_cm_per_s:.2f} ({low_cm_per_s:.2f} to {high_cm_per_s:.2f})".format(**rows[float(phi)])
    return table(["equal bodies", "40 deg", "the paper", "50 deg", "the paper"], [
        ["v sin(theta) of the ridge, cm/s (95 %)", fit("40"), 5.1, fit("50"), 7.4],
        ["the same by [surveys](../notebook/results/README.md) of 1,000 particles", 4.77, "", 6.26, ""],
        ["EERs at speeds of, cm/s", span("40", 2), "15 to 25", span("50", 2), "up to 35"],
        ["EERs at angles of, deg", span("40", 3), "up to 20", span("50", 3), "up to 30"],
        ["impacts with an EER as the largest remnant in half of their runs"] +
        [x for phi in ("40", "50") for x in (f"{len(eers[phi])} of {len(cells[phi])}", "")]])


def statements(report):
    counts = ", ".join(f"{n} {verdict}" for verdict, n in report["counts"].items())
    rows = [[f["statement"], f["verdict"], f["found"]] for f in report["facts"] if f["verdict"] != "not enough data"]
    return (f"{len(report['facts'])} statements: {counts}. Those that are decided, or undecided for a reason other than missing runs:\n\n" +
            table(["the paper", "verdict", "here"], rows))


def fine(runs, standard):
    rows = []
    for place, some in impacts(r for r in runs if r["fidelity"] == "fine").items():
        text = lambda all: "{:.2f} ({:.2f}), {}".format(
            statistics.mean(float(r["b_over_a"]) for r in all if r["b_over_a"]),
            statistics.mean(float(r["m_lr_over_m_total"]) for r in all), len(all))
        rows.append(["{}, {} deg, {} cm/s, {} deg".format(*place), text(standard[place]), text(some)])
    return table(["impact: q, friction, speed, angle", "5,000 particles", "20,000"], rows)


def bill(runs, standard):
    hours = collections.Counter()
    for r in runs:
        hours[f"{int(r['particles_per_target']):,}"] += r["core_s"] / 3600
    cost = [r["core_s"] for r in runs if r["settings"] == "1"]
    rows = []
    for name, q, phi in SERIES:
        here = [v for k, v in standard.items() if k[:2] == (q, phi)]
        seeds = collections.Counter(len(v) for v in here)
        rows.append([name, len(here), sum(n for s, n in seeds.items() if s >= 3), sum(n for s, n in seeds.items() if s >= 6),
                     f"{sum(r['core_s'] for v in here for r in v) / 3600:.2f}"])
    rows.append(["all", len(standard), sum(r[2] for r in rows), sum(r[3] for r in rows), f"{sum(cost) / 3600:.2f}"])
    return (table(["series, `standard`", "impacts", "with three seeds or more", "with six or more", "core-hours"], rows) + "\n\n" +
            f"An impact of 5,000 particles takes {statistics.median(cost):.0f} core-seconds (median; {min(cost):.0f} to {max(cost):.0f}). " +
            "Core-hours by particles: " + ", ".join(f"{n} {h:.2f}" for n, h in hours.items()) + ", {:.2f} in all. ".format(sum(hours.values())) +
            f"{sum(r['settled'] == '0' for r in runs)} of {len(runs)} runs had not settled by 100,000 s.")


def main():
    eerie, database = sys.argv[1:]
    of = ["--db", database]
    runs = list(csv.DictReader(io.StringIO(said(eerie, "query", *of, "--columns", COLUMNS, "--format", "csv"))))
    with sqlite3.connect(f"file:{database}?mode=ro", uri=True) as connection:
        spent = dict(connection.execute("SELECT hash, total(core_seconds) FROM attempts a JOIN jobs j ON j.id = a.job_id GROUP BY hash"))
    for r in runs:
        r["core_s"] = spent[r["hash"]]
    standard = impacts(r for r in runs if r["settings"] == "1")
    blocks = {
        "ridges": ridges(json.loads(said(eerie, "threshold", *of, "--settings", "1", "--json"))["ridges"], standard),
        "statements": statements(json.loads(said(eerie, "check", *of, "--json"))),
        "fine": fine(runs, standard),
        "bill": bill(runs, standard),
    }
    page = PAGE.read_text()
    for name, text in blocks.items():
        page, found = re.subn(rf"(<!-- {name} -->\n).*?(\n<!-- end -->)", lambda m: m[1] + text + m[2], page, flags=re.S)
        if found != 1:
            sys.exit(f"{PAGE}: {found} places for {name}, one is wanted")
    PAGE.write_text(page)


main()
