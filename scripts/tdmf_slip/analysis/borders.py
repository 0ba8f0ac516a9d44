"""Borders between gait words along a parameter: where a contact mode appears or vanishes.

How long it lasts is zero there, and that is what is solved for.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..errors import InputError, RunError
from ..library.gait import Gait, check_is_gait
from ..library.runner import Runner
from ..variables.variable import Given
from .family import Family, Point

ROOT_ACCURACY = 1e-11
"""Length of branch, over the scales, within which a border is located."""
CLOSE_TO_BORDER = 1e-7
"""Distance at which a straight line through two durations is exact."""
SURE = 1e-10
"""Distance from a border at which the words on both sides are read: so far it may be off."""
CORNER = 1e-9
"""Points on both sides of a border that are farther apart are at a corner that the chord does not show."""
ACUTE = 100.0
"""How far such points may be from the corner, over how far they are apart."""
MAX_LOOKS = 100
MAX_BORDERS = 100


@dataclass(frozen=True)
class Border:
    """Where a gait's word changes."""

    value: float
    """Of the parameter."""
    before: str
    """The word before it, in the order of the branch."""
    after: str
    """The word after it."""

    def as_json(self, name: str = "friction") -> dict[str, object]:
        """As a plain object."""
        return {name: self.value, "from": self.before, "to": self.after}


def borders_between(runner: Runner | Mapping[str, Given], name: str, first: Gait, last: Gait) -> list[Border]:
    """All changes of the word from one gait to another of the same branch."""
    check_is_gait(first, "first")
    check_is_gait(last, "last")
    family = Family(runner, name)
    return [crossing.border for crossing in crossings(family, *family.points(first, last))]


@dataclass(frozen=True, eq=False)
class Crossing:
    """A border, and the points of the branch on both sides of it."""

    border: Border
    """What is crossed."""
    short: Point
    """The gait on this side."""
    beyond: Point
    """The gait on the other."""


def crossings(family: Family, first: Point, last: Point) -> Iterator[Crossing]:
    """The borders between two points of a branch."""
    inside = first
    for _ in range(MAX_BORDERS):
        if inside.gait.word == last.gait.word:
            return
        short, beyond = _border(_Chord(family, inside, last), inside, last)
        short = _turned(short, inside)
        beyond = _turned(beyond, last) if beyond.gait.word == last.gait.word else beyond
        if family.distance(short, beyond) > CORNER:
            reach = ACUTE * family.distance(short, beyond)
            short, beyond = (
                _approached(family, *known) for known in ((short, reach, 1), (beyond, reach, -1))
            )
        value = 0.5 * (short.value + beyond.value)
        yield Crossing(Border(value, inside.gait.word, beyond.gait.word), short, beyond)
        inside = beyond
    raise RunError(f"more than {MAX_BORDERS} borders between {first.gait.word} and {last.gait.word}")


def _turned(point: Point, like: Point) -> Point:
    """The point, with the direction that goes with another of the same smooth segment."""
    return point if point.tangent @ like.tangent >= 0.0 else replace(point, tangent=-point.tangent)


class _Chord:
    """The straight way between two points of a branch, and how far along it other points are."""

    def __init__(self, family: Family, first: Point, last: Point) -> None:
        self.family, self.begin = family, family.coordinates(first)
        way = family.coordinates(last) - self.begin
        self.normal = way / np.linalg.norm(way)

    def along(self, point: Point) -> float:
        """How far a point is along the way."""
        return float((self.family.coordinates(point) - self.begin) @ self.normal)

    def at(self, distance: float, inside: Point, outside: Point) -> Point:
        """The point of the branch that is so far along the way, between two that are known."""
        low, high = self.along(inside), self.along(outside)
        if distance in (low, high):
            return inside if distance == low else outside
        begin, end = self.family.coordinates(inside), self.family.coordinates(outside)
        goal = begin + (distance - low) / (high - low) * (end - begin)
        return self.family.on_plane(goal, self.normal, inside.gait)


def _border(chord: _Chord, inside: Point, last: Point) -> tuple[Point, Point]:
    """The points short of where the word of `inside` ends on the way to `last`, and just beyond.

    The points on both sides are brought together until a letter's duration is all but zero, each time nine
    tenths of the way to where the last two say it vanishes. A look that does not serve halves what is left,
    and so does every second one: that finds durations which end as a square root does, where a guard is just
    touched.
    """
    outside = last
    by_word: dict[str, list[Point]] = {inside.gait.word: [inside], last.gait.word: [last]}
    for looks in range(MAX_LOOKS):
        low, high = chord.along(inside), chord.along(outside)
        if high - low <= ROOT_ACCURACY:
            return inside, outside
        vanishing = _vanishing_point(chord, by_word[inside.gait.word], by_word[outside.gait.word])
        look = 0.5 * (low + high)
        if vanishing is not None:
            near, end = vanishing
            if abs(near - end) <= CLOSE_TO_BORDER:
                distances = np.clip([end - SURE, end + SURE], low, high)
                short, beyond = (chord.at(coordinates, inside, outside) for coordinates in distances)
                if short.gait.word == inside.gait.word != beyond.gait.word:
                    return short, beyond
            elif looks % 2 == 0 and low < end + 0.1 * (near - end) < high:
                look = end + 0.1 * (near - end)
        tried = chord.at(look, inside, outside)
        by_word.setdefault(tried.gait.word, []).append(tried)
        if tried.gait.word == inside.gait.word:
            inside = tried
        else:
            outside = tried
    words = f"{inside.gait.word} and {outside.gait.word}"
    raise RunError(f"border between {words} not located near {chord.family.name} = {inside.value:g}")


def _approached(family: Family, point: Point, reach: float, way: int) -> Point:
    """The last point of the same word from one on, along its tangent, no farther than a reach."""
    begin, direction = family.coordinates(point), way * point.tangent
    low, high, last = 0.0, reach, point
    while high - low > ROOT_ACCURACY:
        middle = 0.5 * (low + high)
        try:
            tried = family.on_plane(begin + middle * direction, direction, last.gait)
            there = tried.gait.word == point.gait.word and family.distance(point, tried) <= 2.0 * middle
        except (InputError, RunError):
            there = False
        if there:
            low, last = middle, replace(tried, tangent=point.tangent)
        else:
            high = middle
    return last


def _vanishing_point(
    chord: _Chord, inside: Sequence[Point], outside: Sequence[Point]
) -> tuple[float, float] | None:
    """How far the last point is on the side with more letters, and where by its last two a letter ends."""
    known = inside if len(inside[-1].gait.word) > len(outside[-1].gait.word) else outside
    if len(known) < 2 or len(known[-1].gait.letters) != len(known[-2].gait.letters):
        return None
    near, far = known[-1], known[-2]
    at, step = chord.along(near), chord.along(near) - chord.along(far)
    roots = [
        at - letter.duration * step / (letter.duration - before.duration)
        for letter, before in zip(near.gait.letters, far.gait.letters, strict=True)
        if letter.duration != before.duration
    ]
    low, high = chord.along(inside[-1]) - SURE, chord.along(outside[-1]) + SURE  # beside a point by rounding
    within = [root for root in roots if low <= root <= high]
    return (at, min(within, key=lambda root: abs(root - at))) if within else None
