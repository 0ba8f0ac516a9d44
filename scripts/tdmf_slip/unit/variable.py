"""A variable of the unit: its type, unit and range, and values for it."""

import math
import reprlib
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from fmpy.model_description import ModelVariable

from ..errors import InputError


@dataclass(frozen=True)
class Variable:
    """One variable of the unit, with its declared type folded in."""

    name: str
    reference: int
    type: str
    """Real, Integer, Boolean, String or Enumeration."""
    unit: str
    """Unit of every value, empty where there is none."""
    description: str
    causality: str
    settable: bool
    """A start value is accepted."""
    minimum: float
    maximum: float
    start: float | bool | None
    items: Mapping[int, str]
    """Names of an enumeration's values."""
    display_units: Mapping[str, float]
    """Other units of the same quantity, and how many of each make one `unit`."""

    @property
    def allowed(self) -> str:
        """What a start value may be, in words."""
        if self.type == "Boolean":
            return "true or false"
        if self.items:
            return ", ".join(f"{name} ({value})" for value, name in self.items.items())
        unit = f" {self.unit}" if self.unit not in ("", "1") else ""
        return f"{self.minimum:g} to {self.maximum:g}{unit}"

    def value_of(self, given: object, where: str) -> float | bool:
        """A start value for this variable from a number or a text like `40 deg`, checked against its range.

        Parameters
        ----------
        given : object
            Number, bool, or text: a number, alone or followed by the unit or a display unit; of an
            enumeration also a name.
        where : str
            Where the value was given, for the message.

        Raises
        ------
        InputError
            Not a number, an unknown unit, or out of range.
        """
        if self.type == "Boolean":
            return self._boolean(given, where)
        value = self._number(given, where)
        if not self.minimum <= value <= self.maximum or (self.items and value not in self.items):
            raise self._refusal(given, where)
        return value

    def values_of(self, given: object, where: str) -> np.ndarray:
        """One or more values for this variable, each as `value_of` takes it, in an array.

        Raises
        ------
        InputError
            Not a row of such values.
        """
        try:
            if isinstance(given, str | Mapping):
                raise TypeError
            values = np.array([self.value_of(value, where) for value in given], dtype=float)
        except TypeError:
            raise InputError(
                f"{where} = {reprlib.repr(given)} is not allowed; allowed: a row of values of {self.name}"
            ) from None
        if not len(values):
            raise InputError(f"{where}: no values of {self.name}; allowed: one or more")
        return values

    def _refusal(self, given: object, where: str, hint: str = "") -> InputError:
        shown = given if str(given).isprintable() else repr(given)
        return InputError(f"{where}: {self.name} = {shown} is not allowed; allowed: {self.allowed}{hint}")

    def _boolean(self, given: object, where: str) -> bool:
        values = {"true": True, "false": False, "1": True, "0": False}
        try:
            return values[str(given).lower()]
        except KeyError:
            raise self._refusal(given, where) from None

    def _number(self, given: object, where: str) -> float:
        if isinstance(given, str) and given in self.items.values():
            given = next(value for value, name in self.items.items() if name == given)
        number, _, unit = given.strip().partition(" ") if isinstance(given, str) else (given, "", "")
        factors = {"": 1.0, self.unit: 1.0, **self.display_units}
        if unit.strip() not in factors:
            known = ", ".join(u for u in factors if u)
            raise InputError(f"{where}: {self.name} = {given}: unknown unit {unit.strip()!r}; known: {known}")
        try:
            value = float(number) / factors[unit.strip()]
        except (TypeError, ValueError, OverflowError):
            has_unit = self.unit not in ("", "1")
            hint = ", a unit after a space" if isinstance(given, str) and has_unit else ""
            raise self._refusal(given, where, hint) from None
        if isinstance(given, bool | np.bool_ | bytes) or not math.isfinite(value):
            raise self._refusal(given, where)
        return value


def variable_of(variable: ModelVariable, factors: Mapping[str, Mapping[str, float]]) -> Variable:
    """A variable as the unit's description has it, with display units by their unit."""
    declared = variable.declaredType
    unit = variable.unit or (declared.unit if declared is not None else None) or ""
    items = getattr(declared, "items", None) or []
    return Variable(
        name=variable.name,
        reference=variable.valueReference,
        type=variable.type,
        unit=unit,
        description=variable.description or "",
        causality=variable.causality,
        settable=variable.causality == "input" or variable.initial == "exact",
        minimum=float(variable.min) if variable.min is not None else -math.inf,
        maximum=float(variable.max) if variable.max is not None else math.inf,
        start=_start(variable),
        items={int(item.value): item.name for item in items},
        display_units=factors.get(unit, {}),
    )


def _start(variable: ModelVariable) -> float | bool | None:
    if variable.start is None or variable.type == "String":
        return None
    return variable.start == "true" if variable.type == "Boolean" else float(variable.start)
