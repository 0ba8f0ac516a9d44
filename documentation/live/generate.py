#!/usr/bin/env python3
"""Make the live page's tables of the runner's unit, presets, glossary and the paper's gaits.

    generate.py c     OUTPUT    C: where each value and output is in the core's structs
    generate.py page  OUTPUT    JavaScript: names, units, ranges, defaults and descriptions; presets; words

Needs nothing but Python's standard library, because the C build runs it.
"""

import argparse
import json
import math
import pathlib
import runpy
import sys
import tomllib

HERE = pathlib.Path(__file__).parent
ROOT = HERE.parents[1]
sys.dont_write_bytecode = True  # a build leaves the sources alone
sys.path.insert(0, str(ROOT))

from c_core.hybrid.unit import DEGREES, DISPLAY  # noqa: E402
from c_core.pages.tables import (  # noqa: E402
    constant,
    dimensions,
    group_of,
    inputs_of,
    mechanical_of,
    parameters_of,
    short_names,
)
from c_core.pages.unit import runner_unit  # noqa: E402

PACKAGE = ROOT / "scripts/tdmf_slip"
MODE, PHASE = "contact.mode", "hip.phase"


def values_of(unit):
    """Values that `live_accept` takes, in its order: the core's parameters, then the inputs."""
    return [*parameters_of(unit), *inputs_of(unit)]


def starts_of(unit):
    """The mechanical states, at which a run begins."""
    return mechanical_of(unit)


def outputs_of(unit):
    """Numbers that are read off a run, with their places: states, and what the core's outputs hold."""
    shown = (row for row in unit.rows if row.storage in ("STATE", "OUTPUT", "HELD"))
    return [
        (row, constant(row) if row.storage == "STATE" else f"offsetof(tdmf_outputs, {row.name})")
        for row in shown
        if unit.type_of(row) != "String"
    ]


def agreement(claim, what):
    """A C99 compile-time check: an array of negative size where the claim is false."""
    return f"typedef char agrees_{what}[({claim}) ? 1 : -1];"


def c_table(unit):
    """The C file behind the tables of live.h."""
    groups = {"Real": "LIVE_PARAMETER", "Boolean": "LIVE_FLAG"}
    values = [
        f"    {{LIVE_INPUT, offsetof(tdmf_inputs, {row.name})}},"
        if row.causality == "input"
        else f"    {{{groups[unit.type_of(row)]}, offsetof(tdmf_parameters, {row.name})}},"
        for row in values_of(unit)
    ]
    outputs = []
    for row, place in outputs_of(unit):
        kind = {"Real": "LIVE_DOUBLE", "Boolean": "LIVE_BOOL"}.get(unit.type_of(row), "LIVE_INT")
        outputs.append(f"    {{{'LIVE_STATE' if row.storage == 'STATE' else kind}, {place}}},")
    return "\n".join(
        [
            "/* Derived from c_core/pages by documentation/live/generate.py. */",
            '#include "live.h"',
            "",
            "#include <stddef.h>",
            "",
            "const live_value live_values[] = {",
            *values,
            "};",
            "const int live_value_count = sizeof live_values / sizeof live_values[0];",
            agreement(f"{len(values)} <= LIVE_VALUE_CAPACITY", "values_fit"),
            "",
            "const live_output live_outputs[] = {",
            *outputs,
            "};",
            "const int live_output_count = sizeof live_outputs / sizeof live_outputs[0];",
            agreement(f"{len(outputs)} <= LIVE_OUTPUT_CAPACITY", "outputs_fit"),
            "",
        ]
    )


def described(unit, row):
    """A variable as the page knows it; a Boolean is 0 or 1."""
    kind, known = unit.type_of(row), unit.attributes(row)
    number = float if kind == "Real" else int
    given = {key: known.get(key) for key in ("min", "max", "start")}
    if kind == "Boolean" and row.start is not None:
        given = {"min": 0, "max": 1, "start": row.start}
    return {
        "name": row.name,
        "unit": row.unit if kind == "Real" else "",
        "isFlag": kind == "Boolean",
        "description": row.about,
        "causality": row.causality,
        "variability": row.variability,
        **{key: number(value) for key, value in given.items() if value is not None},
    }


def display_units(unit):
    """Display unit of each unit, and how many of these make one."""
    return {name: {"name": DISPLAY[name], "factor": DEGREES} for name in unit.used_units() if name in DISPLAY}


