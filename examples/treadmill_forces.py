"""A table to fit, from the forces of a treadmill: a row for each recording, means of all its steps.

    python examples/treadmill_forces.py RBDS001runT25forces.txt RBDS001runT35forces.txt > run.csv
    tdmf-slip fit run.csv --vary-each leg.stiffness,hip.stance_torque,hip.touchdown_angle --model reduced

Each file is a table between tabulators with the vertical force in newtons in the column Fy, 300 rows a
second; so others read those of Fukuchi, Fukuchi and Duarte (2017, PeerJ 5:e3298, data at
doi:10.6084/m9.figshare.4543435). The speed, in tenths of a metre per second, stands in its name behind a T.
Neither foot is told from the other, for a stride of the model is a step.
"""

import csv
import itertools
import re
import sys
from pathlib import Path

import numpy as np

RATE = 300.0
"""Rows a second."""
THRESHOLD = 30.0
"""Newtons: the foot is on the ground where the force is more."""
SHORTEST = 0.05
"""Seconds of a contact, or of a flight; what is shorter is noise."""
HEADER = ("speed [m/s]", "frequency [Hz]", "stance_time [s]", "peak_force [N]")


def speed_of(path):
    """By the name of the file."""
    found = re.search(r"T(\d\d)", Path(path).stem)
    if found is None:
        raise SystemExit(f"{path}: no speed in its name; allowed: as in RBDS001runT25forces.txt")
    return int(found[1]) / 10.0


def contacts(force):
    """First rows with the foot on the ground, and first rows without, of contacts that begin and end."""
    loaded = force > THRESHOLD
    for wanted in (True, False):  # short flights are closed, then short contacts left out
        edges = np.flatnonzero(np.diff(loaded.astype(int))) + 1
        for begin, end in itertools.pairwise(edges):
            if loaded[begin] != wanted and end - begin < SHORTEST * RATE:
                loaded[begin:end] = wanted
    change = np.diff(loaded.astype(int))
    down, up = np.flatnonzero(change == 1) + 1, np.flatnonzero(change == -1) + 1
    up = up[up > down[0]] if len(down) else up
    return down[: len(up)], up


def row_of(path):
    """Means over the steps, each with its standard error."""
    with open(path, encoding="utf-8") as file:
        force = np.array([float(row["Fy"] or "nan") for row in csv.DictReader(file, delimiter="\t")])
    down, up = contacts(np.nan_to_num(force))
    if len(down) < 3:
        raise SystemExit(f"{path}: {len(down)} steps; allowed: 3 or more, with the force in the column Fy")
    peaks = np.array([force[begin:end].max() for begin, end in zip(down, up, strict=True)])
    steps, stances = np.diff(down) / RATE, (up - down) / RATE
    reported = [(speed_of(path), 0.01)]
    for values in (steps, stances, peaks):
        reported.append((values.mean(), values.std(ddof=1) / np.sqrt(len(values))))
    period, error = reported[1]
    reported[1] = 1.0 / period, error / period**2
    return [cell for value, its_error in reported for cell in (f"{value:.6g}", f"{max(its_error, 1e-9):.3g}")]


def main():
    """Print the table."""
    if len(sys.argv) < 2:
        raise SystemExit("a file of forces is missing; allowed: one for each speed")
    rows = [row_of(path) for path in sys.argv[1:]]
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow([cell for name in HEADER for cell in (name, name.replace(" [", "_error ["))])
    writer.writerows(rows)


if __name__ == "__main__":
    main()
