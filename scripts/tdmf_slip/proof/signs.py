"""Signs of numbers that decide what happens; where an enclosure leaves one open, nothing is decided."""

from typing import Any

from .dual import Number, value_of
from .laws import sticking_speed
from .undecided import UndecidedError


def positive(number: Number, what: str) -> bool:
    """The sign of a number that is not zero."""
    value = value_of(number)
    if value > 0:
        return True
    if value < 0:
        return False
    raise UndecidedError(what)


def foot_rests(velocity: Number) -> bool:
    """Whether a velocity is exactly zero."""
    return bool(value_of(velocity) == 0)


def absolute(number: Number, what: str, runner: Any, fall: Number) -> Number:
    """The absolute value; where the sign is open, a bound that is enough to tell that an impact sticks."""
    value = value_of(number)
    if value > 0:
        return number
    if value < 0:
        return -number
    if abs(value) < value_of(sticking_speed(runner, fall)):
        return abs(value)
    raise UndecidedError(what)
