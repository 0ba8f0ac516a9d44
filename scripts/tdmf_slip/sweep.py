"""Gaits over a range of friction, and the borders between gait words; over two parameters, a grid on file."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import xarray

from . import blocks, progress
from .borders import Border, crossings
from .continuation import gaits_over
from .errors import InputError, RunError, TdmfSlipError
from .family import Family
from .files import write_dataset
from .orbit import LOSSES, STRIDE_QUANTITIES, Orbit, Runner, check_has_gaits, find_orbit
from .resume import resumed
from .section import COORDINATES
from .unit import Unit, load

FRICTION = "ground.friction"
MOST_VALUES = 1_000_000
"""In a range, and in a grid."""
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
    """What stopped the sweep, or kept a border from being located; or None."""

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
    if not 1 <= number <= MOST_VALUES or not np.all(np.abs(ends) < 1e100):
        raise InputError(f"{where} {text}: allowed: finite A and B, and N from 1 to {MOST_VALUES}")
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
    It also says where a border could not be located; the sweep goes on then.

    Args:
        runner: parameters and start; its friction does not matter.
        frictions: values in order.
        show_progress: a bar on stderr.

    Raises:
        InputError: a value is refused.
        RunError: there is no gait at the first friction.
    """
    _check_frictions(runner, frictions)
    orbits: list[Orbit] = []
    borders: list[Border] = []
    problems: list[str] = []
    with progress.bar("sweep", len(frictions), "gaits", show_progress) as bar:
        first = first_orbit(runner.but(FRICTION, frictions[0]))
        try:
            before = first
            for orbit in gaits_over(runner, FRICTION, frictions, first):
                orbits.append(orbit)
                try:
                    for border, _ in crossings(Family(runner, FRICTION), before, orbit):
                        borders.append(border)
                except RunError as unlocated:
                    problems.append(str(unlocated))
                before = orbit
                bar.update()
        except RunError as lost:
            problems.append(str(lost))
    return Sweep(tuple(orbits), tuple(borders), "; ".join(problems) or None)


def _check_frictions(runner: Runner, frictions: Sequence[float]) -> None:
    """Refuse, before any work, frictions at which there is no gait to follow."""
    if not len(frictions):
        raise InputError("frictions: none; allowed: one or more")
    for friction in frictions:
        _ = runner.but(FRICTION, friction).inputs
        check_has_gaits(friction)


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
    if name == FRICTION:
        raise InputError(f"a grid over {FRICTION} and {name}: allowed: another parameter or input")
    if len(frictions) * len(values) > MOST_VALUES:
        raise InputError(
            f"a grid of {len(frictions)} by {len(values)} gaits: allowed: {MOST_VALUES:,} gaits at the most"
        )
    _check_frictions(runner, frictions)
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
    path = Path(path)
    data = resumed(path, blank, "sweep")
    missing = np.flatnonzero(data["done"].values == 0)
    rows = [Row(runner.but(name, values[number]), tuple(frictions)) for number in missing]
    with (
        progress.bar("sweep", len(values), "rows", show_progress) as bar,
        blocks.run(gaits_of_row, rows, scheduler=scheduler, workers=workers) as results,
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


@dataclass(frozen=True)
class Row:
    """A row of a grid: a block of work."""

    runner: Runner
    frictions: tuple[float, ...]


def gaits_of_row(row: Row) -> tuple[list[Orbit | None], str]:
    """The gait at each friction, None from where the branch cannot be followed; and why it cannot, or ""."""
    try:
        found = sweep(row.runner, row.frictions)
    except TdmfSlipError as problem:  # also start values that go with other rows only
        return [None] * len(row.frictions), str(problem)
    rest = [None] * (len(row.frictions) - len(found.orbits))
    return [*found.orbits, *rest], found.problem or ""
