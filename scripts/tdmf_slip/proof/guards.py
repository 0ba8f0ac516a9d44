"""Guards of the events that can end each mode, and proofs of their signs and zeros along a step.

The guards are those of the page's events, each positive until its event. Falls have guards, too: a stride in
which one of these is not proved to be positive is undecided.

A guard is a tube. It may begin at exactly zero, to an order that follows from the rules of the event before.
The terms that are zero by these rules are dropped, and the rest is divided by that power of t.
"""

from typing import Any

from flint import arb, arb_poly

from ..pages.hip import REST
from .dual import Number
from .flow import Tube

FINEST = 2.0**-14
"""Shortest part of a step over which a guard is enclosed."""


class Guard:
    """A guard over a step, positive until its event."""

    def __init__(self, name: str, tube: Tube, order: int = 0) -> None:
        """The guard's tube, whose terms below an order are zero."""
        self.name, self.order = name, order
        self.span = tube.span
        self.polynomial: arb_poly = tube.polynomial.right_shift(order)
        self.slope = self.polynomial.derivative()
        self.remainder = tube.remainder
        self.power = tube.span.degree + 1 - order

    def over(self, begin: arb, end: arb) -> arb:
        """All values between two times, over the power of t."""
        times = begin.union(end)
        middle = times.mid()
        value = self.polynomial(middle) + self.slope(times) * (times - middle)
        plain = self.polynomial(times)
        if value.overlaps(plain):
            value = value.intersection(plain)
        return value + times**self.power * self.remainder

    def at(self, time: arb) -> arb:
        """The value at a time, over the power of t."""
        return self.polynomial(time) + time**self.power * self.remainder

    def is_positive(self, begin: arb, end: arb) -> bool:
        """True if the guard is proved to be positive between two times."""
        return self.reached(begin, end) is None

    def reached(self, begin: arb, end: arb) -> arb | None:
        """Time to which it is proved to be positive from `begin` on; None if it is positive to `end`."""
        parts, minimum = [(begin, end)], (end - begin) * FINEST
        while parts:
            low, high = parts.pop()
            if self.over(low, high) > 0:
                continue
            if not high - low > minimum:
                return low
            middle = ((low + high) / 2).mid()
            parts += [(middle, high), (low, middle)]
        return None

    def zero_after(self, begin: arb, end: arb) -> arb | None:
        """Enclosure of the guard's only zero between two times, where it falls; None if that is not proved.

        Every function in the tube has one zero in the ball, and is positive before; the slope that
        shows this is checked by the caller at the instant, since a remainder has none.
        """
        root = self._guess(begin, end)
        if root is None:
            return None
        slope = self.slope(root)
        if not slope < 0:
            return None
        radius = (abs(self.at(root) / slope) * arb("1.01")).upper()
        for _ in range(6):
            low, high = (root - radius).mid(), (root + radius).mid()
            if not (low > 0 and high < self.span.reach):
                return None
            if self.at(low) > 0 and self.at(high) < 0:
                return low.union(high)
            radius = (radius * 2 + arb(2) ** -1000).upper()
        return None

    def _guess(self, begin: arb, end: arb) -> arb | None:
        """A time near which the middle of the tube falls through zero; no enclosure."""
        if not (self.at(begin).mid() > 0 and self.at(end).mid() < 0):
            return None
        low, high = begin, end
        for _ in range(20):
            middle = ((low + high) / 2).mid()
            low, high = (middle, high) if self.at(middle).mid() > 0 else (low, middle)
        root = low
        for _ in range(12):
            slope = self.slope(root).mid()
            if slope.is_zero():
                return None
            step = (self.at(root).mid() / slope).mid()
            root = (root - step).mid()
            if not (root >= begin and root <= end):
                return None
            if abs(step) < abs(root) * arb(2) ** (-400):
                break
        return root


EVENTS = {
    "touchdown": "touchdown",
    "apex": "apex",
    "clamp": "clamp",
    "lift-off": "lift_off",
    "slip onset forwards": "slips_forward",
    "slip onset backwards": "slips_backward",
    "end of slip": "comes_to_rest",
    "mid-stance": "mid_stance",
    "greatest compression": "greatest_compression",
    "load": "graze_to_contact",
    "flight": "graze_to_flight",
    "the body's height": "falls",
    "the leg's length": "collapses",
}
"""Events of the page by their names in proofs."""


def _event(name: str, motion: Any) -> Any:
    """An event of the page by its name in proofs."""
    found = EVENTS[name]
    if name == "clamp" and motion.swing == REST:
        found = "release"
    elif name == "apex" and motion.mode == "graze":
        found = "apex_in_graze"
    return motion.marked("is_event")[found]


def guard_of(name: str, motion: Any) -> Number:
    """A guard by its event's name: of a motion of tubes, balls or duals of them."""
    found: Number = _event(name, motion).when(motion)
    return found


def watched(motion: Any) -> list[str]:
    """Names of the guards that may end the mode, without those that are zero for ever."""
    idle = {"greatest compression": not motion.has_thrust, "clamp": not motion.has_servo}
    events = {name: _event(name, motion) for name in EVENTS if not idle.get(name)}
    return [
        name
        for name, event in events.items()
        if motion.mode in event.modes and (event.only is None or event.only(motion))
    ]
