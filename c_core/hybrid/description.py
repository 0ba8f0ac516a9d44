"""modelDescription.xml of a page's unit, for FMI 2.0 and 3.0, and the build description of FMI 3.0."""

import re
from xml.etree import ElementTree

from .unit import DEGREES, DISPLAY
from .units import BASE, dimension_of

CATEGORIES = {
    "logEvents": "Every event, with its time and the modes before and after it",
    "logStatusWarning": "Calls that were carried out with a caveat",
    "logStatusDiscard": "Values that were refused and changed nothing",
    "logStatusError": "Calls that failed, or were out of place and changed nothing",
    "logAll": "All of the above",
}
STATES = {2: ("canGetAndSetFMUstate", "canSerializeFMUstate", "providesDirectionalDerivative")}
STATES[3] = (
    "canGetAndSetFMUState",
    "canSerializeFMUState",
    "providesDirectionalDerivatives",
    "providesAdjointDerivatives",
)
CO_SIMULATION = {
    2: {"canInterpolateInputs": "true", "canNotUseMemoryManagementFunctions": "true"},
    3: {"hasEventMode": "true", "mightReturnEarlyFromDoStep": "true"},
}
GROUPS = {
    "Output": "Outputs",
    "ContinuousStateDerivative": "Derivatives",
    "InitialUnknown": "InitialUnknowns",
}
"""Groups of unknowns in FMI 2.0, by their elements in FMI 3.0."""
TYPES_OF_3 = {"Real": "Float64", "Integer": "Int32"}


def base_unit(unit):
    """The powers of base units in a unit, those of the radian included."""
    found = {name: int(power) for name, power in zip(BASE, dimension_of(unit), strict=True) if power}
    above, _, below = unit.partition("/")
    turns = len(re.findall(r"\brad\b", above)) - len(re.findall(r"\brad\b", below))
    return found | ({"rad": turns} if turns else {})


def document(root):
    """The text of an XML file."""
    ElementTree.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"


