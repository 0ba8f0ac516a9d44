"""Bifurcations of a branch: points where it turns or stability changes, located and classified.

At a fold an eigenvalue is +1 and the parameter turns back. At a period doubling an eigenvalue is -1, and at
a Neimark-Sacker point a complex pair is on the unit circle. At a word border the return map has a kink, and
eigenvalues may jump. Feigin's conditions for a border collision then classify the point from the maps of
both sides: the branch turns where det(I - J) changes its sign across the border, and the period doubles
where det(I + J) does. Any other change in the number of eigenvalues outside the unit circle is kept and
marked `unclassified`.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError
from ..library.gait import Gait
from .borders import Border, Crossing, crossings
from .family import Family, Point

FOLD, PERIOD_DOUBLING, NEIMARK_SACKER = "fold", "period doubling", "Neimark-Sacker"
WORD_BORDER, UNCLASSIFIED = "word border", "unclassified"
KINDS = (FOLD, PERIOD_DOUBLING, NEIMARK_SACKER, WORD_BORDER, UNCLASSIFIED)
SHORTEST = 1e-6
"""Length of branch within which changes that come together are not told apart."""
LOCATED = 1e-11
"""Of the way from one gait to the next."""
ON_CIRCLE = 1e-6
"""How near eigenvalues have to be to where a bifurcation puts them."""
MAX_LOOKS = 100


@dataclass(frozen=True, eq=False)
class Special:
    """A point of a branch where its stability, its direction or its word changes."""

    kind: str
    """fold, period doubling, Neimark-Sacker, word border, or unclassified."""
    value: float
    """Value of the parameter; for an unclassified point, the middle of `between`."""
    gait: Gait
    """Gait at the point; for a word border or an unclassified point, the gait just beyond it."""
    between: tuple[float, float]
    """Values of the parameter at two gaits around it, in their order along the branch."""
    why: str = ""
    """Why the point is unclassified, or why the gaits of a period doubling are not followed."""
    words: tuple[str, str] | None = None
    """Gait words before and after the point, if they differ."""
    index: int = 0
    """Index of the branch's gait just before the point."""

    def as_json(self) -> dict[str, object]:
        """As a plain object; `from` and `to` are the words where they change."""
        known: dict[str, object] = {"kind": self.kind, "value": self.value}
        words = {"from": self.words[0], "to": self.words[1]} if self.words else {}
        return known | words | ({"between": list(self.between), "why": self.why} if self.why else {})


def special_points(family: Family, before: Point, after: Point) -> tuple[list[Border], list[Special]]:
    """What happens between two neighbouring points of a branch, in its order."""
    specials = list(_specials(family, before, after))
    borders = [
        Border(special.value, *special.words)
        for special in specials
        if special.kind == WORD_BORDER and special.words
    ]
    return borders, specials


def _specials(family: Family, before: Point, after: Point) -> Iterator[Special]:
    """In the order of the branch: segment by segment, with one thing each, or too short to be told apart."""
    try:
        if before.gait.word != after.gait.word:
            yield from _across_borders(family, before, after)
            return
        if _is_simple(before, after):
            yield from _bifurcations(family, before, after)
            return
    except (InputError, RunError) as problem:
        if family.distance(before, after) < SHORTEST:
            yield _unclassified(before, after, str(problem))
            return
    halves = _halves(family, before, after)
    if halves is None:
        yield _unclassified(before, after, _account(before, after))
        return
    for begin, end in halves:
        yield from _specials(family, begin, end)


def _halves(family: Family, before: Point, after: Point) -> tuple[tuple[Point, Point], ...] | None:
    """Two segments of one; None where it is too short, or cannot be parted."""
    length = family.distance(before, after)
    if length < SHORTEST:
        return None
    try:
        middle = family.between(before, after, 0.5)
    except (InputError, RunError):
        return None
    if max(family.distance(before, middle), family.distance(middle, after)) >= 0.8 * length:
        return None
    return (before, middle), (middle, after)


def _across_borders(family: Family, before: Point, after: Point) -> Iterator[Special]:
    """Borders, what happens on them, and what between them."""
    begin = before
    for crossing in list(crossings(family, before, after)):
        yield from _specials(family, begin, crossing.short)
        yield from _at_border(crossing, (before.value, after.value))
        begin = crossing.beyond
    yield from _specials(family, begin, after)


def _at_border(crossing: Crossing, around: tuple[float, float]) -> Iterator[Special]:
    """The border, and by the maps of both sides whether the branch turns there or the period doubles."""
    border, short, beyond = crossing.border, crossing.short, crossing.beyond
    words = (border.before, border.after)
    yield Special(WORD_BORDER, border.value, beyond.gait, around, words=words)
    changes = _changes(short, beyond)
    turns = FOLD in changes and _passes_one(short, beyond)
    real = [FOLD] * turns + [PERIOD_DOUBLING] * (PERIOD_DOUBLING in changes)
    for kind in real:
        yield Special(kind, border.value, beyond.gait, around, words=words)
    more = abs(beyond.gait.unstable - short.gait.unstable)
    explained = more <= len(real) and (more - len(real)) % 2 == 0
    if not explained or turns != (FOLD in changes):
        yield replace(_unclassified(short, beyond, _account(short, beyond)), words=words)


