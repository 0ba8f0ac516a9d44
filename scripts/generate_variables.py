#!/usr/bin/env python3
"""Make everything that follows from modelDescription.xml, the one table of variables.

    generate_variables.py ranges      SOURCE OUTPUT     C: ranges and starts for the core
    generate_variables.py variables   SOURCE OUTPUT     C: value references and storage for the unit
    generate_variables.py description SOURCE OUTPUT --version V     the description inside the FMU
    generate_variables.py guid        SOURCE OUTPUT --version V     C: the same description's guid

Needs nothing but Python's standard library, because the C build runs it.
"""

import argparse
import hashlib
import pathlib
import uuid
import xml.etree.ElementTree as ElementTree

# Parameters of these groups belong to the unit; all others are the core's.
UNIT_GROUPS = {"status", "solver"}
# C's enumerators of the enumerations' items.
ENUMERATORS = {"contact.mode": "TDMF_CONTACT_", "hip.phase": "TDMF_PHASE_", "solver.method": "SOLVER_"}


class Variable:
    """One ScalarVariable with its declared type folded in."""

    def __init__(self, element, types, value_reference):
        """Read the element; `types` are the declared types by name."""
        self.element = element
        self.value_reference = value_reference
        self.name = element.get("name")
        self.causality = element.get("causality")
        self.variability = element.get("variability")
        self.initial = element.get("initial")
        self.value = element[0]
        self.type = self.value.tag
        declared = types.get(self.value.get("declaredType"))
        self.unit = self.value.get("unit") or (declared.get("unit") if declared is not None else None)
        self.items = [] if declared is None else list(declared)
        self.derivative = self.value.get("derivative")

    @property
    def group(self):
        """The part of the name before the first dot."""
        return self.name.split(".")[0]

    @property
    def constant(self):
        """The C enumerator of a state: foot.x -> TDMF_FOOT_X."""
        return "TDMF_" + self.name.upper().replace(".", "_")

    def limit(self, which):
        """`min` or `max` as C, the largest double where there is none."""
        sign = {"min": "-", "max": ""}[which]
        return self.value.get(which, sign + "DBL_MAX")

    @property
    def start(self):
        """The start value as C, 0 where there is none."""
        start = self.value.get("start", "0")
        return {"true": "1", "false": "0"}.get(start, start)


class Table:
    """The variables of a model description, in order; a value reference is a position."""

    def __init__(self, source):
        """Read the model description in the file `source`."""
        self.tree = ElementTree.parse(source)
        self.root = self.tree.getroot()
        types = {t.get("name"): t[0] for t in self.root.find("TypeDefinitions")}
        elements = self.root.find("ModelVariables")
        self.variables = [Variable(e, types, i) for i, e in enumerate(elements)]
        self.by_name = {v.name: v for v in self.variables}
        if len(self.by_name) != len(self.variables):
            raise SystemExit(f"{source}: a variable name occurs twice")
        self.derivatives = [v for v in self.variables if v.derivative]
        self.states = [self.find(v.derivative, v.name) for v in self.derivatives]

    def find(self, name, wanted_by):
        """The variable of that name, or a clear end."""
        if name not in self.by_name:
            raise SystemExit(f"modelDescription.xml: {wanted_by} names {name}, which is no variable")
        return self.by_name[name]

    def core_parameters(self):
        """The parameters in `tdmf_parameters`."""
        return [v for v in self.variables if v.causality == "parameter" and v.group not in UNIT_GROUPS]

    def inputs(self):
        """The variables in `tdmf_inputs`."""
        return [v for v in self.variables if v.causality == "input"]


def generated(lines):
    """A C file of these lines, marked as generated."""
    return "\n".join(
        ["/* Generated from modelDescription.xml by scripts/generate_variables.py. */", *lines, ""]
    )


# ---- the core's table ----------------------------------------------------------------------------------


