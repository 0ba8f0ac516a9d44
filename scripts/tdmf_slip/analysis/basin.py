"""The region of attraction of a gait over a slice of the apex section: which starts run on, which fall."""

import reprlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import xarray

from ..blocks.running import run_blocks
from ..errors import InputError
from ..files.netcdf import write_dataset
from ..files.resume import resumed
from ..files.whole import check_place
from ..library import ensemble
from ..library.orbit import Orbit, check_orbit
from ..library.runner import Runner
from ..terminal import progress
from ..unit.section import COORDINATES
from ..unit.unit import Unit, load
from .search import first_orbit

TOLERANCE = 1e-5
"""Relative tolerance of a step for maps and volumes."""
ACCURACY = 5e-4
"""By which the apex after a stride then errs at the most, over the scales, from anywhere in `attraction.BOX`;
from within 0.05 of a gait by a twentieth of that. Of 24,576 starts none has another fate than at 1e-10."""
MOST_STRIDES = 400
NOT_YET = -1
LEG_LENGTH = COORDINATES.index("leg_length")
"""It and the coordinates before are positive, and measured by what they are."""
STRIDES_OF_FATES: Mapping[int, tuple[int, int]] = {
    **dict.fromkeys(range(len(ensemble.FATES)), (0, MOST_STRIDES)),
    ensemble.FATES.index("settled"): (1, MOST_STRIDES),
    ensemble.FATES.index("no_start"): (0, 0),
    NOT_YET: (0, 0),
}
"""The least and the most that a fate may come after."""
STARTS_AT_ONCE = 4096
"""In a block."""
STARTS_IN_A_CALL = 512
"""Of the library, which hears of no interrupt until it returns."""


@dataclass(frozen=True)
class Slice:
    """Starts that differ from a gait's apex in two coordinates: a block of work."""

    runner: Runner
    apex: tuple[float, ...]
    axes: tuple[str, str]
    rows: tuple[float, ...]
    columns: tuple[float, ...]

    def starts(self) -> np.ndarray:
        """One to a row, the columns running fastest."""
        sections = np.tile(self.apex, (len(self.rows), len(self.columns), 1))
        sections[..., COORDINATES.index(self.axes[0])] = np.asarray(self.rows)[:, None]
        sections[..., COORDINATES.index(self.axes[1])] = np.asarray(self.columns)[None, :]
        return sections.reshape(-1, len(COORDINATES))


def fates_of_slice(part: Slice) -> np.ndarray:
    """What becomes of each start of a block, in its shape: the fields `fate` and `strides`."""
    ends = fates(part.runner, part.apex, part.starts())
    return ends.reshape(len(part.rows), len(part.columns))


def fates(
    runner: Runner, apex: Sequence[float], starts: np.ndarray, *, tolerance: float = TOLERANCE
) -> np.ndarray:
    """What becomes of runners that start somewhere, as `run_ensemble` tells it, by one thread."""
    case = ensemble.Case(runner, (apex,))
    calls = range(0, max(1, len(starts)), STARTS_IN_A_CALL)
    return np.concatenate(
        [
            ensemble.run_ensemble(
                [case],
                starts[first : first + STARTS_IN_A_CALL],
                most_strides=MOST_STRIDES,
                tolerance=tolerance,
                threads=1,
            )[0]
            for first in calls
        ]
    )


def stable_gait(runner: Runner | Mapping[str, object], unit: Unit | None = None) -> Orbit:
    """The gait of a runner, if it attracts anything.

    Raises
    ------
    InputError
        It is unstable.
    RunError
        There is none.
    """
    gait = first_orbit(runner, unit)
    if not gait.stable:
        raise InputError(f"the gait at friction {gait.friction:g} is unstable: it attracts nothing")
    return gait


def range_around(gait: Orbit, axis: str) -> tuple[float, float]:
    """Ends of a range of a coordinate of the section that has the gait in it, and most of what it attracts.

    Raises
    ------
    InputError
        An unknown axis, or no gait.
    """
    check_axes((axis,))
    check_orbit(gait, "gait")
    index = COORDINATES.index(axis)
    here, scale = gait.apex[index], gait.runner.scales[index]
    low, high = (here - 0.5 * scale, here + 0.5 * scale) if index > LEG_LENGTH else (0.7 * here, 1.5 * here)
    return float(f"{low:.6g}"), float(f"{high:.6g}")


def check_axes(axes: Sequence[str]) -> None:
    """Refuse names that are not those of coordinates of the section.

    Raises
    ------
    InputError
        One is not.
    """
    wrong = next((axis for axis in axes if axis not in COORDINATES), None)
    if wrong is not None:
        raise InputError(f"axes: {wrong!r} is not allowed; allowed: {', '.join(COORDINATES)}")


