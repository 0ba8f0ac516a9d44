"""Fixed points of the return map: the gait near a guess, and the one that a runner settles on."""

import contextlib
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..errors import GaitNotFoundError, RunError, counted
from ..numerics.newton import NotSolvedError, solve
from .binding import c
from .gait import Gait
from .members import at_friction, check_comes_down, check_has_gaits
from .page_strides import Strides
from .return_map import Along, derivatives, refuse_patch
from .runner import Runner
from .section import Apex, checked_apex
from .shared_steps import joins_search, search_under_way
from .strides import longest_stride, strides_from

SETTLING_STRIDES = 400
"""Strides of a runner that settles, at most."""
LOOK = 8
"""Strides between two looks at how near to its start a stride comes back."""
NEAR = 3e-3
"""Distance, over the scales, to which a stride has to return before Newton's method is tried."""


class Closing:
    """Equations of a gait: after some strides, the apex over the scales is the first one.

    With the map P^n of n strides and its Jacobian J, the residual is P^n(z) - z and its Jacobian J - I.
    """

    def __init__(
        self,
        runner: Runner,
        strides: int = 1,
        along: Along | None = None,
        scales: NDArray[np.float64] | None = None,
    ) -> None:
        """Close `strides` strides of a runner; `along` names what the gait is differentiated by, too.

        The scales are the runner's own, unless others are given.
        """
        refuse_patch(runner)
        check_has_gaits(runner)
        check_comes_down(runner)
        self.runner, self.strides, self.along = runner, strides, along
        self.scales = runner.scales if scales is None else scales
        self.until = longest_stride(runner)
        self.unsolved = ""
        """Why the solver gave up in the last stride; empty where it did not."""

    def residual(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """Last apex minus first, over the scales."""
        apex = x * self.scales
        for _ in range(self.strides):
            apex = self.stride(apex, False).next_points[0]
        residual: NDArray[np.float64] = apex / self.scales - x
        return residual

    def linearize(self, x: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The residual and its exact Jacobian."""
        residual, jacobian, _ = self.varied(x)
        return residual, jacobian

    def varied(
        self, x: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
        """The residual, its exact Jacobian, and its derivative along the parameter, which has no scale."""
        apex, jacobian, along = x * self.scales, np.eye(len(x)), np.zeros(len(x))
        for _ in range(self.strides):
            stride = self.stride(apex, True)
            by_apex, by_parameter = derivatives(self.runner, stride)
            apex, jacobian, along = stride.next_points[0], by_apex @ jacobian, by_apex @ along + by_parameter
        residual = apex / self.scales - x
        return residual, scaled_less_one(jacobian, self.scales), along / self.scales

    def stride(self, apex: NDArray[np.float64], varied: bool) -> Strides:
        """One stride from an apex; RunError where it does not close."""
        self.unsolved = ""
        stride = self.runner.stride(apex, self.until, varied=varied, along=self.along)
        if why_not := stride.why_not():
            self.unsolved = why_not if stride.outcome[0] == c.TDMF_RETURN_UNSOLVED else ""
            raise RunError(why_not)
        return stride

    def gait(self, apex: NDArray[np.float64], near: Gait | None = None) -> Gait:
        """The gait near an apex; the Jacobian of a gait that is near may save some strides."""
        jacobian = None if near is None else scaled_less_one(near.jacobian, self.scales)
        try:
            found = solve(self, apex / self.scales, jacobian=jacobian)
        except NotSolvedError as problem:
            raise self._not_found(
                f"Newton's method stopped after {counted(problem.last.iterations, 'iteration')} with the "
                f"next apex {problem.last.error:.2g} of its scales away"
            ) from None
        except RunError as problem:
            raise self._not_found(f"from the apex that was tried, {problem}") from None
        at = found.x * self.scales if found.iterations else apex
        gait = strides_from(self.runner, at, self.strides, along=self.along)
        return replace(gait, iterations=found.iterations, residual=np.zeros(len(at)))

    def settled(self, apex: NDArray[np.float64]) -> Gait:
        """The gait that a runner settles on from an apex.

        A stable gait that Newton's method finds on the way ends the search. An unstable one counts only where
        the runner has not settled after all strides.
        """
        made, look = 0, LOOK
        while True:
            look = min(look, SETTLING_STRIDES - made)
            before = self._settle(look - 1, apex, made)
            after = apex = self._settle(1, before, made + look - 1)
            made += look
            if made == SETTLING_STRIDES:
                return self.gait(after)
            if np.max(np.abs(after - before) / self.scales) < NEAR:
                with contextlib.suppress(RunError):
                    gait = self.gait(after)
                    if gait.stable:
                        return gait
                look *= 2

    def _settle(self, strides: int, apex: NDArray[np.float64], made: int) -> NDArray[np.float64]:
        """The last apex of some strides."""
        last, closed = self.runner.settle(apex, strides)
        if closed < strides:
            try:
                self.stride(last, False)
            except RunError as problem:
                raise self._not_found(f"{problem} after {counted(made + closed, 'stride')}") from None
        return last

    def _not_found(self, why: str) -> GaitNotFoundError:
        """Error that says why no gait was found, or that the solver gave up."""
        at = at_friction(self.runner)
        if not self.unsolved:
            kind = f" of {self.strides} strides" if self.strides > 1 else ""
            return GaitNotFoundError(f"no gait{kind}{at}: {why}")
        strides, steps, events = search_under_way().done()
        return GaitNotFoundError(
            f"the search for a gait{at} was given up: {self.unsolved}, after {counted(strides, 'stride')}, "
            f"{counted(steps, 'step')} and {counted(events, 'event')}"
        )


def scaled_less_one(jacobian: NDArray[np.float64], scales: NDArray[np.float64]) -> NDArray[np.float64]:
    """Jacobian of the residual, over the scales, from that of the strides."""
    return jacobian * scales / scales[:, None] - np.eye(len(scales))


@joins_search
def gait_near(
    runner: Runner, guess: Apex, strides: int = 1, *, along: Along | None = None, near: Gait | None = None
) -> Gait:
    """The gait near a guess that repeats itself after some strides, by Newton's method.

    The Jacobian of a gait that is near the one sought may save some strides.
    """
    return Closing(runner, strides, along).gait(checked_apex(guess, runner.coordinates), near)


@joins_search
def settled_gait(runner: Runner, *, along: Along | None = None) -> Gait:
    """The gait that a runner settles on from its start, at the end by Newton's method."""
    return Closing(runner, along=along).settled(runner.start_apex())
