"""Resume work from a file: only a file of exactly the same work is accepted."""

import contextlib
from collections.abc import Hashable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError
from ..files.datasets import xarray
from .netcdf import read_dataset


def resumed(path: Path, blank: xarray.Dataset, what: str) -> xarray.Dataset:
    """The partial result on file of the work that would fill `blank`; `blank` if there is no file."""
    try:
        data = read_dataset(path)
    except FileNotFoundError:
        return blank
    except (OSError, ValueError) as problem:
        reason = getattr(problem, "strerror", None) or "no NetCDF file"
        raise InputError(f"{path}: no {what} to go on with ({reason}); allowed: another file name") from None
    difference = _difference(data, blank)
    if difference is not None:
        raise InputError(f"{path}: holds another {what}, {difference}; allowed: another file name")
    return data


def refuse_resumable(path: Path) -> None:
    """Refuse, before any work, to write something else over results on file, which have taken long."""
    with contextlib.suppress(OSError, ValueError):
        data = read_dataset(path)
        if "done" in data or "fate" in data:
            what = "grid of gaits" if "done" in data else "map"
            raise InputError(f"{path}: holds a {what}; allowed: another file name")


def same_values(
    found: xarray.Dataset,
    wanted: xarray.Dataset,
    relative: float = 0.0,
    rounding: Mapping[str, float] | None = None,
) -> bool:
    """Whether all variables of one dataset are those of another, NaN where it is NaN."""
    minimum = rounding or {}
    return all(
        _close(found[name].values, wanted[name].values, relative, minimum.get(str(name), 0.0))
        for name in wanted.data_vars
    )


def _close(found: NDArray[np.float64], wanted: NDArray[np.float64], relative: float, rounding: float) -> bool:
    if wanted.dtype.kind != "f":
        return np.array_equal(found, wanted)
    off = relative * np.max(np.abs(wanted), initial=0.0, where=np.isfinite(wanted))
    off = max(off, rounding)
    return np.allclose(found, wanted, rtol=0.0, atol=off, equal_nan=True)


def _difference(data: xarray.Dataset, blank: xarray.Dataset) -> str | None:
    for name, wanted in blank.coords.items():
        if name not in data.coords or not np.array_equal(data[name].values, wanted.values):
            return f"with other values of {name}"
    for name, wanted in blank.data_vars.items():
        if name not in data or data[name].dims != wanted.dims or _kind(data[name]) != _kind(wanted):
            return f"without such a variable {name}"
    for name, wanted in blank.variables.items():
        for attribute in wanted.attrs:
            if not _same(data[name].attrs, wanted.attrs, attribute):
                return f"with another {attribute} of {name}"
    return next(
        (f"with another {name}" for name in blank.attrs if not _same(data.attrs, blank.attrs, name)), None
    )


def _kind(variable: xarray.DataArray) -> str:
    """Kind of the values. Texts come back from a file with another dtype."""
    return "text" if variable.dtype.kind in "OSTU" else variable.dtype.kind


def _same(found: Mapping[Any, Any], wanted: Mapping[Any, Any], name: Hashable) -> bool:
    """Whether an attribute agrees; numbers may differ by rounding, as between two machines."""
    value, there = wanted[name], found.get(name, "")
    if isinstance(value, str):
        return isinstance(there, str) and there == value
    if np.asarray(there).dtype.kind not in "iuf" or np.shape(there) != np.shape(value):
        return False
    return np.allclose(there, value, rtol=1e-9, atol=1e-12)
