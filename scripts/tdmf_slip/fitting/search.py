"""Least-squares search, also with Huber's loss, to which a single outlier contributes little.

A search may end on a kink, because quantities of gaits have a kink where the word of a gait changes. There
the sum of squares may be least although its gradient is not zero. It is least if a mean of the gradients of
the regions that meet, with weights that are not negative, is zero. Else the shortest mean, in the metric of
the Gauss-Newton method, leads down along the kink (Lemarechal 1975; Wolfe 1975, Mathematical Programming
Study 3, 145-173).

At a fold, a branch of gaits turns back. Its gaits have no derivatives by parameters there, and a search along
them ends. A search across folds varies parameters and apices at once, with strides that need not close. The
difference between the ends of a stride is then a residual with a large weight. In the end it is so small that
the search along the gaits can go on from there.
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
from ..numerics.newton import Vector
from .problem import FIRST_STEP, Problem, Request
from .result import is_likely

MAX_STEPS = 60
"""Largest number of evaluations in a search."""
CHANGE = 1e-9
"""Relative change of the sum of squares and of the unknowns, and slope, at which a search ends."""
INSIDE = 1e-9
"""Least distance of an unknown from its bounds at the start of a search; SciPy would move a closer one."""
HUBER = 1.345
"""Residual up to which Huber's loss is the square: for normal data its efficiency is then 95 %."""
STATIONARY, ROUNDING = 1e-2, 1e-4
"""Distance of a parameter from its optimum that counts as zero.

The distance is relative to the standard error, or to the length of all residuals."""


@dataclass(frozen=True, eq=False)
class Ended:
    """End of a search."""

    at: Vector
    """Unknowns, shape (p,)."""
    residuals: Vector
    """Residuals at the unknowns."""
    loss: float
    """Sum of squares, or of Huber's loss."""
    at_bound: NDArray[np.int_]
    """Active bound of each unknown: -1 at the lower bound, 1 at the upper one, else 0."""
    tries: int
    """Number of tries of the search."""
    ended: bool
    """True if the search ended by itself, not by the number of tries."""
    on_border: bool = False
    """True if the loss is least on a kink, where the word of a gait changes."""


def best_from(problem: Problem, begin: Vector) -> Ended:
    """Search from some unknowns; if the residuals stay large, also across folds nearby; then along kinks."""
    found = searched(problem, begin)
    if (
        problem.lost
        and not problem.is_spent
        and not is_likely(found.loss, problem.request.degrees_of_freedom)
    ):
        apexes, beyond = problem.apexes, across_folds(problem, found.at)
        further = None if beyond is None else searched(problem, beyond)
        if further is not None and further.loss < found.loss:
            found, problem.crossed = further, True
        elif further is not None:
            problem.restart(found.at, apexes)
    if not problem.is_spent and np.isfinite(found.loss):
        found = past_kinks(problem, found)
    return found


def searched(problem: Problem, begin: Vector, fixed: int | None = None, change: float = CHANGE) -> Ended:
    """Result of a search with all unknowns free but the one that is fixed."""
    low, high = problem.bounds
    free = np.arange(len(begin)) != fixed
    inside = INSIDE * np.maximum(1.0, np.abs(begin))
    first = np.where(free, np.clip(begin, low + inside, high - inside), begin)
    if not free.any() or not np.isfinite(problem.residuals(first)).all():
        residuals = problem.residuals(begin)
        return Ended(begin, residuals, loss_of(residuals, problem.robust), np.zeros(len(begin), int), 0, True)
    robust: dict[str, Any] = {"loss": "huber", "f_scale": HUBER} if problem.robust else {}
    # From zero, SciPy's first step is no longer than one.
    at, found = _least_squares(problem, first, np.zeros(len(begin)), free, change, MAX_STEPS, **robust)
    active = np.zeros(len(begin), int)
    active[free] = found.active_mask
    return Ended(at, found.fun, 2.0 * found.cost, active, found.nfev, found.status > 0)


def _least_squares(
    problem: "Problem | Across",
    origin: Vector,
    begin: Vector,
    free: NDArray[np.bool_],
    change: float,
    tries: int,
    **loss: Any,
) -> tuple[Vector, Any]:
    """Run SciPy's `least_squares` over the distances of the free unknowns from an origin.

    Returns all unknowns at the end of the search, and SciPy's result.
    """
    from scipy.optimize import least_squares  # slow to load

    def at(step: Vector) -> Vector:
        there = origin.copy()
        there[free] += step
        return np.clip(there, *problem.bounds)

    found: Any = least_squares(
        lambda step: problem.residuals(at(step)),
        begin[free],
        lambda step: problem.jacobian(at(step))[:, free],
        bounds=(problem.bounds - origin)[:, free],
        method="trf",
        ftol=change,
        xtol=change,
        gtol=change,
        max_nfev=tries,
        **loss,
    )
    return at(found.x), found


