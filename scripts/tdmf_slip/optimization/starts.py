"""Where searches begin: of gaits all over the bounds, those that have no better one near them."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..analysis.linkage import linked
from ..analysis.settled import evenly, settled_gaits
from ..errors import InputError, RunError
from ..library.fixed_point import gait_near
from ..library.gait import Gait
from ..library.varied_stride import plain_stride
from .problem import Problem
from .space import Space

RUNNERS = 1024
"""Spread over the bounds."""
VIOLATED = 2.0
"""What a violated constraint weighs against the objective where a search is to begin: it will be met there by
a change of the parameters, which changes the objective by as much or so."""


@dataclass(frozen=True, eq=False)
class Start:
    """A gait where a search begins."""

    at: NDArray[np.float64]
    """Where it is, inside the bounds from 0 to 1."""
    gait: Gait
    """The gait."""


class Spread:
    """Gaits all over the bounds."""

    def __init__(self, first: Start, space: Space) -> None:
        """From a gait that is known, over the space."""
        self.space, self.runner = space, first.gait.runner
        points = evenly(RUNNERS, len(space.bounds))
        values = space.low + points * space.width
        varied = {name: np.ascontiguousarray(row) for name, row in zip(space.bounds, values.T, strict=True)}
        found = settled_gaits(self.runner, varied, first.gait.apex)
        self.points, self.apexes = points[found.numbers], found.apexes

    def starts(self, problem: Problem, first: Start) -> Iterator[Start]:
        """Where to begin a search for a problem, the most promising first."""
        runners = [self.space.runner_at(self.runner, point) for point in self.points]
        names = problem.goal.names
        merits, known = [], []
        for number, (runner, apex) in enumerate(zip(runners, self.apexes, strict=True)):
            try:
                quantities = plain_stride(runner, apex, names).quantities
            except (InputError, RunError):
                continue
            merits.append(problem.rough_merit(quantities, VIOLATED))
            known.append(number)
        for k in linked(self.points[known], np.array(merits)):
            try:
                yield Start(self.points[known[k]], gait_near(runners[known[k]], self.apexes[known[k]]))
            except RunError:
                continue
