"""Which laws are C functions of the model: a header a topic, a line a function.

A line tells the C type, the function's name and parameters, and the call of the law. Behind a bar: `value x`,
the parameter by which a variation is given the value, or `only` for no variation.
"""

import importlib
import re
from collections.abc import Callable
from functools import partial
from typing import Any

from .. import hip
from ..events import EVENTS
from .values import Function, given, header, struct

PAGES = (
    "constants coordinates dynamics energy events free_fall friction graze ground_force ground_line hip "
    "impact leg runner"
)
POINTERS = {
    "model": "tdmf_model",
    "inputs": "tdmf_inputs",
    "rates": "tdmf_inputs",
    "mode": "tdmf_mode",
    "line": "tdmf_ground_line",
    "leg": "tdmf_leg",
    "law": "tdmf_hip_law",
    "at": "tdmf_evaluation",
    "standing": "tdmf_standing",
}
VALUES = {
    "direction": "tdmf_leg_direction",
    "contact": "tdmf_contact_mode",
    "force": "tdmf_ground_force",
    "body": "tdmf_point",
    "center": "tdmf_point",
    "start": "tdmf_point",
    "push": "tdmf_vector",
    "fall": "tdmf_vector",
    "jerk": "tdmf_vector",
    "foot": "tdmf_vector",
    "acceleration": "tdmf_leg_rates",
    "upright": "bool",
    "sticks": "bool",
}
FIXED = ("direction", "sign", "sine", "turns", "place_rate")

FUNCTIONS = """
runner
    tdmf_mass_constants mass_constants_of(model) =
        runner.derived(model.parameters.body.mass, model.parameters.foot.mass) | value constants
ground_line
    double velocity_along(line, vx, vy) = ground_line.along(line, vx, vy)
    double velocity_off(line, vx, vy) = ground_line.off(line, vx, vy) | only
    double place_along(line, x, y) = ground_line.place_along(line, x, y)
    double height_over(line, x, y) = ground_line.height_over(line, x, y)
    double ground_height_at(line, x) = ground_line.height_at(line, x)
    double path_to(line, x) = ground_line.path_to(line, x)
    tdmf_point point_on(line, along, velocity) = ground_line.point_on(line, along, velocity)
    tdmf_vector vector_on(line, tangential, normal) = ground_line.vector_on(line, tangential, normal)
hip
    tdmf_hip_law external_law(inputs, rates) = hip.external(inputs, rates)
    tdmf_hip_law stance_law(model, inputs, rates, mode) =
        hip.stance(model, inputs, rates, mode.mid_stance_pending)
    tdmf_hip_law servo(model, inputs, mode, place_time) =
        hip.servo(model, inputs, mode.phase, mode.liftoff_angle, place_time)
    tdmf_hip_law flight_law(model, inputs, rates, mode, place_time) =
        hip.flight(model, inputs, rates, mode.phase, mode.clamp_closed, mode.liftoff_angle, place_time)
    double servo_torque(model, inputs, mode, state) =
        hip.servo_torque(model, inputs, state, mode.phase, mode.liftoff_angle)
    double torque_in(model, inputs, mode, state, leg, upright, sine) =
        hip.torque_in_mode(model, inputs, mode, state, leg, upright, sine) | value torque
    tdmf_hip_law law_after(law, elapsed) = hip.after(law, elapsed) | only
leg
    double leg_thrust(model, inputs) = leg.thrust(model, inputs) | only
    double rest_length(model, inputs, mode) = leg.rest_length(model, inputs, mode.thrusts)
    tdmf_leg leg_with(model, line, state, direction, rest_length) =
        leg.evaluate(model, line, state, direction, rest_length, leg.bounded_length(model, state)) | value leg
    double leg_power(model, rest_length, length, rest_length_rate) =
        leg.power(model.parameters.leg.stiffness, rest_length, length, rest_length_rate) | only
    double leg_work_of_jump(model, length, before, after) =
        leg.work_of_jump(model.parameters.leg.stiffness, length, before, after)
friction
    double static_friction(model, inputs) = friction.static(model, inputs)
    double sliding_friction(inputs, sign) = friction.sliding(inputs, sign)
    double cone_width(model, inputs) = friction.width(model, inputs) | only
    tdmf_cone cone_of(friction) = friction.cone(friction) | only
ground_force
    tdmf_ground_force force_under(model, line, leg, torque) =
        ground_force.under(model, line, leg, torque) | only
    tdmf_ground_force force_in(model, inputs, line, leg, torque, contact, sign) =
        ground_force.in_mode(model, inputs, line, leg, torque, contact, sign)
graze
    tdmf_ground_force force_in_stance(model, inputs, mode, state, leg) =
        graze.force_in_stance(model, inputs, mode, state, leg) | only
    tdmf_ground_force force_in_flight(model, inputs, mode, state, leg) =
        graze.force_in_flight(model, inputs, mode, state, leg) | only
free_fall
    tdmf_vector push_on_body(model, inputs) = free_fall.push_on_body(model, inputs)
    tdmf_vector fall_of_body(model, push) = free_fall.of_body(model, push)
    tdmf_vector fall_of_center(model, push) = free_fall.of_center(model, push)
    tdmf_point ballistic_after(start, fall, jerk, time) = free_fall.ballistic(start, fall, jerk, time)
coordinate
    tdmf_point body_from_foot(state, direction) = coordinates.body_from_foot(state, direction)
    tdmf_point body_along(state, direction) = coordinates.body(state, direction)
    tdmf_point center_of_mass_along(model, state, direction) =
        coordinates.center_of_mass(model, state, direction)
    tdmf_point foot_below(model, center, state, direction) =
        coordinates.foot_below(model, center, state, direction)
    tdmf_leg_rates leg_rates_with_foot(state, direction, vx, vy) =
        coordinates.leg_rates_with_foot(state, direction, vx, vy) | only
    tdmf_point foot_over(line, state) = coordinates.foot_over_ground(line, state) | only
    tdmf_standing standing_of(line, state, direction) = coordinates.on_ground(line, state, direction)
    void state_of_standing(line, standing, turns, written) =
        coordinates.from_ground(line, standing, turns) | value state
    double angle_seen(x, y, slope) = coordinates.angle_seen(x, y, slope) | only
    double angle_rate_of(momentum, length) = coordinates.angle_rate(momentum, length)
dynamics
    tdmf_vector acceleration_of_foot(model, line, leg, torque, force, contact) =
        dynamics.foot_acceleration(model, line, leg, torque, force, contact)
    tdmf_leg_rates acceleration_of_leg(model, leg, torque, fall, foot) =
        dynamics.leg_acceleration(model, leg, torque, fall, foot)
    double external_power(inputs, body) = dynamics.external_power(inputs, body)
    void rates_with(model, state, leg, torque, force, foot, acceleration, slip_velocity, place_rate,
        external_power, written) = dynamics.rates(model, state, leg, torque, force, foot, acceleration,
        slip_velocity, place_rate, external_power)
impact
    tdmf_after_impact impact_with(model, inputs, line, state, direction, sign, sticks) =
        impact.after(model, inputs, line, state, direction, sign, sticks)
energy
    tdmf_energy energy_with(model, state, direction, rest_length) =
        energy.mechanical(model, state, direction, rest_length)
constant
    flight_coefficients flight_coefficients_of(model, law, rest_length, push) =
        constants.of_flight(model, law, rest_length, push)
    ground_coefficients ground_coefficients_of(model, line, law, rest_length, push, friction) =
        constants.on_ground(model, line, law, rest_length, push, friction)
    hip_law signed_law(law, sign) = hip.signed(law, sign) | only
guard
"""
for event in (event for event in EVENTS if event.law is not None):
    parameters = ", ".join(["at", *(name for name, _ in event.arguments)])
    only = "" if event.varied else " | only"
    FUNCTIONS += f"    double {event.name}_guard({parameters}) = events.{event.name}({parameters}){only}\n"
