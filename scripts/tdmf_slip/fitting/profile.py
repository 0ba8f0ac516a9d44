"""Intervals by the profile likelihood: a parameter is held, the others are fitted anew, and the loss rises.

The interval ends where it has risen by the quantile of chi square with one degree of freedom (Venzon and
Moolgavkar 1988, Applied Statistics 37, 87-94). Where the data tell the parameter well this is the linear
interval; where they tell it badly it is not symmetric, and may have no end.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from .problem import Problem
from .search import Bounds, Ended, searched

MET = 0.02
"""Relative error of the root of the rise at which the interval's end is interpolated."""
TRIES = 14
"""Largest number of tries to find an end."""
LONGEST, FARTHEST = 5.0, 40.0
"""First step of an unknown, and largest distance of an end, in tenths of the unknown's scale."""
CHANGE = 1e-4
"""Change of the loss at which a search with a held parameter ends."""
BETTER = 1e-3
"""Fall of the loss below the least one that says that this was none."""


@dataclass(frozen=True, eq=False)
class End:
    """One end of an interval."""

    at: float
    """The unknown; infinite where there is no end."""
    why: str
    """Reason why it ends before the rise: `range` or `gaits`; else empty."""


class BetterFitError(Exception):
    """With a parameter held, the loss is less than the least one."""

    def __init__(self, at: NDArray[np.float64]) -> None:
        """Where."""
        super().__init__("the loss is less elsewhere")
        self.at = at


class Profile:
    """The profile of a fit."""

    def __init__(
        self,
        problem: Problem,
        best: Ended,
        bounds: Bounds,
        robust: bool,
        covariance: NDArray[np.float64],
        rise: float,
    ) -> None:
        """Around the fit `best`, by its linear covariance and the loss's rise at an interval's end."""
        self.problem, self.best, self.bounds, self.robust = problem, best, bounds, robust
        self.covariance, self.root = covariance, float(np.sqrt(rise))
        self._apexes = problem.apexes()

    def interval(self, number: int) -> tuple[End, End]:
        """Both ends of the interval of a parameter; `BetterFitError` where the fit was none."""
        low, high = (self._end(number, sign) for sign in (-1.0, 1.0))
        self.problem.restart(self.best.at, self._apexes)
        return low, high

    def _end(self, number: int, sign: float) -> End:
        """By the secant method on the root of the rise, which is nearly linear."""
        self.problem.restart(self.best.at, self._apexes)
        begin, bound = float(self.best.at[number]), float(self.bounds[sign > 0.0][number])
        spread = float(np.sqrt(self.covariance[number, number]))
        inside, outside, seen = (0.0, 0.0), None, self.best.at
        step = min(self.root * spread, LONGEST) if spread > 0.0 else LONGEST
        why = ""
        for _ in range(TRIES):
            far = min(step, sign * (bound - begin))
            if far <= inside[0]:
                return End(bound, "range")
            found = self._constrained(number, begin + sign * far, seen)
            if found is None:
                step, why = 0.5 * (inside[0] + far), "gaits"
                if far - inside[0] < MET * far:
                    return End(begin + sign * inside[0], why)
                continue
            root = self._root(found)
            if root < self.root:
                inside, seen = (far, root), found.at
                if far == sign * (bound - begin):
                    return End(bound, "range")
            else:
                outside = (far, root)
            if abs(root - self.root) <= MET * self.root:
                break
            if outside is None and far >= FARTHEST:
                return End(sign * np.inf, "")
            step = self._next(inside, outside, why)
        if outside is None and not abs(inside[1] - self.root) <= MET * self.root:
            return End(begin + sign * inside[0], why) if why else End(sign * np.inf, "")
        far = self._interpolated(inside, outside or inside)
        return End(begin + sign * far, "")

    def _next(self, inside: tuple[float, float], outside: tuple[float, float] | None, why: str) -> float:
        """How far to go."""
        if outside is not None:
            span = outside[0] - inside[0]
            return float(np.clip(self._interpolated(inside, outside), inside[0] + 0.1 * span, outside[0]))
        longer = inside[0] * self.root / max(inside[1], 1e-3 * self.root)
        return float(np.clip(1.02 * longer, 1.1 * inside[0], (1.3 if why else 3.0) * inside[0]))

    def _interpolated(self, inside: tuple[float, float], outside: tuple[float, float]) -> float:
        rise = outside[1] - inside[1]
        if rise <= 0.0:
            return inside[0] * self.root / max(inside[1], 1e-3 * self.root)
        return inside[0] + (outside[0] - inside[0]) * (self.root - inside[1]) / rise

    def _root(self, found: Ended) -> float:
        rise = found.loss - self.best.loss
        if rise < -BETTER * max(1.0, self.best.loss):
            raise BetterFitError(found.at)
        return float(np.sqrt(max(rise, 0.0)))

    def _constrained(self, number: int, value: float, seen: NDArray[np.float64]) -> Ended | None:
        """The others fitted while one is held, from where they are predicted; None where no gaits are."""
        moved = value - seen[number]
        along = self.covariance[:, number] / (self.covariance[number, number] or 1.0)
        for share in (1.0, 0.0):
            begin = seen + share * moved * along
            begin[number] = value
            begin = np.clip(begin, *self.bounds)
            try:
                found = searched(self.problem, begin, self.bounds, self.robust, number, CHANGE)
            except RunError:
                continue
            if np.isfinite(found.residuals).all():
                return found
        return None