def _unclassified(before: Point, after: Point, why: str) -> Special:
    middle, around = 0.5 * (before.value + after.value), (before.value, after.value)
    words = (before.gait.word, after.gait.word)
    return Special(UNCLASSIFIED, middle, after.gait, around, why, words if words[0] != words[1] else None)


def _period_doubling(point: Point) -> float:
    """Zero where an eigenvalue is -1."""
    return float(np.linalg.det(point.gait.jacobian + np.eye(len(point.gait.jacobian))))


def _passes_one(before: Point, after: Point) -> bool:
    """An odd number of real eigenvalues gets across +1."""
    identity = np.eye(len(before.gait.jacobian))
    low, high = (np.linalg.det(identity - point.gait.jacobian) for point in (before, after))
    return bool((low > 0.0) != (high > 0.0))


def _neimark_sacker(point: Point) -> float:
    """Zero where the product of two eigenvalues is 1: a pair on the unit circle, or a neutral saddle."""
    pairs = [a * b - 1.0 for a, b in combinations(point.gait.eigenvalues, 2)]
    return float(np.prod(pairs).real)


_TESTS: Mapping[str, Callable[[Point], float]] = {
    FOLD: lambda point: float(point.tangent[-1]),
    PERIOD_DOUBLING: _period_doubling,
    NEIMARK_SACKER: _neimark_sacker,
}
"""Functions of a gait that change their sign where something may happen."""
_STABILITY_CHANGES: Mapping[tuple[str, ...], tuple[int, ...]] = {
    (): (0,),
    (FOLD,): (1,),
    (PERIOD_DOUBLING,): (1,),
    (NEIMARK_SACKER,): (0, 2),
}
"""By how many the eigenvalues outside the unit circle may become more or fewer, where one thing happens."""


def _unstable_of_pairs(point: Point) -> int:
    """How many eigenvalues of complex pairs are outside the unit circle."""
    values = point.gait.eigenvalues
    return int(np.count_nonzero(np.abs(values[values.imag != 0.0]) > 1.0))


def _changes(before: Point, after: Point) -> tuple[str, ...]:
    return tuple(kind for kind, test in _TESTS.items() if (test(before) > 0.0) != (test(after) > 0.0))


def _is_simple(before: Point, after: Point) -> bool:
    """The one thing that happens explains how many eigenvalues get across the unit circle.

    Two real ones that leave it make the same sign change as a complex pair.
    """
    changes = _changes(before, after)
    more = after.gait.unstable - before.gait.unstable
    pairs = _unstable_of_pairs(after) - _unstable_of_pairs(before)
    if changes == (NEIMARK_SACKER,) and more not in (0, pairs):
        return False
    return abs(more) in _STABILITY_CHANGES.get(changes, ())


def _account(before: Point, after: Point) -> str:
    """What is seen of two gaits between which more happens than can be told apart."""
    changes = _changes(before, after)
    words = f"{before.gait.word} becomes {after.gait.word}" if before.gait.word != after.gait.word else ""
    turns = "the branch turns" if FOLD in changes else ""
    passes = "an eigenvalue passes -1" if PERIOD_DOUBLING in changes else ""
    counts = f"{before.gait.unstable} eigenvalues outside the unit circle become {after.gait.unstable}"
    return ", ".join(filter(None, (words, turns, passes, counts)))


def _bifurcations(family: Family, before: Point, after: Point) -> Iterator[Special]:
    """What a sign change of a test function stands for; a neutral saddle is nothing."""
    for kind in _changes(before, after):
        point = _zero(family, before, after, _TESTS[kind])
        if _is_there(kind, point.gait.eigenvalues):
            yield Special(kind, point.value, point.gait, (before.value, after.value))
        elif before.gait.unstable != after.gait.unstable:
            raise RunError(f"no eigenvalues of a {kind}: {_account(before, after)}")


def _is_there(kind: str, eigenvalues: NDArray[np.float64] | NDArray[np.complex128]) -> bool:
    if kind == NEIMARK_SACKER:
        return bool(np.any((np.abs(np.abs(eigenvalues) - 1.0) < ON_CIRCLE) & (eigenvalues.imag != 0.0)))
    return bool(np.min(np.abs(eigenvalues - (1.0 if kind == FOLD else -1.0))) < ON_CIRCLE)


def _zero(family: Family, before: Point, after: Point, test: Callable[[Point], float]) -> Point:
    """Where a test function is zero between two points of a branch, by the Illinois method."""
    low, high = 0.0, 1.0
    at_low, at_high = test(before), test(after)
    last = high
    for _ in range(MAX_LOOKS):
        share = high - at_high * (high - low) / (at_high - at_low)
        point = family.between(before, after, share)
        value = test(point)
        if value == 0.0 or min(abs(share - last), abs(high - low)) <= LOCATED:
            return point
        if (value > 0.0) != (at_high > 0.0):
            low, at_low = high, at_high
        else:
            at_low *= 0.5
        high, at_high, last = share, value, share
    raise RunError(f"not located between {family.name} = {before.value:g} and {after.value:g}")
