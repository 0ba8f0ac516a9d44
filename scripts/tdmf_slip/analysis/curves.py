"""Curves of special points of gaits over two parameters: bifurcations, and borders between words."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..checks import checked_whole
from ..errors import InputError, RunError
from ..library.gait import Gait
from ..library.members import ranges_varied
from ..library.runner import Runner
from ..library.shared_steps import shares_steps
from ..numerics.following import RETURNED, Limits, Point, both_ways
from ..numerics.newton import Matrix, Vector
from ..record import dataset
from ..terminal.progress import progress_bar
from ..variables.parameters import RunnerLike
from ..variables.table import Model
from .branches import branch_through, first_in_range
from .gait_problem import GaitProblem
from .special_points import (
    CORNER,
    NEIMARK_SACKER,
    SINGULAR,
    UNCLASSIFIED,
    WORD_BORDER,
    Special,
)

if TYPE_CHECKING:
    import xarray

DIFFERENCE = 1e-6
"""Difference of points, over the scales, by which the test function is differentiated."""
PARTS, MAX_STEP = 15.0, 0.3
"""Least number of steps across a range, and the longest step over the scales."""
ON_CURVE = 0.02
"""Largest distance, over the ranges, of a special point from a curve that goes through it."""
MAX_POINTS = 10_000
"""Largest number of points of a curve that may be asked for, in each direction."""
KINK = 1e-3
"""Change of the Jacobian across a border, over its size, from which both sides give the border's tangent."""
WIDTHS = (0.003, 0.03, 0.3, 3.0, 30.0)
"""Distances to either side of a predicted border at which words are read, over the step."""
FIRST_STEPS = (1e-4, 1e-5, 1e-6)
"""Steps along the second parameter to the second point of a border."""


class Curve(NamedTuple):
    """Special points of one kind over two parameters."""

    kind: str
    """fold, period doubling, Neimark-Sacker, or word border."""
    words: tuple[str, str]
    """Words on both sides of a word border; else empty."""
    points: NDArray[np.float64]
    """Both parameters at each point, in their units, shape (points, 2), in the curve's order."""
    began: str
    """Reason why the curve has no earlier points."""
    ended: str
    """Reason why the curve has no further points."""


class BifurcationProblem(GaitProblem):
    """Gaits over two parameters at which an eigenvalue is where a bifurcation has it.

    The last equation makes a matrix M singular. With the map's Jacobian J it is J - I for folds, J + I for
    period doublings, and the bialternate product of J with itself less I for Neimark-Sacker points. Its
    residual is the least singular value of M with the sign of det M, which is smooth where it is zero.
    """

    same = 1e-6

    def __init__(self, runner: Runner, names: Sequence[str], kind: str) -> None:
        """Bifurcations of a kind of a runner's gaits, over two parameters or inputs."""
        super().__init__(runner, names)
        self.kind = kind

    def singular(self, by_apex: Matrix) -> float:
        """Least singular value of the matrix M, with the sign of its determinant, from J - I."""
        matrix = SINGULAR[self.kind](by_apex + np.eye(len(by_apex)))
        return float(np.linalg.slogdet(matrix)[0] * np.linalg.svd(matrix, compute_uv=False)[-1])

    def residual(self, x: Vector) -> Vector:
        """Residual of the gait, and the singular value."""
        residual, by_apex = self.by_apex(x)
        return np.append(residual, self.singular(by_apex))

    def linearize(self, x: Vector) -> tuple[Vector, Matrix]:
        """The residual and its derivatives, those of the singular value by differences."""
        residual, rows = super().linearize(x)
        singular, gradient = self._differentiated(x, rows)
        return np.append(residual, singular), np.vstack([rows, gradient])

    def describe(self, x: Vector) -> tuple[Gait, Matrix]:
        """The gait, and the derivatives of all equations."""
        gait, rows = super().describe(x)
        return gait, np.vstack([rows, self._differentiated(x, rows)[1]])

    def _differentiated(self, x: Vector, rows: Matrix) -> tuple[float, Vector]:
        here = self.singular(rows[:, : len(rows)])
        there = [self.singular(self.by_apex(x + step)[1]) for step in DIFFERENCE * np.eye(len(x))]
        return here, (np.array(there) - here) / DIFFERENCE

    def ends_between(self, before: Point, after: Point) -> str:
        """Text if the eigenvalues of a Neimark-Sacker point become real; else empty."""
        values = after.gait.eigenvalues
        on_circle = values[np.argmin(np.abs(np.abs(values) - 1.0))]
        if self.kind != NEIMARK_SACKER or on_circle.imag != 0.0:
            return ""
        return "the eigenvalues become real: beyond, their product is 1 and none is on the circle"

    def lost(self, last: Point, why: Exception) -> str:
        """Reason why a curve cannot be followed on."""
        try:
            beyond, _ = super().describe(last.x + 1e-3 * last.tangent)
        except (InputError, RunError) as fate:
            return f"lost: just beyond, {fate}"
        if beyond.sequence != last.gait.sequence:
            return f"at a word border: {last.gait.word} becomes {beyond.word}"
        return f"lost: {why}"


