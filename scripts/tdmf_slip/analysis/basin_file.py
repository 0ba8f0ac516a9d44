"""A region of attraction in a file: gone on with where it stopped, row by row. It needs the extra `data`."""

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from ..errors import InputError
from ..files.netcdf import CLASSIC, write_dataset
from ..files.resume import resumed
from ..files.rows import RowFile
from ..library.engine import FATES
from .basin_result import NOT_YET, STRIDES, Basin
from .fates import MAX_STRIDES

STRIDES_OF_FATES: Mapping[int, tuple[int, int]] = {
    **dict.fromkeys(range(len(FATES)), (0, MAX_STRIDES)),
    FATES.index("no_start"): (0, 0),
    NOT_YET: (0, MAX_STRIDES),
}
"""The least and the most that a fate may come after."""


class BasinFile:
    """A NetCDF file of a map, which holds at any time the rows that are done."""

    def __init__(self, path: Path) -> None:
        """One that may be there already."""
        self.path = path
        self.rows: RowFile | None = None

    def resumed(self, blank: Basin) -> Basin:
        """What the file holds already, or `blank` where there is none; another map is refused."""
        data = Basin.of_dataset(resumed(self.path, blank.to_xarray(), "slice"))
        fates, strides = data["fate"], data[STRIDES]
        allowed = np.select(
            [fates == fate for fate in STRIDES_OF_FATES],
            [(strides >= minimum) & (strides <= maximum) for minimum, maximum in STRIDES_OF_FATES.values()],
            False,
        )
        if not allowed.all():
            row, column = np.argwhere(~allowed)[0]
            raise InputError(
                f"{self.path}: holds another slice, in row {row}, column {column} with fate "
                f"{fates[row, column]} after {strides[row, column]} strides; allowed: another file name"
            )
        return data

    def write_rows(self, data: Basin, rows: Sequence[int]) -> None:
        """Rows that are done; their fates come last."""
        self.rows = self.rows or RowFile(self.path, data.to_xarray())
        self.rows.write((STRIDES, "fate"), rows)

    def write(self, data: Basin) -> None:
        """All of it."""
        write_dataset(self.path, data.to_xarray(), CLASSIC)
