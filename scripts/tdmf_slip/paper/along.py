"""Gaits along a parameter, one by one, for figures and statements."""

from typing import Any, NamedTuple

from ..analysis.branches import continue_branch
from ..analysis.sweeps import gaits_in, sweep
from ..library.gait import Gait
from ..library.runner import Runner
from ..variables.table import FRICTION
from ..variables.variable import Values


class Border(NamedTuple):
    """A change of the gait word."""

    value: float
    """Friction at which it changes."""
    before: str
    """Word before it, in the order of the sweep."""
    after: str
    """Word after it."""


class Swept(NamedTuple):
    """Gaits over friction."""

    by_value: list[Gait | None]
    """Gait at each friction; None where there is none."""
    borders: list[Border]
    """Changes of the word along a branch."""

    @property
    def gaits(self) -> list[Gait]:
        """Gaits at the frictions that have one."""
        return [gait for gait in self.by_value if gait is not None]


class Row(NamedTuple):
    """A point of a branch."""

    value: float
    """Value of the parameter."""
    kind: str
    """Kind of special point; empty for a gait that was met."""
    gait: Gait
    """Gait at the value."""


class Followed(NamedTuple):
    """A branch of gaits."""

    rows: list[Row]
    """Gaits and special points in the branch's order."""

    @property
    def gaits(self) -> list[Gait]:
        """Gaits that were met."""
        return [row.gait for row in self.rows if not row.kind]

    @property
    def values(self) -> list[float]:
        """Value of the parameter at each of the gaits."""
        return [row.value for row in self.rows if not row.kind]

    def specials(self, kind: str) -> list[Row]:
        """Special points of a kind."""
        return [row for row in self.rows if row.kind == kind]


def swept(runner: Runner, frictions: Values, progress: bool = False) -> Swept:
    """Gaits of a runner over friction, and the borders between their words."""
    gaits, borders = sweep(runner, {FRICTION: frictions}, progress=progress)
    found = iter(gaits_in(gaits))
    columns = (borders[name].values.tolist() for name in (FRICTION, "before", "after"))
    return Swept(
        [next(found) if word else None for word in gaits["word"].values],
        [Border(*border) for border in zip(*columns, strict=True)],
    )


def followed(first: Gait, name: str, begin: float, end: float, **limits: Any) -> Followed:
    """The branch of a gait from one end of a range of a parameter to the other."""
    branch = continue_branch(first, {name: (begin, end)}, switch=False, **limits)
    columns = branch[name].values.tolist(), branch["special"].values, gaits_in(branch)
    return Followed([Row(*row) for row in zip(*columns, strict=True)])
