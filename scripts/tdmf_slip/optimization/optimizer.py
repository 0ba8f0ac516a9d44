"""The search for the best gait: from several starts, by SLSQP in smooth regions, from border to border.

Starts are gaits all over the bounds without a better gait near them. The objective and the constraints are
smooth functions of the parameters only while the word and the events of the stride stay. Each run of SLSQP is
therefore in one region, in a box. If an iterate is in another region, the border between the two is located,
with the gradients on both sides:

* If the merit falls away from the border on a side, the search goes on there.
* If it falls on neither side, SLSQP along the border finds the best point on it. This is an optimum if no
  step on either side decreases the merit, to first order.

The eigenvalues are not even continuous across a border. If only one side violates a constraint on them, the
optimum is on the other side.

If an iterate is no gait, because of a fold or a fall, the box becomes smaller. Gaits near a fold change
without bound, and gradients cannot find an optimum at its very edge. The search is then repeated with a
constraint that keeps off the fold.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from ..analysis.settled import Settled, evenly, settled_gaits
from ..analysis.targeted import TargetNotMetError
from ..errors import RunError
from ..library.gait import Gait
from ..library.runner import Runner
from ..library.strides import plain_stride
from ..numerics.walking import halved
from ..terminal.progress import Bar
from .border import Border, Region, best_along, best_on_edge, between, is_near
from .gaits import Candidate, Gaits, Space, Spectrum
from .optimum import FOLD, STABILITY, Optimum, reported
from .problem import MET, OFF_FOLD, Ended, Feasibility, Goal, Problem, minimize

VIOLATED = 2.0
"""Weight of a violated constraint against the objective, in a choice of starts.

The search will meet the constraint by a change of the parameters, and the objective changes about as much."""
RADIUS, SMALLEST = 0.25, 1e-7
"""Half the width of the first box, and of the last one before a search gives up, over the bounds' width."""
ROUNDS = 80
PATIENCE, LITTLE = 12, 1e-6
"""Number of runs, and their improvement of the merit, after which a blocked search gives up."""
PROGRESS = 1e-9
"""Least improvement of the merit that counts as progress of a run."""
STILL_VIOLATED = 1e-3
"""Violation of the constraints above which a search without progress gives up."""
EDGES = 3
"""Largest number of searches along the edge off a fold."""
TOUCHES = "a foot just touches the ground once more there, where gaits end or change as a square root does"
STATIONARY = 1e-4
"""Fall of the merit, over the size of a step, that counts as none."""
ROUGHLY = 1e-4
"""Violation of constraints below which SLSQP can meet them on its own."""
NEARLY = 1e-2
"""Like `ROUGHLY`, after a search for a feasible gait, which ends early because its objective is flat."""
FEASIBLE = 1e-7
"""Violation of constraints, over their scales, that is rounding."""
ACTIVE = 1e-5
"""Distance of an eigenvalue from its limit at which the limit is active."""
NATURAL = 1e-2
"""Least scale of a quantity that is nearly zero, over the scale of its dimension."""
APART = 1e-2
"""Largest distance of optima that count as one, over the width of the bounds and the apices' scales."""
TRIES = 4
"""Number of points on the way to a start that are tried: the end, the middle, and so on."""


@dataclass(frozen=True, eq=False)
class Found:
    """Result of a search."""

    gait: Candidate
    """Best gait of the search."""
    remaining_improvement: dict[str, float]
    """Largest decrease of the merit per size of a step, by gait word on each side; zero at an optimum."""
    border: Border | None = None
    """Border on which the gait lies; None if on no border."""
    why: str = ""
    """Reason why the search did not reach an optimum; empty where it did."""


