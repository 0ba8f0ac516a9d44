"""Gaits at values of a parameter in turn, each from the one before, predicted along the branch's tangent."""

from collections.abc import Callable, Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from ..given import row_of
from ..library.gait import Gait, check_is_gait
from ..library.runner import Runner
from ..numerics.halving import walk as steps_to
from ..variables.variable import Given, Values
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
    first: Gait,
    step_finished: Callable[[], None] = lambda: None,
) -> Iterator[Gait]:
    """The gait at each value, each from the one before; steps in between where values are far apart."""
    check_is_gait(first, "first")
    row = row_of(values, "values", f"a row of values of {name}")
    family = Family(runner, name, first.strides)
    at = family.value_of(first)
    gait = first if first.along == name else family.gait(at, first.apex)
    for value in row:
        for part in walk(family, gait, at, family.runner.replace({name: value})[name]):
            gait, at = part, family.value_of(part)
        yield gait
        step_finished()


def walk(family: Family, gait: Gait, at: float, to: float, shortest: float = SHORTEST) -> Iterator[Gait]:
    """Gaits from one value to another, by predictions along the branch, shorter where they fail."""
    if at == to:
        yield family.gait(to, gait.apex)
        return

    def advance(gait: Gait, at: float, value: float) -> Gait:
        nearby = _predicted(family, gait, value - at)
        following = family.gait(value, nearby, gait)
        _check_near(family, gait, nearby, following)
        _check_leads_back(family, gait, following)
        return following

    smallest = shortest * max(abs(at), abs(to))
    for _, following in steps_to(gait, at, to, advance, shortest=smallest):
        yield following


def _predicted(family: Family, gait: Gait, step: float) -> NDArray[np.float64]:
    """The apex at a parameter a little away, along the branch's tangent."""
    assert gait.by_parameter is not None
    try:
        tangent = np.linalg.solve(np.eye(len(gait.apex)) - gait.jacobian, gait.by_parameter)
    except np.linalg.LinAlgError:
        raise RunError(f"the branch turns at {family.name} = {family.value_of(gait):g}") from None
    return gait.apex + step * tangent


def _check_near(family: Family, before: Gait, nearby: NDArray[np.float64], after: Gait) -> None:
    """Refuse a gait that is of another branch: as far from where it was predicted as from the one before."""
    scales = family.scales[:-1]
    off, moved = (float(np.linalg.norm((after.apex - apex) / scales)) for apex in (nearby, before.apex))
    if off > max(FARTHEST * moved, SAME):
        raise RunError(f"the branch ends near {family.name} = {family.value_of(before):g}")


def _check_leads_back(family: Family, before: Gait, after: Gait) -> None:
    """Refuse a gait from which the branch does not lead back to the one before: it is of another branch."""
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
    if not reaches(family, goal, across, known, begin, family.rows(after)):
        raise RunError(f"the branch ends near {family.name} = {at:g}: none leads back to it from {to:g}")
