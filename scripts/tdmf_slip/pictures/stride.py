"""One stride of a gait, normalised as in the paper, and cut into contact modes: what the pictures draw."""

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..fmu.events import MODE
from ..library.gait import Gait
from ..variables.table import VARIABLES, scale

POINTS = 6000
"""Recorded points in the stride; each event adds two."""


@dataclass(frozen=True)
class Interval:
    """A part of the stride in one contact mode."""

    mode: str
    """Name of the contact mode."""
    rows: slice
    """Rows of the stride in this mode."""


class Stride:
    """One stride from apex to apex, in units of l0, sqrt(m/k) and m. Angles in rad."""

    def __init__(self, gait: Gait) -> None:
        """Run the unit for one stride from the gait's apex."""
        from ..fmu.simulation import simulate  # FMPy loads only where the unit is run

        self.gait = gait
        run = simulate(gait, strides=1, output_interval=gait.period / POINTS)
        self.events = run.events
        self._table = run.table
        values = gait.runner
        self._length = values["leg.free_length"]
        self._mass = values["body.mass"]
        self._time = math.sqrt(self._mass / values["leg.stiffness"])

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        """A recorded variable, one value per row."""
        rows: NDArray[np.float64] = self._table[name]
        return rows / scale(VARIABLES[name].unit or "1", self._length, self._time, self._mass)

    @cached_property
    def time(self) -> NDArray[np.float64]:
        """Time since the apex."""
        return self["time"]

    @cached_property
    def modes(self) -> list[str]:
        """Contact mode of each row."""
        items = VARIABLES[MODE].items
        return [items[int(mode)] for mode in self._table[MODE]]

    @cached_property
    def intervals(self) -> list[Interval]:
        """The stride cut at every change of contact mode, in order; each has at least one row."""
        starts = [0, *(i for i in range(1, len(self.modes)) if self.modes[i] != self.modes[i - 1])]
        ends = [*starts[1:], len(self.modes)]
        return [Interval(self.modes[a], slice(a, b)) for a, b in zip(starts, ends, strict=True)]

    @cached_property
    def stance(self) -> slice:
        """Rows on the ground with force, from the first contact to the last."""
        contact = [p.rows for p in self.intervals if p.mode not in ("flight", "graze")]
        return slice(contact[0].start, contact[-1].stop)

    def times_of(self, what: str) -> list[float]:
        """Times of the events of one kind."""
        return [event.time / self._time for event in self.events if event.what == what]

    @cached_property
    def stance_times(self) -> tuple[float, float]:
        """First and last time of the stance."""
        return float(self.time[self.stance][0]), float(self.time[self.stance][-1])

    @property
    def impulse_ratio(self) -> float:
        """F_x / F_y of the impact at touchdown: the foot's change of velocity, horizontal over vertical."""
        after = self.stance.start
        change_x, change_y = (self[name][after] - self[name][after - 1] for name in ("foot.vx", "foot.vy"))
        return float(change_x / change_y)

    def at(self, name: str, time: float) -> float:
        """A variable at a time, interpolated between rows."""
        return float(np.interp(time, self.time, self[name]))

    def mode_at(self, time: float) -> str:
        """Contact mode at a time."""
        return self.modes[max(0, int(np.searchsorted(self.time, time, side="right")) - 1)]
