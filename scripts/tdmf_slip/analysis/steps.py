"""A branch followed from point to point, through folds and corners, until there is a reason to stop."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from ..errors import InputError, RunError
from .family import Family, Point
from .meeting import Track
from .next_point import BEYOND, next_point, past_corner
from .walking_back import leads_back

SMALLEST_PART = 50
"""Of the range: the parameter changes by no more in a step."""


@dataclass(frozen=True)
class Limits:
    """Where to stop."""

    low: float
    """Of the parameter."""
    high: float
    """Values of the parameter between which the branch is followed."""
    begins_at: float
    """The end that is told as the beginning of the range."""
    max_step: float
    """Along the branch."""
    max_points: int
    """Then it stops."""


def follow(
    family: Family,
    first: Point,
    limits: Limits,
    step_finished: Callable[[], None] = lambda: None,
    ends_between: Callable[[Point, Point], str] = lambda _before, _after: "",
    known: Sequence[Point] = (),
) -> tuple[list[Point], str]:
    """The branch from a point on, in its direction, and why it stops."""
    points, step = [first], limits.max_step / 10.0
    track = Track(family, [*known, first])
    while len(points) < limits.max_points:
        last = points[-1]
        try:
            following, step = next_point(family, last, step, _longest(family, last, limits))
            further = [following]
        except (InputError, RunError) as problem:
            further = past_corner(family, last, track.is_new)
            if not further:
                return points, _lost(family, last, problem)
            step = family.distance([last, *further][-2], further[-1])
        for following in further:
            end, ended = _end_between(family, points[-1], following, limits, track, ends_between)
            for point in end if ended else [following]:
                points.append(point)
                track.add(point)
                step_finished()
            if ended:
                return points, ended
    return points, f"number of points: {limits.max_points}"


def _end_between(
    family: Family,
    last: Point,
    following: Point,
    limits: Limits,
    track: Track,
    ends_between: Callable[[Point, Point], str],
) -> tuple[list[Point], str]:
    """The last points of the branch if it ends before the next one, and why; or nothing."""
    ended = ends_between(last, following)
    if ended:
        return [], ended
    if not limits.low <= following.value <= limits.high:
        end = limits.low if following.value < limits.low else limits.high
        points = [] if last.value == end else [_at_value(family, last, following, end)]
        back = end == limits.begins_at
        return points, f"back at {family.name} = {end:g}" if back else "end of the range"
    met = track.met(last, following)
    return ([], "") if met is None else ([met[0]], met[1])


def _longest(family: Family, last: Point, limits: Limits) -> float:
    """The longest step from a point."""
    rate = abs(last.tangent[-1]) * family.scales[-1] * SMALLEST_PART
    span = limits.high - limits.low
    return float(min(limits.max_step, span / rate)) if rate > 0.0 else limits.max_step


def _at_value(family: Family, before: Point, after: Point, value: float) -> Point:
    """The point of the branch at a value of the parameter; the one after it where that is not found."""
    begin, end = family.coordinates(before), family.coordinates(after)
    share = (value - before.value) / (after.value - before.value)
    try:
        gait = family.gait(value, (begin + share * (end - begin))[:-1] * family.scales[:-1])
        point = family.point(gait, end - begin)
        return point if leads_back(family, point, before) else after
    except (InputError, RunError):
        return after


def _lost(family: Family, last: Point, problem: Exception) -> str:
    """Why the branch cannot be followed on."""
    where = f"{family.name} = {last.value:g}"
    if isinstance(problem, InputError):
        return f"limit of what is allowed at {where}: {problem}"
    try:
        other = family.evaluate(family.coordinates(last) + BEYOND[0] * last.tangent)
    except (InputError, RunError) as fate:
        return f"the gait is lost at {where}: just beyond, {fate}"
    if other.sequence != last.gait.sequence:
        words = (
            f"from {last.gait.word} to {other.word or 'an empty one'}"
            if other.word != last.gait.word
            else "of the events"
        )
        return f"the gait is lost at {where}: at the border {words} no gait goes on from it on the other side"
    return f"no convergence at {where}: {problem}"
