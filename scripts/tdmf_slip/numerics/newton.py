"""Newton's method with damping: steps that do not make the error smaller are shortened by halves."""

from collections.abc import Callable, Iterator
from typing import Any, Protocol, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError

Iterate = TypeVar("Iterate")

Bound: TypeAlias = Callable[[float], float]
"""Of the error behind a step, by that before it: a step that does not come below is shortened."""


def same_error(error: float) -> float:
    """Any step serves that makes the error smaller."""
    return error


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
    equations: Equations[Iterate],
    begin: Iterate,
    *,
    iterations: int,
    shortenings: int,
    bound: Bound = same_error,
) -> Iterator[tuple[Iterate, NDArray[Any] | None]]:
    """The iterates with the whole step from each, and the last one without.

    There are so many steps at the most. So many lengths of a step are tried, all of it, a half and so on, and
    the iterates end where none serves. Where nothing can be evaluated even by the shortest, RunError is
    raised, where there is no step LinAlgError.
    """
    iterate = begin
    for _ in range(iterations):
        if equations.is_solved(iterate):
            break
        step = equations.step(iterate)
        yield iterate, step
        improved = _improved(equations, iterate, step, shortenings, bound)
        if improved is None:
            return
        iterate = improved
    yield iterate, None


def _improved(
    equations: Equations[Iterate], iterate: Iterate, step: NDArray[Any], shortenings: int, bound: Bound
) -> Iterate | None:
    """The iterate at the longest part of a step that makes the error smaller; None where none does."""
    largest = bound(equations.error(iterate))
    for shortening in range(shortenings):
        try:
            tried = equations.moved(iterate, 0.5**shortening * step)
        except RunError:
            if shortening == shortenings - 1:
                raise
            continue
        if equations.error(tried) < largest:
            return tried
    return None


def last_iterate(
    equations: Equations[Iterate],
    begin: Iterate,
    *,
    iterations: int,
    shortenings: int,
    bound: Bound = same_error,
) -> tuple[Iterate, int]:
    """Where `newton_iterates` ends for whatever reason, and after how many steps."""
    iterate, steps = begin, 0
    found = newton_iterates(equations, begin, iterations=iterations, shortenings=shortenings, bound=bound)
    try:
        for number, (further, _) in enumerate(found):
            iterate, steps = further, number
    except (RunError, np.linalg.LinAlgError):
        pass
    return iterate, steps
