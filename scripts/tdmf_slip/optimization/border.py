"""Borders between regions, the best point on a border, and the best point on the edge off a fold.

At a border the word or the events of a gait change, and its quantities have a kink. They are continuous
across it and smooth on either side. So their derivatives on both sides differ by a matrix of rank one,
whose rows are along the normal of the border. This gives the normal exactly. Where that matrix is zero
the functions are smooth, and the search does not treat the border as one.

Parameters on the border are x = x0 + T u + n s(u), with the normal n at x0, a basis T of the plane across
it, and s(u) solved for. So the objective and the constraints are functions of u alone, as smooth as the
region and the border, and their derivatives are those along T + n ds/du, which lies in the border's own
plane.

On the edge off a fold det(I - J)^2 is at its least. Near a fold gaits change as a square root does, so
that a search in a box of parameters creeps: a straight step along the edge leads over the fold. On the
edge itself all is smooth, with one coordinate less than there are parameters.
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
"""Distance of the gaits on both sides, over the width of the bounds."""
ALONG = 1e-9
"""Accuracy of an objective along a border: the border is located to `ACCURACY`, and functions on it are as
noisy."""
SMOOTH = 1e-3
"""Difference of the changes on both sides, over their size, that counts as none."""
CONTINUOUS = 1e-4
"""Largest difference of the apices on both sides, over the scales: where a foot just touches the ground they
change as a square root does."""
NARROWEST, WIDEST = 1e-6, 0.3
"""Distances at which a border is looked for across itself."""
RADIUS, SMALLEST = 0.05, 1e-7
"""Half the width of the first box, and of the last one; of the bounds' width."""
ROUNDS = 20
NEAR = 0.5
"""Share of `OFF_FOLD`: a gait as near to the edge is led onto it."""
ON_EDGE, NEWTON = 1e-9, 12
"""Residual of the edge's equation, and steps towards it."""
INWARDS, LONGEST = 1e-5, 0.1
"""First and last step off the fold, over the bounds' width, where a point is beyond it."""


Region: TypeAlias = set[tuple[object, ...]]
"""Sequences of events, see `Gait.sequence`, between which nothing has a kink."""


@dataclass(frozen=True, eq=False)
class Border:
    """Gaits on both sides of a border between two regions."""

    short: Candidate
    """Gait on this side."""
    beyond: Candidate
    """Gait on the other side."""
    is_smooth: bool
    """Nothing has a kink here."""
    normal: NDArray[np.float64]
    """Unit vector across it, towards `beyond`, shape (d,)."""

    @property
    def sides(self) -> tuple[tuple[Candidate, NDArray[np.float64]], ...]:
        """Both sides, `short` first: the gait, and the unit vector that leads away from the border."""
        return (self.short, -self.normal), (self.beyond, self.normal)


def between(gaits: Gaits, inside: Candidate, outside: Candidate, region: Region) -> Border:
    """The border where the way from a gait to one beyond it leaves a region: by bisection."""
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
    """The border with its normal, which points to the side that the way leads to."""
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
    """The border where a line through a point meets it."""
    reach = max(NARROWEST, float(np.sum((at - near.at) ** 2)))
    while reach <= WIDEST:
        low, high = (gaits.follow(near, at + sign * reach * direction) for sign in (-1.0, 1.0))
        if low.region in region and high.region not in region:
            return between(gaits, low, high, region)
        reach *= 4.0
    raise RunError("the border between two words is not met")


@dataclass(frozen=True, eq=False)
class OnBorder(Candidate):
    """A gait on a border; `at` is u, over which the slopes are."""

    border: Border
    """Border at this point."""
    plane: NDArray[np.float64]
    """Changes of the parameters by u, shape (d, d - 1): T + n ds/du."""
    free: NDArray[np.bool_]
    """Which parameters vary."""

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
        """The border as a point of the chart."""
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
        """The border at u, from a point on it."""
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
    """The best point on a border, by SLSQP in boxes of the chart."""
    here, radius = chart.point(border, np.zeros(chart.basis.shape[1])), RADIUS
    for _ in range(ROUNDS):
        low, high = here.at - radius, here.at + radius
        ended = minimize(problem, chart.follow, here, low, high, is_inside, ALONG)
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
    """The best point on a border between words, as the region on this side has it.

    At first, parameters at their bounds are held there.
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
    """Whether a gait is next to the edge off a fold."""
    return abs(gait.spectrum.fold / OFF_FOLD - 1.0) < NEAR


def best_on_edge(
    gaits: Gaits, problem: Problem, begin: Candidate, region: Region, stationary: float
) -> Candidate:
    """The best gait on the edge off a fold that is reached from one near it."""
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
    """The edge off a fold on a line, by Newton's method."""
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
    """The gait at a point or, where none is there, as little off it as one is."""
    step = 0.0
    while step <= LONGEST:
        try:
            return gaits.follow(near, at + step * normal)
        except RunError:
            step = max(INWARDS, 4.0 * step)
    raise RunError("there are no gaits off the fold")
