"""Record of a saved result: the version that computed it, the model, and all values of its runner.

JSON has them as `version`, `model` and `runner`; a result from which a run can begin has `start_values`
instead of `runner`, and a proof has its exact `parameters`. A NetCDF file has each value as an attribute.
"""

from collections.abc import Mapping
from typing import Any

from .version import __version__

RUNNERS = ("runner", "start_values")
"""Entries that hold a runner's values, by the unit's names."""
NAMES = ("version", "model", *RUNNERS)
"""Entries of a record."""


def origin_of(*, reduced: bool = False, version: str = __version__) -> dict[str, str]:
    """The version and the model, for a result that records its runners in other entries."""
    return {"version": version, "model": "reduced" if reduced else "full"}


def record_of(runner: Any, *varied: str) -> dict[str, Any]:
    """Record of a runner: `version`, `model` and `runner`, without the values that vary in the result."""
    kept = {name: value for name, value in runner.items() if name not in varied}
    return {**origin_of(reduced=runner.reduced), "runner": kept}


def attributes_of(record: Mapping[str, Any]) -> dict[str, float | int | str]:
    """The record of a plain object as NetCDF attributes. Booleans become integers: NetCDF has none."""
    entries = {name: record[name] for name in ("version", "model") if name in record}
    for name in RUNNERS:
        entries |= record.get(name, {})
    return {name: int(value) if isinstance(value, bool) else value for name, value in entries.items()}


def without_record(plain: Mapping[str, Any]) -> dict[str, Any]:
    """A plain object without its record."""
    return {name: value for name, value in plain.items() if name not in NAMES}
