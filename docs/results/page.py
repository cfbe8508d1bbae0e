#!/usr/bin/env python3
"""Fills the tables of README.md and in-doubt.md beside it from the campaign's database: what stands between marks.

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
import tempfile

HERE = pathlib.Path(__file__).parent
SWEEPS = HERE.parent.parent / "sweeps"
SERIES = [("40 deg, coarse and fine grid (Figs. 2a, 2b)", "1", "40"), ("50 deg (Fig. 4)", "1", "50"), ("30 deg", "1", "30"),
          ("mass ratio 0.5 (Fig. 6)", "0.5", "50"), ("mass ratio 0.25", "0.25", "50")]
COLUMNS = "hash,q,phi_d_deg,v_imp_cm_per_s,theta_imp_deg,seed,fidelity,settings,settled,class,b_over_a,m_lr_over_m_total,particles_per_target,scheme"
PAPERS_SCHEME = "libersky-petschek-2018"


def said(*arguments):
    """What a command prints; it says itself, in words for people, why it fails."""
    done = subprocess.run(arguments, stdout=subprocess.PIPE, text=True)
    if done.returncode != 0:
        sys.exit(f"{pathlib.Path(__file__).name}: stopped, since this failed: {' '.join(map(str, arguments))}")
    return done.stdout


def table(head, rows):
    lines = ["| " + " | ".join(str(x) for x in row) + " |" for row in [head, *rows]]
    return "\n".join([lines[0], "|" + "---|" * len(head), *lines[1:]])


def short(number):
    return f"{float(number):g}"


def place_of(run):
    return tuple(short(run[k]) for k in ("q", "phi_d_deg", "v_imp_cm_per_s", "theta_imp_deg"))


def impacts(runs):
    found = collections.defaultdict(list)
    for r in runs:
        found[place_of(r)].append(r)
    return found


def plain(runs, particles):
    """Those that are as by default but for so many particles."""
    return impacts(r for r in runs if r["is_plain"] and r["particles_per_target"] == str(particles))


def leaves_eer(run):
    return run["b_over_a"] != "" and float(run["b_over_a"]) < 0.3


def is_eer(runs):
    return statistics.mean(map(leaves_eer, runs)) >= 0.5


def in_words(place):
    return "{}, {} deg, {} cm/s, {} deg".format(*place)


def in_order(places):
    return sorted(places, key=lambda place: [-float(place[0]), *map(float, place[1:])])


def asked_by_statements():
    """The places of impacts on which statements of the paper rest."""
    points = [p for name in ("second-look", "fifty-thousand") for p in json.loads((SWEEPS / f"{name}.json").read_text())["points"]]
    return {place_of(p) for p in points}


def class_of(run):
    return run["class"]


def differ(runs, what):
    return len(set(map(what, runs))) > 1


def in_doubt(standard):
    """Impacts of which three seeds or more differ on class or EER."""
    return {k: v for k, v in standard.items() if len(v) >= 3 and (differ(v, class_of) or differ(v, leaves_eer))}


def ridges(fits, fine_fits, standard):
    of_equal_bodies = lambda some: {r["phi_d_deg"]: r for r in some if r["q"] == 1 and "v_sin_theta_cm_per_s" in r}
    fine = of_equal_bodies(fine_fits)
    cells = {phi: {k: v for k, v in standard.items() if k[:2] == ("1", phi)} for phi in ("40", "50")}
    eers = {phi: [k for k, v in c.items() if is_eer(v)] for phi, c in cells.items()}
    span = lambda phi, k: "{:g} to {:g}".format(min(float(e[k]) for e in eers[phi]), max(float(e[k]) for e in eers[phi]))
    words = "{v_sin_theta_cm_per_s:.2f} ({low_cm_per_s:.2f} to {high_cm_per_s:.2f})"
    fit = lambda phi: words.format(**of_equal_bodies(fits)[float(phi)])
    finer = lambda phi: (words + ", {impacts} impacts").format(**fine[float(phi)]) if float(phi) in fine else "too few impacts"
    return table(["equal bodies", "40 deg", "the paper", "50 deg", "the paper"], [
        ["v sin(theta) of the ridge, cm/s (95 %)", fit("40"), 5.1, fit("50"), 7.4],
        ["the same by [surveys](../notebook/results/README.md) of 1,000 particles", 4.77, "", 6.26, ""],
        ["the same with 20,000 particles, where 5,000 leave doubt, and beside", finer("40"), "", finer("50"), ""],
        ["EERs at speeds of, cm/s", span("40", 2), "15 to 25", span("50", 2), "up to 35"],
        ["EERs at angles of, deg", span("40", 3), "up to 20", span("50", 3), "up to 30"],
        ["impacts with an EER as the largest remnant in half of their runs"] +
        [x for phi in ("40", "50") for x in (f"{len(eers[phi])} of {len(cells[phi])}", "")]])


def statements(report):
    counts = ", ".join(f"{n} {verdict}" for verdict, n in report["counts"].items() if n > 0)
    rows = [[f["statement"], f["verdict"], f["found"]] for f in report["facts"] if f["verdict"] != "not enough data"]
    return (f"{len(report['facts'])} statements: {counts}. Those that do not lack runs:\n\n" +
            table(["the paper", "verdict", "here"], rows))


def second_look(runs, standard, unsure):
    """Impacts that were run by more than the standard, those aside that are in doubt alone."""
    def text(some):
        if not some:
            return ""
        ratios = [float(r["b_over_a"]) for r in some if r["b_over_a"]]
        spread = f" ± {statistics.stdev(ratios):.2f}" if len(ratios) > 2 else ""
        mass = statistics.mean(float(r["m_lr_over_m_total"]) for r in some)
        return f"{statistics.mean(ratios):.2f}{spread} ({mass:.2f}), {len(some)}"

    kinds = [plain(runs, 20000), plain(runs, 50000), impacts(r for r in runs if r["scheme"] == PAPERS_SCHEME)]
    places = set().union(*kinds) - (unsure.keys() - asked_by_statements())
    rows = [[in_words(place), text(standard[place]), *(text(kind.get(place)) for kind in kinds)] for place in in_order(places)]
    return table(["impact: q, friction, speed, angle", "5,000 particles", "20,000", "50,000", "the paper's scheme, 5,000"], rows)


def doubts(runs, unsure):
    """What 20,000 particles say where seeds differ; the same in a sentence."""
    fine = plain(runs, 20000)
    ratios = lambda some: ", ".join(f"{float(r['b_over_a']):.2f}" for r in some if r["b_over_a"])
    several = lambda some: "; ".join(f"{c} {ratios(r for r in some if r['class'] == c)}" for c in dict.fromkeys(map(class_of, some)))
    usual = lambda some: collections.Counter(map(class_of, some)).most_common(1)[0][0]
    tried = [k for k in unsure if k in fine]
    same = sum(usual(unsure[k]) == usual(fine[k]) for k in tried)
    eers = [k for k in tried if differ(unsure[k], leaves_eer)]
    still = sum(is_eer(fine[k]) for k in eers)
    rows = [[in_words(k), several(unsure[k]), several(fine.get(k, []))] for k in in_order(unsure)]
    return (table(["impact: q, friction, speed, angle", "5,000 particles, each run", "20,000"], rows),
            f"Of {len(unsure)} impacts whose seeds with 5,000 particles differ on class or EER, {'all' if len(tried) == len(unsure) else len(tried)} were run with 20,000: "
            f"{same} end there as most of their seeds do. Of {len(eers)} that leave an EER with some seeds, {still} "
            f"{'does' if still == 1 else 'do'} so with 20,000. Each of them: [in-doubt.md](in-doubt.md).")


def ridge_of_first_seeds(eerie, database, phi, seeds):
    """The ridge had each impact been run with so many seeds at most."""
    with tempfile.TemporaryDirectory() as folder:
        part = pathlib.Path(folder) / "part.sqlite"
        with sqlite3.connect(f"file:{database}?mode=ro", uri=True) as whole, sqlite3.connect(part) as copy:
            whole.backup(copy)
        with sqlite3.connect(part) as copy:
            later = "WHERE job_id IN (SELECT id FROM jobs WHERE seed > ?)"
            for results in ("job_remnants", "job_results"):
                copy.execute(f"DELETE FROM {results} {later}", [seeds])
        found = json.loads(said(eerie, "threshold", "--db", part, "--settings", "1", "--q", "1", "--phi-d", phi, "--json"))
        return "{v_sin_theta_cm_per_s:.2f} ({low_cm_per_s:.2f} to {high_cm_per_s:.2f})".format(**found["ridges"][0])


def certainty(eerie, database, runs, standard):
    """What core-time bought which answer."""
    rows = []
    for phi, surveys in (("40", ["259 surveys of 1,000 particles", "0.96 h", "4.77 (4.57 to 4.99)"]),
                         ("50", ["120 surveys of 1,000 particles", "0.66 h", "6.26 (5.83 to 6.89)"])):
        question = f"v sin(theta) of the ridge of {phi} deg, cm/s (95 %)"
        rows.append([question, *surveys])
        cells = [v for k, v in standard.items() if k[:2] == ("1", phi)]
        for seeds, name in ((1, "one seed of {n} impacts at 5,000"), (1000, "{n} runs of them, more where it is in doubt")):
            some = [r for v in cells for r in v if int(r["seed"]) <= seeds]
            rows.append([question, name.format(n=len(some)), f"{sum(r['core_s'] for r in some) / 3600:.2f} h",
                         ridge_of_first_seeds(eerie, database, phi, seeds)])
    study = list(csv.DictReader((HERE.parent / "notebook/convergence/default-0.1.0-runs.csv").open()))
    for question, case, place in (("b/a of the reference impact", "A", ("1", "40", "20", "15")),
                                  ("b/a of the unequal pair", "D", ("0.5", "50", "25", "20"))):
        def add(particles, ratios, seconds):
            spread = f" ± {statistics.stdev(ratios):.3f}" if len(ratios) > 1 else ""
            runs_of = f"{len(ratios)} runs of {particles:,} particles" if len(ratios) > 1 else f"a run of {particles:,} particles"
            rows.append([question, runs_of, f"{statistics.mean(seconds):.0f} s each", f"{statistics.mean(ratios):.3f}{spread}"])
        coarse = [r for r in study if r["case"] == case and r["particles_per_target"] == "1000"]
        add(1000, [float(r["b_over_a_1"]) for r in coarse], [float(r["core_s"]) for r in coarse])
        for particles in (5000, 20000, 50000):
            some = plain(runs, particles).get(place)
            if some:
                add(particles, [float(r["b_over_a"]) for r in some], [r["core_s"] for r in some])
    for before, row in zip(rows[-2::-1], rows[:0:-1]):  # a question stands once
        if row[0] == before[0]:
            row[0] = ""
    return table(["question", "what was run", "core time", "answer"], rows)


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
    first = sum(r["core_s"] for v in standard.values() for r in v if r["seed"] == "1") / 3600
    rows.append(["all", len(standard), sum(r[2] for r in rows), sum(r[3] for r in rows), f"{sum(cost) / 3600:.2f}"])
    return (table(["series, `standard`", "impacts", "with three seeds or more", "with six or more", "core-hours"], rows) + "\n\n" +
            f"An impact of 5,000 particles takes {statistics.median(cost):.0f} core-seconds (median; {min(cost):.0f} to {max(cost):.0f}), one seed of all of them {first:.1f} core-hours. " +
            "Core-hours by particles: " + ", ".join(f"{n} {h:.2f}" for n, h in hours.items()) + ", {:.2f} in all. ".format(sum(hours.values())) +
            f"{sum(r['settled'] == '0' for r in runs)} of {len(runs)} runs had not settled by 100,000 s.")


def fill(file, blocks):
    page = file.read_text()
    for name, text in blocks.items():
        page, found = re.subn(rf"(<!-- {name} -->\n).*?(\n<!-- end -->)", lambda m: m[1] + text + m[2], page, flags=re.S)
        if found != 1:
            sys.exit(f"{file}: {found} places for {name}, one is wanted")
    file.write_text(page)


def main():
    eerie, database = sys.argv[1:]
    of = ["--db", database]
    runs = list(csv.DictReader(io.StringIO(said(eerie, "query", *of, "--columns", COLUMNS, "--format", "csv"))))
    with sqlite3.connect(f"file:{database}?mode=ro", uri=True) as connection:
        spent = dict(connection.execute("SELECT hash, total(core_seconds) FROM attempts a JOIN jobs j ON j.id = a.job_id GROUP BY hash"))
        shared = {number: json.loads(scene) for number, scene in connection.execute("SELECT id, scene FROM job_settings")}
    for scene in shared.values():
        scene["numerics"].pop("particles_per_target")
    for r in runs:
        r["core_s"] = spent[r["hash"]]
        # As by default but for the particles: no other matter, scheme, viscosity or end.
        r["is_plain"] = shared[int(r["settings"])] == shared[1]
    standard = plain(runs, 5000)
    unsure = in_doubt(standard)
    blocks = {
        "ridges": ridges(*(json.loads(said(eerie, "threshold", *of, *which, "--json"))["ridges"]
                           for which in (("--settings", "1"), ("--fidelity", "fine"))), standard),
        "statements": statements(json.loads(said(eerie, "check", *of, "--json"))),
        "second look": second_look(runs, standard, unsure),
        "certainty": certainty(eerie, database, runs, standard),
        "bill": bill(runs, standard),
    }
    table_of_doubts, sentence = doubts(runs, unsure)
    fill(HERE / "README.md", {**blocks, "doubts": sentence})
    fill(HERE / "in-doubt.md", {"doubts": table_of_doubts})


main()
