"""How FMPy follows inputs that change in time, made exact: its own way is good to one step of its solver.

FMPy's CVODE sets inputs where it looks for events, not where it evaluates the right-hand side, and at the
time of an event those of before it once more. In Co-Simulation FMPy holds inputs over a communication step;
their rates it can set, but takes those of before where the slope changes.
"""

import ctypes
import functools
import importlib.util
import math
from collections.abc import Callable
from types import ModuleType

import fmpy.simulation
import numpy as np
from numpy.typing import NDArray

CLOCK_ROUNDING = 1e-12
"""Relative error of FMPy's times, which are sums."""


class Input(fmpy.simulation.Input):  # type: ignore[misc] # FMPy tells no types
    """FMPy's inputs, set together with the unit's clock. Once a jump is taken, the values after it hold."""

    taken = -math.inf
    next_jump = math.inf

    def __init__(self, *given: object, set_input_derivatives: bool = False, **named: object) -> None:
        """As FMPy's; with derivatives, a communication step ends wherever an input's slope changes."""
        super().__init__(*given, **named)
        self.sets_rates = set_input_derivatives and self.t is not None
        if self.sets_rates:
            self.t_events: NDArray[np.float64] = np.unique([*self.t_events, *self.t])
        if hasattr(self.fmu, "setTime"):  # Model Exchange
            self.fmu.setTime = functools.partial(self._set_time, self.fmu.setTime)

    def _set_time(self, set_time: Callable[[float], object], time: float) -> object:
        """Set the unit's clock, and the inputs of that time, but not beyond their next jump."""
        self.apply(min(time, self.next_jump), discrete=False)
        return set_time(time)

    def nextEvent(self, time: float) -> float:  # noqa: N802 # FMPy's name
        """As FMPy's, which asks before each step."""
        self.next_jump = super().nextEvent(time)
        return self.next_jump

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


@functools.cache
def simulation() -> ModuleType:
    """A private copy of FMPy's module that uses these inputs; the module that others import is unchanged."""
    spec = importlib.util.find_spec("fmpy.simulation")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    module.Input = Input  # type: ignore[attr-defined]
    return module
