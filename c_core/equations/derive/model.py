"""Which laws are C functions of the model: a header a topic, a line a function.

A line tells the C type and name, and the law. Where C's parameters are not those of the law, they are told,
and the call. Behind a bar: `value x`, the parameter by which a variation is given the value, or `only` for
no variation.
"""

import importlib
import re
from collections.abc import Callable
from functools import partial
from typing import Any

from .. import coordinates, hip, leg
from . import events, expressions
from .c import comment, header, struct
from .values import Function, given, members

TYPES = {
    "state": "const double[TDMF_STATE_COUNT]",
    "written": "double[TDMF_STATE_COUNT]",
    "rates": "const tdmf_inputs *",
    "line": "const tdmf_ground_line *",
    "law": "const tdmf_hip_law *",
    "at": "const tdmf_evaluation *",
    "direction": "tdmf_leg_direction",
    "contact": "tdmf_contact_mode",
    "zone": "tdmf_zone",
    "force": "tdmf_ground_force",
    "leg_acceleration": "tdmf_leg_rates",
    **{name: f"const tdmf_{name} *" for name in ("model", "inputs", "mode", "leg", "standing", "flying")},
    **dict.fromkeys(("body", "center", "start"), "tdmf_point"),
    **dict.fromkeys(("push", "acceleration", "free_body", "jerk", "foot"), "tdmf_vector"),
    **dict.fromkeys(("upright", "sticks", "falls", "forward"), "bool"),
}
FIXED = ("direction", "sign", "sine", "winding", "place_rate")

FUNCTIONS = """
runner
    tdmf_mass_constants mass_constants_of(model) =
        runner.derived(model.parameters.body.mass, model.parameters.foot.mass) | value constants
ground_line
    double velocity_along(line, vx, vy) = ground_line.along(line, vx, vy)
    double velocity_off(line, vx, vy) = ground_line.off(line, vx, vy) | only
    double offset_along = ground_line.offset_along
    double height_over = ground_line.height_over
    double ground_height_at = ground_line.height_at
    double path_to = ground_line.path_to
    tdmf_point point_on = ground_line.point_on
    tdmf_vector vector_on = ground_line.vector_on
hip
    tdmf_hip_law external_law = hip.external
    tdmf_hip_law stance_law(model, inputs, rates, mode) =
        hip.stance(model, inputs, rates, mode.mid_stance_pending)
    tdmf_hip_law servo(model, inputs, mode, place_time) =
        hip.servo(model, inputs, mode.phase, mode.liftoff_angle, place_time)
    tdmf_hip_law flight_law(model, inputs, rates, mode, place_time) =
        hip.flight(model, inputs, rates, mode.phase, mode.clamp_closed, mode.liftoff_angle, place_time)
    double servo_torque(model, inputs, mode, state) =
        hip.servo_torque(model, inputs, state, mode.phase, mode.liftoff_angle)
    double torque_in = hip.torque_in_mode | value torque
    tdmf_hip_law law_after = hip.after | only
    void begin_place = hip.begin_place
leg
    double leg_thrust = leg.thrust | only
    double rest_length(model, inputs, mode) = leg.rest_length(model, inputs, mode.thrusts)
    tdmf_leg leg_with(model, line, state, direction, rest_length) =
        leg.evaluate(model, line, state, direction, rest_length, leg.bounded_length(model, state)) | value leg
    double leg_power(model, rest_length, length, rest_length_rate) =
        leg.power(model.parameters.leg.stiffness, rest_length, length, rest_length_rate) | only
    double leg_work_of_jump(model, length, before, after) =
        leg.work_of_jump(model.parameters.leg.stiffness, length, before, after)
friction
    double friction_below = friction.below
    double border_ahead = friction.border_ahead
    double static_friction = friction.static
    double sliding_friction = friction.sliding
    double friction_excess = friction.excess
    double friction_fading = friction.fading
    double friction_growth_rate = friction.growth_rate | only
    double stopped_speed = friction.stopped_speed | only
    double cone_width = friction.width | only
    tdmf_cone cone_of = friction.cone | only
ground_force
    tdmf_ground_force force_under = ground_force.under | only
    tdmf_ground_force force_in = ground_force.in_mode
graze
    tdmf_ground_force force_in_stance = graze.force_in_stance | only
    tdmf_ground_force force_in_flight = graze.force_in_flight | only
free_fall
    tdmf_vector push_on_body = free_fall.push_on_body
    tdmf_vector body_acceleration = free_fall.of_body
    tdmf_vector com_acceleration = free_fall.of_center
    tdmf_point ballistic_after = free_fall.ballistic
coordinate
    tdmf_point body_from_foot = coordinates.body_from_foot
    tdmf_point body_along = coordinates.body
    tdmf_point center_of_mass_along = coordinates.center_of_mass
    tdmf_point foot_below = coordinates.foot_below
    tdmf_leg_rates leg_rates_with_foot = coordinates.leg_rates_with_foot | only
    tdmf_point foot_over = coordinates.foot_over_ground | only
    tdmf_flying flying_of = coordinates.in_flight | only
    void state_of_flying = coordinates.from_flight | only
    tdmf_standing standing_of = coordinates.on_ground
    void state_of_standing(line, standing, winding) =
        coordinates.from_ground(line, standing, winding) | value state
    double angle_seen = coordinates.angle_seen | only
dynamics
    tdmf_vector acceleration_of_foot = dynamics.foot_acceleration
    tdmf_leg_rates acceleration_of_leg = dynamics.leg_acceleration
    double external_power = dynamics.external_power
    void rates_with = dynamics.rates
prescribed_flight
    void placed_leg = prescribed_flight.placed_leg
    void prescribed_rates = prescribed_flight.rates | only
    double rise_time = prescribed_flight.time_to_apex
impact
    tdmf_after_impact impact_with = impact.after
energy
    tdmf_energy energy_with = energy.mechanical
constant
    flight_coefficients flight_coefficients_of = constants.of_flight
    ground_coefficients ground_coefficients_of = constants.on_ground
    signed_law signed_law = hip.signed | only
"""
STRUCTS = {"constant": "coefficients.h"}
RECORDS = {
    "hip": (comment(hip.law_of.__doc__) + struct("tdmf_hip_law", vars(hip.law_of())),),
    "coordinate": tuple(
        comment(law.__doc__) + struct(name, members(law))
        for name, law in (("tdmf_flying", coordinates.in_flight), ("tdmf_standing", coordinates.on_ground))
    ),
}
LINE = re.compile(r"(\w+) (\w+)(?:\((.*)\))? = (\w+)\.(\w+)(?:(\(.*\)))?(?: \| (value|only) ?(\w*))?")


