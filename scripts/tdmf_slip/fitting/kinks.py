"""A search that has ended on a kink: where words of gaits change, their quantities have one.

There a sum of squares may be least without being level. With gradients of the regions that meet, it is least
where a mean of them, with weights that are not negative, is zero; else their shortest mean, in the metric of
the Gauss-Newton method, leads down along the kink (Lemarechal 1975; Wolfe 1975, Mathematical Programming
Study 3, 145-173).
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from .problem import Problem
from .search import Bounds, Ended, is_stationary, loss_of, searched, weights_of

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
    """Where to go on."""

    to: NDArray[np.float64] | None
    is_minimum: bool


class _Walk:
    """Steps along kinks."""

    def __init__(self, problem: Problem, bounds: Bounds, robust: bool) -> None:
        self.problem, self.bounds, self.robust = problem, bounds, robust

    def step(self, ended: Ended) -> _Step:
        """From a place that is not level."""
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
        """Half the gradient of the loss, and of its second derivatives what the first ones tell."""
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
