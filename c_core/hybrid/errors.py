"""Errors of a page, each with the file, the line and the name that it is about."""

import difflib
import sys
from contextlib import contextmanager
from pathlib import Path

PACKAGE = str(Path(__file__).parent)


class PageError(Exception):
    """A page cannot be read; the message begins with the file and the line that have to change."""


class Undecided(BaseException):
    """Leaves a page's function at a comparison that has no answer yet; the caller explores both."""


def caller():
    """File and line of the page that is calling the language."""
    frame = sys._getframe(1)
    while frame.f_code.co_filename.startswith(PACKAGE):
        frame = frame.f_back
    return frame.f_code.co_filename, frame.f_lineno


def location_of(function):
    """File and line where a function of a page begins."""
    code = getattr(function, "__code__", None)
    return (code.co_filename, code.co_firstlineno) if code else None


def page_error(location, name, text):
    """The error at a location, about what has this name."""
    where = f"{location[0]}:{location[1]}: " if location else ""
    return PageError(f"{where}`{name}` {text}")


def similar(name, names):
    """A question for somebody who may have mistyped one of the names."""
    found = difflib.get_close_matches(str(name), list(names), 1)
    return f"; did you mean `{found[0]}`?" if found else ""


@contextmanager
def reading(function, name):
    """Turn whatever goes wrong in a page's function into an error of the page, at the line that did it."""
    try:
        yield
    except PageError as error:
        if getattr(error, "is_located", False):
            raise
        located = _located(error, function, name)
        raise located from None
    except RecursionError as error:
        raise _located("calls itself without end", function, name) from error
    except ArithmeticError as error:
        raise _located(f"cannot be computed: {error}", function, name, error) from error
    except Exception as error:
        raise _located(_in_words(error), function, name, error) from error


def _in_words(error):
    if isinstance(error, AttributeError) and getattr(error, "name", None) and error.obj is not None:
        names = [n for n in dir(error.obj) if not n.startswith("_")]
        return f"reads `{error.name}`, which it does not have here{similar(error.name, names)}"
    return f"raises {type(error).__name__}: {error}"


def _located(error, function, name, raised=None):
    location, traceback = location_of(function), getattr(raised or error, "__traceback__", None)
    while traceback:
        code = traceback.tb_frame.f_code
        if not code.co_filename.startswith(PACKAGE) and code.co_filename.endswith(".py"):
            location = code.co_filename, traceback.tb_lineno
        traceback = traceback.tb_next
    located = page_error(location, name, error if isinstance(error, str) else str(error))
    located.is_located = True
    return located
