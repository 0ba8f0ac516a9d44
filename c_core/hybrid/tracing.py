"""Runs a page's functions on symbols, and names expressions after the page's local variables."""

import sys
from types import SimpleNamespace

from .errors import PACKAGE, reading
from .expressions import Expression, _checks_units

_locals_of = {}
"""Local variables by code object; None for functions that belong to no page."""


def _read_names(frame, happening, result):
    """Name expressions after local variables, when a function of a page returns."""
    code = frame.f_code
    if happening != "return" or result is None:
        return
    if code not in _locals_of:
        is_of_page = not code.co_filename.startswith(PACKAGE) and not code.co_name.startswith("<")
        _locals_of[code] = code.co_varnames[code.co_argcount :] if is_of_page else None
    if _locals_of[code] is None:
        return
    values = frame.f_locals if _locals_of[code] else {}
    found = {name: values[name] for name in _locals_of[code] if name in values}
    found |= vars(result) if isinstance(result, SimpleNamespace) else {}
    if isinstance(result, Expression):
        found[code.co_name] = result
    for name, value in found.items():
        if isinstance(value, Expression) and not name.startswith("_"):
            value.call(name)


def trace(function, *arguments, name=None):
    """Run a function of a page; expressions take the names of local variables and record members."""
    before, checked = sys.getprofile(), _checks_units[0]
    sys.setprofile(_read_names)
    _checks_units[0] = True
    try:
        with reading(function, name or getattr(function, "__name__", "page")):
            return function(*arguments)
    finally:
        sys.setprofile(before)
        _checks_units[0] = checked
