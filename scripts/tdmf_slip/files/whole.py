"""A file is written whole or not at all: beside its place first, then moved there."""

import contextlib
import errno
import os
import stat
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

from ..checks import check_kind
from ..errors import InputError
from ..terminal import interrupts


@contextmanager
def whole(path: Path) -> Iterator[Path]:
    """A path to write to, beside `path` and with its suffix; moved to `path` at the end, gone after an error.

    Where `path` is a symbolic link, its target is written. A file that is replaced hands on its mode and its
    owner. An interrupt from the keyboard waits until the file is there.

    Parameters
    ----------
    path : Path
        Where the file is to be.

    Yields
    ------
    Path
        Where to write.

    Raises
    ------
    InputError
        Nothing can be written there.
    """
    with interrupts.held():
        yield from _whole(path)


def _whole(path: Path) -> Iterator[Path]:
    place = destination(path, str(path))
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


def destination(path: Path, what: str) -> Path:
    """The file that a path stands for, be it there or not: through symbolic links.

    Raises
    ------
    InputError
        There is something else than a file, or one that may not be written.
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

    Parameters
    ----------
    path : Path or str
        Of a file that is to be written.
    allowed : iterable of str
        Suffixes, with their dots, in lower case.
    what : str
        The argument or option, for messages.

    Returns
    -------
    Path
        The path.

    Raises
    ------
    InputError
        Either, or its folder is not there.
    """
    check_kind(path, (str, os.PathLike), what, "the path of a file")
    path = Path(path)
    if path.suffix.lower() not in allowed:
        raise InputError(f"{what}: {path}: format {path.suffix or '(none)'}; allowed: {', '.join(allowed)}")
    place = destination(path, f"{what}: {path}")
    if not place.parent.is_dir():
        raise InputError(f"{what}: {path}: there is no folder {place.parent}; allowed: one that is there")
    check_folder(place.parent, what)
    return path


def check_folder(folder: Path, what: str) -> None:
    """Refuse, before any work, a folder that nothing can be written to.

    One that is missing, in a folder that is there, is made, and goes again: if the work fails, nothing is
    left.

    Parameters
    ----------
    folder : Path
        Where files are to be written.
    what : str
        The argument or option, for messages.

    Raises
    ------
    InputError
        It cannot be made or written to.
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
