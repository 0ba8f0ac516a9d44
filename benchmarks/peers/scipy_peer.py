"""The stride as one writes it by SciPy: solve_ivp with terminal events, a call for each mode."""

import math
from typing import Any

import numpy as np
import scipy
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from tdmf_slip.library.section import Apex

from . import equations as eq
from . import sequence
from .equations import State

RATES, GUARDS = ({name: eq.written(law, name, math) for name in eq.MODES} for law in (eq.rates, eq.guards))


class Peer:
    """DOP853, the method for tight tolerances."""

    name = f"scipy {scipy.__version__} DOP853"

    def __init__(self, tolerance: float, swing_clamp: bool) -> None:
        """Set the relative tolerance, which is also the absolute one in units of Table 1."""
        self._tolerance, self._swing_clamp = tolerance, swing_clamp
        self.seconds = 0.0
        self.evaluations: int | None = 0
        """Evaluations of the right-hand side so far."""

    def _run(self, name: str, state: State, parameters: State) -> tuple[list[float], int]:
        count, guards = len(state), len(eq.EVENTS[name])

        def rates(_: float, now: NDArray[np.float64]) -> list[float]:
            return eq.values_of(RATES[name], count, now.tolist(), parameters)

        def guard(number: int) -> Any:
            def value(_: float, now: NDArray[np.float64]) -> Any:
                return eq.values_of(GUARDS[name], guards, now.tolist(), parameters)[number]

            event: Any = value
            event.terminal, event.direction = True, -1.0
            return event

        run = solve_ivp(
            rates,
            (0.0, sequence.LONGEST),
            np.array(state, dtype=float),
            method="DOP853",
            rtol=self._tolerance,
            atol=self._tolerance,
            events=[guard(number) for number in range(guards)],
        )
        self.evaluations = (self.evaluations or 0) + int(run.nfev)
        fired = next(number for number, times in enumerate(run.t_events) if len(times))
        return run.y[:, -1].tolist(), fired

    def stride(self, section: Apex) -> NDArray[np.float64]:
        """The apex after one stride from an apex."""
        return sequence.stride(list(section), self._run, self._swing_clamp)
