"""Record of a saved result: the version that computed it, the model, and all values of its runner.

JSON has them as `version`, `model` and `runner`; a result from which a run can begin has `start_values`
instead of `runner`, and a proof has its exact `parameters`. A NetCDF file has each value as an attribute.
"""

import json
import warnings
from collections.abc import Mapping
from typing import Any, Protocol

from .errors import Note
from .version import __version__

RUNNERS = ("runner", "start_values")
"""Entries that hold a runner's values, by the unit's names."""
NAMES = ("version", "model", *RUNNERS)
"""Entries of a record."""

EARLIER: Mapping[str, float | bool] = {"hip.swing_clamp": True}
"""Parameters that earlier files do not record, with the values that those results were computed with."""


def origin_of(*, reduced: bool = False, version: str = __version__) -> dict[str, str]:
    """The version and the model, for a result that records its runners in other entries."""
    return {"version": version, "model": "reduced" if reduced else "full"}


class HasRunnerValues(Protocol):
    """A runner: its values and its model."""

    @property
    def values(self) -> Mapping[str, float]:
        """Values by the unit's names."""

    @property
    def reduced(self) -> bool:
        """Whether its model is the reduced map."""


def record_of(runner: HasRunnerValues, *varied: str) -> dict[str, Any]:
    """Record of a runner: `version`, `model` and `runner`, without the values that vary in the result."""
    kept = {name: value for name, value in runner.values.items() if name not in varied}
    return {**origin_of(reduced=runner.reduced), "runner": kept}


def attributes_of(record: Mapping[str, Any]) -> dict[str, float | int | str]:
    """The record of a plain object as NetCDF attributes. Booleans become integers: NetCDF has none."""
    entries = {name: record[name] for name in ("version", "model") if name in record}
    for name in RUNNERS:
        entries |= record.get(name, {})
    return {name: int(value) if isinstance(value, bool) else value for name, value in entries.items()}


def completed(values: Mapping[str, Any]) -> dict[str, Any]:
    """A runner's values from a file, completed by the parameters that earlier files do not record."""
    return {**EARLIER, **values}


def note_missing(values: Mapping[str, Any], where: str) -> None:
    """Warn of parameters that an earlier file does not record, and name the values assumed for them."""
    missing = {name: value for name, value in EARLIER.items() if name not in values}
    if missing:
        read_as = ", ".join(f"{name} = {json.dumps(value)}" for name, value in missing.items())
        warnings.warn(
            f"{where}: does not record {', '.join(missing)}; read as with {read_as}", Note, stacklevel=2
        )


def completed_attributes(attributes: Mapping[str, Any]) -> dict[str, Any]:
    """The attributes of a NetCDF file, completed by those that earlier files do not record."""
    own = dict(attributes)
    of_runner = json.loads(own.pop("runner", "{}")) | own  # earlier files have the runner as one JSON text
    return {**origin_of(), **attributes_of({"runner": completed(of_runner)})}


def without_record(plain: Mapping[str, Any]) -> dict[str, Any]:
    """A plain object without its record."""
    return {name: value for name, value in plain.items() if name not in NAMES}
