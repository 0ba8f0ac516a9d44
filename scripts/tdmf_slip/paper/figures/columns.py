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


def columns(name: str) -> dict[str, NDArray[Any]]:
    """The data of a figure, by column."""
    text = importlib.resources.files(__package__).joinpath(f"{name}.csv").read_text(encoding="utf-8")
    rows = list(csv.DictReader(text.splitlines()))
    return {column: _values([row[column] for row in rows], column in TEXTS) for column in rows[0]}


def _values(given: list[str], are_texts: bool) -> NDArray[Any]:
    if are_texts:
        return np.array(given)
    words = {"True": 1.0, "False": 0.0}
    return np.array([words[value] if value in words else float(value) for value in given])


Columns: TypeAlias = Mapping[str, Sequence[Any] | NDArray[Any]]
"""Values by name, in columns of equal length."""


def attributes(rows: Sequence[Any], *names: str) -> dict[str, list[Any]]:
    """Attributes of gaits or other objects as columns, with a row for each object."""
    return {name: [getattr(row, name) for row in rows] for name in names}


def write_columns(path: Path, columns: Columns) -> None:
    """Write columns as CSV, whole or not at all."""
    with whole(path) as beside, beside.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        writer.writerows(zip(*columns.values(), strict=True))
