"""Gaits of runners whose parameters are spread over a box, side by side: thousands of them in a second.

Each runner begins near a gait that is known and makes strides until they repeat themselves. A runner that
falls begins once more, at the present apex of its nearest neighbour among those that run. Gaits found in this
way are stable, because unstable ones attract no runner. Of many points, `linked` chooses those where a search
is worth beginning, by multi-level single linkage (Rinnooy Kan and Timmer 1987, Mathematical Programming 39,
57-78): within a critical distance of a better point a search would lead into the same basin.
"""

import contextlib
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError
from ..library.batch import Batch
from ..library.batch_tables import CLOSED
from ..library.fixed_point import gait_near
from ..library.gait import Gait
from ..library.runner import Runner

RUNNERS = 1024
"""Number of runners that are spread over what varies."""
FACTOR = 4.0
"""Largest factor between a parameter's value and that of a runner, to both sides."""
FROM_ZERO = 0.4
"""Reach of a parameter that is zero, over its scale."""
TOLERANCE = 1e-6
"""Relative tolerance of a step: where runners settle need not be known any better."""
AT_ONCE = 8
"""Strides between two looks at which runners still run."""
STARTS, LOOKS = 3, 6
"""Starts of a runner that falls, and further looks after the last start."""
SETTLED = 1e-3
"""Distance, over the scales, to which a stride returns next to a gait."""
TAKEN_IN = 0.5
"""Largest distance of a neighbour to begin from, over the widths of the box."""
SIGMA = 4.0
"""Factor of the share of points near one. From 4 on, the number of searches stays finite."""


@dataclass(frozen=True, eq=False)
class Settled:
    """Runners over a box that have settled on gaits."""

    runners: tuple[Runner, ...]
    """The runners."""
    points: NDArray[np.float64]
    """Positions of the runners in the box, from 0 to 1, shape (m, d)."""
    apexes: NDArray[np.float64]
    """Apices next to those of their gaits, shape (m, n)."""

    def gaits(self, merit_of: Callable[[Runner, NDArray[np.float64]], float]) -> Iterator[Gait]:
        """Gaits from which a search is worth beginning, that of least merit first.

        A runner whose merit raises InputError or RunError is left out.
        """
        merits, known = [], []
        for number, (runner, apex) in enumerate(zip(self.runners, self.apexes, strict=True)):
            with contextlib.suppress(InputError, RunError):
                merits.append(merit_of(runner, apex))
                known.append(number)
        for k in linked(self.points[known], np.array(merits)):
            try:
                gait = gait_near(self.runners[known[k]], self.apexes[known[k]])
            except RunError:
                continue
            yield gait


def evenly(count: int, dimension: int, first: int = 0) -> NDArray[np.float64]:
    """Points that fill a box evenly: multiples of powers of a generalized golden ratio, modulo 1."""
    ratio = 1.5
    for _ in range(60):
        ratio = (1.0 + ratio) ** (1.0 / (dimension + 1))
    steps = ratio ** -np.arange(1.0, dimension + 1)
    numbers = first + 1.0 + np.arange(count)
    points: NDArray[np.float64] = (0.5 + numbers[:, None] * steps) % 1.0
    return points


def settled_gaits(
    begin: Gait, names: Sequence[str], values_of: Callable[[str, NDArray[np.float64]], NDArray[np.float64]]
) -> Settled:
    """Runners that settle, of many spread evenly; `values_of` gives values of a name by shares of its range.

    All begin at the apex of a gait.
    """
    points = evenly(RUNNERS, len(names))
    values = {name: values_of(name, shares) for name, shares in zip(names, points.T, strict=True)}
    runs = _Runs(begin, {name: np.ascontiguousarray(row) for name, row in values.items()})
    runs.begin()
    for _ in range(LOOKS):
        runs.go_on(runs.running.copy())
    numbers = np.flatnonzero(runs.running & (runs.returns < SETTLED))
    runners = (runs.runners[number] for number in numbers)
    kept = tuple(runner for runner in runners if runner is not None)
    return Settled(kept, points[numbers], runs.apexes[numbers])


