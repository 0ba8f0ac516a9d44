"""What C has of the laws: functions, a header a topic; the types of what they are handed; words and flags.

This page is a table, as that of the events is: no law stands here.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

from . import (
    coordinates,
    dynamics,
    energy,
    free_fall,
    friction,
    graze,
    ground_force,
    ground_line,
    hip,
    impact,
    leg,
    runner,
)


class InC(NamedTuple):
    """A law that is a function of C.

    `declared` is the type of what it gives, "void" for what is written to a state, and the function's name.
    `call` makes of the parameters of C those of the law, where they are not the same. `value` is the name
    of the parameter by which a variation is given the value; one that is not `varied` has none.
    """

    declared: str
    law: Callable[..., Any]
    call: Callable[..., Any] | None = None
    value: str = ""
    varied: bool = True


FUNCTIONS = {
    "runner": [
        InC(
            "tdmf_mass_constants mass_constants_of",
            runner.derived,
            lambda model: (model.parameters.body.mass, model.parameters.foot.mass),
            value="constants",
        ),
    ],
    "ground_line": [
        InC("double velocity_along", ground_line.along, varied=False),
        InC("double velocity_off", ground_line.off, varied=False),
        InC("double offset_along", ground_line.offset_along, varied=False),
        InC("double height_over", ground_line.height_over, varied=False),
        InC("double ground_height_at", ground_line.height_at),
        InC("tdmf_point point_on", ground_line.point_on, varied=False),
        InC(
            "tdmf_vector vector_on",
            ground_line.vector_on,
            lambda line, force: (line, force.tangential, force.normal),
        ),
    ],
    "hip": [
        InC(
            "double servo_torque",
            hip.servo_torque,
            lambda model, inputs, mode, state: (model, inputs, state, mode.phase, mode.liftoff_angle),
            varied=False,
        ),
        InC("double torque_in", hip.torque_in_mode, value="torque"),
        InC("double place_time_rate", hip.place_time_rate, lambda mode: (mode.phase,), varied=False),
        InC("void begin_place", hip.begin_place, varied=False),
        InC("void end_place", hip.end_place, varied=False),
    ],
    "leg": [
        InC(
            "double rest_length",
            leg.rest_length,
            lambda model, inputs, mode: (model, inputs, mode.thrusts),
            varied=False,
        ),
        InC(
            "tdmf_leg leg_along",
            leg.evaluate,
            lambda model, inputs, mode, state, direction: (
                model,
                mode.ground,
                state,
                direction,
                leg.rest_length(model, inputs, mode.thrusts),
                leg.bounded_length(model, state),
            ),
            value="leg",
        ),
        InC(
            "double leg_power",
            leg.power,
            lambda model, rest_length, length, rest_length_rate: (
                model.parameters.leg.stiffness,
                rest_length,
                length,
                rest_length_rate,
            ),
            varied=False,
        ),
        InC(
            "double leg_work_of_jump",
            leg.work_of_jump,
            lambda model, length, before, after: (model.parameters.leg.stiffness, length, before, after),
            varied=False,
        ),
        InC("double leg_work_between", leg.work_between),
    ],
    "friction": [
        InC(
            "double static_friction",
            friction.static,
            lambda model, inputs, zone: (model, friction.below(model, inputs, zone)),
            varied=False,
        ),
        InC(
            "double signed_friction",
            friction.sliding,
            lambda model, inputs, zone, sign: (friction.below(model, inputs, zone), sign),
            varied=False,
        ),
        InC("double friction_excess", friction.excess, varied=False),
        InC("double friction_fading", friction.fading, varied=False),
        InC("double friction_growth_rate", friction.growth_rate, varied=False),
        InC(
            "double stopped_speed",
            friction.stopped_speed,
            lambda model, inputs, zone, compression, falls: (
                model,
                friction.below(model, inputs, zone),
                compression,
                falls,
            ),
            varied=False,
        ),
        InC("double room_in_cone", friction.room, varied=False),
    ],
    "ground_force": [
        InC("tdmf_ground_force force_under", ground_force.under, varied=False),
        InC(
            "tdmf_ground_force force_in",
            ground_force.in_mode,
            lambda at, sign, falls: (
                at.model,
                friction.below(at.model, at.inputs, at.mode.zone),
                at.mode.ground,
                at.state,
                at.leg,
                at.torque,
                at.mode.contact,
                sign,
                falls,
            ),
        ),
    ],
    "graze": [
        InC("tdmf_ground_force force_in_stance", graze.force_in_stance, varied=False),
        InC("tdmf_ground_force force_in_flight", graze.force_in_flight, varied=False),
    ],
    "free_fall": [
        InC("tdmf_point ballistic_under", free_fall.center_of_mass, varied=False),
    ],
    "coordinate": [
        InC("tdmf_point body_from_foot", coordinates.body_from_foot, varied=False),
        InC("tdmf_point body_along", coordinates.body),
        InC("tdmf_point center_of_mass_along", coordinates.center_of_mass),
        InC("void set_foot_velocity_along", coordinates.with_foot_velocity, varied=False),
        InC("tdmf_point foot_over", coordinates.foot_over_ground, varied=False),
    ],
    "dynamics": [
        InC(
            "double external_power",
            dynamics.external_power,
            lambda at: (at.inputs, coordinates.body(at.state, at.leg)),
        ),
        InC("void rates_at", dynamics.rates),
    ],
    "impact": [
        InC("tdmf_after_impact impact_with", impact.after),
    ],
    "energy": [
        InC(
            "tdmf_energy energy_with",
            energy.mechanical,
            lambda model, state, leg: (model, state, leg, leg.rest_length),
        ),
    ],
}

# By the names of parameters; all others are numbers.
TYPES = {
    "state": "const double[TDMF_STATE_COUNT]",
    "written": "double[TDMF_STATE_COUNT]",
    "rates": "const tdmf_inputs *",
    "line": "const tdmf_ground_line *",
    "at": "const tdmf_evaluation *",
    "direction": "tdmf_leg_direction",
    "contact": "tdmf_contact_mode",
    "zone": "tdmf_zone",
    "force": "tdmf_ground_force",
    **{name: f"const tdmf_{name} *" for name in ("model", "inputs", "mode", "leg")},
    **dict.fromkeys(("before_mode", "after_mode"), "const tdmf_mode *"),
    "start": "tdmf_point",
    **dict.fromkeys(("upright", "sticks", "falls", "forward"), "bool"),
}
# Parameters that do not change in a variation, besides those of a type that cannot.
FIXED = ("direction", "sign", "sine")
WITHOUT_VARIATION = (
    "bool",
    "int",
    "tdmf_contact_mode",
    "tdmf_hip_phase",
    "tdmf_zone",
)

# What has sine and cosine of an angle, and where C has that, after its own name and the arrow or point.
ANGLES = {"line": "{}slope", "ground": "{}slope", "direction": "state[TDMF_LEG_ANGLE]"}

# Words of a mode, and flags of mode or model, which a law may branch on; and structs that are handed on by
# pointer.
WORDS = {"contact": "TDMF_CONTACT_", "phase": "TDMF_PHASE_", "zone": "TDMF_ZONE_"}
FLAGS = (
    "clamp_closed",
    "thrusts",
    "mid_stance_pending",
    "drives",
    "sticks",
    "falls",
    "upright",
    "rises",
    "forward",
    "swing_clamp",
)
POINTERS = ("model", "inputs", "mode")