def range_row(variable, offset):
    """A row of `tdmf_range`."""
    unit = f'"{variable.unit}"' if variable.unit else "NULL"
    limits = f"{variable.limit('min')}, {variable.limit('max')}"
    return f'    {{"{variable.name}", {unit}, {limits}, {variable.start}, {offset}}},'


def ranges(table):
    """The C file behind c_core/model/ranges.h."""
    parameters = [range_row(v, f"offsetof(tdmf_parameters, {v.name})") for v in table.core_parameters()]
    inputs = [range_row(v, f"offsetof(tdmf_inputs, {v.name})") for v in table.inputs()]
    mechanical = [range_row(v, "0") for v in table.states if v.value.get("start")]
    return generated(
        [
            '#include "ranges.h"',
            "",
            "#include <float.h>",
            "",
            "const tdmf_range tdmf_parameter_ranges[] = {",
            *parameters,
            "};",
            "const size_t tdmf_parameter_count =",
            "    sizeof tdmf_parameter_ranges / sizeof tdmf_parameter_ranges[0];",
            "",
            "const tdmf_range tdmf_input_ranges[TDMF_INPUT_COUNT] = {",
            *inputs,
            "};",
            "",
            "const tdmf_range tdmf_state_ranges[TDMF_MECHANICAL_COUNT] = {",
            *mechanical,
            "};",
        ]
    )


# ---- the unit's table ----------------------------------------------------------------------------------


def storage(variable, table):
    """Where the unit keeps a variable: (kind, C expression of its offset or index)."""
    if variable.causality == "independent":
        return "TIME", "0"
    if variable.derivative:
        return "DERIVATIVE", table.by_name[variable.derivative].constant
    if variable in table.states:
        return "STATE", variable.constant
    if variable.causality == "parameter":
        if variable.group in UNIT_GROUPS:
            return "SETTING", f"offsetof(unit_settings, {variable.name})"
        return "PARAMETER", f"offsetof(tdmf_parameters, {variable.name})"
    if variable.causality == "input":
        return "INPUT", f"offsetof(tdmf_inputs, {variable.name})"
    if variable.group == "solver":
        return "WORK", f"offsetof(unit_work, {variable.name})"
    return "OUTPUT", f"offsetof(tdmf_outputs, {variable.name})"


def variable_row(variable, table):
    """A row of `unit_variable`."""
    kind, place = storage(variable, table)
    unit = f'"{variable.unit}"' if variable.unit else "NULL"
    kind_of_value = "INTEGER" if variable.type == "Enumeration" else variable.type.upper()
    settable_before_start = (
        "true" if variable.initial == "exact" or variable.causality == "input" else "false"
    )
    limits = f"{variable.limit('min')}, {variable.limit('max')}, {variable.start}"
    if variable.type in ("Boolean", "String"):
        limits = f"0, 1, {variable.start}"
    return (
        f'    {{"{variable.name}", {unit}, VARIABLE_{kind_of_value}, STORED_{kind}, {place}, '
        f"{settable_before_start}, {limits}}},"
    )


def agreement(claim, what):
    """A C99 compile-time check: an array of negative size where the claim is false."""
    return f"typedef char agrees_{what}[({claim}) ? 1 : -1];"


def agreements(table):
    """What XML and C both state, as compile-time checks."""
    lines = [
        agreement(
            f"TDMF_GUARD_COUNT == {table.root.get('numberOfEventIndicators')}", "number_of_event_indicators"
        ),
        agreement(f"TDMF_STATE_COUNT == {len(table.states)}", "number_of_states"),
    ]
    for i, state in enumerate(table.states):
        lines.append(agreement(f"{state.constant} == {i}", state.constant))
    for variable in table.variables:
        for item in variable.items:
            constant = ENUMERATORS[variable.name] + item.get("name").upper()
            lines.append(agreement(f"{constant} == {item.get('value')}", constant))
    return lines


