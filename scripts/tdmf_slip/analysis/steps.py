"""Steps along a branch by pseudo-arclength: through folds and corners, until there is a reason to stop.

Each gait is sought on the plane across the branch's tangent. Where the word changes the branch goes on, but
its tangent jumps: a corner that is too sharp for the plane is passed with the map of the other side.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError
from .family import Family, Point

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
SMALLEST_PART = 50
"""Of the range: the parameter changes by no more in a step."""
SAME = 1e-8
"""Two points of a branch that are as near are one."""


@dataclass(frozen=True)
class Limits:
    """Where to stop."""

    low: float
    """Of the parameter."""
    high: float
    """Values of the parameter between which the branch is followed."""
    begins_at: float
    """The end that is told as the beginning of the range."""
    largest_step: float
    """Along the branch."""
    most_points: int
    """Then it stops."""


def follow(
    family: Family,
    first: Point,
    limits: Limits,
    step_finished: Callable[[], None] = lambda: None,
    ends_between: Callable[[Point, Point], str] = lambda _before, _after: "",
) -> tuple[list[Point], str]:
    """The branch from a point on, in its direction, and why it stops.

    Parameters
    ----------
    family : Family
        Whose branch it is.
    first : Point
        On it.
    limits : Limits
        Where to stop.
    step_finished : callable, optional
        Called after each gait.
    ends_between : callable, optional
        Why the branch ends between two points, or nothing.

    Returns
    -------
    points : list of Point
        From the first on; the last one is on the range's end, where it is reached.
    ended : str
        Why it stops, in words that differ for each reason.
    """
    points, step = [first], limits.largest_step / 10.0
    while len(points) < limits.most_points:
        last = points[-1]
        try:
            following, step = _step(family, last, step, _longest(family, last, limits))
        except (InputError, RunError) as problem:
            corner = _past_corner(family, last)
            if corner is None:
                return points, _lost(family, last, problem)
            following, step = corner, family.distance(last, corner)
        ended = ends_between(last, following)
        if ended:
            return points, ended
        if not limits.low <= following.value <= limits.high:
            end = limits.low if following.value < limits.low else limits.high
            if last.value != end:
                points.append(_at_value(family, last, following, end))
                step_finished()
            if end == limits.begins_at:
                return points, f"back at {family.name} = {end:g}"
            return points, "end of the range"
        if len(points) > 2 and _is_between(family, first, last, following):
            return [*points, first], f"closed: back at the gait at {family.name} = {first.value:g}"
        points.append(following)
        step_finished()
    return points, f"number of points: {limits.most_points}"


def _longest(family: Family, last: Point, limits: Limits) -> float:
    """The longest step from a point."""
    rate = abs(last.direction[-1]) * family.scales[-1] * SMALLEST_PART
    span = limits.high - limits.low
    return float(min(limits.largest_step, span / rate)) if rate > 0.0 else limits.largest_step


def _step(family: Family, last: Point, step: float, largest: float) -> tuple[Point, float]:
    """The next point, and how long the next step may be.

    Raises
    ------
    InputError
        However short the step, a value of the parameter is not allowed.
    RunError
        However short the step, there is no gait.
    """
    step = min(step, largest)
    while True:
        goal = family.place(last) + step * last.direction
        try:
            following = family.on_plane(goal, last.direction)
            off = float(np.linalg.norm(family.place(following) - goal))
            turns = following.direction @ last.direction < STRAIGHT
            if off > NEAR * step or (step > SHARP and (turns or off > FARTHEST * step)):
                raise RunError(f"the branch turns sharply at {family.name} = {last.value:g}")
            return following, min(largest, (1.5 if off < 0.1 * step else 1.0) * step)
        except (InputError, RunError):
            if step < SHORTEST_STEP:
                raise
            step *= 0.5


def _at_value(family: Family, before: Point, after: Point, value: float) -> Point:
    """The point of the branch at a value of the parameter; the one after it where that is not found."""
    begin, end = family.place(before), family.place(after)
    share = (value - before.value) / (after.value - before.value)
    try:
        orbit = family.orbit(value, (begin + share * (end - begin))[:-1] * family.scales[:-1])
        return family.point(orbit, end - begin)
    except (InputError, RunError):
        return after


def _is_between(family: Family, first: Point, last: Point, following: Point) -> bool:
    """The branch goes through its first point again, in the same direction."""
    begin, way = family.place(last), family.place(following) - family.place(last)
    share = (family.place(first) - begin) @ way / (way @ way)
    if not 0.0 <= share <= 1.0 or following.direction @ first.direction <= 0.0:
        return False
    if np.linalg.norm(begin + share * way - family.place(first)) > np.linalg.norm(way):
        return False
    try:
        again = family.on_plane(begin + share * way, way / np.linalg.norm(way))
    except (InputError, RunError):
        return False
    return family.distance(again, first) < SAME


def _past_corner(family: Family, last: Point) -> Point | None:
    """The branch beyond a change of the events at which it turns, or None where none is found."""
    for distance in BEYOND:
        try:
            other = family.look(family.place(last) + distance * last.direction)
            if other.sequence == last.orbit.sequence:
                continue
            tangent = family.point(other, last.direction).direction
            for way in (last.direction, tangent, -tangent):
                found = _on_other_side(family, last, distance * way)
                if found is not None:
                    return found
        except (InputError, RunError):
            continue
    return None


def _on_other_side(family: Family, last: Point, step: NDArray[np.float64]) -> Point | None:
    """A gait with other events a step away, unless the branch there leads back."""
    length = np.linalg.norm(step)
    try:
        found = family.on_plane(family.place(last) + step, step / length)
    except (InputError, RunError):
        return None
    way = family.place(found) - family.place(last)
    if np.linalg.norm(way) > NEAR * length or found.orbit.sequence == last.orbit.sequence:
        return None
    return found if found.direction @ way > 0.0 else replace(found, direction=-found.direction)


def _lost(family: Family, last: Point, problem: Exception) -> str:
    """Why the branch cannot be followed on."""
    where = f"{family.name} = {last.value:g}"
    if isinstance(problem, InputError):
        return f"limit of what is allowed at {where}: {problem}"
    try:
        other = family.look(family.place(last) + BEYOND[0] * last.direction)
    except (InputError, RunError) as fate:
        return f"the gait is lost at {where}: just beyond, {fate}"
    if other.sequence != last.orbit.sequence:
        words = (
            f"from {last.orbit.word} to {other.word or 'an empty one'}"
            if other.word != last.orbit.word
            else "of the events"
        )
        return f"the gait is lost at {where}: at the border {words} no gait goes on from it on the other side"
    return f"no convergence at {where}: {problem}"
