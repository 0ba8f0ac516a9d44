"""The language of pages: quantities, coordinates, modes, events and outputs of a hybrid model.

A page is a class. Its quantities are declared like fields, its laws are functions of the model at an instant,
and decorators mark the functions that give rates, decide at events or report.
"""

import functools
import inspect
from types import SimpleNamespace as Record
from typing import ClassVar

from .errors import PageError, caller, page_error, similar
from .expressions import Expression, _looks_up, lift, looked_up
from .functions import atan2, cos, exp, expm1, log, log1p, radians, select, sin, sqrt
from .limits import MARGINS
from .quantities import (
    Absent,
    Quantity,
    check_fixed,
    check_quantity,
    checked_kind,
    clock,
    input,
    letters,
    parameter,
    setting,
    state,
)
from .units import ANY, dimension_of, text_of

__all__ = [
    "Model", "Record", "atan2", "clock", "coordinates", "cos", "event", "exp", "expm1", "input", "letters",
    "log", "log1p", "mode", "observe", "on_set", "output", "parameter", "radians", "require", "section",
    "select", "setting", "sin", "sqrt", "state", "table",
]  # fmt: skip


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


def mode(words="", of=None, ends=False, keeps_outputs=False, time_scale=None):
    """Mark the function that gives the rates of the states in a mode.

    Its `words` tell cases apart: each case that a run can reach becomes a mode of its own in C. `of` names
    its coordinates. `time_scale` is that of a law whose series does not show it: steps are at most three
    times as long. A mode that `ends` the run has no rates. With `keeps_outputs`, a unit goes on to show the
    outputs of the mode before.
    """
    marks = {"ends": ends, "keeps_outputs": keeps_outputs, "time_scale": time_scale, "of": of}
    return _marked(is_mode=True, words=_words(words, "mode"), **marks)


def coordinates(name):
    """Mark the function that gives one set of coordinates from any other."""
    return _marked(gives_coordinates=name)


def event(modes, when=None, unit="1", only=None, crossing=None, counted=True, closely=False, **words):
    """Mark the decision at an event, which is due where `when` falls through 0 or a mode begins below 0.

    `words` restrict the event to some cases of the modes. If `only` does not hold where a mode begins, the
    event is not watched there. If `crossing` holds, `when` must cross 0. The function returns the model after
    the event. `leaving` receives 1 if the event is `counted`, else 0; bookkeeping is not counted. A long step
    errs by the tolerance: an event that is located `closely`, as one that ends a run is, is taken only where
    a step that begins close to it finds it, too, and `when` falls in almost a straight line.
    """
    case = {word: value if isinstance(value, tuple) else (value,) for word, value in words.items()}
    modes = _words(modes, "event")
    for name, given in (("when", when), ("only", only), ("crossing", crossing)):
        if not callable(given) and (name == "when" or given is not None):
            text = f"is given {name}={given!r}; it takes a function of the model, such as lambda m: m.height"
            raise page_error(caller(), "event", text)
    marks = {"when": when, "unit": unit, "only": only, "crossing": crossing, "counted": counted, "case": case}
    return _marked(is_event=True, modes=modes, closely=closely, **marks)


def on_set(names):
    """Mark the function that changes other states when an importer sets one of these quantities.

    The function takes the model before and after the jump of the quantity. It returns the model before the
    jump with the other states changed.
    """
    return _marked(is_on_set=True, sets=_words(names, "on_set"))


def section(event, coordinates):
    """Mark the function that starts a run on a section: the model at the start, and a point of the section.

    A return map goes from the section to its next `event`. `coordinates` are states that the event writes.
    The function gets the model where runs start and a record of coordinates. It returns that model with
    states from which the run goes on as if the event had just been taken at these coordinates.
    """
    return _marked(is_section=True, event=event, coordinates=_words(coordinates, "section"))


def table(**columns):
    """Mark the function that gives a row of a table as a mapping; `columns` gives the unit of each entry.

    Decisions look rows up by `row_of`. A run may supply a table of its own in place of the page's rows.
    """
    return _marked(is_table=True, columns=columns)


def require(name, allowed):
    """Mark a number that must not be negative at a start; `allowed` says what the variable has to be."""
    return _marked(is_required=True, of_variable=name, allowed=allowed)


def output(unit="1", meaning="", name=None, kind=float, of=None):
    """Mark a function whose value is reported; or declare an output `of` a function, with its meaning.

    The kind is float, int, bool, a tuple of names for the values 1, 2, ..., a dictionary of these names with
    their meanings, or `letters`.
    """
    items, kind = (kind, tuple(kind)) if isinstance(kind, dict) else ({}, kind)
    kind = checked_kind(kind, "output")
    mark = _marked(is_output=True, unit=unit, name=name, kind_of_value=kind, items=items)
    if of is None:
        return mark
    of.__doc__ = meaning
    return mark(of)


def observe(modes, part, into, unit="1", usual=True):
    """Mark a quantity whose "positive integral" or "largest" value goes into a state.

    One that is not usual is observed only in runs that ask for all observed quantities.
    """
    return _marked(
        is_observed=True, modes=_words(modes, "observe"), part=part, unit=unit, into=into, is_usual=usual
    )


class _Body(dict):
    """Namespace of a page's class, in which a second declaration of a name is an error.

    `places` has the file and line of each name.
    """

    def __init__(self):
        super().__init__()
        self.places = {}

    def __setitem__(self, name, value):
        old = self.get(name)
        if isinstance(old, Quantity) or any(mark in vars(old) for mark in MARKS if hasattr(old, "__dict__")):
            raise page_error(caller(), name, "is declared twice")
        super().__setitem__(name, value)
        self.places[name] = caller()


