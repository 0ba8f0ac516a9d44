"""Events of a run, told from the recorded contact mode and hip phase."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..variables.table import Variables

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


def as_json(events: list[Event]) -> list[Mapping[str, object]]:
    """Events as plain objects."""
    return [{"time": event.time, "what": event.what} for event in events]
