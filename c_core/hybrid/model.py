"""The language of pages: quantities, coordinates, modes, events and outputs of a hybrid model.

A page is a class. Its quantities are declared like fields, its laws are functions of the model at an instant,
and decorators mark the functions that give rates, decide at events or report.
"""

import functools
import inspect
import math
import operator
import sys
from types import SimpleNamespace as Record
from typing import ClassVar

from .errors import PageError, caller, page_error, similar
from .expressions import Condition, Expression, lift, selected
from .units import dimension_of

__all__ = [
    "Model", "Record", "atan2", "clock", "coordinates", "cos", "event", "exp", "expm1", "input", "letters",
    "log", "log1p", "mode", "observe", "on_set", "output", "parameter", "radians", "require", "select",
    "setting", "sin", "sqrt", "state",
]  # fmt: skip

radians = math.radians
BOUNDS = {
    "least": ("at least", operator.ge),
    "above": ("above", operator.gt),
    "most": ("at most", operator.le),
    "below": ("below", operator.lt),
}


def _function(name):
    def of(*numbers):
        numpy = sys.modules.get("numpy")
        if any(isinstance(x, Expression) for x in numbers):
            numbers = [lift(x) for x in numbers]
        elif numpy and any(isinstance(x, numpy.ndarray) for x in numbers):
            return getattr(numpy, {"atan2": "arctan2"}.get(name, name))(*numbers)
        first, *others = numbers
        return getattr(first, name)(*others) if hasattr(first, name) else getattr(math, name)(*numbers)

    of.__name__, of.__doc__ = name, f"`{name}` of a number, an array, an interval or an expression."
    return of


sqrt, sin, cos, exp, log, expm1, log1p, atan2 = map(
    _function, ("sqrt", "sin", "cos", "exp", "log", "expm1", "log1p", "atan2")
)


def select(condition, if_true, if_false):
    """One of two numbers, by a condition. To choose a mode or a word, use `if` instead."""
    if isinstance(condition, Condition):
        return selected(condition.sign, condition.a, condition.b, lift(if_true), lift(if_false))
    if hasattr(condition, "shape") and condition.shape:
        return sys.modules["numpy"].where(condition, if_true, if_false)
    return if_true if condition else if_false


# ---- quantities ----------------------------------------------------------------------------------------


class Quantity(Record):
    """A parameter, a setting, an input, a state or a clock: see the functions that declare them."""

    is_input = is_clock = False

    def __set_name__(self, page, name):
        if self.is_input:
            unit = f"{self.unit}/s" if self.unit else "1/s"
            rate = state(0, unit, f"Rate at which `{name}` is ramped")
            rate.location = self.location
            setattr(page, f"{name}_rate", rate)


def _declared(kind, value, unit, meaning, name, within, **more):
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
    if not all(BOUNDS[word][1](value, bound) for word, bound in within.items()):
        allowed = " and ".join(f"{BOUNDS[word][0]} {bound:g}" for word, bound in within.items())
        raise page_error(quantity, name, f"starts at {value:g}; it must be {allowed}")
    quantity.value = float(value)


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
    return _declared("state", value, unit, meaning, name, within, role="state", of=of, values=values)


def clock(meaning="Time"):
    """The time, a state with rate 1 in every mode."""
    return _declared("state", 0.0, "s", meaning, None, {}, role="clock", is_clock=True)


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


# ---- functions of a page -------------------------------------------------------------------------------


def _marked(**marks):
    def mark(function):
        if not callable(function):
            raise page_error(caller(), str(function), "is marked, but it is no function")
        vars(function).update(marks)
        return function

    return mark


def _words(text, what):
    if not isinstance(text, str):
        raise page_error(caller(), what, f"is given {text!r}; it takes words in one string")
    return text.split()


def mode(words="", of=None, ends=False, time_scale=None):
    """Mark the function that gives the rates of the states in a mode.

    Its `words` tell cases apart: each case that a run can reach becomes a mode of its own in C. `of` names
    its coordinates. `time_scale` is that of a law whose series does not show it: steps are at most three
    times as long. A mode that `ends` the run has no rates.
    """
    return _marked(is_mode=True, words=_words(words, "mode"), ends=ends, time_scale=time_scale, of=of)


def coordinates(name):
    """Mark the function that gives one set of coordinates from any other."""
    return _marked(gives_coordinates=name)


