"""In which units values are told: in those that their user gave them in, else in the variables' own."""

from collections.abc import Mapping

from . import unit_text
from .fmu import Fmu


class DisplayUnits:
    """Units of the unit's variables, some of them as they were given."""

    def __init__(self, fmu: Fmu, given: Mapping[str, object] | None = None) -> None:
        """With what was given, by the variables' names."""
        self._variables = fmu.variables
        self._units = {name: _unit_in(text) for name, text in (given or {}).items() if isinstance(text, str)}

    def factor(self, name: str) -> float:
        """How many of the unit that it is told in make one of the variable's own."""
        return self._variables[name].factor_of(self._units.get(name, "")) or 1.0

    def unit(self, name: str) -> str:
        """The unit that a variable is told in."""
        return self._units.get(name) or self._variables[name].unit

    def value(self, name: str, value: float) -> float:
        """A value of it, in that unit."""
        return value * self.factor(name)


def _unit_in(text: str) -> str:
    return unit_text.split(text.split(":")[0])[1]
