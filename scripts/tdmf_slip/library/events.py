"""Events of a stride, and the letters of its word."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from .binding import c

LETTERS: Mapping[int, str] = {
    c.TDMF_CONTACT_STICK: "0",
    c.TDMF_CONTACT_SLIP_POSITIVE: "+",
    c.TDMF_CONTACT_SLIP_NEGATIVE: "-",
}
"""Letters of the gait word, by contact mode."""


MECHANICAL = slice(c.TDMF_FOOT_X, c.TDMF_FOOT_X + c.TDMF_MECHANICAL_COUNT)
"""Places of the mechanical states among the states of a run."""


@dataclass(frozen=True)
class Event:
    """An event within a stride."""

    time: float
    """s since the apex at which the stride begins."""
    guard: int
    """Guard that fired, by the library's number."""
    contact_before: int
    """Contact mode, by the library's number; as the following."""
    contact_after: int
    """Contact mode that it began."""
    state: tuple[float, ...]
    """Mechanical states before the event, in the order of `STATES`."""


def recorded(log: Any) -> tuple[Event, ...]:
    """Events of a stride, as the solver has logged them."""
    return tuple(
        Event(e.time, e.guard, e.before.contact, e.after.contact, tuple(e.state[MECHANICAL]))
        for e in log.events[0 : min(log.count, c.TDMF_EVENT_CAPACITY)]
    )


@dataclass(frozen=True)
class Letter:
    """A letter of a gait word: a contact mode in which the ground bears the foot."""

    letter: str
    """`+`, `0` or `-`."""
    duration: float
    """s that the mode lasts."""


def letters_of(events: Sequence[Event]) -> tuple[Letter, ...]:
    """The letters of a stride's word; graze and flight add none."""
    found: list[Letter] = []
    flown = True
    for event, following in pairwise(events):
        letter = LETTERS.get(event.contact_after)
        flown = flown or event.contact_after == c.TDMF_CONTACT_FLIGHT
        if letter is None:
            continue
        duration = following.time - event.time
        if found and found[-1].letter == letter and not flown:
            found[-1] = Letter(letter, found[-1].duration + duration)
        else:
            found.append(Letter(letter, duration))
        flown = False
    return tuple(found)
