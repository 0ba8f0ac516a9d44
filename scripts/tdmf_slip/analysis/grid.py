"""Gaits over two parameters: a grid on file, made row by row."""

import tempfile
from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..blocks import run_blocks
from ..errors import InputError, TdmfSlipError
from ..files.datasets import xarray
from ..files.netcdf import write_dataset
from ..files.resume import resumed, same_values
from ..files.whole import check_destination
from ..library.fixed_point import gait_near
from ..library.gait import Gait
from ..library.members import check_has_gaits, check_varied
from ..library.runner import Runner
from ..library.scales import rounding_of
from ..library.section import COORDINATES
from ..record import attributes_of
from ..terminal.progress import progress_bar
from ..variables.table import FRICTION, STATES, VARIABLES, by_full_name
from ..variables.variable import MAX_VALUES, Given, Values
from .gait_columns import COLUMNS
from .sweeps import check_values, sweep_row

GAITS_AGREE = 1e-6
"""To which part of the largest in a row the quantities of a gait on file have to be those of its stride."""


def as_dataset(
    gaits: Sequence[Gait | None], coordinates: Mapping[str, NDArray[np.float64]]
) -> xarray.Dataset:
    """Gaits on a grid, with units; NaN and an empty word where there is none."""
    shape = tuple(len(values) for values in coordinates.values())
    names = tuple(coordinates)
    data = xarray.Dataset(coords={name: ((name,), values) for name, values in coordinates.items()})
    for name, column in COLUMNS.items():
        values = [np.nan if gait is None else column.value_of(gait) for gait in gaits]
        data[name] = names, np.array(values, dtype=float).reshape(shape)
        data[name].attrs = column.attributes
    words = ["" if gait is None else gait.word for gait in gaits]
    data["word"] = names, np.array(words, dtype=object).reshape(shape)
    data["word"].attrs = VARIABLES["stride.word"].attributes
    for name in set(names) & set(VARIABLES):
        data[name].attrs = VARIABLES[name].attributes
    return data


def grid_over(
    runner: Runner, vary: Mapping[str, Values], path: Path | str | None, **where: Any
) -> xarray.Dataset:
    """`grid` in memory, by a file that is not kept where none is asked for."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "grid.nc" if path is None else path
        return grid(runner, vary, file, **where).load()


def grid(
    runner: Runner | Mapping[str, Given],
    vary: Mapping[str, Values],
    path: Path | str,
    *,
    executor: Executor | None = None,
    progress: bool = False,
) -> xarray.Dataset:
    """Gaits over two parameters, row by row, into a NetCDF file.

    The file is whole after each row. Called again with the same file, the sweep goes on with the rows that
    are missing; a file of another sweep is refused. What kept a row from its end is in
    the file's `problem`.
    """
    runner = Runner(runner)
    vary = by_full_name(vary, "vary", "values by the names of two parameters or inputs")
    name, along = _names(vary)
    coordinates = {of: VARIABLES.find(of, "vary").values_of(vary[of], f"vary {of}") for of in (name, along)}
    down, across = coordinates.values()
    if len(across) * len(down) > MAX_VALUES:
        raise InputError(
            f"a grid of {len(across)} by {len(down)} gaits: allowed: {MAX_VALUES:,} gaits at the most"
        )
    for value in down:
        row = runner.replace({name: value})
        check_has_gaits(row[FRICTION] if along != FRICTION else float(min(across)))
    check_values(runner.replace({name: down[0]}), along, across)
    blank = as_dataset([None] * (len(down) * len(across)), coordinates)
    blank["branch"] = (name, along), np.full((len(down), len(across)), np.nan)
    blank["branch"].attrs = {"long_name": "number of the branch in its row"}
    blank["done"] = (name,), np.zeros(len(down), dtype="i1")
    blank["problem"] = (name,), np.full(len(down), "", dtype=object)
    blank.attrs = {"title": "Periodic gaits", **attributes_of(runner.record(*coordinates))}
    path = check_destination(path, (".nc",), "path")
    data = resumed(path, blank, "sweep")
    _check_rows(path, data, blank, runner, progress)
    missing = np.flatnonzero(data["done"].values == 0)
    rows = [Row(runner.replace({name: down[number]}), along, tuple(across)) for number in missing]
    with (
        progress_bar("sweep", len(down), "rows", progress) as bar,
        run_blocks(gaits_of_row, rows, executor) as results,
    ):
        bar.update(len(down) - len(missing))
        for number, (gaits, branches, problem) in results:
            found = as_dataset(gaits, {along: coordinates[along]})
            for variable in found.data_vars:
                data[variable][missing[number]] = found[variable]
            data["branch"][missing[number]] = branches
            data["problem"][missing[number]] = problem
            data["done"][missing[number]] = 1
            write_dataset(path, data)
            bar.update()
    return data


def _names(vary: Mapping[str, Values]) -> tuple[str, str]:
    """What is varied from row to row, and along a row."""
    if len(vary) != 2:
        raise InputError(f"vary {', '.join(map(str, vary))}: allowed: the names of two parameters or inputs")
    names = list(vary)
    name, along = reversed(names) if names[0] == FRICTION else names
    if name not in STATES:
        check_varied(name, "vary")
    check_varied(along, "vary")
    return name, along


def _check_rows(
    path: Path,
    data: xarray.Dataset,
    blank: xarray.Dataset,
    runner: Runner,
    progress: bool,
) -> None:
    """Refuse rows that no sweep can have left: each gait has to close its stride as the file tells."""
    name, along = data["period"].dims
    begun = int(np.count_nonzero(data["done"].values))
    with progress_bar("what is done", begun, "rows", progress) as bar:
        for number, value in enumerate(data[name].values):
            row, nothing = data.isel({name: number}), blank.isel({name: number})
            if same_values(row, nothing):
                continue
            if not _may_be_row(row, runner.replace({str(name): value}), str(along)):
                raise InputError(
                    f"{path}: holds another sweep, with gaits at {name} = {value:g} that are none; "
                    "allowed: another file name"
                )
            bar.update()


def _may_be_row(row: xarray.Dataset, runner: Runner, along: str) -> bool:
    """Whether a row is done, what is in it are gaits, and it says why where some are missing."""
    found = row["period"].notnull().values
    if row["done"] != 1 or not (found.all() or row["problem"].item()):
        return False
    apices = np.stack([row[f"apex_{coordinate}"].values for coordinate in COORDINATES], axis=1)
    values = row[along].values
    try:
        gaits = [
            gait_near(runner.replace({along: value}), apex[: len(runner.coordinates)]) if there else None
            for value, apex, there in zip(values, apices, found, strict=True)
        ]
    except TdmfSlipError:
        return False
    if not np.array_equal(row["branch"].notnull().values, found):
        return False
    wanted = as_dataset(gaits, {along: values})
    rounding = {name: rounding_of(runner, wanted[name].attrs["units"]) for name in COLUMNS}
    return same_values(row, wanted, GAITS_AGREE, rounding)


@dataclass(frozen=True)
class Row:
    """A row of a grid: a block of work."""

    runner: Runner
    """Whose gaits."""
    along: str
    """What is varied."""
    values: tuple[float, ...]
    """At which."""


def gaits_of_row(row: Row) -> tuple[list[Gait | None], list[float], str]:
    """The gait at each value, None where it was not found; of which branch it is; and why none, or ""."""
    try:
        found = sweep_row(row.runner, row.along, row.values)
    except TdmfSlipError as problem:  # also start values that go with other rows only
        return [None] * len(row.values), [np.nan] * len(row.values), str(problem)
    return list(found.by_value), found.branches, found.problem or ""
