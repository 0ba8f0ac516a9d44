"""A page as the generator reads it: its model on symbols, the modes that runs can reach, its decisions."""

import math

from .c_text import safe_names
from .errors import PageError, location_of, page_error, reading, similar
from .expressions import Condition, Variation, explore, forget_expressions, leaves_of, lift, symbol, value_of
from .model import Absent, Model
from .tracing import trace
from .units import ANY, SECOND, dimension_of, power, text_of, times

PARTS = ("positive integral", "largest")
CHAIN_LIMIT = 100


class Page:
    """A model's class: what it declares, and the model at an instant of a mode.

    A key is a mode with its words: each key that a run can reach is a mode of C.
    """

    def __init__(self, model):
        self.model, self.location = model, None
        self.parameters, self.states = model.quantities("parameter"), model.quantities("state")
        self.modes, self.events, self.outputs, self.observed = map(
            model.marked, ("is_mode", "is_event", "is_output", "is_observed")
        )
        self.on_set = {f.sets: f for f in model.marked("is_on_set").values()}
        self.inputs = [name for name, q in self.states.items() if q.is_input]
        self.clocks = [name for name, q in self.states.items() if q.is_clock]
        self.c_names = safe_names(list(self.parameters)) | safe_names(list(self.states))
        self._watched = {}
        self.check_declarations()
        self.check_start()
        self.keys = self.reachable()

    # ---- the model on symbols

    def symbol_of(self, name, of, constant=False):
        """The symbol of a quantity: `p->name`, `x->name` and their like in C."""
        quantity = self.parameters.get(name) or self.states[name]
        return symbol(f"{of}->{self.c_names[name]}", constant, quantity.dimension)

    def at(self, key, state_of=None):
        """The model in a mode, its parameters and states being symbols."""
        state_of = state_of or (lambda name: self.symbol_of(name, "x"))
        values = {name: self.symbol_of(name, "p", constant=True) for name in self.parameters}
        return self.model.at(
            key[0], **dict(key[1]), **values, **{name: state_of(name) for name in self.states}
        )

    def key(self, mode, words):
        """A mode with its words, and no others."""
        for word in self.modes[mode].words:
            if words.get(word) is None:
                raise PageError(f"goes to `{mode}` without its word `{word}`")
        return mode, tuple((word, words[word]) for word in self.modes[mode].words)

    def rates(self, key, state_of=None):
        """Rates of the states in a mode, those of inputs and clocks included."""
        function, model = self.modes[key[0]], self.at(key, state_of)
        given = trace(function, model)
        with reading(function, key[0]):
            if not isinstance(given, dict):
                raise PageError("gives no rates; a mode returns dict(state=rate, ...)")
            for name in given:
                self.check_rate(name, key[0])
            found = {n: getattr(model, f"{n}_rate") for n in self.inputs} | dict.fromkeys(self.clocks, 1)
            found = {} if function.ends else found | given
            rates = {n: lift(rate) for n, rate in found.items() if n in self.states}
            for name, rate in rates.items():
                self.check_unit(
                    rate, times(self.states[name].dimension, power(SECOND, -1)), f"gives `{name}` a rate"
                )
        return rates

    def check_rate(self, name, mode):
        of = self.states[name].of if name in self.states else ()
        if name not in self.states and not isinstance(
            vars(self.model).get(name, getattr(self.model, name, None)), (int, float)
        ):
            raise PageError(f"gives a rate to `{name}`, which is no state{similar(name, self.states)}")
        if of and self.modes[mode].of not in of:
            raise PageError(f"gives a rate to `{name}`, which the coordinates of `{mode}` do not have")

    def check_unit(self, value, dimension, what):
        if value.dimension not in (ANY, dimension):
            raise PageError(f"{what} in {text_of(value.dimension)}; its unit is {text_of(dimension)}")

    def number(self, function, key, name, unit=None, state_of=None):
        """What a function of the page gives in a mode, as an expression; a comparison counts as 1 or 0."""
        value = trace(function, self.at(key, state_of), name=name)
        with reading(function, name):
            if value is None:
                raise PageError("returns nothing; it has to return a number")
            value = lift(value)
            if unit is not None:
                self.check_unit(value, dimension_of(unit), "is")
        return value

    def scale(self, unit):
        """The scale of a unit, an expression of parameters."""
        function = self.model.scales.get(unit, lambda model: 1)
        return lift(trace(function, self.at(("", ())), name=f"scale of {unit}"))

    # ---- events

    def watched(self, key):
        """Events that a mode watches, in the page's order, without those that can never be due."""
        if key not in self._watched:
            words = dict(key[1])
            found = {
                name: e
                for name, e in self.events.items()
                if key[0] in e.modes and all(words.get(word) in values for word, values in e.case.items())
            }
            found = {
                name: e
                for name, e in found.items()
                if e.only is None or self.answer(key, e.only, name) is not False
            }
            self._watched[key] = {name: e for name, e in found.items() if not self.is_never_due(key, name)}
        return self._watched[key]

    def guard(self, key, name, state_of=None):
        """The guard of an event as an expression."""
        event = self.events[name]
        guard = self.number(event.when, key, name, event.unit, state_of)
        if guard.is_number(0):
            raise page_error(
                location_of(event.when), name, f"has a guard that is 0 for ever in the mode `{key[0]}`"
            )
        return guard

    def is_never_due(self, key, name):
        forget_expressions()
        guard = self.guard(key, name)
        return guard.operation == "number" and guard.value > 0

    def answer(self, key, question, name):
        """A page's answer to a question in a mode: a value, or a tree where it branches on numbers."""
        forget_expressions()
        return explore(lambda: _answered(trace(question, self.at(key), name=name)))

    def decide(self, key, name):
        """What an event makes of the model, for each way through its `if`s: keys and changed states."""
        event = self.events[name]

        def run():
            before = self.at(key)
            after = trace(event, before)
            with reading(event, name):
                if not isinstance(after, Model):
                    raise PageError(
                        f"returns {'nothing' if after is None else type(after).__name__}; it has to return "
                        "the model after the event"
                    )
                new_key, changes = self.key(after.mode, vars(after)), self.changes(before, after)
                if new_key == key and not changes and event.crossing is None:
                    raise PageError(
                        f"returns the model as it was in `{key[0]}`: it would be due again without end"
                    )
            return new_key, changes

        forget_expressions()
        return explore(run)

    def changes(self, before, after):
        """States that differ between two models, with their new values."""
        values = {n: getattr(after, n) for n in self.states if getattr(after, n) is not getattr(before, n)}
        values = {n: lift(value) for n, value in values.items() if not isinstance(value, Absent)}
        for name, value in values.items():
            self.check_unit(value, self.states[name].dimension, f"sets `{name}`")
        return values

    def reachable(self):
        """Modes that runs can reach, found by following the page's decisions from its start."""
        todo, found = [self.key(*self.model.start)], []
        while todo:
            key = todo.pop(0)
            if key not in found:
                found.append(key)
                for name in self.watched(key):
                    todo += keys_of(self.decide(key, name))
            if len(found) > 100:
                raise page_error(
                    self.location,
                    self.model.__name__,
                    "reaches more than 100 modes; numbers belong into held states, words are for structure",
                )
        return found

    # ---- checks

    def check_declarations(self):
        """Refuse what can be seen without running anything."""
        model = self.model
        self.location = next(map(location_of, self.modes.values()), None)
        if not self.modes:
            raise page_error(None, model.__name__, "has no mode; a page needs one function marked by @mode()")
        if model.start[0] not in self.modes:
            raise page_error(
                self.location,
                model.__name__,
                f"starts in `{model.start[0]}`, which is no mode{similar(model.start[0], self.modes)}",
            )
        for kind in (self.events, self.observed):
            for name, function in kind.items():
                self.check_modes(name, function)
        for name, function in self.observed.items():
            if function.part not in PARTS:
                raise page_error(
                    location_of(function),
                    name,
                    f"observes the `{function.part}`; known are {' and '.join(PARTS)}",
                )
            if function.into not in self.states:
                raise page_error(
                    location_of(function),
                    name,
                    f"goes into `{function.into}`, which is no state{similar(function.into, self.states)}",
                )
        for function in (*self.events.values(), *self.outputs.values(), *self.observed.values()):
            with reading(function, function.__name__):
                dimension_of(function.unit)
        known = self.parameters.keys() | self.states.keys()
        for name, function in self.on_set.items():
            if name not in known and not hasattr(model, name):
                raise page_error(
                    location_of(function),
                    function.__name__,
                    f"is about `{name}`, which the page does not have{similar(name, known)}",
                )
        sets = {f.gives_coordinates for f in model.marked("gives_coordinates").values()}
        used = {of: q.location for q in self.states.values() for of in q.of or ()}
        used |= {f.of: location_of(f) for f in self.modes.values() if f.of}
        for of, location in used.items():
            if of not in sets:
                raise page_error(
                    location, of, f"is no set of coordinates: no function gives it{similar(of, sets)}"
                )
        named = {}
        for name in [*self.parameters, *(n for n, q in self.states.items() if q.name), *self.outputs]:
            public = model.public(name)
            if public in named:
                raise page_error(
                    getattr(getattr(model, name), "location", None) or location_of(getattr(model, name)),
                    name,
                    f"has the name `{public}` in a unit, which `{named[public]}` has",
                )
            named[public] = name

    def check_modes(self, name, function):
        for mode in function.modes:
            if mode not in self.modes:
                raise page_error(
                    location_of(function),
                    name,
                    f"is about the mode `{mode}`, which the page does not have{similar(mode, self.modes)}",
                )
        for word in getattr(function, "case", ()):
            words = {w for mode in function.modes for w in self.modes[mode].words}
            if word not in words:
                raise page_error(
                    location_of(function),
                    name,
                    f"asks for the word `{word}`, which none of its modes has{similar(word, words)}",
                )

    def check_start(self):
        """Run the start on plain numbers, which finds divisions by zero and chains that do not end."""
        mode, words = self.model.start
        self.key(mode, words)
        model = self.model.at(mode, **words)
        for _ in range(CHAIN_LIMIT):
            due = next((e for n, e in self.events.items() if self.is_due(model, n, e)), None)
            if due is None:
                break
            with reading(due, due.__name__):
                after = due(model)
                if not isinstance(after, Model):
                    raise PageError("returns nothing; it has to return the model after the event")
                model = after
        else:
            raise page_error(
                location_of(due),
                due.__name__,
                f"is due again at the start, in the mode `{model.mode}`, after "
                f"{CHAIN_LIMIT} events in zero time: its guard stays below 0. Let its decision go to a mode "
                "that does not watch it",
            )
        function = self.modes[model.mode]
        with reading(function, model.mode):
            rates = function(model)
            for name, rate in (rates if isinstance(rates, dict) else {}).items():
                if isinstance(rate, Absent):
                    rate.refuse()
                if not isinstance(rate, (int, float)) or not math.isfinite(rate):
                    raise PageError(f"gives `{name}` the rate {rate} at the start")
        self.check_smooth(model)

    def is_due(self, model, name, event):
        if model.mode not in event.modes or not all(
            getattr(model, w, None) in v for w, v in event.case.items()
        ):
            return False
        with reading(event.when, name):
            if (event.only and not event.only(model)) or (event.crossing and event.crossing(model)):
                return False
            guard = event.when(model)
            if guard is None or not math.isfinite(guard):
                raise PageError(f"has the guard {guard} at the start; it has to be a finite number")
            return guard < -1e-9

    def check_smooth(self, model):
        """Refuse rates that have no derivative at the start: a Taylor series cannot begin there."""
        forget_expressions()
        key = self.key(model.mode, vars(model))
        rates = self.rates(key)
        values = {self.symbol_of(n, "p", True): self.parameters[n].value for n in self.parameters}
        values |= {
            self.symbol_of(n, "x"): getattr(model, n)
            for n in self.states
            if not isinstance(getattr(model, n), Absent)
        }
        moving = {self.symbol_of(n, "x"): rate for n, rate in rates.items()}
        varies = Variation(moving | {leaf: 0 for leaf in leaves_of(rates.values()) if leaf not in moving})
        with reading(self.modes[model.mode], model.mode):
            value_of([varies.of(rate) for rate in rates.values()], values)


def _answered(value):
    return bool(value) if isinstance(value, (bool, Condition)) else value


def keys_of(tree):
    """Modes that a decision can lead to, each once."""
    if len(tree) == 2:
        return [tree[0]]
    return list(dict.fromkeys([*keys_of(tree[1]), *keys_of(tree[2])]))
