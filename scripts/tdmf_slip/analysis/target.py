"""Targets: gaits with prescribed quantities, other starts of the search, and the nearest gait to a target.

Newton's method leads to a target from a gait that is near, and on a way of targets from a gait of the same
branch. Where that branch ends, or the way leads where no gait is, gaits with parameters far from the first's
may still lead there. Where the target cannot be met, the nearest gait has the least sum of squared
deviations, each over what is prescribed. It is found by the method of Levenberg and Marquardt.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError, TdmfSlipError
from ..library.gait import Gait
from ..library.runner import Runner
from ..library.strides import plain_stride
from ..numerics.newton import GOOD_ENOUGH, Matrix, Vector, solve
from ..numerics.walking import halved, walk
from ..terminal.progress import progress_bar
from .gait_problem import GaitProblem
from .settled import around, settled_gaits

NEWTON_ITERATIONS, SHORTENINGS = 40, 6
"""Newton iterations, and shortenings of a step, if all that is prescribed is asked for at once."""
LONGEST_STEP = 1.0
"""Longest Newton step over the scales of apex and parameters: far beyond them a stride may take an age."""
CLOSE_ITERATIONS, CLOSE_SHORTENINGS = 10, 3
"""Newton iterations and shortenings for a point that is of use only near the gait."""
STEPS = 40
"""Steps on the way from the first gait's quantities to those prescribed, with the refused ones."""
LEAST_ITERATIONS, LEAST_STEP = 30, 1e-7
"""Iterations to the least change of parameters, and the last step, over the parameters' values."""
SHORTEST_SHARE = 5e-3
"""Shortest step, as a share of the way from the first gait's quantities to those prescribed."""
NONE = 1e-6
"""Share of a prescribed value below which a quantity counts as zero."""
DESCENT_ITERATIONS, LOOK_AHEAD = 30, 8
"""Steps of the search for the nearest gait, and of a look whether a further parameter helps."""
LONGEST_STEPS = (0.3, 0.03)
"""Longest steps over the scales of apex and parameters; each is tried, as they may lead elsewhere."""
MIN_DAMPING, MAX_DAMPING = 1e-9, 1e2
LITTLE = 1e-3
"""Share of the gap by which a step has to reduce it for another step to be worth it."""
HELPING = 0.95
"""A parameter helps if, varied too, it leaves at most this share of the gap."""
MAX_TRIED, TRIED_STEPS = 5, 10
"""Number of parameters that are tried, and of steps towards the target with each."""
SETTINGS = "hip."
"""Parameters that a runner changes at will; they are tried instead of a varied one, too."""
UNCHANGEABLE = ("gravity",)
"""Parameters that cannot be changed, which are not suggested."""


class Iterate(NamedTuple):
    """A point of a search for a gait with prescribed quantities."""

    x: Vector
    """Apex and varied parameters, over the scales."""
    closing: Vector
    """Residual of the stride, over the scales."""
    off: Vector
    """Deviations of the quantities from those prescribed, over these."""
    rows: Matrix
    """Derivatives of `closing` and `off` by the point."""

    @property
    def gap(self) -> float:
        """Distance of the point from the target: the root of the sum of squared deviations."""
        return float(np.linalg.norm(self.off))


def iterate_at(target: GaitProblem, x: Vector) -> Iterate:
    """The iterate at a point; TdmfSlipError where there is no stride."""
    residual, rows = target.linearize(x)
    return Iterate(x, residual[: target.count], residual[target.count :], rows)


def _solved(
    target: GaitProblem, x: Vector, iterations: int = CLOSE_ITERATIONS, shortenings: int = CLOSE_SHORTENINGS
) -> Vector:
    """The point near another that solves the equations, by the shortest steps."""
    return solve(target, x, iterations=iterations, shortenings=shortenings, longest=LONGEST_STEP).x


def solved_from(target: GaitProblem, iterate: Iterate, steps: int = STEPS) -> tuple[Iterate, float]:
    """The point that meets a target, or the last one on the way to it, and the share of the way.

    Newton's method begins at the point given. Where it fails, it is led through targets between the
    quantities of the gait and those prescribed, a share at a time.
    """
    with contextlib.suppress(TdmfSlipError):
        return iterate_at(target, _solved(target, iterate.x, NEWTON_ITERATIONS, SHORTENINGS)), 1.0
    way, attempts = iterate.off * target.quantity_scales, iter(range(steps))

    def advance(x: Vector, _at: float, to: float) -> Vector:
        if next(attempts, None) is None:
            raise RunError("too many steps on the way to the target")
        return _solved(target.with_goal(target.goal + (1.0 - to) * way), x)

    reached = [(0.0, iterate.x)]
    with contextlib.suppress(TdmfSlipError):
        reached.extend(walk(iterate.x, 0.0, 1.0, advance, shortest=SHORTEST_SHARE, first=0.5))
    share, x = reached[-1]
    return (iterate_at(target, x) if share else iterate), share


