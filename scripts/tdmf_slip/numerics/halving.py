"""Steps that are halved where they fail: a single one, and those of a walk from a known value to another."""

from collections.abc import Callable, Iterator
from functools import partial
from itertools import count
from typing import TypeVar

from ..errors import InputError, RunError

MAX_STEPS = 500
"""Steps of a walk, at most; usual walks take fewer than a hundred."""

Found = TypeVar("Found")
Known = TypeVar("Known")


def halved(
    attempt: Callable[[float], Found],
    step: float,
    shortest: float,
    failures: tuple[type[Exception], ...] = (InputError, RunError),
) -> tuple[Found, float]:
    """What an attempt finds by the longest of a step, its half, its quarter and so on, and that step.

    Where none serves that is as long as the shortest, what the last attempt raised is raised.
    """
    while True:
        try:
            return attempt(step), step
        except failures:
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
    """What is found on the way from a value to another, each from what is known at the value before.

    Where `advance` raises RunError the step is halved, where it succeeds the next one is twice as long. No
    step is shorter than the shortest, nor is what it leaves of the way; else the RunError is raised. So it is
    where the end is not reached in `MAX_STEPS` steps.
    """
    at, step = begin, end - begin if first is None else first
    for number in count():
        if at == end:
            return
        if number == MAX_STEPS:
            raise RunError(f"{MAX_STEPS} steps from {begin:g} towards {end:g} lead no farther than to {at:g}")
        step = max(-abs(end - at), min(step, abs(end - at)))
        attempt = partial(_advanced, advance, known, at, end, shortest)
        (at, known), step = halved(attempt, step, shortest, (RunError,))
        yield at, known
        step *= 2.0


def _advanced(
    advance: Callable[[Known, float, float], Known],
    known: Known,
    at: float,
    end: float,
    shortest: float,
    step: float,
) -> tuple[float, Known]:
    to = end if abs(end - at - step) < shortest else at + step
    return to, advance(known, at, to)
