"""Checks of arguments: of what kind they are, and whether they are within a range."""

import contextlib
import datetime
import difflib
import os
import reprlib
from collections import Counter
from collections.abc import Container, Iterable, Iterator, Sequence
from decimal import Decimal
from numbers import Integral, Real
from pathlib import Path
from typing import TypeGuard

import numpy as np

from .errors import InputError

LONGEST_NAME = 100
"""Longest text that is searched for among names; no name is as long, and the search takes its square."""
MAX_LISTED, FEW = 8, 3
"""Largest number of allowed names that a message lists whole, and how many it names of a longer list."""
LONGEST_PATH = 4096
SECOND = np.timedelta64(1, "s")
_REPR = reprlib.Repr()
_REPR.maxstring = _REPR.maxother = _REPR.maxlong = 100


def shown(given: object) -> str:
    """An argument as messages show it: on one line, and with its middle left out where it is long."""
    try:
        plain = given.item() if isinstance(given, np.number) and not _is_duration(given) else given
        return " ".join(_REPR.repr(plain).split())
    except Exception:  # somebody else's code
        return f"<{type(given).__name__}>"


def refusal(what: str, given: object, allowed: str) -> InputError:
    """The message about an argument that is not allowed."""
    return InputError(f"{what} = {shown(given)} is not allowed; allowed: {allowed}")


@contextlib.contextmanager
def reading(what: str, given: object, allowed: str) -> Iterator[None]:
    """Refuse an argument whose own methods fail while it is read."""
    try:
        yield
    except InputError:
        raise
    except Exception as problem:  # somebody else's code
        raise refusal(what, given, allowed) from problem


def is_one_of(given: object, names: Container[str]) -> TypeGuard[str]:
    """True for a text that is one of some names; an array, which compares item by item, is not."""
    return isinstance(given, str) and given in names


def check_kind(given: object, kinds: type | tuple[type, ...], what: str, allowed: str) -> None:
    """Refuse what is of another kind than wanted."""
    if not isinstance(given, kinds):
        raise refusal(what, given, allowed)


def checked_flag(name: str, given: object) -> bool:
    """True or False as a bool; numbers and objects that Python would take for either are refused."""
    check_kind(given, (bool, np.bool_), name, "True or False")
    return bool(given)


def path_of(given: object, what: str, allowed: str) -> Path:
    """A path that is given as a text or a Path."""
    check_kind(given, (str, os.PathLike), what, allowed)
    with reading(what, given, allowed):
        path = Path(given)  # type: ignore[arg-type] # its kind is checked
        if len(str(path)) <= LONGEST_PATH:
            return path
    raise refusal(what, given, allowed)


def number_of(given: object, unit: str = "") -> float | None:
    """The real number that an argument is, or None. A duration is converted to seconds if the unit is s."""
    if type(given) is float:
        return given
    try:
        if getattr(given, "ndim", None) == 0 and not np.ma.is_masked(given):
            given = np.asarray(given)[()]  # also of a DataArray
        if _is_duration(given):
            return _seconds(given) if unit == "s" else None
        is_real = isinstance(given, Real | Decimal) and not isinstance(given, bool)
        return float(given) if is_real else None  # type: ignore[arg-type] # it is one
    except Exception:  # too large, or somebody else's code
        return None


def _is_duration(given: object) -> bool:
    """True for a duration. Check this first, because NumPy's durations count as integers."""
    return isinstance(given, np.timedelta64 | datetime.timedelta)


def _seconds(duration: object) -> float:
    if isinstance(duration, datetime.timedelta):  # pandas has a subclass, to which NaT does not belong
        return duration.total_seconds()
    assert isinstance(duration, np.timedelta64)
    return float(duration / SECOND)


def checked(name: str, value: object, low: float, high: float, unit: str = "") -> float:
    """A number within its range."""
    number = number_of(value, unit)
    if number is None:
        raise refusal(name, value, f"a number, {low:g} to {high:g}")
    if not low <= number <= high:
        raise refusal(name, value, f"{low:g} to {high:g}")
    return number


def checked_between(name: str, value: object, low: float, high: float) -> float:
    """A number between two others, which are not allowed themselves."""
    number = number_of(value)
    if number is None or not low < number < high:
        raise refusal(name, value, f"a number above {low:g} and below {high:g}")
    return number


def checked_whole(name: str, value: object, low: int, high: int) -> int:
    """A whole number within its range."""
    if type(value) is int and low <= value <= high:
        return value
    number = number_of(value)
    if number is not None and number.is_integer():
        whole = int(value) if isinstance(value, Integral) else int(number)  # a float beyond 2^53 is not exact
        if low <= whole <= high:
            return whole
    raise refusal(name, value, f"a whole number from {low} to {high}")


MAX_THREADS = 2**31 - 1


def checked_threads(threads: object) -> int:
    """Number of threads, by default one for each processor."""
    return (os.cpu_count() or 1) if threads is None else checked_whole("threads", threads, 1, MAX_THREADS)


def number_in(text: str) -> float:
    """The number in a text. It raises ValueError for `1_05`, which Python's `float` reads as 105."""
    if "_" in text:
        raise ValueError(f"{shown(text)} is no number")
    return float(text)


MAX_NUMBERS = 100_000_000
"""Largest number of numbers in one argument; they take 800 MB."""


def check_size(what: str, count: int, of: str, maximum: int = MAX_NUMBERS) -> None:
    """Refuse, before any memory is asked for, what is too large to be done at once."""
    if count > maximum:
        raise InputError(f"{what}: {count:,} {of}; allowed: up to {maximum:,} at once")


def near_matches(name: object, names: Iterable[str]) -> str:
    """A hint at names that may have been meant, to follow in a message; empty where none is near."""
    if not isinstance(name, str) or len(name) > LONGEST_NAME:
        return ""
    near = difflib.get_close_matches(name, names, n=3, cutoff=0.5)
    return f"; near matches: {', '.join(near)}" if near else ""


def choice_of(names: Sequence[str], listed_by: str = "") -> str:
    """Allowed names in a message: all of a short list; of a long one a few, and the command that lists it."""
    if len(names) <= MAX_LISTED:
        return ", ".join(names)
    where = f", listed by `{listed_by}`" if listed_by else ""
    return f"{', '.join(names[:FEW])} and {len(names) - FEW} more{where}"


def check_names(
    given: Iterable[object],
    known: Sequence[str],
    what: str,
    also: Iterable[str] = (),
    allowed: str = "",
    listed_by: str = "",
) -> None:
    """Refuse unknown names. The message has near matches; they replace a long list of allowed names."""
    for name in given:
        if not is_one_of(name, known):
            near = near_matches(name, (*known, *also))
            is_listed = not near or len(known) <= MAX_LISTED
            choice = allowed or (choice_of(known, listed_by) if is_listed else "")
            hint = f"; allowed: {choice}" if choice else ""
            raise InputError(f"{what}: {shown(name)} is not allowed{hint}{near}")


def check_once(names: Iterable[object], what: str) -> None:
    """Refuse a name that is given twice."""
    twice = next((name for name, count in Counter(names).items() if count > 1), None)
    if twice is not None:
        raise InputError(f"{what}: {twice} is given twice; allowed: once")
