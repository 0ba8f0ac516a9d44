"""The unit of a page: its variables and dependencies. The C sources of units know no model."""

import hashlib
import json
import math
import re
import uuid
from collections.abc import Mapping
from types import MappingProxyType
from types import SimpleNamespace as Record
from typing import NamedTuple

from .expressions import forget_expressions
from .generate import generate
from .page import Page
from .unit_tables import header, tables
from .world import World

TYPES = {float: "Real", int: "Integer", bool: "Boolean"}
LARGEST = 2**31 - 1
"""The largest Integer of FMI."""
DISPLAY = {"rad": "deg", "rad/s": "deg/s", "rad/s2": "deg/s2"}
DEGREES = 57.29577951308232
"""Factor from a unit to its display unit."""
QUANTITIES = {
    "kg": "Mass",
    "m": "Length",
    "s": "Time",
    "rad": "Angle",
    "m/s": "Velocity",
    "rad/s": "AngularVelocity",
    "m/s2": "Acceleration",
    "rad/s2": "AngularAcceleration",
    "N": "Force",
    "N.m": "Torque",
    "N/m": "TranslationalSpringConstant",
    "N.s/m": "TranslationalDampingConstant",
    "N.m/rad": "RotationalSpringConstant",
    "N.m.s/rad": "RotationalDampingConstant",
    "J": "Energy",
    "W": "Power",
}
"""Quantities by their units."""
RATES = {"s": "1", "J": "W"}
SOLVERS = {
    "native": "the project's own event-driven solver",
    "cvode": "SUNDIALS CVODE with its root finding, if the unit was built with it",
}
WORK = {
    "steps": "Steps of the solver since the start, rejected ones included",
    "evaluations": "Evaluations of rates since the start; native: of a coefficient of their series",
    "layer_steps": "Steps since the start that the time scale of a mode has shortened",
}
"""Counters of the solver of Co-Simulation."""
EXPERIMENT = {"start_time": "startTime", "stop_time": "stopTime"}
EXPERIMENT |= {"tolerance": "tolerance", "step_size": "stepSize"}
TOLERANCE = {"least": 1e-14, "most": 1e-2}


def per_second(unit):
    """The unit of a rate."""
    if unit in RATES:
        return RATES[unit]
    above, _, below = unit.partition("/")
    power = re.fullmatch(r"s(\d*)", below)
    if power:
        return f"{above}/s{int(power[1] or 1) + 1}"
    return f"{above or 1}/({below}.s)" if below else f"{above or 1}/s"


def first_sentence(text):
    """The first sentence of a meaning or a docstring, without its full stop."""
    return re.split(r"\.(?:\s|$)", " ".join((text or "").split()), maxsplit=1)[0]


def real_type(unit):
    """The name of the type of real variables in a unit."""
    return "Number" if unit == "1" else QUANTITIES.get(unit, f"Real in {unit}")


def enumeration_type(name):
    """The name of the type of an enumeration: `ContactMode` of `contact.mode`."""
    return "".join(part.capitalize() for part in re.split(r"\W|_", name))


def experiment_in_xml(given):
    """The times and the tolerance of a default experiment, by default of ten seconds."""
    given = {"start_time": 0.0, "stop_time": 10.0} | given
    return {EXPERIMENT[name]: shortest(float(value)) for name, value in given.items()}


def shortest(number):
    """The shortest decimal text of a number: 1, 0.1 and 1e+09."""
    rounded = f"{number:g}"
    return rounded if float(rounded) == number else repr(number)


def settable(quantity, **more):
    """Attributes of a variable from a quantity of the page that takes a start value."""
    given = {"unit": quantity.unit, "about": quantity.meaning, "within": quantity.within}
    return given | {"start": quantity.value, "is_set": True} | more


class Guard(NamedTuple):
    """An event indicator: the least guard of some events, or the rate of what goes into a state."""

    events: list
    into: str | None


