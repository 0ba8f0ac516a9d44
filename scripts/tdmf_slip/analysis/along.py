"""Gaits along a parameter: a branch followed at given values."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import pairwise

import numpy as np

from ..errors import RunError
from ..given import row_of
from ..library.gait import Gait, check_is_gait
from ..library.runner import Runner
from ..numerics.following import SHORTEST_STEP, Limits, Point, follow
from ..variables.variable import Given, Values
from .gait_problem import BranchProblem
from .special_points import FOLD, special_points

MAX_STEP = 0.2
"""Longest step over the scales; a longer way to the next value is tried in one step."""
MAX_POINTS = 200
"""Largest number of gaits between two values."""


def gaits_over(
    runner: Runner | Mapping[str, Given], name: str, values: Values, first: Gait
) -> Iterator[Gait]:
    """The gait at each value, each from the one before, by steps along the branch where they are far apart.

    Raises RunError at a value to which the branch does not lead; the message says where and why it ends.
    """
    check_is_gait(first, "first")
    row = row_of(values, "values", f"a row of values of {name}")
    problem = BranchProblem(runner, name, first.strides)
    checked = (problem.runner.replace({name: value})[name] for value in row)
    for point in points_over(problem, problem.start(first, problem.towards(1.0)), checked):
        yield point.gait


def points_over(problem: BranchProblem, point: Point, values: Iterable[float]) -> Iterator[Point]:
    """The branch's point at each value, each from the one before; raises as `gaits_over` does."""
    for value in values:
        point = to_value(problem, point, value)
        yield point


def to_value(problem: BranchProblem, point: Point, value: float) -> Point:
    """The point of a branch at a value of its parameter. The first step tried is the whole way."""
    at = problem.value(point)
    if abs(value - at) <= SHORTEST_STEP * problem.scales[-1]:
        return _beside(problem, point, value)
    back = 2.0 * at - value
    limits = Limits(
        np.array([min(value, back)]),
        np.array([max(value, back)]),
        max(MAX_STEP, 2.0 * abs(value - at) / problem.scales[-1]),
        MAX_POINTS,
        begin=back,
        parts=1.0,
        first_step=np.inf,
    )
    points, ended = follow(problem, point.along(problem.towards(value - at)), 1.0, limits)
    fold = _fold(problem, points)
    if fold is not None:
        raise RunError(f"the branch ends in a fold at {problem.name} = {fold:.10g}")
    if problem.value(points[-1]) != value:
        raise RunError(f"the branch ends at {problem.name} = {problem.value(points[-1]):.10g}: {ended}")
    return points[-1]


def _beside(problem: BranchProblem, point: Point, value: float) -> Point:
    """The point at a value that is nearer than the shortest step, such as one that differs by rounding."""
    if problem.value(point) == value:
        return point
    goal = point.x.copy()
    goal[-1] = value / problem.scales[-1]
    found = problem.correct(goal, problem.towards(1.0), point)
    if np.linalg.norm(found.x - point.x) > np.sqrt(SHORTEST_STEP):
        raise RunError(f"the branch ends at {problem.where(point.x)}")
    return found


def _fold(problem: BranchProblem, points: list[Point]) -> float | None:
    """Value of the parameter at which the branch turns back first."""
    for before, after in pairwise(points):
        if before.rises != after.rises:
            folds = [one.value for one in special_points(problem, before, after) if one.kind == FOLD]
            return folds[0] if folds else 0.5 * (problem.value(before) + problem.value(after))
    return None
