"""Searches from several starts, of which the best counts; and what is told where none meets a goal."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..analysis.ordered import OrderNotMetError
from ..contents import ByContents
from ..errors import RunError
from ..library.orbit import Orbit
from ..terminal.progress import Bar
from .gaits import Candidate, Gaits
from .optimum import FOLD, STABILITY, Optimum, told
from .problem import OFF_FOLD, Feasibility, Goal, Problem
from .search import Found, Search
from .space import Space

ROUGHLY = 1e-4
"""Violation of constraints from which SLSQP is left to meet them."""
FEASIBLE = 1e-7
"""Violation of constraints, over their scales, that is rounding."""
ACTIVE = 1e-5
"""Of an eigenvalue: as near to its limit, it is at it."""
NATURAL = 1e-2
"""Least scale of a quantity, over that of its dimension: of one that is zero, or all but."""
TRIES = 4
"""Shares of the way to a start that are tried: all, a half, and so on."""


@dataclass(frozen=True, eq=False)
class Start(ByContents):
    """A gait where a search begins."""

    at: NDArray[np.float64]
    """Where it is, inside the bounds from 0 to 1."""
    orbit: Orbit
    """The gait."""


class Optimizer:
    """Optima of one runner over some parameters."""

    def __init__(self, before: Orbit, space: Space, starts: int) -> None:
        """The gait of the runner as it is given; where the searches begin, and how many.

        Raises
        ------
        RunError
            No gait within the bounds is reached from the one given.
        """
        self.before, self.space = before, space
        gaits = Gaits(before.runner, space, ["speed"])
        given = Start(space.place_of(before.runner), before)
        first = _reached(gaits, given, np.clip(given.at, 0.0, 1.0), 1)
        if first is None:
            raise RunError(
                f"no gait within the bounds of {', '.join(space.bounds)} is reached from the runner's own; "
                "allowed: bounds nearer to its values"
            )
        places = _spread(starts - 1, len(space.bounds))
        others = (_reached(gaits, first, place, TRIES) for place in places)
        self.starts = [first, *(start for start in others if start is not None)]

    def scales(self, goal: Goal) -> dict[str, float]:
        """Of a goal's quantities: their sizes at the first start, or what is prescribed."""
        orbit = self.starts[0].orbit
        length, _, _, _, speed, rate = _natural(orbit)
        natural = {"speed": speed, "frequency": rate, "stance_time": 1.0 / rate}
        natural |= {"length": length, "slip_distance": length}
        values = told(orbit)
        return {
            name: max(abs(goal.at.get(name, values[name])), NATURAL * natural.get(name, 1.0))
            for name in goal.names
        }

    def candidate(self, goal: Goal) -> Candidate:
        """The first start, with its gradients."""
        return self._gaits(goal).candidate(self.starts[0].orbit, self.starts[0].at)

    def best(self, goal: Goal, bar: Bar, starts: Sequence[Start] = ()) -> tuple[Found, Start]:
        """Of all searches, the best gait that meets the constraints; it is a start for others, too.

        Raises
        ------
        OrderNotMetError
            None does.
        """
        problem = Problem(goal, self.scales(goal))
        found = []
        for start in starts or self.starts:
            found.append(self._searched(problem, start))
            bar.update()
        allowed = [one for one in found if problem.violation(one.gait) <= FEASIBLE]
        if not allowed:
            raise self._not_met(goal, min(found, key=lambda one: problem.violation(one.gait)))
        best = min(allowed, key=lambda one: problem.objective(one.gait)[0])
        return best, Start(best.gait.at, best.gait.orbit)

    def _searched(self, problem: Problem, start: Start) -> Found:
        """From one start; where it is far from meeting the constraints, first to where they are met."""
        if problem.violation(self._gaits(problem.goal).candidate(start.orbit, start.at)) > ROUGHLY:
            nearest = self._off_folds(Feasibility(problem.goal, problem.scales), start)
            if problem.violation(nearest.gait) > ROUGHLY:
                return nearest
            start = Start(nearest.gait.at, nearest.gait.orbit)
        return self._off_folds(problem, start)

    def _off_folds(self, problem: Problem, start: Start) -> Found:
        """From one start; once more, and kept off folds, where gaits were lost."""
        found = self._search(problem, start)
        if not found.why or problem.goal.fold:
            return found
        kept_off = type(problem)(replace(problem.goal, fold=True), problem.scales)
        return self._search(kept_off, Start(found.gait.at, found.gait.orbit))

    def _search(self, problem: Problem, start: Start) -> Found:
        gaits = self._gaits(problem.goal)
        return Search(gaits, problem).run(gaits.candidate(start.orbit, start.at))

    def _gaits(self, goal: Goal) -> Gaits:
        return Gaits(self.before.runner, self.space, goal.names, goal.with_spectrum)

    def _not_met(self, goal: Goal, found: Found) -> OrderNotMetError:
        wanted = [f"{name} {value:.6g}" for name, value in goal.at.items()]
        wanted += [
            f"{name} of {limit:.6g} at the {'most' if sign > 0.0 else 'least'}"
            for name, (sign, limit) in goal.at_most.items()
        ]
        wanted += [f"a spectral radius of {goal.radius:g} at the most"] if goal.radius is not None else []
        values = told(found.gait.orbit)
        end = f"; the search ended there: {found.why}" if found.why else ""
        names = [*goal.at, *goal.at_most, *(["lambda_max"] if goal.radius is not None else [])]
        has = ", ".join(f"{name} {values[name]:.6g}" for name in names)
        at = ", ".join(f"{name} = {value:.6g}" for name, value in self.space.values(found.gait.at).items())
        return OrderNotMetError(
            f"no gait with {' and '.join(wanted)} was found within the bounds: the nearest has {has}, "
            f"at {at}{end}",
            found.gait.orbit,
            (),
        )

    def optimum(self, goal: Goal, found: Found) -> Optimum:
        """As it is told of."""
        spectrum, limits = found.gait.spectrum, []
        if goal.radius is not None and goal.radius - spectrum.sizes[0] <= ACTIVE:
            limits.append(STABILITY)
        if spectrum.fold <= OFF_FOLD * (1.0 + ACTIVE):
            limits.append(FOLD)
        return Optimum(
            objective=goal.objective,
            is_least=goal.sign > 0.0,
            parameters={name: found.gait.orbit.runner.values[name] for name in self.space.bounds},
            gait=found.gait.orbit,
            before=self.before,
            active_bounds=self.space.active(found.gait.at),
            limits=tuple(limits),
            falls=found.falls,
            why=found.why,
            starts=len(self.starts),
        )


def _natural(orbit: Orbit) -> NDArray[np.float64]:
    """Scales of the six coordinates, whatever the runner's model."""
    return replace(orbit.runner, reduced=False).scales


def _reached(gaits: Gaits, begin: Start, place: NDArray[np.float64], tries: int) -> Start | None:
    """The gait at a place or, where the branch does not lead so far, on the way there."""
    try:
        first = gaits.candidate(begin.orbit, begin.at)
    except RunError:
        return None
    for number in range(tries):
        at = begin.at + 0.5**number * (place - begin.at)
        try:
            return Start(at, gaits.orbit_from(first, at))
        except RunError:
            continue
    return None


def _spread(count: int, dimension: int) -> list[NDArray[np.float64]]:
    """Places that fill a box evenly: multiples of powers of a generalized golden ratio, modulo 1."""
    ratio = 1.5
    for _ in range(60):
        ratio = (1.0 + ratio) ** (1.0 / (dimension + 1))
    steps = ratio ** -np.arange(1.0, dimension + 1)
    return [np.asarray((0.5 + (k + 1) * steps) % 1.0) for k in range(count)]
