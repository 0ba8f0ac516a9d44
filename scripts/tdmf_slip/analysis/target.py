"""The system that a gait with a target solves: its stride closes, its quantities are those prescribed.

Unknowns are the apex z and the varied parameters p. With the return map P and the quantities q, Newton's
method solves P(z, p) - z = 0 and q(z, p) = the target, all over their scales.
"""

import contextlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..contents import ByContents
from ..errors import InputError, RunError
from ..library.gait import Gait, gait_near
from ..library.quantities import scales_of
from ..library.runner import Runner
from ..library.varied_stride import VariedStride, varied_stride
from ..numerics.halving import walk
from ..numerics.newton import last_iterate

NEWTON_ITERATIONS, SHORTENINGS = 40, 6
"""To what is prescribed at once."""
LONGEST_STEP = 1.0
"""Of Newton's method, over the scales of apex and parameters: far beyond them a stride may take an age."""
CLOSE_ITERATIONS, CLOSE_SHORTENINGS = 10, 3
"""Where a point is near a gait that is sought, or else is of no use."""
STEPS = 40
"""Of the way from the first gait's quantities to those prescribed, with those that are refused."""
CONVERGED, GOOD_ENOUGH = 1e-13, 1e-11
"""Largest difference of apex and next apex over the scales, and of quantities over those prescribed."""
SHORTEST_SHARE = 5e-3
"""Of the way from the first gait's quantities to those prescribed."""


@dataclass(frozen=True, eq=False)
class Iterate(ByContents):
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

    def gait(self, iterate: Iterate) -> Gait:
        """The gait at a point where the stride leads back to its apex."""
        return gait_near(self.runner_at(iterate.at), (iterate.at * self.scales)[: len(self._apex_scales)])

    def deviations(self, iterate: Iterate) -> NDArray[np.float64]:
        """How far a point's quantities are from those prescribed, over these."""
        off: NDArray[np.float64] = (iterate.varied.quantities - self.prescribed) / self.quantity_scales
        return off

    def rows(self, iterate: Iterate) -> NDArray[np.float64]:
        """Changes of what is left over and of the quantities by the point, all over the scales."""
        scales = np.append(self._apex_scales, self.quantity_scales)
        rows: NDArray[np.float64] = iterate.varied.by_all * self.scales / scales[:, None]
        return rows

    def closing(self, iterate: Iterate) -> NDArray[np.float64]:
        """What is left over of the stride, over the scales."""
        return iterate.varied.left_over / self._apex_scales

    def solved_from(self, iterate: Iterate, steps: int = STEPS) -> tuple[Iterate, float]:
        """The point that meets the target, or the last one on the way to it.

        Newton's method alone, from the point given; where it fails, through targets between what the gait
        has and what is prescribed, a share at a time.
        """
        with contextlib.suppress(RunError):
            return self._by_newton(iterate, self.prescribed), 1.0
        begin, way = iterate.varied.quantities, self.prescribed - iterate.varied.quantities
        attempts = iter(range(steps))

        def advance(iterate: Iterate, _at: float, to: float) -> Iterate:
            if next(attempts, None) is None:
                raise RunError("too many steps on the way to the target")
            goal = self.prescribed if to == 1.0 else begin + to * way
            return self._by_newton(iterate, goal, CLOSE_ITERATIONS, CLOSE_SHORTENINGS)

        done = 0.0
        with contextlib.suppress(RunError):
            for share, there in walk(iterate, 0.0, 1.0, advance, shortest=SHORTEST_SHARE, first=0.5):
                iterate, done = there, share
        return iterate, done

    def closed_near(self, at: NDArray[np.float64]) -> Iterate:
        """The gait near a point, by the shortest steps that lead to one."""
        return self._by_newton(self.evaluate(at), None, CLOSE_ITERATIONS, CLOSE_SHORTENINGS)

    def _by_newton(
        self,
        iterate: Iterate,
        goal: NDArray[np.float64] | None,
        iterations: int = NEWTON_ITERATIONS,
        shortenings: int = SHORTENINGS,
    ) -> Iterate:
        """With quantities as the goal says, or with whatever they are."""
        closing = _Closing(self, goal)
        iterate, _ = last_iterate(closing, iterate, iterations=iterations, shortenings=shortenings)
        if closing.largest(iterate) > GOOD_ENOUGH:
            raise RunError("Newton's method does not converge")
        return iterate

    def gap(self, iterate: Iterate) -> float:
        """How far a gait is from the target: the root of the sum of squared deviations."""
        return float(np.linalg.norm(self.deviations(iterate)))


@dataclass(frozen=True, eq=False)
class _Closing(ByContents):
    """That a stride closes and, with a goal, that its quantities are these."""

    target: Target
    goal: NDArray[np.float64] | None

    def error(self, iterate: Iterate) -> float:
        return float(np.linalg.norm(self._off(iterate)))

    def largest(self, iterate: Iterate) -> float:
        return float(np.max(np.abs(self._off(iterate))))

    def is_solved(self, iterate: Iterate) -> bool:
        return self.largest(iterate) <= CONVERGED

    def step(self, iterate: Iterate) -> NDArray[Any]:
        """Of least length, and no longer than `LONGEST_STEP`."""
        off = self._off(iterate)
        step: NDArray[Any] = np.linalg.lstsq(self.target.rows(iterate)[: len(off)], -off)[0]
        return step * min(1.0, LONGEST_STEP / (float(np.max(np.abs(step))) or 1.0))

    def moved(self, iterate: Iterate, step: NDArray[Any]) -> Iterate:
        return self.target.evaluate(iterate.at + step)

    def _off(self, iterate: Iterate) -> NDArray[np.float64]:
        closing = self.target.closing(iterate)
        if self.goal is None:
            return closing
        return np.append(closing, (iterate.varied.quantities - self.goal) / self.target.quantity_scales)
