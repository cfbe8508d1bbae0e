#!/usr/bin/env python3
"""Draws every kind of figure that the program can draw, and the page that shows them.

usage: docs/gallery/make.py [PROGRAM [WORK]]
PROGRAM is build/eerie and WORK, where impacts run and stay for the next time, build/gallery unless
told otherwise. The impacts have 400 particles per target: about four core-minutes for all.
"""
import json
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
NOTEBOOK = ROOT / "docs/notebook"


def grid(name, phi_d, speeds, angles, **more):
    return {"name": name, "grid": {"q": [1], "phi_d_deg": [phi_d], "v_imp_cm_per_s": speeds,
                                   "theta_imp_deg": angles}, **more}


SWEEPS = {
    "grid": grid("grid", 40, {"from": 14, "to": 24, "step": 2}, [10, 15, 20, 25]),
    "wide": grid("wide", 50, [10, 20, 30], [15, 25, 35]),
    "doubt": grid("doubt", 40, [18, 20], [15, 17.5]),
    "films": grid("films", 40, [24], [20], scene={"output": {"snapshot_interval_s": 500}}),
}
A = {"impact": {"q": 1, "theta_imp_deg": 15, "v_imp_cm_per_s": 20},
     "material": {"drucker_prager": {"phi_d_deg": 40}}}
STUDY = {"name": "small", "schemes": ["closing-gaps", "closing-voids"],
         "scene": {"end": {"time_s": 20000}, "output": {"history_interval_s": 250}},
         "cases": [{"name": "A", "title": "A: q = 1, φ_d = 40°, θ_imp = 15°, v_imp = 20 cm/s",
                    "scene": A}],
         "ladder": [{"particles_per_target": 400, "seeds": 1}]}
CHART = {"name": "small-chart", "fidelity": "sketch", "seeds": 2,
         "cases": [{"name": "A", "title": "q = 1, φ_d = 40°, θ_imp = 15°, v_imp = 20 cm/s", "scene": A},
                   {"name": "G", "title": "q = 1, φ_d = 40°, θ_imp = 15°, v_imp = 15 cm/s",
                    "scene": {**A, "impact": {**A["impact"], "v_imp_cm_per_s": 15}}}],
         "reference": {"label": "1,000 per target", "seeds": 1,
                       "set": {"numerics.particles_per_target": 1000}},
         "knobs": [{"name": "particles per target", "settings": [
                       {"label": str(n), "set": {"numerics.particles_per_target": n}}
                       for n in (250, 300)]},
                   {"name": "cfl", "settings": [{"label": str(x), "set": {"numerics.cfl": x}}
                                                for x in (0.4, 0.8)]},
                   {"name": "opening angle", "settings": [
                       {"label": str(x), "set": {"numerics.opening_angle": x}} for x in (0.3, 0.8)]},
                   {"name": "packing", "settings": [{"label": "lattice",
                                                     "set": {"numerics.packing": "lattice"}}]}]}


class Gallery:
    def __init__(self, program, work):
        self.program, self.work, self.page = program, work, []
        work.mkdir(parents=True, exist_ok=True)

    def eerie(self, *words):
        done = subprocess.run([self.program, *map(str, words)], cwd=self.work, text=True,
                              capture_output=True)
        if done.returncode:
            sys.exit(f"eerie {' '.join(map(str, words))}: {done.stderr}")
        return done.stdout

    def run(self, name, database, *words):
        (self.work / f"{name}.json").write_text(json.dumps(SWEEPS[name]))
        self.eerie("run", f"{name}.json", "--db", database, "--quiet", *words)

    def job(self, database, **where):
        words = [w for key, value in where.items() for w in (f"--{key}", value)]
        return self.eerie("query", "--db", database, *words, "--columns", "hash", "--format", "csv",
                          "--limit", 1).split()[-1]

    def show(self, title, file, words, command):
        self.page.append(f"## {title}\n\n    eerie {command}\n\n![{title}](gallery/{file})\n\n{words}\n")

    def draw(self, title, file, words, *command):
        """Draws with a command whose last words are the file, and shows it."""
        self.eerie(*command, "-o", HERE / file)
        for table in HERE.glob("*.csv"):
            table.unlink()
        shown = " ".join(str(w) for w in command)
        self.show(title, file, words, f"{shown} -o {file}")


