"""Results as files. A file is written whole or not at all: beside its place first, then moved there."""

import csv
import os
import stat
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from . import interrupts
from .errors import InputError, check_kind
from .simulation import Run
from .unit import Unit

if TYPE_CHECKING:
    import xarray


@contextmanager
def whole(path: Path) -> Iterator[Path]:
    """A path to write to, beside `path` and with its suffix; moved to `path` at the end, gone after an error.

    An interrupt from the keyboard waits until the file is there.

    Raises:
        InputError: nothing can be written there.
    """
    with interrupts.held():
        yield from _whole(path)


def _whole(path: Path) -> Iterator[Path]:
    try:
        handle, name = tempfile.mkstemp(prefix=f".{path.stem}-", suffix=path.suffix, dir=path.parent)
        os.close(handle)
    except OSError as problem:
        raise InputError(f"{path}: cannot be written: {problem.strerror}") from problem
    try:
        yield Path(name)
        os.chmod(name, 0o666 & ~_umask())  # mkstemp's files are private
        os.replace(name, path)
    except OSError as problem:
        raise InputError(f"{path}: cannot be written: {problem.strerror or problem}") from problem
    finally:
        Path(name).unlink(missing_ok=True)


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def check_place(path: Path | str, allowed: Iterable[str], what: str) -> Path:
    """Refuse, before any work, a path whose suffix names no format or that cannot be written.

    Returns:
        The path.

    Raises:
        InputError: either, or its folder is not there.
    """
    check_kind(path, (str, os.PathLike), what, "the path of a file")
    path = Path(path)
    if path.suffix.lower() not in allowed:
        raise InputError(f"{what}: {path}: format {path.suffix or '(none)'}; allowed: {', '.join(allowed)}")
    if not path.parent.is_dir():
        raise InputError(f"{what}: {path}: there is no folder {path.parent}; allowed: one that is there")
    check_folder(path.parent, what)
    try:
        is_folder = stat.S_ISDIR(path.stat().st_mode)
    except FileNotFoundError:
        return path
    except OSError as problem:
        raise InputError(f"{what}: {path}: {problem.strerror}") from None
    if is_folder:
        raise InputError(f"{what}: {path} is a folder; allowed: the name of a file")
    return path


def check_folder(folder: Path, what: str) -> None:
    """Refuse, before any work, a folder that nothing can be written to.

    One that is missing, in a folder that is there, is made, and goes again: if the work fails, nothing is
    left.

    Raises:
        InputError: it cannot be made or written to.
    """
    try:
        missing = not folder.exists()
        folder.mkdir(exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):  # to ask for leave alone is not enough where root asks
            pass
        if missing:
            folder.rmdir()
    except OSError as problem:
        raise InputError(f"{what}: {folder}: cannot be written to: {problem.strerror}") from problem


def write_table(path: Path | str, run: Run, unit: Unit) -> None:
    """A run's recorded rows as CSV (a header of names) or NetCDF (with units, flags and the run's end).

    Raises:
        InputError: another suffix than .csv or .nc, or nothing can be written there.
    """
    path = check_place(path, WRITERS, "output")
    with whole(path) as beside:
        WRITERS[path.suffix.lower()](beside, run, unit)


def write_dataset(path: Path, data: "xarray.Dataset") -> None:
    """A dataset as NetCDF.

    Raises:
        InputError: nothing can be written there.
    """
    with whole(path) as beside:
        data.to_netcdf(beside)


def _write_csv(path: Path, run: Run, _unit: Unit) -> None:
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(run.table.dtype.names)
        writer.writerows(run.table.tolist())


def _write_netcdf(path: Path, run: Run, unit: Unit) -> None:
    from netCDF4 import Dataset  # slow to load, and seldom asked for

    with Dataset(path, "w") as dataset:
        dataset.createDimension("row", len(run.table))
        for name in run.table.dtype.names:
            column = run.table[name]
            variable = dataset.createVariable(
                name, "i4" if column.dtype == bool else column.dtype, ("row",), zlib=True
            )
            variable[:] = column
            variable.setncatts(_attributes(unit, name))
        dataset.title = f"TDMF-SLIP run, unit version {unit.version}"
        dataset.fallen = int(run.fallen)
        for name in [*unit.names("parameter"), *unit.group("stride")]:
            dataset.setncattr(name, _plain(run.final[name]))


def _plain(value: float | int | bool | str) -> float | int | str:
    """NetCDF has no booleans."""
    return int(value) if isinstance(value, bool) else value


def _attributes(unit: Unit, name: str) -> dict[str, object]:
    """CF attributes of a variable."""
    variable = unit.variables[name]
    attributes: dict[str, object] = {"long_name": variable.description}
    if variable.unit:
        attributes["units"] = variable.unit
    if variable.items:
        attributes["flag_values"] = np.array(list(variable.items), dtype="i4")
        attributes["flag_meanings"] = " ".join(variable.items.values())
    return attributes


WRITERS: Mapping[str, Callable[[Path, Run, Unit], None]] = {".csv": _write_csv, ".nc": _write_netcdf}
