"""The data of a figure, by column."""

import csv
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, TypeAlias

from numpy.typing import NDArray

from ...files.whole import whole

Columns: TypeAlias = Mapping[str, Sequence[Any] | NDArray[Any]]
"""Values by name, in columns of equal length."""


def write_columns(path: Path, columns: Columns) -> None:
    """Write columns as CSV, whole or not at all."""
    with whole(path) as beside, beside.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        writer.writerows(zip(*columns.values(), strict=True))
