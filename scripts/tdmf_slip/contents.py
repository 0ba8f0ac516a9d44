"""Results that are equal where their contents are."""

import dataclasses
from collections.abc import Hashable, Mapping
from typing import Any, ClassVar, NoReturn

import numpy as np


class ByContents:
    """A dataclass, made with `eq=False`, whose arrays and numbers are compared one by one; NaN equals NaN."""

    __dataclass_fields__: ClassVar[dict[str, dataclasses.Field[Any]]]
    __array_ufunc__: ClassVar[None] = None
    """NumPy's arrays leave a comparison with these to these."""

    def __eq__(self, other: object) -> bool:
        """Whether another of the same kind has the same contents."""
        if type(other) is not type(self):
            return NotImplemented
        return self is other or _same_fields(self, other)

    def __hash__(self) -> NoReturn:
        """Refuse: what is equal by its contents would have to be hashed by all of them."""
        raise TypeError(
            f"{type(self).__name__} is compared by its contents and has no hash; allowed: in a list, "
            "or in a dictionary by a name of its own"
        )


def same(one: object, other: object) -> bool:
    """Whether two values are the same by their contents."""
    if isinstance(one, np.ndarray) or isinstance(other, np.ndarray):
        return _same_arrays(one, other)
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        if isinstance(one, Hashable):  # as a runner, which is more than its values
            return bool(one == other)
        return one.keys() == other.keys() and all(same(value, other[name]) for name, value in one.items())
    if isinstance(one, list | tuple) and type(one) is type(other):
        assert isinstance(other, list | tuple)
        return len(one) == len(other) and all(map(same, one, other))
    if dataclasses.is_dataclass(one) and type(one) is type(other):
        return _same_fields(one, other)
    return bool(one == other) or (_is_nan(one) and _is_nan(other))


def _same_fields(one: Any, other: object) -> bool:
    names = [field.name for field in dataclasses.fields(one) if field.compare]
    return all(same(getattr(one, name), getattr(other, name)) for name in names)


def _same_arrays(one: object, other: object) -> bool:
    if not isinstance(one, np.ndarray) or not isinstance(other, np.ndarray):
        return False
    if one.shape != other.shape or one.dtype.names != other.dtype.names:
        return False
    if one.dtype.names is not None:
        return all(_same_arrays(one[name], other[name]) for name in one.dtype.names)
    if one.dtype.kind == "O":
        return all(map(same, one.ravel().tolist(), other.ravel().tolist()))
    numbers = one.dtype.kind in "fc" and other.dtype.kind in "fc"
    return bool(np.array_equal(one, other, equal_nan=numbers))


def _is_nan(value: object) -> bool:
    return isinstance(value, float | complex) and value != value
