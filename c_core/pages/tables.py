"""Tables of the runner's unit for the C library, the Python package and the unit's documentation."""

import html
from types import SimpleNamespace

from ..hybrid.description import base_unit
from ..hybrid.unit import DEGREES, DISPLAY
from .unit import MODELS, OTHER_SHORT_NAMES, QUANTITIES, SCALES, UNITS

C_TYPES = {float: "double", bool: "bool"}
TOP = "Derived from c_core/pages by scripts/derive_equations: edit the pages, not this."
DECLARATIONS = """\
/* Parameters, inputs, states and guards. {top} */
#ifndef TDMF_SLIP_VARIABLES_H
#define TDMF_SLIP_VARIABLES_H

#include <stdbool.h>

/* SI units, angles in rad. A member's path is the variable's name in the FMU: `leg.stiffness`. The defaults
 * are Table 1 of the paper with m = k = l0 = 1. */
{parameters}

/* Inputs, which may change during a run. Their rates, per second, have the same shape; the rate of an input
 * that is held is zero. Discrete inputs, such as ground.height, ground.slope and control, change at events
 * only: their rates are always zero. */
{inputs}

/* Counts of the numbers among the parameters, which come first in their struct, of the inputs, and of the
 * settings: inputs and tunable parameters. */
enum {{
    TDMF_PARAMETER_COUNT = {parameter_count},
    TDMF_INPUT_COUNT = {input_count},
    TDMF_SETTING_LIMIT = {setting_count}
}};

/* Indices of the states of a run, which are those of its page. TDMF_FOOT_X and the next seven are q and its
 * rate, in the order of the paper's q = (x, y, r, theta). Other states are integrals along the run, its last
 * stride and apex, and its memory. Some states repeat inputs, the mode, or q in other coordinates: each call
 * sets them anew. Times among the states count from the start of the run. The leg's angle is never wrapped:
 * the hip unwinds a leg that has wound. After a thousand turns an angle is known to 1e-12, and so is all that
 * follows from it. */
{states}

/* Each guard is a pure number, positive while its event is to come; at zero or below, the event is due. A
 * guard that the present mode does not watch is 1. Every armed guard carries a margin of TDMF_GUARD_MARGIN,
 * so that it is positive even where its event has just happened. */
{guards}

#endif
"""
RANGES = """\
/* {top} */
#include "ranges.h"

#include <float.h>

const tdmf_range tdmf_parameter_ranges[TDMF_PARAMETER_COUNT] = {{
{parameters}
}};

const tdmf_flag tdmf_parameter_flags[] = {{
{flags}
}};
const size_t tdmf_parameter_flag_count =
    sizeof tdmf_parameter_flags / sizeof tdmf_parameter_flags[0];

const tdmf_range tdmf_input_ranges[TDMF_INPUT_COUNT] = {{
{inputs}
}};

const tdmf_range tdmf_state_ranges[TDMF_MECHANICAL_COUNT] = {{
{states}
}};
"""
VARIABLES_HERE = "<!-- variables -->"
"""Placeholder of the list of variables in the page of documentation."""


def group_of(row):
    """The part of a name before the first dot."""
    return row.name.split(".")[0]


def constant(row):
    """The C enumerator of a state or a guard: foot.x -> TDMF_FOOT_X."""
    return "TDMF_" + row.name.upper().replace(".", "_")


def parameters_of(unit):
    """The parameters in `tdmf_parameters`; others are the unit's own."""
    return [row for row in unit.rows if row.storage == "PARAMETER"]


def inputs_of(unit):
    """The variables in `tdmf_inputs`."""
    return [row for row in unit.rows if row.causality == "input"]


def states_of(unit):
    """The states of the page, by their names in the unit."""
    public = unit.page.model.public
    return [SimpleNamespace(name=public(name), about=state.meaning, unit=state.unit or "1")
            for name, state in unit.page.states.items()]


def mechanical_of(unit):
    """The states that take a start value."""
    return [row for row in unit.rows if row.storage == "STATE" and row.is_set]


def comment_of(row):
    """A comment of C: the meaning of a variable, and its unit."""
    return f"/* {row.about.removeprefix('Event indicator: ')}{'' if row.unit == '1' else f', {row.unit}'} */"


def is_flag(row):
    """True if a variable is a Boolean."""
    return row.kind is bool


def struct(name, rows):
    """A struct with a member of each variable's path: numbers one after the other, Booleans after them."""
    groups = {}
    for row in rows:
        groups.setdefault(group_of(row), []).append(row)
    lines = ["typedef struct {"]
    for group, members in sorted(groups.items(), key=lambda group: any(map(is_flag, group[1]))):
        members.sort(key=is_flag)
        names = [row.name.partition(".")[2] for row in members]
        inner = [f"{C_TYPES[row.kind]} {name or group}; {comment_of(row)}"
                 for name, row in zip(names, members, strict=True)]
        lines += inner if names == [""] else ["struct {", *inner, f"}} {group};"]
    return "\n".join([*lines, f"}} {name};"])


def enumeration(rows, count, name=""):
    """An enumeration of variables."""
    opening, end = ("typedef enum {", f"}} {name};") if name else ("enum {", "};")
    return "\n".join([opening, *(f"{constant(row)}, {comment_of(row)}" for row in rows), count, end])


