"""Newton's method to a branch of gaits, on a plane across a direction."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..contents import ByContents
from ..errors import InputError, RunError
from ..library.gait import Gait
from ..numerics.newton import newton_iterates

NEWTON_ITERATIONS = 24
SHORTENINGS = 12
CONVERGED, GOOD_ENOUGH = 1e-13, 1e-11
"""Largest difference of the apex and the next, over the scales."""

Iterate: TypeAlias = tuple[NDArray[np.float64], Gait]
"""A place over the scales, and the strides from there."""


class Strides(Protocol):
    """Strides of one runner by apex and parameter."""

    scales: NDArray[np.float64]
    """Of the coordinates and the parameter."""

    def look(self, place: NDArray[np.float64]) -> Gait:
        """The strides from a place over the scales."""

    def rows(self, gait: Gait) -> NDArray[np.float64]:
        """How what is left over of the strides changes, all over the scales."""


def iterates(
    family: Strides, goal: NDArray[np.float64], normal: NDArray[np.float64], shortenings: int
) -> Iterator[tuple[Gait, NDArray[np.float64]]]:
    """The strides at each place of Newton's method, and where its whole step leads from there.

    Steps that make the error larger are shortened so many times, or taken all the same: where an event is
    just touched the map has a square root, and only whole steps lead across.
    """
    plane = _OnPlane(family, goal, normal)
    begin = goal, family.look(goal)
    if shortenings == 0:
        yield from _whole_steps(plane, begin)
        return
    for (place, gait), step in newton_iterates(
        plane, begin, iterations=NEWTON_ITERATIONS, shortenings=shortenings
    ):
        yield gait, place if step is None else place + step


def _whole_steps(plane: "_OnPlane", iterate: Iterate) -> Iterator[tuple[Gait, NDArray[np.float64]]]:
    """Without damping, until a step leads away from what is good enough."""
    for _ in range(NEWTON_ITERATIONS):
        if plane.is_solved(iterate):
            break
        step = plane.step(iterate)
        place, gait = iterate
        yield gait, place + step
        iterate = plane.moved(iterate, step)
        if gait.error <= GOOD_ENOUGH <= iterate[1].error:
            return
    place, gait = iterate
    yield gait, place


@dataclass(frozen=True, eq=False)
class _OnPlane(ByContents):
    """That strides lead back to their apex, of a place on a plane."""

    family: Strides
    goal: NDArray[np.float64]
    normal: NDArray[np.float64]

    def error(self, iterate: Iterate) -> float:
        return iterate[1].error

    def is_solved(self, iterate: Iterate) -> bool:
        return iterate[1].error <= CONVERGED

    def step(self, iterate: Iterate) -> NDArray[Any]:
        place, gait = iterate
        off = np.append(gait.left_over / self.family.scales[:-1], (place - self.goal) @ self.normal)
        step: NDArray[Any] = np.linalg.solve(np.vstack([self.family.rows(gait), self.normal]), -off)
        return step

    def moved(self, iterate: Iterate, step: NDArray[Any]) -> Iterate:
        """A place that is not allowed is one without strides."""
        place = iterate[0] + step
        try:
            return place, self.family.look(place)
        except InputError as problem:
            raise RunError(f"Newton's method leads to what is not allowed, {problem}") from None
