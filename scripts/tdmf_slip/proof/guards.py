"""Guards of the events that can end each mode, positive until then.

Each is a function of the numbers of the motion, of whatever kind. It evaluates the guards in
`c_core/equations/events.py`, unless one asks for a foot in axes of the world, or decides about the clamp
anew, which the mode knows here. Falls are guards, too: a stride in which one is not proved to be positive is
undecided.

Signs and zeros of guards along a step, proved.

A guard is a tube. It may begin at exactly zero, to an order that follows from the rules of the event
before: the terms that are zero by them are dropped, and what is left is divided by that power of t.
"""

from collections.abc import Callable
from types import SimpleNamespace as Record
from typing import Any

from flint import arb, arb_poly

from ..equations import events
from . import laws
from .dual import Number
from .flow import Tube
from .parameters import Mode

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
        """Whether it is proved to be positive between two times."""
        return self.reached(begin, end) is None

    def reached(self, begin: arb, end: arb) -> arb | None:
        """Up to where it is proved to be positive from one time on; None where that is all of it."""
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
        """Times of its only zero between two times, where it falls through it; None where that is not proved.

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


Function = Callable[[Any, Mode, Any], Number]
FALLS = ("the body's height", "the leg's length", "the foot's lever in graze")
OUTSIDE = "outside"
"""The zone of a foot: a proof knows of no patch."""


class _Instant:
    """An instant as the guards of events read it."""

    def __init__(self, runner: Any, mode: Mode, at: Any) -> None:
        self.model, self.inputs, self.leg = runner.model, runner.inputs, at
        self.mode = Record(clamp_closed=mode.clamped, liftoff_angle=getattr(at, "latched_angle", None))
        self.state = Record(leg_angle=at.angle, leg_angle_rate=at.angle_rate, hip_place_time=0)
        self._of = runner, mode, at

    @property
    def force(self) -> Any:
        """Force that would hold the foot still under the stance law."""
        runner, mode, at = self._of
        axial = laws.axial_force(*self._of)
        return laws.holding_force(runner, at, axial, laws.stance_torque(runner, mode) / at.length)


def _row(guard: Callable[..., Any], **more: Any) -> Function:
    """A guard by its law."""

    def evaluated(runner: Any, mode: Mode, at: Any) -> Number:
        found: Number = guard(_Instant(runner, mode, at), **more)
        return found

    evaluated.__doc__ = guard.__doc__
    return evaluated


normal_force = _row(events.lift_off)
cone_forwards = _row(events.slip_onset_positive, zone=OUTSIDE)
cone_backwards = _row(events.slip_onset_negative, zone=OUTSIDE)
servo = _row(events.clamp)


def slip_speed(runner: Any, mode: Mode, at: Any) -> Number:
    """The foot's speed in the direction of its slip."""
    speed: Number = mode.sign * at.foot_speed
    return speed


def foot_height(runner: Any, mode: Mode, at: Any) -> Number:
    """Guard of a foot in flight: touchdown."""
    return laws.foot_height(runner, at)


def rise(runner: Any, mode: Mode, at: Any) -> Number:
    """The vertical velocity of the centre of mass, off the ground: apex."""
    if mode.contact == "flight":
        return laws.rise(runner, at.along, at.off)
    center = laws.fly(runner, at, at.foot_speed)
    return laws.rise(runner, center.along, center.off)


def unloading(runner: Any, mode: Mode, at: Any) -> Number:
    """-f_n under the stance law, in graze: the foot is loaded where it falls through 0."""
    return -normal_force(runner, mode, at)


def holding(runner: Any, mode: Mode, at: Any) -> Number:
    """f_n under the flight law, in graze: the foot flies where it falls through 0."""
    axial = laws.axial_force(runner, mode, at)
    return laws.holding_force(runner, at, axial, laws.flight_torque(runner, mode, at) / at.length).normal


def body_height(runner: Any, mode: Mode, at: Any) -> Number:
    """Guard of the body above the line: a fall."""
    if mode.contact == "flight":
        return at.height + (1 - runner.model.body_share) * laws.body_over_foot(at)
    return laws.body_over_foot(at)


FUNCTIONS: dict[str, Function] = {
    "touchdown": foot_height,
    "apex": rise,
    "clamp": servo,
    "lift-off": normal_force,
    "slip onset forwards": cone_forwards,
    "slip onset backwards": cone_backwards,
    "end of slip": slip_speed,
    "mid-stance": _row(events.mid_stance),
    "greatest compression": _row(events.greatest_compression),
    "load": unloading,
    "flight": holding,
    "the body's height": body_height,
    "the leg's length": _row(events.leg_too_short),
}
"""Guards by the event's name."""


def watched(runner: Any, mode: Mode) -> tuple[str, ...]:
    """Names of the guards of a mode."""
    names: list[str] = ["the body's height", "the leg's length"]
    if mode.touches:
        names.append("lift-off")
        names += (
            ["end of slip"] if mode.contact == "slip" else ["slip onset forwards", "slip onset backwards"]
        )
        if runner.has_thrust and not mode.thrusts:
            names.append("greatest compression")
    else:
        names += ["touchdown"] if mode.contact == "flight" else ["load", "flight"]
        if mode.rises:
            names.append("apex")
        if not mode.places and runner.has_clamp:
            names.append("clamp")
    if mode.drives and mode.contact != "flight":
        names.append("mid-stance")
    return tuple(names)