class Unit:
    """The variables of a page's unit, in the order of their value references.

    The fields below hold the choices that a page does not make. A subclass sets them.
    """

    identifier = ""
    """The model identifier, by default the name of the page's class."""
    about: Mapping = MappingProxyType({})
    """Author, copyright and license."""
    experiment = None
    """The default experiment, by default the page's own."""
    variables = ""
    """Names of the variables that the unit has, in order. `derivatives` are those of all continuous states.

    By default a unit has all variables of its page.
    """
    guard_events: Mapping = MappingProxyType({})
    """Events, or the observed quantity, behind an event indicator that is called otherwise."""
    computed_states = ""
    """Continuous states that take no start value."""
    steady_states = ""
    """Continuous states that no event makes jump."""
    at_start: Mapping = MappingProxyType({})
    """Names of the variables on which a variable depends at the start, by its name.

    Other variables depend on time and on all start values.
    """
    terminates = "status.terminate_at_end"
    """The parameter that asks to terminate where a run has ended."""
    has_cvode = False
    """True if a parameter chooses between the solvers."""
    terminals: Mapping = MappingProxyType({})
    """Terminals of FMI 3.0: a description, and names of variables."""

    def __init__(self, page):
        self.page, self.model, self.world, self.rows = page, page.model, World(page), []
        self.identifier = self.identifier or page.model.__name__
        self.rate_dependencies, _ = self.world.dependencies(self.world.rates)
        self.output_dependencies, self.moving_outputs = self.world.dependencies(self.world.outputs)
        self.guard_dependencies, _ = self.world.dependencies(self.world.indicators)
        self.guards = {n: Guard([n], None) for n in page.events if self.is_indicator(n)}
        peaks = {n: o.into for n, o in page.observed.items() if o.part == "largest" and o.is_usual}
        self.guards |= {n: Guard([], into) for n, into in peaks.items()}
        self.event_names = {n: n for n in page.events}
        kinds = {n: f.kind_of_value for n, f in page.outputs.items()}
        self.enumerations = {n: of for n, of in kinds.items() if isinstance(of, tuple) and of[0] != "letters"}
        self.words, self.part = [], None
        text = first_sentence(page.model.__doc__) or self.identifier
        self.about = {"description": text, **self.about}
        self.experiment = experiment_in_xml(self.experiment or getattr(page.model, "experiment", {}))
        if self.variables:
            self.group_indicators()
        self.add_all()
        if self.variables:
            self.choose_variables()
        names = [row.name for row in self.rows]
        for row in self.rows:
            if names.count(row.name) > 1:
                page.refuse(f"has two variables called `{row.name}` in its unit")
        self.number = {row.name: i for i, row in enumerate(self.rows)}

    def is_indicator(self, event):
        """True if a guard can come due while a mode lasts, and not only where one begins."""
        for key in self.page.keys:
            if event in self.page.watched(key):
                forget_expressions()
                guard = self.page.guard(key, event)
                if guard.operation != "number" or self.page.watches(key, event) is not True:
                    return True
        return False

    def group_indicators(self):
        """Take the event indicators that are chosen, each with the events behind it."""
        chosen = self.variables.split()
        places = {name: place for place, name in enumerate(chosen)}
        self.world.states.sort(key=lambda name: places[self.model.public(name)])
        names = [name.removeprefix("guard.") for name in chosen if name.startswith("guard.")]
        behind = {name: self.guard_events.get(name, [name]) for name in names}
        self.event_names |= {event: name for name, events in behind.items() for event in events}
        self.guards = {
            name: self.guards[of[0]] if of[0] in self.page.observed else Guard(of, None)
            for name, of in behind.items()
        }

    def choose_variables(self):
        """Keep the variables that are chosen, in their order."""
        known, rates = {row.name: row for row in self.rows}, [r for r in self.rows if r.derivative]
        chosen = self.variables.split()
        missing = [name for name in chosen if name not in known and name != "derivatives"]
        if missing:
            self.page.refuse(f"has no `{missing[0]}`, which its unit wants")
        rows = ([known[name]] if name in known else rates for name in chosen)
        self.rows = [row for of in rows for row in of]

    def add(self, name, storage, offset, causality, variability, unit="1", about="", kind=float, **more):
        """Add a variable."""
        row = dict.fromkeys(("start", "initial", "depends", "derivative"))
        row |= {"within": {}, "items": {}, "is_set": False, "reinit": storage == "STATE", "largest": LARGEST}
        row |= {"name": name, "storage": storage, "offset": offset, "unit": unit or "1", "kind": kind}
        row |= {"causality": causality, "variability": variability, "about": first_sentence(about)}
        self.rows.append(Record(**row | more))

    def add_number(self, name, storage, offset, causality, variability, **more):
        """Add a variable that may be of any kind: a word and an enumeration have an Integer twin each."""
        kind, given = more.get("kind", float), (causality, variability)
        twin = more | {"kind": int, "items": {}}
        if not isinstance(kind, tuple):
            self.add(name, storage, offset, *given, **more)
        elif kind[0] == "letters":
            base, digits = len(kind[1]), int(math.log(LARGEST, len(kind[1])))
            letters = ", ".join(f"{letter} {digit}" for digit, letter in enumerate(kind[1]))
            order = "first letter most significant"
            twin["about"] = f"{name} in base {base}: {letters}, {order}; -1 beyond {digits} letters"
            twin |= {"within": {"least": -1}, "largest": base**digits - 1}
            self.add(name, storage, len(self.words), *given, **more)
            self.add(f"{name}_code", storage, offset, *given, **twin)
            self.words.append((storage, offset, kind[1]))
        else:
            twin |= {"about": f"{name} as an Integer", "within": {"least": 1, "most": len(kind)}}
            self.add(name, storage, offset, *given, **more)
            self.add(f"{name}_index", storage, offset, *given, **twin)

    def add_all(self):
        """Add all variables."""
        self.add("time", "TIME", 0, "independent", "continuous", "s", "Time")
        self.add_parameters()
        self.add_states()
        self.add_outputs()
        self.add_indicators()
        for name, about in WORK.items():
            given = {"initial": "calculated", "depends": set(), "within": {"least": 0}}
            about = f"Co-Simulation: {about[0].lower()}{about[1:]}"
            place = "WORK", f"WORK_{name.upper()}", "output", "discrete"
            self.add(f"solver.{name}", *place, about=about, kind=int, **given)

    def add_parameters(self):
        """Add parameters, discrete inputs, and settings of the unit itself."""
        page = self.page
        for i, (name, q) in enumerate(page.parameters.items()):
            given, public = settable(q, kind=getattr(q, "values", float)), self.model.public(name)
            if q.role == "setting":
                self.add(public, "INPUT", i, "input", "discrete", **given)
            else:
                self.add(public, "PARAMETER", i, "parameter", q.role, initial="exact", **given)
        given = {"initial": "exact", "is_set": True}
        about = "Co-Simulation: tolerance of the solver; the tighter of it and the importer's is used"
        given |= {"about": about, "within": TOLERANCE, "start": 1e-11}
        place = "SETTING", "SETTING_TOLERANCE"
        self.add("solver.relative_tolerance", *place, "parameter", "fixed", **given)
        if any(page.modes[key[0]].ends for key in page.keys):
            about = "Model Exchange: true to ask the importer to terminate when the run has ended"
            given |= {"about": about, "within": {}, "start": True, "kind": bool}
            place = "SETTING", "SETTING_TERMINATES"
            self.add(self.terminates, *place, "parameter", "fixed", **given)
        if self.has_cvode:
            given |= {"about": "Co-Simulation: solver", "start": 1, "kind": tuple(SOLVERS), "items": SOLVERS}
            self.add("solver.method", "SETTING", "SETTING_METHOD", "parameter", "fixed", **given)

    def add_states(self):
        """Add continuous inputs, continuous states and their derivatives, and states that are held.

        A held state without a name of its own is local, and not shown where another variable has its name.
        """
        page, world, public_of = self.page, self.world, self.model.public
        first, places = len(page.parameters), {n: i for i, n in enumerate(page.states)}
        for name in page.inputs:
            place = "INPUT", first + places[name], "input", "continuous"
            self.add(public_of(name), *place, **settable(page.states[name]))
        for name in world.states:
            q, public = page.states[name], public_of(name)
            given = settable(q, initial="exact", depends={name})
            given["reinit"] = public not in self.steady_states.split()
            is_computed = public in self.computed_states.split()
            if is_computed or (q.of and world.start_of and world.start_of not in q.of):
                given |= {"initial": "calculated", "start": None, "is_set": False}
                given["within"] = {} if is_computed else q.within
            self.add(public, "STATE", first + places[name], "output", "continuous", **given)
        for name in world.starts:
            given = settable(page.states[name], initial="exact")
            given["about"] = f"Start value: {given['about']}"
            self.add(f"start.{public_of(name)}", "START", places[name], "parameter", "fixed", **given)
        for i, name in enumerate(world.states):
            public, unit = public_of(name), per_second(page.states[name].unit or "1")
            given = {"initial": "calculated", "derivative": public, "depends": self.rate_dependencies[name]}
            place = "DERIVATIVE", i, "local", "continuous"
            self.add(f"der({public})", *place, unit, f"Time derivative of {public}", **given)
        shown = {row.name for row in self.rows} | {public_of(name) for name in page.outputs}
        for name in world.held:
            q, causality = page.states[name], "output" if page.states[name].name else "local"
            given = {"unit": q.unit, "about": q.meaning, "kind": q.values, "within": q.within}
            given |= {"initial": "calculated", "depends": set()}
            if q.name or public_of(name) not in shown:
                self.add_number(public_of(name), "HELD", first + places[name], causality, "discrete", **given)

    def add_outputs(self):
        """Add the outputs. One that nothing but events changes is discrete."""
        for i, (name, function) in enumerate(self.page.outputs.items()):
            kind = function.kind_of_value
            moves = kind is float and name in self.moving_outputs
            given = {"unit": function.unit, "about": function.__doc__ or "", "kind": kind}
            given |= {
                "initial": "calculated",
                "depends": self.output_dependencies[name],
                "items": function.items,
            }
            variability = "continuous" if moves else "discrete"
            self.add_number(self.model.public(name), "OUTPUT", i, "output", variability, **given)

    def add_indicators(self):
        """Add event indicators: guards of events, and rates of observed largest values."""
        for i, name in enumerate(self.guards):
            behind = self.guard_events.get(name, [name])
            function = self.page.events.get(behind[0]) or self.page.observed[behind[0]]
            depends = set().union(*(self.guard_dependencies.get(n, set()) for n in behind))
            about = function.__doc__ or name
            about = f"{'' if behind[0] in self.page.events else 'rate of the '}{about[0].lower()}{about[1:]}"
            given = {"about": f"Event indicator: {about}", "depends": depends, "initial": "calculated"}
            self.add(f"guard.{name}", "GUARD", i, "local", "continuous", **given)

    def type_of(self, row):
        """The type of a variable, in the words of FMI 2.0."""
        if isinstance(row.kind, tuple):
            return "String" if row.kind[0] == "letters" else "Enumeration"
        return TYPES[row.kind]

    def references(self, row, at_start=False):
        """Value references of all that a variable depends on, in a run or at its start.

        At the start, events may bring in every start value.
        """
        if not at_start:
            return sorted(self.number[self.model.public(name)] for name in row.depends)
        if row.name in self.at_start:
            return sorted(self.number[name] for name in self.at_start[row.name].split())
        if row.storage == "WORK":
            return []
        of_start = (r for r in self.rows if r.is_set or r.causality == "independent")
        return [self.number[r.name] for r in of_start if r.storage != "SETTING"]

    def used_units(self):
        """Units of all real variables."""
        return dict.fromkeys(row.unit for row in self.rows if self.type_of(row) == "Real")

    def types(self):
        """Types: name, kind, description, attributes and items.

        There is one for each unit, because fmi-sim reads units of types only.
        """
        for unit in self.used_units():
            given = {"quantity": QUANTITIES.get(unit), "unit": unit, "displayUnit": DISPLAY.get(unit)}
            yield real_type(unit), "Real", None, given, []
        for row in self.rows:
            if self.type_of(row) == "Enumeration":
                items = [
                    {"name": item, "value": str(i), "description": row.items.get(item)}
                    for i, item in enumerate(row.kind, 1)
                ]
                yield enumeration_type(row.name), "Enumeration", row.about, {}, items

    def attributes(self, row):
        """Attributes of a variable that depend on its type."""
        kind = self.type_of(row)
        text_of = {"Real": lambda x: shortest(float(x)), "Boolean": lambda x: str(bool(x)).lower()}.get(
            kind, lambda x: str(int(x))
        )
        given = {"start": None if row.start is None else text_of(row.start)}
        if kind == "Enumeration":
            given["declaredType"] = enumeration_type(row.name)
        if kind in ("Real", "Integer"):
            for bound, words in {"min": ("least", "above"), "max": ("most", "below")}.items():
                given[bound] = next((text_of(row.within[w]) for w in words if w in row.within), None)
        if kind == "Real":
            given |= {"declaredType": real_type(row.unit), "reinit": "true" if row.reinit else None}
        return given


def unit_of(model, version="0"):
    """The unit of a page, with its identity, and by file the C that depends on the page."""
    unit = Unit(Page(model))
    texts = generate(unit.page) | {"unit_page.h": header(unit), "unit_page.c": tables(unit)}
    forget_expressions()
    identify(unit, texts, version)
    return unit, texts


def identify(unit, texts, version):
    """Give a unit an identity that changes with its content and with the version, and write its header."""
    rows = [{**vars(row), "depends": sorted(row.depends or ())} for row in unit.rows]
    content = repr((sorted(texts.items()), version, unit.about, unit.experiment, rows))
    unit.identity = "{" + str(uuid.UUID(hashlib.sha256(content.encode()).hexdigest()[:32])) + "}"
    texts["guid.h"] = f"#define FMU_GUID {json.dumps(unit.identity)}\n"
