"""The search for the least sum of squares, or of a loss that a datum far off changes little.

A search may end on a kink: where words of gaits change, their quantities have one. There a sum of squares may
be least without being level. With gradients of the regions that meet, it is least where a mean of them, with
weights that are not negative, is zero. Else their shortest mean, in the metric of the Gauss-Newton method,
leads down along the kink (Lemarechal 1975; Wolfe 1975, Mathematical Programming Study 3, 145-173).

Where a branch of gaits turns back, its gaits have no derivatives by parameters, and a search along them ends.
A fit across folds searches parameters and apices at once, with strides that need not close. The difference
between the ends of a stride is then a residual, with so large a weight that little is left of it in the end:
near enough to a gait for the search along the gaits to go on from there.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..analysis.settled import around, settled_gaits
from ..errors import InputError, RunError
from ..library.fixed_point import gait_near
from ..library.gait import Gait
from ..library.runner import Runner
from ..library.strides import plain_stride, varied_stride
from .measurements import Measurements
from .problem import FIRST_STEP, Problem

MAX_STEPS = 60
"""Tries of the search."""
CHANGE = 1e-9
"""Change of the sum of squares, of the unknowns, and of the slope at which the search ends."""
INSIDE = 1e-9
"""Distance of an unknown from its bounds where a search begins; SciPy would move a closer one."""
HUBER = 1.345
"""Errors up to which Huber's loss is the square: for normal data its efficiency is then 95 %."""
STATIONARY, ROUNDING = 1e-2, 1e-4
"""Distance of a parameter from its best, over its standard error and over the length of all residuals."""

Bounds = tuple[NDArray[np.float64], NDArray[np.float64]]
"""Least and greatest values of the unknowns."""


@dataclass(frozen=True, eq=False)
class Ended:
    """How a search ended."""

    at: NDArray[np.float64]
    """The unknowns."""
    residuals: NDArray[np.float64]
    """Residuals at the unknowns."""
    loss: float
    """The sum of squares, or of the loss."""
    at_bound: NDArray[np.int_]
    """Active bound of each unknown: -1 or 1 where it is at its least or greatest value, else 0."""
    tries: int
    """Number of tries of the search."""
    ended: bool
    """Whether the search ended by itself, not by the number of tries."""
    on_border: bool = False
    """The loss is least there, but not level: on a kink, where the word of a gait changes."""


def searched(
    problem: Problem,
    begin: NDArray[np.float64],
    bounds: Bounds,
    robust: bool,
    fixed: int | None = None,
    change: float = CHANGE,
) -> Ended:
    """Result of SciPy's `least_squares`."""
    from scipy.optimize import least_squares  # slow to load

    free = np.arange(len(begin)) != (-1 if fixed is None else fixed)
    inside = INSIDE * np.maximum(1.0, np.abs(begin))
    at = np.where(free, np.clip(begin, bounds[0] + inside, bounds[1] - inside), begin)
    first = at.copy()

    def all_of(step: NDArray[np.float64]) -> NDArray[np.float64]:
        at[free] = first[free] + step  # from zero, where SciPy's first step is no longer than one
        return np.clip(at, *bounds)

    def none(tries: int) -> Ended:
        residuals = problem.residuals(begin)
        return Ended(begin, residuals, loss_of(residuals, robust), np.zeros(len(begin), int), tries, True)

    if not free.any() or not np.isfinite(problem.residuals(first)).all():
        return none(0)
    found: Any = least_squares(
        lambda step: problem.residuals(all_of(step)),
        np.zeros(int(free.sum())),
        lambda step: problem.jacobian(all_of(step))[:, free],
        bounds=(bounds[0][free] - first[free], bounds[1][free] - first[free]),
        method="trf",
        x_scale=1.0,
        ftol=change,
        xtol=change,
        gtol=change,
        max_nfev=MAX_STEPS,
        loss="huber" if robust else "linear",
        f_scale=HUBER if robust else 1.0,
    )
    active = np.zeros(len(begin), int)
    active[free] = found.active_mask
    there = all_of(found.x).copy()
    return Ended(there, found.fun, 2.0 * found.cost, active, found.nfev, found.status > 0)


def loss_of(residuals: NDArray[np.float64], robust: bool) -> float:
    """The sum of squares or, robustly, of Huber's loss."""
    size = np.abs(residuals)
    return float(np.sum(np.where(robust & (size > HUBER), 2.0 * HUBER * size - HUBER**2, size**2)))


def weights_of(residuals: NDArray[np.float64], robust: bool) -> NDArray[np.float64]:
    """Weights of residuals and their changes where the loss is taken as squares: 1, or less where far."""
    size = np.abs(residuals)
    far = robust & (size > HUBER)
    weights: NDArray[np.float64] = np.sqrt(np.where(far, HUBER / np.where(far, size, 1.0), 1.0))
    return weights


