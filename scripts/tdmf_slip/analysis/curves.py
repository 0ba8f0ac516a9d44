"""Curves of special points of gaits over two parameters: bifurcations, and borders between words."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial

import numpy as np
from numpy.typing import NDArray

from ..checks import checked_whole, refusal, shown
from ..errors import InputError, RunError
from ..given import row_of
from ..library.members import check_varied
from ..library.quantities import scales_of
from ..library.runner import Runner
from ..library.shared_steps import shares_steps
from ..numerics.halving import halved
from ..terminal.progress import progress_bar
from ..variables.parameters import RunnerLike
from ..variables.table import VARIABLES, by_full_name
from .bifurcations import NEIMARK_SACKER, UNCLASSIFIED, WORD_BORDER, Special
from .curve import CLOSED, LONGEST, SHORTEST, Box, Curve
from .lines import border_curve
from .meeting import PointSet
from .plane import CurvePoint, Plane
from .tracing import continue_branch

FARTHEST = 0.5
"""How far a point may be from where it was predicted, over the step."""
ON_CURVE = 0.02
"""Of the ranges: a special point as near to a curve of its kind is on it."""
MAX_POINTS = 10_000
"""Of a curve, in each direction."""
SAME = 1e-6
"""Two points of a curve that are as near, over the scales, are one."""


@shares_steps
def continue_curves(
    runner: RunnerLike,
    vary: Mapping[str, tuple[float, float]],
    *,
    model: str | None = None,
    max_points: int = 200,
    progress: bool = False,
) -> tuple[Curve, ...]:
    """Curves of special points over two parameters, each followed both ways to the ranges' edges.

    They begin at the special points of the branch over the first parameter, at the runner's value of the
    second, or where that is beyond its range at the range's beginning.

    Parameters
    ----------
    runner : Runner, Gait, mapping of str to float, Series, str or Path, optional
        Whose gaits.
    vary : mapping of str to pair of float
        By name of two parameters or inputs: the ends of their ranges.
    model : str, optional
        `full` or `reduced`, as in `find_gait`.
    max_points : int, default 200
        Of a curve in each direction.
    progress : bool, default False
        A count of points on stderr.

    Returns
    -------
    tuple of Curve
        Of folds, period doublings, Neimark-Sacker points and word borders.

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
    >>> print({curve.kind for curve in curves})
    {'word border'}
    """
    runner = Runner(runner, model=model)
    checked_whole("max_points", max_points, 1, MAX_POINTS)
    names, spans = _checked_ranges(vary)
    first, second = names
    if np.any(spans[:, 0] == spans[:, 1]):
        raise InputError(f"vary {first} and {second}: allowed: ranges whose ends differ")
    home = runner[second]
    if not spans[1].min() <= home <= spans[1].max():
        runner = runner.replace({second: float(spans[1, 0])})
    branch = continue_branch(runner, {first: (float(spans[0, 0]), float(spans[0, 1]))}, switch=False)
    sizes = scales_of(runner, names)[-2:]
    box = Box(spans.min(axis=1) / sizes, spans.max(axis=1) / sizes)
    found: list[Curve] = []
    with progress_bar("curves", None, "points", progress) as bar:

        def tell() -> None:
            bar.update()

        for special in branch.specials:
            at = np.array([special.value, runner[second]]) / sizes
            if special.kind == UNCLASSIFIED or _is_on(found, special, at, sizes, box):
                continue
            if special.kind == WORD_BORDER:
                curve = border_curve(runner, names, sizes, box, branch, special, max_points, tell)
            elif special.words is None:
                point = np.append(special.gait.apex / runner.scales, at)
                curve = curve_through(Plane(runner, names, special.kind), box, point, max_points, tell)
            else:
                continue  # on a word border, whose curve has it
            found.append(curve)
    return tuple(found)


def _checked_ranges(vary: object) -> tuple[tuple[str, str], NDArray[np.float64]]:
    """Names of the two parameters, and the ends of their ranges, shape (2, 2)."""
    allowed = "two parameters or inputs, each with the two ends of its range"
    given = by_full_name(vary, "vary", allowed)
    if len(given) != 2:
        raise InputError(f"vary = {shown(vary)} is not allowed; allowed: {allowed}")
    spans = []
    for name, ends in given.items():
        check_varied(name, "vary")
        pair = row_of(ends, f"vary {name}", allowed)
        if len(pair) != 2:
            raise refusal(f"vary {name}", ends, allowed)
        spans.append([float(VARIABLES.find(name, "vary").value_of(value, f"vary {name}")) for value in pair])
    first, second = given
    return (first, second), np.array(spans)


def _is_on(
    found: Sequence[Curve],
    special: Special,
    at: NDArray[np.float64],
    sizes: NDArray[np.float64],
    box: Box,
) -> bool:
    """A curve that has been followed goes through a special point."""
    for curve in found:
        if (curve.kind, curve.words) != (special.kind, special.words) or len(curve.points) < 2:
            continue
        points = (curve.points / sizes - at) / box.size
        begin, way = points[:-1], np.diff(points, axis=0)
        share = np.clip(-np.sum(begin * way, axis=1) / np.sum(way**2, axis=1), 0.0, 1.0)
        if np.min(np.linalg.norm(begin + share[:, None] * way, axis=1)) < ON_CURVE:
            return True
    return False


def curve_through(
    plane: Plane,
    box: Box,
    at: NDArray[np.float64],
    max_points: int,
    tell: Callable[[], None] = lambda: None,
) -> Curve:
    """The curve of bifurcations through one of them, both ways."""
    here = plane.evaluate(at)
    back, began = _followed(plane, box, [here], -here.tangent, max_points, tell)
    forth: list[CurvePoint] = []
    ended = began
    if began != CLOSED:
        forth, ended = _followed(plane, box, [*back[::-1], here], here.tangent, max_points, tell)
    whole = [*back[::-1], here, *forth]
    points = np.array([(point.at * plane.scales)[-2:] for point in whole])
    return Curve(plane.runner, plane.kind, plane.names, points, began, ended)


def _followed(
    plane: Plane,
    box: Box,
    known: Sequence[CurvePoint],
    direction: NDArray[np.float64],
    max_points: int,
    tell: Callable[[], None],
) -> tuple[list[CurvePoint], str]:
    """The curve from the last of the points that are known, without it, and why it stops."""
    found: list[CurvePoint] = []
    points = list(known)
    last, step = known[-1], 1.0
    while len(found) < max_points:
        longest = LONGEST / max(np.max(np.abs(direction[-2:]) / box.size), 0.05)
        try:
            following, step = halved(
                partial(_stepped, plane, last, longest * direction), step, SHORTEST / LONGEST
            )
        except (InputError, RunError) as problem:
            return found, _lost(plane, last, direction, problem)
        tell()
        if box.outside(following.at[-2:]):
            share = box.share(last.at[-2:], following.at[-2:])
            return [*found, _at_edge(plane, box, last, following, share)], "edge of the ranges"
        again = _met(plane, points, last, following)
        if again is not None:
            return [*found, again], CLOSED
        found.append(following)
        points.append(following)
        if plane.kind == NEIMARK_SACKER and not _is_complex(following):
            return found, "the eigenvalues become real: beyond, their product is 1 and none is on the circle"
        tangent = following.tangent
        last, direction = following, tangent if tangent @ direction > 0.0 else -tangent
        step = min(1.0, 1.5 * step)
    return found, f"number of points: {max_points}"


def _stepped(plane: Plane, last: CurvePoint, way: NDArray[np.float64], share: float) -> CurvePoint:
    """The point of the curve a share of a way further, from which it leads back."""
    goal = last.at + share * way
    following = plane.corrected(goal, way / np.linalg.norm(way), last)
    if np.linalg.norm(following.at - goal) > FARTHEST * share * np.linalg.norm(way):
        raise RunError("the curve turns sharply")
    if not plane.leads_back(following, last):
        raise RunError("no point is found that leads back")
    return following


def _met(
    plane: Plane, points: Sequence[CurvePoint], last: CurvePoint, following: CurvePoint
) -> CurvePoint | None:
    """The point at which the curve has been that it goes through in its next step, or None."""
    track = PointSet(len(plane.scales))
    for point in points:
        track.add(point.at)
    way = (following.at - last.at) / np.linalg.norm(following.at - last.at)
    for number, beside in track.beside(last.at, following.at):
        try:
            found = plane.corrected(beside, way, following)
        except (InputError, RunError):
            continue
        if np.linalg.norm(found.at - points[number].at) < SAME:
            return points[number]
    return None


def _at_edge(plane: Plane, box: Box, last: CurvePoint, following: CurvePoint, share: float) -> CurvePoint:
    """The point of the curve on the edge of the ranges; the last one within where it is not found."""
    goal = last.at + share * (following.at - last.at)
    across = np.zeros(len(goal))
    beyond = np.maximum(box.low - following.at[-2:], following.at[-2:] - box.high) / box.size
    across[-2 + int(np.argmax(beyond))] = 1.0
    try:
        return plane.corrected(goal, across, last)
    except (InputError, RunError):
        return last


def _is_complex(point: CurvePoint) -> bool:
    values = point.gait.eigenvalues
    on_circle = values[np.argmin(np.abs(np.abs(values) - 1.0))]
    return bool(on_circle.imag != 0.0)


def _lost(plane: Plane, last: CurvePoint, direction: NDArray[np.float64], problem: Exception) -> str:
    """Why a curve cannot be followed on."""
    try:
        beyond = plane.strides_at(last.at + 1e-3 * direction, plane.names[0])
    except (InputError, RunError) as fate:
        return f"lost: just beyond, {fate}"
    if beyond.sequence != last.gait.sequence:
        return f"at a word border: {last.gait.word} becomes {beyond.word}"
    return f"lost: {problem}"