def named(unit, name):
    """The variable of that name."""
    return unit.rows[unit.number[name]]


def items(unit, name):
    """Name and description of an enumeration's items, by number."""
    meanings = named(unit, name).items
    return {i: {"name": item, "description": meanings[item]} for i, item in enumerate(meanings, 1)}


def in_unit(unit, name, given):
    """A value of a preset in its variable's unit; a text ends in a unit."""
    if not isinstance(given, str):
        return float(given)
    number, _, measure = given.partition(" ")
    if measure != DISPLAY[named(unit, name).unit]:
        raise SystemExit(f"presets: {name} = {given}: the unit is not {DISPLAY[named(unit, name).unit]}")
    return float(number) / DEGREES


def flat(content, prefix=""):
    """Nested tables as whole names."""
    for key, value in content.items():
        if isinstance(value, dict):
            yield from flat(value, f"{prefix}{key}.")
        else:
            yield prefix + key, value


def known_values(unit, given):
    """A preset's values that differ from the defaults, of what the page has a control for."""
    known = {row.name for row in (*values_of(unit), *starts_of(unit))}
    values = {name: in_unit(unit, name, value) for name, value in given.items() if name in known}
    return {
        name: value
        for name, value in values.items()
        if not math.isclose(value, named(unit, name).start, rel_tol=1e-15)
    }


def own_presets(unit):
    """Those of presets.toml."""
    for given in tomllib.loads((HERE / "presets.toml").read_text(encoding="utf-8"))["preset"]:
        name, values = given.pop("name"), dict(flat(given))
        for value in values:
            if value not in unit.number:
                raise SystemExit(f"presets.toml, {name!r}, names {value}, which is no variable")
        yield {"name": name, "values": known_values(unit, values)}


def presets(unit):
    """The paper's gaits, the runner of human size, the page's own."""
    gaits = json.loads((PACKAGE / "paper/reference_gaits.json").read_text(encoding="utf-8"))["gaits"]
    found = [
        {
            "name": f"paper, friction {gait['friction']:g}",
            "word": gait["word"],
            "values": {"ground.friction": gait["friction"]},
            "apex": gait["apex"],
        }
        for gait in gaits
        if not gait["swing_clamp"]  # as by default
    ]
    human = tomllib.loads((PACKAGE / "variables/presets/human.toml").read_text(encoding="utf-8"))
    found.append({"name": "human scale", "values": known_values(unit, dict(flat(human)))})
    return [*found, *own_presets(unit)]


def paper_units(unit):
    """Label of each unit where the runner is in the paper's units."""
    label = runpy.run_path(str(PACKAGE / "variables/units.py"))["paper_label"]
    labels = {name: label(*powers) for name, powers in dimensions(unit).items() if any(powers)}
    return {**labels, "deg/s": "deg sqrt(k/m)"}


def terms():
    """Words that the page explains: by name, a sentence."""
    known = tomllib.loads((HERE.parent / "glossary.toml").read_text(encoding="utf-8"))["live"]
    return {
        name: f"{term['title'][0].upper()}{term['title'][1:]}: {term['text']}" for name, term in known.items()
    }


def page_table(unit):
    """The page's module of data."""
    data = {
        "values": [described(unit, row) for row in values_of(unit)],
        "starts": [described(unit, row) for row in starts_of(unit)],
        "outputs": [described(unit, row) for row, _ in outputs_of(unit)],
        "displayUnits": display_units(unit),
        "dimensions": dimensions(unit),
        "contactModes": items(unit, MODE),
        "hipPhases": items(unit, PHASE),
        "apex": [
            described(unit, row) for row in unit.rows if group_of(row) == "apex" and row.name != "apex.time"
        ],
        "presets": presets(unit),
        "aliases": short_names(unit),
        "paperUnits": paper_units(unit),
        "terms": terms(),
    }
    lines = [
        f"export const {name} = {json.dumps(value, ensure_ascii=False)};" for name, value in data.items()
    ]
    return "\n".join(["// Derived from c_core/pages by documentation/live/generate.py.", *lines, ""])


def main():
    """Run the command."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("what", choices=["c", "page"])
    parser.add_argument("output", type=pathlib.Path)
    arguments = parser.parse_args()
    text = {"c": c_table, "page": page_table}[arguments.what](runner_unit())
    arguments.output.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
