"""Arguments by name, in a row or as a range: mappings, lists, and the Series and DataFrames of users.

Those are known by what they can do, so that neither pandas nor another library of tables is imported.
"""

import math
from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence, Sized
from typing import Any, Protocol, TypeGuard

import numpy as np
from numpy.typing import NDArray

from .checks import check_once, check_size, checked_whole, number_of, reading, refusal
from .errors import InputError


class LabelledRow(Protocol):
    """Values with labels, as a Series of pandas."""

    def to_numpy(self) -> Any:
        """The values."""

    def items(self) -> Iterable[tuple[Hashable, Any]]:
        """The values with their labels."""


def is_table(given: object) -> TypeGuard[Any]:
    """True for a table with named columns, such as a DataFrame."""
    return hasattr(given, "to_numpy") and hasattr(given, "columns")


def is_series(given: object) -> TypeGuard[Any]:
    """True for a row of values, such as a Series, with labels or without."""
    return hasattr(given, "to_numpy") and not hasattr(given, "columns")


MAX_ROW = 10_000_000
"""Length of a row, at most."""


def mapping_of(given: object, what: str, allowed: str) -> dict[Any, Any]:
    """Values by name, as a new dictionary."""
    if given is None or type(given) is dict:
        return dict(given or {})
    with reading(what, given, allowed):
        if isinstance(given, Mapping):
            return dict(given)
        if is_table(given):
            check_once(given.columns, what)
            return {name: np.asarray(given[name]) for name in given.columns}
        if is_series(given) and hasattr(given, "items"):
            pairs = list(given.items())
            check_once((name for name, _ in pairs), what)
            return dict(pairs)
    raise refusal(what, given, allowed)


def row_of(given: object, what: str, allowed: str, maximum: int = MAX_ROW) -> list[Any]:
    """Values in a row, as a new list."""
    is_array = isinstance(given, np.ndarray) and given.ndim > 0
    is_sequence = isinstance(given, Sequence) and not isinstance(given, str | bytes)
    if not (is_sequence or is_array or is_series(given)):
        raise refusal(what, given, allowed)
    row: Any = given
    with reading(what, given, allowed):
        check_size(what, len(row), "values", maximum)
        return list(row)


def numbers_of(what: str, given: object, allowed: str = "numbers", unit: str = "") -> NDArray[np.float64]:
    """An array of real numbers, of any shape. Durations are converted to seconds if the unit is s.

    Refused are

    - complex numbers and truth values, which NumPy would convert to real numbers,
    - masked values,
    - dates, texts, and rows of different lengths.
    """
    with reading(what, given, allowed):
        length = (
            given.size if isinstance(given, np.ndarray) else len(given) if isinstance(given, Sized) else 1
        )
        check_size(what, length, "numbers")
        if not _is_masked(given):
            array = np.asarray(given)
            check_size(what, array.size, "numbers")
            if array.dtype.kind in "iuf":
                return array.astype(float)
            if array.dtype.kind in "mO":
                numbers = [number_of(one, unit) for one in array.ravel()]
                if None not in numbers:
                    return np.array(numbers, dtype=float).reshape(array.shape)
    raise refusal(what, given, allowed)


def _is_masked(given: object) -> bool:
    """True if the values contain a masked one anywhere."""
    if isinstance(given, np.ma.MaskedArray):
        return bool(np.ma.is_masked(given))
    return isinstance(given, list | tuple) and any(map(_is_masked, given))


def rows_of(given: object, what: str) -> object:
    """The rows of a table as mappings; what is no table, as it is."""
    if not is_table(given):
        return given
    columns = mapping_of(given, what, "a table")
    return [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]


def numbers_by(what: str, given: object, names: Sequence[str]) -> NDArray[np.float64]:
    """Numbers in the order of the names if they are labelled by them, else in their own order."""
    if type(given) is np.ndarray and given.dtype == float:
        check_size(what, given.size, "numbers")
        return given.copy()  # the usual case, at once
    allowed = f"numbers for {', '.join(names)}"
    frame: Any = given
    with reading(what, given, allowed):
        labels = list(frame.columns if is_table(given) else frame.index if _has_labels(given) else ())
        texts = [label for label in labels if isinstance(label, str)]
        if texts and (sorted(texts) != sorted(names) or len(texts) != len(labels)):
            raise InputError(f"an apex with {', '.join(map(str, labels))}; allowed: {', '.join(names)}")
        return numbers_of(what, frame[list(names)] if texts else given, allowed)


def _has_labels(given: object) -> bool:
    """True for a Series with a label for each value. A list has a method called `index`, too."""
    return is_series(given) and hasattr(getattr(given, "index", None), "__iter__")


def ends_given(
    what: str,
    given: object,
    *,
    may_be_one: bool = False,
    read: Callable[[list[Any], str], list[Any]] = lambda row, _: row,
) -> tuple[float, float]:
    """Both ends of a range (low, high), which differ unless they may be one; `read` converts texts."""
    allowed = "two finite numbers, the lower one first"
    ends = [number_of(end) for end in read(row_of(given, what, allowed)[:3], what)]
    if len(ends) == 2 and ends[0] is not None and ends[1] is not None:
        low, high = ends[0], ends[1]
        if math.isfinite(high - low) and (low < high or (may_be_one and low == high)):
            return low, high
    raise refusal(what, given, allowed)


def counts_given(given: object, high: int) -> tuple[int, int]:
    """Numbers of points of two axes, at least 2: a number `n` for both, or one for each axis."""
    allowed = "a number, or one of each axis"
    counts = [given, given] if number_of(given) is not None else row_of(given, "n", allowed)
    if len(counts) != 2:
        raise refusal("n", given, allowed)
    first, second = (checked_whole("n", count, 2, high) for count in counts)
    return first, second
