"""The search for the best gait: within a smooth region by SLSQP, and on from border to border.

The objective and the constraints are smooth functions of the parameters only while the word and the events of
the stride stay. So each run of SLSQP is on one region, in a box. Where an iterate is on another one, the
border between the two is located, with the gradients on both sides:

* where the merit falls away from the border on a side, the search goes on there;
* where it falls on neither, the best point on the border is looked for, by SLSQP along it; this is an optimum
  where, on both sides, no step makes the merit less, to first order.

The eigenvalues are not even continuous across a border. Where one side violates a constraint on them and the
other does not, the other is the better one, and the optimum is its.

Where an iterate is no gait, because of a fold or a fall, the box becomes smaller. Gaits near a fold change
without bound, and an optimum at its very edge cannot be found by gradients: the caller then asks once more
with a constraint that keeps off the fold.
"""

from dataclasses import dataclass

from ..errors import RunError
from .along import best_along
from .border import Border, Side, between
from .fold_edge import best_on_edge, is_near
from .gaits import Candidate, Gaits
from .problem import MET, Problem
from .region import Region
from .slsqp import Ended, minimize

RADIUS, SMALLEST = 0.25, 1e-7
"""Half the width of the first box, and of the last one before a search gives up; of the bounds' width."""
ROUNDS = 80
PATIENCE, LITTLE = 12, 1e-6
"""A search that was kept from going on gives up after so many runs that make the merit less by no more."""
PROGRESS = 1e-9
"""Of the merit: a run that makes it less by no more has come to nothing."""
ROUGHLY = 1e-3
"""Violation of the constraints at which a search that makes no progress has nothing to hope for."""
EDGES = 3
"""Searches along the edge that is kept off a fold."""
TOUCHES = "a foot just touches the ground once more there, where gaits end or change as a square root does"
STATIONARY = 1e-4
"""Fall of the merit, over the size of a step, that counts as none."""


@dataclass(frozen=True, eq=False)
class Found:
    """Where a search ended."""

    gait: Candidate
    """The best one."""
    remaining_improvement: dict[str, float]
    """Largest decrease of the merit per size of a step, by gait word next to it; zero at an optimum."""
    border: Border | None = None
    """On which it lies, if on any."""
    why: str = ""
    """What kept the search from an optimum; empty where it is one."""


def _touches_again(gait: Candidate, beyond: Candidate) -> bool:
    """Whether between two gaits a foot just touches the ground once more within a stride."""
    return gait.gait.stride["touchdowns"] != beyond.gait.stride["touchdowns"]


class Search:
    """From a gait to the best one of a problem that is reached."""

    def __init__(self, gaits: Gaits, problem: Problem) -> None:
        """Of which runner, over which parameters, and what is asked."""
        self.gaits, self.problem = gaits, problem

    def run(self, begin: Candidate) -> Found:
        """The optimum that is reached from a gait, or how far the search came."""
        best, region, radius, largest, why = begin, Region.of(begin.gait), RADIUS, 1.0, ""
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
                if not ended.lost and not grows and self.problem.violation(best) > ROUGHLY:
                    return Found(best, {best.gait.word: fall}, why="the constraints cannot be met from here")
                why = ended.lost or "the search does not converge"
            else:
                try:
                    went = self._at_border(best, ended.beyond, region)
                except RunError as problem:
                    went, why = (best, region, True), str(problem)
                    touches = touches or _touches_again(best, ended.beyond)
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
        low, high = (best.at - radius).clip(0.0, 1.0), (best.at + radius).clip(0.0, 1.0)
        follow = self.gaits.follow
        return minimize(self.problem, follow, best, low, high, lambda gait: region.has(gait.gait))

    def _at_border(
        self, best: Candidate, beyond: Candidate, region: Region
    ) -> Found | tuple[Candidate, Region, bool]:
        """The optimum on the border on the way; or the gait and the region to go on from.

        With these, whether the search stays where it was, for which it wants a smaller box.
        """
        merit = self.problem.merit
        border = between(self.gaits, best, beyond, region.has)
        if border.is_smooth:
            region.grow(border.beyond.gait)
            return min((best, border.short), key=merit), region, False
        if min(merit(side.gait) for side in border.sides) > merit(best) + MET:
            return best, region, True
        better = self._better_side(border)
        if better is None:
            border = best_along(self.gaits, self.problem, border, region, STATIONARY)
            better = self._better_side(border)
            if better is None:
                return self._found(border)
        if better is border.beyond:
            return better, Region.of(better.gait), False
        return min((best, better), key=merit), region, True

    def _open_sides(self, border: Border) -> list[Side]:
        """Without the side of more merit where it jumps, for it is no better than the border itself."""
        merits = [self.problem.merit(side.gait) for side in border.sides]
        return [side for side, merit in zip(border.sides, merits, strict=True) if merit <= min(merits) + MET]

    def _better_side(self, border: Border) -> Candidate | None:
        """Where the merit falls away from the border, the more if on both sides; None where on neither."""
        sides = self._open_sides(border)
        if len(sides) == 1 and sides[0].gait is border.beyond:
            return border.beyond
        gains = [side.gain(self.problem) for side in sides]
        best = max(range(len(sides)), key=lambda number: gains[number])
        return sides[best].gait if gains[best] > STATIONARY else None

    def _found(self, border: Border) -> Found:
        sides = self._open_sides(border)
        remaining = {side.gait.gait.word: self.problem.steepest(side.gait, side.away) for side in sides}
        why = "" if max(remaining.values()) <= STATIONARY else "the search along a border does not converge"
        return Found(min((side.gait for side in sides), key=self.problem.merit), remaining, border, why)