class Description:
    """The description of a unit in a version of FMI, 2 or 3."""

    def __init__(self, unit, fmi, version, sources):
        self.unit, self.fmi, self.sources = unit, fmi, sources
        self.first_index = 1 if fmi == 2 else 0  # FMI 3.0 has value references instead of indices
        given = {"fmiVersion": f"{fmi}.0", "modelName": unit.identifier, **unit.about, "version": version}
        given["guid" if fmi == 2 else "instantiationToken"] = unit.identity
        given |= {"generationTool": f"TDMF-SLIP {version}", "variableNamingConvention": "structured"}
        if fmi == 2:
            indicators = sum(row.storage == "GUARD" for row in unit.rows)
            given["numberOfEventIndicators"] = str(indicators)
        self.root = ElementTree.Element("fmiModelDescription", given)
        self.interfaces()
        self.units()
        self.types()
        categories = self.add(self.root, "LogCategories")
        for name, text in CATEGORIES.items():
            self.add(categories, "Category", name=name, description=text)
        self.add(self.root, "DefaultExperiment", **unit.experiment)
        variables = self.add(self.root, "ModelVariables")
        for row in unit.rows:
            self.variable(variables, row)
        self.structure()

    def add(self, parent, tag, **attributes):
        """Add an element; attributes without a value are left out."""
        return ElementTree.SubElement(parent, tag, {k: v for k, v in attributes.items() if v is not None})

    def interfaces(self):
        """Capabilities of the unit, by interface."""
        able = dict.fromkeys(STATES[self.fmi], "true")
        co_simulation = {"canHandleVariableCommunicationStepSize": "true", "maxOutputDerivativeOrder": "1"}
        exchange = (
            {"canNotUseMemoryManagementFunctions": "true"}
            if self.fmi == 2
            else {"needsCompletedIntegratorStep": "true"}
        )
        for tag, more in (
            ("ModelExchange", exchange),
            ("CoSimulation", co_simulation | CO_SIMULATION[self.fmi]),
        ):
            element = self.add(self.root, tag, modelIdentifier=self.unit.identifier, **able, **more)
            if self.fmi == 2:
                files = self.add(element, "SourceFiles")
                for name in self.sources:
                    self.add(files, "File", name=name)

    def units(self):
        """Definitions of the units of all real variables."""
        definitions = self.add(self.root, "UnitDefinitions")
        for name in self.unit.used_units():
            element = self.add(definitions, "Unit", name=name)
            self.add(element, "BaseUnit", **{base: str(power) for base, power in base_unit(name).items()})
            if name in DISPLAY:
                self.add(element, "DisplayUnit", name=DISPLAY[name], factor=repr(DEGREES))

    def types(self):
        """Types. FMPy 0.3.19 to 0.3.23 cannot read a description of one in FMI 3.0."""
        definitions = self.add(self.root, "TypeDefinitions")
        for name, kind, about, given, items in self.unit.types():
            if self.fmi == 3:
                kind = f"{TYPES_OF_3.get(kind, kind)}Type"
                made = self.add(definitions, kind, name=name, **given)
            else:
                made = self.add(
                    self.add(definitions, "SimpleType", name=name, description=about), kind, **given
                )
            for item in items:
                self.add(made, "Item", **item)

    def variable(self, parent, row):
        """A variable; in FMI 2.0 what depends on its type is an element of its own."""
        kind, own = self.unit.type_of(row), self.unit.attributes(row)
        if row.derivative:
            own["derivative"] = str(self.unit.number[row.derivative] + self.first_index)
        common = {"name": row.name, "valueReference": str(self.unit.number[row.name])}
        common |= {"description": row.about or None, "causality": row.causality}
        common |= {"variability": row.variability, "initial": row.initial}
        if self.fmi == 2:
            self.add(self.add(parent, "ScalarVariable", **common), kind, **own)
        else:
            self.add(parent, TYPES_OF_3.get(kind, kind), **common, **own)

    def unknowns(self):
        """Variables in each group of the structure: outputs, derivatives, initial unknowns, indicators."""
        rows = self.unit.rows
        yield "Output", [row for row in rows if row.causality == "output"]
        yield "ContinuousStateDerivative", [row for row in rows if row.storage == "DERIVATIVE"]
        calculated = [
            row
            for row in rows
            if row.initial == "calculated" and (row.causality == "output" or row.storage == "DERIVATIVE")
        ]
        yield "InitialUnknown", calculated
        yield "EventIndicator", [row for row in rows if row.storage == "GUARD"]

    def structure(self):
        """The model structure: unknowns and what they depend on.

        The dependencies are always written, because CasADi reads no unit without them.
        """
        structure, number = self.add(self.root, "ModelStructure"), self.unit.number
        for tag, rows in self.unknowns():
            parent, name, at_start = structure, "valueReference", tag == "InitialUnknown"
            if self.fmi == 2:
                if tag not in GROUPS or not rows:
                    continue
                parent, tag, name = self.add(structure, GROUPS[tag]), "Unknown", "index"
            for row in rows:
                references = self.unit.references(row, at_start)
                given = " ".join(str(i + self.first_index) for i in references)
                self.add(parent, tag, **{name: str(number[row.name] + self.first_index)}, dependencies=given)


def description(unit, fmi, version, sources):
    """The text of modelDescription.xml in a version of FMI, 2 or 3, with the names of the C files."""
    return document(Description(unit, fmi, version, sources).root)


def build_description(unit, sources):
    """The text of sources/buildDescription.xml of FMI 3.0."""
    root = ElementTree.Element("fmiBuildDescription", fmiVersion="3.0")
    configuration = ElementTree.SubElement(root, "BuildConfiguration", modelIdentifier=unit.identifier)
    files = ElementTree.SubElement(
        configuration, "SourceFileSet", language="C99", compilerOptions="-ffp-contract=off"
    )
    for name in sources:
        ElementTree.SubElement(files, "SourceFile", name=name)
    about = "where it is not in the C library"
    ElementTree.SubElement(configuration, "Library", name="m", external="true", description=about)
    return document(root)


def terminals(unit):
    """The text of terminalsAndIcons.xml of FMI 3.0: the icon fills a square, terminals have no graphics."""
    root = ElementTree.Element("fmiTerminalsAndIcons", fmiVersion="3.0")
    corners = {"x1": "-100", "y1": "-100", "x2": "100", "y2": "100"}
    graphics = ElementTree.SubElement(root, "GraphicalRepresentation")
    ElementTree.SubElement(graphics, "CoordinateSystem", corners | {"suggestedScalingFactorTo_mm": "0.1"})
    ElementTree.SubElement(graphics, "Icon", corners)
    group = ElementTree.SubElement(root, "Terminals")
    for name, (about, members) in unit.terminals.items():
        terminal = ElementTree.SubElement(group, "Terminal", name=name, matchingRule="bus", description=about)
        for member in members.split():
            given = {"variableName": member, "memberName": member, "variableKind": "signal"}
            ElementTree.SubElement(terminal, "TerminalMemberVariable", given)
    return document(root)
