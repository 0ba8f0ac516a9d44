"""A page on symbols: the modes that runs can reach, their rates, guards and decisions, and checks."""

import math
from types import CodeType, FunctionType

from .c_text import safe_names
from .errors import PageError, check_known, page_error, reading, similar
from .expressions import Condition, _looks_up, explore, forget_expressions, leaves_of, lift, symbol
from .limits import LIMITS, MARGINS
from .model import MARKS, Absent, Model
from .quantities import Quantity
from .tracing import trace
from .units import ANY, SECOND, dimension_of, power, text_of, times
from .variations import Variation, value_of

PARTS = ("positive integral", "largest")
MODE_LIMIT = 100


class Page:
    """The declarations of a model, and its functions on symbols.

    A key is a mode with its words. Each key that a run can reach becomes a mode of C.
    """

    def __init__(self, model):
        self.model = model
        self.parameters, self.states = model.quantities("parameter"), model.quantities("state")
        self.modes, self.events = model.marked("is_mode"), model.marked("is_event")
        self.outputs, self.observed = model.marked("is_output"), model.marked("is_observed")
        self.tables, self.sections = model.marked("is_table"), model.marked("is_section")
        self.on_set = {name: f for f in model.marked("is_on_set").values() for name in f.sets}
        self.inputs = [name for name, q in self.states.items() if q.is_input]
        self.clocks = [name for name, q in self.states.items() if q.is_clock]
        self.c_names = safe_names(list(self.parameters)) | safe_names(list(self.states))
        self._watched, self._watches = {}, {}
        self.check_declarations()
        self.check_start()
        self.keys = self.reachable()
        self.check_words()
        self.check_unreached()

    # ---- the model on symbols

    def symbol_of(self, name, of, constant=False):
        """The symbol of a quantity, in C a member of the struct `of`: `p->name` or `x->name`."""
        quantity = self.parameters.get(name) or self.states[name]
        return symbol(f"{of}->{self.c_names[name]}", constant, quantity.dimension)

    def at(self, key, state_of=None):
        """The model in a mode, with symbols for parameters and states."""
        state_of = state_of or (lambda name: self.symbol_of(name, "x"))
        values = {name: self.symbol_of(name, "p", constant=True) for name in self.parameters}
        values |= {name: state_of(name) for name in self.states}
        return self.model.at(key[0], **dict(key[1]), **values)

    def key(self, mode, words):
        """The key of a mode, from the values of words."""
        for word in self.modes[mode].words:
            if words.get(word) is None:
                raise PageError(f"goes to `{mode}` without its word `{word}`")
        return mode, tuple((word, words[word]) for word in self.modes[mode].words)

    @property
    def world_key(self):
        """The first mode that a run reaches in the coordinates called `world`, or None."""
        return next((key for key in self.keys if self.modes[key[0]].of == "world"), None)

    def rates(self, key, state_of=None):
        """Rates of the states in a mode, inputs and clocks included."""
        function, model = self.modes[key[0]], self.at(key, state_of)
        given = trace(function, model)
        with reading(function, key[0]):
            if not isinstance(given, dict):
                raise PageError("gives no rates; a mode returns dict(state=rate, ...)")
            if function.ends and given:
                raise PageError(f"gives a rate to `{next(iter(given))}`, but the mode ends the run")
            for name in given:
                self.check_rate(name, key[0])
            found = {n: getattr(model, f"{n}_rate") for n in self.inputs} | dict.fromkeys(self.clocks, 1)
            found = {} if function.ends else found | given
            rates = {n: lift(rate) for n, rate in found.items() if n in self.states}
            for name, rate in rates.items():
                dimension = times(self.states[name].dimension, power(SECOND, -1))
                self.check_unit(rate, dimension, f"gives `{name}` a rate")
        return rates

    def along_motion(self, rates, varies):
        """A variation along a motion: states vary by their rates, and parameters do not vary."""
        varies.found |= {self.symbol_of(n, "x"): rates.get(n, lift(0)) for n in self.states}
        varies.found |= {self.symbol_of(n, "p", True): lift(0) for n in self.parameters}
        return varies

    def check_rate(self, name, mode):
        """Refuse the rate of a name that is no state, or no state of the mode's coordinates."""
        of = self.states[name].of if name in self.states else ()
        if name not in self.states and not isinstance(
            vars(self.model).get(name, getattr(self.model, name, None)), (int, float)
        ):
            raise PageError(f"gives a rate to `{name}`, which is no state{similar(name, self.states)}")
        if of and self.modes[mode].of not in of:
            raise PageError(f"gives a rate to `{name}`, which the coordinates of `{mode}` do not have")

    def check_unit(self, value, dimension, what):
        """Refuse a value in another unit."""
        if value.dimension not in (ANY, dimension):
            raise PageError(f"{what} in {text_of(value.dimension)}; its unit is {text_of(dimension)}")

    def number(self, function, key, name, unit=None, state_of=None):
        """The value of a page's function in a mode, as an expression; a comparison counts as 1 or 0."""
        value = trace(function, self.at(key, state_of), name=name)
        with reading(function, name):
            if value is None:
                raise PageError("returns nothing; it has to return a number")
            value = lift(value)
            if unit is not None:
                self.check_unit(value, dimension_of(unit), "is")
        return value

    def scale(self, unit):
        """The scale of a unit, as an expression of parameters."""
        function = self.model.scales.get(unit, lambda model: 1)
        return self.number(function, ("", ()), f"scale of {unit}", unit)

    # ---- events

    def watched(self, key):
        """Events that can become due in a mode, in the page's order."""
        if key not in self._watched:
            words = dict(key[1])
            self._watched[key] = {
                name: e
                for name, e in self.events.items()
                if key[0] in e.modes
                and all(words.get(word) in values for word, values in e.case.items())
                and self.watches(key, name) is not False
                and not self.is_never_due(key, name)
            }
        return self._watched[key]

    def watches(self, key, name):
        """Answer whether a mode watches an event: a truth value, or a tree if it depends on numbers."""
        if (key, name) not in self._watches:
            only = self.events[name].only
            self._watches[key, name] = True if only is None else self.answer(key, only, name)
        return self._watches[key, name]

    def guard(self, key, name, state_of=None):
        """The guard of an event as an expression."""
        event = self.events[name]
        guard = self.number(event.when, key, name, event.unit, state_of)
        if guard.is_number(0):
            raise page_error(event.when, name, f"has a guard that is 0 for ever in the mode `{key[0]}`")
        return guard

    def is_never_due(self, key, name):
        forget_expressions()
        guard = self.guard(key, name)
        return guard.operation == "number" and guard.value > 0

    def answer(self, key, question, name, may_be_none=False):
        """The answer of a page's function in a mode: a value, or a tree if it branches on numbers."""

        def run():
            value = trace(question, self.at(key), name=name)
            with reading(question, name):
                if value is None and not may_be_none:
                    raise PageError("returns nothing; it has to return whether the condition holds")
            return bool(value) if isinstance(value, (bool, Condition)) else value

        forget_expressions()
        return explore(run)

    def model_after(self, function, name, *given):
        """The model that a page's function returns."""
        after = trace(function, *given, name=name)
        with reading(function, name):
            if not isinstance(after, Model):
                given = "nothing" if after is None else type(after).__name__
                raise PageError(f"returns {given}; it has to return the model")
        return after

    def after(self, name, before):
        """The model after an event."""
        event = self.events[name]
        _looks_up[0] = True
        try:
            return self.model_after(event, name, before)
        finally:
            _looks_up[0] = False

    def decide(self, key, name):
        """The decision of an event, as a tree of conditions whose leaves are keys and changed states."""
        event = self.events[name]

        def run():
            before = self.at(key)
            after = self.after(name, before)
            with reading(event, name):
                new_key, changes = self.key(after.mode, vars(after)), self.changes(before, after)
                if new_key == key and not changes and event.crossing is None:
                    text = f"returns the model as it was in `{key[0]}`: it would be due again without end"
                    raise PageError(text)
            return new_key, changes

        forget_expressions()
        return explore(run)

    def placed(self, name, point):
        """The model where runs start, and that model on a section."""
        function, before = self.sections[name], self.at(self.keys[0])
        after = trace(function, before, point, name=name)
        with reading(function, name):
            if not isinstance(after, Model) or after.mode != before.mode:
                raise PageError("has to return the model in the mode in which runs start")
        return before, after

    def changes(self, before, after):
        """States that differ between two models, with their new values."""
        values = {n: getattr(after, n) for n in self.states if getattr(after, n) is not getattr(before, n)}
        values = {n: lift(value) for n, value in values.items() if not isinstance(value, Absent)}
        for name, value in values.items():
            self.check_unit(value, self.states[name].dimension, f"sets `{name}`")
        return values

    def reachable(self):
        """Keys that runs can reach, found by following the decisions from the page's start."""
        todo, found = [self.key(*self.model.start)], []
        while todo:
            key = todo.pop(0)
            if key not in found:
                found.append(key)
                for name in self.watched(key):
                    todo += keys_of(self.decide(key, name))
            if len(found) > MODE_LIMIT:
                self.refuse(f"reaches more than {MODE_LIMIT} modes; hold numbers in states, not in words")
        return found

    # ---- checks

    def place_of(self, name):
        """File and line at which a name of the page was set last."""
        return next(c._places[name] for c in self.model.__mro__ if name in getattr(c, "_places", ()))

    def refuse(self, text):
        """Raise an error about the page as a whole."""
        raise page_error(next(iter(self.modes.values()), None), self.model.__name__, text)

    def check_declarations(self):
        """Refuse errors that are visible without running a function of the page."""
        start = self.model.start
        if not (isinstance(start, tuple) and [type(part) for part in start] == [str, dict]):
            text = f'has the start {start!r}; it has to be a mode and its words, such as "flight", {{}}'
            raise page_error(self.place_of("start"), self.model.__name__, text)
        start = start[0]
        if not self.modes:
            self.refuse("has no mode; a page needs one function marked by @mode()")
        place, text = self.place_of("start"), "starts in {}, which is no mode"
        check_known(place, self.model.__name__, start, self.modes, text)
        if len(self.events) > LIMITS["PAGE_EVENT"]:
            self.refuse(f"has {len(self.events)} events; at most {LIMITS['PAGE_EVENT']} are allowed")
        for name, function in [*self.events.items(), *self.observed.items()]:
            self.check_modes(name, function)
        self.check_observed()
        self.check_units()
        self.check_sections()
        self.check_sets()
        self.check_coordinates()
        self.check_public_names()
        self.check_scales()

    def check_observed(self):
        """Refuse observed quantities of an unknown part, or whose state does not exist."""
        for name, function in self.observed.items():
            if function.part not in PARTS:
                text = f"observes the `{function.part}`; known are {' and '.join(PARTS)}"
                raise page_error(function, name, text)
            check_known(function, name, function.into, self.states, "goes into {}, which is no state")

    def check_units(self):
        """Refuse unknown units of functions and of columns of tables."""
        columns = [(n, f, unit) for n, f in self.tables.items() for unit in f.columns.values()]
        functions = self.events | self.outputs | self.observed
        for name, function, unit in [*((n, f, f.unit) for n, f in functions.items()), *columns]:
            with reading(function, name):
                dimension_of(unit)

    def check_sections(self):
        """Refuse sections without an event or state of the page."""
        for name, function in self.sections.items():
            check_known(function, name, function.event, self.events, "is taken at {}, which is no event")
            for of in function.coordinates:
                check_known(function, name, of, self.states, "has the coordinate {}, which is no state")
            if len(function.coordinates) > LIMITS["MAP"]:
                raise page_error(function, name, f"has more than {LIMITS['MAP']} coordinates")

    def check_sets(self):
        """Refuse functions about the setting of a quantity that does not exist."""
        known = self.parameters.keys() | self.states.keys()
        for name, function in self.on_set.items():
            if not hasattr(self.model, name):
                check_known(
                    function, function.__name__, name, known, "is about {}, which the page does not have"
                )

    def check_coordinates(self):
        """Refuse coordinates that no function gives."""
        sets = {f.gives_coordinates for f in self.model.marked("gives_coordinates").values()}
        used = {of: q for q in self.states.values() for of in q.of or ()}
        used |= {f.of: f for f in self.modes.values() if f.of}
        for of, declared in used.items():
            check_known(declared, of, of, sets, "is no set of coordinates: no function gives it")

    def check_public_names(self):
        """Refuse two quantities of one name in a unit."""
        named = {}
        for name in [*self.parameters, *(n for n, q in self.states.items() if q.name), *self.outputs]:
            public = self.model.public(name)
            other = named.setdefault(public, name)
            if other != name:
                text = f"has the name `{public}` in a unit, which `{other}` has"
                raise page_error(getattr(self.model, name), name, text)

    def check_modes(self, name, function):
        """Refuse modes and words that the page does not have."""
        for mode in function.modes:
            if getattr(self.model, mode, mode) is not None:  # not dropped by a subclass
                text = "is about the mode {}, which the page does not have"
                check_known(function, name, mode, self.modes, text)
        words = {word for mode in function.modes if mode in self.modes for word in self.modes[mode].words}
        for word in getattr(function, "case", ()):
            check_known(function, name, word, words, "asks for the word {}, which none of its modes has")

    def check_scales(self):
        """Refuse scales that are no positive numbers, or depend on more than parameters."""
        for unit, function in self.model.scales.items():
            if not callable(function):
                text = f"is {function!r}; it has to be a function of the parameters"
                raise page_error(self.place_of("scales"), f"scale of {unit}", text)
            with reading(function, f"scale of {unit}"):
                scale = self.scale(unit)
                if not scale.is_constant:
                    raise PageError("depends on a state; it may depend on parameters alone")
                values = {self.symbol_of(n, "p", True): q.value for n, q in self.parameters.items()}
                if not 0 < value_of([scale], values)[0] < math.inf:
                    raise PageError(f"is {values[scale]:g}; it has to be above 0")

    def check_words(self):
        """Refuse an event that asks for a value of a word that no function of the page mentions."""
        mentioned = {value for _, words in self.keys for _, value in words}
        mentioned |= {text for member in self.model.members().values() for text in texts_of(member)}
        for name, function in self.events.items():
            for word, values in function.case.items():
                for value in values:
                    if isinstance(value, str):
                        text = f"asks for {word}={{}}, which no decision gives"
                        check_known(function, name, value, mentioned, text)

    @property
    def unreached(self):
        """Modes to which no event of the page leads."""
        reached = {mode for mode, _ in self.keys}
        return {mode: function for mode, function in self.modes.items() if mode not in reached}

    @property
    def uncalled(self):
        """Functions that nothing else on the page calls, as an override of one that was renamed."""
        callers = {}
        for base in self.model.__mro__:
            for own, value in vars(base).items():
                for name in names_in(value):
                    callers.setdefault(name, set()).add(own)
        return {
            name: function
            for name, function in self.model.members().items()
            if isinstance(function, FunctionType)
            and not any(hasattr(function, mark) for mark in MARKS)
            and not hasattr(Model, name)
            and callers.get(name, set()) <= {name}
        }

    def check_unreached(self):
        """Run what no run reaches, and requirements of a start, which refuses errors in them."""
        for mode, function in self.unreached.items():
            if not function.words:
                self.rates((mode, ()))
                for name in self.watched((mode, ())):
                    self.decide((mode, ()), name)
        for name, function in self.model.marked("is_required").items():
            self.number(function, self.keys[0], name)

    def check_start(self):
        """Run the start on plain numbers, which detects divisions by zero and endless chains."""
        mode, words = self.model.start
        self.key(mode, words)
        model = self.model.at(mode, **words)
        for _ in range(LIMITS["PAGE_CHAIN"]):
            due = next((n for n, e in self.events.items() if self.is_due(model, n, e)), None)
            if due is None:
                break
            model = self.after(due, model)
        else:
            after = f"in the mode `{model.mode}`, after {LIMITS['PAGE_CHAIN']} events in zero time"
            text = "its guard stays below 0. Let its decision go to a mode that does not watch it"
            raise page_error(self.events[due], due, f"is due again at the start, {after}: {text}")
        function = self.modes[model.mode]
        with reading(function, model.mode):
            rates = trace(function, model)
            for name, rate in (rates if isinstance(rates, dict) else {}).items():
                if isinstance(rate, Absent):
                    rate.refuse()
                if not isinstance(rate, (int, float)) or not math.isfinite(rate):
                    raise PageError(f"gives `{name}` the rate {rate} at the start")
        self.check_smooth(model)

    def is_due(self, model, name, event):
        fits = all(getattr(model, word, None) in values for word, values in event.case.items())
        with reading(event.when, name):
            if model.mode not in event.modes or not fits or (event.only and not event.only(model)):
                return False
            if event.crossing and event.crossing(model):
                return False
            guard = event.when(model)
            if guard is None or not math.isfinite(guard):
                raise PageError(f"has the guard {guard} at the start; it has to be a finite number")
            return guard < -MARGINS["late"]

    def check_smooth(self, model):
        """Refuse rates without a derivative at the start, because a Taylor series needs one."""
        forget_expressions()
        key = self.key(model.mode, vars(model))
        rates = self.rates(key)
        values = {self.symbol_of(n, "p", True): self.parameters[n].value for n in self.parameters}
        starts = {n: getattr(model, n) for n in self.states}
        values |= {self.symbol_of(n, "x"): x for n, x in starts.items() if not isinstance(x, Absent)}
        moving = {self.symbol_of(n, "x"): rate for n, rate in rates.items()}
        varies = Variation(moving | {leaf: 0 for leaf in leaves_of(rates.values()) if leaf not in moving})
        with reading(self.modes[model.mode], model.mode):
            value_of([varies.of(rate) for rate in rates.values()], values)


def codes_of(function):
    """The code of a function and of functions inside it; nothing of what is no function."""
    codes = [function.__code__] if isinstance(function, FunctionType) else []
    for code in codes:
        yield code
        codes += [constant for constant in code.co_consts if isinstance(constant, CodeType)]


def texts_of(member):
    """Texts in the code of a function of the page."""
    return [text for code in codes_of(member) for text in code.co_consts if isinstance(text, str)]


def names_in(member):
    """Names in the code of a member of a page, and of the functions that it was declared with."""
    parts = [member]
    for part in parts:
        for code in codes_of(part):
            yield from code.co_names
        yield from texts_of(part)
        if isinstance(part, dict):
            parts += part.values()
        elif isinstance(part, FunctionType | Quantity | property):
            parts += [part.fget] if isinstance(part, property) else vars(part).values()


def keys_of(tree):
    """The keys that a decision can lead to."""
    if len(tree) == 2:
        return [tree[0]]
    return list(dict.fromkeys([*keys_of(tree[1]), *keys_of(tree[2])]))
