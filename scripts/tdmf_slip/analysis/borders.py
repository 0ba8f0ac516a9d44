"""Borders between gait words along a parameter: where a contact mode appears or vanishes.

How long it lasts is zero there, and that is what is solved for.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from ..library.orbit import Orbit, check_orbit
from ..library.runner import Runner
from ..unit.variable import Given
from .family import Family

ROOT_ACCURACY = 1e-11
"""Of the parameter where a test function of the gait is zero, over the larger of the values around."""
CLOSE_TO_BORDER = 1e-7
"""Distance at which a straight line through two durations is exact, likewise."""
SURE = 1e-10
"""Distance from a border at which the words on both sides are read, likewise: so far it may be off."""
MOST_LOOKS = 100
MOST_BORDERS = 100


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


def borders_between(
    runner: Runner | Mapping[str, Given], name: str, first: Orbit, last: Orbit
) -> list[Border]:
    """All changes of the word from one gait to another of the same branch.

    Parameters
    ----------
    runner : Runner or mapping of str to float
        Whose gaits.
    name : str
        Parameter or input along which the branch is followed.
    first, last : Orbit
        Gaits of the branch.

    Returns
    -------
    list of Border
        In order from first to last.

    Raises
    ------
    InputError
        The name is that of no parameter or input, or the gaits are none.
    RunError
        A gait between them cannot be found.
    """
    check_orbit(first, "first")
    check_orbit(last, "last")
    return [border for border, _ in crossings(Family(runner, name), first, last)]


def crossings(family: Family, first: Orbit, last: Orbit) -> Iterator[tuple[Border, Orbit]]:
    """The borders of `borders_between` with the gaits just beyond.

    Parameters
    ----------
    family : Family
        Whose branch it is.
    first, last : Orbit
        Gaits of the branch.

    Yields
    ------
    border : Border
    beyond : Orbit
        The gait just beyond it.

    Raises
    ------
    RunError
        A gait between them cannot be found, or there are more borders than can be told apart.
    """
    inside = first
    for _ in range(MOST_BORDERS):
        if inside.word == last.word:
            return
        value, outside = _border(family, inside, last)
        yield Border(value, inside.word, outside.word), outside
        inside = outside
    raise RunError(f"more than {MOST_BORDERS} borders between {first.word} and {last.word}")


def _border(family: Family, inside: Orbit, last: Orbit) -> tuple[float, Orbit]:
    """Where the word of `inside` ends on the way to `last`, and the gait just beyond.

    The gaits on both sides are brought together until a letter's duration is all but zero, each time nine
    tenths of the way to where the last two say it vanishes. A look that does not serve halves what is left,
    and so does every second one: that finds durations which end as a square root does, where a guard is just
    touched.
    """
    name = family.name
    outside = last
    smallest = 1e-9 * max(abs(inside.runner.values[name]), abs(last.runner.values[name]))
    sides: dict[str, list[Orbit]] = {inside.word: [inside], last.word: [last]}
    for looks in range(MOST_LOOKS):
        low, high = inside.runner.values[name], outside.runner.values[name]
        size = max(abs(low), abs(high), smallest)
        if abs(high - low) <= ROOT_ACCURACY * size:
            return 0.5 * (low + high), outside
        vanishing = _vanishing_point(name, sides[inside.word], sides[outside.word], low, high)
        look = 0.5 * (low + high)
        if vanishing is not None:
            near, value = vanishing
            if abs(near - value) <= CLOSE_TO_BORDER * size:
                short, beyond = _sides(family, inside, outside, value)
                if short.word == inside.word != beyond.word:
                    return value, beyond
            elif looks % 2 == 0 and min(low, high) < value + 0.1 * (near - value) < max(low, high):
                look = value + 0.1 * (near - value)
        tried = family.orbit(look, _between(inside, outside, look, name))
        sides.setdefault(tried.word, []).append(tried)
        if tried.word == inside.word:
            inside = tried
        else:
            outside = tried
    words = f"{inside.word} and {outside.word}"
    raise RunError(f"border between {words} not located near {name} = {low:g}")


def _sides(family: Family, inside: Orbit, outside: Orbit, value: float) -> tuple[Orbit, Orbit]:
    """The gaits just short of a value and just beyond it, on the way from one gait to another."""
    low, high = inside.runner.values[family.name], outside.runner.values[family.name]
    step = np.copysign(SURE * max(abs(low), abs(high)), high - low)
    places = np.clip([value - step, value + step], min(low, high), max(low, high))
    return family.orbit(places[0], inside.apex), family.orbit(places[1], outside.apex)


def _between(inside: Orbit, outside: Orbit, value: float, name: str) -> NDArray[np.float64]:
    low, high = inside.runner.values[name], outside.runner.values[name]
    share = (value - low) / (high - low)
    return (1.0 - share) * inside.apex + share * outside.apex


def _vanishing_point(
    name: str, inside: Sequence[Orbit], outside: Sequence[Orbit], low: float, high: float
) -> tuple[float, float] | None:
    """The last value on the side with more letters, and where by its last two gaits a letter ends."""
    side = inside if len(inside[-1].word) > len(outside[-1].word) else outside
    if len(side) < 2 or len(side[-1].letters) != len(side[-2].letters):
        return None
    near, far = side[-1], side[-2]
    at, step = near.runner.values[name], near.runner.values[name] - far.runner.values[name]
    roots = [
        at - letter.duration * step / (letter.duration - before.duration)
        for letter, before in zip(near.letters, far.letters, strict=True)
        if letter.duration != before.duration
    ]
    slack = SURE * abs(at)  # the border may lie on a gait already tried, or beside it by rounding
    within = [root for root in roots if min(low, high) - slack <= root <= max(low, high) + slack]
    return (at, min(within, key=lambda root: abs(root - at))) if within else None
