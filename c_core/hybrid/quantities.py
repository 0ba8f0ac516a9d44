"""Quantities of a page: parameters, settings, inputs, states and clocks."""

import math
import operator
import sys
from types import SimpleNamespace as Record

from .errors import PageError, caller, page_error, similar
from .units import dimension_of

BOUNDS = {
    "least": ("at least", operator.ge),
    "above": ("above", operator.gt),
    "most": ("at most", operator.le),
    "below": ("below", operator.lt),
}


class Quantity(Record):
    """A parameter, a setting, an input, a state or a clock: see the functions that declare them."""

    is_input = is_clock = False

    def __set_name__(self, page, name):
        if self.is_input:
            unit = f"{self.unit}/s" if self.unit else "1/s"
            rate = state(0, unit, f"Rate at which `{name}` is ramped")
            rate.location = self.location
            setattr(page, f"{name}_rate", rate)


def checked_kind(kind, what):
    """The kind of a value, which is a type or a tuple of names."""
    if kind in (float, int, bool) or (isinstance(kind, tuple) and all(isinstance(n, str) for n in kind)):
        return kind
    text = "allowed are float, int, bool, a tuple of names and letters(...)"
    raise page_error(caller(), what, f"has the kind {getattr(kind, '__name__', repr(kind))}; {text}")


def _declared(kind, value, unit, meaning, name, within, **more):
    for text in (unit, meaning, name or ""):
        if not isinstance(text, str):
            order = "the order is value, unit, meaning, name"
            raise page_error(caller(), kind, f"is given {text!r} for a text; {order}")
    new = Quantity(kind=kind, value=value, unit=unit, meaning=meaning, name=name, within=within)
    vars(new).update({"location": caller(), "of": None, "values": float} | more)
    return new


def check_quantity(name, quantity):
    """Refuse an invalid declaration, and set the dimension of its unit."""
    value, within = quantity.value, quantity.within
    try:
        quantity.dimension = dimension_of(quantity.unit)
    except PageError as error:
        raise page_error(quantity, name, str(error)) from None
    for word in within:
        if word not in BOUNDS:
            raise page_error(quantity, name, f"has `{word}`, which is no bound{similar(word, BOUNDS)}")
    if not isinstance(value, (int, float)) or not math.isfinite(value):
        raise page_error(quantity, name, f"starts at {value!r}; it has to be a finite number")
    check_bounds(quantity, name, value, within, "starts at")
    quantity.value = float(value)


def check_bounds(location, name, value, within, how):
    """Refuse a number out of bounds."""
    if not all(BOUNDS[word][1](value, bound) for word, bound in within.items()):
        allowed = " and ".join(f"{BOUNDS[word][0]} {bound:g}" for word, bound in within.items())
        raise page_error(location, name, f"{how} {value:g}; it must be {allowed}")


def check_fixed(location, name, value, quantity):
    """Refuse what a subclass has in place of a quantity and is no number that the quantity may be."""
    if not isinstance(value, (int, float)) or not math.isfinite(value):
        given = getattr(value, "__qualname__", repr(value))
        text = f"is {given} in place of the {quantity.kind} that it was; a finite number fixes it"
        raise page_error(location, name, text)
    check_bounds(location, name, value, quantity.within, "is fixed at")


def range_of(quantity):
    """The least and the most number that a quantity may be."""
    within, largest = quantity.within, sys.float_info.max
    least = max(within.get("least", -largest), math.nextafter(within.get("above", -math.inf), math.inf))
    return least, min(within.get("most", largest), math.nextafter(within.get("below", math.inf), -math.inf))


def parameter(value, unit="1", meaning="", name=None, tunable=False, **within):
    """A number that is constant in a run: its default, unit, meaning and bounds (least, above, most, below).

    A `tunable` one may change at an event of the importer. A default of `True` or `False` declares a
    Boolean, which counts as 1 or 0.
    """
    values = bool if isinstance(value, bool) else float
    role = "tunable" if tunable else "fixed"
    return _declared("parameter", value, unit, meaning, name, within, role=role, values=values)


def setting(value=0.0, unit="1", meaning="", name=None, **within):
    """A discrete input, which is constant between the changes that an importer makes."""
    return _declared("parameter", value, unit, meaning, name, within, role="setting")


def input(value=0.0, unit="1", meaning="", name=None, **within):
    """A continuous input, which every mode moves at the held rate `<name>_rate`, 0 by default."""
    return _declared("state", value, unit, meaning, name, within, role="input", is_input=True)


def state(value=0.0, unit="1", meaning="", name=None, of=None, values=float, **within):
    """A state and its start value. It is constant ("held") in modes that give it no rate.

    `of` names the sets of coordinates that it belongs to; without it the state is in all of them. `values`
    is the kind of its values, as in `output`.
    """
    of = tuple(of.split()) if of else None
    values = checked_kind(values, "state")
    return _declared("state", value, unit, meaning, name, within, role="state", of=of, values=values)


def clock(meaning="Time", held_in=""):
    """The time, a state with rate 1 in every mode.

    If states are named that hold times of it, a unit counts it from the start of its run, so that durations
    keep their digits however late that is. Such a state is negative as long as it holds no time.
    """
    given = {"role": "clock", "is_clock": True, "held_in": held_in.split()}
    return _declared("state", 0.0, "s", meaning, None, {}, **given)


def letters(alphabet):
    """The kind of a text output: each digit of the number stands for a letter of the alphabet."""
    return ("letters", alphabet)


class Absent:
    """Placeholder of a state that the coordinates of a mode do not have; reading it is an error."""

    __array_ufunc__ = None

    def __init__(self, name, mode):
        self.name, self.mode = name, mode

    def refuse(self, *_):
        raise PageError(f"reads `{self.name}` in the mode `{self.mode}`, whose coordinates do not have it")

    __add__ = __radd__ = __sub__ = __rsub__ = __mul__ = __rmul__ = __truediv__ = __rtruediv__ = refuse
    __neg__ = __abs__ = __pow__ = __rpow__ = __lt__ = __le__ = __gt__ = __ge__ = __float__ = __bool__ = refuse
