"""The next point of a branch: a step of pseudo-arclength, or beyond a corner.

A step is taken only if it can be walked back: the corrector that starts from the new gait's tangent has to
find the old one. Else it may have led to another branch that comes near.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import dropwhile

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError
from ..numerics.halving import halved
from .family import Family, Point
from .walking_back import leads_back

SHORTEST_STEP = 1e-7
"""Along the branch: where no step of this length finds a gait it ends, unless it has a corner there."""
SHARP = 1e-4
"""Steps from this length down may turn by any angle."""
STRAIGHT = 0.9
"""Cosine of the largest angle by which the tangent turns in a longer one."""
FARTHEST, NEAR = 0.5, 10.0
"""How far a gait may be from where it was predicted, over the step: in longer ones, and at a corner."""
BEYOND = (1e-6, 3e-6, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2)
"""How far beyond a corner the map of the other side is looked at."""
MAX_BACK = 100
"""Steps from beyond a corner back to it."""


def next_point(family: Family, last: Point, step: float, largest: float) -> tuple[Point, float]:
    """The next point by a step along the tangent, and how long the next step may be."""

    def attempt(step: float) -> tuple[Point, float]:
        goal = family.coordinates(last) + step * last.tangent
        following = family.on_plane(goal, last.tangent, last.gait)
        off = float(np.linalg.norm(family.coordinates(following) - goal))
        turns = following.tangent @ last.tangent < STRAIGHT
        if off > NEAR * step or (step > SHARP and (turns or off > FARTHEST * step)):
            raise RunError(f"the branch turns sharply at {family.name} = {last.value:g}")
        if not leads_back(family, following, last):
            raise RunError(f"from {family.name} = {last.value:g} no gait is found that leads back to it")
        return following, off

    (following, off), step = halved(attempt, min(step, largest), 0.5 * SHORTEST_STEP)
    return following, min(largest, (1.5 if off < 0.1 * step else 1.0) * step)


def past_corner(
    family: Family, last: Point, is_new: Callable[[Sequence[Point]], bool] = lambda _points: True
) -> list[Point]:
    """Points of the branch beyond a change of the events at which it turns."""
    for distance in BEYOND:
        try:
            other = family.evaluate(family.coordinates(last) + distance * last.tangent)
            if other.sequence == last.gait.sequence:
                continue
            tangent = family.point(other, last.tangent).tangent
            for way in (last.tangent, tangent, -tangent):
                found = _on_other_side(family, last, distance * way)
                if found and is_new([last, *found]):
                    return found
        except (InputError, RunError):
            continue
    return []


def _on_other_side(family: Family, last: Point, step: NDArray[np.float64]) -> list[Point]:
    """A gait with other events a step away, if its branch leads back; and those on the way there."""
    length = np.linalg.norm(step)
    try:
        found = family.on_plane(family.coordinates(last) + step, step / length)
    except (InputError, RunError):
        return []
    way = family.coordinates(found) - family.coordinates(last)
    if np.linalg.norm(way) > NEAR * length or found.gait.sequence == last.gait.sequence:
        return []
    found = found if found.tangent @ way > 0.0 else reverse(found)
    return [found] if leads_back(family, found, last) else _way_to(family, last, found)


def _way_to(family: Family, corner: Point, found: Point) -> list[Point]:
    """Points of the branch from a corner to a gait beyond it, by walking back from there; none if it fails.

    Where an event is just touched the map has a square root: close to it the tangent turns without end.
    """
    back = [reverse(found)]
    longest = family.distance(corner, found)
    step = longest / 4.0
    for _ in range(MAX_BACK):
        left = family.distance(corner, back[-1])
        if left <= SHARP:
            there = dropwhile(lambda point: point.gait.sequence == corner.gait.sequence, reversed(back))
            return [reverse(point) for point in there]
        if left > 2.0 * longest:
            break
        try:
            following, step = next_point(family, back[-1], step, 0.5 * left)
        except (InputError, RunError):
            break
        back.append(following)
    return []


def reverse(point: Point) -> Point:
    """The same point of the branch in the other direction."""
    return replace(point, tangent=-point.tangent)
