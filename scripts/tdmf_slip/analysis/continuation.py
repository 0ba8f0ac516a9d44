"""Gaits at values of a parameter in turn, each from the one before, predicted along the branch's tangent."""

from collections.abc import Callable, Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from ..given import row_of
from ..library.orbit import Orbit, check_orbit
from ..library.runner import Runner
from ..unit.variable import Given, Values
from .family import Family
from .walking_back import reaches

SHORTEST = 1e-9
"""Of steps, over the larger of the values at both ends of the way."""
FARTHEST = 0.7
"""How far a gait may be from where it was predicted, over how far it is from the one before."""
SAME = 1e-6
"""Over the scales: gaits as near are of one branch."""


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
    check_orbit(first, "first")
    row = row_of(values, "values", f"a row of values of {name}")
    family = Family(runner, name, first.strides)
    at = family.value_of(first)
    orbit = first if first.along == name else family.orbit(at, first.apex)
    for value in row:
        for part in walk(family, orbit, at, family.runner.but(name, value).values[name]):
            orbit, at = part, family.value_of(part)
        yield orbit
        step_finished()


def walk(family: Family, orbit: Orbit, at: float, to: float, shortest: float = SHORTEST) -> Iterator[Orbit]:
    """Gaits from one value to another, by predictions along the branch, shorter where they fail.

    Parameters
    ----------
    family : Family
        Whose gaits.
    orbit : Orbit
        The first one, differentiated by the family's parameter.
    at : float
        Its value.
    to : float
        The last value.
    shortest : float, default 1e-9
        Of steps, over the larger of the two values.

    Yields
    ------
    Orbit
        On the way; the last one is at the last value.

    Raises
    ------
    RunError
        The branch cannot be followed so far.
    """
    step = to - at
    if step == 0.0:
        yield family.orbit(to, orbit.apex)
        return
    smallest = shortest * max(abs(at), abs(to))
    while at != to:
        step = np.clip(step, -abs(to - at), abs(to - at))
        value = to if abs(to - at - step) < smallest else at + step
        try:
            nearby = _predicted(family, orbit, value - at)
            following = family.orbit(value, nearby)
            _check_near(family, orbit, nearby, following)
            _check_leads_back(family, orbit, following)
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


def _check_near(family: Family, before: Orbit, nearby: NDArray[np.float64], after: Orbit) -> None:
    """Refuse a gait that is of another branch: as far from where it was predicted as from the one before.

    Raises
    ------
    RunError
        It is.
    """
    scales = family.scales[:-1]
    off, moved = (float(np.linalg.norm((after.apex - apex) / scales)) for apex in (nearby, before.apex))
    if off > max(FARTHEST * moved, SAME):
        raise RunError(f"the branch ends near {family.name} = {family.value_of(before):g}")


def _check_leads_back(family: Family, before: Orbit, after: Orbit) -> None:
    """Refuse a gait from which the branch does not lead back to the one before: it is of another branch.

    Raises
    ------
    RunError
        It does not.
    """
    at, to = family.value_of(before), family.value_of(after)
    known, begin, goal = (
        np.append(apex, value) / family.scales
        for apex, value in (
            (before.apex, at),
            (after.apex, to),
            (_predicted(family, after, at - to), at),
        )
    )
    across = np.eye(len(known))[-1]
    if not reaches(family, goal, across, known, float(np.linalg.norm(begin - known))):
        raise RunError(f"the branch ends near {family.name} = {at:g}: none leads back to it from {to:g}")
