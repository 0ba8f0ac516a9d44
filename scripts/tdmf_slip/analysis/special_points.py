"""Special points of a branch of gaits: where it turns, where its stability changes, where its word changes.

At a fold an eigenvalue is +1 and the parameter turns back. At a period doubling an eigenvalue is -1, and at
a Neimark-Sacker point a complex pair is on the unit circle. At a word border the return map has a kink, and
eigenvalues may jump. Feigin's conditions for a border collision then classify the point from the maps of
both sides: the branch turns where det(I - J) changes its sign across the border, and the period doubles
where det(I + J) does. Any other change in the number of eigenvalues outside the unit circle is kept and
marked `unclassified`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError, counted
from ..library.gait import Gait
from ..numerics.following import Point
from ..numerics.newton import Matrix
from .gait_problem import BORDER_ACCURACY, BranchProblem

FOLD, PERIOD_DOUBLING, NEIMARK_SACKER = "fold", "period doubling", "Neimark-Sacker"
WORD_BORDER, UNCLASSIFIED = "word border", "unclassified"
SHORTEST = 1e-6
"""Length of branch within which special points are not distinguished."""
LOCATED = 1e-11
"""Share of the way between two gaits to which a zero of a test function is located."""
ON_CIRCLE = 1e-6
"""Distance of eigenvalues from where a bifurcation has them."""
CORNER = 1e-9
"""Largest distance of the points on both sides of a border; points farther apart are at an acute corner."""
ACUTE = 100.0
"""Longest way from such a point towards the corner, over the distance between both points."""
MAX_LOOKS = 100
MAX_BORDERS = 100


class Special(NamedTuple):
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
    """Reason why the point is unclassified, or why gaits of a period doubling are not followed."""
    words: tuple[str, str] = ("", "")
    """Gait words before and after the point, if they differ; else empty."""
    short: Gait | None = None
    """Gait just before a word border."""


def special_points(problem: BranchProblem, before: Point, after: Point) -> list[Special]:
    """Special points between two neighbouring points of a branch, in its order."""
    return list(_specials(problem, before, after))


def _specials(problem: BranchProblem, before: Point, after: Point) -> Iterator[Special]:
    """Special points of a segment, which is halved until it holds one or is too short."""
    length = float(np.linalg.norm(after.x - before.x))
    try:
        if before.gait.word != after.gait.word:
            yield from _across_borders(problem, before, after)
            return
        if _is_simple(before, after):
            yield from _bifurcations(problem, before, after)
            return
    except (InputError, RunError) as why:
        if length < SHORTEST:
            yield _unclassified(problem, before, after, str(why))
            return
    middle = None
    if length >= SHORTEST:
        try:
            middle = problem.between(before, after, 0.5)
        except (InputError, RunError):
            middle = None
    if middle is None or max(np.linalg.norm(middle.x - end.x) for end in (before, after)) >= 0.8 * length:
        yield _unclassified(problem, before, after, _account(before, after))
        return
    yield from _specials(problem, before, middle)
    yield from _specials(problem, middle, after)


def _across_borders(problem: BranchProblem, before: Point, after: Point) -> Iterator[Special]:
    """Word borders, and the special points on them and between them."""
    begin = before
    for short, beyond in list(crossings(problem, before, after)):
        yield from _specials(problem, begin, short)
        yield from _at_border(problem, short, beyond, (problem.value(before), problem.value(after)))
        begin = beyond
    yield from _specials(problem, begin, after)


def _at_border(
    problem: BranchProblem, short: Point, beyond: Point, around: tuple[float, float]
) -> Iterator[Special]:
    """A word border, and by the maps of both sides a fold or period doubling on it."""
    value, words = border_between(problem, short, beyond), (short.gait.word, beyond.gait.word)
    yield Special(WORD_BORDER, value, beyond.gait, around, words=words, short=short.gait)
    changes = _changes(short, beyond)
    # The branch turns where an odd number of real eigenvalues gets across 1.
    turns = FOLD in changes and (_determinant(FOLD, short) > 0.0) != (_determinant(FOLD, beyond) > 0.0)
    real = [FOLD] * turns + [PERIOD_DOUBLING] * (PERIOD_DOUBLING in changes)
    for kind in real:
        yield Special(kind, value, beyond.gait, around, words=words)
    more = abs(beyond.gait.unstable - short.gait.unstable)
    explained = more <= len(real) and (more - len(real)) % 2 == 0
    if not explained or turns != (FOLD in changes):
        yield _unclassified(problem, short, beyond, _account(short, beyond))


def _unclassified(problem: BranchProblem, before: Point, after: Point, why: str) -> Special:
    around = problem.value(before), problem.value(after)
    words = (before.gait.word, after.gait.word)
    kept = words if words[0] != words[1] else ("", "")
    return Special(UNCLASSIFIED, 0.5 * sum(around), after.gait, around, why, kept)


def bialternate(matrix: Matrix) -> Matrix:
    """The bialternate product of a matrix with itself: its eigenvalues are the products of pairs."""
    pairs = list(combinations(range(len(matrix)), 2))
    rows = [[matrix[i, k] * matrix[j, m] - matrix[i, m] * matrix[j, k] for k, m in pairs] for i, j in pairs]
    return np.array(rows).reshape(len(pairs), len(pairs))


SINGULAR: Mapping[str, Callable[[Matrix], Matrix]] = {
    FOLD: lambda jacobian: jacobian - np.eye(len(jacobian)),
    PERIOD_DOUBLING: lambda jacobian: jacobian + np.eye(len(jacobian)),
    NEIMARK_SACKER: lambda jacobian: (product := bialternate(jacobian)) - np.eye(len(product)),
}
"""Matrices made from the map's Jacobian that are singular at a bifurcation: where an eigenvalue is 1 or -1,
and where the product of two of them is 1, as for a pair on the unit circle or at a neutral saddle."""


def _determinant(kind: str, point: Point) -> float:
    """Determinant of a bifurcation's matrix."""
    return float(np.linalg.det(SINGULAR[kind](point.gait.jacobian)))


