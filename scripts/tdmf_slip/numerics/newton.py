"""Newton's method with damping: steps that do not make the error smaller are shortened by halves."""

from collections.abc import Iterator
from typing import Any, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError

Iterate = TypeVar("Iterate")


class Equations(Protocol[Iterate]):
    """What is solved: an iterate is a point with all that is evaluated there."""

    def error(self, iterate: Iterate) -> float:
        """What a step has to make smaller."""

    def is_solved(self, iterate: Iterate) -> bool:
        """Whether no more steps are taken."""

    def step(self, iterate: Iterate) -> NDArray[Any]:
        """The whole step of Newton's method; LinAlgError where there is none."""

    def moved(self, iterate: Iterate, step: NDArray[Any]) -> Iterate:
        """The iterate a step further; RunError where nothing can be evaluated there."""


def newton_iterates(
    equations: Equations[Iterate], begin: Iterate, *, iterations: int, shortenings: int, gain: float = 1.0
) -> Iterator[tuple[Iterate, NDArray[Any] | None]]:
    """The iterates with the whole step from each, and the last one without.

    Parameters
    ----------
    equations : Equations
        What is solved.
    begin : Iterate
        The first one.
    iterations : int
        Steps at the most.
    shortenings : int
        Lengths of a step that are tried: all, a half and so on. The iterates end where none serves.
    gain : float, default 1
        A step has to make the error smaller than so much of it.

    Raises
    ------
    RunError
        Nothing can be evaluated where the shortest step leads.
    LinAlgError
        There is no step.
    """
    iterate = begin
    for _ in range(iterations):
        if equations.is_solved(iterate):
            break
        step = equations.step(iterate)
        yield iterate, step
        improved = _improved(equations, iterate, step, shortenings, gain)
        if improved is None:
            return
        iterate = improved
    yield iterate, None


def _improved(
    equations: Equations[Iterate], iterate: Iterate, step: NDArray[Any], shortenings: int, gain: float
) -> Iterate | None:
    """The iterate at the longest part of a step that makes the error smaller; None where none does."""
    bound = gain * equations.error(iterate)
    for shortening in range(shortenings):
        try:
            tried = equations.moved(iterate, 0.5**shortening * step)
        except RunError:
            if shortening == shortenings - 1:
                raise
            continue
        if equations.error(tried) < bound:
            return tried
    return None


def last_iterate(
    equations: Equations[Iterate], begin: Iterate, *, iterations: int, shortenings: int, gain: float = 1.0
) -> tuple[Iterate, int]:
    """Where `newton_iterates` ends for whatever reason, and after how many steps."""
    iterate, steps = begin, 0
    found = newton_iterates(equations, begin, iterations=iterations, shortenings=shortenings, gain=gain)
    try:
        for number, (further, _) in enumerate(found):
            iterate, steps = further, number
    except (RunError, np.linalg.LinAlgError):
        pass
    return iterate, steps
