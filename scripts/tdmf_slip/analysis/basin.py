"""The region of attraction of a gait over a slice of the apex section: which starts run on, which fall."""

import json
import math
import reprlib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..blocks.running import run_blocks
from ..checks import check_size
from ..errors import InputError
from ..files.datasets import xarray
from ..files.netcdf import CLASSIC, write_dataset
from ..files.resume import resumed
from ..files.rows import RowFile
from ..files.whole import check_place
from ..library import ensemble
from ..library.affine_law import AffineLaw
from ..library.gait import Gait, check_is_gait
from ..library.runner import Runner
from ..library.section import COORDINATES, check_axes
from ..terminal.progress import progress_bar
from ..unit.unit import Fmu, load_fmu
from ..unit.variable import Given
from .ball import Ball, attributes_of, ball_of
from .fates import MOST_ALONG, MOST_STRIDES, STARTS_AT_ONCE
from .held_gait import stable_gait as stable_gait
from .search import model_of
from .slice_block import Slice, fates_of_slice

MOST_STARTS = MOST_ALONG**2
"""A map of as many is 2 GB."""
NOT_YET = -1
STRIDES = "strides_until_known"
"""Name of the variable."""
LEG_LENGTH = COORDINATES.index("leg_length")
"""It and the coordinates before are positive, and measured by what they are."""
STRIDES_OF_FATES: Mapping[int, tuple[int, int]] = {
    **dict.fromkeys(range(len(ensemble.FATES)), (0, MOST_STRIDES)),
    ensemble.FATES.index("no_start"): (0, 0),
    NOT_YET: (0, MOST_STRIDES),
}
"""The least and the most that a fate may come after."""


def range_around(gait: Gait, axis: str) -> tuple[float, float]:
    """Ends of a range of a coordinate of the section that has the gait in it, and most of what it attracts.

    Parameters
    ----------
    gait : Gait
        Which gait.
    axis : str
        One of `COORDINATES`.

    Returns
    -------
    pair of float
        To six digits, in the coordinate's unit.

    Raises
    ------
    InputError
        An unknown axis, or no gait.
    """
    check_axes((axis,))
    check_is_gait(gait, "gait")
    index = COORDINATES.index(axis)
    here, scale = gait.apex[index], gait.runner.scales[index]
    low, high = (here - 0.5 * scale, here + 0.5 * scale) if index > LEG_LENGTH else (0.7 * here, 1.5 * here)
    return _rounded(low), _rounded(high)


def _rounded(value: float) -> float:
    """A number to six significant digits."""
    return round(value, 5 - math.floor(math.log10(abs(value)))) if value else 0.0


