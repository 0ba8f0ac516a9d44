"""Gaits over a range of friction, and the borders between gait words; over two parameters, a grid on file."""

import contextlib
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import xarray

from . import blocks, progress
from .continuation import Border, borders_between, gaits_over
from .errors import InputError, RunError
from .files import whole
from .orbit import LOSSES, STRIDE_QUANTITIES, Orbit, Runner, find_orbit
from .section import COORDINATES
from .unit import Unit, load

FRICTION = "ground.friction"
SPACINGS = {"linear": np.linspace, "log": np.geomspace}
UNITS: Mapping[str, str] = {
    "lambda_max": "1",
    "damper_loss": "J",
    "friction_loss": "J",
    "impact_loss": "J",
}
"""Of what the unit has no variable for."""


@dataclass(frozen=True)
class Sweep:
    """Gaits at the values of a range, in its order, as far as the branch could be followed."""

    orbits: tuple[Orbit, ...]
    borders: tuple[Border, ...]
    problem: str | None
    """What stopped the sweep, or None."""

    def as_json(self) -> dict[str, object]:
        """The sweep as a plain object."""
        return {
            "gaits": [orbit.as_json() for orbit in self.orbits],
            "transitions": [border.as_json() for border in self.borders],
            "problem": self.problem,
        }


def values_of(text: str, spacing: str, where: str) -> np.ndarray:
    """The values that A:B:N stands for.

    Raises:
        InputError: it is not of that form, N is below 1, or the spacing cannot reach from A to B.
    """
    try:
        first, last, count = text.split(":")
        ends = float(first), float(last)
        number = int(count)
    except ValueError:
        raise InputError(f"{where} {text}: allowed: A:B:N, two numbers and how many values") from None
    if number < 1 or not np.all(np.isfinite(ends)):
        raise InputError(f"{where} {text}: allowed: finite A and B, and N of 1 or more")
    if spacing == "log" and min(ends) <= 0.0:
        raise InputError(f"{where} {text}: allowed with logarithmic spacing: A and B above 0")
    return SPACINGS[spacing](*ends, number)


def first_orbit(runner: Runner, unit: Unit | None = None) -> Orbit:
    """A gait of a runner: by settling from its start values, else along the friction from the unit's own.

    Raises:
        RunError: neither finds one.
    """
    try:
        return find_orbit(runner, along=FRICTION)
    except RunError as problem:
        unit = load() if unit is None else unit
        home = unit.start_of(FRICTION)
        if runner.values[FRICTION] == home:
            raise
        try:
            start = find_orbit(runner.but(FRICTION, home), along=FRICTION)
            return next(gaits_over(runner, FRICTION, [runner.values[FRICTION]], start))
        except RunError:
            raise problem from None


def sweep(runner: Runner, frictions: Sequence[float], *, show_progress: bool = False) -> Sweep:
    """The gait at each friction, each from the one before, and every change of the gait word between.

    A branch that cannot be followed ends the sweep: what was found is kept, and `problem` says what happened.

    Args:
        runner: parameters and start; its friction does not matter.
        frictions: values in order.
        show_progress: a bar on stderr.

    Raises:
        InputError: a value is refused.
        RunError: there is no gait at the first friction.
    """
    for friction in frictions:
        _ = runner.but(FRICTION, friction).inputs
    orbits: list[Orbit] = []
    borders: list[Border] = []
    problem = None
    with progress.bar("sweep", len(frictions), "gaits", show_progress) as bar:
        first = first_orbit(runner.but(FRICTION, frictions[0]))
        try:
            for orbit in gaits_over(runner, FRICTION, frictions, first):
                if orbits and orbit.word != orbits[-1].word:
                    borders += borders_between(runner, FRICTION, orbits[-1], orbit)
                orbits.append(orbit)
                bar.update()
        except RunError as found:
            problem = str(found)
    return Sweep(tuple(orbits), tuple(borders), problem)


