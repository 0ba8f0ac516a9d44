"""Borders between regions: where the word or the events of a gait change, and its quantities have a kink.

Quantities are continuous across a border and smooth on either side. So the changes of all of them and of the
apex differ, from one side to the other, by a matrix of rank one, whose rows are along the normal of the
border: their derivatives along the border are the same. This gives the normal exactly. Where that matrix is
nothing the functions are smooth, and the border is none for the search.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from ..library.gait import Gait
from .gaits import Candidate, Gaits
from .problem import Problem

ACCURACY = 1e-10
"""Distance of the gaits on both sides, over the width of the bounds."""
SMOOTH = 1e-3
"""Difference of the changes on both sides, over their size, that counts as none."""
CONTINUOUS = 1e-4
"""Largest difference of the apices on both sides, over the scales: where a foot just touches the ground they
change as a square root does."""
NARROWEST, WIDEST = 1e-6, 0.3
"""Distances at which a border is looked for across itself."""


@dataclass(frozen=True, eq=False)
class Border:
    """Gaits on both sides of a border between two regions."""

    short: Candidate
    """On this side."""
    beyond: Candidate
    """On the other."""
    is_smooth: bool
    """Nothing has a kink here."""
    normal: NDArray[np.float64]
    """Unit vector across it, towards `beyond`, shape (d,)."""

    @property
    def sides(self) -> tuple["Side", "Side"]:
        """Both sides, `short` first."""
        return Side(self.short, -self.normal), Side(self.beyond, self.normal)


@dataclass(frozen=True, eq=False)
class Side:
    """A gait beside a border."""

    gait: Candidate
    """The gait."""
    away: NDArray[np.float64]
    """Unit vector that leads away from the border, shape (d,)."""

    def gain(self, problem: Problem) -> float:
        """How much steeper the merit falls away from the border than along it."""
        return problem.steepest(self.gait, self.away) - problem.steepest(self.gait, self.away, along=True)


def between(gaits: Gaits, inside: Candidate, outside: Candidate, is_inside: Callable[[Gait], bool]) -> Border:
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
        if is_inside(found):
            low, near = middle, replace(near, at=at, gait=found)
        else:
            high, beyond = middle, found
    short = gaits.candidate(near.gait, near.at)
    return _border(short, gaits.candidate(beyond, inside.at + high * way), way / length)


def _border(short: Candidate, beyond: Candidate, way: NDArray[np.float64]) -> Border:
    """With its normal, which leads to the side that the way does."""
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
    near: Candidate,
    at: NDArray[np.float64],
    direction: NDArray[np.float64],
    is_inside: Callable[[Gait], bool],
) -> Border:
    """The border where a line through a point meets it."""
    reach = max(NARROWEST, float(np.sum((at - near.at) ** 2)))
    while reach <= WIDEST:
        low, high = (gaits.follow(near, at + sign * reach * direction) for sign in (-1.0, 1.0))
        if is_inside(low.gait) and not is_inside(high.gait):
            return between(gaits, low, high, is_inside)
        reach *= 4.0
    raise RunError("the border between two words is not met")
