"""Results as files. A file is written whole or not at all: beside its place first, then moved there.

NetCDF is made in memory and goes through Python's own files as everything does: its library knows neither
why a write failed nor names that are no UTF-8.
"""

import contextlib
import csv
import errno
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
    import netCDF4
    import xarray

IN_MEMORY = "memory.nc"
"""Name of a NetCDF file that is on no disk."""
FIRST_SIZE = 2**16
"""Bytes of such a one at first; it grows."""


@contextmanager
def whole(path: Path) -> Iterator[Path]:
    """A path to write to, beside `path` and with its suffix; moved to `path` at the end, gone after an error.

    Where `path` is a symbolic link, its target is written. A file that is replaced hands on its mode and its
    owner. An interrupt from the keyboard waits until the file is there.

    Raises:
        InputError: nothing can be written there.
    """
    with interrupts.held():
        yield from _whole(path)


def _whole(path: Path) -> Iterator[Path]:
    place = _destination(path, str(path))
    try:
        handle, name = tempfile.mkstemp(prefix=".tdmf-slip-", suffix=path.suffix, dir=place.parent)
        os.close(handle)
    except OSError as problem:
        raise InputError(f"{path}: cannot be written: {problem.strerror}") from problem
    try:
        yield Path(name)
        _hand_on_mode(place, name)
        os.replace(name, place)
    except OSError as problem:
        raise InputError(f"{path}: cannot be written: {problem.strerror or problem}") from problem
    finally:
        Path(name).unlink(missing_ok=True)


def _hand_on_mode(place: Path, name: str) -> None:
    """Give a file of mkstemp, which is private, owner and mode of what it replaces, or of a new file."""
    try:
        old = place.stat()
    except FileNotFoundError:
        os.chmod(name, 0o666 & ~_umask())
        return
    if hasattr(os, "chown"):  # not on Windows
        for owner, group in ((-1, old.st_gid), (old.st_uid, -1)):
            with contextlib.suppress(PermissionError):
                os.chown(name, owner, group)
    os.chmod(name, stat.S_IMODE(old.st_mode))


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def _destination(path: Path, what: str) -> Path:
    """The file that a path stands for, be it there or not: through symbolic links.

    Raises:
        InputError: there is something else than a file, or one that may not be written.
    """
    place = Path(os.path.realpath(path))
    try:
        kind = place.stat().st_mode
    except FileNotFoundError:
        return place
    except (OSError, ValueError) as problem:
        raise InputError(f"{what}: {getattr(problem, 'strerror', None) or problem}") from None
    if stat.S_ISDIR(kind):
        raise InputError(f"{what}: a folder; allowed: a file")
    if not stat.S_ISREG(kind):
        raise InputError(f"{what}: a pipe or device; allowed: a file")
    if not os.access(place, os.W_OK):
        raise InputError(f"{what}: cannot be written: {os.strerror(errno.EACCES)}")
    return place


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
    place = _destination(path, f"{what}: {path}")
    if not place.parent.is_dir():
        raise InputError(f"{what}: {path}: there is no folder {place.parent}; allowed: one that is there")
    check_folder(place.parent, what)
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
    from xarray.backends import NetCDF4DataStore

    with whole(path) as beside:
        dataset = _new_netcdf()
        data.dump_to_store(NetCDF4DataStore(dataset))
        beside.write_bytes(dataset.close())


def read_dataset(path: Path) -> "xarray.Dataset":
    """A dataset from a NetCDF file, all of it.

    Raises:
        InputError: there is something else than a file.
        OSError, ValueError: it cannot be read, or is no such file.
    """
    import xarray
    from netCDF4 import Dataset

    content = _destination(path, str(path)).read_bytes()
    return xarray.load_dataset(xarray.backends.NetCDF4DataStore(Dataset(IN_MEMORY, memory=content)))


def _new_netcdf() -> "netCDF4.Dataset":
    """One in memory, whose `close` gives its bytes."""
    from netCDF4 import Dataset  # slow to load, and seldom asked for

    return Dataset(IN_MEMORY, "w", memory=FIRST_SIZE)


def _write_csv(path: Path, run: Run, _unit: Unit) -> None:
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(run.table.dtype.names)
        writer.writerows(run.table.tolist())


def _write_netcdf(path: Path, run: Run, unit: Unit) -> None:
    dataset = _new_netcdf()
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
    path.write_bytes(dataset.close())


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