def is_stationary(ended: Ended, jacobian: NDArray[np.float64], robust: bool) -> bool:
    """Whether no parameter within its range could make the loss less, to first order."""
    weights = weights_of(ended.residuals, robust)
    residuals, slopes = weights * ended.residuals, weights[:, None] * jacobian
    sizes = np.linalg.norm(slopes, axis=0)
    sizes[sizes == 0.0] = 1.0
    left = -(residuals @ slopes) / sizes
    outwards = left * ended.at_bound > 0.0
    maximum = max(STATIONARY, ROUNDING * float(np.linalg.norm(residuals)))
    return bool(np.all(outwards | (np.abs(left) <= maximum)))


def starts(first: Gait, measurements: Measurements, vary: Sequence[str]) -> Iterator[Gait]:
    """Gaits to begin with, the nearest to the data first; none is near a nearer one."""

    def loss(runner: Runner, apex: NDArray[np.float64]) -> float:
        """Huber's loss of a gait over all rows."""
        losses = []
        for row in measurements.rows:
            has = plain_stride(runner, apex, tuple(row)).quantities
            off = [(value - of.value) / of.error for value, of in zip(has, row.values(), strict=True)]
            losses.append(loss_of(np.array(off), True))
        return sum(losses)

    return settled_gaits(first, vary, partial(around, first.runner)).gaits(loss)


ROUNDS, REGIONS = 12, 8
"""Searches that go on, and gradients at one place, at the most."""
ASIDE = 1e-4
"""Distance of an unknown at which another region is looked at."""
SHORTEST = 1e-4
"""Shortest step."""
LEVEL = 1e-4
"""Fall of the loss that is none."""
SUFFICIENT = 0.1
"""Share of the predicted fall that a step has to achieve."""
HEAVY = 1e4
"""Weight of the sum of weights."""


def past_kinks(problem: Problem, ended: Ended, bounds: Bounds, robust: bool) -> Ended:
    """Go on along kinks, to where the loss is least."""
    walk = _Walk(problem, bounds, robust)
    for _ in range(ROUNDS):
        try:
            if is_stationary(ended, problem.jacobian(ended.at), robust):
                return ended
            step = walk.step(ended)
        except (RunError, np.linalg.LinAlgError):
            break
        if step.is_minimum:
            return replace(ended, ended=True, on_border=True)
        if step.to is None:
            break
        further = searched(problem, step.to, bounds, robust)
        if not further.loss < ended.loss - LEVEL * SUFFICIENT:
            break
        ended = further
    problem.residuals(ended.at)
    return ended


@dataclass(frozen=True, eq=False)
class _Step:
    """Outcome of a step along a kink: the point at which the search goes on, if any."""

    to: NDArray[np.float64] | None
    is_minimum: bool


