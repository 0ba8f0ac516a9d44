"""Gaits over two parameters."""

from dataclasses import dataclass

import numpy as np

from ..labelled import LabelledArrays


@dataclass(frozen=True, eq=False, repr=False)
class GaitGrid(LabelledArrays):
    """Gaits over two parameters: `grid["speed"]` is an array over both, NaN where there is no gait."""

    @property
    def axes(self) -> tuple[str, str]:
        """Names of the two parameters."""
        first, second = self.variables["word"].dimensions
        return first, second

    @property
    def gaits(self) -> int:
        """How many were found."""
        return int(np.isfinite(self["period"]).sum())

    @property
    def words(self) -> tuple[str, ...]:
        """Of the gaits, each once, in alphabetical order."""
        return tuple(sorted({word for word in self["word"].ravel() if word}))

    def __repr__(self) -> str:
        """In a line: over what, how many, and their words."""
        rows, columns = self["word"].shape
        return (
            f"<GaitGrid of {' and '.join(self.axes)}: {self.gaits:,} of {rows:,} by {columns:,} gaits, "
            f"{', '.join(self.words)}>"
        )
