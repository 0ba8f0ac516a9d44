#!/usr/bin/env python3
"""Make everything that follows from modelDescription.xml, the one table of variables.

    generate_variables.py declarations SOURCE OUTPUT    C: parameters, inputs, states, guards
    generate_variables.py ranges      SOURCE OUTPUT     C: ranges and starts for the core
    generate_variables.py guid        SOURCE OUTPUT --version V     C: the units' guid
    generate_variables.py fmi2        SOURCE OUTPUT --version V --sources F...
                                                                    the description inside the FMI 2.0 unit
    generate_variables.py fmi3        SOURCE OUTPUT --version V     the description inside the FMI 3.0 unit
    generate_variables.py build       SOURCE OUTPUT --sources F...  FMI 3.0: how its sources are compiled
    generate_variables.py terminals   SOURCE OUTPUT                 FMI 3.0: icon and terminals
    generate_variables.py page        SOURCE OUTPUT --template PAGE the units' page with its list of variables
    generate_variables.py python      SOURCE OUTPUT                 the Python package's table

Needs nothing but Python's standard library, because the C build runs it.
"""

import argparse
import hashlib
import html
import pathlib
import re
import sys
import uuid
import xml.etree.ElementTree as ElementTree

sys.dont_write_bytecode = True  # a build leaves the sources alone
sys.path.insert(0, str(pathlib.Path(__file__).parents[1]))
from c_core.hybrid.description import build_description, description, document  # noqa: E402

# Parameters of these groups belong to the unit; all others are the core's.
UNIT_GROUPS = {"status", "solver"}
C_TYPES = {"Real": "double", "Boolean": "bool"}
GUARDS = "guard"
"""The group of the event indicators."""


class Variable:
    """One ScalarVariable with its declared type folded in."""

    def __init__(self, element, types, value_reference):
        """Read the element; `types` are the declared types by name."""
        self.element = element
        self.alias = element.attrib.pop("alias", "")
        self.value_reference = value_reference
        self.name = element.get("name")
        self.causality = element.get("causality")
        self.variability = element.get("variability")
        self.initial = element.get("initial")
        self.about = element.get("description")
        self.value = element[0]
        self.type = self.value.tag
        declared = types.get(self.value.get("declaredType"))
        self.unit = self.value.get("unit") or (declared.get("unit") if declared is not None else None)
        self.quantity = declared.get("quantity") if declared is not None else None
        self.items = [] if declared is None else list(declared)
        self.derivative = self.value.get("derivative")
        self.storage = "GUARD" if self.group == GUARDS else "DERIVATIVE" if self.derivative else ""

    @property
    def group(self):
        """The part of the name before the first dot."""
        return self.name.split(".")[0]

    @property
    def constant(self):
        """The C enumerator of a state or a guard: foot.x -> TDMF_FOOT_X."""
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
        self.guards = [v for v in self.variables if v.group == GUARDS]
        annotations = self.root.find("VendorAnnotations")
        self.root.remove(annotations)
        self.package = annotations.find("Tool")
        self.units = [*self.root.find("UnitDefinitions"), *self.package.findall("Unit")]
        # What a description asks of a unit.
        self.rows = self.variables
        self.number = {v.name: v.value_reference for v in self.variables}
        self.identifier = self.root.get("modelName")
        self.about = {name: self.root.get(name) for name in ("description", "author", "copyright", "license")}
        self.categories = {c.get("name"): c.get("description") for c in self.root.find("LogCategories")}
        self.experiment = self.root.find("DefaultExperiment").attrib

    def used_units(self):
        """Units of all real variables."""
        return [unit.get("name") for unit in self.root.find("UnitDefinitions")]

    def types(self):
        """Types: name, kind, description, attributes and items."""
        for declared in self.root.find("TypeDefinitions"):
            (of,) = declared
            items = [item.attrib for item in of]
            yield declared.get("name"), of.tag, declared.get("description"), of.attrib, items

    def type_of(self, variable):
        """The type of a variable, in the words of FMI 2.0."""
        return variable.type

    def attributes(self, variable):
        """Attributes of a variable that depend on its type."""
        return dict(variable.value.attrib)

    def references(self, variable, at_start=False):
        """Value references of all that a variable depends on."""
        known = start_dependencies(self) if at_start else run_dependencies(self)
        if variable.name not in known:
            raise SystemExit(f"modelDescription.xml: no dependencies are declared for {variable.name}")
        return sorted(self.find(name, variable.name).value_reference for name in known[variable.name])

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

    def start_states(self):
        """The states that take a start value."""
        return [v for v in self.states if v.initial == "exact"]

    def dimensions(self):
        """Powers of length, time and mass of each unit; an angle has none."""
        bases = {unit.get("name"): unit.find("BaseUnit") for unit in self.units}
        return {name: tuple(int(base.get(of, 0)) for of in ("m", "s", "kg")) for name, base in bases.items()}

    def aliases(self):
        """From the short name to the variable's own."""
        return {v.alias: v.name for v in self.variables if v.alias}


