"""Units that values are shown in: those that the user gave, the paper's, or the variables' own."""

from collections.abc import Mapping
from typing import Any

from . import paper_units, units
from .table import MODELS, Model


class DisplayUnits:
    """Units of the unit's variables, some of them as they were given."""

    def __init__(
        self,
        given: Mapping[str, object] | None = None,
        values: Mapping[str, Any] | None = None,
        model: Model | None = None,
    ) -> None:
        """Take what the user gave, by variables' names, and the values of the runner that is shown."""
        self._values = values or {}
        self._variables = (model or getattr(values, "model", None) or MODELS["full"]).variables
        self._units = {name: _unit_in(text) for name, text in (given or {}).items() if isinstance(text, str)}

    def factor(self, name: str) -> float:
        """Factor from a variable's own unit to the unit that it is shown in."""
        return self._variables[name].factor_of(self._units.get(name, "")) or 1.0

    def unit(self, name: str) -> str:
        """Unit that a variable is shown in."""
        return self._units.get(name) or self.label(self._variables[name].unit)

    def label(self, unit: str) -> str:
        """Label of a unit: the paper's, if the runner is in the paper's units."""
        return paper_units.label(unit, self._values)

    def value(self, name: str, value: float) -> float:
        """Value of a variable in the unit that it is shown in."""
        return value * self.factor(name)


def _unit_in(text: str) -> str:
    return units.split(text.split(":")[0])[1]
