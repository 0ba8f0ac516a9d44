"""Errors of a page, each with the file, the line and the name that it is about."""

import difflib
import sys
from contextlib import contextmanager
from pathlib import Path

PACKAGE = str(Path(__file__).parent)
returned = {}
"""The line at which a function of a page last returned, by the file and line of its beginning."""


class PageError(Exception):
    """A page cannot be read. The message begins with the file and line to change."""

    is_located = False


class Undecided(BaseException):
    """Leaves a page's function at a comparison without an answer; the caller then explores both answers."""


def caller():
    """File and line of the page that is calling the language."""
    frame = sys._getframe(1)
    while frame.f_code.co_filename.startswith(PACKAGE):
        frame = frame.f_back
    return frame.f_code.co_filename, frame.f_lineno


def location_of(declared):
    """File and line where a function returned, or begins if it did not, or where a quantity is declared."""
    if code := getattr(declared, "__code__", None):
        begin = code.co_filename, code.co_firstlineno
        return begin[0], returned.get(begin, begin[1])
    return getattr(declared, "location", None)


def page_error(location, name, text):
    """An error that starts with its location and name. A location may be given as what is declared there."""
    location = location if isinstance(location, tuple) else location_of(location)
    where = f"{location[0]}:{location[1]}: " if location else ""
    error = PageError(f"{where}`{name}` {text}")
    error.is_located = True
    return error


def similar(name, names):
    """The question "did you mean ...?" where a known name resembles a mistyped one."""
    found = difflib.get_close_matches(str(name), list(names), 1)
    return f"; did you mean `{found[0]}`?" if found else ""


def check_known(location, name, value, known, what):
    """Refuse a value that is not among the known ones. `what` says what is wrong, with `{}` for the value."""
    if value not in known:
        text = what.format(f"`{value}`")
        raise page_error(location, name, f"{text}{similar(value, known)}")


@contextmanager
def reading(function, name):
    """Turn every exception of a page's function into a PageError at the line that raised it."""
    try:
        yield
    except Exception as error:
        if getattr(error, "is_located", False):
            raise
        location, traceback = location_of(function), error.__traceback__
        while traceback:
            code = traceback.tb_frame.f_code
            if not code.co_filename.startswith(PACKAGE) and code.co_filename.endswith(".py"):
                location = code.co_filename, traceback.tb_lineno
            traceback = traceback.tb_next
        raise page_error(location, name, _in_words(error)) from error


def _in_words(error):
    if isinstance(error, PageError):
        return str(error)
    if isinstance(error, RecursionError):
        return "calls itself without end"
    if isinstance(error, ArithmeticError):
        return f"cannot be computed: {error}"
    if isinstance(error, AttributeError) and getattr(error, "name", None) and error.obj is not None:
        names = [n for n in dir(error.obj) if not n.startswith("_")]
        return f"reads `{error.name}`, which it does not have here{similar(error.name, names)}"
    return f"raises {type(error).__name__}: {error}"
