"""Gaits over a range of friction, and the borders between gait words; over two parameters, a grid on file."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np
import xarray
from tqdm import tqdm

from . import blocks, progress
from .borders import Border, crossings
from .continuation import gaits_over
from .errors import InputError, RunError, TdmfSlipError
from .family import Family
from .files import check_place, write_dataset
from .orbit import (
    LOSSES,
    STATES,
    STRIDE_QUANTITIES,
    Orbit,
    Runner,
    check_has_gaits,
    check_varied,
    find_orbit,
)
from .ranges import MOST_VALUES
from .resume import resumed, same_values
from .section import COORDINATES
from .unit import Unit, load

FRICTION = "ground.friction"
MOST_GAITS = 100_000
"""Of a sweep that is on no file: each takes 10 kB."""
GAITS_AGREE = 1e-6
"""To which part of the largest in a row the quantities of a gait on file have to be those of its stride."""
UNITS: Mapping[str, str] = {
    "lambda_max": "1",
    "damper_loss": "J",
    "friction_loss": "J",
    "impact_loss": "J",
}
"""Of what the unit has no variable for."""


@dataclass(frozen=True)
class Sweep:
    """Gaits at the values of a range, where they were found."""

    frictions: tuple[float, ...]
    """The range."""
    gaits: tuple[Orbit | None, ...]
    """At each friction; None where there is none, or it was not found."""
    borders: tuple[Border, ...]
    problem: str | None
    """Why gaits are missing, and what kept a border from being located; or None."""

    @property
    def orbits(self) -> tuple[Orbit, ...]:
        """The gaits that were found, in the order of the range."""
        return tuple(gait for gait in self.gaits if gait is not None)

    def as_json(self) -> dict[str, object]:
        """The sweep as a plain object; `missing` are the frictions without a gait."""
        found = zip(self.frictions, self.gaits, strict=True)
        return {
            "gaits": [orbit.as_json() for orbit in self.orbits],
            "transitions": [border.as_json() for border in self.borders],
            "missing": [friction for friction, gait in found if gait is None],
            "problem": self.problem,
        }


def first_orbit(runner: Runner | Mapping[str, object], unit: Unit | None = None) -> Orbit:
    """A gait of a runner: by settling from its start values, else along the friction from the unit's own.

    Raises:
        RunError: neither finds one.
    """
    runner = Runner.of(runner)
    try:
        return find_orbit(runner, along=FRICTION)
    except RunError as problem:
        unit = load(unit)
        home = unit.start_of(FRICTION)
        if runner.values[FRICTION] == home:
            raise
        try:
            start = find_orbit(runner.but(FRICTION, home), along=FRICTION)
            return next(gaits_over(runner, FRICTION, [runner.values[FRICTION]], start))
        except RunError:
            raise problem from None


def sweep(
    runner: Runner | Mapping[str, object], frictions: Sequence[float], *, show_progress: bool = False
) -> Sweep:
    """The gait at each friction, each from the one before, and every change of the gait word between.

    Where the first frictions have no gait, the sweep begins at the first that has one, and follows its branch
    back as far as it goes; where a branch cannot be followed on, the sweep goes on with the next gait that is
    found. `problem` says what happened. Changes of the word from one branch to another are no borders.

    Args:
        runner: parameters and start, or start values by name; its friction does not matter.
        frictions: values in order.
        show_progress: a bar on stderr.

    Raises:
        InputError: a value is refused.
        RunError: there is no gait at any of them; the message tells of the first.
    """
    runner = Runner.of(runner)
    frictions = load().find(FRICTION, "frictions").values_of(frictions, "frictions")
    if len(frictions) > MOST_GAITS:
        raise InputError(
            f"{len(frictions):,} frictions: allowed: {MOST_GAITS:,}, or a grid, which is on file"
        )
    _check_frictions(runner, frictions)
    return _sweep(runner, frictions, show_progress)


def _sweep(runner: Runner, frictions: Sequence[float], show_progress: bool = False) -> Sweep:
    gaits: list[Orbit | None] = [None] * len(frictions)
    borders: list[Border] = []
    problems: list[str] = []
    end = 0
    with progress.bar("sweep", len(frictions), "gaits", show_progress) as bar:
        while end < len(frictions):
            begin, first, why = _begin(runner, frictions, end, bar)
            if first is None:
                problems.append(why)
                break
            preceding, _ = _followed(runner, frictions[end:begin][::-1], first, bar)
            following, lost = _followed(runner, frictions[begin:], first, bar)
            branch = [*preceding[::-1], *following]
            problems += [why] if end < begin - len(preceding) else []
            problems += [lost] if lost else []
            end = begin + len(following)
            gaits[end - len(branch) : end] = branch
            found, unknown = _borders(runner, branch)
            borders += found
            problems += unknown
    if not any(gaits):
        raise RunError("; ".join([*problems[:1], *["nor is there any further on"] * (len(frictions) > 1)]))
    return Sweep(
        frictions=tuple(float(friction) for friction in frictions),
        gaits=tuple(gaits),
        borders=tuple(borders),
        problem="; ".join(dict.fromkeys(problems)) or None,
    )


def _begin(
    runner: Runner, frictions: Sequence[float], start: int, bar: tqdm
) -> tuple[int, Orbit | None, str | None]:
    """Number of a friction with a gait, the first from `start` on; that gait; why the one at `start` is none.

    While there is none yet, the longer search is made at both ends of the range: a branch that comes from
    outside is met there.
    """
    why = None
    for number in range(start, len(frictions)):
        search = first_orbit if start == 0 and number in (0, len(frictions) - 1) else find_orbit
        try:
            return number, search(runner.but(FRICTION, frictions[number])), why
        except RunError as problem:
            why = why or str(problem)
            bar.update()
    return len(frictions), None, why


def _followed(
    runner: Runner, frictions: Sequence[float], first: Orbit, bar: tqdm
) -> tuple[list[Orbit], str | None]:
    """Gaits from one on, as far as the branch could be followed, and what stopped it."""
    found: list[Orbit] = []
    try:
        for orbit in gaits_over(runner, FRICTION, frictions, first):
            found.append(orbit)
            bar.update()
    except RunError as problem:
        return found, str(problem)
    return found, None


def _borders(runner: Runner, orbits: Sequence[Orbit]) -> tuple[list[Border], list[str]]:
    """All changes of the word, and why some are missing."""
    borders: list[Border] = []
    problems: list[str] = []
    for before, after in pairwise(orbits):
        try:
            for border, _ in crossings(Family(runner, FRICTION), before, after):
                borders.append(border)
        except RunError as problem:
            problems.append(str(problem))
    return borders, problems


def _check_frictions(runner: Runner, frictions: Sequence[float]) -> None:
    """Refuse, before any work, frictions at which there is no gait to follow."""
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

    Args:
        runner: the other parameters and the start, or start values by name.
        frictions: values along a row.
        name: the second parameter or input, or a state that the search for gaits starts with.
        values: one for each row.
        path: of the NetCDF file.
        scheduler: of a Dask cluster, see `blocks.run`. The result does not depend on who computes it.
        workers: processes on this machine, by default one for each processor.
        show_progress: a bar on stderr.
        unit: for units and descriptions.

    Raises:
        InputError: a value is refused, or the file holds another sweep.
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
    path = check_place(path, (".nc",), "path")
    data = resumed(path, blank, "sweep")
    _check_rows(path, data, blank, runner, name, unit, show_progress)
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

    Raises:
        InputError: the first such row.
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
        found = _sweep(row.runner, row.frictions)
    except TdmfSlipError as problem:  # also start values that go with other rows only
        return [None] * len(row.frictions), str(problem)
    return list(found.gaits), found.problem or ""
