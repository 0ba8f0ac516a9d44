"""The region of attraction of a gait: which starts on a slice of the apex section run on, and which fall."""

import os
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import xarray

from . import progress
from .errors import InputError
from .files import whole
from .library import c, ffi
from .orbit import Orbit, Runner
from .section import COORDINATES
from .sweep import first_orbit
from .unit import Unit, load

TOLERANCE = 1e-8
"""Relative tolerance of the native solver, for thousands of runners."""
NEAR = 1e-2
"""Distance from the gait's apex, over the scales, at which a runner counts as settled."""
MOST_STRIDES = 400
FATES = ("settled", "fell", "undecided", "no_start")
"""By the library's numbers."""
NOT_YET = -1
ROWS_AT_ONCE = 8


def basin(
    runner: Runner,
    axes: tuple[str, str],
    ranges: tuple[Sequence[float], Sequence[float]],
    *,
    path: Path | None = None,
    workers: int | None = None,
    show_progress: bool = False,
    unit: Unit | None = None,
) -> xarray.Dataset:
    """The fate of a runner from each point of a slice through the gait's apex.

    The other four coordinates are the gait's. With a path the result is written there as NetCDF, block by
    block, and a file of the same slice is gone on with.

    Args:
        runner: parameters and friction.
        axes: two names of `section.COORDINATES`.
        ranges: values along each.
        path: of a NetCDF file.
        workers: threads; by default one for each processor. The result does not depend on it.
        show_progress: a bar on stderr.
        unit: for units.

    Returns:
        `fate`, by the flag values of its attribute, and `strides` until then, over the two coordinates; how
        large a share of the slice settles is the attribute `settled_share`.

    Raises:
        InputError: an unknown axis, or the file holds another slice.
        RunError: there is no gait.
    """
    unit = load() if unit is None else unit
    if len(set(axes)) != 2 or any(axis not in COORDINATES for axis in axes):
        raise InputError(f"axes {', '.join(axes)}: allowed: two of {', '.join(COORDINATES)}")
    gait = first_orbit(runner, unit)
    if not gait.stable:
        raise InputError(f"the gait at friction {gait.friction:g} is unstable: it attracts nothing")
    data = _blank(gait, axes, ranges, unit)
    if path is not None and path.exists():
        data = _resumed(path, data)
    missing = [r for r in range(len(ranges[0])) if (data["fate"].values[r] == NOT_YET).any()]
    blocks = [missing[i : i + ROWS_AT_ONCE] for i in range(0, len(missing), ROWS_AT_ONCE)]
    with (
        progress.bar("basin", len(ranges[0]), "rows", show_progress) as bar,
        ThreadPoolExecutor(workers or os.cpu_count()) as pool,
    ):
        bar.update(len(ranges[0]) - len(missing))
        runs = [pool.submit(_fates, gait, axes, np.asarray(ranges[0])[block], ranges[1]) for block in blocks]
        for block, run in zip(blocks, runs, strict=True):
            data["fate"].values[block], data["strides"].values[block] = run.result()
            bar.update(len(block))
            if path is not None:
                with whole(path) as beside:
                    data.to_netcdf(beside)
    data.attrs["settled_share"] = float(np.mean(data["fate"].values == 0))
    return data


def _fates(
    gait: Orbit, axes: tuple[str, str], rows: np.ndarray, columns: Sequence[float]
) -> tuple[np.ndarray, np.ndarray]:
    """Fates and strides of a block of rows; the library is busy without Python's lock."""
    sections = np.tile(gait.apex, (len(rows), len(columns), 1))
    sections[..., COORDINATES.index(axes[0])] = np.asarray(rows)[:, None]
    sections[..., COORDINATES.index(axes[1])] = np.asarray(columns)[None, :]
    runner = Runner(gait.runner.values, TOLERANCE)
    count = sections.shape[0] * sections.shape[1]
    gaits = ffi.new("double[1][6]", [list(gait.apex)])
    rules = ffi.new("tdmf_fate_rules *")
    rules.gaits, rules.gait_count, rules.distance, rules.most_strides = gaits, 1, NEAR, MOST_STRIDES
    fates = ffi.new("tdmf_fate[]", count)
    starts = ffi.cast("double (*)[6]", ffi.from_buffer(sections))
    c.tdmf_find_fates(runner.solver(), runner.model, runner.inputs, rules, starts, count, fates)
    found = np.frombuffer(ffi.buffer(fates), dtype=np.intc).reshape(*sections.shape[:2], 3)
    return found[..., 0], found[..., 2]


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
    data["fate"].attrs = {"flag_values": np.arange(len(FATES)), "flag_meanings": " ".join(FATES)}
    data["strides"].attrs = {"units": "1", "long_name": "strides closed until then"}
    for axis, value in zip(COORDINATES, gait.apex, strict=True):
        data.attrs[f"gait_{axis}"] = float(value)
    for axis in axes:
        variable = unit.variables[f"apex.{axis}"]
        data[axis].attrs = {"units": variable.unit or "1", "long_name": variable.description}
    data.attrs |= {"word": gait.word, **gait.runner.values}
    return data


def _resumed(path: Path, blank: xarray.Dataset) -> xarray.Dataset:
    try:
        data = xarray.load_dataset(path)
    except (OSError, ValueError) as problem:
        raise InputError(f"{path}: no basin to go on with ({problem}); allowed: another file name") from None
    same = set(blank.coords) == set(data.coords) and all(
        np.array_equal(data[axis].values, blank[axis].values) for axis in blank.coords
    )
    if not same or not _same_attributes(data.attrs, blank.attrs):
        raise InputError(f"{path}: holds another slice; allowed: another file name")
    return data


def _same_attributes(found: Mapping, wanted: Mapping) -> bool:
    return all(
        np.allclose(found.get(name, np.nan), value, rtol=1e-9, atol=1e-12)
        if isinstance(value, float)
        else found.get(name) == value
        for name, value in wanted.items()
    )
