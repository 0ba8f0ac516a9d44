"""Equations of gaits over parameters: to be solved for prescribed quantities, or followed as curves."""

from __future__ import annotations

import contextlib
import copy
from collections.abc import Mapping, Sequence

import numpy as np

from ..errors import InputError, RunError
from ..library.fixed_point import Closing, gait_near, scaled_less_one
from ..library.gait import Gait
from ..library.members import check_varied
from ..library.quantities import scales_of
from ..library.runner import Runner
from ..library.strides import BETWEEN_WORDS, MadeStride, plain_stride, strides_from, varied_stride
from ..numerics.following import BEYOND, Limits, Point, Problem
from ..numerics.newton import Matrix, Vector
from ..variables.variable import Given

OPPOSITE = -0.5
"""Cosine of the angle by which the way between the halves of a gait turns where they swap places."""
ASIDE = 0.25
"""Distance of a solution from the middle between two others, over their distance, that makes it doubtful."""
COARSE, BORDER_ACCURACY = 1e-10, 1e-11
"""Lengths of branch, over the scales, within which a border is located: first by the words of plain strides,
which may be others right beside it, then by those of strides with derivatives."""
MAX_HALVINGS = 100


class GaitProblem(Problem):
    """Gaits over parameters, with or without prescribed quantities.

    The unknowns are the apex and the parameters. The equations make the last apex the first one, and each
    quantity as prescribed, all over their scales. With prescribed quantities the scales of the parameters
    are their values in the runner. Otherwise they are powers of two near these values, because scaling by a
    power of two is exact.
    """

    def __init__(
        self,
        runner: Runner | Mapping[str, Given],
        names: Sequence[str],
        strides: int = 1,
        prescribed: Mapping[str, float] | None = None,
    ) -> None:
        """Gaits of a runner that repeat themselves after some strides, over parameters or inputs by name.

        Gaits with prescribed quantities take one stride.
        """
        self.runner, self.names, self.strides = Runner(runner), tuple(names), strides
        for name in names:
            check_varied(name, "name", self.runner.model)
        self.quantities = tuple(prescribed or ())
        self.goal = np.array([*(prescribed or {}).values()])
        self.quantity_scales = np.array([abs(value) or 1.0 for value in self.goal])
        self.scales = scales_of(self.runner, names)
        if not self.quantities:
            self.scales[-len(names) :] = 2.0 ** np.round(np.log2(self.scales[-len(names) :]))
        self._closings: tuple[bytes, dict[str, Closing]] = b"", {}

    @property
    def count(self) -> int:
        """Number of the coordinates of an apex."""
        return len(self.scales) - len(self.names)

    def with_goal(self, goal: Vector | None) -> GaitProblem:
        """The same gaits with other values prescribed, or with none."""
        other = copy.copy(self)
        if goal is None:
            other.quantities, goal, other.quantity_scales = (), self.goal[:0], self.goal[:0]
        other.goal = goal
        return other

    def runner_at(self, x: Vector) -> Runner:
        """The runner at a point."""
        return self.runner.replace(dict(zip(self.names, map(float, self.values(x)), strict=True)))

    def apex_at(self, x: Vector) -> Vector:
        """The apex at a point."""
        apex: Vector = x[: self.count] * self.scales[: self.count]
        return apex

    def at(self, gait: Gait) -> Vector:
        """Apex and parameters of a gait, over the scales."""
        x: Vector = np.append(gait.apex, [gait.runner[name] for name in self.names]) / self.scales
        return x

    def residual(self, x: Vector) -> Vector:
        """Last apex minus first, then deviations of the quantities, over the scales."""
        if not self.quantities:
            return self._closing(x).residual(x[: self.count])
        return self._residual_of(plain_stride(self.runner_at(x), self.apex_at(x), self.quantities))

    def linearize(self, x: Vector) -> tuple[Vector, Matrix]:
        """The residual, and its derivatives by apex and parameters."""
        if self.quantities:
            stride = varied_stride(self.runner_at(x), self.apex_at(x), self.quantities, self.names)
            scales = np.append(self.scales[: self.count], self.quantity_scales)
            return self._residual_of(stride), stride.by_all * self.scales / scales[:, None]
        apex = x[: self.count]
        found = [self._closing(x, name).varied(apex) for name in self.names]
        by_parameters = np.column_stack([by for _, _, by in found]) * self.scales[self.count :]
        return found[0][0], np.hstack([found[0][1], by_parameters])

    def _residual_of(self, stride: MadeStride) -> Vector:
        off = (stride.quantities - self.goal) / self.quantity_scales
        return np.append(stride.residual / self.scales[: self.count], off)

    def by_apex(self, x: Vector) -> tuple[Vector, Matrix]:
        """The residual, and its derivatives by the apex alone, shape (n, n)."""
        residual, by_apex, _ = self._closing(x).varied(x[: self.count])
        return residual, by_apex

    def gait_at(self, x: Vector) -> Gait:
        """The gait found from a point near it."""
        return gait_near(self.runner_at(x), self.apex_at(x))

    def describe(self, x: Vector) -> tuple[Gait, Matrix]:
        """The strides from a point, whether they lead back to it or not, and the derivatives."""
        runner, scales = self._closing(x).runner, self.scales[: self.count]
        gait = strides_from(runner, self.apex_at(x), self.strides, along=self.names[0])
        assert gait.by_parameter is not None
        further = [self._closing(x, name).varied(x[: self.count])[2] for name in self.names[1:]]
        columns = [gait.by_parameter / scales, *further]
        by_apex = scaled_less_one(gait.jacobian, scales)
        return gait, np.hstack([by_apex, np.array(columns).T * self.scales[self.count :]])

    def start(self, gait: Gait, along: Vector) -> Point:
        """A gait as a point whose tangent goes along a direction."""
        return self.point(self.at(gait), along)

    def word_at(self, x: Vector, varied: bool = True) -> str:
        """The word of the strides from a point, made with derivatives as those of `describe`, or plain.

        Plain strides take other steps, and right beside a border they may have another word.
        """
        closing, apex = self._closing(x), self.apex_at(x)
        words: list[str] = []
        for _ in range(self.strides):
            stride = closing.stride(apex, varied)
            apex, words = stride.next_points[0], [*words, str(stride.words[0])]
        return BETWEEN_WORDS.join(words)

    def border(
        self, inside: Vector, outside: Vector, word: str, rows: Matrix, across: Vector | None = None
    ) -> tuple[Vector, Vector]:
        """Solutions on both sides of a word border, between one with the word and one with another.

        `rows` are a Jacobian from nearby. Over two parameters the solutions are on the plane `across`.
        """
        normal = (outside - inside) / np.linalg.norm(outside - inside)
        planes = normal if across is None else np.array([across, normal])

        def bisected(inside: Vector, outside: Vector, width: float, varied: bool) -> tuple[Vector, Vector]:
            for _ in range(MAX_HALVINGS):
                if (outside - inside) @ normal <= width:
                    break
                x = self._between_on(inside, outside, planes, rows)
                inside, outside = (x, outside) if self.word_at(x, varied) == word else (inside, x)
            return inside, outside

        near = bisected(inside, outside, COARSE, False)
        if not self.word_at(near[0]) == word != self.word_at(near[1]):
            near = inside, outside
        return bisected(*near, BORDER_ACCURACY, True)

    def _between_on(self, begin: Vector, end: Vector, across: Vector, rows: Matrix) -> Vector:
        """The solution on planes halfway between two others.

        Beside an event that is just touched the Jacobian from nearby may lead to another stretch of the
        curve. So a solution far off the middle is compared with that by the Jacobian there.
        """
        middle, reach = 0.5 * (begin + end), ASIDE * float(np.linalg.norm(end - begin))
        x = self.solution(middle, across, rows)
        if np.linalg.norm(x - middle) > reach:
            with contextlib.suppress(InputError, RunError):
                x = min(
                    x, self.solution(middle, across, None), key=lambda x: float(np.linalg.norm(x - middle))
                )
        return x

    def _closing(self, x: Vector, along: str | None = None) -> Closing:
        """Equations at the values of the parameters; those at the last values are kept."""
        along = along or self.names[0]
        values = x[-len(self.names) :].tobytes()
        if self._closings[0] != values:
            self._closings = values, {}
        known = self._closings[1]
        if along not in known:
            runner = next(iter(known.values())).runner if known else self.runner_at(x)
            known[along] = Closing(runner, self.strides, along, self.scales[: self.count])
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
        """Reason why a branch of twice the period begins or ends."""
        return f"period doubling at {self.name} = {value:.10g}"

    def at_edge(self, value: float, limits: Limits) -> str:
        """Reason why the branch ended at an end of the range."""
        return f"back at {self.name} = {value:g}" if value == limits.begin else "end of the range"

    def where_met(self, point: Point, following: Point, number: int) -> str:
        """Reason why the branch ended at a gait where it has been."""
        where = f"back at the gait at {self.where(point.x)}"
        if number:
            return f"retraced: {where}, begun by another of its strides"
        if point.tangent @ following.tangent > 0.0:
            return f"closed: {where}"
        return f"retraced: {where}, from the other side"

    def lost(self, last: Point, why: Exception) -> str:
        """Reason why the branch cannot be followed on."""
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
