"""The command `variables`: every variable of the unit."""

import math

from ..terminal.text import table
from ..variables.table import SHORT_NAMES, VARIABLES
from ..variables.variable import Variable
from .command import Answer, command

HEADER = ("name", "short name", "unit", "range", "default", "kind", "meaning")


@command("variables", runner=False)
def variables_command() -> Answer:
    """List every variable of the unit with its short name, unit, range, default and meaning."""
    variables = list(VARIABLES.values())
    return Answer(
        {"variables": [_object(one) for one in variables]}, table(HEADER, list(map(row, variables)))
    )


def _object(variable: Variable) -> dict[str, object]:
    """A variable as a plain object; None stands for a missing entry or bound."""
    return {
        "name": variable.name,
        "short_name": SHORT_NAMES.get(variable.name),
        "type": variable.type,
        "unit": variable.unit or None,
        "minimum": variable.minimum,
        "maximum": variable.maximum,
        "items": {name: number for number, name in variable.items.items()} or None,
        "default": variable.start,
        "causality": variable.causality,
        "variability": variable.variability,
        "settable": variable.settable,
        "meaning": variable.description,
    }


def row(variable: Variable) -> tuple[str, str, str, str, str, str, str]:
    """A variable in words: name, short name, unit, range, default, causality, meaning."""
    unit = "" if variable.unit == "1" else variable.unit
    return (
        variable.name,
        SHORT_NAMES.get(variable.name, ""),
        unit,
        _range(variable),
        _default(variable),
        variable.kind,
        variable.description,
    )


def _range(variable: Variable) -> str:
    """Allowed values; empty where any is allowed."""
    if variable.items:
        return ", ".join(variable.items.values())
    low, high = variable.minimum, variable.maximum
    if math.isinf(low) and math.isinf(high):
        return ""
    above = "" if math.isinf(low) else f"{low:g}"
    return f"{above} to {high:g}" if math.isfinite(high) else f"from {above}"


def _default(variable: Variable) -> str:
    if variable.start is None:
        return ""
    if isinstance(variable.start, bool):
        return "true" if variable.start else "false"
    if variable.items:
        return variable.items[int(variable.start)]
    return f"{variable.start:.12g}"
