"""The search for the best gait: within a smooth piece by SLSQP, and on from border to border.

The objective and the constraints are smooth functions of the parameters only while the word and the events of
the stride stay. So each run of SLSQP is on one piece, in a box. Where an iterate is on another one, the
border between the two is located, with the gradients on both sides:

* where the merit falls away from the border on a side, the search goes on there;
* where it falls on neither, the best place on the border is looked for, by SLSQP along it; this is an optimum
  where, on both sides, no step makes the merit less, to first order.

The eigenvalues are not even continuous across a border. Where one side violates a constraint on them and the
other does not, the other is the better one, and the optimum is its.

Where an iterate is no gait, because of a fold or a fall, the box becomes smaller. Gaits near a fold change
without bound, and an optimum at its very edge cannot be found by gradients: the caller then asks once more
with a constraint that keeps off the fold.
"""

from collections.abc import Callable
from dataclasses import dataclass

from ..errors import RunError
from .along import best_along
from .border import Border, between
from .gaits import Candidate, Gaits
from .pieces import Piece
from .problem import MET, Problem
from .slsqp import Ended, minimize

RADIUS, SMALLEST = 0.25, 1e-7
"""Half the width of the first box, and of the last one before a search gives up; of the bounds' width."""
ROUNDS = 80
PROGRESS = 1e-9
"""Of the merit: a run that makes it less by no more has come to nothing."""
ROUGHLY = 1e-3
"""Violation of the constraints at which a search that makes no progress has nothing to hope for."""
STATIONARY = 1e-4
"""Fall of the merit, over the size of a step, that counts as none."""


@dataclass(frozen=True)
class Found:
    """Where a search ended."""

    gait: Candidate
    """The best one."""
    falls: dict[str, float]
    """By the words beside it: how much less the merit could be, over the size of a step; zero at an
    optimum."""
    border: Border | None = None
    """On which it lies, if on any."""
    why: str = ""
    """What kept the search from an optimum; empty where it is one."""


class Search:
    """From a gait to the best one of a problem that is reached."""

    def __init__(
        self, gaits: Gaits, problem: Problem, tell: Callable[[Candidate], None] = lambda gait: None
    ) -> None:
        """`tell` is called with the best gait after each run of SLSQP."""
        self.gaits, self.problem, self.tell = gaits, problem, tell

    def run(self, begin: Candidate) -> Found:
        """The optimum that is reached from a gait, or how far the search came."""
        best, piece, radius, largest, why = begin, Piece.of(begin.orbit), RADIUS, 1.0, ""
        for _ in range(ROUNDS):
            ended = self._in_box(best, radius, piece)
            progress = self.problem.merit(best) - self.problem.merit(ended.best)
            best = ended.best
            self.tell(best)
            if ended.beyond is None:
                fall = self.problem.steepest(best)
                if fall <= STATIONARY and not ended.lost:
                    return Found(best, {best.orbit.word: fall})
                if ended.lost and not self.problem.goal.fold:
                    return Found(best, {best.orbit.word: fall}, why=ended.lost)
                grows = not ended.lost and progress > PROGRESS
                largest = 0.5 * radius if ended.lost else 1.5 * largest
                radius = min(1.0, largest, 2.0 * radius) if grows else 0.25 * radius
                if not ended.lost and not grows and self.problem.violation(best) > ROUGHLY:
                    return Found(best, {best.orbit.word: fall}, why="the constraints cannot be met from here")
                why = ended.lost or "the search does not converge"
            else:
                try:
                    went = self._at_border(best, ended.beyond, piece)
                except RunError as problem:
                    went, why = (best, piece, True), str(problem)
                if isinstance(went, Found):
                    return went
                best, piece, stays = went
                radius *= 0.25 if stays else 1.0
                why = why or "words change too often"
            if radius < SMALLEST:
                break
        return Found(best, {best.orbit.word: self.problem.steepest(best)}, why=why)

    def _in_box(self, best: Candidate, radius: float, piece: Piece) -> Ended:
        low, high = (best.at - radius).clip(0.0, 1.0), (best.at + radius).clip(0.0, 1.0)
        follow = self.gaits.follow
        return minimize(self.problem, follow, best, low, high, lambda gait: piece.has(gait.orbit))

    def _at_border(
        self, best: Candidate, beyond: Candidate, piece: Piece
    ) -> Found | tuple[Candidate, Piece, bool]:
        """The optimum on the border on the way; or the gait and the piece to go on from.

        With these, whether the search stays where it was, for which it wants a smaller box.
        """
        merit = self.problem.merit
        border = between(self.gaits, best, beyond, piece.has)
        if border.is_smooth:
            piece.grow(border.beyond.orbit)
            return min((best, border.short), key=merit), piece, False
        if merit(self._lower(border)[0]) > merit(best) + MET:
            return best, piece, True
        side = self._better_side(border)
        if side is None:
            border = best_along(self.gaits, self.problem, border, piece, STATIONARY)
            side = self._better_side(border)
            if side is None:
                return self._found(border)
        if side is border.beyond:
            return side, Piece.of(side.orbit), False
        return min((best, side), key=merit), piece, True

    def _lower(self, border: Border) -> tuple[Candidate, ...]:
        """Its side of less merit first; without the other one where the merit jumps."""
        sides = sorted((border.short, border.beyond), key=self.problem.merit)
        jumps = self.problem.merit(sides[1]) > self.problem.merit(sides[0]) + MET
        return (sides[0],) if jumps else (border.short, border.beyond)

    def _better_side(self, border: Border) -> Candidate | None:
        """Where the merit falls away from the border, the more if on both sides; None where on neither."""
        lower = self._lower(border)
        if lower == (border.beyond,):
            return border.beyond
        gains = {
            id(gait): border.gain(self.problem, gait, away)
            for gait, away in border.sides
            if any(gait is one for one in lower)
        }
        best = max(lower, key=lambda gait: gains[id(gait)])
        return best if gains[id(best)] > STATIONARY else None

    def _found(self, border: Border) -> Found:
        lower = self._lower(border)
        falls = {
            gait.orbit.word: self.problem.steepest(gait, away)
            for gait, away in border.sides
            if any(gait is one for one in lower)
        }
        why = "" if max(falls.values()) <= STATIONARY else "the search along a border does not converge"
        return Found(min(lower, key=self.problem.merit), falls, border, why)
