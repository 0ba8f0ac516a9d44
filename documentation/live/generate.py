#!/usr/bin/env python3
"""Make the live page's tables of modelDescription.xml, presets, glossary and the paper's gaits.

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
sys.path.insert(0, str(ROOT / "scripts"))

from generate_variables import Table, generated  # noqa: E402

PACKAGE = ROOT / "scripts/tdmf_slip"
MODE, PHASE = "contact.mode", "hip.phase"


def values_of(table):
    """Values that `live_accept` takes, in its order: the core's parameters, then the inputs."""
    return [*table.core_parameters(), *table.inputs()]


def starts_of(table):
    """The mechanical states, at which a run begins."""
    return [v for v in table.states if v.value.get("start")]


def outputs_of(table):
    """Numbers that are read off a run, with their places: states, and what the core's outputs hold."""
    shown = [
        v
        for v in table.variables
        if v.type != "String"
        and v.causality not in ("independent", "parameter", "input")
        and v not in table.guards
        and v.group != "solver"
        and not v.derivative
    ]
    return [(v, v.constant if v in table.states else f"offsetof(tdmf_outputs, {v.name})") for v in shown]


def agreement(claim, what):
    """A C99 compile-time check: an array of negative size where the claim is false."""
    return f"typedef char agrees_{what}[({claim}) ? 1 : -1];"


def c_table(table):
    """The C file behind the tables of live.h."""
    groups = {"Real": "LIVE_PARAMETER", "Boolean": "LIVE_FLAG"}
    values = [
        f"    {{LIVE_INPUT, offsetof(tdmf_inputs, {v.name})}},"
        if v.causality == "input"
        else f"    {{{groups[v.type]}, offsetof(tdmf_parameters, {v.name})}},"
        for v in values_of(table)
    ]
    outputs = []
    for variable, storage_name in outputs_of(table):
        kind = {"Real": "LIVE_DOUBLE", "Boolean": "LIVE_BOOL"}.get(variable.type, "LIVE_INT")
        outputs.append(f"    {{{'LIVE_STATE' if variable in table.states else kind}, {storage_name}}},")
    return generated(
        [
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
        ]
    )


def described(variable):
    """A variable as the page knows it; a Boolean is 0 or 1."""
    number = {"Real": float, "Integer": int, "Enumeration": int}.get(variable.type, str)
    given = {key: variable.value.get(key) for key in ("min", "max", "start")}
    if variable.type == "Boolean" and given["start"]:
        number, given = int, {"min": "0", "max": "1", "start": variable.start}
    return {
        "name": variable.name,
        "unit": variable.unit or "",
        "isFlag": variable.type == "Boolean",
        "description": variable.element.get("description"),
        "causality": variable.causality,
        "variability": variable.variability,
        **{key: number(text) for key, text in given.items() if text},
    }


def display_units(table):
    """Display unit of each unit, and how many of these make one."""
    units = {}
    for unit in table.units:
        shown = unit.find("DisplayUnit")
        if shown is not None:
            units[unit.get("name")] = {"name": shown.get("name"), "factor": float(shown.get("factor"))}
    return units


def items(table, name):
    """Name and description of an enumeration's items, by number."""
    return {
        int(item.get("value")): {"name": item.get("name"), "description": item.get("description")}
        for item in table.by_name[name].items
    }


def in_unit(table, name, given):
    """A value of a preset in its variable's unit; a text ends in a unit."""
    if not isinstance(given, str):
        return float(given)
    number, _, unit = given.partition(" ")
    shown = display_units(table)[table.by_name[name].unit]
    if unit != shown["name"]:
        raise SystemExit(f"presets: {name} = {given}: the unit is not {shown['name']}")
    return float(number) / shown["factor"]


def flat(content, prefix=""):
    """Nested tables as whole names."""
    for key, value in content.items():
        if isinstance(value, dict):
            yield from flat(value, f"{prefix}{key}.")
        else:
            yield prefix + key, value


def known_values(table, given):
    """A preset's values that differ from the defaults, of what the page has a control for."""
    known = {v.name for v in (*values_of(table), *starts_of(table))}
    values = {name: in_unit(table, name, value) for name, value in given.items() if name in known}
    return {
        name: value
        for name, value in values.items()
        if not math.isclose(value, float(table.by_name[name].start), rel_tol=1e-15)
    }


def own_presets(table):
    """Those of presets.toml."""
    for given in tomllib.loads((HERE / "presets.toml").read_text(encoding="utf-8"))["preset"]:
        name, values = given.pop("name"), dict(flat(given))
        for value in values:
            table.find(value, f"presets.toml, {name!r},")
        yield {"name": name, "values": known_values(table, values)}


def presets(table):
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
    found.append({"name": "human scale", "values": known_values(table, dict(flat(human)))})
    return [*found, *own_presets(table)]


def paper_units(table):
    """Label of each unit where the runner is in the paper's units."""
    label = runpy.run_path(str(PACKAGE / "variables/units.py"))["paper_label"]
    labels = {unit: label(*powers) for unit, powers in table.dimensions().items() if any(powers)}
    return {**labels, "deg/s": "deg sqrt(k/m)"}


def terms():
    """Words that the page explains: by name, a sentence."""
    known = tomllib.loads((HERE.parent / "glossary.toml").read_text(encoding="utf-8"))["live"]
    return {
        name: f"{term['title'][0].upper()}{term['title'][1:]}: {term['text']}" for name, term in known.items()
    }


def page_table(table):
    """The page's module of data."""
    data = {
        "values": [described(v) for v in values_of(table)],
        "starts": [described(v) for v in starts_of(table)],
        "outputs": [described(v) for v, _ in outputs_of(table)],
        "displayUnits": display_units(table),
        "dimensions": table.dimensions(),
        "contactModes": items(table, MODE),
        "hipPhases": items(table, PHASE),
        "apex": [described(v) for v in table.variables if v.group == "apex" and v.name != "apex.time"],
        "presets": presets(table),
        "aliases": table.aliases(),
        "paperUnits": paper_units(table),
        "terms": terms(),
    }
    lines = [
        f"export const {name} = {json.dumps(value, ensure_ascii=False)};" for name, value in data.items()
    ]
    return "\n".join(
        ["// Generated from modelDescription.xml by documentation/live/generate.py.", *lines, ""]
    )


def main():
    """Run the command."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("what", choices=["c", "page"])
    parser.add_argument("output", type=pathlib.Path)
    arguments = parser.parse_args()
    table = Table(ROOT / "modelDescription.xml")
    text = {"c": c_table, "page": page_table}[arguments.what](table)
    arguments.output.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
