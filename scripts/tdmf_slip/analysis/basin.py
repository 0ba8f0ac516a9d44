"""The region of attraction of a gait over a slice of the apex section: which starts run on, which fall."""

import dataclasses
import functools
import json
import math
from collections.abc import Callable, Mapping, Sequence
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
from ..files.whole import check_destination
from ..given import counts_given
from ..library import ensemble
from ..library.affine_law import AffineLaw
from ..library.gait import Gait
from ..library.runner import Runner
from ..library.section import check_axes
from ..terminal.progress import progress_bar
from ..unit.unit import Fmu, load_fmu
from .axes import AXES, Axes, axes_of
from .axes import range_around as range_around
from .ball import Ball, attributes_of, ball_of
from .controlled_gait import stable_gait as stable_gait
from .fates import MAX_ALONG, MAX_STRIDES, STARTS_AT_ONCE
from .preview import PREVIEW, REFINEMENTS, follow_points, preview_of
from .search import model_of
from .slice_block import Slice, fates_of_slice

MAX_STARTS = MAX_ALONG**2
"""A map of as many is 2 GB."""
MAX_AXIS = MAX_STARTS // 2
NOT_YET = -1
STRIDES = "strides_until_known"
"""Name of the variable."""
STRIDES_OF_FATES: Mapping[int, tuple[int, int]] = {
    **dict.fromkeys(range(len(ensemble.FATES)), (0, MAX_STRIDES)),
    ensemble.FATES.index("no_start"): (0, 0),
    NOT_YET: (0, MAX_STRIDES),
}
"""The least and the most that a fate may come after."""


