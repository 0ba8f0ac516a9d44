"""Which states lead to a gait."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..checks import checked
from ..errors import InputError
from ..library.gait import Gait
from ..library.section import REDUCED, Apex, checked_apex
from .grid import Grid

FARTHEST = 1000.0
"""Sides of a cell."""


@dataclass(frozen=True, eq=False)
class Reached:
    """How many strides at the least lead from each cell to the cells about a gait."""

    target: NDArray[np.bool_]
    """Those cells, shape (rows, columns)."""
    inner: NDArray[np.int32]
    """From any point of the cell, by estimate; -1 where no choice of actions is known to lead there."""
    outer: NDArray[np.int32]
    """From some point of the cell, perhaps; -1 where none may."""

    @property
    def inner_share(self) -> float:
        """Share of the cells from which a choice of actions leads to the gait, from inside."""
        return float((self.inner >= 0).mean())

    @property
    def outer_share(self) -> float:
        """The same from outside."""
        return float((self.outer >= 0).mean())

    def as_json(self) -> dict[str, object]:
        """Summary in a few numbers."""
        return {
            "cells": int(self.target.sum()),
            "inner_share": self.inner_share,
            "outer_share": self.outer_share,
            "inner_strides": int(self.inner.max()),
            "outer_strides": int(self.outer.max()),
        }


def target_of(grid: Grid, gait: Gait | Apex, within: float) -> NDArray[np.bool_]:
    """The cells about a gait's apex."""
    within = checked("within", within, 0.5, FARTHEST)
    apex = gait.apex if isinstance(gait, Gait) else np.asarray(gait)
    point = checked_apex(apex[: len(REDUCED)], REDUCED)
    near = [
        (edges[:-1] >= at - within * size) & (edges[1:] <= at + within * size)
        for edges, at, size in zip(grid.edges.values(), point, grid.sizes, strict=True)
    ]
    target: NDArray[np.bool_] = near[0][:, None] & near[1]
    if not target.any():
        raise InputError(
            f"gait: at {', '.join(f'{at:g}' for at in point)}: no cell is as near; allowed: one in range"
        )
    return target
