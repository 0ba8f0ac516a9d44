"""Some rows of a slice of the apex section: a block of work, and what becomes of its starts."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..library.laws import Law, is_noisy
from ..library.runner import Runner
from ..library.section import COORDINATES
from .ball import Ball
from .fates import fates


@dataclass(frozen=True, eq=False)
class Slice:
    """Starts that differ from a gait's apex in two coordinates: a block of work."""

    runner: Runner
    """Whose starts."""
    apex: tuple[float, ...]
    """The gait's, shape (n,)."""
    axes: tuple[str, str]
    """Names of the two coordinates."""
    rows: tuple[float, ...]
    """Values of the first."""
    columns: tuple[float, ...]
    """Values of the second."""
    numbers: tuple[int, ...] = ()
    """Of the rows in the whole slice."""
    law: Law | None = None
    """By which runners are set."""
    ball: Ball | None = None
    """In which a start has settled."""

    def starts(self) -> NDArray[np.float64]:
        """One to a row, the columns running fastest."""
        sections = np.tile(self.apex, (len(self.rows), len(self.columns), 1))
        sections[..., COORDINATES.index(self.axes[0])] = np.asarray(self.rows)[:, None]
        sections[..., COORDINATES.index(self.axes[1])] = np.asarray(self.columns)[None, :]
        return sections.reshape(-1, len(self.apex))


def fates_of_slice(part: Slice) -> NDArray[np.int32]:
    """Fate, and strides until it was known, of each start of a block: shape (2, rows, columns)."""
    starts, columns = part.starts(), len(part.columns)
    rows = (
        list(zip(part.numbers, np.split(starts, len(part.rows)), strict=True)) if is_noisy(part.law) else []
    )
    runs = [
        fates(part.runner, part.apex, row, law=part.law, first_number=number * columns)
        for number, row in rows
    ] or [fates(part.runner, part.apex, starts, law=part.law, ball=part.ball)]
    both = np.concatenate([(run.fate, run.strides) for run in runs], axis=1)
    return both.reshape(2, -1, columns)