def as_dataset(
    orbits: Sequence[Orbit | None], coordinates: Mapping[str, np.ndarray], unit: Unit
) -> xarray.Dataset:
    """Gaits on a grid, with units; NaN and an empty word where there is none.

    Args:
        orbits: as many as the grid has points, the last coordinate fastest.
        coordinates: values of one or two parameters, by name.
        unit: for units and descriptions.
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
    runner: Runner,
    frictions: Sequence[float],
    name: str,
    values: Sequence[float],
    path: Path,
    *,
    scheduler: str | None = None,
    workers: int | None = None,
    show_progress: bool = False,
    unit: Unit | None = None,
) -> xarray.Dataset:
    """Gaits over the friction and a second parameter, row by row, into a NetCDF file.

    The file is whole after each row. Called again with the same file, the sweep goes on with the rows that
    are missing; a file of another sweep is refused.

    Args:
        runner: the other parameters and the start.
        frictions: values along a row.
        name: the second parameter or input.
        values: one for each row.
        path: of the NetCDF file.
        scheduler: of a Dask cluster, see `blocks.run`. The result does not depend on who computes it.
        workers: processes on this machine, by default one for each processor.
        show_progress: a bar on stderr.
        unit: for units and descriptions.

    Raises:
        InputError: a value is refused, or the file holds another sweep.
    """
    unit = load() if unit is None else unit
    coordinates = {name: np.asarray(values, dtype=float), FRICTION: np.asarray(frictions, dtype=float)}
    for value in values:
        _ = runner.but(name, value).model
    attributes = {"title": "Periodic gaits", "source": f"tdmf-slip {unit.version}"} | {
        n: v for n, v in runner.values.items() if n not in coordinates
    }
    data = _resumed(path, coordinates, attributes)
    if data is None:
        data = as_dataset([None] * (len(values) * len(frictions)), coordinates, unit)
        data["done"] = (name,), np.zeros(len(values), dtype="i1")
        data.attrs = attributes
    missing = np.flatnonzero(data["done"].values == 0)
    rows = [Row(runner.but(name, values[number]), tuple(frictions)) for number in missing]
    with progress.bar("sweep", len(values), "rows", show_progress) as bar:
        bar.update(len(values) - len(missing))
        for number, orbits in blocks.run(gaits_of_row, rows, scheduler=scheduler, workers=workers):
            found = as_dataset(orbits, {FRICTION: coordinates[FRICTION]}, unit)
            for variable in found.data_vars:
                data[variable][missing[number]] = found[variable]
            data["done"][missing[number]] = 1
            with whole(path) as beside:
                data.to_netcdf(beside)
            bar.update()
    return data


@dataclass(frozen=True)
class Row:
    """A row of a grid: a block of work."""

    runner: Runner
    frictions: tuple[float, ...]


def gaits_of_row(row: Row) -> list[Orbit | None]:
    """The gait at each friction; None from where the branch cannot be followed."""
    found: tuple[Orbit, ...] = ()
    with contextlib.suppress(RunError):  # no gait at the first friction: none in this row
        found = sweep(row.runner, row.frictions).orbits
    return [*found, *[None] * (len(row.frictions) - len(found))]


def _resumed(
    path: Path, coordinates: Mapping[str, np.ndarray], attributes: Mapping[str, object]
) -> xarray.Dataset | None:
    if not path.exists():
        return None
    try:
        data = xarray.load_dataset(path)
    except (OSError, ValueError) as problem:
        raise InputError(
            f"{path}: not a sweep to go on with ({problem}); allowed: another file name"
        ) from None
    same = "done" in data and all(
        n in data.coords and np.array_equal(data.coords[n].values, values)
        for n, values in coordinates.items()
    )
    differing = [n for n, v in attributes.items() if same and data.attrs.get(n) != v]
    if not same or differing:
        what = f"other values of {json.dumps(differing[:3])}" if differing else "other ranges"
        raise InputError(f"{path}: holds another sweep, with {what}; allowed: another file name")
    return data
