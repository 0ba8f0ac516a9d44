"""A file is written whole or not at all: beside its destination first, then moved there."""

import contextlib
import csv
import errno
import os
import re
import secrets
import stat
import tempfile
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

from ..checks import path_of
from ..errors import InputError, RunError, reason
from ..uninterrupted import uninterrupted

LONGEST_CELL = 100
"""Characters: no number needs as many."""
DECIMAL_COMMA = re.compile(r"([+-]?\d*),(\d+)([^.]*)$")
DECIMAL_POINT = re.compile(r"[+-]?\d*\.\d*(e[+-]?\d+)?( .*)?$", re.IGNORECASE)
SEPARATORS = {",": ",", ";": ";", "\t": "a tabulator"}
"""Separators of cells, and their names in messages. The first one in a header counts: it has no numbers."""


def cells_of(lines: Iterable[tuple[int, str]], where: str) -> list[tuple[int, list[str]]]:
    """The cells of lines of which the first is the header; it says what is between cells."""
    found: list[tuple[int, list[str]]] = []
    separator = ","
    for number, line in lines:
        if not found:
            separator = next((mark for mark in SEPARATORS if mark in line), separator)
        _check_lengths(line, separator, f"{where}, line {number}")
        try:
            (row,) = csv.reader([line], delimiter=separator, skipinitialspace=True, strict=True)
        except (csv.Error, ValueError) as problem:
            raise InputError(
                f"{where}, line {number}: {problem}; allowed: cells with {SEPARATORS[separator]} between"
            ) from None
        found.append((number, [cell.strip() for cell in row]))
    return found if separator == "," else _with_points(found, where)


def _check_lengths(line: str, separator: str, here: str) -> None:
    for column, cell in enumerate(line.split(separator), start=1):
        if len(cell) > LONGEST_CELL:
            raise InputError(
                f"{here}, column {column}: a cell of {len(cell):,} characters; allowed: {LONGEST_CELL}"
            )


def _with_points(lines: list[tuple[int, list[str]]], where: str) -> list[tuple[int, list[str]]]:
    """The cells with decimal commas turned into points; a table with both decimal signs is refused."""
    with_point = next((cell for _, row in lines for cell in row if DECIMAL_POINT.match(cell)), None)
    for number, row in lines:
        for column, cell in enumerate(row):
            match = DECIMAL_COMMA.match(cell)
            if match is None:
                continue
            if with_point is not None:
                raise InputError(
                    f"{where}, line {number}: {cell} in a table that has {with_point}, too; allowed: a comma "
                    "or a point for the decimal sign, and nothing between thousands"
                )
            row[column] = f"{match[1]}.{match[2]}{match[3]}"
    return lines


@contextmanager
def whole(path: Path) -> Iterator[Path]:
    """A path to write to, beside `path` and with its suffix; moved to `path` at the end, gone after an error.

    Where `path` is a symbolic link, its target is written. A file that is replaced hands on its mode and its
    owner. Raises RunError where the file cannot be written, as on a full disk.
    """
    resolved = destination(path, str(path))
    try:
        beside = _created(resolved, path.suffix)
    except OSError as problem:
        raise not_written(path, problem) from problem
    try:
        yield beside
        _flush(beside, os.O_RDWR)
        _hand_on_mode(resolved, beside)
        os.replace(beside, resolved)
        if os.name == "posix":  # elsewhere a folder cannot be opened
            _flush(resolved.parent, os.O_RDONLY)
    except OSError as problem:
        raise not_written(path, problem) from problem
    finally:
        beside.unlink(missing_ok=True)


def not_written(path: Path, problem: OSError) -> RunError:
    """The error about a file that could not be written, as on a full disk, though it was allowed."""
    return RunError(f"{path}: cannot be written: {problem.strerror or problem}")


def write_whole(path: Path, write: Callable[[Path], object]) -> None:
    """Write a file, given how; an interrupt from the keyboard waits until the file is there."""

    def work() -> None:
        with whole(path) as beside:
            write(beside)

    uninterrupted(work)


def _created(resolved: Path, suffix: str) -> Path:
    """An empty file beside a path, with the mode of new files, or private if it will get an old mode."""
    mode = 0o600 if resolved.exists() else 0o666  # less what the process's mask takes away
    while True:
        beside = resolved.with_name(f".tdmf-slip-{secrets.token_hex(8)}{suffix}")
        with contextlib.suppress(FileExistsError):
            os.close(os.open(beside, os.O_CREAT | os.O_EXCL | os.O_WRONLY, mode))
            return beside


def _hand_on_mode(resolved: Path, beside: Path) -> None:
    """Give a file owner and mode of what it replaces, if there is such a file."""
    try:
        old = resolved.stat()
    except FileNotFoundError:
        return
    if hasattr(os, "chown"):  # not on Windows
        for owner, group in ((-1, old.st_gid), (old.st_uid, -1)):
            with contextlib.suppress(PermissionError):
                os.chown(beside, owner, group)
    os.chmod(beside, stat.S_IMODE(old.st_mode))


def _flush(resolved: Path, flags: int) -> None:
    """Flush a file to disk; otherwise its new name may be on the disk before its content."""
    handle = os.open(resolved, flags)
    try:
        os.fsync(handle)
    except OSError as problem:
        if problem.errno not in (errno.EINVAL, errno.ENOTSUP):  # some file systems cannot
            raise
    finally:
        os.close(handle)


def destination(path: Path, what: str) -> Path:
    """The file that a path stands for, be it there or not: through symbolic links."""
    resolved = Path(path)
    try:
        resolved = Path(os.path.realpath(path))
        kind = resolved.stat().st_mode
    except FileNotFoundError:
        return resolved
    except (OSError, ValueError) as problem:
        raise InputError(f"{what}: {reason(problem)}") from None
    if stat.S_ISDIR(kind):
        raise InputError(f"{what}: a folder; allowed: a file")
    if not stat.S_ISREG(kind):
        raise InputError(f"{what}: a pipe or device; allowed: a file")
    if not os.access(resolved, os.W_OK):
        raise InputError(f"{what}: cannot be written: {os.strerror(errno.EACCES)}")
    return resolved


def check_destination(path: Path | str, allowed: Iterable[str] | None, what: str) -> Path:
    """Refuse, before any work, a path that cannot be written, or whose suffix names none of some formats."""
    path = path_of(path, what, "the path of a file")
    if allowed is not None and path.suffix.lower() not in allowed:
        raise InputError(f"{what}: {path}: format {path.suffix or '(none)'}; allowed: {', '.join(allowed)}")
    resolved = destination(path, f"{what}: {path}")
    if not resolved.parent.is_dir():
        raise InputError(f"{what}: {path}: the folder {resolved.parent} does not exist")
    check_folder(resolved.parent, what)
    return path


def check_folder(folder: Path, what: str) -> None:
    """Refuse, before any work, a folder that nothing can be written to.

    One that is missing, in a folder that is there, is made, and goes again: if the work fails, nothing is
    left.
    """
    try:
        missing = not folder.exists()
        folder.mkdir(exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):  # to ask for leave alone is not enough where root asks
            pass
        if missing:
            folder.rmdir()
    except (OSError, ValueError) as problem:
        raise InputError(f"{what}: {folder}: cannot be written to: {reason(problem)}") from problem
