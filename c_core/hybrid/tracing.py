"""Runs a page's functions on symbols, and names expressions after the page's local variables."""

import sys
from types import SimpleNamespace

from .errors import PACKAGE, reading, returned
from .expressions import Expression, _checks_units


def _read_names(frame, happening, result):
    """Name expressions after local variables, when a function of a page returns; note the line."""
    code = frame.f_code
    if happening != "return" or code.co_filename.startswith(PACKAGE):
        return
    returned[code.co_filename, code.co_firstlineno] = frame.f_lineno
    if result is None or code.co_name.startswith("<"):
        return
    names = code.co_varnames[code.co_argcount :]
    values = frame.f_locals if names else {}
    found = {name: values[name] for name in names if name in values}
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