_STABILITY_CHANGES: Mapping[tuple[str, ...], tuple[int, ...]] = {
    (): (0,),
    (FOLD,): (1,),
    (PERIOD_DOUBLING,): (1,),
    (NEIMARK_SACKER,): (0, 2),
}
"""Possible changes of the number of eigenvalues outside the unit circle at one special point."""


def _unstable_in_pairs(point: Point) -> int:
    """Number of eigenvalues of complex pairs outside the unit circle."""
    values = point.gait.eigenvalues
    return int(np.count_nonzero(np.abs(values[values.imag != 0.0]) > 1.0))


def _test(kind: str, point: Point) -> float:
    """Test function that changes its sign at a bifurcation of a kind, or at a neutral saddle."""
    return float(point.tangent[-1]) if kind == FOLD else _determinant(kind, point)


def _changes(before: Point, after: Point) -> tuple[str, ...]:
    return tuple(kind for kind in SINGULAR if (_test(kind, before) > 0.0) != (_test(kind, after) > 0.0))


def _is_simple(before: Point, after: Point) -> bool:
    """True if at most one bifurcation explains how many eigenvalues get across the unit circle.

    Two real eigenvalues that leave the circle change the same sign as a complex pair.
    """
    changes = _changes(before, after)
    more = after.gait.unstable - before.gait.unstable
    pairs = _unstable_in_pairs(after) - _unstable_in_pairs(before)
    if changes == (NEIMARK_SACKER,) and more not in (0, pairs):
        return False
    return abs(more) in _STABILITY_CHANGES.get(changes, ())


def _account(before: Point, after: Point) -> str:
    """Text of the differences of two gaits that have several special points between them."""
    changes = _changes(before, after)
    words = f"{before.gait.word} becomes {after.gait.word}" if before.gait.word != after.gait.word else ""
    turns = "the branch turns" if FOLD in changes else ""
    passes = "an eigenvalue passes -1" if PERIOD_DOUBLING in changes else ""
    counts = (
        f"{counted(before.gait.unstable, 'eigenvalue')} outside the unit circle become {after.gait.unstable}"
    )
    return ", ".join(filter(None, (words, turns, passes, counts)))


