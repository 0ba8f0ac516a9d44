"""Runs a page's functions on symbols, and reads the names that they give to what they compute."""

import sys
from types import SimpleNamespace

from .errors import PACKAGE, reading
from .expressions import Expression, _checks_units

_locals_of = {}
"""Local variables of a page's functions by code object; nothing for functions that are not a page's."""


def _local_names(code):
    if code not in _locals_of:
        is_of_page = not code.co_filename.startswith(PACKAGE) and not code.co_name.startswith("<")
        _locals_of[code] = code.co_varnames[code.co_argcount :] if is_of_page else None
    return _locals_of[code]


def _read_names(frame, happening, result):
    """Give expressions the names of the local variables that hold them, as a function of a page returns."""
    if happening != "return" or result is None:
        return
    names = _local_names(frame.f_code)
    if names is None:
        return
    found = vars(result) if isinstance(result, SimpleNamespace) else {}
    if names:
        values = frame.f_locals
        found = {name: values[name] for name in names if name in values} | found
    if isinstance(result, Expression):
        found = {**found, frame.f_code.co_name: result}
    for name, value in found.items():
        if isinstance(value, Expression) and not name.startswith("_"):
            value.call(name)


def trace(function, *arguments, name=None):
    """Run a function of a page; local variables and members of records give their names to expressions."""
    before, checked = sys.getprofile(), _checks_units[0]
    sys.setprofile(_read_names)
    _checks_units[0] = True
    try:
        with reading(function, name or getattr(function, "__name__", "page")):
            return function(*arguments)
    finally:
        sys.setprofile(before)
        _checks_units[0] = checked