def function(line: str) -> Function:
    """Give the function that a line tells."""
    matched = LINE.fullmatch(line)
    assert matched, line
    result, name, parameters, page, law_name, call, note, value = matched.groups()
    pages = {page: importlib.import_module(f"..{page}", __package__), "leg": leg}
    law = getattr(pages[page], law_name)
    names = parameters.split(", ") if parameters else expressions.parameters(law)
    call = call or f"({''.join(f'{name}, ' for name in names)})"

    def arguments(*handed: Any) -> Any:
        known = dict(zip(names, handed, strict=True))
        if "direction" in known and "state" in known:  # C has them already
            known["direction"] = given("direction", leg.direction(known["state"].leg_angle))
        return eval(call, {**pages, **known})

    return Function(
        result,
        name,
        {name: TYPES.get(name, "double") for name in (*names, *(["written"] if result == "void" else []))},
        law,
        arguments,
        fixed=FIXED,
        value=value or "",
        varied=note != "only",
    )


def headers() -> dict[str, Callable[[], str]]:
    """Give what writes each header."""
    topics = re.findall(r"^(\w+)\n((?: .*\n)*)", FUNCTIONS, re.MULTILINE)
    lines = {topic: re.sub(r" =\n +", " = ", text).strip().split("\n") for topic, text in topics}
    return {
        f"{topic}_laws.h": partial(laws, topic, [line.strip() for line in lines[topic]]) for topic in lines
    } | {"guard_laws.h": partial(events.guards, TYPES)}


def laws(topic: str, lines: list[str]) -> str:
    """Write the header of a topic."""
    functions = [function(line) for line in lines]
    page = functions[0].law.__module__.rpartition(".")[2]
    includes = f'#include "{STRUCTS.get(topic, "quantities.h")}"\n\n#include <math.h>\n'
    return header(
        f"{topic}_laws", f"{page}.py", includes, *RECORDS.get(topic, ()), *(f.c() for f in functions)
    )
