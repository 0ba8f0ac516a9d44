"""Gaits as curves to be followed: fixed points of the return map over one parameter or over two."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator, Mapping, Sequence

import numpy as np

from ..errors import InputError, RunError
from ..given import row_of
from ..library.fixed_point import Closing
from ..library.gait import Gait, check_is_gait
from ..library.members import check_varied
from ..library.quantities import scales_of
from ..library.runner import Runner
from ..library.strides import strides_from
from ..numerics.following import BEYOND, Limits, Point, Problem, walk
from ..numerics.newton import Matrix, Vector
from ..variables.variable import Given, Values

OPPOSITE = -0.5
"""Cosine of the angle by which the way from one half of a gait to the other turns where they swap places."""
ASIDE = 0.25
"""Distance of a solution from the middle between two others, over theirs, that makes it doubtful."""
SHORTEST_WALK = 1e-9
"""Shortest step of a walk along a parameter, over the larger of the values at both ends of the way."""
FARTHEST_WALK = 0.7
"""Largest distance of a gait from its prediction, over its distance from the gait before."""
SAME = 1e-6
"""Gaits as near, over the scales, are of one branch."""


class GaitProblem(Problem):
    """Fixed points of the return map over parameters; unknowns are the apex and the parameters.

    The scales of the parameters are powers of two near their values in the runner, or 1, so that a value
    survives being scaled.
    """

    def __init__(self, runner: Runner | Mapping[str, Given], names: Sequence[str], strides: int = 1) -> None:
        """Gaits of a runner that repeat themselves after some strides, over parameters or inputs by name."""
        self.runner, self.names, self.strides = Runner(runner), tuple(names), strides
        for name in names:
            check_varied(name, "name", self.runner.model)
        self.scales = scales_of(self.runner, names)
        self.scales[-len(names) :] = 2.0 ** np.round(np.log2(self.scales[-len(names) :]))
        self._closings: tuple[bytes, dict[str, Closing]] = b"", {}

    def runner_at(self, x: Vector) -> Runner:
        """The runner at a point."""
        return self.runner.replace(dict(zip(self.names, map(float, self.values(x)), strict=True)))

    def at(self, gait: Gait) -> Vector:
        """Apex and parameters of a gait, over the scales."""
        x: Vector = np.append(gait.apex, [gait.runner[name] for name in self.names]) / self.scales
        return x

    def residual(self, x: Vector) -> Vector:
        """Last apex minus first, over the scales."""
        return self._closing(x).residual(x[: -len(self.names)])

    def linearize(self, x: Vector) -> tuple[Vector, Matrix]:
        """The residual, and its derivatives by apex and parameters."""
        apex = x[: -len(self.names)]
        found = [self._closing(x, name).varied(apex) for name in self.names]
        by_parameters = np.column_stack([by for _, _, by in found]) * self.scales[len(apex) :]
        return found[0][0], np.hstack([found[0][1], by_parameters])

    def by_apex(self, x: Vector) -> tuple[Vector, Matrix]:
        """The residual, and its derivatives by the apex alone, shape (n, n)."""
        residual, by_apex, _ = self._closing(x, self.names[0]).varied(x[: -len(self.names)])
        return residual, by_apex

    def describe(self, x: Vector) -> tuple[Gait, Matrix]:
        """The strides from a point, whether they lead back to it or not, and the derivatives."""
        count = len(self.names)
        gait = strides_from(
            self.runner_at(x), x[:-count] * self.scales[:-count], self.strides, along=self.names[0]
        )
        scales = self.scales[:-count]
        assert gait.by_parameter is not None
        further = [self._closing(x, name).varied(x[:-count])[2] for name in self.names[1:]]
        columns = [gait.by_parameter / scales, *further]
        by_apex = gait.jacobian * scales / scales[:, None] - np.eye(len(scales))
        return gait, np.hstack([by_apex, np.array(columns).T * self.scales[-count:]])

    def start(self, gait: Gait, along: Vector) -> Point:
        """A gait as a point whose tangent goes along a direction."""
        return self.point(self.at(gait), along)

    def word_at(self, x: Vector) -> str:
        """The word of the strides from a point, made as `describe` makes them.

        Plain strides take other steps, and near a border they may have another word.
        """
        return self.describe(x)[0].word

    def look(self, begin: Vector, end: Vector, across: Vector, rows: Matrix) -> tuple[Vector, str]:
        """The solution on planes halfway between two others, and its word.

        `rows` are a Jacobian from nearby. Beside an event that is just touched it may lead to another stretch
        of the curve. So a solution far off the middle is compared with that by the Jacobian there.
        """
        middle, reach = 0.5 * (begin + end), ASIDE * float(np.linalg.norm(end - begin))
        x = self.solution(middle, across, rows)
        if np.linalg.norm(x - middle) > reach:
            with contextlib.suppress(InputError, RunError):
                x = min(
                    x, self.solution(middle, across, None), key=lambda x: float(np.linalg.norm(x - middle))
                )
        return x, self.word_at(x)

    def _closing(self, x: Vector, along: str = "") -> Closing:
        """Equations at the values of the parameters, kept for the last ones."""
        values = x[-len(self.names) :].tobytes()
        if self._closings[0] != values:
            self._closings = values, {}
        known = self._closings[1]
        if along not in known:
            runner = next(iter(known.values())).runner if known else self.runner_at(x)
            known[along] = Closing(runner, self.strides, along or None, self.scales[: -len(self.names)])
        return known[along]


class BranchProblem(GaitProblem):
    """A branch: gaits over one parameter."""

    def __init__(self, runner: Runner | Mapping[str, Given], name: str, strides: int = 1) -> None:
        """Gaits of a runner that repeat themselves after some strides, over a parameter or input."""
        super().__init__(runner, (name,), strides)
        self.doublings: Sequence[float] = ()
        """Period doublings of the branch that these gaits of twice the period left."""

    @property
    def name(self) -> str:
        """Name of the parameter or input."""
        return self.names[0]

    def value(self, point: Point) -> float:
        """The parameter's value at a point, in its unit."""
        return float(self.values(point.x)[0])

    def towards(self, end: float) -> Vector:
        """Direction in which the parameter grows, or falls for a negative number."""
        return np.append(np.zeros(len(self.scales) - 1), end)

    def label(self, known: object) -> object:
        """The word and the events of the strides."""
        assert isinstance(known, Gait)
        return known.sequence

    def visited(self, point: Point) -> Sequence[Vector]:
        """The apexes of all strides of the gait."""
        return [point.x, *(np.append(a / self.scales[:-1], point.x[-1]) for a in point.gait.following)]

    def ends_between(self, before: Point, after: Point) -> str:
        """Text of the period doubling at which the halves of gaits of twice the period swap places.

        From there on the same gaits would be met again, begun by their other half.
        """
        if not self.doublings:
            return ""
        half = self.strides // 2 - 1
        old, new = ((p.gait.following[half] - p.gait.apex) / self.scales[:-1] for p in (before, after))
        if old @ new > OPPOSITE * np.linalg.norm(old) * np.linalg.norm(new):
            return ""
        middle = 0.5 * (self.value(before) + self.value(after))
        return self.at_doubling(min(self.doublings, key=lambda value: abs(value - middle)))

    def at_doubling(self, value: float) -> str:
        """Why a branch of twice the period begins or ends."""
        return f"period doubling at {self.name} = {value:.10g}"

    def at_edge(self, value: float, limits: Limits) -> str:
        """Why the branch ended at an end of the range."""
        return f"back at {self.name} = {value:g}" if value == limits.begin else "end of the range"

    def where_met(self, point: Point, following: Point, number: int) -> str:
        """Why the branch ended at a gait where it has been."""
        where = f"back at the gait at {self.where(point.x)}"
        if number:
            return f"retraced: {where}, begun by another of its strides"
        if point.tangent @ following.tangent > 0.0:
            return f"closed: {where}"
        return f"retraced: {where}, from the other side"

    def lost(self, last: Point, why: Exception) -> str:
        """Why the branch cannot be followed on."""
        where = self.where(last.x)
        if isinstance(why, InputError):
            return f"limit of what is allowed at {where}: {why}"
        try:
            other, _ = self.describe(last.x + BEYOND[0] * last.tangent)
        except (InputError, RunError) as fate:
            return f"the gait is lost at {where}: just beyond, {fate}"
        if other.sequence == last.gait.sequence:
            return f"no convergence at {where}: {why}"
        before, after = last.gait.word, other.word
        words = f"from {before} to {after or 'an empty one'}" if before != after else "of the events"
        return f"the gait is lost at {where}: at the border {words} no gait goes on from it on the other side"


