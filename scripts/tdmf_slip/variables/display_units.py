"""Units that values are shown in: those that their user gave, the paper's, or the variables' own."""

from collections.abc import Mapping
from typing import Any

from . import paper_units, units
from .table import VARIABLES


class DisplayUnits:
    """Units of the unit's variables, some of them as they were given."""

    def __init__(
        self, given: Mapping[str, object] | None = None, values: Mapping[str, Any] | None = None
    ) -> None:
        """With what was given, by the variables' names, and the values of the runner that is shown."""
        self._values = values or {}
        self._units = {name: _unit_in(text) for name, text in (given or {}).items() if isinstance(text, str)}

    def factor(self, name: str) -> float:
        """How many of the unit that it is told in make one of the variable's own."""
        return VARIABLES[name].factor_of(self._units.get(name, "")) or 1.0

    def unit(self, name: str) -> str:
        """The unit that a variable is shown in."""
        return self._units.get(name) or self.label(VARIABLES[name].unit)

    def label(self, unit: str) -> str:
        """The label of a unit: the paper's, if the runner is in the paper's units."""
        return paper_units.label(unit, self._values)

    def value(self, name: str, value: float) -> float:
        """A value of it, in that unit."""
        return value * self.factor(name)


def _unit_in(text: str) -> str:
    return units.split(text.split(":")[0])[1]
