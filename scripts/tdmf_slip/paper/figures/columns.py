"""The data of a figure, by column, computed or stored.

Data of figures that take minutes to compute are stored. `tdmf-slip figures --measure` recomputes them and
writes them beside the figures.
"""

import csv
import importlib.resources
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ...files.whole import whole

TEXTS = ("kind", "law", "word")
"""Columns of text."""
NUMBERS = {"True": 1.0, "False": 0.0}
"""Numbers that stand for stored truth values."""
Columns: TypeAlias = dict[str, NDArray[Any]]
"""Values by name, in columns of equal length."""
Data: TypeAlias = Mapping[str, Sequence[Any] | NDArray[Any]]
"""Columns, or sequences that `as_columns` makes columns of."""


def columns(name: str) -> Columns:
    """The stored data of a figure, by column."""
    text = importlib.resources.files(__package__).joinpath(f"{name}.csv").read_text(encoding="utf-8")
    rows = list(csv.DictReader(text.splitlines()))
    return as_columns({of: [_value(row[of], of) for row in rows] for of in rows[0]})


def _value(text: str, column: str) -> str | float:
    if column in TEXTS:
        return text
    return NUMBERS[text] if text in NUMBERS else float(text)


def as_columns(data: Data) -> Columns:
    """Sequences as columns."""
    return {name: np.asarray(values) for name, values in data.items()}


def select(data: Columns, chosen: Any = True, **values: Any) -> Columns:
    """The rows that are chosen by a mask or by indices, and that have these values."""
    has_values = np.all([data[name] == value for name, value in values.items()], axis=0)
    mask = chosen & has_values if values else chosen
    return {name: column[mask] for name, column in data.items()}


def attributes(rows: Sequence[Any], *names: str) -> dict[str, list[Any]]:
    """Attributes of gaits or other objects as columns, with a row for each object."""
    return {name: [getattr(row, name) for row in rows] for name in names}


def write_columns(path: Path, columns: Columns) -> None:
    """Write columns as CSV, whole or not at all."""
    with whole(path) as beside, beside.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        writer.writerows(zip(*(column.tolist() for column in columns.values()), strict=True))