def event(modes, when, unit="1", only=None, crossing=None, counted=True, **words):
    """Mark the decision at an event, which is due where `when` falls through 0 or a mode begins below 0.

    `words` restrict the event to some cases of the modes. If `only` does not hold where a mode begins, the
    event is not watched there. If `crossing` holds, `when` must cross 0. The function returns the model after
    the event. `counted` tells `leaving` whether the event counts; bookkeeping does not.
    """
    case = {word: value if isinstance(value, tuple) else (value,) for word, value in words.items()}
    marks = {"when": when, "unit": unit, "only": only, "crossing": crossing, "counted": counted, "case": case}
    return _marked(is_event=True, modes=_words(modes, "event"), **marks)


def on_set(names):
    """Mark what else changes when an importer sets one of these quantities.

    The function takes the model before and after the change, and returns the one before with its changes.
    """
    return _marked(is_on_set=True, sets=_words(names, "on_set"))


def require(name, allowed):
    """Mark a number that must not be negative at a start; `allowed` says what the variable has to be."""
    return _marked(is_required=True, of_variable=name, allowed=allowed)


def output(unit="1", meaning="", name=None, kind=float, of=None):
    """Mark a function whose value is reported; or declare an output `of` a function, with its meaning.

    The kind is float, int, bool, a tuple of names for the values 1, 2, ..., or `letters`.
    """
    mark = _marked(is_output=True, unit=unit, name=name, kind_of_value=kind)
    if of is None:
        return mark
    of.__doc__ = meaning
    return mark(of)


def observe(modes, part, into, unit="1"):
    """Mark a quantity whose "positive integral" or "largest" value goes into a state."""
    return _marked(is_observed=True, modes=_words(modes, "observe"), part=part, unit=unit, into=into)


class _Body(dict):
    """Namespace of a page's class, in which a second declaration of a name is an error."""

    def __setitem__(self, name, value):
        old = self.get(name)
        if isinstance(old, Quantity) or any(mark in vars(old) for mark in MARKS if hasattr(old, "__dict__")):
            raise page_error(caller(), name, "is declared twice")
        super().__setitem__(name, value)
        if name == "start":
            super().__setitem__("start_at", caller())


NAME_LIMIT = 60
MARKS = ("is_mode", "is_event", "is_output", "is_observed", "is_on_set", "is_required", "gives_coordinates")


class _Page(type):
    """Metaclass of pages, which checks the declared names."""

    @classmethod
    def __prepare__(cls, name, bases, **_):
        return _Body()

    def __new__(cls, name, bases, body, **more):
        for own, value in body.items():  # what overrides a mode or an event is one, too
            inherited = next((getattr(base, own) for base in bases if hasattr(base, own)), None)
            if inspect.isfunction(value) and inspect.isfunction(inherited):
                vars(value).update({**vars(inherited), **vars(value)})
        new = super().__new__(cls, name, bases, dict(body), **more)
        for own, value in body.items():
            if isinstance(value, Quantity) or any(hasattr(value, mark) for mark in MARKS):
                if bases and own in vars(Model):
                    raise page_error(value, own, "is a word of the language; choose another name")
                if own.startswith("_") or not own.isascii() or len(own) > NAME_LIMIT:
                    text = f"cannot be a name: use at most {NAME_LIMIT} letters, digits and _, a letter first"
                    raise page_error(value, own, text)
        for own, value in vars(new).items():
            if isinstance(value, Quantity):
                check_quantity(own, value)
        for own in dict.fromkeys(n for base in new.__mro__ for n in vars(base)):
            declared = [base for base in new.__mro__ if isinstance(vars(base).get(own), Quantity)]
            if len(declared) > 1 and not issubclass(declared[0], declared[1]) and own not in body:
                text = f"is declared by the parts {declared[0].__name__} and {declared[1].__name__}"
                raise page_error(vars(declared[0])[own], own, text)
        return new


