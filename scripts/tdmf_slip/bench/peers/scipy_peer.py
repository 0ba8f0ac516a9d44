"""The stride as one writes it by SciPy: solve_ivp with terminal events, a call for each mode."""

import math
from collections.abc import Sequence

import numpy as np
import scipy
from scipy.integrate import solve_ivp

from . import equations as eq
from . import sequence


class Peer:
    """DOP853, the method for tight tolerances."""

    name = f"scipy {scipy.__version__} DOP853"

    def __init__(self, tolerance: float) -> None:
        """At a relative tolerance; the absolute one is the same, in units of Table 1."""
        self._tolerance = tolerance
        self.evaluations = 0
        """Of the right-hand side so far."""

    def _run(self, name: str, state: Sequence[float], parameters: Sequence[float]) -> tuple[list[float], int]:
        mode = sequence.mode_of(name)

        def rates(_: float, now: np.ndarray) -> list[float]:
            now = now.tolist()
            torque = sequence.torque_of(name, now, parameters)
            return [
                *now[4:],
                *eq.accelerations(mode, now, torque, parameters[1], math.sin, math.cos),
            ]

        def guard(number: int) -> object:
            def value(_: float, now: np.ndarray) -> float:
                return sequence.guards_of(name, now.tolist(), parameters, math.sin, math.cos)[number]

            value.terminal, value.direction = True, -1.0
            return value

        count = len(sequence.guards_of(name, state, parameters, math.sin, math.cos))
        run = solve_ivp(
            rates,
            (0.0, sequence.LONGEST),
            np.array(state, dtype=float),
            method="DOP853",
            rtol=self._tolerance,
            atol=self._tolerance,
            events=[guard(number) for number in range(count)],
        )
        self.evaluations += run.nfev
        fired = next(number for number, times in enumerate(run.t_events) if len(times))
        return run.y[:, -1].tolist(), fired

    def stride(self, section: Sequence[float]) -> np.ndarray:
        """The apex after one stride from an apex."""
        return sequence.stride(section, self._run)