def generated(lines):
    """A C file of these lines, marked as generated."""
    return "\n".join(
        ["/* Generated from modelDescription.xml by scripts/generate_variables.py. */", *lines, ""]
    )


# ---- the core's declarations ---------------------------------------------------------------------------


def comment_of(variable):
    """A comment of C: what the table says of a variable, and its unit."""
    unit = "" if variable.unit in (None, "1") else f", {variable.unit}"
    return f"/* {variable.element.get('description').removeprefix('Event indicator: ')}{unit} */"


def is_flag(variable):
    """Whether it is a Boolean."""
    return variable.type == "Boolean"


def struct(name, variables):
    """A struct with a member of each variable's path: numbers one after the other, Booleans after them."""
    groups = {}
    for variable in variables:
        groups.setdefault(variable.group, []).append(variable)
    lines = ["typedef struct {"]
    for group, members in sorted(groups.items(), key=lambda group: any(map(is_flag, group[1]))):
        members.sort(key=is_flag)
        names = [variable.name.partition(".")[2] for variable in members]
        inner = [
            f"{C_TYPES[v.type]} {n or group}; {comment_of(v)}" for n, v in zip(names, members, strict=True)
        ]
        lines += inner if names == [""] else ["struct {", *inner, f"}} {group};"]
    return "\n".join([*lines, f"}} {name};"])


def enumeration(variables, count, name=""):
    """An enumeration of variables."""
    lines = [f"{v.constant}, {comment_of(v)}" for v in variables]
    opening, end = ("typedef enum {", f"}} {name};") if name else ("enum {", "};")
    return "\n".join([opening, *lines, count, end])


DECLARATIONS = """\
/* Parameters, inputs, states and guards, derived from modelDescription.xml by
 * scripts/generate_variables.py: edit that, not this. */
#ifndef TDMF_SLIP_VARIABLES_H
#define TDMF_SLIP_VARIABLES_H

#include <stdbool.h>

/* SI units, angles in rad. A member's path is the variable's name in the FMU: `leg.stiffness`. Ranges and
 * defaults (Table 1 of the paper with m = k = l0 = 1) come from modelDescription.xml. */
{parameters}

/* What may change during a run. Rates of inputs, per second, have the same shape; zero where they are held.
 * Discrete inputs, such as ground.height, ground.slope and control, change at events only: their rates are
 * always zero. */
{inputs}

/* How many numbers there are among the parameters, which come first in their struct; how many inputs; and how
 * many settings: inputs and tunable parameters. */
enum {{
    TDMF_PARAMETER_COUNT = {parameter_count},
    TDMF_INPUT_COUNT = {input_count},
    TDMF_SETTING_LIMIT = {setting_count}
}};

/* Indices into a state vector of TDMF_STATE_COUNT doubles. The first eight are q and its rate, in the order
 * of the paper's q = (x, y, r, theta); the rest are integrals along the run and a clock. The leg's angle is
 * never wrapped: the hip unwinds a leg that has wound. After a thousand turns an angle is known to 1e-12,
 * and so is all that follows from it. */
{states}

/* Each guard is a pure number, positive while its event is to come; at zero or below, the event is due. A
 * guard that the present mode does not watch is 1. Every armed guard carries a margin of TDMF_GUARD_MARGIN,
 * so that it is positive even where its event has just happened. */
{guards}

#endif
"""