@dataclass(frozen=True, eq=False)
class Side:
    """A gait next to a word border."""

    x: Vector
    """Apex and parameters, over the scales."""
    rows: Matrix
    """Derivatives of the residual."""


class BorderProblem(GaitProblem):
    """A border between two words over two parameters.

    It has no residual. On the plane across the border's tangent the gaits are a branch, on which the border
    is located by bisection. The branch may turn at a fold nearby: nothing is assumed about it.
    """

    same = 1e-6

    def __init__(self, runner: Runner, names: Sequence[str], special: Special) -> None:
        """The border through a special point of a branch over the first parameter."""
        super().__init__(runner, names)
        assert special.short is not None
        self.words, self._begin = special.words, (special.short, special.gait)

    def first(self) -> Point:
        """The special point, with the tangent of the border."""
        sides = [Side(x, self.describe(x)[1]) for x in map(self.at, self._begin)]
        up = np.eye(len(self.scales))[-1]
        here = self._between(sides[0], sides[1], up, None)
        if self._exact_tangent(sides[0], sides[1]) is not None:
            return here
        why = RunError("")
        for step in FIRST_STEPS:
            try:
                second = self.correct(here.x + step * up, up, here)
                return replace(here, tangent=second.tangent)
            except (InputError, RunError) as met:
                why = RunError(f"lost at the start: {met}")
        raise why

    def correct(self, goal: Vector, across: Vector, near: Point | None = None) -> Point:
        """The border near a goal on the plane across a direction, from a point of the border nearby."""
        assert near is not None
        shift = goal - near.x
        reach = max(float(np.linalg.norm(shift)), 1e-5)
        why: Exception = RunError("")
        for width in WIDTHS:
            try:
                ends = [
                    self._beside(side, shift, sign * width * reach, across, near)
                    for side, sign in zip(near.gait, (-1.0, 1.0), strict=True)
                ]
                # One of the words may last for less than the width: it is enough to see the other one end.
                for inner in (0, 1):
                    if ends[inner][1] == self.words[inner] != ends[1 - inner][1]:
                        return self._located([x for x, _ in ends], inner, across, near)
            except (InputError, RunError) as met:
                why = met
        raise RunError(f"no border from {self.words[0]} to {self.words[1]} goes on: {why}")

    def leads_back(self, found: Point, known: Point) -> bool:
        """True if the border is found again from the tangent at another point."""
        way = found.x - known.x
        try:
            back = self.correct(found.x - (way @ found.tangent) * found.tangent, found.tangent, found)
        except (InputError, RunError):
            return False
        return bool(np.linalg.norm(back.x - known.x) <= RETURNED * np.linalg.norm(way))

    def _beside(
        self, side: Side, shift: Vector, distance: float, across: Vector, near: Point
    ) -> tuple[Vector, str]:
        """A gait on the plane, at a distance from the expected border along the branch, and its word."""
        towards = near.gait[1].x - near.gait[0].x
        along = np.linalg.svd(np.vstack([side.rows, across]))[2][-1]
        along = along if along @ towards >= 0.0 else -along
        goal = side.x + shift + distance * along
        x = self.solution(goal, np.array([across, along]), side.rows)
        return x, self.word_at(x)

    def _located(self, ends: Sequence[Vector], inner: int, across: Vector, near: Point) -> Point:
        """The border between two gaits; the inner gait has the word of its side."""
        word, rows = self.words[inner], near.gait[inner].rows
        pair = self.border(ends[inner], ends[1 - inner], word, rows, across)
        if np.linalg.norm(pair[1] - pair[0]) > CORNER:
            raise RunError("the gaits of both words are apart")
        found = [self.describe(x) for x in pair]
        if found[1][0].word != self.words[1 - inner]:
            raise RunError(f"between {self.words[0]} and {self.words[1]} comes {found[1][0].word}")
        sides = [Side(x, rows) for x, (_, rows) in zip(pair, found, strict=True)]
        return self._between(sides[inner], sides[1 - inner], across, near)

    def _between(self, short: Side, beyond: Side, across: Vector, near: Point | None) -> Point:
        """The point of the border between its two sides, with its tangent along a direction."""
        x = 0.5 * (short.x + beyond.x)
        tangent = self._exact_tangent(short, beyond)
        if tangent is None:
            way = across if near is None else x - near.x
            tangent = way / np.linalg.norm(way)
        return Point(x, tangent, (short, beyond), short.rows).along(across)

    def _exact_tangent(self, short: Side, beyond: Side) -> Vector | None:
        """Tangent of the border, common to the gaits of both sides; None without a kink."""
        _, sizes, directions = np.linalg.svd(np.vstack([short.rows, beyond.rows]))
        tangent: Vector = directions[-1]
        return tangent if sizes[-2] > KINK * sizes[-3] else None