def loss_of(residuals: Vector, robust: bool) -> float:
    """Sum of squares, or of Huber's loss."""
    size = np.abs(residuals)
    return float(np.sum(np.where(robust & (size > HUBER), 2.0 * HUBER * size - HUBER**2, size**2)))


def weights_of(residuals: Vector, robust: bool) -> Vector:
    """Weights of residuals and derivatives that turn the loss into squares: less than 1 for outliers."""
    size = np.abs(residuals)
    weights: Vector = np.sqrt(HUBER / np.maximum(size, HUBER)) if robust else np.ones_like(size)
    return weights


def is_stationary(ended: Ended, jacobian: Vector, robust: bool) -> bool:
    """True if no parameter within its range could decrease the loss, to first order."""
    weights = weights_of(ended.residuals, robust)
    residuals, slopes = weights * ended.residuals, weights[:, None] * jacobian
    sizes = np.linalg.norm(slopes, axis=0)
    sizes[sizes == 0.0] = 1.0
    left = -(residuals @ slopes) / sizes
    outwards = left * ended.at_bound > 0.0
    maximum = max(STATIONARY, ROUNDING * float(np.linalg.norm(residuals)))
    return bool(np.all(outwards | (np.abs(left) <= maximum)))


def starts(first: Gait, request: Request) -> Iterator[Gait]:
    """Gaits to begin with, those nearest to the data first; gaits close to an earlier one are left out."""

    def loss(runner: Runner, apex: Vector) -> float:
        """Huber's loss of a gait over all rows."""
        losses = []
        for row in request.measurements.rows:
            has = plain_stride(runner, apex, tuple(row)).quantities
            off = [(value - of.value) / of.error for value, of in zip(has, row.values(), strict=True)]
            losses.append(loss_of(np.array(off), True))
        return sum(losses)

    vary = (*request.shared, *request.each)
    return settled_gaits(first, vary, partial(around, first.runner)).gaits(loss)


ROUNDS, REGIONS = 12, 8
"""Largest number of searches along kinks, and of gradients at one point."""
ASIDE = 1e-4
"""Step aside at which the gradient of another region is evaluated."""
SHORTEST = 1e-4
"""Shortest step down, as a share of the Gauss-Newton step."""
LEVEL = 1e-4
"""Fall of the loss that counts as none."""
SUFFICIENT = 0.1
"""Share of the predicted fall that a step has to achieve."""
HEAVY = 1e4
"""Weight of the equation that the weights of a mean add up to 1."""


def past_kinks(problem: Problem, ended: Ended) -> Ended:
    """Search on along kinks until the loss is least."""
    for _ in range(ROUNDS):
        try:
            if is_stationary(ended, problem.jacobian(ended.at), problem.robust):
                return ended
            to, is_minimum = _lower_along_kink(problem, ended)
        except (RunError, np.linalg.LinAlgError):
            break
        if is_minimum:
            return replace(ended, ended=True, on_border=True)
        if to is None:
            break
        further = searched(problem, to)
        if not further.loss < ended.loss - LEVEL * SUFFICIENT:
            break
        ended = further
    problem.residuals(ended.at)
    return ended


def _lower_along_kink(problem: Problem, ended: Ended) -> tuple[Vector | None, bool]:
    """Point of less loss, from a point with a gradient; without one, True if the loss is least already."""
    free = ended.at_bound == 0
    if not free.any():
        return None, False
    gradient, square = _slopes(problem, ended.at, free)
    inverse: Vector = np.asarray(np.linalg.pinv(square, hermitian=True), dtype=np.float64)
    gradients = [gradient]
    for _ in range(REGIONS):
        mean = _shortest(np.array(gradients), inverse)
        down, promised = np.zeros(len(free)), float(mean @ inverse @ mean)
        down[free] = -inverse @ mean
        if promised <= LEVEL:
            return None, len(gradients) > 1
        share = 1.0
        while share >= SHORTEST:
            to = np.clip(ended.at + share * down, *problem.bounds)
            residuals = problem.residuals(to)
            if np.isfinite(residuals).all():
                loss = loss_of(residuals, problem.robust)
                if loss < ended.loss - SUFFICIENT * share * promised:
                    return to, False
            share *= 0.3
        aside = ended.at + ASIDE * down / max(1e-300, float(np.max(np.abs(down))))
        gradients.append(_slopes(problem, np.clip(aside, *problem.bounds), free)[0])
    return None, False


def _slopes(problem: Problem, at: Vector, free: NDArray[np.bool_]) -> tuple[Vector, Vector]:
    """Half the gradient of the loss, and the Gauss-Newton part of its second derivatives."""
    residuals = problem.residuals(at)
    if not np.isfinite(residuals).all():
        raise RunError("there are no gaits beside the kink")
    weights = weights_of(residuals, problem.robust)
    slopes = weights[:, None] * problem.jacobian(at)[:, free]
    return slopes.T @ (weights * residuals), slopes.T @ slopes