def declarations(table):
    """The public header tdmf_slip/variables.h, before it is formatted."""
    inputs, parameters = table.inputs(), table.core_parameters()
    return DECLARATIONS.format(
        parameters=struct("tdmf_parameters", parameters),
        inputs=struct("tdmf_inputs", inputs),
        parameter_count=sum(not is_flag(v) for v in parameters),
        input_count=len(inputs),
        setting_count=len(inputs) + sum(v.variability == "tunable" for v in parameters),
        states=enumeration(table.states, "TDMF_STATE_COUNT"),
        guards=enumeration(table.guards, "TDMF_GUARD_COUNT", "tdmf_guard"),
    )


# ---- the core's table ----------------------------------------------------------------------------------


def range_row(variable, offset):
    """A row of `tdmf_range`."""
    unit = f'"{variable.unit}"' if variable.unit else "NULL"
    limits = f"{variable.limit('min')}, {variable.limit('max')}"
    continuous = "true" if variable.variability == "continuous" else "false"
    at_events = "true" if variable.variability in ("tunable", "discrete", "continuous") else "false"
    changes = f"{continuous}, {at_events}"
    return f'    {{"{variable.name}", {unit}, {limits}, {variable.start}, {changes}, {offset}}},'


def quantity(variable):
    """The C enumerator of what a variable is: AngularVelocity -> TDMF_QUANTITY_ANGULAR_VELOCITY."""
    words = re.findall("[A-Z][a-z]*", variable.quantity)
    return "_".join(["TDMF_QUANTITY", *map(str.upper, words)])


def ranges(table):
    """The C file behind c_core/model/ranges.h."""
    parameters, flags = [], []
    for variable in table.core_parameters():
        offset = f"offsetof(tdmf_parameters, {variable.name})"
        if is_flag(variable):
            flags.append(f'    {{"{variable.name}", {variable.value.get("start")}, {offset}}},')
        else:
            parameters.append(range_row(variable, offset))
    inputs = [range_row(v, f"offsetof(tdmf_inputs, {v.name})") for v in table.inputs()]
    mechanical = [range_row(v, "0") for v in table.states if v.value.get("start")]
    quantities = [f"    [{v.constant}] = {quantity(v)}," for v in table.states]
    return generated(
        [
            '#include "ranges.h"',
            "",
            "#include <float.h>",
            "",
            "const tdmf_range tdmf_parameter_ranges[TDMF_PARAMETER_COUNT] = {",
            *parameters,
            "};",
            "",
            "const tdmf_flag tdmf_parameter_flags[] = {",
            *flags,
            "};",
            "const size_t tdmf_parameter_flag_count =",
            "    sizeof tdmf_parameter_flags / sizeof tdmf_parameter_flags[0];",
            "",
            "const tdmf_range tdmf_input_ranges[TDMF_INPUT_COUNT] = {",
            *inputs,
            "};",
            "",
            "const tdmf_range tdmf_state_ranges[TDMF_MECHANICAL_COUNT] = {",
            *mechanical,
            "};",
            "",
            "const tdmf_quantity tdmf_state_quantities[TDMF_STATE_COUNT] = {",
            *quantities,
            "};",
        ]
    )


# ---- the descriptions inside the units -----------------------------------------------------------------


def guid_of(source, version):
    """An identity that changes with the content and the version."""
    content = pathlib.Path(source).read_bytes() + version.encode()
    return "{" + str(uuid.UUID(hashlib.sha256(content).hexdigest()[:32])) + "}"


def declared_dependencies(table, tag):
    """Dependencies by name, from the elements with this tag in the table's ModelStructure."""
    return {
        table.find(element.get("name"), "ModelStructure").name: element.get("dependencies").split()
        for element in table.root.find("ModelStructure").iter(tag)
    }


