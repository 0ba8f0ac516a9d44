"""Which laws are C functions of the model, and how these are declared: a header a topic."""

from types import SimpleNamespace
from typing import Any

from .. import (
    constants,
    coordinates,
    dynamics,
    energy,
    events,
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
from .values import Function, given, header

MODEL = "const tdmf_model *model"
INPUTS = "const tdmf_inputs *inputs"
RATES = "const tdmf_inputs *rates"
MODE = "const tdmf_mode *mode"
LINE = "const tdmf_ground_line *line"
LEG = "const tdmf_leg *leg"
LAW = "const tdmf_hip_law *law"
AT = "const tdmf_evaluation *at"
GUARD_ARGUMENTS = {"line": LINE, "sign": "double sign"}
STATE = "const double state[TDMF_STATE_COUNT]"
DIRECTION = "tdmf_leg_direction direction"


def along_leg(state: Any) -> SimpleNamespace:
    """Give the leg's direction, which C has as a parameter."""
    return given("direction", leg.direction(state.leg_angle))


def runner_laws() -> str:
    """Write what parameters make once."""
    return header(
        "runner",
        [
            Function(
                f"tdmf_mass_constants tdmf_mass_constants_of({MODEL})",
                runner.derived,
                lambda model: (model.parameters.body.mass, model.parameters.foot.mass),
                result="constants",
            ),
        ],
    )


def ground_line_laws() -> str:
    """Write the axes of the ground."""
    return header(
        "ground_line",
        [
            Function(f"double tdmf_velocity_along({LINE}, double vx, double vy)", ground_line.along),
            Function(f"double tdmf_velocity_off({LINE}, double vx, double vy)", ground_line.off),
            Function(f"double tdmf_place_along({LINE}, double x, double y)", ground_line.place_along),
            Function(f"double tdmf_height_over({LINE}, double x, double y)", ground_line.height_over),
            Function(f"double tdmf_ground_height_at({LINE}, double x)", ground_line.height_at),
            Function(f"double tdmf_path_to({LINE}, double x)", ground_line.path_to),
            Function(
                f"tdmf_point tdmf_point_on({LINE}, double along, double velocity)", ground_line.point_on
            ),
            Function(
                f"tdmf_vector tdmf_vector_on({LINE}, double tangential, double normal)", ground_line.vector_on
            ),
        ],
    )


def hip_laws() -> str:
    """Write the laws of the hip."""
    return header(
        "hip",
        [
            Function(f"tdmf_hip_law tdmf_external_law({INPUTS}, {RATES})", hip.external),
            Function(
                f"tdmf_hip_law tdmf_stance_law({MODEL}, {INPUTS}, {RATES}, {MODE})",
                hip.stance,
                lambda model, inputs, rates, mode: (model, inputs, rates, mode.mid_stance_pending),
            ),
            Function(
                f"tdmf_hip_law tdmf_servo({MODEL}, {INPUTS}, {MODE}, double place_time)",
                hip.servo,
                lambda model, inputs, mode, place_time: (
                    model,
                    inputs,
                    mode.phase,
                    mode.liftoff_angle,
                    place_time,
                ),
            ),
            Function(
                f"tdmf_hip_law tdmf_flight_law({MODEL}, {INPUTS}, {RATES}, {MODE}, double place_time)",
                hip.flight,
                lambda model, inputs, rates, mode, place_time: (
                    model,
                    inputs,
                    rates,
                    mode.phase,
                    mode.clamp_closed,
                    mode.liftoff_angle,
                    place_time,
                ),
            ),
            Function(
                f"double tdmf_law_torque({LAW}, {STATE})",
                hip.torque,
                lambda law, state: (law, state.leg_angle, state.leg_angle_rate),
            ),
            Function(
                f"double tdmf_servo_torque({MODEL}, {INPUTS}, {MODE}, {STATE})",
                hip.servo_torque,
                lambda model, inputs, mode, state: (model, inputs, state, mode.phase, mode.liftoff_angle),
            ),
            Function(
                f"double tdmf_torque_in({MODEL}, {INPUTS}, {MODE}, {STATE}, {LEG}, bool upright, "
                "double sine)",
                hip.torque_in_mode,
                fixed=("sine",),
                result="torque",
            ),
            Function(f"double tdmf_law_drift({LAW})", hip.drift),
            Function(f"tdmf_hip_law tdmf_law_after({LAW}, double elapsed)", hip.after, varied=False),
        ],
    )


def leg_laws() -> str:
    """Write what the leg is."""
    return header(
        "leg",
        [
            Function(
                f"tdmf_leg_direction tdmf_direction_over({LINE}, {DIRECTION})",
                leg.direction_over,
                varied=False,
            ),
            Function(f"double tdmf_leg_thrust({MODEL}, {INPUTS})", leg.thrust, varied=False),
            Function(
                f"double tdmf_rest_length({MODEL}, {INPUTS}, {MODE})",
                leg.rest_length,
                lambda model, inputs, mode: (model, inputs, mode.thrusts),
            ),
            Function(
                f"tdmf_leg tdmf_leg_with({MODEL}, {LINE}, {STATE}, {DIRECTION}, double rest_length)",
                leg.evaluate,
                lambda model, line, state, direction, rest_length: (
                    model,
                    line,
                    state,
                    along_leg(state),
                    rest_length,
                    leg.bounded_length(model, state),
                ),
                fixed=("direction",),
                result="leg",
            ),
            Function(
                f"double tdmf_leg_power({MODEL}, double rest_length, double length, double rest_length_rate)",
                leg.power,
                lambda model, *more: (model.parameters.leg.stiffness, *more),
                varied=False,
            ),
            Function(
                f"double tdmf_leg_work_of_jump({MODEL}, double length, double before, double after)",
                leg.work_of_jump,
                lambda model, *more: (model.parameters.leg.stiffness, *more),
            ),
        ],
    )


def friction_laws() -> str:
    """Write friction."""
    return header(
        "friction",
        [
            Function(f"double tdmf_static_friction({MODEL}, {INPUTS})", friction.static),
            Function(
                f"double tdmf_sliding_friction({INPUTS}, double sign)", friction.sliding, fixed=("sign",)
            ),
            Function(f"double tdmf_cone_width({MODEL}, {INPUTS})", friction.width, varied=False),
            Function("tdmf_cone tdmf_cone_of(double friction)", friction.cone, varied=False),
        ],
    )


def ground_force_laws() -> str:
    """Write the force of the ground."""
    return header(
        "ground_force",
        [
            Function(
                f"tdmf_ground_force tdmf_force_under({MODEL}, {LINE}, {LEG}, double torque)",
                ground_force.under,
            ),
            Function(
                f"tdmf_ground_force tdmf_force_in({MODEL}, {INPUTS}, {LINE}, {LEG}, double torque, "
                "tdmf_contact_mode contact, double sign)",
                ground_force.in_mode,
                fixed=("sign",),
            ),
            Function(
                f"double tdmf_graze_torque({MODEL}, {LINE}, {LEG}, bool upright, double sine)",
                ground_force.graze_torque,
                fixed=("sine",),
                result="torque",
            ),
        ],
    )


def graze_laws() -> str:
    """Write what decides graze."""
    return header(
        "graze",
        [
            Function(
                f"tdmf_ground_force tdmf_force_in_stance({MODEL}, {INPUTS}, {MODE}, {STATE}, {LEG})",
                graze.force_in_stance,
            ),
            Function(
                f"tdmf_ground_force tdmf_force_in_flight({MODEL}, {INPUTS}, {MODE}, {STATE}, {LEG})",
                graze.force_in_flight,
            ),
        ],
    )


def free_fall_laws() -> str:
    """Write free fall."""
    return header(
        "free_fall",
        [
            Function(f"tdmf_vector tdmf_push_on_body({MODEL}, {INPUTS})", free_fall.push_on_body),
            Function(f"tdmf_vector tdmf_fall_of_body({MODEL}, tdmf_vector push)", free_fall.of_body),
            Function(f"tdmf_vector tdmf_fall_of_center({MODEL}, tdmf_vector push)", free_fall.of_center),
            Function(
                "tdmf_point tdmf_ballistic_after(tdmf_point start, tdmf_vector fall, tdmf_vector jerk, "
                "double time)",
                free_fall.ballistic,
            ),
        ],
    )


def coordinate_laws() -> str:
    """Write coordinates."""
    return header(
        "coordinate",
        [
            Function(
                f"tdmf_point tdmf_body_from_foot({STATE}, {DIRECTION})",
                coordinates.body_from_foot,
                lambda state, direction: (state, along_leg(state)),
                fixed=("direction",),
            ),
            Function(
                f"tdmf_point tdmf_body_along({STATE}, {DIRECTION})",
                coordinates.body,
                lambda state, direction: (state, along_leg(state)),
                fixed=("direction",),
            ),
            Function(
                f"tdmf_point tdmf_center_of_mass_along({MODEL}, {STATE}, {DIRECTION})",
                coordinates.center_of_mass,
                lambda model, state, direction: (model, state, along_leg(state)),
                fixed=("direction",),
            ),
            Function(
                f"tdmf_point tdmf_foot_below({MODEL}, tdmf_point center, {STATE}, {DIRECTION})",
                coordinates.foot_below,
                lambda model, center, state, direction: (model, center, state, along_leg(state)),
                fixed=("direction",),
            ),
            Function(
                f"tdmf_leg_rates tdmf_leg_rates_with_foot({STATE}, {DIRECTION}, double vx, double vy)",
                coordinates.leg_rates_with_foot,
                lambda state, direction, vx, vy: (state, along_leg(state), vx, vy),
                varied=False,
            ),
            Function(
                f"tdmf_standing tdmf_standing_of({LINE}, {STATE}, {DIRECTION})",
                coordinates.on_ground,
                lambda line, state, direction: (line, state, along_leg(state)),
                fixed=("direction",),
            ),
            Function(
                f"void tdmf_state_of_standing({LINE}, const tdmf_standing *at, double turns, "
                "double written[TDMF_STATE_COUNT])",
                coordinates.from_ground,
                fixed=("turns",),
                result="state",
            ),
            Function(
                "double tdmf_angle_seen(double x, double y, double slope)",
                coordinates.angle_seen,
                varied=False,
            ),
            Function("double tdmf_angle_rate_of(double momentum, double length)", coordinates.angle_rate),
        ],
    )


def constant_laws() -> str:
    """Write what is constant in a mode."""
    return header(
        "constant",
        [
            Function(
                f"flight_coefficients tdmf_flight_coefficients_of({MODEL}, {LAW}, double rest_length, "
                "tdmf_vector push)",
                constants.of_flight,
            ),
            Function(
                f"ground_coefficients tdmf_ground_coefficients_of({MODEL}, {LINE}, {LAW}, "
                "double rest_length, "
                "tdmf_vector push, double friction)",
                constants.on_ground,
            ),
        ],
        structs="coefficients.h",
    )


def dynamics_laws() -> str:
    """Write the equations of motion."""
    return header(
        "dynamics",
        [
            Function(
                f"tdmf_vector tdmf_acceleration_of_foot({MODEL}, {LINE}, {LEG}, double torque, "
                "tdmf_ground_force force, tdmf_contact_mode contact)",
                dynamics.foot_acceleration,
            ),
            Function(
                f"tdmf_leg_rates tdmf_acceleration_of_leg({MODEL}, {LEG}, double torque, tdmf_vector fall, "
                "tdmf_vector foot)",
                dynamics.leg_acceleration,
            ),
            Function(f"double tdmf_external_power({INPUTS}, tdmf_point body)", dynamics.external_power),
            Function(
                f"void tdmf_rates_with({MODEL}, {STATE}, {LEG}, double torque, tdmf_ground_force force, "
                "tdmf_vector foot, "
                "tdmf_leg_rates acceleration, double slip_velocity, double place_rate, "
                "double external_power, "
                "double derivatives[TDMF_STATE_COUNT])",
                dynamics.rates,
                fixed=("place_rate",),
            ),
        ],
    )


def impact_laws() -> str:
    """Write the impact."""
    return header(
        "impact",
        [
            Function(
                f"tdmf_after_impact tdmf_impact_with({MODEL}, {INPUTS}, {LINE}, {STATE}, {DIRECTION}, "
                "double sign, "
                "bool sticks)",
                impact.after,
                lambda model, inputs, line, state, direction, sign, sticks: (
                    model,
                    inputs,
                    line,
                    state,
                    along_leg(state),
                    sign,
                    sticks,
                ),
                fixed=("direction", "sign"),
            ),
        ],
    )


def energy_laws() -> str:
    """Write the energies."""
    return header(
        "energy",
        [
            Function(
                f"tdmf_energy tdmf_energy_with({MODEL}, {STATE}, {DIRECTION}, double rest_length)",
                energy.mechanical,
                lambda model, state, direction, rest_length: (model, state, along_leg(state), rest_length),
                fixed=("direction",),
            ),
        ],
    )


def guard_laws() -> str:
    """Write the guards of events, and their changes."""
    return header(
        "guard",
        [
            Function(
                f"double tdmf_{event.name}_guard("
                f"{', '.join([AT, *(GUARD_ARGUMENTS[name] for name, _ in event.arguments)])})",
                event.law,
                fixed=("sign",),
                varied=event.varied,
            )
            for event in events.EVENTS
            if event.law is not None
        ],
        structs="evaluation.h",
    )


HEADERS = [
    runner_laws,
    ground_line_laws,
    hip_laws,
    leg_laws,
    friction_laws,
    ground_force_laws,
    graze_laws,
    free_fall_laws,
    coordinate_laws,
    dynamics_laws,
    impact_laws,
    energy_laws,
    guard_laws,
    constant_laws,
]