def basin(
    runner: Runner | Mapping[str, object],
    axes: tuple[str, str],
    ranges: tuple[Sequence[float | str], Sequence[float | str]],
    *,
    path: Path | str | None = None,
    scheduler: str | None = None,
    workers: int | None = None,
    show_progress: bool = False,
    unit: Unit | None = None,
) -> xarray.Dataset:
    """The fate of a runner from each point of a slice through the gait's apex.

    The other four coordinates are the gait's. With a path the result is written there as NetCDF, block by
    block, and a file of the same slice is gone on with.

    Parameters
    ----------
    runner : Runner or mapping of str to object
        Parameters and friction, or start values by name.
    axes : tuple[str, str]
        Two names of `section.COORDINATES`.
    ranges : tuple[Sequence[float | str], Sequence[float | str]]
        Values along each, numbers or texts like `70 deg`.
    path : Path or str, optional
        Of a NetCDF file.
    scheduler : str, optional
        Of a Dask cluster, see `run_blocks`. The result does not depend on who computes it.
    workers : int, optional
        Processes on this machine, by default one for each processor.
    show_progress : bool, default False
        A bar on stderr.
    unit : Unit, optional
        For units.

    Returns
    -------
    xarray.Dataset
        `fate`, by the flag values of its attribute, and `strides` until then, over the two coordinates. How
        much of the slice settles, its attributes say: `settled_share` and, in the coordinates' units,
        `settled_area`.

    Raises
    ------
    InputError
        An unknown axis, the file holds another slice, or the gait is unstable.
    RunError
        There is no gait.
    """
    unit, runner = load(unit), Runner.of(runner)
    path = None if path is None else check_place(path, (".nc",), "path")
    axes, ranges = _checked_slice(axes, ranges, unit)
    gait = stable_gait(runner, unit)
    data = _blank(gait, axes, ranges, unit)
    if path is not None:
        data = _resumed(path, data)
    missing = [row for row in range(len(ranges[0])) if (data["fate"].values[row] == NOT_YET).any()]
    at_once = max(1, STARTS_AT_ONCE // len(ranges[1]))
    rows = [missing[i : i + at_once] for i in range(0, len(missing), at_once)]
    parts = [
        Slice(runner, tuple(gait.apex), axes, tuple(np.asarray(ranges[0])[block]), tuple(ranges[1]))
        for block in rows
    ]
    with (
        progress.bar("basin", len(ranges[0]), "rows", show_progress) as bar,
        run_blocks(fates_of_slice, parts, scheduler=scheduler, workers=workers) as results,
    ):
        bar.update(len(ranges[0]) - len(missing))
        for number, ends in results:
            for name in ("fate", "strides"):
                data[name].values[rows[number]] = ends[name]
            bar.update(len(rows[number]))
            if path is not None:
                write_dataset(path, data)
    share = float(np.mean(data["fate"].values == 0))
    area = share * float(np.prod([np.ptp(values) for values in ranges]))
    data.attrs |= {"settled_share": share, "settled_area": area}
    if path is not None:
        write_dataset(path, data)
    return data


def _checked_slice(axes: object, ranges: object, unit: Unit) -> tuple[tuple[str, str], list[np.ndarray]]:
    for what, pair in (("axes", axes), ("ranges", ranges)):
        if not isinstance(pair, Sequence | np.ndarray) or isinstance(pair, str) or len(pair) != 2:
            raise InputError(f"{what} = {reprlib.repr(pair)} is not allowed; allowed: a pair")
    check_axes(axes)
    if axes[0] == axes[1]:
        raise InputError(f"axes {', '.join(axes)}: allowed: two that differ")
    variables = [unit.variables[f"apex.{axis}"] for axis in axes]
    return tuple(axes), [
        variable.values_of(values, f"range of {axis}")
        for variable, axis, values in zip(variables, axes, ranges, strict=True)
    ]


def _resumed(path: Path, blank: xarray.Dataset) -> xarray.Dataset:
    data = resumed(path, blank, "slice")
    fates, strides = data["fate"].values, data["strides"].values
    allowed = np.select(
        [fates == fate for fate in STRIDES_OF_FATES],
        [(strides >= least) & (strides <= most) for least, most in STRIDES_OF_FATES.values()],
        False,
    )
    if not allowed.all():
        row, column = np.argwhere(~allowed)[0]
        raise InputError(
            f"{path}: holds another slice, in row {row}, column {column} with fate {fates[row, column]} "
            f"after {strides[row, column]} strides; allowed: another file name"
        )
    return data


def _blank(
    gait: Orbit, axes: tuple[str, str], ranges: tuple[Sequence[float], Sequence[float]], unit: Unit
) -> xarray.Dataset:
    shape = len(ranges[0]), len(ranges[1])
    data = xarray.Dataset(
        {
            "fate": (axes, np.full(shape, NOT_YET, dtype="i4")),
            "strides": (axes, np.zeros(shape, dtype="i4")),
        },
        coords={axis: ((axis,), np.asarray(v, dtype=float)) for axis, v in zip(axes, ranges, strict=True)},
    )
    data["fate"].attrs = {
        "flag_values": np.arange(len(ensemble.FATES)),
        "flag_meanings": " ".join(ensemble.FATES),
    }
    data["strides"].attrs = {"units": "1", "long_name": "strides closed until then"}
    for axis, value in zip(COORDINATES, gait.apex, strict=True):
        data.attrs[f"gait_{axis}"] = float(value)
    for axis in axes:
        variable = unit.variables[f"apex.{axis}"]
        data[axis].attrs = {"units": variable.unit or "1", "long_name": variable.description}
    data.attrs |= {"word": gait.word, **gait.runner.values}
    return data