def continue_curves(
    runner: RunnerLike,
    vary: Mapping[str, tuple[float, float]],
    *,
    model: str | Model | None = None,
    max_points: int = 200,
    progress: bool = False,
) -> xarray.Dataset:
    """Follow curves of special points over two parameters, each both ways to the edges of the ranges.

    They begin at the special points of the branch over the first parameter. The second parameter has the
    runner's value there, or the beginning of its range if the runner's value is outside.

    Parameters
    ----------
    runner : as in `find_gait`
    vary : mapping of str to pair of float
        Two parameters or inputs, and the ends of their ranges.
    model : as in `find_gait`
    max_points : int, default 200
        Largest number of points of a curve, in each direction.
    progress : bool, default False
        Show a count of points on stderr.

    Returns
    -------
    xarray.Dataset
        Over `curve`: its `kind`, which is `fold`, `period doubling`, `Neimark-Sacker` or `word border`, the
        words `before` and `after` on both sides of a word border, and why it has no points before its first
        and after its last, `began` and `ended`. Over `point`: both parameters in the curve's order, and
        `curve_number`.

    Raises
    ------
    InputError
        No such parameter, a value that is not allowed, or a range without length.
    RunError
        There is no gait to begin with.

    Examples
    --------
    >>> import tdmf_slip
    >>> vary = {"ground.friction": (0.45, 0.55), "leg.damping": (0.19, 0.21)}
    >>> curves = tdmf_slip.continue_curves({}, vary, max_points=5)
    >>> print({str(kind) for kind in curves["kind"].values})
    {'word border'}
    """
    runner = Runner(runner, model=model)
    allowed = "two parameters or inputs, each with the two ends of its range"
    ranges = ranges_varied(vary, {2}, allowed, runner.model)
    (first, second), spans = ranges, np.array(list(ranges.values()))
    names = first, second
    return _dataset(runner, names, spans, _curves(runner, names, spans, max_points, progress))


