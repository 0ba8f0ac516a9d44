"""The motions: what each is told in its cases, what of it is stored, and who watches its events.

The laws of a motion are on its page. This page is a table, as that of the events is.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

from . import constants, flight, friction, ground, hip


class Family(NamedTuple):
    """Motions of one page that share the structs of their series.

    `start` is what a motion starts with, `constants` the law that gives what it depends on. Of that `ramps`
    change in time, by the word "drift" in any width, by "ramp" where inputs ramp. `rates` are quantities that
    are rates of others; the series that are `stored` are asked for, and those `varied` have variations.
    `cases` tell the page what it asks, and of a case what else is stored, and that nothing ramps.
    """

    name: str
    page: Any
    start: str
    constants: Callable[..., Any]
    ramps: dict[str, str]
    rates: dict[str, str]
    stored: str
    varied: str
    cases: dict[str, dict[str, Any]]


GROUND = Family(
    name="ground",
    page=ground,
    start="x y vx vy foot_vx",
    constants=constants.on_ground,
    ramps=dict.fromkeys(("rest_length", "gravity_x", "gravity_y", "friction", "torque"), "ramp"),
    rates={"length_rate": "length"},
    stored="length length_rate normal_force tangential_push along off torque power speed_square",
    varied="torque power friction_power",
    cases={
        # Without a torque the leg does not turn; where one varies, the variation is that of a leg that does.
        "stick": {"contact": "stick", "has_torque": False, "stored": "square turning"},
        "stick_with_torque": {"contact": "stick", "has_torque": True},
        "slip": {"contact": "slip", "has_torque": False, "stored": "square turning friction_power"},
        "slip_with_torque": {"contact": "slip", "has_torque": True, "stored": "friction_power"},
        "falling_slip": {"contact": "slip", "has_torque": True, "falls": True, "stored": "friction_power"},
        "graze": {"contact": "graze", "has_torque": True, "stored": "angle_rate axial_y"},
    },
)
FLIGHT = Family(
    name="flight",
    page=flight,
    start="length angle length_rate angle_rate",
    constants=constants.of_flight,
    ramps={"torque": "drift", "rest_length": "ramp", "push_x": "ramp", "push_y": "ramp"},
    rates={},
    stored="square angle_rate rate_square speed_square",
    varied="torque power",
    cases={
        "flight": {"pushed": False, "ramp": False},
        "pushed_flight": {"pushed": True, "stored": "push_moment"},
    },
)
MOTIONS = {family.name: family for family in (FLIGHT, GROUND)}
# Structs of the model, and the cases of each header, whose first part is the name of its motion or of a mode.
COORDINATES = {"flight": "tdmf_flying", "ground": "tdmf_standing"}
HEADERS = {
    "ground": ("ground", []),
    "stick": ("ground", ["stick", "stick_with_torque"]),
    "slip": ("ground", ["slip", "slip_with_torque"]),
    "falling_slip": ("ground", ["falling_slip"]),
    "graze": ("ground", ["graze"]),
    "flight": ("flight", ["flight", "pushed_flight"]),
}

# ---- guards as series --------------------------------------------------------------------------------------

# Laws of series of a motion, in one header: what a law is handed that is none of these is constant, or a
# struct of such. Of the last a law alone is wanted, of numbers.
STRUCTS = {"law": ("signed_law", hip.signed), "cone": ("friction_cone", friction.cone)}
GUARDS = [ground.ahead, ground.room, ground.rise, ground.lever, ground.load, hip.torque, flight.drop]
OF_NUMBERS = [friction.smallest_room]

# ---- who watches -------------------------------------------------------------------------------------------

# The modes of each motion, and by which flags of the case those are told that watch an event.
MODES = {"flight": ("flight",), "ground": ("stick", "slip", "graze")}
CASES = {
    ("stick", "slip"): "!is.grazes",
    ("stick",): "!is.slips && !is.grazes",
    ("slip",): "is.slips",
    ("graze",): "is.grazes",
}
# Flags of the mode that must be set, or must not, as the lanes have them.
FLAGS = {"not mode.thrusts": "c->awaits_thrust > 0.0"}
# Parameters that guards are made of, as the table's laws have them.
PARAMETERS = "at->model->parameters."
FORCES = "watch_forces(search, c, s, !is.slips, !is.slips && is.meets_border);"
GRAZE = "watch_graze(search, c, s, at->angle);"
HEIGHTS = "watch_heights(search, c, s, tolerance, s->length[0] + length_change, com);"
# What is more than one series, or is seen more cheaply for several events at once: calls of the kernel.
BY_HAND = {
    "flight": {
        "new_ground": "if (is.awaits_ground) {watch_new_ground(search, c, s, tolerance, com);}",
        "body_down": HEIGHTS,
        "touchdown": HEIGHTS,
        "apex": "watch_apex(search, c, com, is.rising);",
        "clamp": "if (is.clamped) {watch_clamp(search, c, s);}",
    },
    "ground": {
        "mid_stance": "watch_mid_stance(search, c, s);",
        **dict.fromkeys(("lift_off", "slip_onset_positive", "slip_onset_negative"), FORCES),
        "patch_border": "if (is.meets_border) {watch_patch_border(search, c, s, at);}",
        **dict.fromkeys(("apex", "graze_to_contact", "graze_to_flight"), GRAZE),
    },
}
GIVEN = {
    "flight": "const ballistic *com, flight_case is, real length_change, double tolerance",
    "ground": "const ground_coordinates *at, ground_case is, real length_change",
}
