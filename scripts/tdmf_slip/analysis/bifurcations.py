"""Where a branch turns or a gait's stability changes: located along the branch, and judged there.

A fold is an eigenvalue at +1 where the parameter turns back, a period doubling one at -1, a Neimark-Sacker
point a complex pair on the unit circle. Whatever else changes the number of eigenvalues outside the unit
circle from one gait to the next is told as not judged: none is passed over.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError
from ..library.orbit import Orbit
from .borders import Border, crossings
from .family import Family, Point

FOLD, PERIOD_DOUBLING, NEIMARK_SACKER = "fold", "period doubling", "Neimark-Sacker"
WORD_BORDER, NOT_JUDGED = "word border", "not judged"
SHORTEST = 1e-6
"""Length of branch within which changes that come together are not told apart."""
LOCATED = 1e-11
"""Of the way from one gait to the next."""
ON_CIRCLE = 1e-6
"""How near eigenvalues have to be to where a bifurcation puts them."""
MOST_LOOKS = 100


@dataclass(frozen=True)
class Special:
    """A point of a branch where its stability, its direction or its word changes."""

    kind: str
    """fold, period doubling, Neimark-Sacker, word border, or not judged."""
    value: float
    """Of the parameter; of what is not judged, the middle of where it lies."""
    orbit: Orbit
    """The gait there; at a word border, and of what is not judged, the one just beyond."""
    between: tuple[float, float]
    """Values of the parameter at two gaits around it, in their order along the branch."""
    why: str = ""
    """Why it is not judged."""

    def as_json(self) -> dict[str, object]:
        """As a plain object."""
        known: dict[str, object] = {"kind": self.kind, "value": self.value}
        return known | ({"between": list(self.between), "why": self.why} if self.why else {})


def happenings(family: Family, before: Point, after: Point) -> tuple[list[Border], list[Special]]:
    """What happens between two neighbouring points of a branch, in its order.

    Parameters
    ----------
    family : Family
        Whose branch it is.
    before, after : Point
        Neighbours on it.

    Returns
    -------
    pair of lists, of Border and of Special
        The borders between words, and the special points, which have the borders among them.
    """
    borders: list[Border] = []
    specials: list[Special] = []
    for begin, end in _simple_pieces(family, before, after):
        changes, around = _changes(begin, end), (begin.value, end.value)
        try:
            for border, beyond in _borders(family, begin, end, changes):
                borders.append(border)
                specials.append(Special(WORD_BORDER, border.value, beyond, around))
            if _is_simple(begin, end):
                specials += _bifurcations(family, begin, end, changes)
            elif _matters(begin, end, changes):
                raise RunError(_account(begin, end, changes))
        except (InputError, RunError) as problem:
            specials.append(Special(NOT_JUDGED, sum(around) / 2.0, end.orbit, around, str(problem)))
    return borders, specials


def _simple_pieces(family: Family, before: Point, after: Point) -> Iterator[tuple[Point, Point]]:
    """Pieces with one thing each that explains what happens, or too short to be told apart."""
    length = family.distance(before, after)
    if _is_simple(before, after) or length < SHORTEST:
        yield before, after
        return
    try:
        middle = family.between(before, after, 0.5)
        halved = max(family.distance(before, middle), family.distance(middle, after)) < 0.8 * length
    except (InputError, RunError):
        halved = False
    if not halved:
        yield before, after
        return
    yield from _simple_pieces(family, before, middle)
    yield from _simple_pieces(family, middle, after)


def _period_doubling(point: Point) -> float:
    """Zero where an eigenvalue is -1."""
    return float(np.linalg.det(point.orbit.jacobian + np.eye(len(point.orbit.apex))))


def _neimark_sacker(point: Point) -> float:
    """Zero where the product of two eigenvalues is 1: a pair on the unit circle, or a neutral saddle."""
    pairs = [a * b - 1.0 for a, b in combinations(point.orbit.eigenvalues, 2)]
    return float(np.prod(pairs).real)


_TESTS: Mapping[str, Callable[[Point], float]] = {
    FOLD: lambda point: float(point.direction[-1]),
    PERIOD_DOUBLING: _period_doubling,
    NEIMARK_SACKER: _neimark_sacker,
}
"""Functions of a gait that change their sign where something may happen."""
_STABILITY_CHANGES: Mapping[tuple[str, ...], tuple[int, ...]] = {
    (): (0,),
    (WORD_BORDER,): (0,),
    (FOLD,): (1,),
    (PERIOD_DOUBLING,): (1,),
    (NEIMARK_SACKER,): (0, 2),
}
"""By how many the eigenvalues outside the unit circle may become more or fewer, where one thing happens."""


def _unstable(point: Point, *, of_pairs: bool = False) -> int:
    """How many eigenvalues are outside the unit circle: all, or of complex pairs."""
    values = point.orbit.eigenvalues
    counted = values[values.imag != 0.0] if of_pairs else values
    return int(np.count_nonzero(np.abs(counted) > 1.0))


def _changes(before: Point, after: Point) -> tuple[str, ...]:
    found = [kind for kind, test in _TESTS.items() if (test(before) > 0.0) != (test(after) > 0.0)]
    return (*found, WORD_BORDER) if before.orbit.word != after.orbit.word else tuple(found)


def _is_simple(before: Point, after: Point) -> bool:
    """The one thing that happens explains how many eigenvalues get across the unit circle.

    Two real ones that leave it make the same sign change as a complex pair.
    """
    changes = _changes(before, after)
    more = _unstable(after) - _unstable(before)
    pairs = _unstable(after, of_pairs=True) - _unstable(before, of_pairs=True)
    if changes == (NEIMARK_SACKER,) and more not in (0, pairs):
        return False
    return abs(more) in _STABILITY_CHANGES.get(changes, ())


def _matters(before: Point, after: Point, changes: tuple[str, ...]) -> bool:
    """More than a border at which the eigenvalues jump, but none of them across the unit circle."""
    return bool({FOLD, PERIOD_DOUBLING} & set(changes)) or _unstable(before) != _unstable(after)


def _account(before: Point, after: Point, changes: tuple[str, ...]) -> str:
    """What is seen of two gaits between which more happens than can be told apart."""
    words = f"{before.orbit.word} becomes {after.orbit.word}" if WORD_BORDER in changes else ""
    turns = "the branch turns" if FOLD in changes else ""
    passes = "an eigenvalue passes -1" if PERIOD_DOUBLING in changes else ""
    counts = f"{_unstable(before)} eigenvalues outside the unit circle become {_unstable(after)}"
    return ", ".join(filter(None, (words, turns, passes, counts)))


def _borders(
    family: Family, before: Point, after: Point, changes: tuple[str, ...]
) -> Iterator[tuple[Border, Orbit]]:
    """With the gaits just beyond. Where the branch turns as well, only a short piece says where."""
    if WORD_BORDER not in changes:
        return
    if FOLD not in changes:
        yield from crossings(family, before.orbit, after.orbit)
    elif family.distance(before, after) < SHORTEST:
        middle = 0.5 * (before.value + after.value)
        yield Border(middle, before.orbit.word, after.orbit.word), after.orbit


def _bifurcations(family: Family, before: Point, after: Point, changes: tuple[str, ...]) -> Iterator[Special]:
    """What a sign change of a test function stands for; a neutral saddle is nothing.

    Raises
    ------
    RunError
        The eigenvalues at the zero are not those of a bifurcation.
    """
    for kind in changes:
        if kind == WORD_BORDER:
            continue
        point = _zero(family, before, after, _TESTS[kind])
        if _is_there(kind, point.orbit.eigenvalues):
            yield Special(kind, point.value, point.orbit, (before.value, after.value))
        elif _unstable(before) != _unstable(after):
            raise RunError(f"no eigenvalues of a {kind}: {_account(before, after, changes)}")


def _is_there(kind: str, eigenvalues: NDArray[np.float64] | NDArray[np.complex128]) -> bool:
    if kind == NEIMARK_SACKER:
        return bool(np.any((np.abs(np.abs(eigenvalues) - 1.0) < ON_CIRCLE) & (eigenvalues.imag != 0.0)))
    return bool(np.min(np.abs(eigenvalues - (1.0 if kind == FOLD else -1.0))) < ON_CIRCLE)


def _zero(family: Family, before: Point, after: Point, test: Callable[[Point], float]) -> Point:
    """Where a test function is zero between two points of a branch: by the Illinois method along the branch.

    Raises
    ------
    RunError
        It is not located.
    """
    low, high = 0.0, 1.0
    at_low, at_high = test(before), test(after)
    last = high
    for _ in range(MOST_LOOKS):
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