def impacts(g):
    for name, database in (("grid", "grid.sqlite"), ("wide", "grid.sqlite"),
                           ("films", "films.sqlite")):
        g.run(name, database, "--fidelity", "sketch")
    g.run("doubt", "doubt.sqlite", "--fidelity", "auto", "--finest", "survey", "--most-seeds", 4)
    (g.work / "small.json").write_text(json.dumps(STUDY))
    (g.work / "small-chart.json").write_text(json.dumps(CHART))


def maps(g):
    g.draw("A map", "map.svg", "Colour and number say b/a, the letter what happened.",
           "map", "--db", "grid.sqlite", "--phi-d", 40)
    g.draw("All quantities of a map", "quantities.svg",
           "Letters stand in the panel of classes alone. The legend fills the free place.",
           "map", "--db", "grid.sqlite", "--phi-d", 40, "--quantity", "b/a,c/a,m-lr,period,class,n-eer,p-eer")
    g.draw("Maps of two places", "places.svg",
           "Where grids differ, each panel has axes of its own.", "map", "--db", "grid.sqlite")
    shutil.copy(g.work / "doubt-doubt-auto.svg", HERE / "auto.svg")
    g.show("The map of `--fidelity auto`", "auto.svg",
           "Which fidelity and how many seeds stand behind each cell; frames are in doubt.",
           "run doubt.json --fidelity auto --db doubt.sqlite")
    g.draw("Sizes of remnants", "sizes.svg", "How many remnants an impact leaves above each mass.",
           "sizes", "--db", "grid.sqlite")


def pictures(g):
    job = g.job("films.sqlite", v=24)
    for colour, words in (("body", "Five moments, chosen by what happens."),
                          ("depth", "How deep particles lay before the impact."),
                          ("speed", "Relative to the own clump.")):
        g.draw(f"Particles by {colour}", f"particles-{colour}.png", words,
               "show", job[:8], "--db", "films.sqlite", "--colour", colour)
    g.draw("A light curve", "lightcurve.svg", "One rotation in hours, and amplitude over aspect.",
           "lightcurve", job[:8], "--db", "films.sqlite")


def studies(g):
    out = g.work / "studies"
    g.eerie("converge", ROOT / "sweeps/studies/convergence.json", "--draw-only", "--known",
            NOTEBOOK / "convergence/runs.csv", "--db", "none.sqlite", "-o", out)
    shutil.copy(out / "C30.svg", HERE / "convergence.svg")
    g.show("Convergence of an impact", "convergence.svg", "Numbers of the notebook, drawn again.",
           "converge sweeps/studies/convergence.json --draw-only --known "
           "docs/notebook/convergence/runs.csv -o studies")
    g.eerie("converge", "small.json", "--db", "small.sqlite", "-o", out)
    shutil.copy(out / "A-diagnosis.svg", HERE / "diagnosis.svg")
    g.show("What acts in an impact", "diagnosis.svg", "One run of each scheme over time.",
           "converge small.json -o studies")
    g.eerie("chart", "small-chart.json", "--db", "chart.sqlite", "-o", out / "chart.svg")
    shutil.copy(out / "chart.svg", HERE / "chart.svg")
    shutil.copy(out / "chart-cases.svg", HERE / "chart-cases.svg")
    command = "chart small-chart.json -o chart.svg"
    g.show("Error against cost", "chart.svg", "Each mark is a setting of the solver.", command)
    g.show("What each setting makes of each impact", "chart-cases.svg", "The same runs, one by one.",
           command)


def disk(g):
    out = g.work / "disk"
    g.eerie("disk", "-o", out)
    for name, title in (("turbulence", "The disk: turbulence"), ("stirring", "The disk: larger bodies")):
        shutil.copy(out / f"{name}.svg", HERE / f"{name}.svg")
        g.show(title, f"{name}.svg", "Where impacts are slow enough for elongated bodies.",
               "disk -o disk")


def main():
    program = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/eerie").resolve()
    work = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else ROOT / "build/gallery").resolve()
    gallery = Gallery(str(program), work)
    for part in (impacts, maps, pictures, studies, disk):
        part(gallery)
    head = ("# All figures\n\nEvery kind of figure that the program draws. `make gallery` draws them "
            "anew; look at them before and after a change of one.\nThe impacts are small: 400 "
            "particles per target.\n\n")
    (ROOT / "docs/gallery.md").write_text(head + "\n".join(gallery.page))


if __name__ == "__main__":
    main()
