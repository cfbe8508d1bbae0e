#!/usr/bin/env python3
"""What whole impacts cost by two programs, run by turns on one core, to their settled ends.

usage: docs/notebook/speed/cost.py OLD NEW PARTICLES [-n PAIRS] [-c CASES] [-o TABLE.csv]
OLD and NEW are programs. OLD runs the scheme of before, `closing-voids` with a late phase at c/4; NEW the default. The
impacts are those of sweeps/studies/default.json; CASES, such as A,G, are some of them. Pair k is of seed k: how long
an impact takes to settle is a matter of chance. Seconds are of the processor, in user mode. The table is written
after each pair, and pairs that stand in it are kept.
"""
import argparse
import csv
import json
import math
import os
import pathlib
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
BEFORE = {"scheme": "closing-voids", "late_sound_speed": 0.25}
HEAD = ["particles_per_target", "case", "pair", "old_core_s", "new_core_s", "old_b_over_a", "new_b_over_a", "old_dL_over_L",
        "new_dL_over_L", "old_particle_steps", "new_particle_steps"]


def merged(a, b):
    return {k: merged(a[k], b[k]) if isinstance(a.get(k), dict) and isinstance(b.get(k), dict) else b.get(k, a.get(k))
            for k in {**a, **b}}


def run(program, scene, folder):
    """Processor seconds and the result."""
    scene_file = folder / "scene.json"
    scene_file.write_text(json.dumps(scene))
    out = folder / "out"
    shutil.rmtree(out, ignore_errors=True)
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run([program, "solve", scene_file, "--out", out, "--threads", "1"], text=True, capture_output=True,
                          env={**os.environ, "OMP_NUM_THREADS": "1"})
    if done.returncode:
        sys.exit(f"{program}: {done.stderr.strip()}")
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    return seconds, json.loads((out / "result.json").read_text())


def row_of(found):
    (old_s, old), (new_s, new) = found
    remnant = lambda r: (r["analysis"]["remnants"] or [{}])[0].get("b_over_a")
    return [f"{old_s:.2f}", f"{new_s:.2f}", remnant(old), remnant(new), old["run"]["dL_over_L"], new["run"]["dL_over_L"],
            old["run"]["particle_steps"], new["run"]["particle_steps"]]


def report(rows):
    by_size = {}
    for r in rows:
        by_size.setdefault(int(r["particles_per_target"]), {}).setdefault(r["case"], []).append(r)
    for size, cases in sorted(by_size.items()):
        logs = []
        for case, pairs in cases.items():
            ratio = statistics.median(float(r["new_core_s"]) / float(r["old_core_s"]) for r in pairs)
            logs.append(math.log(ratio))
            old, new = (statistics.median(float(r[k]) for r in pairs) for k in ("old_core_s", "new_core_s"))
            print(f"{size:6} {case:4} {old:8.1f} s {new:8.1f} s  {ratio:.2f}")
        print(f"{size:6} geometric mean of {len(logs)}: {math.exp(statistics.mean(logs)):.3f}")


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("old"), arguments.add_argument("new"), arguments.add_argument("particles", type=int)
    arguments.add_argument("-n", "--pairs", type=int, default=1)
    arguments.add_argument("-c", "--cases")
    arguments.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("cost.csv"))
    a = arguments.parse_args()
    study = json.loads((ROOT / "sweeps/studies/default.json").read_text())
    rows = list(csv.DictReader(a.output.open())) if a.output.exists() else []
    for pair in range(1, a.pairs + 1):
        for case in study["cases"]:
            if a.cases and case["name"] not in a.cases.split(","):
                continue
            key = [str(a.particles), case["name"], str(pair)]
            if any([r["particles_per_target"], r["case"], r["pair"]] == key for r in rows):
                continue
            size = {"numerics": {"particles_per_target": a.particles, "seed": pair}}
            new = {"numerics": {**study["scene"]["numerics"], "scheme": study["schemes"][0]}}
            scene = merged(merged({"end": study["scene"]["end"]}, case["scene"]), size)
            with tempfile.TemporaryDirectory() as folder:
                folder = pathlib.Path(folder)
                found = run(a.old, merged(scene, {"numerics": BEFORE}), folder), run(a.new, merged(scene, new), folder)
            rows.append(dict(zip(HEAD, [*key, *row_of(found)])))
            with a.output.open("w", newline="") as file:
                writer = csv.DictWriter(file, HEAD)
                writer.writeheader()
                writer.writerows(rows)
    report(rows)


main()