NAME_LIMIT = 60
OVERRIDABLE = "start", "scales", "nominals", "prefix", "decayed", "leaving"
"""Names of `Model` that a page may set."""
MARKS = (
    "is_mode", "is_event", "is_output", "is_observed", "is_on_set", "is_required", "is_section", "is_table",
    "gives_coordinates",
)  # fmt: skip


class _Page(type):
    """Metaclass of pages, which checks the declared names."""

    @classmethod
    def __prepare__(cls, name, bases, **_):
        return _Body()

    def __new__(cls, name, bases, body, **more):
        for own, value in body.items():  # an overridden mode stays a mode
            inherited = next((getattr(base, own) for base in bases if hasattr(base, own)), None)
            if inspect.isfunction(value) and inspect.isfunction(inherited):
                vars(value).update({**vars(inherited), **vars(value)})
        new = super().__new__(cls, name, bases, dict(body), **more)
        new._places = body.places
        for own, value in body.items():
            is_declared = isinstance(value, Quantity) or any(hasattr(value, mark) for mark in MARKS)
            is_word = bases and own in {*vars(Model), "COUNT"} and not own.startswith("__")
            if is_word and (is_declared or own not in OVERRIDABLE):
                raise page_error(value, own, "is a word of the language; choose another name")
            if is_declared and (own.startswith("_") or not own.isascii() or len(own) > NAME_LIMIT):
                text = f"cannot be a name: use at most {NAME_LIMIT} letters, digits and _, a letter first"
                raise page_error(value, own, text)
        for own, value in vars(new).items():
            hidden = next((vars(base)[own] for base in new.__mro__[1:] if own in vars(base)), None)
            if isinstance(value, Quantity):
                check_quantity(own, value)
            elif own in body and isinstance(hidden, Quantity):
                check_fixed(body.places[own], own, value, hidden)
            if value is not None and not callable(value) and any(hasattr(hidden, mark) for mark in MARKS):
                text = "is in place of a function of the page; a function overrides it, and None drops it"
                raise page_error(body.places[own], own, text)
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
    nominals: ClassVar = {}
    """Typical sizes of states in a unit that are not those of their units, as functions of the parameters."""
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

    def __setattr__(self, name, value):
        raise PageError(f"assigns to `{name}`; an event returns m.replace({name}=...), a law changes nothing")

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
    def declared_name(cls, name):
        """The `name=` of a declaration, or None."""
        given = (getattr(vars(base).get(name), "name", None) for base in cls.__mro__)
        return next((found for found in given if found), None)

    @classmethod
    def public(cls, name):
        """The name in a unit: `name=` of the declaration, else the name with the prefix of its part."""
        if cls.declared_name(name):
            return cls.declared_name(name)
        declared = [base for base in cls.__mro__ if name in vars(base)]
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
                vars(self)[name] = Absent(name, self.mode)
        return self

    @property
    def seen_in(self):
        """The set of coordinates of the mode."""
        return getattr(self.marked("is_mode").get(self.mode), "of", None)

    def in_coordinates(self, name):
        """The values of another set of coordinates, as a mapping without those that are fixed."""
        functions = self.marked("gives_coordinates").values()
        give = next((give for give in functions if give.gives_coordinates == name), None)
        if give is None:
            raise PageError(f"needs the coordinates `{name}`, which no function of the page gives")
        values, states = give(self), self.quantities("state")
        if not isinstance(values, dict):
            raise page_error(give, give.__name__, "gives no coordinates; it returns dict(state=value, ...)")
        for of in values:
            if of not in states and not hasattr(type(self), of):
                text = f"gives the coordinate `{of}`, which is no state{similar(of, states)}"
                raise page_error(give, give.__name__, text)
        for of, quantity in states.items():
            if name in (quantity.of or ()) and of not in values and isinstance(getattr(self, of), Absent):
                text = f"does not give `{of}`, which belongs to the coordinates `{name}`"
                raise page_error(give, give.__name__, text)
        return {of: value for of, value in values.items() if of in states}

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

    def row_of(self, name, row):
        """A row of a table as a record, by the number of the row. Only decisions may look rows up."""
        tables = self.marked("is_table")
        if name not in tables:
            raise PageError(f"looks up `{name}`, which is no table of the page{similar(name, tables)}")
        given, columns = tables[name](self, row), tables[name].columns
        if not isinstance(given, dict) or given.keys() != columns.keys():
            raise PageError(f"looks up `{name}`, whose rows must have exactly {', '.join(columns)}")
        if not any(isinstance(value, Expression) for value in vars(self).values()):
            return Record(**given)
        if not _looks_up[0]:
            raise PageError(f"looks up `{name}`; only a decision may. Let it hold what it finds in a state")
        return Record(**{column: self.entry_of(name, row, column, given[column]) for column in columns})

    def entry_of(self, name, row, column, own):
        """An entry of a table on symbols: the page's own where a run does not supply the table."""
        unit, own = self.marked("is_table")[name].columns[column], lift(own)
        if own.dimension not in (ANY, dimension_of(unit)):
            raise PageError(f"gives `{column}` in {text_of(own.dimension)}; its unit is {unit}")
        found = looked_up((name, column), lift(row), own)
        found.dimension = dimension_of(unit)
        return found

    def margin_of(self, unit, name="zero"):
        """Margin of decisions about a quantity in this unit; `late` is that of an event just taken."""
        return MARGINS[name] * self.scales.get(unit, lambda model: 1)(self)

    def replace(self, **changes):
        """The model in the same mode, with other words and states."""
        return self.to(self.mode, **changes)

    def leaving(self, counted):
        """The model before the decision of any event, with what all events record. `counted` is 1 or 0."""
        return self