def item_names(table, name):
    """The names of an enumeration's items as a C array."""
    names = ", ".join(f'"{item.get("name")}"' for item in table.by_name[name].items)
    return f"const char *const unit_{name.replace('.', '_')}_names[] = {{{names}}};"


def variables(table):
    """The C file behind fmu_src/variables.h."""
    return generated(
        [
            '#include "variables.h"',
            "",
            "#include <float.h>",
            "",
            "/* What C and XML must agree on. */",
            *agreements(table),
            "",
            "const unit_variable unit_variables[] = {",
            *[variable_row(v, table) for v in table.variables],
            "};",
            "const size_t unit_variable_count = sizeof unit_variables / sizeof unit_variables[0];",
            "",
            item_names(table, "contact.mode"),
            item_names(table, "hip.phase"),
        ]
    )


# ---- the description inside the FMU --------------------------------------------------------------------


def guid_of(source, version):
    """An identity that changes with the content and the version."""
    content = pathlib.Path(source).read_bytes() + version.encode()
    return "{" + str(uuid.UUID(hashlib.sha256(content).hexdigest()[:32])) + "}"


def unknown(variable, table, dependencies):
    """An Unknown of the model structure, names turned into indices."""
    element = ElementTree.Element("Unknown", index=str(variable.value_reference + 1))
    if dependencies is not None:
        found = sorted(table.find(name, variable.name).value_reference + 1 for name in dependencies)
        element.set("dependencies", " ".join(map(str, found)))
    return element


def known_dependencies(table):
    """Dependencies by name; an output that is a state depends on itself."""
    dependencies = {s.name: [s.name] for s in table.states if s.causality == "output"}
    for element in table.root.find("ModelStructure"):
        dependencies[table.find(element.get("name"), "ModelStructure").name] = element.get(
            "dependencies"
        ).split()
    return dependencies


def complete_structure(table):
    """The model structure as FMI wants it."""
    dependencies = known_dependencies(table)
    outputs = [v for v in table.variables if v.causality == "output"]
    initial_unknowns = [v for v in table.variables if v.initial == "calculated"]
    structure = ElementTree.Element("ModelStructure")
    for tag, unknowns in (("Outputs", outputs), ("Derivatives", table.derivatives)):
        group = ElementTree.SubElement(structure, tag)
        for variable in unknowns:
            group.append(unknown(variable, table, dependencies.get(variable.name)))
    group = ElementTree.SubElement(structure, "InitialUnknowns")
    for variable in initial_unknowns:
        group.append(unknown(variable, table, None))
    return structure


def describe(table, source, version):
    """The modelDescription.xml inside the FMU."""
    root = table.root
    root.set("guid", guid_of(source, version))
    root.set("version", version)
    root.set("generationTool", f"TDMF-SLIP {version}")
    for variable in table.variables:
        variable.element.set("valueReference", str(variable.value_reference))
        if variable.derivative:
            state = table.find(variable.derivative, variable.name)
            variable.value.set("derivative", str(state.value_reference + 1))
    structure = complete_structure(table)
    position = list(root).index(root.find("ModelStructure"))
    root.remove(root[position])
    root.insert(position, structure)
    ElementTree.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"


def guid(source, version):
    """The C header with the guid."""
    return generated([f'#define UNIT_GUID "{guid_of(source, version)}"'])


def main():
    """Run the command."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("what", choices=["ranges", "variables", "description", "guid"])
    parser.add_argument("source")
    parser.add_argument("output")
    parser.add_argument("--version", default="")
    arguments = parser.parse_args()
    table = Table(arguments.source)
    text = {
        "ranges": lambda: ranges(table),
        "variables": lambda: variables(table),
        "description": lambda: describe(table, arguments.source, arguments.version),
        "guid": lambda: guid(arguments.source, arguments.version),
    }[arguments.what]()
    pathlib.Path(arguments.output).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
