"""Results for the paper's runner, and the data of each figure as a table.

The table of a figure whose data take minutes is stored beside its module, as `NAME.csv`.
`tdmf-slip figures --measure` computes the stored tables anew and writes them beside the figures.
"""

import importlib.resources
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache, cached_property
from operator import attrgetter
from typing import Any

import numpy as np
import pandas

from ...analysis.search import periodic_gait
from ...analysis.sweeps import Sweep, gaits_in, sweep
from ...library.gait import Gait
from ...library.runner import Runner
from ...pictures.panels import Stride
from ...variables.parameters import read_parameters
from ...variables.table import FRICTION
from ..evidence import SWEPT
from ..matched import match_gaits

EQUAL = 48
"""Number of gaits over friction that are matched to the first one."""
CLAMP = "hip.swing_clamp"


class Results:
    """Results for the paper's runner, each computed when it is first asked for."""

    def __init__(self, tables: Mapping[str, Callable[["Results"], pandas.DataFrame]], measure: bool = False):
        """Compute tables by the functions of the figures, or read the stored ones."""
        self.runner = Runner(read_parameters("paper"))
        self._tables, self._measure = tables, measure
        self.table, self.stride = cache(self._table), cache(self._stride)

    def _table(self, figure: str) -> pandas.DataFrame:
        """Data of a figure."""
        known = None if self._measure else stored(figure)
        return self._tables[figure](self) if known is None else known

    def _stride(self, friction: float, clamp: bool = False) -> Stride:
        return Stride(self.gait(friction, {CLAMP: clamp}))

    def gait(self, friction: float, values: Mapping[str, Any] | None = None) -> Gait:
        """The gait at a friction, with other values of the runner."""
        return periodic_gait(self.runner.replace({FRICTION: friction, **(values or {})}))

    @cached_property
    def sweep(self) -> Sweep:
        """Gaits over friction, and the borders between their words."""
        return sweep(self.runner, {FRICTION: SWEPT})

    @cached_property
    def gaits(self) -> list[Gait]:
        """Gaits over friction, by falling friction."""
        return gaits_in(self.sweep.gaits)

    @cached_property
    def equal(self) -> list[Gait]:
        """Gaits over friction, matched to the first one."""
        chosen = np.linspace(0, len(self.gaits) - 1, EQUAL).round().astype(int)
        return match_gaits([self.gaits[0], *(self.gaits[number] for number in chosen)])

    @property
    def both(self) -> list[tuple[int, Gait]]:
        """Pairs of a number and a gait: 0 for gaits over friction, 1 for those matched to the first one."""
        return [*((0, gait) for gait in self.gaits), *((1, gait) for gait in self.equal)]


def stored(figure: str) -> pandas.DataFrame | None:
    """Stored data of a figure; None if they are not stored."""
    file = importlib.resources.files(__package__).joinpath(f"{figure}.csv")
    if not file.is_file():
        return None
    with file.open(encoding="utf-8") as text:
        return pandas.read_csv(text, keep_default_na=False)


Column = str | Callable[[Any], Any]
"""Name of an attribute, with dots as in `gait.word` where it is nested, or a function of the row."""


def table_of(rows: Iterable[Any], *attributes: str, **columns: Column) -> pandas.DataFrame:
    """A row for each gait or other object: its attributes, and columns of other names."""
    rows, found = list(rows), dict(zip(attributes, attributes, strict=True)) | columns
    values_of = {name: attrgetter(of) if isinstance(of, str) else of for name, of in found.items()}
    return pandas.DataFrame({name: [of(row) for row in rows] for name, of in values_of.items()})


def table_by(
    names: Sequence[str], rows: Iterable[tuple[Any, ...]], *attributes: str, **columns: Column
) -> pandas.DataFrame:
    """A row for each tuple: its first items under the names, and columns of its gait as in `table_of`."""
    *keys, gaits = zip(*rows, strict=True)
    before = pandas.DataFrame(dict(zip(names, keys, strict=True)))
    return before.join(table_of(gaits, *attributes, **columns))


def value_of(name: str) -> Callable[[Gait], float]:
    """Column with the value of a parameter or input in the runner of each gait."""
    return lambda gait: gait.runner[name]


def leading(gait: Gait) -> np.ndarray:
    """Real parts of the two eigenvalues of largest modulus, the greater one first."""
    return np.sort(gait.eigenvalues[:2].real)[::-1]


LEADING: Mapping[str, Callable[[Gait], float]] = {
    "greater_eigenvalue": lambda gait: float(leading(gait)[0]),
    "other_eigenvalue": lambda gait: float(leading(gait)[1]),
}
"""Columns of the two leading eigenvalues, which keep their signs along a branch."""