def least_changed(target: GaitProblem, iterate: Iterate, begin: Iterate) -> Iterate:
    """The gait that meets the target with the least change of the varied parameters, over their values.

    Steps of the Gauss-Newton method lead along the gaits that meet the target. The search ends where the
    change no longer gets smaller by much, or no nearer gait meets the target.
    """
    count = target.count

    def change(x: Vector) -> Vector:
        return x[count:] - begin.x[count:]

    for _ in range(LEAST_ITERATIONS):
        tangents = null_space(iterate.rows)
        step = -tangents @ np.linalg.lstsq(tangents[count:], change(iterate.x))[0]
        if not np.max(np.abs(step[count:]), initial=0.0) > LEAST_STEP:
            break
        step *= min(1.0, LONGEST_STEP / float(np.max(np.abs(step))))
        before = iterate

        def nearer(share: float, before: Iterate = before, step: Vector = step) -> Iterate:
            found = iterate_at(target, _solved(target, before.x + share * step))
            if not np.linalg.norm(change(found.x)) < np.linalg.norm(change(before.x)):
                raise RunError("the change does not get smaller")
            return found

        try:
            iterate, _ = halved(nearer, 1.0, SHORTEST_SHARE)
        except TdmfSlipError:
            break
    return iterate


def null_space(rows: Matrix) -> Matrix:
    """An orthonormal basis of the null space, in columns, for rows that are independent."""
    basis: Matrix = np.linalg.svd(rows)[2][len(rows) :].T
    return basis


def initial_iterates(target: GaitProblem, first: Gait) -> Iterator[Iterate]:
    """Gaits from which a target may be reached, the nearest to it first."""

    def gap(runner: Runner, apex: Vector) -> float:
        return _gap(plain_stride(runner, apex, target.quantities).quantities, target.goal)

    for gait in settled_gaits(first, target.names, partial(around, first.runner)).gaits(gap):
        with contextlib.suppress(TdmfSlipError):
            yield iterate_at(target, target.at(gait))


def _gap(quantities: NDArray[np.float64], prescribed: NDArray[np.float64]) -> float:
    """Distance of a gait from a target by logarithms of ratios, or by deviations where signs differ."""
    size = np.abs(prescribed)
    size[size == 0.0] = 1.0
    factors = np.maximum(quantities / size, NONE) / np.maximum(prescribed / size, NONE)
    positive = (prescribed > 0.0) & (quantities >= 0.0)
    off = np.where(positive, np.log(factors), (quantities - prescribed) / size)
    return float(np.linalg.norm(off))


def nearest_from(
    target: GaitProblem,
    iterates: Sequence[Iterate],
    steps: Sequence[float] = LONGEST_STEPS,
    iterations: int = DESCENT_ITERATIONS,
) -> Iterate:
    """The gait nearest to a target, of those that are reached from some gaits."""
    return min(
        (_descended(target, iterate, step, iterations) for iterate in iterates for step in steps),
        key=lambda iterate: iterate.gap,
    )


def _descended(target: GaitProblem, iterate: Iterate, longest: float, iterations: int) -> Iterate:
    """Iterate at which the gap gets no smaller, by the method of Levenberg and Marquardt along the gaits."""
    damping, free = 1e-3, target.with_goal(None)
    for _ in range(iterations):
        step = _step_along(iterate, slice(None), damping, longest)
        try:
            tried = iterate_at(target, _solved(free, iterate.x + step))
        except TdmfSlipError:
            tried = iterate
        gain = iterate.gap - tried.gap
        if gain <= 0.0:
            damping *= 10.0
            if damping > MAX_DAMPING:
                break
            continue
        enough = tried.gap <= GOOD_ENOUGH or gain < LITTLE * iterate.gap
        iterate, damping = tried, max(0.1 * damping, MIN_DAMPING)
        if enough:
            break
    return iterate


