"""What is given by name, in a row or as a range: mappings, lists, and the Series and DataFrames of users.

Those are known by what they can do, so that neither pandas nor another library of tables is imported.
"""

import math
from collections import Counter
from collections.abc import Hashable, Iterable, Mapping, Sequence
from typing import Any, Protocol, TypeGuard

import numpy as np

from .checks import checked_whole, is_number, shown
from .errors import InputError


class LabelledRow(Protocol):
    """Values with labels, as a Series of pandas."""

    def to_numpy(self) -> Any:
        """The values."""

    def items(self) -> Iterable[tuple[Hashable, Any]]:
        """The values with their labels."""


def is_table(given: object) -> TypeGuard[Any]:
    """Whether something is a table with named columns, as a DataFrame."""
    return hasattr(given, "to_numpy") and hasattr(given, "columns")


def is_series(given: object) -> TypeGuard[Any]:
    """Whether something is a row of values, as a Series, with labels or without."""
    return hasattr(given, "to_numpy") and not hasattr(given, "columns")


def mapping_of(given: object, what: str, allowed: str) -> Mapping[Any, Any]:
    """What is given by name."""
    if given is None:
        return {}
    if isinstance(given, Mapping):
        return given
    if is_table(given):
        _check_once(given.columns, what)
        return {name: np.asarray(given[name]) for name in given.columns}
    if is_series(given) and hasattr(given, "items"):
        pairs = list(given.items())
        _check_once((name for name, _ in pairs), what)
        return dict(pairs)
    raise InputError(f"{what} = {shown(given)} is not allowed; allowed: {allowed}")


def row_of(given: object, what: str, allowed: str) -> Sequence[Any]:
    """What is given one after the other."""
    check_row(given, what, allowed)
    return given if isinstance(given, Sequence) else list(given)  # type: ignore[call-overload] # it is a row


def check_row(given: object, what: str, allowed: str) -> None:
    """Refuse what is no row, without going through what may be as long as any."""
    is_array = isinstance(given, np.ndarray) and given.ndim > 0
    is_sequence = isinstance(given, Sequence) and not isinstance(given, str | bytes)
    if not (is_sequence or is_array or is_series(given)):
        raise InputError(f"{what} = {shown(given)} is not allowed; allowed: {allowed}")


def rows_of(given: object) -> object:
    """The rows of a table as mappings; what is no table, as it is."""
    if not is_table(given):
        return given
    columns = mapping_of(given, "table", "")
    return [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]


def in_order(given: object, names: Sequence[str]) -> Any:
    """Values by their labels, where these are the names that are wanted; else as they come."""
    frame: Any = given
    labels = frame.columns if is_table(given) else frame.index if _has_labels(given) else ()
    texts = [label for label in labels if isinstance(label, str)]
    if not texts:
        return given
    if sorted(texts) != sorted(names) or len(texts) != len(list(labels)):
        raise InputError(f"an apex with {', '.join(map(str, labels))}; allowed: {', '.join(names)}")
    return frame[list(names)].to_numpy()


def _has_labels(given: object) -> bool:
    """Whether a Series has a label for each value; a list has a method of that name."""
    return is_series(given) and hasattr(getattr(given, "index", None), "__iter__")


def _check_once(names: Iterable[object], what: str) -> None:
    twice = next((name for name, count in Counter(names).items() if count > 1), None)
    if twice is not None:
        raise InputError(f"{what}: {twice} is given twice; allowed: once")


def ends_given(what: str, given: object, *, may_be_one: bool = False) -> tuple[float, float]:
    """Both ends of a range (low, high), which differ unless they may be one."""
    allowed = "two finite numbers, the lower one first"
    try:
        low, high = (float(end) for end in row_of(given, what, allowed))
    except (TypeError, ValueError):
        raise InputError(f"{what} = {shown(given)} is not allowed; allowed: {allowed}") from None
    if not (math.isfinite(high - low) and (low < high or (may_be_one and low == high))):
        raise InputError(f"{what} = {shown(given)} is not allowed; allowed: {allowed}")
    return low, high


def counts_given(given: object, high: int) -> tuple[int, int]:
    """How many points each of two axes has: a number `n`, or one for each axis, from 2 on."""
    allowed = "a number, or one of each axis"
    both = is_number(given) or isinstance(given, bool | np.bool_)
    counts = (given, given) if both else tuple(row_of(given, "n", allowed))
    if len(counts) != 2:
        raise InputError(f"n = {shown(given)} is not allowed; allowed: {allowed}")
    first, second = (checked_whole("n", count, 2, high) for count in counts)
    return first, second
