"""Result of a run of the unit."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..checks import is_one_of, near_matches, shown
from ..errors import InputError
from ..record import origin_of
from ..variables import paper_units
from ..variables.table import Variables
from ..variables.variable import Value
from .events import Event

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True, eq=False, repr=False)
class Run:
    """Result of a run. All values are in the units of the model description, see `units`."""

    table: NDArray[np.void]
    """Recorded rows: structured array, fields `time` and variables' names; two rows at each event."""
    variables: Variables
    """Variables of the unit that was run, with units and meanings."""
    fallen: bool
    """The run ended in a fall."""
    fall_time: float | None
    """s; None where the runner has not fallen."""
    version: str
    """Version of the unit."""
    start_values: Mapping[str, Value]
    """Every parameter, input and state at the start, by the unit's names."""
    final: Mapping[str, float | int | bool | str]
    """Every variable of the unit at the end of the run, also where the runner has fallen."""
    events: list[Event] = field(default_factory=list)
    """Contact and phase changes, in their order."""
    messages: list[str] = field(default_factory=list)
    """Messages of the unit."""

    stride: Mapping[str, float | int | str] = field(default_factory=dict)
    """The last completed stride: `count`, `period`, `word` and so on; zero and empty without one."""
    apex: Mapping[str, float] = field(default_factory=dict)
    """The section at the last apex: `time`, `com_height` and so on."""

    def label(self, unit: str) -> str:
        """The label of a unit in texts and pictures of this run: `l0` for `m` in the paper's units."""
        return paper_units.label(unit, self.final)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the table's fields, `time` first."""
        return self.table.dtype.names or ()

    @property
    def units(self) -> Mapping[str, str]:
        """Unit of each field."""
        return {name: self.variables[name].unit for name in self.names}

    @property
    def record(self) -> dict[str, Any]:
        """Record for a file of the run: `version`, `model` and `start_values`."""
        return {**origin_of(version=self.version), "start_values": dict(self.start_values)}

    @property
    def strides(self) -> int:
        """How many were completed."""
        return int(self.final["stride.count"])

    def __getitem__(self, name: str) -> NDArray[Any]:
        """A column of the table, as in `run["com.x"]`."""
        if not is_one_of(name, self.names):
            raise InputError(f"{shown(name)} was not recorded{near_matches(name, self.names)}")
        return self.table[name]

    def __repr__(self) -> str:
        """In a line: how far it went, and the last stride."""
        time, speed = self.label("s"), self.label("m/s")
        end = (
            f"fell at {self.fall_time:.6g} {time}"
            if self.fallen
            else f"to {self.table['time'][-1]:.6g} {time}"
        )
        last = (
            f", word {self.stride['word']}, speed {self.stride['speed']:.6g} {speed}" if self.strides else ""
        )
        return f"<Run {end}, {self.strides} strides{last}>"

    def to_dataset(self) -> "xarray.Dataset":
        """The recorded rows with units, over the time; at an event there are two rows of the same time.

        Returns
        -------
        xarray.Dataset
            A variable for each column, over the coordinate `time`; as attributes version, model, start values
            and last stride.
        """
        from .tables import dataset_of  # xarray is slow to load

        return dataset_of(self)
