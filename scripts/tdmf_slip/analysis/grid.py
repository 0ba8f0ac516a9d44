"""Gaits over the friction and a second parameter: a grid on file, made row by row."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import xarray

from ..blocks.running import run_blocks
from ..errors import InputError, TdmfSlipError
from ..files.netcdf import write_dataset
from ..files.resume import resumed, same_values
from ..files.whole import check_place
from ..library.orbit import LOSSES, STRIDE_QUANTITIES, Orbit, find_orbit
from ..library.runner import STATES, Runner, check_varied
from ..terminal import progress
from ..unit.section import COORDINATES
from ..unit.unit import FRICTION, Unit, load
from .sweep import MOST_VALUES, check_frictions, sweep_row

GAITS_AGREE = 1e-6
"""To which part of the largest in a row the quantities of a gait on file have to be those of its stride."""
UNITS: Mapping[str, str] = {
    "lambda_max": "1",
    "damper_loss": "J",
    "friction_loss": "J",
    "impact_loss": "J",
}
"""Of what the unit has no variable for."""


def as_dataset(
    orbits: Sequence[Orbit | None], coordinates: Mapping[str, np.ndarray], unit: Unit
) -> xarray.Dataset:
    """Gaits on a grid, with units; NaN and an empty word where there is none.

    Parameters
    ----------
    orbits : Sequence[Orbit | None]
        As many as the grid has points, the last coordinate fastest.
    coordinates : Mapping[str, ndarray]
        Values of one or two parameters, by name.
    unit : Unit
        For units and descriptions.
    """
    shape = tuple(len(values) for values in coordinates.values())
    names = tuple(coordinates)

    def field(value_of: object) -> tuple[tuple[str, ...], np.ndarray]:
        values = [np.nan if orbit is None else value_of(orbit) for orbit in orbits]
        return names, np.array(values, dtype=float).reshape(shape)

    data = xarray.Dataset(coords={name: ((name,), values) for name, values in coordinates.items()})
    for name in (*STRIDE_QUANTITIES, *LOSSES):
        data[name] = field(lambda orbit, name=name: orbit.stride[name])
    for index, name in enumerate(COORDINATES):
        data[f"apex_{name}"] = field(lambda orbit, index=index: orbit.apex[index])
    data["lambda_max"] = field(lambda orbit: abs(orbit.eigenvalues[0]))
    words = ["" if orbit is None else orbit.word for orbit in orbits]
    data["word"] = names, np.array(words, dtype=object).reshape(shape)
    for name in data.variables:
        candidates = (name, f"stride.{name}", name.replace("apex_", "apex."))
        described = next((n for n in candidates if n in unit.variables), None)
        if described is not None:
            variable = unit.variables[described]
            data[name].attrs = {"units": variable.unit or "1", "long_name": variable.description}
        elif name in UNITS:
            data[name].attrs = {"units": UNITS[name]}
    return data


def grid(
    runner: Runner | Mapping[str, object],
    frictions: Sequence[float],
    name: str,
    values: Sequence[float | str],
    path: Path | str,
    *,
    scheduler: str | None = None,
    workers: int | None = None,
    show_progress: bool = False,
    unit: Unit | None = None,
) -> xarray.Dataset:
    """Gaits over the friction and a second parameter, row by row, into a NetCDF file.

    The file is whole after each row. Called again with the same file, the sweep goes on with the rows that
    are missing; a file of another sweep is refused. What kept a row from its end is in
    the file's `problem`.

    Parameters
    ----------
    runner : Runner or mapping of str to object
        The other parameters and the start, or start values by name.
    frictions : Sequence[float]
        Values along a row.
    name : str
        The second parameter or input, or a state that the search for gaits starts with.
    values : Sequence[float | str]
        One for each row.
    path : Path or str
        Of the NetCDF file.
    scheduler : str, optional
        Of a Dask cluster, see `run_blocks`. The result does not depend on who computes it.
    workers : int, optional
        Processes on this machine, by default one for each processor.
    show_progress : bool, default False
        A bar on stderr.
    unit : Unit, optional
        For units and descriptions.

    Raises
    ------
    InputError
        A value is refused, or the file holds another sweep.
    """
    unit, runner = load(unit), Runner.of(runner)
    if name not in STATES:
        check_varied(name, "name")
    if name == FRICTION:
        raise InputError(f"a grid over {FRICTION} and {name}: allowed: another parameter or input")
    coordinates = {
        name: unit.find(name, "values").values_of(values, "values"),
        FRICTION: unit.find(FRICTION, "frictions").values_of(frictions, "frictions"),
    }
    values, frictions = coordinates.values()
    if len(frictions) * len(values) > MOST_VALUES:
        raise InputError(
            f"a grid of {len(frictions)} by {len(values)} gaits: allowed: {MOST_VALUES:,} gaits at the most"
        )
    check_frictions(runner, frictions)
    for value in values:
        row = runner.but(name, value)
        _ = row.model, row.inputs
    attributes = {"title": "Periodic gaits", "source": f"tdmf-slip {unit.version}"} | {
        n: v for n, v in runner.values.items() if n not in coordinates
    }
    blank = as_dataset([None] * (len(values) * len(frictions)), coordinates, unit)
    blank["done"] = (name,), np.zeros(len(values), dtype="i1")
    blank["problem"] = (name,), np.full(len(values), "", dtype=object)
    blank.attrs = attributes
    path = check_place(path, (".nc",), "path")
    data = resumed(path, blank, "sweep")
    _check_rows(path, data, blank, runner, name, unit, show_progress)
    missing = np.flatnonzero(data["done"].values == 0)
    rows = [Row(runner.but(name, values[number]), tuple(frictions)) for number in missing]
    with (
        progress.bar("sweep", len(values), "rows", show_progress) as bar,
        run_blocks(gaits_of_row, rows, scheduler=scheduler, workers=workers) as results,
    ):
        bar.update(len(values) - len(missing))
        for number, (orbits, problem) in results:
            found = as_dataset(orbits, {FRICTION: coordinates[FRICTION]}, unit)
            for variable in found.data_vars:
                data[variable][missing[number]] = found[variable]
            data["problem"][missing[number]] = problem
            data["done"][missing[number]] = 1
            write_dataset(path, data)
            bar.update()
    return data


def _check_rows(
    path: Path,
    data: xarray.Dataset,
    blank: xarray.Dataset,
    runner: Runner,
    name: str,
    unit: Unit,
    show_progress: bool,
) -> None:
    """Refuse rows that no sweep can have left: each gait has to close its stride as the file tells.

    Raises
    ------
    InputError
        The first such row.
    """
    begun = int(np.count_nonzero(data["done"].values))
    with progress.bar("what is done", begun, "rows", show_progress) as bar:
        for number, value in enumerate(data[name].values):
            row, nothing = data.isel({name: number}), blank.isel({name: number})
            if same_values(row, nothing):
                continue
            if not _may_be_row(row, runner.but(name, value), unit):
                raise InputError(
                    f"{path}: holds another sweep, with gaits at {name} = {value:g} that are none; "
                    "allowed: another file name"
                )
            bar.update()


def _may_be_row(row: xarray.Dataset, runner: Runner, unit: Unit) -> bool:
    """Whether a row is done, what is in it are gaits, and it says why where some are missing."""
    found = row["period"].notnull().values
    if row["done"] != 1 or not (found.all() or row["problem"].item()):
        return False
    apices = np.stack([row[f"apex_{coordinate}"].values for coordinate in COORDINATES], axis=1)
    frictions = row[FRICTION].values
    try:
        orbits = [
            find_orbit(runner.but(FRICTION, friction), apex) if there else None
            for friction, apex, there in zip(frictions, apices, found, strict=True)
        ]
    except TdmfSlipError:
        return False
    return same_values(row, as_dataset(orbits, {FRICTION: frictions}, unit), GAITS_AGREE)


@dataclass(frozen=True)
class Row:
    """A row of a grid: a block of work."""

    runner: Runner
    frictions: tuple[float, ...]


def gaits_of_row(row: Row) -> tuple[list[Orbit | None], str]:
    """The gait at each friction, None where it was not found; and why not, or ""."""
    try:
        found = sweep_row(row.runner, row.frictions)
    except TdmfSlipError as problem:  # also start values that go with other rows only
        return [None] * len(row.frictions), str(problem)
    return list(found.gaits), found.problem or ""