def around(runner: Runner, name: str, shares: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values of a parameter: by factors of its own or, where that is zero, about it."""
    variable, value = runner.model.variables[name], runner[name]
    if value:
        values = value * FACTOR ** (2.0 * shares - 1.0)
    else:
        reach = FROM_ZERO * runner.scale_of(variable.unit)
        low, high = max(-reach, variable.minimum), min(reach, variable.maximum)
        values = low + shares * (high - low)
    clipped: NDArray[np.float64] = np.clip(values, variable.minimum, variable.maximum)
    return clipped


class _Runs:
    """Runners side by side."""

    def __init__(self, begin: Gait, varied: Mapping[str, NDArray[np.float64]]) -> None:
        self.runner, self.varied = begin.runner, varied
        rows = np.column_stack(list(varied.values()))
        low, high = rows.min(axis=0), rows.max(axis=0)
        self.points = (rows - low) / np.where(high > low, high - low, 1.0)
        self.runners = [self._runner(dict(zip(varied, row.tolist(), strict=True))) for row in rows]
        self.able = np.array([runner is not None for runner in self.runners])
        self.apexes = np.tile(begin.apex, (len(rows), 1))
        self.running = np.zeros(len(rows), dtype=bool)
        self.returns = np.full(len(rows), np.inf)

    def begin(self) -> None:
        """Begin at the given apex. Runners that fall begin again where their neighbours are."""
        from scipy.spatial import KDTree  # slow to load

        self.go_on(self.able)
        for _ in range(STARTS - 1):
            fallen = self.able & ~self.running
            if not (fallen.any() and self.running.any()):
                return
            runners = np.flatnonzero(self.running)
            far, nearest = KDTree(self.points[runners]).query(self.points[fallen])
            near = np.zeros_like(fallen)
            near[np.flatnonzero(fallen)[far <= TAKEN_IN]] = True
            self.apexes[near] = self.apexes[runners[nearest[far <= TAKEN_IN]]]
            if near.any():
                self.go_on(near)

    def go_on(self, which: NDArray[np.bool_]) -> None:
        """Make strides of some of the runners; runners that fall stop running."""
        if not which.any():
            return
        values = {name: row[which] for name, row in self.varied.items()}
        batch = Batch(self.runner, self.apexes[which], vary=values, tolerance=TOLERANCE)
        made = batch.run(AT_ONCE, record=True).recorded
        assert made is not None
        closed = (made["fate"] == CLOSED).all(axis=1) & (made["length"][:, -1] > 0.0)
        ends, begins = made["next_apex"][:, -1], made["apex"][:, -1]
        going = np.flatnonzero(which)[closed]
        self.running[which] = closed
        self.apexes[going] = ends[closed]
        self.returns[going] = np.linalg.norm((ends - begins)[closed] / self.runner.scales, axis=1)

    def _runner(self, values: Mapping[str, float]) -> Runner | None:
        """The runner with some values; None where the library does not take them together."""
        try:
            return self.runner.replace(values)
        except InputError:
            return None


def linked(points: NDArray[np.float64], merits: NDArray[np.float64]) -> Sequence[int]:
    """Numbers of the points that have none of less merit near them, the least merit first."""
    count = len(merits)
    if not count:
        return []
    dimension = points.shape[1]
    share = min(1.0, SIGMA * math.log(max(count, 2)) / count)
    reach = (math.gamma(1.0 + 0.5 * dimension) * share) ** (1.0 / dimension) / math.sqrt(math.pi)
    order = np.argsort(merits, kind="stable")
    taken = []
    for rank, number in enumerate(order):
        better = points[order[:rank]]
        if not np.any(np.linalg.norm(better - points[number], axis=1) < reach):
            taken.append(int(number))
    return taken