def _step_along(iterate: Iterate, columns: slice | list[int], damping: float, longest: float) -> Vector:
    """The damped step along the gaits that leaves the least gap, by some of the unknowns."""
    rows, count = iterate.rows[:, columns], len(iterate.closing)
    tangents = null_space(rows[:count])
    slopes = rows[count:] @ tangents
    square = slopes.T @ slopes + damping * np.eye(tangents.shape[1])
    step: Vector = tangents @ np.linalg.lstsq(square, -slopes.T @ iterate.off)[0]
    return step * min(1.0, longest / (float(np.linalg.norm(step)) or 1.0))


@dataclass(frozen=True)
class Help:
    """A parameter that brings a target nearer, or meets it."""

    name: str
    """Name of the parameter or input."""
    instead_of: str
    """Varied parameter that then keeps its value; empty where all of them vary."""
    left: float
    """Gap that is left; 0 where the target is met."""
    changed: float
    """Distance of the gait that meets the target from the first, over the scales."""

    def __str__(self) -> str:
        """Advice and its effect, in parentheses."""
        how = f"instead of {self.instead_of}" if self.instead_of else "too"
        return f"vary {self.name} {how} ({'meets the target' if self.left == 0.0 else 'comes nearer'})"


def parameters_that_help(
    target: GaitProblem, nearest: Iterate, first: Gait, progress: bool = False
) -> tuple[Help, ...]:
    """Parameters and inputs that bring the target nearer, each varied beside the others or instead of one.

    Those whose derivatives promise most, at the nearest gait or at the first one, are varied one by one from
    the first gait on, as a user who varies them begins. Those are named with which the target is met, or a
    gait is found that is nearer to it.
    """
    maximum, near = HELPING * nearest.gap, target.gait_at(nearest.x)
    promising = _promising(target, (near, first))
    found: list[Help] = []
    with progress_bar("what would help", len(promising), "parameters", progress) as bar:
        for name in promising:
            more = _helps(target, name, "", (first, near), maximum)
            others = target.names if name.startswith(SETTINGS) else ()
            instead = (_helps(target, name, other, (first, near), maximum) for other in others)
            one = more if more.left == 0.0 else next((help for help in instead if help.left == 0.0), more)
            found += [one] if one.left <= maximum else []
            bar.update()
    return tuple(sorted(found, key=lambda help: (help.left, help.changed)))


def _helps(target: GaitProblem, name: str, other: str, gaits: tuple[Gait, Gait], maximum: float) -> Help:
    """The gap that is left where one more parameter varies, or one instead of another that is named.

    The search begins at the first gait. A parameter that varies too may also come nearer from the second one.
    """
    first, near = gaits
    kept = [name if varied == other else varied for varied in target.names]
    wider = _varying(target, kept if other else [*kept, name])
    try:
        begin = iterate_at(wider, wider.at(first))
        there, share = solved_from(wider, begin, STEPS if other else TRIED_STEPS)
        if not other and there.gap > maximum:
            there = nearest_from(wider, [iterate_at(wider, wider.at(near))], LONGEST_STEPS[:1], LOOK_AHEAD)
    except TdmfSlipError:
        return Help(name, other, np.inf, np.inf)
    left = 0.0 if share == 1.0 else np.inf if other else there.gap
    return Help(name, other, left, float(np.linalg.norm(there.x - begin.x)))


def _varying(target: GaitProblem, names: Sequence[str]) -> GaitProblem:
    """The same target with other parameters varied."""
    prescribed = dict(zip(target.quantities, target.goal.tolist(), strict=True))
    return GaitProblem(target.runner, names, prescribed=prescribed)


def _promising(target: GaitProblem, gaits: Sequence[Gait]) -> list[str]:
    """Further parameters; first those that, by the derivatives, would leave the smallest gap."""
    values = gaits[0].runner
    left_out = (*target.names, *UNCHANGEABLE)
    names = [name for name in values.model.varied if name not in left_out and values[name] != 0.0]
    widest = _varying(target, [*target.names, *names])
    left = dict.fromkeys(names, np.inf)
    for gait in gaits:
        with contextlib.suppress(TdmfSlipError):
            iterate = iterate_at(widest, widest.at(gait))
            kept = list(range(len(target.scales)))
            for further, name in enumerate(names, len(kept)):
                columns = [*kept, further]
                slopes = iterate.rows[target.count :, columns]
                step = _step_along(iterate, columns, 0.0, LONGEST_STEPS[0])
                left[name] = min(left[name], float(np.linalg.norm(iterate.off + slopes @ step)) / iterate.gap)
    return sorted(names, key=lambda name: left[name])[:MAX_TRIED]