def _shortest(gradients: Vector, inverse: Vector) -> Vector:
    """Shortest mean in a metric, with weights that are not negative."""
    from scipy.optimize import nnls  # slow to load

    values, vectors = np.linalg.eigh(inverse)
    lengths = gradients @ (vectors * np.sqrt(np.maximum(values, 0.0)))
    size = float(np.max(np.abs(lengths))) or 1.0
    rows = np.vstack([lengths.T / size, HEAVY * np.ones(len(gradients))])
    weights, _ = nnls(rows, np.append(np.zeros(lengths.shape[1]), HEAVY))
    mean: Vector = weights / weights.sum() @ gradients
    return mean


WEIGHT = 1e3
"""Weight of a stride's residual over the coordinates' scales, beside residuals over their errors."""
MAX_STEPS_ACROSS, CHANGE_ACROSS = 100, 1e-6
"""Largest number of evaluations, and relative change at which the search ends."""


class Across:
    """Residuals of a problem and of strides that should close, over parameters and apices."""

    def __init__(self, problem: Problem, unknowns: Vector) -> None:
        """Begin at the gaits at which the Jacobian of the problem was last evaluated."""
        self.problem, self._first = problem, np.array(problem.apexes)
        self._scales = problem.runner.scales
        self._last: Vector | None = None
        self.begin = np.append(unknowns, np.zeros(self._first.size))
        self.bounds = np.hstack([problem.bounds, np.outer([-np.inf, np.inf], np.ones(self._first.size))])

    def split(self, at: Vector) -> tuple[Vector, Vector]:
        """Unknowns of the problem, and apices of the strides, shape (rows, n)."""
        unknowns, moved = np.split(at, [len(self.problem.parameters)])
        return unknowns, self._first + FIRST_STEP * self._scales * moved.reshape(self._first.shape)

    def _strides(self, at: Vector, stride: Any, *varied: Sequence[str]) -> tuple[list[Any], Vector]:
        problem, (unknowns, apexes) = self.problem, self.split(at)
        values, made = problem.values(unknowns), []
        for number, (row, apex) in enumerate(zip(problem.rows, apexes, strict=True)):
            problem.count_strides(1)
            made.append(stride(problem.runner_of(values, number), apex, tuple(row), *varied))
        return made, values

    def residuals(self, at: Vector) -> Vector:
        """Residuals of the problem, then those of closing; infinite if a stride does not reach an apex.

        Once all allowed strides are made, the last residuals are returned, so that the search ends.
        """
        if self.problem.is_spent and self._last is not None:
            return self._last.copy()
        try:
            strides, values = self._strides(at, plain_stride)
        except (InputError, RunError):
            return np.full(len(self.problem.errors) + self._first.size, np.inf)
        closing = [WEIGHT * stride.residual / self._scales for stride in strides]
        self._last = np.concatenate([self.problem.over_errors(strides, values), *closing])
        return self._last.copy()

    def jacobian(self, at: Vector) -> Vector:
        """Jacobian of the residuals."""
        problem, width = self.problem, self._first.shape[1]
        strides, _ = self._strides(at, varied_stride, problem.vary)
        count, unknowns = len(problem.errors), len(problem.parameters)
        slopes = np.zeros((count + self._first.size, len(at)))
        slopes[:count, :unknowns] = problem.by_unknowns([stride.by_all[width:, width:] for stride in strides])
        for k, (rows, columns, stride) in enumerate(
            zip(problem.places, problem.columns, strides, strict=True)
        ):
            here, moved = np.arange(k * width, (k + 1) * width), FIRST_STEP * self._scales
            weights = WEIGHT / self._scales[:, None]
            slopes[rows, unknowns + here] = stride.by_all[width:, :width] * moved / problem.errors[rows, None]
            slopes[np.ix_(count + here, unknowns + here)] = weights * stride.by_all[:width, :width] * moved
            by_values = stride.by_all[:width, width:] * problem.steps[columns]
            slopes[np.ix_(count + here, columns)] = weights * by_values
        return slopes


def across_folds(problem: Problem, unknowns: Vector, fixed: int | None = None) -> Vector | None:
    """Unknowns beyond a fold at which a search along the gaits has ended, with all free but the one fixed.

    The problem goes on from there. None if no gaits are found beyond the fold.
    """
    across = Across(problem, unknowns)
    if not np.isfinite(across.residuals(across.begin)).all():
        return None
    free = np.arange(len(across.begin)) != fixed
    origin = np.where(free, 0.0, across.begin)
    try:
        at, _ = _least_squares(across, origin, across.begin, free, CHANGE_ACROSS, MAX_STEPS_ACROSS)
        reached, apexes = across.split(at)
        values = problem.values(reached)
        runners = [problem.runner_of(values, row) for row in range(len(apexes))]
        problem.restart(reached, [gait_near(*ends).apex for ends in zip(runners, apexes, strict=True)])
    except (InputError, RunError):
        return None
    return reached
