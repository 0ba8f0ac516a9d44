"""Events: what ends a motion or turns it into another, in one table.

An event is due where its guard, positive while the event is to come, has fallen to zero. A guard is a law of
the runner `at` an instant: model, inputs, mode, state, leg, torque and force. The table below says by which
scale it is divided, which modes watch it and in what order events are taken that are due at one instant. What
an event makes of the run is its reset; resets decide, and are written by hand in c_core/model/events.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

from . import coordinates, friction, graze, ground_line, hip
from .functions import Record


def _direction(leg):
    return Record(sine=leg.sine, cosine=leg.cosine)


def touchdown(at):
    """d, the height of the foot over the ground."""
    return ground_line.height_over(at.mode.ground, at.state.foot_x, at.state.foot_y)


def new_ground(at, line):
    """-d, the depth of the foot below a line that waits to be in force."""
    return -ground_line.height_over(line, at.state.foot_x, at.state.foot_y)


def apex(at):
    """vy_c, at which the centre of mass rises; where it does not rise yet, -vy_c."""
    rate = coordinates.center_of_mass(at.model, at.state, _direction(at.leg)).vy
    return rate if at.mode.rises else -rate


def clamp(at):
    """The servo's torque, which closes the clamp of (12) by falling through 0, and opens it by rising."""
    servo = hip.servo_torque(at.model, at.inputs, at.state, "retract", at.mode.liftoff_angle)
    return -servo if at.mode.clamp_closed else servo


def lift_off(at):
    """f_n, the ground's normal force  (10)."""
    return at.force.normal


def slip_onset_positive(at, zone):
    """rho mu f_n + f_t: a foot at rest that reaches the edge of the cone (2) here slips forward."""
    return friction.room(friction.static(at.model, friction.below(at.model, at.inputs, zone)), 1, at.force)


def slip_onset_negative(at, zone):
    """rho mu f_n - f_t: the same, and the foot slips backward."""
    return friction.room(friction.static(at.model, friction.below(at.model, at.inputs, zone)), -1, at.force)


def cone_width(at, zone):
    """max(1, rho mu), by which the room in the cone of a foot at rest is measured."""
    return friction.width(at.model, friction.below(at.model, at.inputs, zone))


def slip_velocity_zero(at, sign):
    """sgn(v_t) v_t, the speed of a foot that slips."""
    return sign * ground_line.along(at.mode.ground, at.state.foot_vx, at.state.foot_vy)


def patch_border(at, forward):
    """How far the foot is from the border of the patch that it slips to, in x."""
    border = friction.border_ahead(at.model, at.mode.zone, forward)
    return border - at.state.foot_x if forward else at.state.foot_x - border


def mid_stance(at):
    """theta: the leg falls through the vertical."""
    return at.state.leg_angle


def greatest_compression(at):
    """-rdot, of a leg that has not been compressed most in this stance."""
    return -at.leg.length_rate


def graze_to_contact(at):
    """-N of the stance law: it loads the foot again."""
    return -graze.force_in_stance(at).normal


def graze_to_flight(at):
    """N of the flight law: it lifts the foot."""
    return graze.force_in_flight(at).normal


def body_down(at):
    """d + r cos theta', the height of the body over the ground: a fall."""
    foot = ground_line.height_over(at.mode.ground, at.state.foot_x, at.state.foot_y)
    return foot + at.leg.length * at.leg.ground_cosine


def leg_too_short(at):
    """r less the least length: a fall."""
    return at.leg.length - at.model.parameters.leg.min_length


