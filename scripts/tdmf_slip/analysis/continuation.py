"""Gaits along a parameter: at values in turn, or as a branch that is followed through folds.

A branch is followed by pseudo-arclength continuation on the exact Jacobian.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..checks import check_kind, checked, checked_whole, is_number
from ..drawable import Drawable
from ..errors import InputError, RunError
from ..library.orbit import Orbit, check_orbit
from ..library.runner import Runner
from ..unit.unit import Unit, load
from ..unit.variable import Given, Values
from .bifurcations import Special, happenings
from .borders import Border
from .family import Family, Point

if TYPE_CHECKING:
    import xarray

SHORTEST_STEP = 1e-7
"""Along the branch: where no step of this length finds a gait, the branch ends."""
LARGEST_STEP = 1e9
MOST_POINTS = 1_000_000
"""Of a branch."""


@dataclass(frozen=True, repr=False)
class Branch(Drawable):
    """Gaits in the order in which they were met along a parameter."""

    name: str
    """Of the parameter or input."""
    values: tuple[float, ...]
    """Of the parameter, at each gait."""
    orbits: tuple[Orbit, ...]
    """The gaits."""
    borders: tuple[Border, ...]
    """Where the word changes, in the branch's order."""
    specials: tuple[Special, ...]
    """Bifurcations, word borders, and what could not be judged, in the branch's order."""
    ended: str
    """Why the branch stops: at the end of the range, where it began, or in words what happened."""

    def __repr__(self) -> str:
        """In a line: how many gaits, from where to where, and what is special."""
        kinds = ", ".join(dict.fromkeys(special.kind for special in self.specials)) or "nothing special"
        ends = f"{self.values[0]:.6g} to {self.values[-1]:.6g}"
        return f"<Branch {len(self.orbits)} gaits, {self.name} {ends}: {kinds}; ended: {self.ended}>"

    def to_xarray(self, unit: Unit | None = None) -> "xarray.Dataset":
        """Quantities of the gaits over the parameter, in the branch's order, with units.

        Parameters
        ----------
        unit : Unit, optional
            For units and descriptions; by default that of `fmu_path`.

        Returns
        -------
        xarray.Dataset
            As `grid.as_dataset` gives it; behind a fold the parameter goes back.
        """
        from .grid import as_dataset  # xarray is slow to load

        return as_dataset(self.orbits, {self.name: np.array(self.values)}, load(unit))


def gaits_over(
    runner: Runner | Mapping[str, Given],
    name: str,
    values: Values,
    first: Orbit,
    step_finished: Callable[[], None] = lambda: None,
) -> Iterator[Orbit]:
    """The gait at each value in turn, each from the one before; steps in between where values are far apart.

    Parameters
    ----------
    runner : Runner or mapping of str to float
        Whose gaits.
    name : str
        Parameter or input that is varied.
    values : sequence of float
        Of it, in its unit.
    first : Orbit
        A gait to begin at.
    step_finished : callable, optional
        Called after each gait.

    Yields
    ------
    Orbit
        At each value.

    Raises
    ------
    InputError
        The name is that of no parameter or input, a value is none, or `first` is no gait.
    RunError
        The branch cannot be followed so far.
    """
    family = Family(runner, name)
    check_orbit(first, "first")
    check_kind(values, (Sequence, np.ndarray), "values", f"a row of values of {name}")
    at = family.value_of(first)
    orbit = first if first.along == name else family.orbit(at, first.apex)
    for value in values:
        for part in _walk(family, orbit, at, family.runner.but(name, value).values[name]):
            orbit, at = part, family.value_of(part)
        yield orbit
        step_finished()


