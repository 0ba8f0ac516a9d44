"""Walk from one value to another in steps that are halved where they fail."""

from collections.abc import Callable, Iterator
from itertools import count
from typing import TypeVar

from ..errors import InputError, RunError

MAX_STEPS = 500
"""Largest number of steps of a walk; most walks take fewer than a hundred."""

Found = TypeVar("Found")
Known = TypeVar("Known")


def halved(attempt: Callable[[float], Found], step: float, shortest: float) -> tuple[Found, float]:
    """Result of an attempt with the longest of a step, its half, its quarter and so on, and that step.

    Where no step as long as the shortest succeeds, the error of the last attempt is raised.
    """
    while True:
        try:
            return attempt(step), step
        except (InputError, RunError):
            step *= 0.5
            if not abs(step) >= shortest:  # also where it is not a number
                raise


def walk(
    known: Known,
    begin: float,
    end: float,
    advance: Callable[[Known, float, float], Known],
    *,
    shortest: float,
    first: float | None = None,
) -> Iterator[tuple[float, Known]]:
    """Results on the way from one value to another, each found from the one before.

    Where `advance` fails the step is halved; where it succeeds the next step is twice as long. No step is
    shorter than the shortest, nor is what it leaves of the way; else the last error is raised. A walk that
    does not reach the end in `MAX_STEPS` steps raises RunError.
    """
    at, step = begin, end - begin if first is None else first

    def attempt(step: float) -> tuple[float, Known]:
        to = end if abs(end - at - step) < shortest else at + step
        return to, advance(known, at, to)

    for number in count():
        if at == end:
            return
        if number == MAX_STEPS:
            raise RunError(f"{MAX_STEPS} steps from {begin:g} towards {end:g} lead no farther than to {at:g}")
        step = max(-abs(end - at), min(step, abs(end - at)))
        (at, known), step = halved(attempt, step, shortest)
        yield at, known
        step *= 2.0
