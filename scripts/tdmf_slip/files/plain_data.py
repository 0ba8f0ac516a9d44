"""Plain objects, as `as_json` gives them, as datasets."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from ..record import attributes_of, without_record
from .datasets import xarray


def dataset_of(plain: Mapping[str, Any]) -> xarray.Dataset:
    """Each entry as a variable: lists over dimensions of their name, rows of mappings by their columns.

    The record of the result becomes the dataset's attributes.
    """
    data = xarray.Dataset(attrs=attributes_of(plain))
    for name, value in _flat(without_record(plain)):
        if value is None:
            continue
        if isinstance(value, list | tuple) and value and all(isinstance(row, Mapping) for row in value):
            for column in dict.fromkeys(key for row in value for key, _ in _flat(row)):
                array = _array([dict(_flat(row)).get(column) for row in value])
                if array is not None and array.ndim and array.size:
                    data[f"{name}.{column}"] = _dimensions(name, column, array), array
            continue
        array = _array(value)
        if array is not None and array.size:  # a file of the classic format has no empty dimension
            data[name] = _dimensions(name, "", array), array
    return data


def _flat(plain: Mapping[str, Any], prefix: str = "") -> list[tuple[str, Any]]:
    """Entries of nested mappings, their names joined by points."""
    return [
        entry
        for name, value in plain.items()
        for entry in (
            _flat(value, f"{prefix}{name}.") if isinstance(value, Mapping) else [(f"{prefix}{name}", value)]
        )
    ]


def _array(value: Any) -> np.ndarray[Any, Any] | None:
    """Numbers or texts; of rows of different lengths nothing."""
    numbers = _filled(value)
    try:
        array = np.asarray(numbers)
    except ValueError:
        return None
    return array.astype(object) if array.dtype.kind == "U" else None if array.dtype.kind == "O" else array


def _filled(value: Any) -> Any:
    """NaN where a number is missing."""
    if isinstance(value, list | tuple):
        return [_filled(one) for one in value]
    return np.nan if value is None else value


def _dimensions(name: str, column: str, array: np.ndarray[Any, Any]) -> tuple[str, ...]:
    """Names of an array's dimensions: numbered, and of rows the entry's own for the first."""
    own = f"{name}.{column}" if column else name
    return tuple(name if column and axis == 0 else f"{own}_{axis}" for axis in range(array.ndim))
