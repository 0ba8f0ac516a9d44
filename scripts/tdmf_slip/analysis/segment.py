"""Gaits at values of a parameter in turn, as far as their branch goes along it, and what ends it there."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..errors import InputError, RunError
from ..library.gait import Gait
from ..library.runner import Runner
from ..variables.variable import Values
from .bifurcations import FOLD, special_points
from .continuation import gaits_over
from .family import Family, Point
from .steps import Limits, follow

LARGEST_STEP = 0.2
MAX_POINTS = 200
"""Of a branch that is followed to learn why it ends, from the last gait on."""


@dataclass(frozen=True)
class Segment:
    """Of a range, values whose gaits are of one branch."""

    begin: int
    """Number of the first value."""
    end: int
    """Number after that of the last."""
    began: str
    """Why the branch has no gait at the value before; empty at the beginning of the range."""
    ended: str
    """Why it has none at the next; empty at the end of the range."""

    def as_json(self, values: Sequence[float]) -> dict[str, object]:
        """As a plain object; the values are those of the range."""
        ends = {"from": values[self.begin], "to": values[self.end - 1]}
        return {**ends, "began": self.began or None, "ended": self.ended or None}


def followed(
    runner: Runner,
    name: str,
    values: Values,
    first: Gait,
    step_finished: Callable[[], None] = lambda: None,
) -> tuple[list[Gait], list[str]]:
    """Gaits at values in turn from one on, as far as the branch could be followed, and what stopped it."""
    found: list[Gait] = []
    while len(found) < len(values):
        last = found[-1] if found else first
        try:
            for gait in gaits_over(runner, name, values[len(found) :], last):
                found.append(gait)
                step_finished()
        except RunError as problem:
            last = found[-1] if found else first
            reached, why = _beyond(Family(runner, name), last, float(values[len(found)]))
            if reached is None:
                return found, [why or str(problem)]
            found.append(reached)
            step_finished()
    return found, []


def _beyond(family: Family, last: Gait, value: float) -> tuple[Gait | None, str]:
    """The gait at a value where the branch leads there, by steps along it; else why it does not."""
    at = family.value_of(last)
    back = 2.0 * at - value
    limits = Limits(min(value, back), max(value, back), back, LARGEST_STEP, MAX_POINTS)
    try:
        first = family.point(last, np.append(np.zeros(len(last.apex)), value - at))
        points, ended = follow(family, first, limits)
    except (InputError, RunError):
        return None, ""
    fold = _fold(family, points)
    if fold is not None:
        return None, f"the branch ends in a fold at {family.name} = {fold:.10g}"
    if points[-1].value == value:
        return points[-1].gait, ""
    return None, f"the branch ends at {family.name} = {points[-1].value:.10g}: {ended}"


def _fold(family: Family, points: Sequence[Point]) -> float | None:
    """Where the parameter turns back first."""
    for before, after in pairwise(points):
        if before.rises != after.rises:
            folds = [
                special.value for special in special_points(family, before, after)[1] if special.kind == FOLD
            ]
            return folds[0] if folds else 0.5 * (before.value + after.value)
    return None
