"""Result of a run of the unit."""

import csv
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..files.whole import check_destination, write_whole
from ..record import dataset, origin_of
from ..variables import paper_units
from ..variables.table import Variables
from ..variables.variable import Value, Variable

if TYPE_CHECKING:
    import xarray

MODE, PHASE = "contact.mode", "hip.phase"
OFF_GROUND = {"flight", "graze"}
SLIPS = {"slip_positive", "slip_negative"}


@dataclass(frozen=True)
class Event:
    """One change of contact mode or hip phase."""

    time: float
    """s since the start of the run."""
    what: str
    """touchdown, slip_onset, slip_velocity_zero, liftoff, liftoff_into_graze, graze_end, midstance, apex."""


def events_of(table: NDArray[np.void], variables: Variables) -> list[Event]:
    """Events in order, from rows recorded before and after each.

    What begins and ends in zero time inside one event, such as an impact that leaves at once, is not seen:
    the unit's `event.count` counts that too.
    """
    modes, phases = variables[MODE].items, variables[PHASE].items
    changed = np.flatnonzero((np.diff(table[MODE]) != 0) | (np.diff(table[PHASE]) != 0))
    events = []
    for row in changed:
        before, after = table[row], table[row + 1]
        names = [
            _contact_event(modes[before[MODE]], modes[after[MODE]]),
            _phase_event(phases[before[PHASE]], phases[after[PHASE]]),
        ]
        events += [Event(float(after["time"]), name) for name in names if name]
    return events


def _contact_event(before: str, after: str) -> str | None:
    if before == after:
        return None
    if before == "graze":
        return "graze_end"
    if before == "flight":
        return "touchdown"
    if after in OFF_GROUND:
        return {"flight": "liftoff", "graze": "liftoff_into_graze"}[after]
    return "slip_velocity_zero" if before in SLIPS else "slip_onset"


def _phase_event(before: str, after: str) -> str | None:
    return {("drive", "coast"): "midstance", ("retract", "place"): "apex"}.get((before, after))


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
    model: str
    """Name of the runner's model."""
    start_values: Mapping[str, Value]
    """Every parameter, input and state at the start, by the unit's names."""
    final: Mapping[str, float | int | bool | str]
    """Every variable of the unit at the end of the run, also where the runner has fallen."""
    events: list[Event] = field(default_factory=list)
    """Contact and phase changes, in their order."""
    messages: list[str] = field(default_factory=list)
    """Messages of the unit."""

    @property
    def stride(self) -> dict[str, Any]:
        """The last completed stride: `count`, `period`, `word` and so on; zero and empty without one."""
        return self._latched("stride")

    @property
    def apex(self) -> dict[str, Any]:
        """The section at the last apex: `time`, `com_height` and so on."""
        return self._latched("apex")

    def _latched(self, group: str) -> dict[str, Any]:
        return {of.member: self.final[of.name] for of in self.variables.group(group)}

    def label(self, unit: str) -> str:
        """The label of a unit in texts and pictures of this run: `l0` for `m` in the paper's units."""
        return paper_units.label(unit, self.final)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the table's fields, `time` first."""
        return self.table.dtype.names or ()

    @property
    def record(self) -> dict[str, Any]:
        """Record for a file of the run: `version`, `model` and `start_values`."""
        origin = origin_of(version=self.version) | {"model": self.model}
        return {**origin, "start_values": dict(self.start_values)}

    @property
    def strides(self) -> int:
        """Number of completed strides."""
        return int(self.final["stride.count"])


def write_table(path: Path | str, run: Run) -> None:
    """A run's recorded rows as CSV (a header of names) or NetCDF (with units, flags and the run's end)."""
    path = check_destination(path, WRITERS, "output")
    write_whole(path, lambda beside: WRITERS[path.suffix.lower()](beside, run))


def _write_csv(path: Path, run: Run) -> None:
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(run.names)
        writer.writerows(run.table.tolist())


def _write_netcdf(path: Path, run: Run) -> None:
    from ..files.netcdf import netcdf_of  # slow to load, and seldom asked for

    path.write_bytes(netcdf_of(dataset_of(run)))


def dataset_of(run: Run) -> "xarray.Dataset":
    """A run's recorded rows over the time, with units, flags and the run's end."""
    variables: dict[str, Any] = {}
    for name in run.names:
        column = run.table[name]
        values = column.astype("i4") if column.dtype == bool else column  # NetCDF has no booleans
        variables[name] = "time", values, _attributes(run.variables[name]), {"zlib": True}
    events = np.array([event.time for event in run.events]), {"units": "s", "long_name": "time of the event"}
    variables["event_time"] = "event", *events
    labels = {"event": np.array([event.what for event in run.events], dtype=object)}
    latched = (*run.variables.group("stride"), *run.variables.group("apex"))
    attributes = {variable.name: run.final[variable.name] for variable in latched}
    attributes |= {} if run.fall_time is None else {"fall_time": run.fall_time}
    messages = "\n".join(run.messages)
    return dataset(
        "run", run.record, variables, labels, fallen=int(run.fallen), messages=messages, **attributes
    )


def _attributes(variable: Variable) -> dict[str, object]:
    """CF attributes of a variable."""
    attributes: dict[str, object] = {"long_name": variable.description}
    if variable.unit:
        attributes["units"] = variable.unit
    if variable.items:
        attributes["flag_values"] = np.array(list(variable.items), dtype="i4")
        attributes["flag_meanings"] = " ".join(variable.items.values())
    return attributes


WRITERS: Mapping[str, Callable[[Path, Run], None]] = {".csv": _write_csv, ".nc": _write_netcdf}