def gaits_over(
    runner: Runner | Mapping[str, Given],
    name: str,
    values: Values,
    first: Gait,
    step_finished: Callable[[], object] = lambda: None,
) -> Iterator[Gait]:
    """The gait at each value, each from the one before; steps in between where values are far apart."""
    check_is_gait(first, "first")
    row = row_of(values, "values", f"a row of values of {name}")
    problem = BranchProblem(runner, name, first.strides)
    point = problem.start(first, problem.towards(1.0))
    for value in row:
        for following in to_value(problem, point, problem.runner.replace({name: value})[name]):
            point = following
        yield point.gait
        step_finished()


def to_value(problem: BranchProblem, point: Point, value: float) -> Iterator[Point]:
    """Points of a branch on the way to a value of its parameter, by steps that are halved where they fail."""

    def advance(known: Point, at: float, to: float) -> Point:
        goal = _predicted(problem, known, to)
        found = problem.correct(goal, problem.towards(1.0), known)
        off, moved = (float(np.linalg.norm((found.x - x)[:-1])) for x in (goal, known.x))
        if off > max(FARTHEST_WALK * moved, SAME):
            raise RunError(f"the branch ends near {problem.where(known.x)}")
        if not problem.reaches(_predicted(problem, found, at), problem.towards(1.0), known.x, found):
            raise RunError(
                f"the branch ends near {problem.where(known.x)}: none leads back to it from {to:g}"
            )
        return found

    begin = problem.value(point)
    for _, found in walk(point, begin, value, advance, shortest=SHORTEST_WALK * max(abs(begin), abs(value))):
        yield found


def _predicted(problem: BranchProblem, point: Point, value: float) -> Vector:
    """Unknowns at a value of the parameter, along the branch's tangent."""
    if point.tangent[-1] == 0.0:
        raise RunError(f"the branch turns at {problem.where(point.x)}")
    x = value / problem.scales[-1]
    goal: Vector = point.x + (x - point.x[-1]) / point.tangent[-1] * point.tangent
    goal[-1] = x
    return goal