def basin(
    runner: Runner | Mapping[str, Given],
    axes: tuple[str, str],
    ranges: tuple[ArrayLike, ArrayLike],
    *,
    law: AffineLaw | None = None,
    ball: Ball | str = "tested",
    path: Path | str | None = None,
    scheduler: str | None = None,
    threads: int | None = None,
    progress: bool = False,
    fmu: Fmu | None = None,
) -> xarray.Dataset:
    """The fate of a runner from each point of a slice through the gait's apex.

    The other coordinates are the gait's; the reduced map has none. With a path the result is written there as
    NetCDF, row by row, and a file of the same slice is gone on with.

    Parameters
    ----------
    runner : Runner or mapping of str to float
        Parameters and friction, or start values by name.
    axes : pair of str
        Two names of `section.COORDINATES`.
    ranges : pair of sequences of float
        Values along each, in the coordinate's unit.
    law : AffineLaw, optional
        By which settings are made anew at each apex; the gait is then the one near the law's apex, which the
        law keeps as it is and has to make stable.
    ball : {"tested", "none"} or Ball, default "tested"
        A start has settled as soon as it comes into a ball of attraction. By default the norm is tested to
        fall from 10,000 points of it, and it is made only where it saves more than it costs; with `none` a
        start is followed until it is within 0.01 of the gait, over the scales; a ball that is proved, as
        `proved_ball` gives it, is small, so that starts are followed for longer, at a finer tolerance.
    path : Path or str, optional
        Of a NetCDF file.
    scheduler : str, optional
        Of a Dask cluster, see `run_blocks`. The result does not depend on who computes it.
    threads : int, optional
        Threads on this machine, by default one for each processor.
    progress : bool, default False
        A bar on stderr.
    fmu : Fmu, optional
        For units.

    Returns
    -------
    xarray.Dataset
        `fate`, by the flag values of its attribute, and `strides_until_known`, that were closed until then,
        over the two coordinates. How much of the slice settles, its attributes say: `settled_share` and, in
        the coordinates' units, `settled_area`; and by which ball: `ball` ("tested", "proved" or "none"),
        `ball_radius` (every apex so near in each coordinate, over the scales, is inside), `ball_rate` (what
        the norm falls to in a stride at the most) and `ball_points`.

    Raises
    ------
    InputError
        An unknown axis or ball, the file holds another slice, the gait is unstable, or the law does not keep
        it.
    RunError
        There is no gait.

    Examples
    --------
    >>> import numpy as np
    >>> import tdmf_slip
    >>> axes, ranges = ("com_height", "com_speed"), (np.linspace(1.2, 1.6, 3), np.linspace(0.9, 1.2, 3))
    >>> fates = tdmf_slip.basin({"ground.friction": 0.6}, axes, ranges, threads=1)
    >>> print(fates["fate"].shape, fates.attrs["settled_share"])
    (3, 3) 1.0
    """
    fmu, runner = load_fmu(fmu), Runner.of(runner)
    path = None if path is None else check_place(path, (".nc",), "path")
    axes, values = _checked_slice(axes, ranges, runner.coordinates, fmu)
    gait = stable_gait(runner, fmu, law)
    around = ball_of(gait, ball, len(values[0]) * len(values[1]), law)
    data = _blank(gait, axes, values, fmu)
    data.attrs |= attributes_of(around)
    if law is not None:
        data.attrs["law"] = json.dumps(law.as_json())
    if path is not None:
        data = _resumed(path, data)
    missing = [row for row in range(len(values[0])) if (data["fate"].values[row] == NOT_YET).any()]
    at_once = max(1, STARTS_AT_ONCE // len(values[1]))
    rows = [missing[i : i + at_once] for i in range(0, len(missing), at_once)]
    parts = [
        Slice(
            runner,
            tuple(gait.apex),
            axes,
            tuple(values[0][block]),
            tuple(values[1]),
            tuple(block),
            law,
            around,
        )
        for block in rows
    ]
    file = None
    with (
        progress_bar("basin", len(values[0]), "rows", progress) as bar,
        run_blocks(fates_of_slice, parts, scheduler=scheduler, threads=threads) as results,
    ):
        bar.update(len(values[0]) - len(missing))
        for number, ends in results:
            data["fate"].values[rows[number]] = ends["fate"]
            data[STRIDES].values[rows[number]] = ends["strides"]
            bar.update(len(rows[number]))
            if path is not None:
                file = file or RowFile(path, data)
                file.write((STRIDES, "fate"), rows[number])
    share = float(np.mean(data["fate"].values == ensemble.SETTLED))
    area = share * float(np.prod([np.ptp(along) for along in values]))
    data.attrs |= {"settled_share": share, "settled_area": area}
    if path is not None:
        write_dataset(path, data, CLASSIC)
    return data


def _checked_slice(
    axes: Any, ranges: Any, coordinates: Sequence[str], fmu: Fmu
) -> tuple[tuple[str, str], tuple[NDArray[np.float64], NDArray[np.float64]]]:
    for what, pair in (("axes", axes), ("ranges", ranges)):
        if not isinstance(pair, Sequence | np.ndarray) or isinstance(pair, str) or len(pair) != 2:
            raise InputError(f"{what} = {reprlib.repr(pair)} is not allowed; allowed: a pair")
    check_axes(axes, coordinates)
    first, second = axes
    if first == second:
        raise InputError(f"axes {first}, {second}: allowed: two that differ")
    rows, columns = (
        fmu.variables[f"apex.{axis}"].values_of(values, f"range of {axis}")
        for axis, values in zip(axes, ranges, strict=True)
    )
    check_size("ranges", len(rows) * len(columns), f"starts ({len(rows):,} by {len(columns):,})", MOST_STARTS)
    return (first, second), (rows, columns)


def _resumed(path: Path, blank: xarray.Dataset) -> xarray.Dataset:
    data = resumed(path, blank, "slice")
    fates, strides = data["fate"].values, data[STRIDES].values
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
    gait: Gait,
    axes: tuple[str, str],
    ranges: tuple[NDArray[np.float64], NDArray[np.float64]],
    fmu: Fmu,
) -> xarray.Dataset:
    shape = len(ranges[0]), len(ranges[1])
    data = xarray.Dataset(
        {
            "fate": (axes, np.full(shape, NOT_YET, dtype="i4")),
            STRIDES: (axes, np.zeros(shape, dtype="i4")),
        },
        coords={axis: ((axis,), values) for axis, values in zip(axes, ranges, strict=True)},
    )
    data["fate"].attrs = {
        "flag_values": np.arange(len(ensemble.FATES)),
        "flag_meanings": " ".join(ensemble.FATES),
    }
    data[STRIDES].attrs = {"units": "1", "long_name": "strides closed until the fate was known"}
    for axis, value in zip(gait.runner.coordinates, gait.apex, strict=True):
        data.attrs[f"gait_{axis}"] = float(value)
    for axis in axes:
        variable = fmu.variables[f"apex.{axis}"]
        data[axis].attrs = {"units": variable.unit or "1", "long_name": variable.description}
    data.attrs |= {"word": gait.word, **gait.runner.values, **model_of(gait.runner)}
    return data
