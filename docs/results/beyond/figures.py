"""Draws the figures of these pages from their CSV files, with gnuplot: docs/results/beyond/figures.py"""
import csv
import pathlib
import subprocess

HERE = pathlib.Path(__file__).parent
OUT = HERE / "figures"
COLOURS = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#000000"]


def rows(name):
    """Lines of a CSV file, with numbers where there are numbers."""
    def value(text):
        try:
            return float(text)
        except ValueError:
            return text
    with open(HERE / f"{name}.csv", newline="") as file:
        return [{key: value(text) for key, text in row.items()} for row in csv.DictReader(file)]


def draw(name, x, y, curves, extra="", style="linespoints pt 7 ps 0.6 lw 2", colours=range(7)):
    """curves: {title: [(x, y), ...]} or {title: (points, style)}; written to figures/NAME.svg."""
    script = ["set terminal svg size 640,420 font 'DejaVu Sans,13' enhanced",
              f"set output '{OUT / name}.svg'", f"set xlabel '{x}'", f"set ylabel '{y}'",
              "set key outside right top", "set grid lc rgb '#dddddd'", extra]
    plots, data = [], []
    for k, (title, points) in enumerate(curves.items()):
        points, how = points if isinstance(points, tuple) else (points, style)
        plots.append(f"'-' title '{title}' with {how} lc rgb '{COLOURS[colours[k]]}'")
        data += [f"{a} {b}" for a, b in sorted(points)] + ["e"]
    script.append("plot " + ", ".join(plots))
    subprocess.run(["gnuplot"], input="\n".join(script + data), text=True, check=True)


def series(table, x, keep, y=lambda r: r["b_over_a"]):
    return [(x(r), y(r)) for r in table if keep(r) and r["b_over_a"] != ""]


def level(y):
    """The range of a ratio, with a line at y."""
    return ("set yrange [0:1]\n"
            f"set arrow from graph 0, first {y} to graph 1, first {y} nohead dt 2 lc rgb '#888888'")


EER = level(0.3)


def spin():
    table = rows("spin")
    def of(period, tilt):
        wanted = (period, tilt, 20)
        return series(table, lambda r: r["theta_imp_deg"],
                      lambda r: (r["spin_period_h"], r["spin_tilt_deg"], r["v_imp_cm_per_s"]) == wanted)
    draw("spin", "angle, 20 cm/s (deg)", "b/a of the largest remnant",
         {"prograde, 4 h": of(4, 0), "6 h": of(6, 0), "none": of(0, 0), "retrograde, 6 h": of(6, 180),
          "4 h": of(4, 180)}, EER)


def cohesion():
    table = rows("cohesion")
    draw("cohesion", "cohesion (Pa); left: none", "b/a of the largest remnant",
         {f"{v:g} cm/s": series(table, lambda r: r["cohesion_Pa"] or 1e-3, lambda r: r["v_imp_cm_per_s"] == v)
          for v in (15, 20, 25, 30)}, EER + "\nset logscale x")


def second_hit():
    table = rows("second-hit-remnant")
    turn = "target.shape.turn_deg"
    curves = {f"{q:g} of its mass, {name}": series(table, lambda r: r["v_imp_cm_per_s"],
              lambda r: (r["q"], r[turn], r["theta_imp_deg"]) == (q, at, 30))
              for q in (0.1, 0.3) for at, name in ((0, "end"), (90, "flank"))}
    draw("second-hit", "speed of the hit, 30° (cm/s)", "b/a of the largest remnant", curves, EER)


def size():
    draw("size", "radius of the target (m)", "b/a of the largest remnant",
         {"v/v_{esc} = 3.26": series(rows("size"), lambda r: r["target_radius_m"], lambda r: True)},
         EER + "\nset logscale x")


def disruption():
    table = rows("disruption")
    draw("disruption", "speed, head-on (cm/s)", "mass left",
         {f"{phi:g}°": [(r["v_imp_cm_per_s"], r["m_lr_over_m_total"]) for r in table if r["phi_d_deg"] == phi]
          for phi in (10, 20, 30, 40, 50)}, level(0.5))


def moonlets():
    table = rows("moonlets")
    curves = {f"{theta}° across": series(table, lambda r: r["distance_m"],
              lambda r: (r["azimuth_deg"], r["theta_imp_deg"]) == (90, theta), lambda r: 1 / r["b_over_a"])
              for theta in (0, 5, 10)}
    for theta, value in ((0, 1.20), (5, 1.36), (10, 1.63)):
        curves[f"{theta}°, published"] = ([(850, value), (3100, value)], "lines dt 2 lw 1")
    draw("moonlets", "distance of the primary (m)", "a/b of the moonlet", curves, "set logscale x\nset xrange [800:3500]\nset xtics (850, 1000, 1300, 2000, 3100)",
         colours=[0, 1, 2, 0, 1, 2])


def arrokoth():
    table = [r for r in rows("arrokoth") if r["rank"] == 1]
    draw("arrokoth", "speed (m/s)", "b/a of the largest remnant",
         {f"{theta:g}°": series(table, lambda r: r["v_imp_cm_per_s"] / 100, lambda r: r["theta_imp_deg"] == theta)
          for theta in (45, 60, 75, 85)}, "set yrange [0:1]")


def splitting():
    table = rows("splitting")
    curves = {"published": ([(30, 1.41), (45, 1.17), (60, 1.09)], "linespoints pt 6 lw 1")}
    for alpha in (0.8333, 0.3, 0.1):
        points = []
        for theta in (30, 45, 60):
            of = [r for r in table if (r["viscosity_alpha"], r["theta_imp_deg"], r["particles_per_target"]) == (alpha, theta, 1000)]
            merges = [r["v_over_v_esc"] for r in of if r["m_lr_over_m_total"] > 0.9]
            parts = [r["v_over_v_esc"] for r in of if r["m_lr_over_m_total"] < 0.6]
            if merges and parts:
                points.append((theta, (max(merges) + min(parts)) / 2))
        curves[f"alpha {alpha:g}"] = points
    draw("splitting", "angle (deg)", "speed at which they part, over v_{esc}", curves, "set yrange [1:2.2]")


def two_materials():
    table = [r for r in rows("two-materials") if r["impactor_rho0_kg_per_m3"] == 2700]
    def means(phi):
        of = series(table, lambda r: r["v_imp_cm_per_s"], lambda r: r["impactor_phi_d_deg"] == phi)
        return [(v, sum(b for a, b in of if a == v) / sum(a == v for a, _ in of)) for v in {a for a, _ in of}]
    draw("two-materials", "speed, 15° (cm/s)", "b/a of the largest remnant, mean of three seeds",
         {f"impactor {phi:g}°": means(phi) for phi in (20, 30, 40, 50, 60)}, EER)


if __name__ == "__main__":
    OUT.mkdir(exist_ok=True)
    for figure in (spin, cohesion, second_hit, size, disruption, moonlets, arrokoth, splitting, two_materials):
        figure()