def _dataset(
    runner: Runner, names: tuple[str, str], spans: NDArray[np.float64], curves: Sequence[Curve]
) -> xarray.Dataset:
    points = np.concatenate([np.empty((0, 2)), *(curve.points for curve in curves)])
    texts = [(curve.kind, curve.began, curve.ended, *curve.words) for curve in curves]
    columns = np.array(texts, dtype=object).reshape(-1, 5).T
    variables: dict[str, Any] = {
        name: ("curve", column)
        for name, column in zip(("kind", "began", "ended", "before", "after"), columns, strict=True)
    }
    numbers = np.repeat(np.arange(len(curves)), [len(curve.points) for curve in curves])
    variables["curve_number"] = "point", numbers
    coordinates = {
        name: ("point", column, runner.model.variables[name].attributes)
        for name, column in zip(names, points.T, strict=True)
    }
    ranges = {f"{axis}_range": span.tolist() for axis, span in zip(("first", "second"), spans, strict=True)}
    varied = names if len(points) else ()
    data = dataset("curves", runner.record(*varied), variables, coordinates, over=", ".join(names))
    return data.assign_attrs(ranges)


@shares_steps
def _curves(
    runner: Runner, names: tuple[str, str], spans: NDArray[np.float64], max_points: int, progress: bool
) -> list[Curve]:
    checked_whole("max_points", max_points, 1, MAX_POINTS)
    first, second = names
    if np.any(spans[:, 0] == spans[:, 1]):
        raise InputError(f"vary {first} and {second}: allowed: ranges whose ends differ")
    home = runner[second]
    if not spans[1].min() <= home <= spans[1].max():
        runner = runner.replace({second: float(spans[1, 0])})
    begin, end = map(float, spans[0])
    along = Limits(np.array([min(begin, end)]), np.array([max(begin, end)]), begin=begin)
    limits = Limits(spans.min(axis=1), spans.max(axis=1), MAX_STEP, max_points, parts=PARTS)
    found: list[Curve] = []
    with progress_bar("curves", None, "points", progress) as bar:
        branch = branch_through(first_in_range(runner, first, begin, end), first, begin, end, along)
        for special in (row.special for row in branch.rows if row.special is not None):
            at = np.array([special.value, runner[second]])
            if special.kind == UNCLASSIFIED or _is_on(found, special, at, limits):
                continue
            if special.kind == WORD_BORDER or not any(special.words):  # otherwise on the curve of a border
                found.append(curve_of(runner, names, special, at, limits, bar.update))
    return found


def _is_on(found: Sequence[Curve], special: Special, at: Vector, limits: Limits) -> bool:
    """True if a curve that has been followed goes through a special point."""
    for curve in found:
        same = curve.kind == special.kind and {*curve.words} == {*special.words}
        if not same or len(curve.points) < 2:
            continue
        points = (curve.points - at) / (limits.high - limits.low)
        begin, way = points[:-1], np.diff(points, axis=0)
        share = np.clip(-np.sum(begin * way, axis=1) / np.sum(way**2, axis=1), 0.0, 1.0)
        if np.min(np.linalg.norm(begin + share[:, None] * way, axis=1)) < ON_CURVE:
            return True
    return False


def curve_of(
    runner: Runner,
    names: tuple[str, str],
    special: Special,
    at: Vector,
    limits: Limits,
    step_finished: Callable[[], object] = lambda: None,
) -> Curve:
    """The curve through a special point of a branch over the first parameter, both ways."""
    try:
        if special.kind == WORD_BORDER:
            problem: GaitProblem = BorderProblem(runner, names, special)
            assert isinstance(problem, BorderProblem)
            start = problem.first()
        else:
            problem = BifurcationProblem(runner, names, special.kind)
            start = problem.start(special.gait, np.eye(len(problem.scales))[-1])
    except (InputError, RunError) as why:
        return Curve(special.kind, special.words, at[None, :], str(why), str(why))
    return curve_through(problem, start, limits, special.kind, special.words, step_finished)


def curve_through(
    problem: GaitProblem,
    start: Point,
    limits: Limits,
    kind: str,
    words: tuple[str, str] = ("", ""),
    step_finished: Callable[[], object] = lambda: None,
) -> Curve:
    """The curve of a problem through a point, both ways."""
    points, began, ended = both_ways(problem, start, limits, step_finished)
    values = np.array([problem.values(point.x) for point in points])
    return Curve(kind, words, values, began, ended)
