"""Dimensions of SI units, as powers of the base units, and dimensions of expressions."""

import functools
import re

from .errors import PageError

BASE = ["kg", "m", "s", "A", "K", "mol", "cd"]
ANY = None
"""Dimension of a bare number, which takes whatever unit its context needs."""


NONE = (0.0,) * len(BASE)
UNITS = dict.fromkeys(["1", "", "rad"], NONE)
UNITS |= {unit: tuple(float(unit == base) for base in BASE) for unit in BASE}
DERIVED = "N=kg.m/s2 J=N.m W=J/s Pa=N/m2 Hz=1/s C=A.s V=W/A Ohm=V/A"


@functools.cache
def times(a, b):
    """The dimension of a product."""
    return b if a is ANY else a if b is ANY else tuple(x + y for x, y in zip(a, b, strict=True))


@functools.cache
def power(a, exponent):
    """The dimension of a power."""
    return ANY if a is ANY else tuple(x * exponent for x in a)


SECOND = UNITS["s"]


def dimension_of(unit):
    """The dimension of a unit such as `N.m.s/rad`, `m/s2` or `1`."""
    above, *below = unit.split("/")
    found = NONE
    for sign, part in [(1, above), *((-1, part) for part in below)]:
        for factor in part.strip("()").split("."):
            name, exponent = re.fullmatch(r"([A-Za-z]*|1)(-?\d*)", factor).groups() if factor else ("", "")
            if name not in UNITS:
                known = f"allowed are {', '.join(u for u in UNITS if u)} and their products"
                raise PageError(f"has the unit `{unit}`, in which `{factor}` is no unit; {known}")
            found = times(found, power(UNITS[name], sign * int(exponent or 1)))
    return found


for _derived in DERIVED.split():
    _unit, _text = _derived.split("=")
    UNITS[_unit] = dimension_of(_text)


def text_of(dimension):
    """A dimension in base units, for messages."""
    names = ((name, x) for name, x in zip(BASE, dimension, strict=True) if x)
    return ".".join(name if x == 1 else f"{name}{x:g}" for name, x in names) or "1"


def _alike(dimensions, what):
    known = [d for d in dimensions if d is not ANY]
    if any(d != known[0] for d in known):
        raise PageError(f"{what} {' and '.join(dict.fromkeys(map(text_of, known)))}, which do not fit")
    return known[0] if known else ANY


def dimension_of_node(node, of):
    """The dimension of an operation on operands of the dimensions `of`."""
    match node.operation:
        case "number":
            return ANY
        case "*":
            return times(*of)
        case "/":
            return times(of[0], power(of[1], -1))
        case "+" | "-":
            return _alike(of, "adds or subtracts")
        case "sqrt":
            return power(of[0], 0.5)
        case "rate":
            return times(of[0], power(SECOND, -1))
        case "negative" | "abs":
            return of[0]
        case "looked_up" | "variation_looked_up":
            return of[1]
        case "select":
            _alike(of[:2], "compares")
            return _alike(of[2:], "selects between")
        case "atan2":
            _alike(of, "takes the angle of")
            return NONE
    if of[0] not in (ANY, NONE):
        raise PageError(f"takes `{node.operation}` of a quantity in {text_of(of[0])}; make it dimensionless")
    return NONE