def run_dependencies(table):
    """Dependencies in a run: an output that is a state has itself, one that only events change has none."""
    dependencies = {s.name: [s.name] for s in table.states if s.causality == "output"}
    dependencies |= {
        v.name: [] for v in table.variables if v.causality == "output" and v.variability == "discrete"
    }
    return dependencies | declared_dependencies(table, "Unknown")


def initial_unknowns(table):
    """What the start values determine, of those that FMI asks for."""
    return [v for v in table.variables if v.initial == "calculated" and v not in table.guards]


def whole_start(table):
    """Names of time, of all inputs and of all start values of the core."""
    return [
        v.name
        for v in table.variables
        if (v.initial == "exact" or v.causality in ("input", "independent")) and v.group not in UNIT_GROUPS
    ]


def start_dependencies(table):
    """Dependencies of what the start determines: whatever a start follows from, unless declared."""
    at_start = dict.fromkeys((v.name for v in initial_unknowns(table)), whole_start(table))
    return at_start | declared_dependencies(table, "InitialUnknown")


TERMINALS = {
    "ground": (
        "Contact of foot and ground",
        ["foot.x", "foot.y", "foot.vx", "foot.vy", "contact.fx", "contact.fy", "ground.friction"],
    ),
    "hip": (
        "Joint of body and leg: a torque on it, the angle of the leg and its rate",
        ["hip.external_torque", "leg.angle", "leg.angle_rate"],
    ),
}
"""Terminals of FMI 3.0: description, and the variables in each."""


def terminals(table):
    """The terminalsAndIcons.xml of FMI 3.0: the icon fills a square, terminals have no graphics."""
    root = ElementTree.Element("fmiTerminalsAndIcons", fmiVersion="3.0")
    corners = {"x1": "-100", "y1": "-100", "x2": "100", "y2": "100"}
    graphics = ElementTree.SubElement(root, "GraphicalRepresentation")
    ElementTree.SubElement(graphics, "CoordinateSystem", corners | {"suggestedScalingFactorTo_mm": "0.1"})
    ElementTree.SubElement(graphics, "Icon", corners)
    group = ElementTree.SubElement(root, "Terminals")
    for name, (about, members) in TERMINALS.items():
        terminal = ElementTree.SubElement(group, "Terminal", name=name, matchingRule="bus", description=about)
        for member in members:
            variable = table.find(member, "TERMINALS").name
            ElementTree.SubElement(
                terminal,
                "TerminalMemberVariable",
                variableName=variable,
                memberName=variable,
                variableKind="signal",
            )
    return document(root)


# ---- the units' page -----------------------------------------------------------------------------------

VARIABLES_HERE = "<!-- variables -->"
"""Where the page wants its list of variables."""


def kind(variable):
    """How a variable is used, in the words of FMI."""
    kinds = {"tunable": "tunable parameter", "discrete": f"discrete {variable.causality}"}
    return kinds.get(variable.variability, variable.causality)


def allowed(variable):
    """What the values of a variable may be."""
    if variable.items:
        return ", ".join(item.get("name") for item in variable.items)
    low, high = variable.value.get("min"), variable.value.get("max")
    if low is None and high is None:
        return ""
    return f"{low} to {high}" if high is not None else f"from {low}"


def default(variable):
    """The start value of a variable, as text."""
    start = variable.value.get("start", "")
    return next((item.get("name") for item in variable.items if item.get("value") == start), start)


def page(table, template):
    """The page, with a row for every variable."""
    head = ("variable", "unit", "range", "default", "kind", "meaning")
    lines = ['<table class="all">', "<tr>" + "".join(f"<th>{title}</th>" for title in head) + "</tr>"]
    for v in table.variables:
        unit = "" if v.unit in (None, "1") else v.unit
        cells = [unit, allowed(v), default(v), kind(v), v.element.get("description")]
        texts = [f"<code>{v.name}</code>", *(html.escape(cell) for cell in cells)]
        lines.append("<tr>" + "".join(f"<td>{text}</td>" for text in texts) + "</tr>")
    text = pathlib.Path(template).read_text(encoding="utf-8")
    if text.count(VARIABLES_HERE) != 1:
        raise SystemExit(f"{template}: {VARIABLES_HERE} has to be in it once")
    return text.replace(VARIABLES_HERE, "\n".join([*lines, "</table>"]))


