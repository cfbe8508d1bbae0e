#!/usr/bin/env python3
"""Two schemes beside each other, impact by impact, from tables that `eerie converge` wrote.

Usage: compare.py RUNS.csv SCHEME OTHER_RUNS.csv OTHER_SCHEME PARTICLES_PER_TARGET

Prints, for each impact of both, mean and standard deviation over seeds, how many standard errors
the means differ by, and the ratios of particle-steps and core-seconds (other over first). Core-seconds
are worth comparing only where both tables come from one machine.
"""

import csv
import math
import statistics
import sys

COLUMNS = {"b_over_a_1": "b/a", "c_over_a_1": "c/a", "m_1_over_m_total": "M_1/M", "period_1_h": "period h"}


def runs(path, scheme, particles):
    """The rows of one scheme and particle number, by the name of the impact."""
    found = {}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            if row["scheme"] == scheme and int(row["particles_per_target"]) == particles:
                found.setdefault(row["case"], []).append(row)
    return found


def values(rows, column):
    return [float(row[column]) for row in rows if row[column]]


def text(numbers):
    spread = statistics.stdev(numbers) if len(numbers) > 1 else 0
    return f"{statistics.mean(numbers):.3f} ± {spread:.3f}"


def standard_errors(one, other):
    """By how many standard errors of their difference two means differ; nothing from single runs."""
    if min(len(one), len(other)) < 2:
        return ""
    error = math.sqrt(statistics.variance(one) / len(one) + statistics.variance(other) / len(other))
    return f"{(statistics.mean(other) - statistics.mean(one)) / error:+.1f}" if error > 0 else ""


def geometric_mean(numbers):
    return math.exp(statistics.mean(map(math.log, numbers)))


def main():
    if len(sys.argv) != 6:
        sys.exit(__doc__)
    first = runs(sys.argv[1], sys.argv[2], int(sys.argv[5]))
    other = runs(sys.argv[3], sys.argv[4], int(sys.argv[5]))
    names = [name for name in first if name in other]
    if not names:
        sys.exit("the two tables have no impact in common at this particle number")
    ratios = {"particle_steps": [], "core_s": []}
    print("| impact | runs |", " | ".join(f"{c} | | differ by" for c in COLUMNS.values()),
          "| steps | core-s | dL/L |")
    print("|" + "---|" * (2 + 3 * len(COLUMNS) + 3))
    for name in names:
        cells = [name, f"{len(first[name])}, {len(other[name])}"]
        for column in COLUMNS:
            one, two = values(first[name], column), values(other[name], column)
            cells += [text(one), text(two), standard_errors(one, two)]
        for column, all_ratios in ratios.items():
            mean = [statistics.mean(values(rows[name], column)) for rows in (first, other)]
            all_ratios.append(mean[1] / mean[0])
            cells.append(f"{all_ratios[-1]:.2f}")
        drift = [max(values(rows[name], "dL_over_L")) for rows in (first, other)]
        cells.append(f"{drift[0]:.0e}, {drift[1]:.0e}")
        print("|", " | ".join(cells), "|")
    print(f"\ngeometric mean over {len(names)} impacts: particle-steps "
          f"{geometric_mean(ratios['particle_steps']):.2f}, core-seconds "
          f"{geometric_mean(ratios['core_s']):.2f}")


if __name__ == "__main__":
    main()
