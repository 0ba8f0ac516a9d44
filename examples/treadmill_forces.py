"""A table to fit, from the forces of a treadmill: a row for each recording, means of all its steps.

    python examples/treadmill_forces.py RBDS001runT25forces.txt RBDS001runT35forces.txt > run.csv
    tdmf-slip fit run.csv --vary-each leg.stiffness,hip.stance_torque,hip.touchdown_angle --model reduced

Each file is a tab-separated table with 300 rows a second. Its column Fy is the vertical force in newtons, as
in the recordings of Fukuchi, Fukuchi and Duarte (2017, PeerJ 5:e3298, data at
doi:10.6084/m9.figshare.4543435). The file's name has the speed, in tenths of a metre per second, behind a T.
Left and right foot are not distinguished, because a stride of the model is a step. An empty cell is a gap.
Steps that touch a gap are left out, and their number is printed on stderr.
"""

import csv
import itertools
import re
import sys
from pathlib import Path

import numpy as np

COLUMN = "Fy"
"""Title of the column of the vertical force, in upper or lower case."""
RATE = 300.0
"""Rows a second."""
THRESHOLD = 30.0
"""Newtons: the foot is on the ground where the force is more."""
SHORTEST = 0.05
"""Duration in seconds below which a contact or a flight is noise."""
HEADER = ("speed [m/s]", "frequency [Hz]", "stance_time [s]", "peak_force [N]")


def speed_of(path):
    """Speed in m/s, from the name of the file."""
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


def read_forces(path):
    """The column Fy, with NaN for each gap."""
    try:
        with open(path, encoding="utf-8-sig", newline="") as file:
            header, *rows = csv.reader(file, delimiter="\t")
    except (OSError, ValueError) as problem:
        raise SystemExit(f"{path}: cannot be read: {problem}; allowed: a table with a header") from None
    titles = [title.strip().lower() for title in header]
    if COLUMN.lower() not in titles:
        raise SystemExit(f"{path}: the columns {', '.join(titles)}; allowed: with the force in {COLUMN}")
    column = titles.index(COLUMN.lower())
    cells = [row[column].strip() if len(row) > column else "" for row in rows]
    if any("," in cell for cell in cells) and any("." in cell for cell in cells):
        raise SystemExit(f"{path}: decimal commas and points; allowed: one of the two, and no other mark")
    try:
        return np.array([float(cell.replace(",", ".") or "nan") for cell in cells])
    except ValueError as problem:
        raise SystemExit(f"{path}: {problem}; allowed: numbers, or empty cells") from None


def steps_of(force):
    """Rows, rows in contact and peak force of each step without a gap, and how many steps have a gap."""
    is_gap = ~np.isfinite(force)
    rows = np.arange(len(force))
    known = force if is_gap.all() else np.interp(rows, rows[~is_gap], force[~is_gap])
    down, up = contacts(known)
    whole, cut = [], []
    for begin, lift, end in zip(down[:-1], up[:-1], down[1:], strict=True):
        if is_gap[begin - 1 : end + 1].any():
            cut.append(end - begin)  # several steps, where the gap is long
        else:
            whole.append((end - begin, lift - begin, force[begin:lift].max()))
    columns = np.array(whole, dtype=float).reshape(-1, 3).T
    usual = np.median(columns[0]) if whole else np.inf
    return columns, sum(max(1, round(length / usual)) for length in cut)


def row_of(path):
    """Means over the steps, each with its standard error."""
    (steps, stances, peaks), left_out = steps_of(read_forces(path))
    if left_out:
        print(f"{path}: {left_out} steps touch a gap and are left out", file=sys.stderr)
    if len(steps) < 3:
        raise SystemExit(
            f"{path}: {len(steps)} steps; allowed: 3 or more, with the force in the column {COLUMN}"
        )
    reported = [(speed_of(path), 0.01)]
    for values in (steps / RATE, stances / RATE, peaks):
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
