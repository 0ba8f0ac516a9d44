"""A run's recorded rows on file: CSV, or NetCDF with units, flags and the run's end."""

import csv
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..files.whole import check_destination, write_whole
from ..record import dataset
from ..variables.variable import Variable
from .run import Run

if TYPE_CHECKING:
    import xarray


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
    variables = {}
    for name in run.names:
        column = run.table[name]
        values = column.astype("i4") if column.dtype == bool else column  # NetCDF has no booleans
        variables[name] = "time", values, _attributes(run.variables[name]), {"zlib": True}
    stride = {variable.name: run.final[variable.name] for variable in run.variables.group("stride")}
    return dataset("run", run.record, variables, {}, fallen=int(run.fallen), **stride)


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
