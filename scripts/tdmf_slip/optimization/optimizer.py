"""Searches from several starts, of which the best counts; and what is told where none meets a goal."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from ..analysis.settled import evenly
from ..analysis.targeted import TargetNotMetError
from ..errors import RunError
from ..library.gait import Gait
from ..library.runner import Runner
from ..numerics.following import halved
from ..terminal.progress import Bar
from .gaits import Candidate, Gaits
from .optimum import FOLD, STABILITY, Optimum, reported
from .problem import OFF_FOLD, Feasibility, Goal, Problem
from .search import Found, Search
from .space import Space
from .starts import Spread, Start

ROUGHLY = 1e-4
"""Violation of constraints from which SLSQP is left to meet them."""
NEARLY = 1e-2
"""The same where the search for them has ended: its square is so flat there that it ends early."""
FEASIBLE = 1e-7
"""Violation of constraints, over their scales, that is rounding."""
ACTIVE = 1e-5
"""Of an eigenvalue: as near to its limit, it is at it."""
NATURAL = 1e-2
"""Least scale of a quantity, over that of its dimension: of one that is zero, or all but."""
APART = 1e-2
"""Over the width of the bounds, and of apices over the scales: optima as near are one."""
TRIES = 4
"""Shares of the way to a start that are tried: all, a half, and so on."""


@dataclass(frozen=True, eq=False)
class Best:
    """The best of several searches."""

    found: Found
    """Where it ended."""
    starts: int
    """How many searches were made."""
    basins: int
    """At how many different optima they ended."""

    @property
    def start(self) -> Start:
        """As a start for other searches."""
        return Start(self.found.gait.at, self.found.gait.gait)


class Optimizer:
    """Optima of one runner over some parameters."""

    def __init__(self, before: Gait, space: Space, starts: int) -> None:
        """The gait of the runner as it is given; where the searches begin, and how many."""
        self.before, self.space = before, space
        gaits = Gaits(before.runner, space, ["speed"])
        given = Start(space.coordinates_of(before.runner), before)
        first = _reached(gaits, given, np.clip(given.at, 0.0, 1.0), 1)
        if first is None:
            raise RunError(
                f"no gait within the bounds of {', '.join(space.bounds)} is reached from the runner's own; "
                "allowed: bounds nearer to its values"
            )
        self.first, self.count, self._gaits_of = first, starts, gaits

    @cached_property
    def spread(self) -> Spread:
        """Gaits all over the bounds."""
        return Spread(self.first, self.space)

    def starts(self, problem: Problem) -> list[Start]:
        """Where the searches for a problem begin: at the runner's own gait, and where it promises most.

        Where too few runners settle, from points that are reached along the gaits from the first.
        """
        more = self.count - 1
        if not more:
            return [self.first]
        found = list(islice(self.spread.starts(problem, self.first), more))
        if not found:
            points = evenly(more, len(self.space.bounds))
            reached = (_reached(self._gaits_of, self.first, point, TRIES) for point in points)
            found = [start for start in reached if start is not None]
        return [self.first, *found]

    def scales(self, goal: Goal) -> dict[str, float]:
        """Of a goal's quantities: their sizes at the first start, or what is prescribed."""
        gait = self.first.gait
        length, _, _, _, speed, rate = _natural(gait)
        natural = {"speed": speed, "frequency": rate, "stance_time": 1.0 / rate}
        natural |= {"length": length, "slip_distance": length}
        values = reported(gait)
        return {
            name: max(abs(goal.at.get(name, values[name])), NATURAL * natural.get(name, 1.0))
            for name in goal.names
        }

    def candidate(self, goal: Goal) -> Candidate:
        """The first start, with its gradients."""
        return self._gaits(goal).candidate(self.first.gait, self.first.at)

    def best(self, goal: Goal, bar: Bar, starts: Sequence[Start] = ()) -> "Best":
        """Of all searches, the best gait that meets the constraints."""
        problem = Problem(goal, self.scales(goal))
        found, begun, trouble = [], starts or self.starts(problem), ""
        for start in begun:
            try:
                found.append(self._searched(problem, start))
            except RunError as lost:
                trouble = str(lost)
            bar.update()
        bar.update(0 if starts else self.count - len(begun))
        if not found:
            raise RunError(trouble)
        allowed = [one for one in found if problem.violation(one.gait) <= FEASIBLE]
        if not allowed:
            raise self._not_met(goal, min(found, key=lambda one: problem.violation(one.gait)))
        best = min(allowed, key=lambda one: problem.objective(one.gait)[0])
        return Best(best, len(begun), _basins(allowed))

    def _searched(self, problem: Problem, start: Start) -> Found:
        """From one start; where it is far from meeting the constraints, first to where they are met."""
        if problem.violation(self._gaits(problem.goal).candidate(start.gait, start.at)) > ROUGHLY:
            nearest = self._off_folds(Feasibility(problem.goal, problem.scales), start)
            if problem.violation(nearest.gait) > NEARLY:
                return nearest
            start = Start(nearest.gait.at, nearest.gait.gait)
        return self._off_folds(problem, start)

    def _off_folds(self, problem: Problem, start: Start) -> Found:
        """From one start; once more, and kept off folds, where gaits were lost."""
        found = self._search(problem, start)
        if not found.why or problem.goal.fold:
            return found
        kept_off = type(problem)(replace(problem.goal, fold=True), problem.scales)
        return self._search(kept_off, Start(found.gait.at, found.gait.gait))

    def _search(self, problem: Problem, start: Start) -> Found:
        gaits = self._gaits(problem.goal)
        return Search(gaits, problem).run(gaits.candidate(start.gait, start.at))

    def _gaits(self, goal: Goal) -> Gaits:
        return Gaits(self.before.runner, self.space, goal.names, goal.with_spectrum, goal.radius)

    def _not_met(self, goal: Goal, found: Found) -> TargetNotMetError:
        wanted = [f"{name} {value:.6g}" for name, value in goal.at.items()]
        wanted += [
            f"{name} of {limit:.6g} at the {'most' if sign > 0.0 else 'least'}"
            for name, (sign, limit) in goal.upper_limits.items()
        ]
        wanted += [f"a spectral radius of {goal.radius:g} at the most"] if goal.radius is not None else []
        values = reported(found.gait.gait)
        end = f"; the search ended there: {found.why}" if found.why else ""
        names = [*goal.at, *goal.upper_limits, *(["lambda_max"] if goal.radius is not None else [])]
        has = ", ".join(f"{name} {values[name]:.6g}" for name in names)
        at = ", ".join(f"{name} = {value:.6g}" for name, value in self.space.values(found.gait.at).items())
        return TargetNotMetError(
            f"no gait with {' and '.join(wanted)} was found within the bounds: the nearest has {has}, "
            f"at {at}{end}",
            found.gait.gait,
            (),
        )

    def optimum(self, goal: Goal, best: "Best") -> Optimum:
        """As it is told of."""
        found, limits = best.found, []
        spectrum = found.gait.spectrum
        if goal.radius is not None and goal.radius - spectrum.sizes[0] <= ACTIVE:
            limits.append(STABILITY)
        if spectrum.fold <= OFF_FOLD * (1.0 + ACTIVE):
            limits.append(FOLD)
        return Optimum(
            objective=goal.objective,
            is_minimum=goal.sign > 0.0,
            parameters={name: found.gait.gait.runner[name] for name in self.space.bounds},
            gait=found.gait.gait,
            before=self.before,
            active_bounds=self.space.active(found.gait.at),
            limits=tuple(limits),
            remaining_improvement=found.remaining_improvement,
            why=found.why,
            starts=best.starts,
            basins=best.basins,
        )


def _basins(found: Sequence[Found]) -> int:
    """How many different optima there are among gaits that searches ended at."""
    different: list[Candidate] = []
    for gait in (one.gait for one in found if not one.why):
        scales = gait.gait.runner.scales
        if not any(
            np.linalg.norm(gait.at - other.at) < APART
            and np.linalg.norm((gait.gait.apex - other.gait.apex) / scales) < APART
            for other in different
        ):
            different.append(gait)
    return len(different)


def _natural(gait: Gait) -> NDArray[np.float64]:
    """Scales of the six coordinates, whatever the runner's model."""
    return Runner(gait, model="full").scales


def _reached(gaits: Gaits, begin: Start, point: NDArray[np.float64], tries: int) -> Start | None:
    """The gait at a point or, where the branch does not lead so far, on the way there."""
    try:
        first = gaits.candidate(begin.gait, begin.at)
    except RunError:
        return None

    def attempt(share: float) -> Start:
        at = begin.at + share * (point - begin.at)
        return Start(at, gaits.gait_from(first, at))

    try:
        return halved(attempt, 1.0, 0.5 ** (tries - 1))[0]
    except RunError:
        return None
