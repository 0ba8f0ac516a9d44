"""Gaits over a range of friction, and the borders between gait words."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from ..drawable import Drawable
from ..errors import InputError, RunError
from ..library.members import check_has_gaits
from ..library.orbit import Orbit, settled_orbit
from ..library.runner import Runner
from ..terminal import progress
from ..unit.unit import FRICTION, Unit, load
from ..unit.variable import Given, Values
from .borders import Border, crossings
from .continuation import gaits_over
from .family import Family
from .search import find_orbit

if TYPE_CHECKING:
    import xarray

MOST_VALUES = 1_000_000
"""Of a range, and of a grid."""
MOST_GAITS = 100_000
"""Of a sweep that is on no file: each takes 10 kB."""


@dataclass(frozen=True, repr=False)
class Sweep(Drawable):
    """Gaits at the values of a range, where they were found."""

    frictions: tuple[float, ...]
    """The range."""
    gaits: tuple[Orbit | None, ...]
    """At each friction; None where there is none, or it was not found."""
    borders: tuple[Border, ...]
    """Where the word changes along a branch, in the order of the range."""
    problem: str | None
    """Why gaits are missing, and what kept a border from being located; or None."""

    def __repr__(self) -> str:
        """In a line: how many gaits, from where to where, and their words."""
        words = ", ".join(dict.fromkeys(orbit.word for orbit in self.orbits))
        ends = f"{self.frictions[0]:.6g} to {self.frictions[-1]:.6g}"
        return f"<Sweep {len(self.orbits)} of {len(self.frictions)} gaits, {FRICTION} {ends}: {words}>"

    def to_xarray(self, unit: Unit | None = None) -> "xarray.Dataset":
        """Quantities of the gaits over the friction, with units.

        Parameters
        ----------
        unit : Unit, optional
            For units and descriptions; by default that of `fmu_path`.

        Returns
        -------
        xarray.Dataset
            As `grid.as_dataset` gives it.
        """
        from .grid import as_dataset  # xarray is slow to load

        return as_dataset(self.gaits, {FRICTION: np.array(self.frictions)}, load(unit))

    @property
    def orbits(self) -> tuple[Orbit, ...]:
        """The gaits that were found, in the order of the range."""
        return tuple(gait for gait in self.gaits if gait is not None)

    def as_json(self) -> dict[str, object]:
        """The sweep as a plain object; `missing` are the frictions without a gait."""
        found = zip(self.frictions, self.gaits, strict=True)
        return {
            "gaits": [orbit.as_json() for orbit in self.orbits],
            "transitions": [border.as_json() for border in self.borders],
            "missing": [friction for friction, gait in found if gait is None],
            "problem": self.problem,
        }


def sweep(runner: Runner | Mapping[str, Given], frictions: Values, *, show_progress: bool = False) -> Sweep:
    """The gait at each friction, each from the one before, and every change of the gait word between.

    Where the first frictions have no gait, the sweep begins at the first that has one, and follows its branch
    back as far as it goes; where a branch cannot be followed on, the sweep goes on with the next gait that is
    found. `problem` says what happened. Changes of the word from one branch to another are no borders.

    Parameters
    ----------
    runner : Runner or mapping of str to float
        Parameters and start, or start values by name; its friction does not matter.
    frictions : sequence of float
        Values in order, above 0.
    show_progress : bool, default False
        A bar on stderr.

    Returns
    -------
    Sweep
        The gaits, and the borders between their words.

    Raises
    ------
    InputError
        A value is refused.
    RunError
        There is no gait at any of them; the message tells of the first.
    """
    runner = Runner.of(runner)
    values = load().find(FRICTION, "frictions").values_of(frictions, "frictions")
    if len(values) > MOST_GAITS:
        raise InputError(f"{len(values):,} frictions: allowed: {MOST_GAITS:,}, or a grid, which is on file")
    check_frictions(runner, values)
    return sweep_row(runner, values, show_progress)


def sweep_row(runner: Runner, frictions: Values, show_progress: bool = False) -> Sweep:
    """`sweep` over frictions that are checked already.

    Parameters
    ----------
    runner : Runner
        Whose gaits.
    frictions : sequence of float
        Values in order.
    show_progress : bool, default False
        A bar on stderr.

    Returns
    -------
    Sweep
        As `sweep` gives it.
    """
    gaits: list[Orbit | None] = [None] * len(frictions)
    borders: list[Border] = []
    problems: list[str] = []
    end = 0
    with progress.bar("sweep", len(frictions), "gaits", show_progress) as bar:
        while end < len(frictions):
            begin, first, why = _begin(runner, frictions, end, bar)
            if first is None:
                problems += why
                break
            preceding, _ = _followed(runner, frictions[end:begin][::-1], first, bar)
            following, lost = _followed(runner, frictions[begin:], first, bar)
            branch = [*preceding[::-1], *following]
            problems += why if end < begin - len(preceding) else []
            problems += lost
            end = begin + len(following)
            gaits[end - len(branch) : end] = branch
            found, unknown = _borders(runner, branch)
            borders += found
            problems += unknown
    if not any(gaits):
        raise RunError("; ".join([*problems[:1], *["nor is there any further on"] * (len(frictions) > 1)]))
    return Sweep(
        frictions=tuple(float(friction) for friction in frictions),
        gaits=tuple(gaits),
        borders=tuple(borders),
        problem="; ".join(dict.fromkeys(problems)) or None,
    )


def _begin(
    runner: Runner, frictions: Values, start: int, bar: progress.Bar
) -> tuple[int, Orbit | None, list[str]]:
    """Number of a friction with a gait, the first from `start` on; that gait; why the one at `start` is none.

    While there is none yet, the longer search is made at both ends of the range: a branch that comes from
    outside is met there.
    """
    why: list[str] = []
    for number in range(start, len(frictions)):
        search = find_orbit if start == 0 and number in (0, len(frictions) - 1) else settled_orbit
        try:
            return number, search(runner.but(FRICTION, frictions[number])), why
        except RunError as problem:
            why = why or [str(problem)]
            bar.update()
    return len(frictions), None, why


def _followed(
    runner: Runner, frictions: Values, first: Orbit, bar: progress.Bar
) -> tuple[list[Orbit], list[str]]:
    """Gaits from one on, as far as the branch could be followed, and what stopped it."""
    found: list[Orbit] = []
    try:
        for orbit in gaits_over(runner, FRICTION, frictions, first):
            found.append(orbit)
            bar.update()
    except RunError as problem:
        return found, [str(problem)]
    return found, []


def _borders(runner: Runner, orbits: Sequence[Orbit]) -> tuple[list[Border], list[str]]:
    """All changes of the word, and why some are missing."""
    borders: list[Border] = []
    problems: list[str] = []
    for before, after in pairwise(orbits):
        try:
            family = Family(runner, FRICTION)
            borders += [found.border for found in crossings(family, *family.points(before, after))]
        except RunError as problem:
            problems.append(str(problem))
    return borders, problems


def check_frictions(runner: Runner, frictions: Values) -> None:
    """Refuse, before any work, frictions at which there is no gait to follow.

    Parameters
    ----------
    runner : Runner
        Whose gaits are to be found.
    frictions : sequence of float
        At which.
    """
    for friction in frictions:
        _ = runner.but(FRICTION, friction).inputs
        check_has_gaits(friction)
