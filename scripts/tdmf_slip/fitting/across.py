"""A fit across folds: parameters and apices at once, with strides that need not close on the way.

Where a branch of gaits turns back, its gaits have no derivatives by parameters, and a search along them ends.
Here the apices are unknowns, too, and what a stride leaves over is a residual that weighs so much that little
is left over in the end: near enough to a gait for the search along the gaits to go on from there.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError
from ..library.fixed_point import gait_near
from ..library.varied_stride import plain_stride, varied_stride
from .problem import FIRST_STEP, Problem

WEIGHT = 1e3
"""Weight of a stride's residual over the coordinates' scales, beside residuals over their errors."""
MAX_STEPS, CHANGE = 100, 1e-6
"""Largest number of steps; change of the sum of squares and of the unknowns at which the search ends."""


class Across:
    """Residuals of quantities and of closing, over parameters and apices."""

    def __init__(self, problem: Problem, unknowns: NDArray[np.float64]) -> None:
        """From the gaits at which the problem's Jacobian was asked for last."""
        self.problem = problem
        self._apexes = np.array(problem.apexes())
        self._steps = FIRST_STEP * problem.runner.scales
        self._last: NDArray[np.float64] | None = None
        self.begin = np.append(unknowns, np.zeros(self._apexes.size))

    def unknowns(self, at: NDArray[np.float64]) -> NDArray[np.float64]:
        """Those of the problem."""
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
            ftol=CHANGE,
            xtol=CHANGE,
            gtol=CHANGE,
            max_nfev=MAX_STEPS,
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