class _Walk:
    """Steps along kinks."""

    def __init__(self, problem: Problem, bounds: Bounds, robust: bool) -> None:
        self.problem, self.bounds, self.robust = problem, bounds, robust

    def step(self, ended: Ended) -> _Step:
        """The next step from a place that is not level."""
        free = ended.at_bound == 0
        if not free.any():
            return _Step(None, False)
        gradient, square = self._slopes(ended.at, free)
        inverse: NDArray[np.float64] = np.asarray(np.linalg.pinv(square, hermitian=True), dtype=np.float64)
        gradients = [gradient]
        for _ in range(REGIONS):
            mean = _shortest(np.array(gradients), inverse)
            down, promised = -inverse @ mean, float(mean @ inverse @ mean)
            if promised <= LEVEL:
                return _Step(None, len(gradients) > 1)
            to = self._lower(ended, free, down, promised)
            if to is not None:
                return _Step(to, False)
            aside = ended.at.copy()
            aside[free] += ASIDE * down / max(1e-300, float(np.max(np.abs(down))))
            gradients.append(self._slopes(np.clip(aside, *self.bounds), free)[0])
        return _Step(None, False)

    def _lower(
        self, ended: Ended, free: NDArray[np.bool_], down: NDArray[np.float64], promised: float
    ) -> NDArray[np.float64] | None:
        share = 1.0
        while share >= SHORTEST:
            to = ended.at.copy()
            to[free] += share * down
            to = np.clip(to, *self.bounds)
            residuals = self.problem.residuals(to)
            if np.isfinite(residuals).all():
                loss = loss_of(residuals, self.robust)
                if loss < ended.loss - SUFFICIENT * share * promised:
                    return to
            share *= 0.3
        return None

    def _slopes(
        self, at: NDArray[np.float64], free: NDArray[np.bool_]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Half the gradient of the loss, and the Gauss-Newton part of its second derivatives."""
        residuals = self.problem.residuals(at)
        if not np.isfinite(residuals).all():
            raise RunError("there are no gaits beside the kink")
        weights = weights_of(residuals, self.robust)
        slopes = weights[:, None] * self.problem.jacobian(at)[:, free]
        return slopes.T @ (weights * residuals), slopes.T @ slopes


def _shortest(gradients: NDArray[np.float64], inverse: NDArray[np.float64]) -> NDArray[np.float64]:
    """The mean, with weights that are not negative, of least length in a metric."""
    from scipy.optimize import nnls  # slow to load

    values, vectors = np.linalg.eigh(inverse)
    root = vectors * np.sqrt(np.maximum(values, 0.0))
    lengths = gradients @ root
    size = float(np.max(np.abs(lengths))) or 1.0
    rows = np.vstack([lengths.T / size, HEAVY * np.ones(len(gradients))])
    weights, _ = nnls(rows, np.append(np.zeros(lengths.shape[1]), HEAVY))
    mean: NDArray[np.float64] = weights / weights.sum() @ gradients
    return mean


WEIGHT = 1e3
"""Weight of a stride's residual over the coordinates' scales, beside residuals over their errors."""
MAX_STEPS_ACROSS, CHANGE_ACROSS = 100, 1e-6
"""Largest number of steps; change of the sum of squares and of the unknowns at which the search ends."""


class Across:
    """Residuals of quantities and of closing, over parameters and apices."""

    def __init__(self, problem: Problem, unknowns: NDArray[np.float64]) -> None:
        """Begin at the gaits at which the problem's Jacobian was last computed."""
        self.problem = problem
        self._apexes = np.array(problem.apexes())
        self._steps = FIRST_STEP * problem.runner.scales
        self._last: NDArray[np.float64] | None = None
        self.begin = np.append(unknowns, np.zeros(self._apexes.size))

    def unknowns(self, at: NDArray[np.float64]) -> NDArray[np.float64]:
        """Unknowns of the problem among all unknowns."""
        return at[: len(self.problem.parameters)]

    def apexes(self, at: NDArray[np.float64]) -> NDArray[np.float64]:
        """Apexes of the strides, shape (rows, n)."""
        moved = at[len(self.problem.parameters) :].reshape(self._apexes.shape)
        apexes: NDArray[np.float64] = self._apexes + self._steps * moved
        return apexes

    def residuals(self, at: NDArray[np.float64]) -> NDArray[np.float64]:
        """Row by row, those of quantities before those of closing; infinite where a stride does not close.

        Where no further stride is to be made, those of before, so that the search ends.
        """
        if self.problem.is_spent and self._last is not None:
            return self._last.copy()
        found = self._residuals(at)
        if np.isfinite(found).all():
            self._last = found
        return found

    def _residuals(self, at: NDArray[np.float64]) -> NDArray[np.float64]:
        problem, values = self.problem, self.problem.values(self.unknowns(at))
        parts = []
        for number, (row, apex) in enumerate(zip(problem.rows, self.apexes(at), strict=True)):
            problem.count_strides(1)
            try:
                stride = plain_stride(problem.runner_of(values, number), apex, tuple(row))
            except (InputError, RunError):
                return np.full(problem.count + self._apexes.size, np.inf)
            closing = WEIGHT * stride.residual / problem.runner.scales
            parts += [problem.over_errors(stride.quantities, number), closing]
        return np.concatenate([*parts, problem.off_priors(values)])

    def jacobian(self, at: NDArray[np.float64]) -> NDArray[np.float64]:
        """Jacobian of the residuals."""
        problem, values = self.problem, self.problem.values(self.unknowns(at))
        width = self._apexes.shape[1]
        blocks = []
        for number, (row, apex) in enumerate(zip(problem.rows, self.apexes(at), strict=True)):
            problem.count_strides(1)
            varied = varied_stride(problem.runner_of(values, number), apex, tuple(row), problem.vary)
            errors = np.array([of.error for of in row.values()])
            weights = np.append(problem.runner.scales / WEIGHT, errors)
            weighted = varied.by_all / weights[:, None]
            block = np.zeros((len(weighted), len(self.begin)))
            block[:, problem.columns[number]] = weighted[:, width:] * problem.steps[problem.columns[number]]
            first = len(problem.parameters) + number * width
            block[:, first : first + width] = weighted[:, :width] * self._steps
            blocks.append(np.roll(block, -width, axis=0))
        of_priors = problem.slopes_of_priors()
        blocks.append(np.hstack([of_priors, np.zeros((len(of_priors), self._apexes.size))]))
        return np.vstack(blocks)


def cross(
    problem: Problem,
    unknowns: NDArray[np.float64],
    bounds: tuple[NDArray[np.float64], NDArray[np.float64]],
) -> NDArray[np.float64] | None:
    """Go on where a search along the gaits has ended, and hand the gaits that are reached to the problem."""
    from scipy.optimize import least_squares  # slow to load

    across = Across(problem, unknowns)
    free = np.full(len(across.begin) - len(unknowns), np.inf)
    try:
        found: Any = least_squares(
            across.residuals,
            across.begin,
            across.jacobian,
            bounds=(np.append(bounds[0], -free), np.append(bounds[1], free)),
            method="trf",
            ftol=CHANGE_ACROSS,
            xtol=CHANGE_ACROSS,
            gtol=CHANGE_ACROSS,
            max_nfev=MAX_STEPS_ACROSS,
        )
        reached = across.unknowns(found.x)
        values = problem.values(reached)
        apexes = [
            gait_near(problem.runner_of(values, row), apex).apex
            for row, apex in enumerate(across.apexes(found.x))
        ]
        problem.restart(reached, apexes)
    except (InputError, RunError):
        return None
    return reached
