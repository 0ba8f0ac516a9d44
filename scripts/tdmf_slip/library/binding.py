"""The C library, called from Python: all its public functions and structs, declared by its public headers.

::

    from tdmf_slip.library.binding import c, ffi

    parameters = c.tdmf_default_parameters()
    model = ffi.new("tdmf_model *")
    c.tdmf_model_create(model, ffi.new("tdmf_parameters *", parameters))

The headers are read when the package is built (scripts/declare_library.py), so that no declaration is
repeated here and none has to be parsed at each start.
"""

import os
import sys
from pathlib import Path
from typing import Any

from ..errors import InputError
from . import declarations

FOLDER = Path(__file__).parents[1] / "native"
PATH_VARIABLE = "TDMF_SLIP_LIBRARY"
NAMES = {"win32": "tdmf_slip_shared.dll", "darwin": "libtdmf_slip_shared.dylib"}


def library_path() -> Path:
    """Return the path of the C library, to which a program in C is linked.

    It is the file that the environment variable TDMF_SLIP_LIBRARY names, else the package's own. The folder
    of the latter also has the headers.

    Returns
    -------
    Path
        Path of a file that exists.

    Raises
    ------
    InputError
        There is no such file.

    Examples
    --------
    >>> import tdmf_slip
    >>> (tdmf_slip.library_path().parent / "tdmf_slip" / "tdmf_slip.h").is_file()
    True
    """
    override = os.environ.get(PATH_VARIABLE)
    path = Path(override) if override else FOLDER / NAMES.get(sys.platform, "libtdmf_slip_shared.so")
    if not path.is_file():
        wanted = f"{PATH_VARIABLE}: {override!r} is not a file" if override else f"{path} is missing"
        raise InputError(f"{wanted}; install the package with pip, or name the library that CMake built")
    return path


def _library() -> Any:
    """The library, loaded."""
    path = library_path()
    try:
        return ffi.dlopen(str(path))
    except OSError as problem:
        raise InputError(
            f"{path}: cannot be loaded as a library: {problem}; install the package with pip, "
            "or name the library that CMake built"
        ) from None


ffi: Any = declarations.ffi
"""Makes structs and arrays of the library's types."""
c: Any = _library()
"""The library's functions and enumerators, by their names in C."""


def text_of(characters: object) -> str:
    """A text of the library, a `char *`."""
    text: bytes = ffi.string(characters)
    return text.decode()


def check_accepted(refusal: Any, where: str = "") -> None:
    """Raise an `InputError` if the library refused a value, a `MemoryError` if there is too little memory.

    `where` begins the message.
    """
    if refusal.variable != ffi.NULL:
        text = ffi.new("char[256]")
        c.tdmf_refusal_text(ffi.new("tdmf_refusal *", refusal), text, len(text))
        error = MemoryError if refusal.code == c.TDMF_UNAVAILABLE else InputError
        raise error(f"{where}{text_of(text)}")
