"""How FMPy follows inputs that change in time, made exact: its own way is good to one step of its solver.

FMPy's CVODE sets inputs where it looks for events, not where it evaluates the right-hand side, and at the
time of an event those of before it once more. In Co-Simulation FMPy holds inputs over a communication step;
their rates it can set, but takes those of before where the slope changes.
"""

import ctypes
import math

import fmpy.simulation
import fmpy.sundials
import numpy as np
from numpy.typing import NDArray

CLOCK_ROUNDING = 1e-12
"""Relative error of FMPy's times, which are sums."""


class Input(fmpy.simulation.Input):  # type: ignore[misc] # FMPy tells no types
    """FMPy's inputs; those of after an event from the time on at which it is taken."""

    taken = -math.inf

    def __init__(self, *given: object, set_input_derivatives: bool = False, **named: object) -> None:
        """As FMPy's; with derivatives, a communication step ends wherever an input's slope changes."""
        super().__init__(*given, **named)
        self.sets_rates = set_input_derivatives and self.t is not None
        if self.sets_rates:
            self.t_events: NDArray[np.float64] = np.unique([*self.t_events, *self.t])

    def apply(
        self, time: float, continuous: bool = True, discrete: bool = True, after_event: bool = False
    ) -> None:
        """As FMPy's, but an event stays taken."""
        if after_event:
            self.taken = time
        super().apply(time, continuous, discrete, after_event or time == self.taken)
        if self.sets_rates and continuous:
            self._set_rates(time)

    @classmethod
    def interpolate(cls, *given: object, **named: object) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """As FMPy's, but a table of one row, too, gives one value for each input."""
        values, rates = super().interpolate(*given, **named)
        return values.ravel(), rates.ravel()

    def _set_rates(self, time: float) -> None:
        for vrs, _, orders, _, table, _ in self.continuous:
            rates = (ctypes.c_double * len(vrs))(*self._rates(time, table))
            self.fmu.fmi2SetRealInputDerivatives(self.fmu.component, vrs, len(vrs), orders, rates)

    def _rates(self, time: float, table: NDArray[np.float64]) -> NDArray[np.float64]:
        """Slopes to the right of a time."""
        reached = time + CLOCK_ROUNDING * max(1.0, abs(time))
        after = int(np.searchsorted(self.t, reached, side="right"))
        if after in (0, len(self.t)):
            return np.zeros(len(table))
        slopes: NDArray[np.float64] = (table[:, after] - table[:, after - 1]) / (
            self.t[after] - self.t[after - 1]
        )
        return slopes


class Solver(fmpy.sundials.CVodeSolver):  # type: ignore[misc] # FMPy tells no types
    """FMPy's CVODE, with the inputs of the time at which it evaluates, but not beyond their next jump."""

    next_jump = math.inf

    def step(self, t: float, until: float) -> object:
        """As FMPy's."""
        self.next_jump = self.input.nextEvent(t)
        try:
            return super().step(t, until)
        except TypeError as problem:
            if self.error_info is None:  # FMPy formats CVODE's account of an error even where there is none
                raise RuntimeError("CVODE failed") from problem
            raise

    def f(self, t: float, y: object, ydot: object, user_data: object) -> object:
        """As FMPy's."""
        self.input.apply(min(t, self.next_jump), discrete=False)
        return super().f(t, y, ydot, user_data)


def follow_inputs() -> None:
    """Have FMPy run by these from now on."""
    fmpy.simulation.Input = Input
    fmpy.sundials.CVodeSolver = Solver