class Event(NamedTuple):
    """A row of the table.

    `law` is the guard (None: only C has it), `scale` what divides it; `watched` tells for each contact
    the phases in which it is watched, `only_while` a flag of mode or model that must be set, or with "not"
    must not. `band` is the margin by which a guard is armed: "dead" for a sign that is remembered, "apex"
    for either, with a margin of its own, "by hand" where C arms it. `slack` is what C adds to the guard,
    `width` the law of a further scale, `arguments` are further ones of both laws, with what C hands in.
    `takes` names the reset where it has not the event's name; it is "" where the record alone knows of the
    event.
    """

    name: str
    law: Callable[..., Any] | None
    scale: str
    watched: dict[str, tuple[str, ...]]
    only_while: str = ""
    band: str = ""
    slack: str = ""
    width: Callable[..., Any] | None = None
    arguments: tuple[tuple[str, str], ...] = ()
    takes: str | None = None


ALL = ("drive", "coast", "retract", "place")
ANYWHERE = {"flight": ALL, "stick": ALL, "slip": ALL, "graze": ALL}
ON_GROUND = {"stick": ALL, "slip": ALL, "graze": ALL}
CONTACT = {"stick": ALL, "slip": ALL}
FLIGHT, STICK, SLIP, GRAZE = ({mode: ALL} for mode in ("flight", "stick", "slip", "graze"))
FORWARD, BACKWARD = (f"tdmf_zone_towards(at->model, at->state[TDMF_FOOT_X], {s})" for s in ("1.0", "-1.0"))

# In the order in which those are taken that are due at one instant.
EVENTS = [
    Event("new_ground", new_ground, "length", FLIGHT, band="by hand", arguments=(("line", "&line"),)),
    Event("body_down", body_down, "length", ANYWHERE, takes="fall"),
    Event("leg_too_short", leg_too_short, "length", ANYWHERE, takes="fall"),
    Event(
        "apex",
        apex,
        "speed",
        {"flight": ("retract", "place"), "graze": ("retract",)},
        band="apex",
    ),
    Event(
        "touchdown",
        touchdown,
        "length",
        FLIGHT,
        slack="tdmf_rounding_at_foot(at)",
    ),
    Event(
        "clamp",
        clamp,
        "energy",
        {"flight": ("retract",)},
        only_while="model.parameters.hip.swing_clamp",
        band="dead",
    ),
    Event("greatest_compression", greatest_compression, "speed", CONTACT, only_while="not mode.thrusts"),
    Event("mid_stance", mid_stance, "", ON_GROUND, only_while="mode.mid_stance_pending"),
    Event("lift_off", lift_off, "force", CONTACT),
    Event(
        "slip_onset_positive",
        slip_onset_positive,
        "force",
        STICK,
        width=cone_width,
        arguments=(("zone", FORWARD),),
    ),
    Event(
        "slip_onset_negative",
        slip_onset_negative,
        "force",
        STICK,
        width=cone_width,
        arguments=(("zone", BACKWARD),),
    ),
    Event(
        "slip_velocity_zero",
        slip_velocity_zero,
        "speed",
        SLIP,
        arguments=(("sign", "tdmf_sign_of_slip(at->mode)"),),
    ),
    Event("patch_border", patch_border, "length", SLIP, band="by hand", arguments=(("forward", ""),)),
    Event("force_peak", None, "", CONTACT, band="by hand", takes=""),
    Event("vertical_force_peak", None, "", CONTACT, band="by hand", takes=""),
    Event("graze_to_contact", graze_to_contact, "force", GRAZE),
    Event("graze_to_flight", graze_to_flight, "force", GRAZE),
]

# C of a row: functions that are written by hand, margins, and the modes of each contact.
BY_HAND = {
    "reset": "void tdmf_take_{}(tdmf_run *run)",
    "guard": "double tdmf_armed_{}(const tdmf_evaluation *at)",
}
BANDS = {"": "TDMF_GUARD_MARGIN", "dead": "TDMF_DEAD_BAND", "apex": "TDMF_APEX_MARGIN"}
CONTACTS = {
    "flight": ["FLIGHT"],
    "stick": ["STICK"],
    "slip": ["SLIP_POSITIVE", "SLIP_NEGATIVE"],
    "graze": ["GRAZE"],
}
