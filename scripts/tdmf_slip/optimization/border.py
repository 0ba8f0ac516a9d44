"""Borders between regions, the best point on a border, and the best point on the edge off a fold.

At a border the word or the events of a gait change, and its quantities have a kink. They are continuous
across the border and smooth on either side. The derivatives on both sides therefore differ by a matrix of
rank one, whose rows are along the normal of the border. This gives the normal exactly. If that matrix is
zero, the functions are smooth, and the search ignores the border.

Parameters on the border are x = x0 + T u + n s(u), with the normal n at x0 and a basis T of the plane across
it; s(u) is solved for. The objective and the constraints are then functions of u alone, as smooth as the
region and the border. Their derivatives are those along T + n ds/du, which lies in the border's own plane.

On the edge off a fold, det(I - J)^2 has its least allowed value. Near a fold, gaits change like a square
root, and a search in a box of parameters creeps, because a straight step along the edge leads over the fold.
On the edge itself all functions are smooth, with one coordinate less than there are parameters.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from .gaits import AT_BOUND, Candidate, Gaits, Rows
from .problem import OFF_FOLD, Problem, minimize

ACCURACY = 1e-10
"""Largest distance between the gaits on both sides, over the width of the bounds."""
ALONG = 1e-9
"""Accuracy of an objective along a border; functions on it are as noisy as its location, see `ACCURACY`."""
SMOOTH = 1e-3
"""Relative difference between the derivatives on both sides that counts as none."""
CONTINUOUS = 1e-4
"""Largest difference of the apices on both sides, over the scales.

