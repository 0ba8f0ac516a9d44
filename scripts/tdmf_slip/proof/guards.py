"""What each mode watches: the guards of the events that can end it, positive until then.

Each is a function of the numbers of the motion, of whatever kind. It evaluates the table of events, in
`c_core/equations/events.py`, unless that asks for a foot in axes of the world, or decides about the clamp
anew, which the mode knows here. Falls are guards, too: a stride in which one is not proved to be positive is
undecided.
"""

from collections.abc import Callable
from types import SimpleNamespace as Record
from typing import Any

from ..equations import events, ground
from . import laws
from .dual import Number
from .modes import Mode

Function = Callable[[Any, Mode, Any], Number]
FALLS = ("the body's height", "the leg's length", "the foot's lever in graze")
OUTSIDE = "outside"
"""The zone of a foot: a proof knows of no patch."""


class _Instant:
    """An instant as the table of events has it."""

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
    """A guard of the table."""

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
    speed: Number = ground.slip_velocity_zero(at.foot_speed, mode.sign)
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
"""By the event's name."""


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