class Search:
    """Search from a gait for the best one of a problem."""

    def __init__(self, gaits: Gaits, problem: Problem) -> None:
        """Keep the gaits over the parameters, and the problem."""
        self.gaits, self.problem = gaits, problem

    def run(self, begin: Candidate) -> Found:
        """Optimum that is reached from a gait, or the best gait before the search stopped."""
        best, region, radius, largest, why = begin, {begin.region}, RADIUS, 1.0, ""
        edges, touches = 0, False
        merits: list[float] = []
        for _ in range(ROUNDS):
            ended = self._in_box(best, radius, region)
            progress = self.problem.merit(best) - self.problem.merit(ended.best)
            best = ended.best
            merits.append(self.problem.merit(best))
            if len(merits) > PATIENCE and merits[-PATIENCE] - merits[-1] <= LITTLE and why:
                break
            if ended.beyond is None:
                fall = self.problem.steepest(best)
                if fall <= STATIONARY and not ended.lost:
                    return Found(best, {best.gait.word: fall})
                if ended.lost and not self.problem.goal.fold:
                    return Found(best, {best.gait.word: fall}, why=ended.lost)
                if self.problem.goal.fold and edges < EDGES and is_near(best):
                    edges += 1
                    best = best_on_edge(self.gaits, self.problem, best, region, STATIONARY)
                    fall = self.problem.steepest(best)
                    if fall <= STATIONARY:
                        return Found(best, {best.gait.word: fall})
                grows = not ended.lost and progress > PROGRESS
                largest = 0.5 * radius if ended.lost else 1.5 * largest
                radius = min(1.0, largest, 2.0 * radius) if grows else 0.25 * radius
                if not ended.lost and not grows and self.problem.violation(best) > STILL_VIOLATED:
                    return Found(best, {best.gait.word: fall}, why="the constraints cannot be met from here")
                why = ended.lost or "the search does not converge"
            else:
                try:
                    went = self._at_border(best, ended.beyond, region)
                except RunError as problem:
                    went, why = (best, region, True), str(problem)
                    here, there = (of.gait.stride["touchdowns"] for of in (best, ended.beyond))
                    touches = touches or here != there
                if isinstance(went, Found):
                    return went
                best, region, stays = went
                radius *= 0.25 if stays else 1.0
                why = why or "words change too often"
            if radius < SMALLEST:
                break
        remaining = {best.gait.word: self.problem.steepest(best)}
        return Found(best, remaining, why=TOUCHES if touches else why)

    def _in_box(self, best: Candidate, radius: float, region: Region) -> Ended:
        box = (best.at - radius).clip(0.0, 1.0), (best.at + radius).clip(0.0, 1.0)
        return minimize(self.problem, self.gaits.follow, best, box, lambda gait: gait.region in region)

    def _at_border(
        self, best: Candidate, beyond: Candidate, region: Region
    ) -> Found | tuple[Candidate, Region, bool]:
        """Optimum on the border between two gaits; or the gait and the region to go on from.

        The third value is True if the search stays in its region and needs a smaller box.
        """
        merit = self.problem.merit
        border = between(self.gaits, best, beyond, region)
        if border.is_smooth:
            region.add(border.beyond.region)
            return min((best, border.short), key=merit), region, False
        if min(merit(side) for side, _ in border.sides) > merit(best) + MET:
            return best, region, True
        better = self._better_side(border)
        if better is None:
            border = best_along(self.gaits, self.problem, border, region, STATIONARY)
            better = self._better_side(border)
            if better is None:
                return self._found(border)
        if better is border.beyond:
            return better, {better.region}, False
        return min((best, better), key=merit), region, True

    def _open_sides(self, border: Border) -> list[tuple[Candidate, NDArray[np.float64]]]:
        """Sides of a border, without the side of greater merit if the merit jumps."""
        merits = [self.problem.merit(gait) for gait, _ in border.sides]
        return [side for side, merit in zip(border.sides, merits, strict=True) if merit <= min(merits) + MET]

    def _better_side(self, border: Border) -> Candidate | None:
        """Side on which the merit falls away from the border, the steeper of two; None if on neither side."""
        sides = self._open_sides(border)
        if len(sides) == 1 and sides[0][0] is border.beyond:
            return border.beyond
        gains = [self.problem.gain(*side) for side in sides]
        best = int(np.argmax(gains))
        return sides[best][0] if gains[best] > STATIONARY else None

    def _found(self, border: Border) -> Found:
        sides = self._open_sides(border)
        remaining = {gait.gait.word: self.problem.steepest(gait, away) for gait, away in sides}
        why = "" if max(remaining.values()) <= STATIONARY else "the search along a border does not converge"
        return Found(min((gait for gait, _ in sides), key=self.problem.merit), remaining, border, why)


