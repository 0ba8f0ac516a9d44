"""The search for the least sum of squares, or of a loss that a datum far off changes little."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .problem import Problem

MAX_STEPS = 60
"""Tries of the search."""
CHANGE = 1e-9
"""Change of the sum of squares, of the unknowns, and of the slope at which the search ends."""
INSIDE = 1e-9
"""Distance of an unknown from its bounds where a search begins; SciPy would move a closer one."""
HUBER = 1.345
"""Errors up to which Huber's loss is the square: of normal data it then tells 95 % of what squares do."""
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
    """There."""
    loss: float
    """The sum of squares, or of the loss."""
    at_bound: NDArray[np.int_]
    """Active bound of each unknown: -1 or 1 where it is at its least or greatest value, else 0."""
    tries: int
    """Number of tries of the search."""
    ended: bool
    """By itself, not by the number of tries."""
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
    """By which residuals and their changes count where the loss is taken as squares: 1, or less where far."""
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
