"""The tables of a page's unit in C."""

import json

from .c_text import lines_of, number_text, wrapped_text
from .errors import page_error
from .expressions import forget_expressions, leaves_of, lift
from .instants import Functions, answer_in_c
from .quantities import BOUNDS, range_of
from .tables import c_boolean

TOP = "/* Derived from the page {name}: edit the page, not this. */\n"


def allowed(within):
    """The range of a quantity in words."""
    if within.keys() == {"least", "most"}:
        return f"from {within['least']:.15g} to {within['most']:.15g}"
    return " and ".join(f"{BOUNDS[word][0]} {bound:.15g}" for word, bound in within.items())


def empty(name):
    """The only row of a table in C that would have none. A row of a struct is in braces."""
    return ["{0},"] if name.startswith("unit_") else ["0,"]


def requirements_in_c(page, functions):
    """Functions of C for the numbers that must not be negative at a start, by their names on the page."""
    found = {}
    for name, function in page.model.marked("is_required").items():
        forget_expressions()
        body = answer_in_c(page.number(function, page.keys[0], name))
        about = f"{name}: {function.__doc__ or ''}"
        found[name] = functions.add(f"require_{name}", "answer", body, about)
    return found


def requirements(unit, functions):
    """Rows of numbers that must not be negative at a start."""
    page, rows = unit.page, []
    for name, margin in requirements_in_c(page, functions).items():
        function = page.model.marked("is_required")[name]
        if function.of_variable not in unit.number:
            near = f"`{function.of_variable}` is no variable of the unit"
            raise page_error(function, name, near)
        forget_expressions()
        names = map(unit.world.name_of, leaves_of([page.number(function, page.keys[0], name)]))
        of_parameters = c_boolean(page.states.keys().isdisjoint(names))
        number = unit.number[function.of_variable]
        bound = unit.number.get(function.allowed.split()[-1], -1)
        rows.append(f"{{{of_parameters}, {number}, {json.dumps(function.allowed)}, {bound}, {margin}}},")
    return rows


def nominals(unit, functions):
    """Rows of typical sizes that the page gives to continuous states."""
    rows = []
    for name, function in unit.model.nominals.items():
        forget_expressions()
        body = answer_in_c(unit.page.number(function, unit.page.keys[0], name))
        answer = functions.add(f"nominal_{name}", "answer", body, f"Typical size of {name}.")
        rows.append(f"{{{unit.world.states.index(name)}, {answer}}},")
    return rows


def bounds(unit):
    """Rows of states that belong to no coordinates, and are bounded or of whole numbers."""
    rows, largest = [], number_text(2.0**53)
    for number, (name, q) in enumerate(unit.page.states.items()):
        if q.of or q.is_input or (q.values is float and not q.within):
            continue
        is_whole = q.values is not float
        least, most = ("0.0", "1.0") if q.values is bool else (f"-{largest}", largest)
        if q.within:
            bounds = range_of(q)
            least = number_text(bounds[0]) if abs(bounds[0]) < 1e300 else least
            most = number_text(bounds[1]) if abs(bounds[1]) < 1e300 else most
        moves = c_boolean(name in unit.world.moving)
        rows.append(f"{{{number}, {least}, {most}, {c_boolean(is_whole)}, {moves}}},")
    return rows


def numbers(unit):
    """Rows of the numbers of a run, parameters and states: names for messages, and ranges.

    States that move may go far beyond the range of starts, and sums beyond any state.
    """
    page, public = unit.page, {}
    names, first = [*page.parameters, *page.states], len(page.parameters)
    for row in unit.rows:
        if row.storage in ("PARAMETER", "INPUT", "HELD", "STATE") and unit.type_of(row) != "String":
            public.setdefault(row.offset, row.name)
    starts = {names[row.offset] for row in unit.rows if row.storage == "STATE" and row.is_set}
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


def variable_row(unit, row):
    """A row of `fmu_variable`."""
    limits = ("0.0", "1.0") if row.kind is bool else ("-DBL_MAX", "DBL_MAX")
    if row.kind is int:
        limits = "-INT_MAX", number_text(lift(row.largest).value)
    if isinstance(row.kind, tuple) and row.kind[0] != "letters":
        limits = "1.0", f"{len(row.kind)}.0"
    if row.within and row.kind is float:
        limits = [number_text(lift(bound).value) for bound in range_of(row)]
    start = number_text(lift(float(row.start or 0)).value)
    measure = json.dumps(row.unit) if row.unit != "1" and row.kind is float else "NULL"
    members = [
        json.dumps(row.name),
        measure,
        f"VARIABLE_{unit.type_of(row).upper()}",
        f"STORED_{row.storage}",
    ]
    members += [str(row.offset), f"VARIABILITY_{row.variability.upper()}", c_boolean(row.is_set)]
    in_words = json.dumps(allowed(row.within)) if row.within and row.kind is float else "NULL"
    members += [c_boolean(row.reinit), *limits, start, in_words]
    return f"{{{', '.join(members)}}},"