Where a foot just touches the ground, apices change like a square root."""
NARROWEST, WIDEST = 1e-6, 0.3
"""Shortest and longest distance on both sides at which a border is searched for."""
RADIUS, SMALLEST = 0.05, 1e-7
"""Half the width of the first and of the last box, over the width of the bounds."""
ROUNDS = 20
NEAR = 0.5
"""Distance from the edge, as a share of `OFF_FOLD`, at which a gait is moved onto the edge."""
ON_EDGE, NEWTON = 1e-9, 12
"""Largest residual of a gait on the edge, and number of Newton steps towards the edge."""
INWARDS, LONGEST = 1e-5, 0.1
"""First and last step back from beyond the fold, over the width of the bounds."""


Region: TypeAlias = set[tuple[object, ...]]
"""Sequences of events, see `Gait.sequence`, across which all functions are smooth."""


@dataclass(frozen=True, eq=False)
class Border:
    """Gaits on both sides of a border between two regions."""

    short: Candidate
    """Gait on this side."""
    beyond: Candidate
    """Gait on the other side."""
    is_smooth: bool
    """True if the functions have no kink at this border."""
    normal: NDArray[np.float64]
    """Unit normal of the border, towards `beyond`, shape (d,)."""

    @property
    def sides(self) -> tuple[tuple[Candidate, NDArray[np.float64]], ...]:
        """Both sides, `short` first: the gait, and the unit vector that leads away from the border."""
        return (self.short, -self.normal), (self.beyond, self.normal)


def between(gaits: Gaits, inside: Candidate, outside: Candidate, region: Region) -> Border:
    """Border at which the line from a gait to another one leaves a region, by bisection."""
    way = outside.at - inside.at
    low, high, length = 0.0, 1.0, float(np.linalg.norm(way))
    near, beyond = inside, outside.gait
    while (high - low) * length > ACCURACY:
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        at = inside.at + middle * way
        found = gaits.gait_from(near, at)
        if found.sequence in region:
            low, near = middle, replace(near, at=at, gait=found)
        else:
            high, beyond = middle, found
    short = gaits.candidate(near.gait, near.at)
    return _border(short, gaits.candidate(beyond, inside.at + high * way), way / length)


def _border(short: Candidate, beyond: Candidate, way: NDArray[np.float64]) -> Border:
    """Border with its normal, which points in the direction of the way."""
    scales = short.gait.runner.scales[:, None]
    if np.max(np.abs(beyond.gait.apex - short.gait.apex) / scales[:, 0]) > CONTINUOUS:
        raise RunError("the gaits end where the word changes")
    sides = [np.vstack([gait.apex_slopes / scales, gait.slopes]) for gait in (short, beyond)]
    jump = sides[1] - sides[0]
    is_smooth = np.linalg.norm(jump) <= SMOOTH * np.linalg.norm(sides[0])
    normal = np.linalg.svd(jump)[2][0]
    return Border(short, beyond, bool(is_smooth), normal if normal @ way >= 0.0 else -normal)


def across(
    gaits: Gaits,
    region: Region,
    near: Candidate,
    at: NDArray[np.float64],
    direction: NDArray[np.float64],
) -> Border:
    """Border on a line through a point."""
    reach = max(NARROWEST, float(np.sum((at - near.at) ** 2)))
    while reach <= WIDEST:
        low, high = (gaits.follow(near, at + sign * reach * direction) for sign in (-1.0, 1.0))
        if low.region in region and high.region not in region:
            return between(gaits, low, high, region)
        reach *= 4.0
    raise RunError("the border between two words is not met")


@dataclass(frozen=True, eq=False)
class OnBorder(Candidate):
    """Gait on a border; `at` is u, and slopes are derivatives by u."""

    border: Border
    """Border at this point."""
    plane: NDArray[np.float64]
    """Derivatives of the parameters by u, shape (d, d - 1): T + n ds/du."""
    free: NDArray[np.bool_]
    """True for the parameters that vary, shape (d,)."""

    @property
    def margins(self) -> Rows:
        """Margins of the bounds of the parameters that vary."""
        at, plane = self.border.short.at[self.free], self.plane[self.free]
        return np.append(at, 1.0 - at), np.vstack([plane, -plane])


class Chart:
    """Coordinates u on a border: a step in the plane across a normal, and one along the normal.

    `locate` finds the border on a line: from a gait on it, by a point of the line and the normal.
    """

    def __init__(
        self,
        border: Border,
        free: NDArray[np.bool_],
        locate: Callable[[Candidate, NDArray[np.float64], NDArray[np.float64]], Border],
    ) -> None:
        varied = np.where(free, border.normal, 0.0)
        self.free, self.locate = free, locate
        self.normal = varied / np.linalg.norm(varied)
        self.basis = np.eye(len(free))[:, free] @ np.linalg.svd(border.normal[None, free])[2][1:].T

    def point(self, border: Border, u: NDArray[np.float64]) -> OnBorder:
        """Point of the chart at a border."""
        normal, short = border.normal, border.short
        plane = self.basis - np.outer(self.normal, normal @ self.basis / (normal @ self.normal))
        return OnBorder(
            at=u,
            gait=short.gait,
            apex_slopes=short.apex_slopes @ plane,
            values=short.values,
            slopes=short.slopes @ plane,
            spectrum=short.spectrum.along(plane),
            border=border,
            plane=plane,
            free=self.free,
        )

    def follow(self, near: Candidate, u: NDArray[np.float64]) -> OnBorder:
        """Point of the chart at u, from one nearby."""
        assert isinstance(near, OnBorder)
        at = near.border.short.at + near.plane @ (u - near.at)
        return self.point(self.locate(near.border.short, at, self.normal), u)


def _best_over(
    problem: Problem,
    chart: Chart,
    border: Border,
    is_optimum: Callable[[Border], bool],
    is_inside: Callable[[Candidate], bool] = lambda gait: True,
) -> Border:
    """Best point on a border, by SLSQP in boxes of the chart."""
    here, radius = chart.point(border, np.zeros(chart.basis.shape[1])), RADIUS
    for _ in range(ROUNDS):
        box = here.at - radius, here.at + radius
        ended = minimize(problem, chart.follow, here, box, is_inside, ALONG)
        grows = not ended.lost and problem.merit(ended.best) < problem.merit(here)
        assert isinstance(ended.best, OnBorder)
        here = ended.best
        if not ended.lost and is_optimum(here.border):
            break
        radius *= 2.0 if grows else 0.25
        if radius < SMALLEST:
            break
    return here.border


def best_along(gaits: Gaits, problem: Problem, border: Border, region: Region, stationary: float) -> Border:
    """Best point on a border between words, by the functions of the region on this side.

    The first search holds parameters that are at their bounds.
    """

    def is_optimum(border: Border) -> bool:
        return problem.steepest(border.short, border.normal, along=True) <= stationary

    at = border.short.at
    off_bounds = (at > AT_BOUND) & (at < 1.0 - AT_BOUND)
    for free in (off_bounds, np.ones_like(off_bounds)):
        if np.count_nonzero(free) < 2 or not np.any(border.normal[free]):
            continue
        chart = Chart(border, free, partial(across, gaits, region))
        border = _best_over(problem, chart, border, is_optimum)
        if is_optimum(border):
            break
    return border


def is_near(gait: Candidate) -> bool:
    """True for a gait near the edge off a fold."""
    return abs(gait.spectrum.fold / OFF_FOLD - 1.0) < NEAR


def best_on_edge(
    gaits: Gaits, problem: Problem, begin: Candidate, region: Region, stationary: float
) -> Candidate:
    """Best gait on the edge off a fold that is reached from a gait near the edge."""
    normal = begin.spectrum.fold_slopes
    if len(normal) < 2 or not np.any(normal):
        return begin
    without = Problem(replace(problem.goal, fold=False), problem.scales)
    try:
        edge = _edge(gaits, begin, begin.at, normal / np.linalg.norm(normal))
    except RunError:
        return begin
    chart = Chart(edge, np.ones(len(normal), dtype=bool), partial(_edge, gaits))
    found = _best_over(
        without,
        chart,
        edge,
        lambda border: problem.steepest(border.short) <= stationary,
        lambda gait: gait.region in region,
    )
    return min(begin, found.short, key=problem.merit)


def _edge(gaits: Gaits, near: Candidate, at: NDArray[np.float64], normal: NDArray[np.float64]) -> Border:
    """Point of the edge off a fold on a line, by Newton's method."""
    gait = _off_fold(gaits, near, at, normal)
    for _ in range(NEWTON):
        left, slopes = gait.spectrum.fold / OFF_FOLD - 1.0, gait.spectrum.fold_slopes
        if abs(left) <= ON_EDGE:
            return Border(gait, gait, is_smooth=False, normal=slopes / np.linalg.norm(slopes))
        slope = float(slopes @ normal) / OFF_FOLD
        if not slope > 0.0:
            break
        gait = gaits.follow(gait, gait.at - max(left, -NEAR) / slope * normal)
    raise RunError("the edge of the fold is not met")


def _off_fold(
    gaits: Gaits, near: Candidate, at: NDArray[np.float64], normal: NDArray[np.float64]
) -> Candidate:
    """Gait at a point, or if there is none, at the nearest point along the normal that has one."""
    step = 0.0
    while step <= LONGEST:
        try:
            return gaits.follow(near, at + step * normal)
        except RunError:
            step = max(INWARDS, 4.0 * step)
    raise RunError("there are no gaits off the fold")
