"""What each mode watches: the guards of the events that can end it, positive until then.

Each is a function of the numbers of the motion, of whatever kind. Falls are guards, too: a stride in which
one is not proved to be positive is undecided.
"""

from collections.abc import Callable
from typing import Any

from ..equations import friction
from . import laws
from .dual import Number
from .modes import Mode

Function = Callable[[Any, Mode, Any], Number]
FALLS = ("the body's height", "the leg's length", "the foot's lever in graze")


def _force(runner: Any, mode: Mode, at: Any) -> Any:
    """What would hold the foot still under the stance law."""
    axial = laws.axial_force(runner, mode, at)
    return laws.holding_force(runner, at, axial, laws.stance_torque(runner, mode) / at.length)


def normal_force(runner: Any, mode: Mode, at: Any) -> Number:
    """f_n under the stance law: lift-off where it falls through 0."""
    return _force(runner, mode, at).normal


def cone_forwards(runner: Any, mode: Mode, at: Any) -> Number:
    """Rho mu f_n + f_t: slip onset forwards where it falls through 0."""
    return friction.room(laws.static_friction(runner), 1, _force(runner, mode, at))


def cone_backwards(runner: Any, mode: Mode, at: Any) -> Number:
    """Rho mu f_n - f_t: slip onset backwards."""
    return friction.room(laws.static_friction(runner), -1, _force(runner, mode, at))


def slip_speed(runner: Any, mode: Mode, at: Any) -> Number:
    """The foot's speed in the direction of its slip."""
    return at.foot_speed * mode.sign


def leg_angle(runner: Any, mode: Mode, at: Any) -> Number:
    """Theta in drive: mid-stance where it falls through 0."""
    return at.angle


def shortening(runner: Any, mode: Mode, at: Any) -> Number:
    """-rdot before the thrust: greatest compression."""
    return -at.length_rate


def foot_height(runner: Any, mode: Mode, at: Any) -> Number:
    """Of a foot in flight: touchdown."""
    return laws.foot_height(runner, at)


def rise(runner: Any, mode: Mode, at: Any) -> Number:
    """The vertical velocity of the centre of mass, off the ground: apex."""
    if mode.contact == "flight":
        return laws.rise(runner, at.along, at.off)
    center = laws.fly(runner, at, at.foot_speed)
    return laws.rise(runner, center.along, center.off)


def servo(runner: Any, mode: Mode, at: Any) -> Number:
    """What the clamp is decided by, positive while it stays as it is."""
    torque = laws.servo_torque(runner, mode, at)
    return -torque if mode.clamped else torque


def unloading(runner: Any, mode: Mode, at: Any) -> Number:
    """-f_n under the stance law, in graze: the foot is loaded where it falls through 0."""
    return -normal_force(runner, mode, at)


def holding(runner: Any, mode: Mode, at: Any) -> Number:
    """f_n under the flight law, in graze: the foot flies where it falls through 0."""
    axial = laws.axial_force(runner, mode, at)
    return laws.holding_force(runner, at, axial, laws.flight_torque(runner, mode, at) / at.length).normal


def body_height(runner: Any, mode: Mode, at: Any) -> Number:
    """Of the body above the line: a fall."""
    if mode.contact == "flight":
        return at.height + (1 - runner.model.body_share) * laws.body_over_foot(at)
    return laws.body_over_foot(at)


def leg_room(runner: Any, mode: Mode, at: Any) -> Number:
    """Of the leg above its least length: a fall."""
    return at.length - runner.min_length


FUNCTIONS: dict[str, Function] = {
    "touchdown": foot_height,
    "apex": rise,
    "clamp": servo,
    "lift-off": normal_force,
    "slip onset forwards": cone_forwards,
    "slip onset backwards": cone_backwards,
    "end of slip": slip_speed,
    "mid-stance": leg_angle,
    "greatest compression": shortening,
    "load": unloading,
    "flight": holding,
    "the body's height": body_height,
    "the leg's length": leg_room,
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
        if not mode.places and runner.has_servo:
            names.append("clamp")
    if mode.drives and mode.contact != "flight":
        names.append("mid-stance")
    return tuple(names)
