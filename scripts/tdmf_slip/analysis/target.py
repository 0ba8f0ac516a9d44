"""The system that a gait with a target solves: its stride closes, its quantities are those prescribed.

Unknowns are the apex z and the varied parameters p. With the return map P and the quantities q, Newton's
method solves P(z, p) - z = 0 and q(z, p) = the target, all over their scales.
"""

import contextlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError
from ..library.fixed_point import gait_near
from ..library.gait import Gait
from ..library.quantities import scales_of
from ..library.runner import Runner
from ..library.varied_stride import VariedStride, plain_stride, varied_stride
from ..numerics.following import halved, walk
from ..numerics.newton import solve

NEWTON_ITERATIONS, SHORTENINGS = 40, 6
"""To what is prescribed at once."""
LONGEST_STEP = 1.0
"""Of Newton's method, over the scales of apex and parameters: far beyond them a stride may take an age."""
CLOSE_ITERATIONS, CLOSE_SHORTENINGS = 10, 3
"""Where a point is near a gait that is sought, or else is of no use."""
STEPS = 40
"""Of the way from the first gait's quantities to those prescribed, with those that are refused."""
LEAST_ITERATIONS, LEAST_STEP = 30, 1e-7
"""To the least change of parameters, and the last step there, over the parameters' values."""
SHORTEST_SHARE = 5e-3
"""Of the way from the first gait's quantities to those prescribed."""


@dataclass(frozen=True, eq=False)
class Iterate:
    """An apex and parameters, with the stride from there."""

    at: NDArray[np.float64]
    """Coordinates, then varied parameters, over the scales."""
    varied: VariedStride
    """Of it."""


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

    def with_more(self, *names: str) -> "Target":
        """The same target with more parameters varied."""
        quantities = dict(zip(self.names, map(float, self.prescribed), strict=True))
        return Target(self.runner, quantities, [*self.vary, *names])

    def with_one_for(self, name: str, other: str) -> "Target":
        """The same target with another parameter varied instead of one."""
        quantities = dict(zip(self.names, map(float, self.prescribed), strict=True))
        return Target(self.runner, quantities, [other if varied == name else varied for varied in self.vary])

    def runner_at(self, at: NDArray[np.float64]) -> Runner:
        """The runner with the varied parameters' values at a point."""
        values = (at * self.scales)[-len(self.vary) :]
        return self.runner.replace(dict(zip(self.vary, map(float, values), strict=True)))

    def iterate_of(self, gait: Gait) -> Iterate:
        """That of a gait of this runner, whatever its varied parameters."""
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
        return stride.left_over / self._apex_scales, stride.quantities

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
        return iterate.varied.left_over / self._apex_scales

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