class Model(metaclass=_Page):
    """The base of a page. A subclass overrides what differs; a number in place of a quantity fixes it."""

    start = "", {}
    """The mode in which runs start, and its words."""
    scales: ClassVar = {}
    """Typical size of quantities by unit, as functions of the parameters; 1 by default."""
    prefix = ""
    """Prefix that a part gives to the names of its quantities in a unit."""
    decayed = 60
    """Exponent beyond which exp(-x) counts as 0, because it is far below rounding."""

    def __init_subclass__(cls):
        for name in list(vars(cls)):
            value = vars(cls)[name]
            is_fixed = not isinstance(value, Quantity) or value.kind != "state"
            if is_fixed and any(getattr(vars(base).get(name), "is_input", False) for base in cls.__mro__[1:]):
                setattr(cls, f"{name}_rate", 0)

    @classmethod
    @functools.cache
    def members(cls):
        """Everything that the page declares, by name, in the order of the page."""
        names = dict.fromkeys(name for base in reversed(cls.__mro__) for name in vars(base))
        return {name: inspect.getattr_static(cls, name) for name in names}

    @classmethod
    @functools.cache
    def marked(cls, mark):
        """Functions of the page with a mark, by name, in the order of the page."""
        return {name: function for name, function in cls.members().items() if hasattr(function, mark)}

    @classmethod
    @functools.cache
    def quantities(cls, kind):
        """Quantities of a kind by name, in the order of the page."""
        found = cls.members().items()
        return {name: q for name, q in found if isinstance(q, Quantity) and q.kind == kind}

    @classmethod
    def public(cls, name):
        """The name in a unit: `name=` of the declaration, else the name with the prefix of its part."""
        declared = [base for base in cls.__mro__ if name in vars(base)]
        for base in declared:
            if getattr(vars(base)[name], "name", None):
                return vars(base)[name].name
        prefix = vars(declared[-1]).get("prefix", "")
        return f"{prefix}.{name}" if prefix else name

    @classmethod
    def at(cls, mode, **values):
        """The model at an instant of a mode, with these values of words, parameters and states."""
        new = object.__new__(cls)
        for kind in ("parameter", "state"):
            vars(new).update({name: q.value for name, q in cls.quantities(kind).items()})
        unknown = [n for n in values if not hasattr(cls, n) and n not in cls.all_words()]
        if unknown:
            known = similar(unknown[0], vars(new))
            raise PageError(f"is given `{unknown[0]}`, which it does not have{known}")
        vars(new).update(values, mode=mode)
        return new.without_other_coordinates()

    @classmethod
    @functools.cache
    def all_words(cls):
        """The words of all modes."""
        return {word for function in cls.marked("is_mode").values() for word in function.words}

    def without_other_coordinates(self):
        """Remove the states that the mode's coordinates do not have."""
        seen_in = self.seen_in
        for name, quantity in self.quantities("state").items():
            if quantity.of and seen_in not in quantity.of:
                setattr(self, name, Absent(name, self.mode))
        return self

    @property
    def seen_in(self):
        """The set of coordinates of the mode."""
        return getattr(self.marked("is_mode").get(self.mode), "of", None)

    def in_coordinates(self, name):
        """The values of another set of coordinates, as a mapping."""
        for give in self.marked("gives_coordinates").values():
            if give.gives_coordinates == name:
                return give(self)
        raise PageError(f"needs the coordinates `{name}`, which no function of the page gives")

    def to(self, mode, **changes):
        """The model in another mode, with other words and states, in the coordinates of that mode."""
        modes = self.marked("is_mode")
        if mode not in modes:
            raise PageError(f"goes to `{mode}`, which is no mode of the page{similar(mode, modes)}")
        allowed = self.quantities("state").keys() | self.all_words()
        for name in changes:
            if name not in allowed and not hasattr(type(self), name):
                text = f"changes `{name}`, which is neither a state nor a word{similar(name, allowed)}"
                raise PageError(text)
            if name in self.quantities("parameter"):
                raise PageError(f"changes the parameter `{name}`; only a state can change")
        changes = {name: value for name, value in changes.items() if name in allowed}  # others are fixed
        new, of = object.__new__(type(self)), modes[mode].of
        vars(new).update(vars(self))
        is_same = of == self.seen_in
        if not is_same:
            vars(new).update(self.in_coordinates(of) if of else {})
        vars(new).update(changes, mode=mode)
        return new if is_same else new.without_other_coordinates()

    def margin_of(self, unit):
        """Margin of decisions about a quantity in this unit."""
        return 1e-12 * self.scales.get(unit, lambda model: 1)(self)

    def replace(self, **changes):
        """The model in the same mode, with other words and states."""
        return self.to(self.mode, **changes)

    def leaving(self, counted):
        """The model before the decision of any event, with what all events record. `counted` is 1 or 0."""
        return self
