"""What is given, checked: by its kind, and against a range."""

import difflib
import reprlib
from collections.abc import Container, Iterable
from numbers import Real
from typing import TypeGuard

from .errors import InputError

LONGEST_NAME = 100
"""Of what is searched for among names: none is as long, and the search takes the square of it."""
_REPR = reprlib.Repr()
_REPR.maxstring = _REPR.maxother = _REPR.maxlong = 100


def shown(given: object) -> str:
    """What was given, for a message: on one line, and with its middle left out where it is long."""
    return " ".join(_REPR.repr(given).split())


def is_one_of(given: object, names: Container[str]) -> TypeGuard[str]:
    """Whether something is one of some names; an array, which compares item by item, is none."""
    return isinstance(given, str) and given in names


def check_kind(given: object, kinds: type | tuple[type, ...], what: str, allowed: str) -> None:
    """Refuse what is of another kind than wanted."""
    if not isinstance(given, kinds):
        raise InputError(f"{what} = {shown(given)} is not allowed; allowed: {allowed}")


def is_number(given: object) -> TypeGuard[float]:
    """Whether something is a real number, of whatever type."""
    return isinstance(given, Real)


def checked(name: str, value: object, low: float, high: float) -> float:
    """A number within its range."""
    if not is_number(value) or not low <= value <= high:
        raise InputError(f"{name} = {shown(value)} is not allowed; allowed: {low:g} to {high:g}")
    return float(value)


def checked_whole(name: str, value: object, low: int, high: int) -> int:
    """A whole number within its range."""
    if not is_number(value) or not low <= value <= high or value % 1:
        raise InputError(
            f"{name} = {shown(value)} is not allowed; allowed: a whole number from {low} to {high}"
        )
    return int(value)


MAX_NUMBERS = 100_000_000
"""In what is given at once; they take 800 MB."""


def check_size(what: str, count: int, of: str, maximum: int = MAX_NUMBERS) -> None:
    """Refuse, before any memory is asked for, what is too large to be done at once."""
    if count > maximum:
        raise InputError(f"{what}: {count:,} {of}; allowed: up to {maximum:,} at once")


def near_matches(name: object, names: Iterable[str]) -> str:
    """A hint at names that may have been meant, to follow in a message; empty where none is near."""
    text = str(name)
    if len(text) > LONGEST_NAME:
        return ""
    near = difflib.get_close_matches(text, names, n=3, cutoff=0.5)
    return f"; near matches: {', '.join(near)}" if near else ""