def basin(
    runner: object = None,
    axes: Axes = AXES,
    n: int | tuple[int, int] = 128,
    *,
    model: str | None = None,
    law: AffineLaw | None = None,
    ball: Ball | str = "tested",
    refine: str = "exact",
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
    runner : Runner, Gait, mapping of str to float, str or Path, optional
        Parameters and friction, or start values by name; of a gait its runner.
    axes : mapping of str to (low, high), or pair of str
        Two names of `section.COORDINATES` with their ranges, in the coordinate's unit; None for a range
        around the gait, or the names alone. By default height and speed.
    n : int or pair of int, default 128
        Starts along each of the axes, both ends included.
    model : str, optional
        `full` or `reduced`, as in `find_gait`.
    law : AffineLaw, optional
        By which settings are made anew at each apex; the gait is then the one near the law's apex, which the
        law keeps as it is and has to make stable.
    ball : {"tested", "none"} or Ball, default "tested"
        A start has settled as soon as it comes into a ball of attraction. By default the norm is tested to
        fall from 10,000 points of it, and it is made only where it saves more than it costs; with `none` a
        start is followed until it is within 0.01 of the gait, over the scales; a ball that is proved, as
        `proved_ball` gives it, is small, so that starts are followed for longer, at a finer tolerance.
    refine : {"exact", "preview"}, default "exact"
        Every start is followed; or only those near a border between fates and the corners of squares of at
        most 16 starts a side elsewhere, which are painted with the fate of their corners. Of 256 by 256
        starts a preview takes 7 to 200 times fewer strides; an island smaller than a square can be missed.
    path : Path or str, optional
        Of a NetCDF file; a preview is written there when it is whole.
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
        the norm falls to in a stride at the most) and `ball_points`. `refine` says how the map was
        made; a preview has `is_followed`, too: 0 for starts that are painted.

    Raises
    ------
    InputError
        An unknown axis, ball or way to refine, a preview by a law with noise, the file holds another slice,
        the gait is unstable, or the law does not keep it.
    RunError
        There is no gait.

    Examples
    --------
    >>> import tdmf_slip
    >>> axes = {"com_height": (1.2, 1.6), "com_speed": (0.9, 1.2)}
    >>> fates = tdmf_slip.basin({"ground.friction": 0.6}, axes, n=3, threads=1)
    >>> print(fates["fate"].shape, fates.attrs["settled_share"])
    (3, 3) 1.0
    """
    fmu, runner = load_fmu(fmu), Runner.of(runner, fmu, model=model)
    spans = axes_of(axes, runner.coordinates)
    counts = counts_given(n, MAX_AXIS)
    size = math.prod(counts)
    check_size("n", size, f"starts ({counts[0]:,} by {counts[1]:,})", MAX_STARTS)
    gait = stable_gait(runner, fmu, law)
    ends = {name: range_around(gait, name) if span is None else span for name, span in spans.items()}
    values = {
        name: np.linspace(*span, count) for (name, span), count in zip(ends.items(), counts, strict=True)
    }
    return basin_at(
        gait,
        values,
        law=law,
        ball=ball,
        refine=refine,
        path=path,
        scheduler=scheduler,
        threads=threads,
        progress=progress,
        fmu=fmu,
    )


def basin_at(
    gait: Gait,
    values: Mapping[str, ArrayLike],
    *,
    law: AffineLaw | None = None,
    ball: Ball | str = "tested",
    refine: str = "exact",
    path: Path | str | None = None,
    scheduler: str | None = None,
    threads: int | None = None,
    progress: bool = False,
    fmu: Fmu | None = None,
) -> xarray.Dataset:
    """`basin` of a stable gait, at values of two coordinates that may be at any distance from each other."""
    fmu, runner = load_fmu(fmu), gait.runner
    path = None if path is None else check_destination(path, (".nc",), "path")
    axes, along = _checked_slice(values, runner.coordinates, fmu)
    _check_refine(refine, law)
    around = ball_of(gait, ball, len(along[0]) * len(along[1]), law)
    data = _blank(gait, axes, along, fmu)
    data.attrs |= attributes_of(around) | {"refine": refine}
    if law is not None:
        data.attrs["law"] = json.dumps(law.as_json())
    if refine == PREVIEW:
        data["is_followed"] = axes, np.zeros(data["fate"].shape, dtype="i1")
        data["is_followed"].attrs = {"long_name": "1 for a start that was followed, 0 for a painted one"}
    if path is not None:
        data = _resumed(path, data)
    plan = Slice(runner, tuple(gait.apex), axes, tuple(along[0]), tuple(along[1]), law=law, ball=around)
    blocks = functools.partial(run_blocks, scheduler=scheduler, threads=threads)
    if refine == PREVIEW:
        _paint(data, plan, blocks, progress)
    else:
        _follow_rows(data, plan, blocks, path, progress)
    share = float(np.mean(data["fate"].values == ensemble.SETTLED))
    area = share * float(np.prod([np.ptp(row) for row in along]))
    data.attrs |= {"settled_share": share, "settled_area": area}
    if path is not None:
        write_dataset(path, data, CLASSIC)
    return data


def _check_refine(refine: str, law: AffineLaw | None) -> None:
    if refine not in REFINEMENTS:
        raise InputError(f"refine = {refine!r} is not allowed; allowed: {', '.join(REFINEMENTS)}")
    if refine == PREVIEW and law is not None and law.is_noisy:
        raise InputError("refine = 'preview' with a law that has noise: allowed: 'exact'")


def _paint(data: xarray.Dataset, plan: Slice, blocks: Callable[..., Any], progress: bool) -> None:
    """A preview, unless the file holds it."""
    if (data["fate"].values != NOT_YET).all():
        return
    with progress_bar("preview of a basin", None, "starts", progress) as bar:
        found = preview_of(data["fate"].shape, functools.partial(follow_points, plan, blocks, bar.update))
    data["fate"].values[:], data[STRIDES].values[:] = found.fate, found.strides
    data["is_followed"].values[:] = found.is_followed


def _follow_rows(
    data: xarray.Dataset, plan: Slice, blocks: Callable[..., Any], path: Path | None, progress: bool
) -> None:
    """Rows that are missing, each start by itself, into the file as they come."""
    missing = [row for row in range(len(plan.rows)) if (data["fate"].values[row] == NOT_YET).any()]
    at_once = max(1, STARTS_AT_ONCE // len(plan.columns))
    rows = [missing[i : i + at_once] for i in range(0, len(missing), at_once)]
    parts = [
        dataclasses.replace(plan, rows=tuple(np.asarray(plan.rows)[block]), numbers=tuple(block))
        for block in rows
    ]
    file = None
    with (
        progress_bar("basin", len(plan.rows), "rows", progress) as bar,
        blocks(fates_of_slice, parts) as results,
    ):
        bar.update(len(plan.rows) - len(missing))
        for number, ends in results:
            data["fate"].values[rows[number]] = ends["fate"]
            data[STRIDES].values[rows[number]] = ends["strides"]
            bar.update(len(rows[number]))
            if path is not None:
                file = file or RowFile(path, data)
                file.write((STRIDES, "fate"), rows[number])


def _checked_slice(
    values: Mapping[str, ArrayLike], coordinates: Sequence[str], fmu: Fmu
) -> tuple[tuple[str, str], tuple[NDArray[np.float64], NDArray[np.float64]]]:
    """Names of the two coordinates, and their values."""
    first, second = values
    check_axes((first, second), coordinates)
    rows, columns = (
        fmu.variables[f"apex.{axis}"].values_of(along, f"range of {axis}") for axis, along in values.items()
    )
    check_size("ranges", len(rows) * len(columns), f"starts ({len(rows):,} by {len(columns):,})", MAX_STARTS)
    return (first, second), (rows, columns)


def _resumed(path: Path, blank: xarray.Dataset) -> xarray.Dataset:
    data = resumed(path, blank, "slice")
    fates, strides = data["fate"].values, data[STRIDES].values
    allowed = np.select(
        [fates == fate for fate in STRIDES_OF_FATES],
        [(strides >= minimum) & (strides <= maximum) for minimum, maximum in STRIDES_OF_FATES.values()],
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
