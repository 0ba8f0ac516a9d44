"""The unit of a page: its variables, dependencies and tables in C. The C sources of units know no model."""

import hashlib
import json
import math
import re
import uuid
from types import SimpleNamespace as Record
from typing import NamedTuple

from .c_text import c_text, lines_of, number_text, statements, wrapped_text
from .errors import page_error
from .expressions import forget_expressions, leaves_of, lift
from .generate import generate
from .instants import Functions
from .page import Page
from .quantities import BOUNDS, range_of
from .tables import c_boolean
from .tracing import trace
from .variations import Variation

TYPES = {float: "Real", int: "Integer", bool: "Boolean"}
LARGEST = 2**31 - 1
"""The largest Integer of FMI."""
DISPLAY = {"rad": "deg", "rad/s": "deg/s", "rad/s2": "deg/s2"}
EXPERIMENT = {"start_time": "startTime", "stop_time": "stopTime"}
EXPERIMENT |= {"tolerance": "tolerance", "step_size": "stepSize"}
TOLERANCE = {"least": 1e-14, "most": 1e-2}
TOP = "/* Derived from the page {name}: edit the page, not this. */\n"


def per_second(unit):
    """The unit of a rate."""
    above, _, below = unit.partition("/")
    power = re.fullmatch(r"s(\d*)", below)
    if power:
        return f"{above}/s{int(power[1] or 1) + 1}"
    return f"{above or 1}/({below}.s)" if below else f"{above or 1}/s"


def allowed(within):
    """The range of a quantity in words."""
    if within.keys() == {"least", "most"}:
        return f"from {within['least']:.15g} to {within['most']:.15g}"
    return " and ".join(f"{BOUNDS[word][0]} {bound:.15g}" for word, bound in within.items())


def experiment_of(model):
    """The times and the tolerance of the default experiment: the page's own `experiment`, or ten seconds."""
    given = {"start_time": 0.0, "stop_time": 10.0} | getattr(model, "experiment", {})
    return {EXPERIMENT[name]: repr(float(value)) for name, value in given.items()}


def empty(name):
    """The row of a table of C that has none; a row of a struct is in braces."""
    return ["{0},"] if name.startswith("unit_") else ["0,"]


def requirements_in_c(page, functions):
    """Functions of C for the numbers that must not be negative at a start, by their names on the page."""
    found = {}
    for name, function in page.model.marked("is_required").items():
        forget_expressions()
        value, taken = page.number(function, page.keys[0], name), {}
        body = statements([value], taken, set()) + f"    return {c_text(value, taken.get)};\n"
        about = f"{name}: {function.__doc__ or ''}"
        found[name] = functions.add(f"require_{name}", "answer", body, about)
    return found


