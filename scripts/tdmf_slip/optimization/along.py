"""The search along a border between two regions, for the best point on it.

Parameters on the border are x = x0 + T u + n s(u), with the normal n at x0, a basis T of the plane across it,
and s(u) solved for. So the objective and the constraints are functions of u alone, as smooth as those of the
region and the border are, and their derivatives are those along T + n ds/du, which is in the border's own
plane.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .border import Border, across
from .gaits import Candidate, Gaits
from .problem import Problem, Rows
from .region import Region
from .slsqp import minimize
from .space import AT_BOUND

RADIUS, SMALLEST = 0.05, 1e-7
"""Half the width of the first box, and of the last one; of the bounds' width."""
ROUNDS = 20


@dataclass(frozen=True, eq=False)
class OnBorder(Candidate):
    """A gait on a border; `at` is u, over which the slopes are."""

    border: Border
    """There."""
    plane: NDArray[np.float64]
    """Changes of the parameters by u, shape (d, d - 1): T + n ds/du."""


class AlongBorder(Problem):
    """A problem over a border; the bounds of the parameters are among the margins."""

    def __init__(self, problem: Problem, free: NDArray[np.bool_]) -> None:
        """Of the problem itself, and which of the parameters are varied."""
        super().__init__(problem.goal, problem.scales)
        self._problem, self._free = problem, free

    def objective(self, gait: Candidate) -> tuple[float, NDArray[np.float64]]:
        """As the problem has it."""
        return self._problem.objective(gait)

    def equations(self, gait: Candidate) -> Rows:
        """As the problem has them."""
        return self._problem.equations(gait)

    def margins(self, gait: Candidate) -> Rows:
        """Those of the problem, and of the bounds."""
        assert isinstance(gait, OnBorder)
        left, slopes = self._problem.margins(gait)
        at, plane = gait.border.short.at[self._free], gait.plane[self._free]
        return np.concatenate([left, at, 1.0 - at]), np.vstack([slopes, plane, -plane])


def best_along(gaits: Gaits, problem: Problem, border: Border, region: Region, stationary: float) -> Border:
    """The best point on a border, as the region on this side has it."""
    at = border.short.at
    off_bounds = (at > AT_BOUND) & (at < 1.0 - AT_BOUND)
    for free in (off_bounds, np.ones_like(off_bounds)):
        if np.count_nonzero(free) < 2 or not np.any(border.normal[free]):
            continue
        border = _best_over(gaits, problem, border, region, free, stationary)
        if problem.steepest(border.short, border.normal, along=True) <= stationary:
            break
    return border


def _best_over(
    gaits: Gaits,
    problem: Problem,
    border: Border,
    region: Region,
    free: NDArray[np.bool_],
    stationary: float,
) -> Border:
    """With some of the parameters held: first those at their bounds, which may have to leave them then."""
    wanted, chart = AlongBorder(problem, free), _Chart(gaits, border, region, free)
    here, radius = chart.point(border, np.zeros(chart.basis.shape[1])), RADIUS
    for _ in range(ROUNDS):
        ended = minimize(wanted, chart.follow, here, here.at - radius, here.at + radius)
        grows = not ended.lost and wanted.merit(ended.best) < wanted.merit(here)
        assert isinstance(ended.best, OnBorder)
        here = ended.best
        if (
            not ended.lost
            and problem.steepest(here.border.short, here.border.normal, along=True) <= stationary
        ):
            break
        radius *= 2.0 if grows else 0.25
        if radius < SMALLEST:
            break
    return here.border


class _Chart:
    """Coordinates u on a border."""

    def __init__(self, gaits: Gaits, border: Border, region: Region, free: NDArray[np.bool_]) -> None:
        self.gaits, self.region = gaits, region
        normal = np.where(free, border.normal, 0.0)
        self.normal = normal / np.linalg.norm(normal)
        self.basis = np.eye(len(free))[:, free] @ np.linalg.svd(border.normal[None, free])[2][1:].T

    def point(self, border: Border, u: NDArray[np.float64]) -> OnBorder:
        """A point on the border, where its normal says how it bends off the plane."""
        bend = -(border.normal @ self.basis) / (border.normal @ self.normal)
        plane = self.basis + np.outer(self.normal, bend)
        short = border.short
        return OnBorder(
            at=u,
            gait=short.gait,
            apex_slopes=short.apex_slopes @ plane,
            values=short.values,
            slopes=short.slopes @ plane,
            spectrum=short.spectrum.along(plane),
            border=border,
            plane=plane,
        )

    def follow(self, near: Candidate, u: NDArray[np.float64]) -> OnBorder:
        """The border at u, from a point on it."""
        assert isinstance(near, OnBorder)
        at = near.border.short.at + near.plane @ (u - near.at)
        return self.point(across(self.gaits, near.border.short, at, self.normal, self.region.has), u)