# ---- the Python package's table ------------------------------------------------------------------------


def python_start(variable):
    """The start value of a number or a Boolean as Python has it, None where there is none."""
    if "start" not in variable.value.attrib or variable.type == "String":
        return None
    return variable.start == "1" if variable.type == "Boolean" else float(variable.start)


def python_variable(variable, display_units):
    """The fields of the package's `Variable`, in their order."""
    return (
        variable.name,
        variable.value_reference,
        variable.type,
        variable.unit or "",
        variable.element.get("description"),
        variable.causality,
        variable.variability,
        variable.causality == "input" or variable.initial == "exact",
        float(variable.value.get("min", "-inf")),
        float(variable.value.get("max", "inf")),
        python_start(variable),
        {int(item.get("value")): item.get("name") for item in variable.items},
        display_units.get(variable.unit, {}),
    )


def python(table):
    """The Python module of data."""
    display_units = {
        unit.get("name"): {
            shown.get("name"): float(shown.get("factor")) for shown in unit.findall("DisplayUnit")
        }
        for unit in table.units
    }
    rows = [python_variable(v, display_units) for v in table.variables]
    of_quantity = ("name", "unit", "description", "coordinate")
    quantities = [tuple(q.get(of, "") for of in of_quantity) for q in table.package.findall("Quantity")]
    quantities += [
        (v.name.partition(".")[2], v.unit or "1", v.element.get("description"), "")
        for v in table.variables
        if v.group == "stride"
    ]
    models = [
        (m.get("name"), *(tuple(m.get(names).split()) for names in ("coordinates", "quantities", "scales")))
        for m in table.package.findall("Model")
    ]
    names = {
        "PARAMETERS": table.core_parameters(),
        "INPUTS": table.inputs(),
        "STATES": table.start_states(),
    }
    lines = [
        '"""Generated from modelDescription.xml by scripts/generate_variables.py."""',
        "from math import inf",
        f"DIMENSIONS = {table.dimensions()}",
        f"ALIASES = {table.aliases()}",
        *(f"{name} = {tuple(v.name for v in members)}" for name, members in names.items()),
        *(
            f"{name} = (\n{rows_of}\n)"
            for name, rows_of in (
                ("VARIABLES", ",\n".join(map(repr, rows)) + ","),
                ("QUANTITIES", ",\n".join(map(repr, quantities)) + ","),
                ("MODELS", ",\n".join(map(repr, models)) + ","),
            )
        ),
    ]
    return "\n".join([*lines, ""])


# ---- the guid ------------------------------------------------------------------------------------------


def guid(source, version):
    """The C header with the guid."""
    return generated([f'#define FMU_GUID "{guid_of(source, version)}"'])


def main():
    """Run the command."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    makers = {
        "declarations": lambda: declarations(table),
        "ranges": lambda: ranges(table),
        "guid": lambda: guid(arguments.source, arguments.version),
        "fmi2": lambda: description(table, 2, arguments.version, arguments.sources),
        "fmi3": lambda: description(table, 3, arguments.version, arguments.sources),
        "build": lambda: build_description(table, arguments.sources),
        "terminals": lambda: terminals(table),
        "page": lambda: page(table, arguments.template),
        "python": lambda: python(table),
    }
    parser.add_argument("what", choices=list(makers))
    parser.add_argument("source")
    parser.add_argument("output")
    parser.add_argument("--version", default="")
    parser.add_argument("--sources", nargs="*", default=[], help="names of the unit's C files")
    parser.add_argument("--template", help="page without its list of variables")
    arguments = parser.parse_args()
    table = Table(arguments.source)
    table.identity = guid_of(arguments.source, arguments.version)
    text = makers[arguments.what]()
    pathlib.Path(arguments.output).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
