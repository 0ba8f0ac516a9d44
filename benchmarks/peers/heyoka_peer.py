"""The stride by heyoka: a Taylor integrator for each mode, with its events, compiled, not in compact mode."""

import time
from collections.abc import Sequence
from typing import Any

import heyoka as hy
import numpy as np
from numpy.typing import NDArray
from tdmf_slip.library.section import Apex

from . import equations as eq
from . import sequence


def _system(name: str) -> tuple[list[Any], list[Any]]:
    """Equations of motion and guards of a mode."""
    state, count = hy.make_vars(*eq.names_of(name)), eq.MOVING[name]
    parameters = [hy.par[i] for i in range(len(eq.PARAMETERS))]
    rates, guards = (
        eq.values_of(eq.written(law, name, hy), size, state, parameters)
        for law, size in ((eq.rates, count), (eq.guards, len(eq.EVENTS[name])))
    )
    return list(zip(state[:count], [x + hy.expression(0.0) for x in rates], strict=True)), guards


class Peer:
    """Integrators of all modes at one tolerance, for one runner."""

    name = f"heyoka {hy.__version__}"

    def __init__(self, tolerance: float, swing_clamp: bool) -> None:
        """Compile the integrators of the modes."""
        self._swing_clamp = swing_clamp
        self.seconds = 0.0
        """Seconds spent in integrators so far."""
        self.evaluations: int | None = None
        """Unknown: heyoka does not count evaluations."""
        self._integrators: dict[str, Any] = {}
        for name in sequence.modes_of(swing_clamp):
            system, guards = _system(name)
            events = [hy.t_event(guard, direction=hy.event_direction.negative) for guard in guards]
            start = [0.1] * len(system)
            self._integrators[name] = hy.taylor_adaptive(
                system, start, t_events=events, tol=tolerance, compact_mode=False
            )

    def _run(self, name: str, state: Sequence[float], parameters: Sequence[float]) -> tuple[list[float], int]:
        """The state at the first event of a mode, and which it was."""
        integrator, moving = self._integrators[name], eq.MOVING[name]
        integrator.time = 0.0
        integrator.state[:] = state[:moving]
        integrator.pars[:] = parameters[: len(integrator.pars)]
        integrator.reset_cooldowns()
        begin = time.perf_counter()
        outcome = int(integrator.propagate_until(sequence.LONGEST)[0])
        self.seconds += time.perf_counter() - begin
        return [*integrator.state, *state[moving:]], -outcome - 1

    def stride(self, section: Apex) -> NDArray[np.float64]:
        """The apex after one stride from an apex."""
        return sequence.stride(list(section), self._run, self._swing_clamp)


class BatchPeer:
    """The same for several runners at once, as many as heyoka recommends for this processor."""

    name = f"heyoka {hy.__version__} in batches"
    lanes = hy.recommended_simd_size()

    def __init__(self, tolerance: float, swing_clamp: bool) -> None:
        """Compile the integrators of the modes."""
        self._swing_clamp = swing_clamp
        self.seconds = 0.0
        """Seconds spent in integrators so far."""
        self.evaluations: int | None = None
        """Unknown: heyoka does not count evaluations."""
        self._integrators: dict[str, Any] = {}
        for name in sequence.modes_of(swing_clamp):
            system, guards = _system(name)
            events = [hy.t_event_batch(guard, direction=hy.event_direction.negative) for guard in guards]
            start = np.full((len(system), self.lanes), 0.1)
            self._integrators[name] = hy.taylor_adaptive_batch(
                system, start, t_events=events, tol=tolerance, compact_mode=False
            )

    def _run(
        self, name: str, state: Sequence[Any], parameters: Sequence[Any]
    ) -> tuple[list[Any], NDArray[np.int64]]:
        """States at each runner's first event of a mode, and which it was."""
        integrator, moving = self._integrators[name], eq.MOVING[name]
        integrator.set_time([0.0] * self.lanes)
        for row in range(moving):
            integrator.state[row] = state[row]
        for row in range(len(integrator.pars)):
            integrator.pars[row] = parameters[row]
        integrator.reset_cooldowns()
        guards = np.full(self.lanes, -1)
        while (guards < 0).any():
            # A propagation stops at the first event of any runner; those that have had theirs stay.
            targets = np.where(guards < 0, sequence.LONGEST, integrator.time)
            begin = time.perf_counter()
            integrator.propagate_until(list(targets))
            self.seconds += time.perf_counter() - begin
            outcomes = np.array([int(result[0]) for result in integrator.propagate_res])
            stopped = (guards < 0) & (outcomes < 0) & (outcomes >= -eq.MOST_GUARDS)
            guards[stopped] = -outcomes[stopped] - 1
        return [*integrator.state.copy(), *state[moving:]], guards

    def strides(self, sections: NDArray[np.float64]) -> NDArray[np.float64]:
        """The apices after one stride, one to a row; as many as there are lanes."""
        return sequence.stride(list(sections.T), self._run, self._swing_clamp).T
