"""Ranges of values as they are written on a command line: A:B, or A:B:N for N values, with units."""

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from ..checks import number_in
from ..errors import InputError
from ..variables import units
from ..variables.variable import MAX_VALUES, Variable

SPACINGS: Mapping[str, Callable[[float, float, int], NDArray[np.float64]]] = {
    "linear": np.linspace,
    "log": np.geomspace,
}


def ends_of(text: str, variable: Variable, where: str) -> tuple[float, float]:
    """Both ends of a range A:B of a variable, in its unit."""
    parts = text.split(":")
    if len(parts) != 2:
        raise InputError(f"{where} {text}: allowed: A:B, as in {_example(variable)}")
    first, last = _ends(parts, variable, f"{where} {text}")
    if first == last:
        raise InputError(f"{where} {text}: allowed: two ends that differ")
    return first, last


def values_of(text: str, spacing: str, variable: Variable, where: str) -> NDArray[np.float64]:
    """The values of a variable that A:B:N stands for, in its unit."""
    parts = text.split(":")
    if len(parts) != 3:
        raise InputError(
            f"{where} {text}: allowed: A:B:N, two ends and how many values, as in {_example(variable)}:5"
        )
    try:
        count = number_in(parts[2])
        number = int(count) if count.is_integer() else 0
    except ValueError:
        number = 0
    if not 1 <= number <= MAX_VALUES:
        raise InputError(f"{where} {text}: N = {parts[2]}; allowed: a whole number from 1 to {MAX_VALUES}")
    ends = _ends(parts[:2], variable, f"{where} {text}")
    if number == 1 and ends[0] != ends[1]:
        raise InputError(
            f"{where} {text}: one value cannot be A and B; allowed: N from 2 on, or B equal to A"
        )
    if spacing == "log" and min(ends) <= 0.0:
        raise InputError(f"{where} {text}: allowed with logarithmic spacing: A and B above 0")
    first, last = ends
    return SPACINGS[spacing](first, last, number)


def _ends(parts: list[str], variable: Variable, where: str) -> list[float]:
    with_unit = [bool(units.split(part)[1]) for part in parts]
    if with_unit[0] != with_unit[1]:
        raise InputError(f"{where}: a unit at one end only; allowed: at both or at none")
    return [variable.value_of(part, where) for part in parts]


def _example(variable: Variable) -> str:
    return "'35 deg:45 deg'" if "deg" in variable.display_units else "0.1:1"