class World:
    """The continuous states of a unit, and the names that values depend on."""

    def __init__(self, page):
        self.page, moving = page, set()
        sets = {f.gives_coordinates for f in page.model.marked("gives_coordinates").values()}
        start = page.modes[page.keys[0][0]]
        self.key = page.world_key
        if sets and ("world" not in sets or self.key is None):
            page.refuse("has coordinates, and no mode in those called `world`, which a unit shows")
        self.start_of = start.of if start.of != "world" else None
        for key in page.keys:
            forget_expressions()
            moving |= {n for n, rate in page.rates(key).items() if not rate.is_number(0)}
        self.integrals = {
            n: o for n, o in page.observed.items() if o.part == "positive integral" and o.is_usual
        }
        moving |= {o.into for o in self.integrals.values()}
        left_out = {f"{n}_rate" for n in page.inputs}
        left_out |= {o.into for o in page.observed.values() if not o.is_usual}
        own = {n: q for n, q in page.states.items() if q.role == "state" and n not in left_out}
        self.states = [n for n, q in own.items() if (q.of and "world" in q.of) or (not q.of and n in moving)]
        self.held = [n for n, q in own.items() if not q.of and n not in self.states]
        self.starts = [n for n, q in own.items() if q.of and self.start_of in q.of and "world" not in q.of]
        self.moving = moving | set(self.states)
        self.names = {page.c_names[n]: n for n in (*page.parameters, *page.states)}
        settings = [n for n, q in page.parameters.items() if q.role == "setting"]
        self.knowns = dict.fromkeys([*self.states, *page.inputs, *settings])

    def in_mode(self, key):
        """The states of a mode with coordinates of its own, as expressions of the world's."""
        of = self.page.modes[key[0]].of
        if self.key is None or of in (None, "world"):
            return {}
        seen = trace(self.page.at(self.key).in_coordinates, of, name=of)
        return {n: lift(value) for n, value in seen.items()}

    def rates(self, key):
        """Rates of the continuous states in a mode."""
        page, of = self.page, self.page.modes[key[0]].of
        rates = page.rates(key)
        found = {n: rates.get(n, lift(0)) for n in self.states}
        if self.key is not None and of not in (None, "world"):
            moving = page.along_motion(rates, Variation({}))
            seen = trace(page.at(key).in_coordinates, "world", name="world")
            found |= {n: moving.of(lift(value)) for n, value in seen.items() if n in self.states}
        for name, observed in self.integrals.items():
            if key[0] in observed.modes:
                found[observed.into] = found[observed.into] + page.number(observed, key, name)
        return found

    def outputs(self, key):
        """The outputs in a mode."""
        return {n: self.page.number(f, key, n) for n, f in self.page.outputs.items()}

    def guards(self, key):
        """The guards that a mode watches."""
        return {n: self.page.guard(key, n) for n in self.page.watched(key)}

    def dependencies(self, values_in):
        """Names of states, inputs and settings that values depend on in any mode, by the values' names.

        Also the values' names that depend on something that moves.
        """
        found, moves = {}, set()
        for key in self.page.keys:
            forget_expressions()
            own, values = self.in_mode(key), values_in(key)
            for name, value in values.items():
                names = {self.names[leaf.value[3:]] for leaf in leaves_of([value])}
                moves |= {name} if names & self.moving else set()
                for other in names & own.keys():
                    names |= {self.names[leaf.value[3:]] for leaf in leaves_of([own[other]])}
                found.setdefault(name, set()).update(names & self.knowns.keys())
        return found, moves


class Guard(NamedTuple):
    """An event indicator: the least guard of some events, or the rate of what goes into a state."""

    events: list
    into: str | None


