"""A variable of the unit: its type, unit and range, and values for it."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from numbers import Real
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..checks import check_kind, number_in, number_of, shown
from ..errors import InputError
from ..given import row_of
from . import units

Value: TypeAlias = float | bool
"""A checked start value in the variable's unit; the number of an enumeration's item."""
Given: TypeAlias = float | bool | str
"""A start value as users give it: a number in the variable's unit, or a text like `40 deg`."""
MAX_VALUES = 1_000_000
"""Most values in one row, such as a range."""
LONGEST_TEXT = 100
"""Longest text that a message repeats unchanged."""
Values: TypeAlias = Sequence[float] | NDArray[np.float64]
"""Numbers in a row, in the variable's unit."""


def attributes_of(unit: str, description: str) -> dict[str, str]:
    """A unit and a description, by the names that CF gives them."""
    return {"units": unit or "1", "long_name": description}


@dataclass(frozen=True)
class Variable:
    """One variable of the unit, with its declared type folded in."""

    name: str
    """Its name, such as `leg.stiffness`."""
    reference: int
    """Its value reference."""
    type: str
    """Real, Integer, Boolean, String or Enumeration."""
    unit: str
    """Unit of every value, empty where there is none."""
    description: str
    """Its meaning."""
    causality: str
    """FMI's word for its role: `parameter`, `input`, `output` and so on."""
    variability: str
    """`fixed`, `tunable`, `discrete` or `continuous`."""
    settable: bool
    """True if the variable takes a start value."""
    minimum: float
    """Smallest value allowed; minus infinity for no limit."""
    maximum: float
    """Largest value allowed; infinity for no limit."""
    start: Value | None
    """Its default, if it has one."""
    items: Mapping[int, str]
    """Names of an enumeration's values."""
    display_units: Mapping[str, float]
    """Other units of the quantity, each with how many of it make one `unit`."""

    @property
    def attributes(self) -> dict[str, str]:
        """Its unit and description, by the names that CF gives them."""
        return attributes_of(self.unit, self.description)

    @property
    def group(self) -> str:
        """First part of its name, such as `stride` of `stride.period`; empty without a dot."""
        return self.name.rpartition(".")[0]

    @property
    def member(self) -> str:
        """Last part of its name, such as `period` of `stride.period`."""
        return self.name.rpartition(".")[2]

    @property
    def kind(self) -> str:
        """Causality, with whether it is tunable or discrete."""
        if self.variability == "tunable":
            return "tunable parameter"
        return f"discrete {self.causality}" if self.variability == "discrete" else self.causality

    @property
    def allowed(self) -> str:
        """Allowed start values, in words."""
        if self.type == "Boolean":
            return "true or false"
        if self.items:
            return ", ".join(f"{name} ({value})" for value, name in self.items.items())
        unit = f" {self.unit}" if self.unit not in ("", "1") else ""
        return f"{self.minimum:g} to {self.maximum:g}{unit}"

    @property
    def known_units(self) -> tuple[str, ...]:
        """Units that its values may be given in, its own first."""
        others = (
            *self.display_units,
            *(name for name, (unit, _) in units.OTHER_UNITS.items() if unit == self.unit),
        )
        return tuple(dict.fromkeys(name for name in (self.unit, *others) if name))

    def factor_of(self, unit: str) -> float | None:
        """Factor from the variable's own unit to another; None for a unit of another dimension."""
        return units.factor(unit, self.unit, self.display_units)

    def value_of(self, given: Given, where: str) -> Value:
        """A start value for this variable, checked against its range."""
        if self.type == "Boolean":
            return self._boolean(given, where)
        value = (
            self._parsed(given, where)
            if isinstance(given, str)
            else self._finite(number_of(given, self.unit), given, where)
        )
        if not self.minimum <= value <= self.maximum or (self.items and value not in self.items):
            raise self._refusal(given, where, self._hint_at_degrees(given, value))
        return value

    def without_units(self, row: Sequence[Any], where: str) -> list[Any]:
        """Values in a row, of which texts such as `40 deg` are converted to the variable's own unit."""
        return [self.value_of(value, where) if isinstance(value, str) else value for value in row]

    def values_of(self, given: object, where: str) -> NDArray[np.float64]:
        """One or more numbers for this variable, checked against its range."""
        row = row_of(given, where, f"a row of values of {self.name}", MAX_VALUES)
        if not row:
            raise InputError(f"{where}: no values of {self.name}; allowed: one or more")
        return np.array([self.value_of(value, where) for value in row], dtype=float)

    def _hint_at_degrees(self, given: Given, value: float) -> str:
        """How to write a number that would be allowed as degrees; empty for other values."""
        has_unit = isinstance(given, str) and units.split(given)[1] != ""
        in_degrees = value / self.display_units.get("deg", math.nan)
        is_meant = not has_unit and self.minimum <= in_degrees <= self.maximum
        return f"; for degrees write '{value:g} deg'" if is_meant else ""

    def _refusal(self, given: object, where: str, hint: str = "", kind: str = "") -> InputError:
        plain = isinstance(given, str) and given.isprintable() and len(given) <= LONGEST_TEXT
        text = given if plain else shown(given)
        return InputError(
            f"{where}: {self.name} = {text} is not allowed; allowed: {kind}{self.allowed}{hint}"
        )

    def _boolean(self, given: Given, where: str) -> bool:
        values = {"true": True, "false": False, "1": True, "0": False, "1.0": True, "0.0": False}
        try:
            check_kind(given, (str, bool, np.bool_, Real), where, self.allowed)
            return values[str(given).lower()]
        except (InputError, KeyError):
            raise self._refusal(given, where) from None

    def _parsed(self, text: str, where: str) -> float:
        """The number that a text stands for, in the variable's unit."""
        if text in self.items.values():
            return next(float(value) for value, name in self.items.items() if name == text)
        number, unit = units.split(text)
        factor = self.factor_of(unit)
        if factor is None:
            raise InputError(
                f"{where}: {self.name} = {shown(text)}: unknown unit {shown(unit)}; known: "
                f"{', '.join(self.known_units) or 'none'}"
            )
        hint = ", or a number and a unit" if self.unit not in ("", "1") else ""
        try:
            return self._finite(number_in(number), text, where) / factor
        except ValueError:
            raise self._refusal(text, where, hint, kind="a number, ") from None

    def _finite(self, number: float | None, given: object, where: str) -> float:
        """A finite number, by what was given as one."""
        if number is None:
            raise self._refusal(given, where, kind="a number, ")
        if not math.isfinite(number):
            raise self._refusal(given, where)
        return number
