"""Targets: gaits with prescribed quantities, other starts of the search, and the nearest gait to a target.

Newton's method leads to a target from a gait that is near, and on a way of targets from a gait of the same
branch. Where that branch ends, or the way leads where no gait is, gaits with parameters far from the first's
may still lead there. Where the target cannot be met, the nearest gait has the least sum of squared
deviations, each over what is prescribed. It is found by the method of Levenberg and Marquardt.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError
from ..library.fixed_point import gait_near
from ..library.gait import Gait
from ..library.quantities import scales_of
from ..library.runner import Runner
from ..library.strides import MadeStride, plain_stride, varied_stride
from ..numerics.following import halved, walk
from ..numerics.newton import GOOD_ENOUGH, solve
from ..terminal.progress import progress_bar
from .settled import around, settled_gaits

NEWTON_ITERATIONS, SHORTENINGS = 40, 6
"""Newton iterations, and shortenings of a step, if all that is prescribed is asked for at once."""
LONGEST_STEP = 1.0
"""Longest Newton step over the scales of apex and parameters: far beyond them a stride may take an age."""
CLOSE_ITERATIONS, CLOSE_SHORTENINGS = 10, 3
"""Newton iterations and shortenings for a point that is near the gait, or else of no use."""
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
"""Parameters whose derivatives promise most are tried, each by so many steps towards the target."""
SETTINGS = "hip."
"""Parameters that a runner changes at will; they are tried instead of a varied one, too."""
NOT_THE_RUNNERS = ("gravity",)
"""Parameters that nobody can change, which are not suggested as a help."""


@dataclass(frozen=True, eq=False)
class Iterate:
    """An apex and parameters, with the stride from there."""

    at: NDArray[np.float64]
    """Coordinates, then varied parameters, over the scales."""
    varied: MadeStride
    """The stride from there, with its derivatives."""


class Target:
    """Quantities that a gait is to have, and the parameters that are varied for it."""

    def __init__(self, runner: Runner, quantities: Mapping[str, float], vary: Sequence[str]) -> None:
        """All are taken as they are; `find_gait` checks them."""
        self.runner, self.vary = runner, tuple(vary)
        self.names = tuple(quantities)
        self.prescribed = np.array([quantities[name] for name in self.names])
        self.scales = scales_of(runner, self.vary)
        self._apex_scales = runner.scales
        self.quantity_scales = np.array([abs(value) or 1.0 for value in self.prescribed])

    def varying(self, names: Sequence[str]) -> Target:
        """The same target with other parameters varied."""
        return Target(self.runner, dict(zip(self.names, map(float, self.prescribed), strict=True)), names)

    def runner_at(self, at: NDArray[np.float64]) -> Runner:
        """The runner with the varied parameters' values at a point."""
        values = (at * self.scales)[-len(self.vary) :]
        return self.runner.replace(dict(zip(self.vary, map(float, values), strict=True)))

    def iterate_of(self, gait: Gait) -> Iterate:
        """The iterate of a gait of this runner, whatever its varied parameters."""
        values = [gait.runner[name] for name in self.vary]
        return self.evaluate(np.append(gait.apex, values) / self.scales)

    def evaluate(self, at: NDArray[np.float64]) -> Iterate:
        """The stride from a point."""
        count = len(self._apex_scales)
        try:
            runner = self.runner_at(at)
            varied = varied_stride(runner, (at * self.scales)[:count], self.names, self.vary)
        except InputError as problem:
            raise RunError(str(problem)) from None
        return Iterate(at, varied)

    def plain(self, at: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Residual of the stride from a point, over the scales, and the quantities of the stride."""
        apex = (at * self.scales)[: len(self._apex_scales)]
        try:
            stride = plain_stride(self.runner_at(at), apex, self.names)
        except InputError as problem:
            raise RunError(str(problem)) from None
        return stride.residual / self._apex_scales, stride.quantities

    def gait(self, iterate: Iterate) -> Gait:
        """The gait at a point where the stride leads back to its apex."""
        return gait_near(self.runner_at(iterate.at), (iterate.at * self.scales)[: len(self._apex_scales)])

    def deviations(self, iterate: Iterate) -> NDArray[np.float64]:
        """How far a point's quantities are from those prescribed, over these."""
        off: NDArray[np.float64] = (iterate.varied.quantities - self.prescribed) / self.quantity_scales
        return off

    def rows(self, iterate: Iterate) -> NDArray[np.float64]:
        """Derivatives of the residual and of the quantities by the point, all over the scales."""
        scales = np.append(self._apex_scales, self.quantity_scales)
        rows: NDArray[np.float64] = iterate.varied.by_all * self.scales / scales[:, None]
        return rows

    def closing(self, iterate: Iterate) -> NDArray[np.float64]:
        """Residual of the stride, over the scales."""
        return iterate.varied.residual / self._apex_scales

    def solved_from(self, iterate: Iterate, steps: int = STEPS) -> tuple[Iterate, float]:
        """The point that meets the target, or the last one on the way to it.

        Newton's method alone, from the point given; where it fails, through targets between what the gait
        has and what is prescribed, a share at a time.
        """
        with contextlib.suppress(RunError):
            return self._solved(iterate.at, self.prescribed), 1.0
        begin, way = iterate.varied.quantities, self.prescribed - iterate.varied.quantities
        attempts = iter(range(steps))

        def advance(iterate: Iterate, _at: float, to: float) -> Iterate:
            if next(attempts, None) is None:
                raise RunError("too many steps on the way to the target")
            goal = self.prescribed if to == 1.0 else begin + to * way
            return self._solved(iterate.at, goal, CLOSE_ITERATIONS, CLOSE_SHORTENINGS)

        done = 0.0
        with contextlib.suppress(RunError):
            for share, there in walk(iterate, 0.0, 1.0, advance, shortest=SHORTEST_SHARE, first=0.5):
                iterate, done = there, share
        return iterate, done

    def closed_near(self, at: NDArray[np.float64]) -> Iterate:
        """The gait near a point, by the shortest steps that lead to one."""
        return self._solved(at, None, CLOSE_ITERATIONS, CLOSE_SHORTENINGS)

    def least_changed(self, iterate: Iterate, begin: Iterate) -> Iterate:
        """The gait that meets the target with the least change of the varied parameters, over their values.

        By the method of Gauss and Newton along the gaits that meet the target. Where the change no longer
        gets smaller by much, or no nearer gait meets the target, the search ends.
        """
        count = len(self._apex_scales)
        change = float(np.linalg.norm(iterate.at[count:] - begin.at[count:]))
        for _ in range(LEAST_ITERATIONS):
            tangents = null_space(self.rows(iterate))
            step = -tangents @ np.linalg.lstsq(tangents[count:], iterate.at[count:] - begin.at[count:])[0]
            if not np.max(np.abs(step[count:]), initial=0.0) > LEAST_STEP:
                break
            step *= min(1.0, LONGEST_STEP / float(np.max(np.abs(step))))
            try:
                attempt = partial(self._nearer, iterate, begin, step, change)
                (iterate, change), _ = halved(attempt, 1.0, SHORTEST_SHARE)
            except RunError:
                break
        return iterate

    def _nearer(
        self, iterate: Iterate, begin: Iterate, step: NDArray[np.float64], change: float, share: float
    ) -> tuple[Iterate, float]:
        """A gait a share of a step away that meets the target, and its change, which has to be smaller."""
        found = self._solved(iterate.at + share * step, self.prescribed, CLOSE_ITERATIONS, CLOSE_SHORTENINGS)
        count = len(self._apex_scales)
        changed = float(np.linalg.norm(found.at[count:] - begin.at[count:]))
        if not changed < change:
            raise RunError("the change does not get smaller")
        return found, changed

    def _solved(
        self,
        at: NDArray[np.float64],
        goal: NDArray[np.float64] | None,
        iterations: int = NEWTON_ITERATIONS,
        shortenings: int = SHORTENINGS,
    ) -> Iterate:
        """The gait near a point with quantities as the goal says, or with whatever they are."""
        found = solve(
            _Closing(self, goal), at, iterations=iterations, shortenings=shortenings, longest=LONGEST_STEP
        )
        return self.evaluate(found.x)

    def gap(self, iterate: Iterate) -> float:
        """How far a gait is from the target: the root of the sum of squared deviations."""
        return float(np.linalg.norm(self.deviations(iterate)))


@dataclass(frozen=True, eq=False)
class _Closing:
    """Equations of a stride that closes and, with a goal, whose quantities are these."""

    target: Target
    goal: NDArray[np.float64] | None

    def residual(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """Residual of the stride, then deviations of the quantities, over the scales."""
        return self._off(*self.target.plain(x))

    def linearize(self, x: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The residual and its exact Jacobian."""
        iterate = self.target.evaluate(x)
        residual = self._off(self.target.closing(iterate), iterate.varied.quantities)
        return residual, self.target.rows(iterate)[: len(residual)]

    def _off(self, closing: NDArray[np.float64], quantities: NDArray[np.float64]) -> NDArray[np.float64]:
        if self.goal is None:
            return closing
        return np.append(closing, (quantities - self.goal) / self.target.quantity_scales)


def null_space(rows: NDArray[np.float64]) -> NDArray[np.float64]:
    """An orthonormal basis of the null space, in columns, for rows that are independent."""
    basis: NDArray[np.float64] = np.linalg.svd(rows)[2][len(rows) :].T
    return basis


def initial_iterates(target: Target, first: Gait) -> Iterator[Iterate]:
    """Gaits from which a target may be reached, the nearest to it first."""

    def gap(runner: Runner, apex: NDArray[np.float64]) -> float:
        return _gap(plain_stride(runner, apex, target.names).quantities, target.prescribed)

    for gait in settled_gaits(first, target.vary, partial(around, first.runner)).gaits(gap):
        try:
            iterate = target.iterate_of(gait)
        except RunError:
            continue
        yield iterate


def _gap(quantities: NDArray[np.float64], prescribed: NDArray[np.float64]) -> float:
    """How far a gait is from a target, by factors: half is as far as twice; where signs differ, over it."""
    size = np.abs(prescribed)
    size[size == 0.0] = 1.0
    factors = np.maximum(quantities / size, NONE) / np.maximum(prescribed / size, NONE)
    positive = (prescribed > 0.0) & (quantities >= 0.0)
    off = np.where(positive, np.log(factors), (quantities - prescribed) / size)
    return float(np.linalg.norm(off))


def nearest_from(
    target: Target,
    iterates: Sequence[Iterate],
    steps: Sequence[float] = LONGEST_STEPS,
    iterations: int = DESCENT_ITERATIONS,
) -> Iterate:
    """The gait nearest to a target, of those that are reached from some gaits."""
    return min(
        (_descended(target, iterate, step, iterations) for iterate in iterates for step in steps),
        key=target.gap,
    )


def _descended(target: Target, iterate: Iterate, longest: float, iterations: int) -> Iterate:
    """Iterate at which the gap gets no smaller."""
    damping = 1e-3
    for _ in range(iterations):
        gap = target.gap(iterate)
        tried = _stepped(target, iterate, damping, longest)
        if tried is None or target.gap(tried) >= gap:
            damping *= 10.0
            if damping > MAX_DAMPING:
                break
            continue
        iterate, damping = tried, max(0.1 * damping, MIN_DAMPING)
        if target.gap(tried) <= GOOD_ENOUGH or gap - target.gap(tried) < LITTLE * gap:
            break
    return iterate


def _stepped(target: Target, iterate: Iterate, damping: float, longest: float) -> Iterate | None:
    """A step towards the target along the gaits; None where there is no gait."""
    count = len(target.closing(iterate))
    rows = target.rows(iterate)
    tangents = null_space(rows[:count])
    slopes = rows[count:] @ tangents
    square = slopes.T @ slopes + damping * np.eye(tangents.shape[1])
    step = tangents @ np.linalg.solve(square, -slopes.T @ target.deviations(iterate))
    step *= min(1.0, longest / (float(np.linalg.norm(step)) or 1.0))
    try:
        return target.closed_near(iterate.at + step)
    except RunError:
        return None


@dataclass(frozen=True)
class Help:
    """A parameter that brings a target nearer, or meets it."""

    name: str
    """Name of the parameter or input."""
    instead_of: str
    """Varied parameter that then keeps its value; empty where all of them vary."""
    left: float
    """Share of the gap that is left; 0 where the target is met."""
    changed: float
    """How far the gait that meets the target is from the first, over the scales."""

    def __str__(self) -> str:
        """Advice and its effect, in parentheses."""
        how = f"instead of {self.instead_of}" if self.instead_of else "too"
        return f"vary {self.name} {how} ({'meets the target' if self.left == 0.0 else 'comes nearer'})"


def parameters_that_help(
    target: Target, nearest: Iterate, first: Gait, progress: bool = False
) -> tuple[Help, ...]:
    """Parameters and inputs that bring the target nearer, each varied beside the others or instead of one.

    Those whose derivatives promise most, at the nearest gait or at the first one, are varied one by one from
    the first gait on, as a user who varies them begins. Those are named with which the target is met, or a
    gait is found that is nearer to it.
    """
    maximum, near = HELPING * target.gap(nearest), target.gait(nearest)
    promising = _promising(target, (near, first))
    found: list[Help] = []
    with progress_bar("what would help", len(promising), "parameters", progress) as bar:
        for name in promising:
            more = _helps(target, name, "", (first, near), maximum)
            others = target.vary if name.startswith(SETTINGS) else ()
            instead = (_helps(target, name, other, (first, near), maximum) for other in others)
            one = more if more.left == 0.0 else next((help for help in instead if help.left == 0.0), more)
            found += [one] if one.left <= maximum else []
            bar.update()
    return tuple(sorted(found, key=lambda help: (help.left, help.changed)))


def _helps(target: Target, name: str, other: str, gaits: tuple[Gait, Gait], maximum: float) -> Help:
    """The gap that is left where one more parameter varies, or one instead of another that is named.

    The search begins at the first gait. A parameter that varies too may also come nearer from the second one.
    """
    first, near = gaits
    kept = [name if varied == other else varied for varied in target.vary]
    wider = target.varying(kept if other else [*kept, name])
    try:
        begin = wider.iterate_of(first)
        there, share = wider.solved_from(begin, STEPS if other else TRIED_STEPS)
        if not other and wider.gap(there) > maximum:
            there = nearest_from(wider, (wider.iterate_of(near),), LONGEST_STEPS[:1], LOOK_AHEAD)
    except RunError:
        return Help(name, other, np.inf, np.inf)
    left = 0.0 if share == 1.0 else np.inf if other else wider.gap(there)
    return Help(name, other, left, float(np.linalg.norm(there.at - begin.at)))


def _promising(target: Target, gaits: Sequence[Gait]) -> list[str]:
    """Further parameters; first those that, by the derivatives, would leave the smallest gap."""
    values = gaits[0].runner
    left_out = (*target.vary, *NOT_THE_RUNNERS)
    names = [name for name in values.model.varied if name not in left_out and values[name] != 0.0]
    widest = target.varying([*target.vary, *names])
    left = dict.fromkeys(names, np.inf)
    for gait in gaits:
        with contextlib.suppress(RunError):
            iterate = widest.iterate_of(gait)
            kept = list(range(len(gait.apex) + len(target.vary)))
            for further, name in enumerate(names, len(kept)):
                left[name] = min(left[name], _promised(widest, iterate, [*kept, further]))
    return sorted(names, key=lambda name: left[name])[:MAX_TRIED]


def _promised(target: Target, iterate: Iterate, columns: list[int]) -> float:
    """The share of the gap that is left after the longest step, along gaits, by some of what is varied."""
    off, count = target.deviations(iterate), len(target.closing(iterate))
    rows = target.rows(iterate)[:, columns]
    tangents = null_space(rows[:count])
    slopes = rows[count:] @ tangents
    step = -np.linalg.lstsq(slopes, off)[0]
    step *= min(1.0, LONGEST_STEPS[0] / (float(np.linalg.norm(step)) or 1.0))
    return float(np.linalg.norm(off + slopes @ step) / np.linalg.norm(off))