JUMP = "model, inputs, line, state, direction"
for event in (event for event in EVENTS if callable(event.jump)):
    FUNCTIONS += f"    void {event.name}_jump({JUMP}, written) = events.{event.jump.__name__}({JUMP})\n"
STRUCTS = {"constant": "coefficients.h", "guard": "evaluation.h"}
RECORDS = {"hip": (struct("tdmf_hip_law", hip.law_of),)}


def declared(name: str) -> str:
    """Declare a parameter by its name."""
    if name in ("state", "written"):
        return f"{'const ' if name == 'state' else ''}double {name}[TDMF_STATE_COUNT]"
    return f"const {POINTERS[name]} *{name}" if name in POINTERS else f"{VALUES.get(name, 'double')} {name}"


def function(line: str) -> Function:
    """Give the function that a line tells."""
    matched = re.fullmatch(r"(\w+) (\w+)\((.*?)\) = (\w+)\.(\w+)(\(.*?\))(?: \| (.*))?", line)
    assert matched, line
    result, name, parameters, page, law, call, note = matched.groups()
    names = [parameter for parameter in parameters.split(", ") if parameter != "written"]
    pages = {p: importlib.import_module(f"..{p}", __package__) for p in PAGES.split()}

    def arguments(*handed: Any) -> Any:
        known = dict(zip(names, handed, strict=True))
        if "direction" in known and "state" in known:  # C has them already
            known["direction"] = given("direction", pages["leg"].direction(known["state"].leg_angle))
        return eval(f"(lambda *all: all){call}", {**pages, **known})

    return Function(
        f"{result} tdmf_{name}({', '.join(map(declared, parameters.split(', ')))})",
        getattr(pages[page], law),
        arguments,
        fixed=tuple(parameter for parameter in names if parameter in FIXED),
        result=(note or "").partition("value ")[2],
        varied=note != "only",
    )


def headers() -> dict[str, Callable[[], str]]:
    """Give what writes each header."""
    found: dict[str, list[str]] = {}
    for line in FUNCTIONS.strip().splitlines():
        if not line.startswith(" "):
            topic = found.setdefault(line, [])
        elif line.startswith("        "):
            topic[-1] += " " + line.strip()
        else:
            topic.append(line.strip())
    return {
        f"{topic}_laws.h": partial(
            header,
            topic,
            [function(line) for line in lines],
            STRUCTS.get(topic, "quantities.h"),
            RECORDS.get(topic, ()),
        )
        for topic, lines in found.items()
    }