def header(unit):
    """The header with the sizes of the unit's tables."""
    page, world = unit.page, unit.world
    counts = {
        "PARAMETER": page.parameters,
        "STATE": page.states,
        "MODE": page.keys,
        "EVENT": page.events,
        "OUTPUT": page.outputs,
    }
    counts |= {"CONTINUOUS": world.states, "GUARD": unit.guards, "WORD": unit.words}
    counts["ENUMERATION"] = unit.enumerations
    counts["REQUIREMENT"] = page.model.marked("is_required")
    lines = [f"UNIT_{name}_COUNT = {len(of)}," for name, of in counts.items()]
    lines.append(f"UNIT_NOMINAL_COUNT = {len(unit.model.nominals)},")
    lines.append(f"UNIT_BOUND_COUNT = {len(bounds(unit))},")
    lines.append(f"UNIT_CLOCK_IS_RELATIVE = {int(bool(times(unit)))},")
    top = TOP.format(name=unit.model.__name__)
    return f"{top}#ifndef UNIT_PAGE_H\n#define UNIT_PAGE_H\n\nenum {{\n{lines_of(lines)}}};\n\n#endif\n"


def times(unit):
    """Names of the states that hold times of a clock."""
    return {name for clock in unit.page.clocks for name in unit.page.states[clock].held_in}


def immediate_events(unit):
    """Events whose guards are always below zero, as bits: their conditions alone make them due."""
    page, found = unit.page, 0
    for number, name in enumerate(page.events):
        keys = [key for key in page.keys if name in page.watched(key)]
        forget_expressions()
        guards = [page.guard(key, name) for key in keys]
        if guards and all(guard.operation == "number" for guard in guards):
            found |= 1 << number
    return found


def tables(unit):
    """The tables of the unit."""
    page, functions = unit.page, Functions(unit.page.c)
    names, events = list(page.states), list(page.events)
    first = len(page.parameters)
    shown = [f"{{{r.offset - first}, {c_boolean(r.is_set)}}}," for r in unit.rows if r.storage == "STATE"]
    masks = [sum(1 << events.index(n) for n in guard.events) for guard in unit.guards.values()]
    peaks = [names.index(guard.into) if guard.into else -1 for guard in unit.guards.values()]
    guards = [f"{{UINT64_C({mask}), {into}}}," for mask, into in zip(masks, peaks, strict=True)]
    items = [(n, ", ".join(map(json.dumps, of))) for n, of in unit.enumerations.items()]
    described = [f"{{{list(page.outputs).index(n)}, names_of_{n}}}," for n in unit.enumerations]
    words = [f"{{STORED_{storage}, {i}, {json.dumps(of)}}}," for storage, i, of in unit.words]
    ramps = {n: names.index(f"{n}_rate") for n in page.inputs if f"{n}_rate" in names}
    rows = {
        "unit_state unit_states": shown,
        "unit_enumeration unit_enumerations": described,
        "char *const unit_event_names": [f"{json.dumps(unit.event_names[n])}," for n in events],
        "unit_guard unit_guards": guards,
        "unit_word unit_words": words,
        "unit_requirement unit_requirements": requirements(unit, functions),
        "unit_number unit_numbers": numbers(unit),
        "unit_bound unit_bounds": bounds(unit),
        "unit_nominal unit_nominals": nominals(unit, functions),
        "int unit_input_rates": [f"{ramps.get(n, -1)}," for n in names],
        "bool unit_holds_time": [f"{c_boolean(n in times(unit))}," for n in names],
    }
    variables, part = [variable_row(unit, row) for row in unit.rows], f"tdmf_{unit.part}_part"
    parts = [
        TOP.format(name=unit.model.__name__),
        f'#include "{page.c}.h"\n\n#include "unit_tables.h"\n',
        "#include <float.h>\n#include <limits.h>\n",
        *map(wrapped_text, functions.texts),
        f"const tdmf_model_kind *const unit_model = &tdmf_{page.c}_model;\n",
        f"extern const tdmf_page_part {part};" if unit.part else "",
        f"const tdmf_page_part *const unit_part = {f'&{part}' if unit.part else 'NULL'};\n",
        f"const fmu_variable fmu_variables[] = {{\n{lines_of(variables)}}};",
        f"const size_t fmu_variable_count = {len(variables)};\n",
        f"const int unit_clock = {names.index(page.clocks[0]) if page.clocks else -1};\n",
        f"const uint64_t unit_immediate_events = UINT64_C({immediate_events(unit)});\n",
        *(f"static const char *const names_of_{n}[] = {{{of}}};\n" for n, of in items),
        *(f"const {name}[] = {{\n{lines_of(of or empty(name))}}};\n" for name, of in rows.items()),
    ]
    return "\n".join(parts)
