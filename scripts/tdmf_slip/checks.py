"""What is given, checked: by its kind, and against a range."""

import difflib
import reprlib
from collections.abc import Iterable
from numbers import Real
from typing import TypeGuard

from .errors import InputError


def check_kind(given: object, kinds: type | tuple[type, ...], what: str, allowed: str) -> None:
    """Refuse what is of another kind than wanted.

    Parameters
    ----------
    given : object
        What was given.
    kinds : type or tuple of type
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


def is_number(given: object) -> TypeGuard[float]:
    """Whether something is a real number, of whatever type.

    Parameters
    ----------
    given : object
        What was given.

    Returns
    -------
    bool
        False for a text, an array, None.
    """
    return isinstance(given, Real)


def checked(name: str, value: object, low: float, high: float) -> float:
    """A number within its range.

    Parameters
    ----------
    name : str
        What it is of, for the message.
    value : object
        What was given.
    low, high : float
        The range, both ends allowed.

    Returns
    -------
    float
        The number.

    Raises
    ------
    InputError
        It is no number, or beyond.
    """
    if not is_number(value) or not low <= value <= high:
        raise InputError(f"{name} = {value!r} is not allowed; allowed: {low:g} to {high:g}")
    return float(value)


def checked_whole(name: str, value: object, low: int, high: int) -> int:
    """A whole number within its range.

    Parameters
    ----------
    name : str
        What it is of, for the message.
    value : object
        What was given.
    low, high : int
        The range, both ends allowed.

    Returns
    -------
    int
        The number.

    Raises
    ------
    InputError
        It is no number, beyond, or not whole.
    """
    if not is_number(value) or not low <= value <= high or value % 1:
        raise InputError(f"{name} = {value!r} is not allowed; allowed: a whole number from {low} to {high}")
    return int(value)


def near_matches(name: object, names: Iterable[str]) -> str:
    """A hint at names that may have been meant, to follow in a message; empty where none is near.

    Parameters
    ----------
    name : object
        What was given.
    names : iterable of str
        What there is.

    Returns
    -------
    str
        Beginning with a semicolon.
    """
    near = difflib.get_close_matches(str(name), names, n=3, cutoff=0.5)
    return f"; near matches: {', '.join(near)}" if near else ""
