"""The search along the edge that is kept off a fold: where det(I - J)^2 is at its least.

Near a fold gaits change as a square root does, so that a search in a box of parameters creeps: a straight
step along the edge leads off it, over the fold. On the edge itself all is smooth, with as many coordinates as
there are parameters less one.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from .along import AlongBorder, OnBorder
from .border import Border
from .gaits import Candidate, Gaits
from .problem import OFF_FOLD, Problem
from .region import Region
from .slsqp import minimize

NEAR = 0.5
"""Of `OFF_FOLD`: a gait as near to the edge is led onto it."""
RADIUS, SMALLEST, ROUNDS = 0.1, 1e-5, 12
"""Half the width of the first box and of the last one, of the bounds' width; and boxes."""
ON_EDGE, NEWTON = 1e-9, 12
"""What is left over of the edge's equation, and steps towards it."""
INWARDS, LONGEST = 1e-5, 0.1
"""Of the bounds' width: first and last step off the fold, where a point is beyond it."""


def is_near(gait: Candidate) -> bool:
    """Whether a gait is next to the edge."""
    return abs(gait.spectrum.fold / OFF_FOLD - 1.0) < NEAR


def best_on_edge(
    gaits: Gaits, problem: Problem, begin: Candidate, region: Region, stationary: float
) -> Candidate:
    """The best gait on the edge that is reached from one near it."""
    if len(begin.at) < 2:
        return begin
    without = Problem(replace(problem.goal, fold=False), problem.scales)
    wanted = AlongBorder(without, np.ones(len(begin.at), dtype=bool))
    best, radius = begin, RADIUS
    for _ in range(ROUNDS):
        try:
            chart = _Chart(gaits, best)
            here = chart.follow(chart.here(best), np.zeros(len(best.at) - 1))
        except RunError:
            break
        ended = minimize(
            wanted,
            chart.follow,
            here,
            here.at - radius,
            here.at + radius,
            lambda gait: region.has(gait.gait),
        )
        assert isinstance(ended.best, OnBorder)
        found = ended.best.border.short
        gained = problem.merit(best) - problem.merit(found)
        best = found if gained > 0.0 else best
        if problem.steepest(best) <= stationary:
            break
        radius *= 2.0 if gained > 0.0 and not ended.lost else 0.25
        if radius < SMALLEST:
            break
    return best


class _Chart:
    """Coordinates u on the edge: parameters are a point, a step across u, and one along the normal there."""

    def __init__(self, gaits: Gaits, begin: Candidate) -> None:
        self.gaits = gaits
        slopes = begin.spectrum.fold_slopes
        size = float(np.linalg.norm(slopes))
        if not size > 0.0:
            raise RunError("the edge of the fold has no normal here")
        self.normal = slopes / size
        self.basis: NDArray[np.float64] = np.linalg.svd(self.normal[None, :])[2][1:].T

    def here(self, gait: Candidate) -> OnBorder:
        """A gait as the origin of the coordinates."""
        return self._point(gait, np.zeros(self.basis.shape[1]))

    def follow(self, near: Candidate, u: NDArray[np.float64]) -> OnBorder:
        """The gait on the edge at u, from one that is known; by Newton's method along the normal."""
        assert isinstance(near, OnBorder)
        known = near.border.short
        gait = self._off_fold(known, known.at + near.plane @ (u - near.at))
        for _ in range(NEWTON):
            left = gait.spectrum.fold / OFF_FOLD - 1.0
            if abs(left) <= ON_EDGE:
                return self._point(gait, u)
            slope = float(gait.spectrum.fold_slopes @ self.normal) / OFF_FOLD
            if not slope > 0.0:
                break
            gait = self.gaits.follow(gait, gait.at - max(left, -NEAR) / slope * self.normal)
        raise RunError("the edge of the fold is not met")

    def _off_fold(self, near: Candidate, at: NDArray[np.float64]) -> Candidate:
        """The gait at a point or, where none is there, as little off it as one is."""
        step = 0.0
        while step <= LONGEST:
            try:
                return self.gaits.follow(near, at + step * self.normal)
            except RunError:
                step = max(INWARDS, 4.0 * step)
        raise RunError("there are no gaits off the fold")

    def _point(self, gait: Candidate, u: NDArray[np.float64]) -> OnBorder:
        slopes = gait.spectrum.fold_slopes
        bend = -(slopes @ self.basis) / (slopes @ self.normal)
        plane = self.basis + np.outer(self.normal, bend)
        return OnBorder(
            at=u,
            gait=gait.gait,
            apex_slopes=gait.apex_slopes @ plane,
            values=gait.values,
            slopes=gait.slopes @ plane,
            spectrum=gait.spectrum.along(plane),
            border=Border(gait, gait, is_smooth=False, normal=self.normal),
            plane=plane,
        )