class Unit:
    """The variables of a page's unit, in the order of their value references."""

    def __init__(self, page):
        self.page, self.model, self.world, self.rows = page, page.model, World(page), []
        self.identifier = page.model.__name__
        self.of_rates, _ = self.world.dependencies(self.world.rates)
        self.of_outputs, self.moving_outputs = self.world.dependencies(self.world.outputs)
        self.of_guards, _ = self.world.dependencies(self.world.guards)
        self.guards = {n: Guard([n], None) for n in page.events if self.is_indicator(n)}
        peaks = {n: o.into for n, o in page.observed.items() if o.part == "largest" and o.is_usual}
        self.guards |= {n: Guard([], into) for n, into in peaks.items()}
        self.event_names = {n: n for n in page.events}
        kinds = {n: f.kind_of_value for n, f in page.outputs.items()}
        self.enumerations = {n: of for n, of in kinds.items() if isinstance(of, tuple) and of[0] != "letters"}
        self.words, self.part, self.categories = [], None, {}
        self.about = {"description": " ".join((page.model.__doc__ or self.identifier).split())}
        self.experiment = experiment_of(page.model)
        self.add_all()
        names = [row.name for row in self.rows]
        for row in self.rows:
            if names.count(row.name) > 1:
                page.refuse(f"has two variables called `{row.name}` in its unit")
        self.number = {row.name: i for i, row in enumerate(self.rows)}

    def is_indicator(self, event):
        """Whether a guard can come due while a mode lasts, and not only where one begins."""
        for key in self.page.keys:
            if event in self.page.watched(key):
                forget_expressions()
                guard = self.page.guard(key, event)
                if guard.operation != "number" or self.page.watches(key, event) is not True:
                    return True
        return False

    def add(self, name, storage, offset, causality, variability, unit="1", about="", kind=float, **more):
        """Add a variable."""
        row = {
            "start": None,
            "initial": None,
            "within": {},
            "depends": None,
            "derivative": None,
            "is_set": False,
            "largest": LARGEST,
            "reinit": storage == "STATE",
        }
        row |= {
            "name": name,
            "storage": storage,
            "offset": offset,
            "causality": causality,
            "unit": unit or "1",
        }
        row |= {"variability": variability, "about": " ".join(about.split()), "kind": kind} | more
        self.rows.append(Record(**row))

    def add_number(self, name, storage, offset, causality, variability, **more):
        """Add a variable that may be of any kind: a word and an enumeration have an Integer twin each."""
        kind = more.get("kind", float)
        given = (causality, variability)
        if not isinstance(kind, tuple):
            self.add(name, storage, offset, *given, **more)
            return
        twin = more | {"kind": int}
        if kind[0] == "letters":
            self.words.append((storage == "OUTPUT", offset - self.first(storage), kind[1]))
            self.add(name, storage, len(self.words) - 1, *given, **more)
            twin["about"] = f"Code of {name}: digits in the base of its alphabet"
            digits = int(math.log(LARGEST, len(kind[1])))
            twin["largest"] = len(kind[1]) ** digits - 1
            self.add(f"{name}_code", storage, offset, *given, **twin)
        else:
            self.add(name, storage, offset, *given, **more)
            twin["about"] = f"Number of {name}"
            self.add(f"{name}_index", storage, offset, *given, **twin)

    def first(self, storage):
        """Offset at which a storage begins among the numbers of a run."""
        return len(self.page.parameters) if storage == "HELD" else 0

    def add_all(self):
        """Add all variables."""
        self.add("time", "TIME", 0, "independent", "continuous", "s", "Time")
        self.add_parameters()
        self.add_states()
        self.add_outputs()
        self.add_indicators()
        about = "Steps that the solver of Co-Simulation has taken"
        given = {"initial": "calculated", "depends": set()}
        self.add("solver.steps", "WORK", "WORK_STEPS", "output", "discrete", "1", about, int, **given)

    def add_parameters(self):
        """Add parameters, discrete inputs, and settings of the unit itself."""
        page = self.page
        for i, (name, q) in enumerate(page.parameters.items()):
            given = {"unit": q.unit, "about": q.meaning, "within": q.within, "start": q.value, "is_set": True}
            given["kind"] = getattr(q, "values", float)
            public = self.model.public(name)
            if q.role == "setting":
                self.add(public, "INPUT", i, "input", "discrete", **given)
            else:
                self.add(public, "PARAMETER", i, "parameter", q.role, initial="exact", **given)
        given = {"initial": "exact", "is_set": True}
        about = "Relative tolerance of the solver in Co-Simulation"
        given |= {"about": about, "within": TOLERANCE, "start": 1e-11}
        place = "SETTING", "SETTING_TOLERANCE"
        self.add("solver.relative_tolerance", *place, "parameter", "fixed", **given)
        if any(page.modes[key[0]].ends for key in page.keys):
            about = "Whether Model Exchange asks to terminate where the run has ended"
            given |= {"about": about, "within": {}, "start": True, "kind": bool}
            place = "SETTING", "SETTING_TERMINATES"
            self.add("status.terminate_at_end", *place, "parameter", "fixed", **given)

    def add_states(self):
        """Add continuous inputs, continuous states and their derivatives, and states that are held.

        A held state without a name of its own is local, and not shown where another variable has its name.
        """
        page, world, public_of = self.page, self.world, self.model.public
        first, places = len(page.parameters), {n: i for i, n in enumerate(page.states)}
        for name in page.inputs:
            q = page.states[name]
            given = {"unit": q.unit, "about": q.meaning, "within": q.within, "start": q.value, "is_set": True}
            self.add(public_of(name), "INPUT", first + places[name], "input", "continuous", **given)
        for i, name in enumerate(world.states):
            q = page.states[name]
            given = {"unit": q.unit, "about": q.meaning, "within": q.within, "start": q.value, "is_set": True}
            given |= {"initial": "exact", "depends": {name}}
            if q.of and world.start_of and world.start_of not in q.of:
                given |= {"initial": "calculated", "start": None, "is_set": False}
            self.add(public_of(name), "STATE", i, "output", "continuous", **given)
        for name in world.starts:
            q = page.states[name]
            given = {
                "unit": q.unit,
                "about": f"Start value: {q.meaning}",
                "within": q.within,
                "start": q.value,
            }
            given |= {"initial": "exact", "is_set": True}
            self.add(f"start.{public_of(name)}", "START", places[name], "parameter", "fixed", **given)
        for i, name in enumerate(world.states):
            public, unit = public_of(name), per_second(page.states[name].unit or "1")
            given = {"initial": "calculated", "derivative": public, "depends": self.of_rates[name]}
            place = "DERIVATIVE", i, "local", "continuous"
            self.add(f"der({public})", *place, unit, f"Rate of {public}", **given)
        shown = {row.name for row in self.rows} | {public_of(name) for name in page.outputs}
        for name in world.held:
            q, causality = page.states[name], "output" if page.states[name].name else "local"
            given = {"unit": q.unit, "about": q.meaning, "kind": q.values}
            given |= {"initial": "calculated", "depends": set()}
            if q.name or public_of(name) not in shown:
                self.add_number(public_of(name), "HELD", first + places[name], causality, "discrete", **given)

    def add_outputs(self):
        """Add the outputs. One that nothing but events changes is discrete."""
        for i, (name, function) in enumerate(self.page.outputs.items()):
            kind = function.kind_of_value
            moves = kind is float and name in self.moving_outputs
            given = {"unit": function.unit, "about": function.__doc__ or "", "kind": kind}
            given |= {"initial": "calculated", "depends": self.of_outputs[name]}
            variability = "continuous" if moves else "discrete"
            self.add_number(self.model.public(name), "OUTPUT", i, "output", variability, **given)

    def add_indicators(self):
        """Add event indicators: guards of events, and rates of observed largest values."""
        for i, name in enumerate(self.guards):
            function = self.page.events.get(name) or self.page.observed[name]
            depends = self.of_guards.get(name, set(self.world.knowns))
            given = {"about": f"Event indicator: {function.__doc__ or name}", "depends": depends}
            given["initial"] = "calculated"
            self.add(f"guard.{name}", "GUARD", i, "local", "continuous", **given)

    def type_of(self, row):
        """The type of a variable, in the words of FMI 2.0."""
        if isinstance(row.kind, tuple):
            return "String" if row.kind[0] == "letters" else "Enumeration"
        return TYPES[row.kind]

    def references(self, row, at_start=False):
        """Value references of all that a variable depends on. None: at the start, on every start value."""
        return None if at_start else sorted(self.number[self.model.public(name)] for name in row.depends)

    def used_units(self):
        """Units of all real variables."""
        return dict.fromkeys(row.unit for row in self.rows if self.type_of(row) == "Real")

    def types(self):
        """Types: name, kind, description, attributes and items.

        There is one for each unit, because fmi-sim reads units of types only.
        """
        for unit in self.used_units():
            yield f"Real in {unit}", "Real", None, {"unit": unit, "displayUnit": DISPLAY.get(unit)}, []
        for row in self.rows:
            if self.type_of(row) == "Enumeration":
                items = [{"name": item, "value": str(i)} for i, item in enumerate(row.kind, 1)]
                yield row.name, "Enumeration", None, {}, items

    def attributes(self, row):
        """Attributes of a variable that depend on its type."""
        kind, start = self.type_of(row), row.start
        if start is not None:
            start = str(bool(start)).lower() if row.kind is bool else repr(float(start))
        given = {"start": start}
        if kind == "Enumeration":
            given["declaredType"] = row.name
        if kind == "Real":
            for bound, words in {"min": ("least", "above"), "max": ("most", "below")}.items():
                given[bound] = next((repr(float(row.within[w])) for w in words if w in row.within), None)
            given |= {"declaredType": f"Real in {row.unit}", "reinit": "true" if row.reinit else None}
        return given

    # ---- tables in C

    def requirements(self, functions):
        """Rows of numbers that must not be negative at a start."""
        rows = []
        for name, margin in requirements_in_c(self.page, functions).items():
            function = self.page.model.marked("is_required")[name]
            if function.of_variable not in self.number:
                near = f"`{function.of_variable}` is no variable of the unit"
                raise page_error(function, name, near)
            forget_expressions()
            value = self.page.number(function, self.page.keys[0], name)
            of_parameters = c_boolean(
                not {self.world.names[leaf.value[3:]] for leaf in leaves_of([value])}
                & self.page.states.keys()
            )
            number, bound = (
                self.number[function.of_variable],
                self.number.get(function.allowed.split()[-1], -1),
            )
            allowed = json.dumps(function.allowed)
            rows.append(f"{{{of_parameters}, {number}, {allowed}, {bound}, {margin}}},")
        return rows

    def nominals(self, functions):
        """Rows of typical sizes that the page gives to continuous states."""
        rows = []
        for name, function in self.model.nominals.items():
            forget_expressions()
            value, taken = self.page.number(function, self.page.keys[0], name), {}
            body = statements([value], taken, set()) + f"    return {c_text(value, taken.get)};\n"
            answer = functions.add(f"nominal_{name}", "answer", body, f"Typical size of {name}.")
            rows.append(f"{{{self.world.states.index(name)}, {answer}}},")
        return rows

    def bounds(self):
        """Rows of states that belong to no coordinates, and are bounded or of whole numbers."""
        rows, largest = [], number_text(2.0**53)
        for number, (name, q) in enumerate(self.page.states.items()):
            if q.of or q.is_input or (q.values is float and not q.within):
                continue
            is_whole = q.values is not float
            least, most = ("0.0", "1.0") if q.values is bool else (f"-{largest}", largest)
            if q.within:
                bounds = range_of(q)
                least = number_text(bounds[0]) if abs(bounds[0]) < 1e300 else least
                most = number_text(bounds[1]) if abs(bounds[1]) < 1e300 else most
            moves = c_boolean(name in self.world.moving)
            rows.append(f"{{{number}, {least}, {most}, {c_boolean(is_whole)}, {moves}}},")
        return rows

    def numbers(self):
        """Rows of the numbers of a run, parameters and states: names for messages, and what they may ever be.

        States that move may go far beyond the range of starts, and sums beyond any state.
        """
        page, public = self.page, {}
        names, first = [*page.parameters, *page.states], len(page.parameters)
        for row in self.rows:
            place = row.offset
            if row.storage == "STATE":
                place = names.index(self.world.states[row.offset])
            if row.storage in ("PARAMETER", "INPUT", "HELD", "STATE") and self.type_of(row) != "String":
                public.setdefault(place, row.name)
        starts = {self.world.states[row.offset] for row in self.rows if row.storage == "STATE" and row.is_set}
        of_motion = starts | {n for n in page.inputs if f"{n}_rate" in page.states}
        rows = []
        for place, name in enumerate(names):
            if place < first:
                bounds = [number_text(bound) for bound in range_of(page.parameters[name])]
            else:
                largest = "fmu_largest_state" if name in of_motion else "fmu_largest_sum"
                bounds = [f"-{largest}", largest]
            rows.append(f"{{{json.dumps(public.get(place, name))}, {', '.join(bounds)}}},")
        return rows

    def variable_row(self, row):
        """A row of `fmu_variable`."""
        limits = ("0.0", "1.0") if row.kind is bool else ("-DBL_MAX", "DBL_MAX")
        if row.kind is int:
            limits = "-INT_MAX", number_text(lift(row.largest).value)
        if isinstance(row.kind, tuple) and row.kind[0] != "letters":
            limits = "1.0", f"{len(row.kind)}.0"
        if row.within:
            limits = [number_text(lift(bound).value) for bound in range_of(row)]
        start = number_text(lift(float(row.start or 0)).value)
        unit = json.dumps(row.unit) if row.unit != "1" and row.kind is float else "NULL"
        members = [
            json.dumps(row.name),
            unit,
            f"VARIABLE_{self.type_of(row).upper()}",
            f"STORED_{row.storage}",
        ]
        members += [str(row.offset), f"VARIABILITY_{row.variability.upper()}", c_boolean(row.is_set)]
        members += [c_boolean(row.reinit), *limits, start]
        return f"{{{', '.join(members)}}},"

    def header(self):
        """The header with the sizes of the unit's tables."""
        page, world = self.page, self.world
        counts = {
            "PARAMETER": page.parameters,
            "STATE": page.states,
            "EVENT": page.events,
            "OUTPUT": page.outputs,
        }
        counts |= {"CONTINUOUS": world.states, "GUARD": self.guards, "WORD": self.words}
        counts["ENUMERATION"] = self.enumerations
        counts["REQUIREMENT"] = page.model.marked("is_required")
        lines = [f"UNIT_{name}_COUNT = {len(of)}," for name, of in counts.items()]
        lines.append(f"UNIT_NOMINAL_COUNT = {len(self.model.nominals)},")
        lines.append(f"UNIT_BOUND_COUNT = {len(self.bounds())},")
        lines.append(f"UNIT_CLOCK_IS_RELATIVE = {int(bool(self.times()))},")
        top = TOP.format(name=self.identifier)
        return f"{top}#ifndef UNIT_PAGE_H\n#define UNIT_PAGE_H\n\nenum {{\n{lines_of(lines)}}};\n\n#endif\n"

    def times(self):
        """Names of the states that hold times of a clock."""
        return {name for clock in self.page.clocks for name in self.page.states[clock].held_in}

    def immediate_events(self):
        """Events whose guards are below zero for ever, as bits: only their conditions make them due."""
        page, found = self.page, 0
        for number, name in enumerate(page.events):
            keys = [key for key in page.keys if name in page.watched(key)]
            forget_expressions()
            guards = [page.guard(key, name) for key in keys]
            if guards and all(guard.operation == "number" for guard in guards):
                found |= 1 << number
        return found

    def tables(self):
        """The tables of the unit."""
        page, functions = self.page, Functions(self.page.c)
        names, events = list(page.states), list(page.events)
        starts = {row.offset: c_boolean(row.is_set) for row in self.rows if row.storage == "STATE"}
        shown = [f"{{{names.index(n)}, {starts[i]}}}," for i, n in enumerate(self.world.states)]
        masks = [sum(1 << events.index(n) for n in guard.events) for guard in self.guards.values()]
        peaks = [names.index(guard.into) if guard.into else -1 for guard in self.guards.values()]
        guards = [f"{{UINT64_C({mask}), {into}}}," for mask, into in zip(masks, peaks, strict=True)]
        items = [(n, ", ".join(map(json.dumps, of))) for n, of in self.enumerations.items()]
        described = [f"{{{list(page.outputs).index(n)}, names_of_{n}}}," for n in self.enumerations]
        words = [f"{{{c_boolean(is_output)}, {i}, {json.dumps(of)}}}," for is_output, i, of in self.words]
        ramps = {n: names.index(f"{n}_rate") for n in page.inputs if f"{n}_rate" in names}
        ranges = [json.dumps(allowed(row.within)) if row.within else "NULL" for row in self.rows]
        rows = {
            "unit_state unit_states": shown,
            "unit_enumeration unit_enumerations": described,
            "char *const unit_event_names": [f"{json.dumps(self.event_names[n])}," for n in events],
            "unit_guard unit_guards": guards,
            "unit_word unit_words": words,
            "unit_requirement unit_requirements": self.requirements(functions),
            "unit_number unit_numbers": self.numbers(),
            "unit_bound unit_bounds": self.bounds(),
            "unit_nominal unit_nominals": self.nominals(functions),
            "char *const unit_allowed": [f"{text}," for text in ranges],
            "int unit_input_rates": [f"{ramps.get(n, -1)}," for n in names],
            "bool unit_holds_time": [f"{c_boolean(n in self.times())}," for n in names],
        }
        variables, part = [self.variable_row(row) for row in self.rows], f"tdmf_{self.part}_part"
        parts = [
            TOP.format(name=self.identifier),
            f'#include "{page.c}.h"\n\n#include "unit_tables.h"\n#include "variables.h"\n',
            "#include <float.h>\n#include <limits.h>\n",
            *map(wrapped_text, functions.texts),
            f"const tdmf_model_kind *const unit_model = &tdmf_{page.c}_model;\n",
            f"extern const tdmf_page_part {part};" if self.part else "",
            f"const tdmf_page_part *const unit_part = {f'&{part}' if self.part else 'NULL'};\n",
            f"const fmu_variable fmu_variables[] = {{\n{lines_of(variables)}}};",
            f"const size_t fmu_variable_count = {len(variables)};\n",
            f"const int unit_clock = {names.index(page.clocks[0]) if page.clocks else -1};\n",
            f"const uint64_t unit_immediate_events = UINT64_C({self.immediate_events()});\n",
            *(f"static const char *const names_of_{n}[] = {{{of}}};\n" for n, of in items),
            *(f"const {name}[] = {{\n{lines_of(of or empty(name))}}};\n" for name, of in rows.items()),
        ]
        return "\n".join(parts)


def unit_texts(unit):
    """The C of a unit by file, but for what no page changes and for its identity, FMU_GUID in guid.h."""
    texts = generate(unit.page) | {"unit_page.h": unit.header()}
    texts["unit_page.c"] = unit.tables()
    forget_expressions()
    return texts


def unit_of(model):
    """The unit of a page, with an identity that changes with its content, and its C by file."""
    unit = Unit(Page(model))
    texts = unit_texts(unit)
    rows = [{**vars(row), "depends": sorted(row.depends or ())} for row in unit.rows]
    content = repr((sorted(texts.items()), model.__doc__, experiment_of(model), rows))
    unit.identity = "{" + str(uuid.UUID(hashlib.sha256(content.encode()).hexdigest()[:32])) + "}"
    texts["guid.h"] = f"#define FMU_GUID {json.dumps(unit.identity)}\n"
    return unit, texts
