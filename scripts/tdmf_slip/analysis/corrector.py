"""Newton's method to a branch of gaits, on a plane across a direction."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..contents import ByContents
from ..errors import InputError, RunError
from ..library.gait import Gait
from ..numerics.newton import newton_iterates, same_error

NEWTON_ITERATIONS = 24
SHORTENINGS = 12
CONVERGED, GOOD_ENOUGH = 1e-13, 1e-11
"""Largest difference of the apex and the next, over the scales."""

Iterate: TypeAlias = tuple[NDArray[np.float64], Gait]
"""A point over the scales, and the strides from there."""


class Strides(Protocol):
    """Strides of one runner by apex and parameter."""

    scales: NDArray[np.float64]
    """Of the coordinates and the parameter."""

    def evaluate(self, coordinates: NDArray[np.float64]) -> Gait:
        """The strides from a point over the scales."""

    def rows(self, gait: Gait) -> NDArray[np.float64]:
        """How what is left over of the strides changes, all over the scales."""


def iterates(
    family: Strides, goal: NDArray[np.float64], normal: NDArray[np.float64], shortenings: int
) -> Iterator[tuple[Gait, NDArray[np.float64]]]:
    """The strides at each point of Newton's method, and where its whole step leads from there.

    Steps that make the error larger are shortened so many times, or taken all the same: where an event is
    just touched the map has a square root, and only whole steps lead across.
    """
    plane, begin = _OnPlane(family, goal, normal), (goal, family.evaluate(goal))
    bound, tries = (same_error, shortenings) if shortenings else (_unless_good_enough, 1)
    for (coordinates, gait), step in newton_iterates(
        plane, begin, iterations=NEWTON_ITERATIONS, shortenings=tries, bound=bound
    ):
        yield gait, coordinates if step is None else coordinates + step


def _unless_good_enough(error: float) -> float:
    """Any whole step is taken, until one leads away from what is good enough."""
    return np.inf if error > GOOD_ENOUGH else GOOD_ENOUGH


@dataclass(frozen=True, eq=False)
class _OnPlane(ByContents):
    """That strides lead back to their apex, of a point on a plane."""

    family: Strides
    goal: NDArray[np.float64]
    normal: NDArray[np.float64]

    def error(self, iterate: Iterate) -> float:
        return iterate[1].error

    def is_solved(self, iterate: Iterate) -> bool:
        return iterate[1].error <= CONVERGED

    def step(self, iterate: Iterate) -> NDArray[Any]:
        coordinates, gait = iterate
        off = np.append(gait.left_over / self.family.scales[:-1], (coordinates - self.goal) @ self.normal)
        step: NDArray[Any] = np.linalg.solve(np.vstack([self.family.rows(gait), self.normal]), -off)
        return step

    def moved(self, iterate: Iterate, step: NDArray[Any]) -> Iterate:
        """A point that is not allowed is one without strides."""
        coordinates = iterate[0] + step
        try:
            return coordinates, self.family.evaluate(coordinates)
        except InputError as problem:
            raise RunError(f"Newton's method leads to what is not allowed, {problem}") from None