def _walk(family: Family, orbit: Orbit, at: float, to: float) -> Iterator[Orbit]:
    """Gaits from one value to another, by predictions along the branch, shorter where they fail."""
    step = to - at
    if step == 0.0:
        yield family.orbit(to, orbit.apex)
        return
    smallest = 1e-9 * max(abs(at), abs(to))
    while at != to:
        step = np.clip(step, -abs(to - at), abs(to - at))
        value = to if abs(to - at - step) < smallest else at + step
        try:
            nearby = _predicted(family, orbit, value - at)
            following = family.orbit(value, nearby)
        except RunError:
            step *= 0.5
            if abs(step) < smallest:
                raise
            continue
        yield following
        orbit, at, step = following, value, 2.0 * step


def _predicted(family: Family, orbit: Orbit, step: float) -> NDArray[np.float64]:
    """The apex at a parameter a little away, along the branch's tangent."""
    assert orbit.by_parameter is not None
    try:
        tangent = np.linalg.solve(np.eye(len(orbit.apex)) - orbit.jacobian, orbit.by_parameter)
    except np.linalg.LinAlgError:
        raise RunError(f"the branch turns at {family.name} = {family.value_of(orbit):g}") from None
    return orbit.apex + step * tangent


def trace(
    runner: Runner | Mapping[str, Given],
    name: str,
    first: Orbit,
    end: float,
    *,
    largest_step: float = 0.05,
    most_points: int = 1000,
    step_finished: Callable[[], None] = lambda: None,
) -> Branch:
    """Follow the branch of a gait, through folds, until the parameter leaves the range.

    Pseudo-arclength continuation: each gait is sought on the plane across the branch's tangent. Lengths along
    the branch are measured over the coordinates' scales, and over the first value of the parameter.

    Parameters
    ----------
    runner : Runner or mapping of str to float
        Whose gaits.
    name : str
        Parameter or input that is varied.
    first : Orbit
        A gait to begin at.
    end : float
        Value of the parameter at which to stop; where a fold leads back, the branch stops at its first.
    largest_step : float, default 0.05
        Along the branch.
    most_points : int, default 1000
        Stop after so many gaits.
    step_finished : callable, optional
        Called after each gait.

    Returns
    -------
    Branch
        The gaits in their order, with borders and bifurcations.

    Raises
    ------
    InputError
        No such parameter, it has the value of `end` already, or what is given is none.
    RunError
        The first gait cannot be found again.
    """
    runner = Family(runner, name).runner
    check_orbit(first, "first")
    checked("largest_step", largest_step, SHORTEST_STEP, LARGEST_STEP)
    checked_whole("most_points", most_points, 1, MOST_POINTS)
    start = first.runner.values[name]
    if not is_number(end):
        raise InputError(f"end {end!r} of {name}: allowed: a number")
    if not abs(end - start) > 0.0:
        raise InputError(f"end {end:g} of {name}: allowed: a number other than the first gait's {start:g}")
    family = Family(runner.but(name, start), name)
    towards_end = np.append(np.zeros_like(first.apex), end - start)
    points, ended = [family.point(family.orbit(start, first.apex), towards_end)], f"{most_points} gaits"
    step = largest_step / 10.0
    while len(points) < most_points:
        last = points[-1]
        try:
            following = family.on_plane(family.place(last) + step * last.direction, last.direction)
        except (InputError, RunError) as problem:
            step *= 0.5
            if step < SHORTEST_STEP:
                ended = str(problem)
                break
            continue
        points.append(following)
        step_finished()
        if not min(start, end) < following.value < max(start, end):
            beyond_end = (following.value - end) * (end - start) >= 0.0
            ended = "end of the range" if beyond_end else f"back at {name} = {start:g}"
            break
        step = min(largest_step, 1.5 * step)
    return _branch(family, points, ended)


def _branch(family: Family, points: Sequence[Point], ended: str) -> Branch:
    borders: list[Border] = []
    specials: list[Special] = []
    for before, after in pairwise(points):
        its_borders, its_specials = happenings(family, before, after)
        borders += its_borders
        specials += its_specials
    return Branch(
        family.name,
        tuple(point.value for point in points),
        tuple(point.orbit for point in points),
        tuple(borders),
        tuple(specials),
        ended,
    )
