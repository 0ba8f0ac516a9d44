"""Gaits along a parameter, for figures and statements."""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from ..analysis.branches import continue_branch
from ..analysis.sweeps import Sweep, gaits_in
from ..library.gait import Gait
from ..variables.table import FRICTION


class Row(NamedTuple):
    """A point of a branch."""

    value: float
    """Value of the parameter."""
    kind: str
    """Kind of special point; empty for a gait that was met."""
    gait: Gait
    """Gait at the value."""


def followed(
    first: Gait, name: str, begin: float, end: float, *, to_turn: bool = False, **limits: Any
) -> list[Row]:
    """Gaits and special points of a gait's branch, from one end of a range of a parameter to the other.

    With `to_turn` only those up to the greatest value, where the branch first turns back.
    """
    branch = continue_branch(first, {name: (begin, end)}, switch=False, **limits)
    turns = np.flatnonzero(np.diff(branch[name].values) < 0.0)
    if to_turn and len(turns):
        branch = branch.isel(point=slice(turns[0] + 1))
    columns = branch[name].values.tolist(), branch["special"].values, gaits_in(branch)
    return [Row(*row) for row in zip(*columns, strict=True)]


def met(rows: Sequence[Row]) -> list[Row]:
    """Rows of gaits that were met, without special points."""
    return [row for row in rows if not row.kind]


def words_over(found: Sweep) -> list[tuple[str, float, float]]:
    """Words of a sweep over friction, and the frictions from which and to which each lasts."""
    gaits = found.gaits.isel({FRICTION: found.gaits["word"].values != ""})
    first, *_, last = gaits[FRICTION].values.tolist()
    edges = [first, *found.borders[FRICTION].values.tolist(), last]
    words = [gaits["word"].values[0], *found.borders["after"].values]
    return [(word, *edge) for word, edge in zip(words, pairwise(edges), strict=True)]
