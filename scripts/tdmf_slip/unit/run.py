"""What a run of the unit gave."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from .events import Event


@dataclass(frozen=True)
class Run:
    """What a run gave. All values are in the units of the model description, see `units`."""

    table: NDArray[np.void]
    """Recorded rows: structured array, fields `time` and variables' names; two rows at each event."""
    units: Mapping[str, str]
    """Unit of each field."""
    fallen: bool
    """The run ended in a fall."""
    fall_time: float | None
    """s; None where the runner has not fallen."""
    final: Mapping[str, float | int | bool | str]
    """Every variable of the unit at the end of the run, also where the runner has fallen."""
    events: list[Event] = field(default_factory=list)
    """Contact and phase changes, in their order."""
    messages: list[str] = field(default_factory=list)
    """What the unit had to say."""

    stride: Mapping[str, float | int | str] = field(default_factory=dict)
    """The last completed stride: `count`, `period`, `word` and so on; zero and empty without one."""
    apex: Mapping[str, float] = field(default_factory=dict)
    """The section at the last apex: `time`, `com_height` and so on."""

    @property
    def names(self) -> tuple[str, ...]:
        """Of the table's fields, `time` first."""
        return tuple(self.units)

    @property
    def strides(self) -> int:
        """How many were completed."""
        return int(self.final["stride.count"])
