"""Results for the paper's runner, and the data of each figure as a table.

The table of a figure whose data take minutes is stored beside its module, as `NAME.csv`.
`tdmf-slip figures --measure` computes the stored tables anew and writes them beside the figures.
"""

import importlib.resources
from collections.abc import Callable, Iterable, Mapping
from functools import cache, cached_property
from operator import attrgetter
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas

from ...analysis.sweeps import gaits_in
from ...library.runner import Runner
from ...pictures.panels import Stride
from ...variables.parameters import read_parameters
from ..along import gait_table
from ..evidence import Evidence
from ..matched import match_gaits
from ..statements.claim import CLAMP

if TYPE_CHECKING:
    import xarray

EQUAL = 48
"""Number of gaits over friction that are matched to the first one."""


class Results(Evidence):
    """Results for the paper's runner, each computed when it is first asked for."""

    def __init__(self, tables: Mapping[str, Callable[["Results"], pandas.DataFrame]], measure: bool = False):
        """Compute tables by the functions of the figures, or read the stored ones."""
        super().__init__(Runner(read_parameters("paper")))
        self._tables, self._measure = tables, measure
        self.table, self.stride = cache(self._table), cache(self._stride)

    def _table(self, figure: str) -> pandas.DataFrame:
        """Data of a figure."""
        known = None if self._measure else stored(figure)
        return self._tables[figure](self) if known is None else known

    def _stride(self, friction: float, clamp: bool = False) -> Stride:
        return Stride(self.gait(friction, **{CLAMP: clamp}))

    @cached_property
    def equal(self) -> "xarray.Dataset":
        """Gaits over friction, matched to the first one."""
        found = gaits_in(self.sweep.gaits)
        chosen = np.linspace(0, len(found) - 1, EQUAL).round().astype(int)
        return match_gaits([found[0], *(found[number] for number in chosen)])

    @property
    def both(self) -> pandas.DataFrame:
        """Gaits over friction, then, as `matched`, those matched to the first one."""
        matched = gait_table(self.equal).assign(matched=True)
        return pandas.concat([self.gaits.assign(matched=False), matched], ignore_index=True)


def stored(figure: str) -> pandas.DataFrame | None:
    """Stored data of a figure; None if they are not stored."""
    file = importlib.resources.files(__package__).joinpath(f"{figure}.csv")
    if not file.is_file():
        return None
    with file.open(encoding="utf-8") as text:
        return pandas.read_csv(text, keep_default_na=False)


def table_of(rows: Iterable[Any], *attributes: str, **columns: Callable[[Any], Any]) -> pandas.DataFrame:
    """A row for each object: its attributes, and what functions of it give."""
    rows, values_of = list(rows), {name: attrgetter(name) for name in attributes} | columns
    return pandas.DataFrame({name: [of(row) for row in rows] for name, of in values_of.items()})
