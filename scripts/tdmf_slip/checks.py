"""What is given, checked: by its kind, and against a range."""

import reprlib
from numbers import Real

from .errors import InputError


def check_kind(given: object, kinds: type | tuple[type, ...], what: str, allowed: str) -> None:
    """Refuse what is of another kind than wanted.

    Parameters
    ----------
    given : object
        What was given.
    kinds : type or tuple[type, ...]
        Of which it has to be one.
    what : str
        Its name, for the message.
    allowed : str
        What it may be, in words.

    Raises
    ------
    InputError
        It is of none of them.
    """
    if not isinstance(given, kinds):
        raise InputError(f"{what} = {reprlib.repr(given)} is not allowed; allowed: {allowed}")


def checked(name: str, value: float, low: float, high: float) -> float:
    """A number within its range.

    Raises
    ------
    InputError
        It is none, or beyond.
    """
    if not isinstance(value, Real) or not low <= value <= high:
        raise InputError(f"{name} = {value!r} is not allowed; allowed: {low:g} to {high:g}")
    return float(value)


def checked_whole(name: str, value: int, low: int, high: int) -> int:
    """A whole number within its range.

    Raises
    ------
    InputError
        It is none, or beyond.
    """
    if not isinstance(value, Real) or not low <= value <= high or value % 1:
        raise InputError(f"{name} = {value!r} is not allowed; allowed: a whole number from {low} to {high}")
    return int(value)