class Optimizer:
    """Optima of a runner over some parameters."""

    def __init__(self, before: Gait, space: Space, starts: int) -> None:
        """Keep the runner's own gait, the parameters, and the number of searches."""
        self.before, self.space = before, space
        gaits = Gaits(before.runner, space, ["speed"])
        inside = np.clip(space.coordinates_of(before.runner), 0.0, 1.0)
        first = _reached(gaits, before, inside, 1)
        if first is None:
            raise RunError(
                f"no gait within the bounds of {', '.join(space.bounds)} was reached from the runner's own "
                "gait; choose bounds nearer to the runner's values"
            )
        self.first, self.count, self._gaits_of = first, starts, gaits

    @cached_property
    def settled(self) -> Settled:
        """Settled runners all over the bounds."""

        def between_bounds(name: str, shares: NDArray[np.float64]) -> NDArray[np.float64]:
            low, high = self.space.bounds[name]
            values: NDArray[np.float64] = low + shares * (high - low)
            return values

        return settled_gaits(self.first, tuple(self.space.bounds), between_bounds)

    def starts(self, problem: Problem) -> list[Gait]:
        """Starts of the searches for a problem: the runner's own gait, then the most promising ones.

        If no runner settles, starts are gaits that are reached along the branch from the first.
        """
        more = self.count - 1
        if not more:
            return [self.first]

        def merit(runner: Runner, apex: NDArray[np.float64]) -> float:
            """Merit of a gait without constraints on its eigenvalues, which are unknown."""
            values = plain_stride(runner, apex, problem.goal.names).quantities
            at = self.space.coordinates_of(runner)
            slopes, spectrum = np.zeros((len(values), len(at))), Spectrum.none(len(at))
            rough = Candidate(at, self.first, np.zeros((len(apex), len(at))), values, slopes, spectrum)
            return problem.objective(rough)[0] + VIOLATED * problem.violation(rough)

        found = list(islice(self.settled.gaits(merit), more))
        if not found:
            points = evenly(more, len(self.space.bounds))
            reached = (_reached(self._gaits_of, self.first, point, TRIES) for point in points)
            found = [gait for gait in reached if gait is not None]
        return [self.first, *found]

    def scales(self, goal: Goal) -> dict[str, float]:
        """Scales of the quantities of a goal: their sizes at the first start, or the prescribed values."""
        gait = self.first
        units = {name: of.unit for name, of in gait.runner.model.quantities.items()}
        sized = ("speed", "frequency", "stance_time", "length", "slip_distance")
        natural = {name: gait.runner.scale_of(units[name]) for name in sized if name in units}
        values = reported(gait)
        return {
            name: max(abs(goal.at.get(name, values[name])), NATURAL * natural.get(name, 1.0))
            for name in goal.names
        }

    def candidate(self, goal: Goal) -> Candidate:
        """First start with its gradients."""
        return self._gaits(goal).candidate(self.first)

    def best(self, goal: Goal, bar: Bar, starts: Sequence[Gait] = ()) -> Optimum:
        """Best gait of all searches that meets the constraints."""
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
        return self._optimum(goal, best, len(begun), _basins(allowed))

    def _searched(self, problem: Problem, start: Gait) -> Found:
        """Search from one start; if it is far from meeting the constraints, find a feasible gait first."""
        if problem.violation(self._gaits(problem.goal).candidate(start)) > ROUGHLY:
            nearest = self._off_folds(Feasibility(problem.goal, problem.scales), start)
            if problem.violation(nearest.gait) > NEARLY:
                return nearest
            start = nearest.gait.gait
        return self._off_folds(problem, start)

    def _off_folds(self, problem: Problem, start: Gait) -> Found:
        """Search from one start; if gaits were lost, search again off folds."""
        found = self._search(problem, start)
        if not found.why or problem.goal.fold:
            return found
        kept_off = type(problem)(replace(problem.goal, fold=True), problem.scales)
        return self._search(kept_off, found.gait.gait)

    def _search(self, problem: Problem, start: Gait) -> Found:
        gaits = self._gaits(problem.goal)
        return Search(gaits, problem).run(gaits.candidate(start))

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

    def _optimum(self, goal: Goal, found: Found, starts: int, basins: int) -> Optimum:
        """Optimum as it is reported."""
        spectrum, limits = found.gait.spectrum, []
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
            starts=starts,
            basins=basins,
        )


def _basins(found: Sequence[Found]) -> int:
    """Number of different optima among the results of searches."""
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


def _reached(gaits: Gaits, begin: Gait, point: NDArray[np.float64], tries: int) -> Gait | None:
    """Gait at a point, or on the way to it if the branch does not lead so far."""
    try:
        first = gaits.candidate(begin)
        way = point - first.at
        shortest = 0.5 ** (tries - 1)
        gait, _ = halved(lambda share: gaits.gait_from(first, first.at + share * way), 1.0, shortest)
    except RunError:
        return None
    return gait