def _bifurcations(problem: BranchProblem, before: Point, after: Point) -> Iterator[Special]:
    """Bifurcations at sign changes of test functions, without neutral saddles."""
    for kind in _changes(before, after):
        point = _zero(problem, before, after, kind)
        if is_bifurcation(kind, point.gait.eigenvalues):
            around = problem.value(before), problem.value(after)
            yield Special(kind, problem.value(point), point.gait, around)
        elif before.gait.unstable != after.gait.unstable:
            raise RunError(f"no eigenvalues of a {kind}: {_account(before, after)}")


def is_bifurcation(kind: str, eigenvalues: NDArray[Any]) -> bool:
    """True if eigenvalues are where a bifurcation has them."""
    if kind == NEIMARK_SACKER:
        return bool(np.any((np.abs(np.abs(eigenvalues) - 1.0) < ON_CIRCLE) & (eigenvalues.imag != 0.0)))
    return bool(np.min(np.abs(eigenvalues - (1.0 if kind == FOLD else -1.0))) < ON_CIRCLE)


def _zero(problem: BranchProblem, before: Point, after: Point, kind: str) -> Point:
    """The zero of a test function between two points of a branch."""
    from scipy.optimize import brentq  # slow to load

    found = {0.0: before, 1.0: after}

    def test_at(share: float) -> float:
        if share not in found:
            found[share] = problem.between(before, after, share)
        return _test(kind, found[share])

    try:
        return found[brentq(test_at, 0.0, 1.0, xtol=LOCATED, maxiter=MAX_LOOKS)]
    except RuntimeError:  # not convergent
        where = f"{problem.where(before.x)} and {problem.where(after.x)}"
        raise RunError(f"not located between {where}") from None


def border_between(problem: BranchProblem, short: Point, beyond: Point) -> float:
    """Value of the parameter at the border between two points that are next to it."""
    return 0.5 * (problem.value(short) + problem.value(beyond))


def crossings(problem: BranchProblem, first: Point, last: Point) -> Iterator[tuple[Point, Point]]:
    """Points short of and beyond each word border between two points of a branch."""
    inside = first
    for _ in range(MAX_BORDERS):
        if inside.gait.word == last.gait.word:
            return
        short, beyond = _border(problem, inside, last)
        short = short.along(inside.tangent)
        beyond = beyond.along(last.tangent) if beyond.gait.word == last.gait.word else beyond
        apart = float(np.linalg.norm(beyond.x - short.x))
        if apart > CORNER:
            short = _approached(problem, short, ACUTE * apart, 1.0)
            beyond = _approached(problem, beyond, ACUTE * apart, -1.0)
        yield short, beyond
        inside = beyond
    raise RunError(f"more than {MAX_BORDERS} borders between {first.gait.word} and {last.gait.word}")


def _border(problem: BranchProblem, inside: Point, last: Point) -> tuple[Point, Point]:
    """The points just before and just beyond the end of a word on the way from `inside` to `last`."""
    normal, word = last.x - inside.x, inside.gait.word
    where = f"border of {word} not located near {problem.where(inside.x)}"
    try:
        low, high = problem.border(inside.x, last.x, word, inside.rows)
    except (InputError, RunError) as why:
        raise RunError(f"{where}: {why}") from None
    short = inside if low is inside.x else problem.point(low, normal)
    beyond = last if high is last.x else problem.point(high, normal)
    if not short.gait.word == word != beyond.gait.word:
        raise RunError(where)
    return short, beyond


def _approached(problem: BranchProblem, point: Point, reach: float, way: float) -> Point:
    """The farthest point along the tangent of a point that has its word, within a reach."""
    direction, word = way * point.tangent, point.gait.word
    low, high, last = 0.0, reach, point
    while high - low > BORDER_ACCURACY:
        middle = 0.5 * (low + high)
        try:
            tried = problem.correct(point.x + middle * direction, direction, last)
            is_within = tried.gait.word == word and np.linalg.norm(tried.x - point.x) <= 2.0 * middle
        except (InputError, RunError):
            is_within = False
        if is_within:
            low, last = middle, replace(tried, tangent=point.tangent)
        else:
            high = middle
    return last