def declarations(unit):
    """The public header tdmf_slip/variables.h, before it is formatted."""
    inputs, parameters = inputs_of(unit), parameters_of(unit)
    guards = [row for row in unit.rows if row.storage == "GUARD"]
    return DECLARATIONS.format(
        top=TOP, parameters=struct("tdmf_parameters", parameters), inputs=struct("tdmf_inputs", inputs),
        parameter_count=sum(not is_flag(row) for row in parameters), input_count=len(inputs),
        setting_count=len(inputs) + sum(row.variability == "tunable" for row in parameters),
        states=enumeration(states_of(unit), "TDMF_STATE_COUNT"),
        guards=enumeration(guards, "TDMF_GUARD_COUNT", "tdmf_guard"))


def range_row(row, offset):
    """A row of `tdmf_range`."""
    least, most = row.within["least"], row.within["most"]
    changes = [row.variability == "continuous", row.variability != "fixed"]
    numbers = f"{float(least)!r}, {float(most)!r}, {float(row.start)!r}"
    flags = ", ".join(str(change).lower() for change in changes)
    return f'    {{"{row.name}", "{row.unit}", {numbers}, {flags}, {row.offset}, {offset}}},'


def ranges(unit):
    """The C file behind c_core/model/ranges.h."""
    numbers, flags = [], []
    for row in parameters_of(unit):
        offset = f"offsetof(tdmf_parameters, {row.name})"
        if is_flag(row):
            flags.append(f'    {{"{row.name}", {str(bool(row.start)).lower()}, {offset}}},')
        else:
            numbers.append(range_row(row, offset))
    return RANGES.format(
        top=TOP, parameters="\n".join(numbers), flags="\n".join(flags),
        inputs="\n".join(range_row(row, f"offsetof(tdmf_inputs, {row.name})") for row in inputs_of(unit)),
        states="\n".join(range_row(row, "0") for row in mechanical_of(unit)))


def documentation_page(unit, template):
    """The page of documentation, with a row for every variable."""
    head = ("variable", "unit", "range", "default", "kind", "meaning")
    lines = ['<table class="all">', "<tr>" + "".join(f"<th>{title}</th>" for title in head) + "</tr>"]
    for row in unit.rows:
        known = unit.attributes(row)
        low, high, start = (known.get(name) or "" for name in ("min", "max", "start"))
        allowed = f"{low} to {high}" if high else f"from {low}" if low else ""
        if unit.type_of(row) == "Enumeration":
            allowed, start = ", ".join(row.kind), row.kind[int(start) - 1] if start else ""
        kinds = {"tunable": "tunable parameter", "discrete": f"discrete {row.causality}"}
        measure = "" if row.unit == "1" else row.unit
        cells = [measure, allowed, start, kinds.get(row.variability, row.causality), row.about]
        texts = [f"<code>{row.name}</code>", *map(html.escape, cells)]
        lines.append("<tr>" + "".join(f"<td>{text}</td>" for text in texts) + "</tr>")
    before, after = template.split(VARIABLES_HERE)
    return before + "\n".join([*lines, "</table>"]) + after


def dimensions(unit):
    """Powers of length, time and mass of each unit; an angle has none."""
    powers = {name: base_unit(name) for name in [*unit.used_units(), *UNITS]}
    return {name: tuple(of.get(base, 0) for base in ("m", "s", "kg")) for name, of in powers.items()}


def short_names(unit):
    """Names of parameters and inputs by their short names."""
    names = [row.name for row in [*parameters_of(unit), *inputs_of(unit)] if group_of(row) != "control"]
    return {OTHER_SHORT_NAMES.get(name, name.rpartition(".")[2]): name for name in names if "." in name}


def python_variable(unit, row):
    """The fields of the package's `Variable`, in their order."""
    kind, known = unit.type_of(row), unit.attributes(row)
    start = None
    if row.start is not None and kind != "String":
        start = bool(row.start) if kind == "Boolean" else float(row.start)
    return (
        row.name, unit.number[row.name], kind, row.unit if kind == "Real" else "", row.about, row.causality,
        row.variability, row.is_set, float(known.get("min") or "-inf"), float(known.get("max") or "inf"),
        start, dict(enumerate(row.kind, 1)) if kind == "Enumeration" else {},
        {DISPLAY[row.unit]: DEGREES} if kind == "Real" and row.unit in DISPLAY else {})


def package_table(unit):
    """The module of data of the Python package."""
    strides = [(row.name.partition(".")[2], row.unit, row.about, "")
               for row in unit.rows if group_of(row) == "stride"]
    tables = {
        "VARIABLES": [python_variable(unit, row) for row in unit.rows],
        "QUANTITIES": [(*quantity, "")[:4] for quantity in QUANTITIES] + strides,
        "MODELS": [(name, tuple(at_apex.split()), tuple(of_stride.split()), SCALES)
                   for name, (at_apex, of_stride) in MODELS.items()],
    }
    names = {
        "PARAMETERS": parameters_of(unit), "INPUTS": inputs_of(unit),
        "STATES": mechanical_of(unit),
    }
    lines = [f'"""{TOP}"""', "from math import inf", f"DIMENSIONS = {dimensions(unit)}",
             f"ALIASES = {short_names(unit)}"]
    lines += [f"{name} = {tuple(row.name for row in rows)}" for name, rows in names.items()]
    for name, rows in tables.items():
        lines.append("\n".join([f"{name} = (", *(f"{row!r}," for row in rows), ")"]))
    return "\n".join([*lines, ""])
