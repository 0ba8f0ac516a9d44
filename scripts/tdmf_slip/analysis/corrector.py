"""Newton's method to a branch of gaits, on a plane across a direction."""

from collections.abc import Iterator
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError
from ..library.gait import Gait

NEWTON_ITERATIONS = 24
SHORTENINGS = 12
CONVERGED, GOOD_ENOUGH = 1e-13, 1e-11
"""Largest difference of the apex and the next, over the scales."""


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
    place, gait = goal, family.look(goal)
    for _ in range(NEWTON_ITERATIONS):
        if gait.error <= CONVERGED:
            break
        off = np.append(gait.left_over / family.scales[:-1], (place - goal) @ normal)
        change: NDArray[Any] = np.linalg.solve(np.vstack([family.rows(gait), normal]), -off)
        yield gait, place + change
        improved = _improved(family, place, change, gait, shortenings)
        if improved is None:
            return
        place, gait = improved
    yield gait, place


def _improved(
    family: Strides, place: NDArray[np.float64], change: NDArray[Any], gait: Gait, shortenings: int
) -> tuple[NDArray[np.float64], Gait] | None:
    """Goes a step, or the part of it that makes the error smaller; None where none does."""
    if shortenings == 0:
        there = _tried(family, place + change)
        return None if gait.error <= GOOD_ENOUGH <= there.error else (place + change, there)
    for shortening in range(shortenings):
        tried = place + 0.5**shortening * change
        try:
            there = _tried(family, tried)
        except RunError:
            if shortening == shortenings - 1:
                raise
            continue
        if there.error < gait.error:
            return tried, there
    return None


def _tried(family: Strides, place: NDArray[np.float64]) -> Gait:
    """The strides where a step leads; a place that is not allowed is one without strides."""
    try:
        return family.look(place)
    except InputError as problem:
        raise RunError(f"Newton's method leads to what is not allowed, {problem}") from None
