"""Choices of the runner's unit: its variables in order, short names, and quantities of a stride."""

from ..hybrid.page import Page
from ..hybrid.unit import Unit
from .runner import Runner


class RunnerUnit(Unit):
    """The unit of the runner's page."""

    identifier = "TDMF_SLIP"
    about = {
        "description":
            "A spring-legged runner whose foot can stick, slip, lift off and land (Or and Moravia 2016)",
        "author": "The TDMF-SLIP authors", "copyright": "Copyright 2026 The TDMF-SLIP authors",
        "license": "BSD-2-Clause",
    }
    experiment = {"stop_time": 251, "tolerance": 1e-6, "step_size": 0.1}
    """Ten strides of the default gait."""
    variables = """
        time body.mass foot.mass leg.stiffness leg.damping leg.free_length leg.min_length gravity
        hip.stance_torque hip.touchdown_angle hip.kp hip.kd hip.liftoff_angle_factor hip.retraction_rate
        hip.swing_clamp ground.static_friction_ratio ground.stribeck_velocity ground.patch_begin
        ground.patch_end ground.patch_friction leg.thrust
        status.terminate_on_fall solver.method solver.relative_tolerance
        ground.friction hip.external_torque ground.height ground.slope leg.extension body.external_fx
        body.external_fy control.touchdown_angle control.stance_torque control.thrust
        foot.x foot.y leg.length leg.angle foot.vx foot.vy leg.length_rate leg.angle_rate
        hip.work hip.place_time leg.work energy.damper_loss energy.friction_loss hip.positive_work
        energy.external_work derivatives
        body.x body.y body.vx body.vy com.x com.y com.vx com.vy contact.fx contact.fy contact.normal
        contact.tangential leg.force hip.torque energy.kinetic energy.potential energy.elastic energy.total
        contact.mode contact.mode_index hip.phase hip.phase_index hip.liftoff_angle ground.pending
        energy.impact_loss event.count event.last_time status.fallen solver.steps solver.evaluations
        solver.layer_steps
        stride.count stride.period stride.length stride.rise stride.speed stride.work stride.hip_work
        stride.leg_work stride.positive_work stride.cost_of_transport stride.touchdowns stride.stance_time
        stride.duty_factor stride.slip_distance stride.peak_force stride.word stride.word_code
        stride.peak_vertical_force
        apex.time apex.com_height apex.com_speed apex.leg_length apex.leg_angle apex.leg_length_rate
        apex.leg_angle_rate
        guard.touchdown guard.apex guard.clamp guard.lift_off guard.slip_onset_positive
        guard.slip_onset_negative guard.slip_velocity_zero guard.mid_stance guard.force_peak
        guard.graze_to_contact guard.graze_to_flight guard.body_down guard.leg_too_short
        guard.greatest_compression guard.new_ground guard.vertical_force_peak guard.patch_border
    """
    guard_events = {
        "apex": ["apex", "apex_in_graze"], "clamp": ["clamp", "release"],
        "slip_onset_positive": ["slips_forward"], "slip_onset_negative": ["slips_backward"],
        "slip_velocity_zero": ["comes_to_rest", "enters_layer", "leaves_layer"],
        "force_peak": ["force_on_foot"], "vertical_force_peak": ["vertical_force_on_foot"],
        "body_down": ["falls"], "leg_too_short": ["collapses"],
        "patch_border": ["crosses_border", "passes_end", "passes_begin"],
    }
    computed_states = """
        hip.work hip.place_time leg.work energy.damper_loss energy.friction_loss hip.positive_work
        energy.external_work
    """
    steady_states = """
        foot.x leg.length leg.angle hip.work energy.damper_loss energy.friction_loss hip.positive_work
        energy.external_work
    """
    contact_at_start = """
        foot.mass ground.static_friction_ratio ground.stribeck_velocity ground.patch_begin ground.patch_end
        ground.patch_friction ground.friction ground.height ground.slope foot.x foot.y foot.vx foot.vy
    """
    """Variables that decide the outcome of an impact at the start."""
    motion_at_start = f"{contact_at_start} body.mass leg.length leg.angle leg.length_rate leg.angle_rate"
    zero_at_start = """
        hip.work hip.place_time energy.damper_loss energy.friction_loss hip.positive_work
        energy.external_work der(leg.work) ground.pending stride.count stride.period stride.length
        stride.rise stride.speed stride.work stride.hip_work stride.leg_work stride.positive_work
        stride.cost_of_transport stride.touchdowns stride.stance_time stride.duty_factor
        stride.slip_distance stride.peak_force stride.peak_vertical_force stride.word stride.word_code
    """
    at_start = dict.fromkeys(zero_at_start.split(), "") | {
        "body.x": "foot.x leg.length leg.angle", "body.y": "foot.y leg.length leg.angle",
        "body.vx": "leg.length leg.angle foot.vx leg.length_rate leg.angle_rate",
        "body.vy": "leg.length leg.angle foot.vy leg.length_rate leg.angle_rate",
        "com.x": "body.mass foot.mass foot.x leg.length leg.angle",
        "com.y": "body.mass foot.mass foot.y leg.length leg.angle",
        "com.vx": motion_at_start, "com.vy": motion_at_start, "energy.kinetic": motion_at_start,
        "energy.potential": "body.mass foot.mass gravity foot.y leg.length leg.angle",
        "hip.liftoff_angle": "leg.angle", "energy.impact_loss": contact_at_start, "event.last_time": "time",
    }
    terminates = "status.terminate_on_fall"
    has_cvode = True
    terminals = {
        "ground": (
            "Contact of foot and ground",
            "foot.x foot.y foot.vx foot.vy contact.fx contact.fy ground.friction"),
        "hip": (
            "Joint of body and leg: a torque on it, the angle of the leg and its rate",
            "hip.external_torque leg.angle leg.angle_rate"),
    }

    def __init__(self, page):
        super().__init__(page)
        self.part = "plain_runner"


OTHER_SHORT_NAMES = {
    "body.mass": "body_mass", "foot.mass": "foot_mass", "hip.stance_torque": "torque",
    "hip.retraction_rate": "retraction", "ground.height": "ground_height",
}
"""Short names of parameters and inputs. All others are the last part of the name; `control.*` have none."""
UNITS = ["Hz", "N2.m2.s"]
"""Units of quantities, beside those of the variables."""
QUANTITIES = [
    ("frequency", "Hz", "Strides per second, one over the period"),
    ("liftoff_angle", "rad", "Leg angle at the last lift-off of the stride"),
    ("external_work", "J", "Work of external forces and torques on the runner"),
    ("damper_loss", "J", "Energy that the leg's damper takes"),
    ("friction_loss", "J", "Energy that friction takes"),
    ("impact_loss", "J", "Energy that the foot's impacts take"),
    ("apex_height", "m", "Height of the centre of mass at the apex", "com_height"),
    ("apex_speed", "m/s", "Speed of the centre of mass at the apex", "com_speed"),
    ("apex_leg_angle", "rad", "Leg angle at the apex", "leg_angle"),
    ("foot_clearance", "m", "Height of the foot above the ground at the apex"),
    ("greatest_foot_height", "m", "Greatest height of the foot in flight"),
    ("greatest_slip_velocity", "m/s", "Greatest speed of the foot along the ground in slip"),
    ("squared_torque", "N2.m2.s", "Integral of the squared hip torque over the stride"),
    ("positive_work", "J", "Positive work of hip and leg; in the reduced map, of the hip"),
    ("positive_hip_work", "J", "Work of the hip where its power is positive"),
    ("positive_leg_work", "J", "Work of the leg's changes of rest length where positive"),
    ("positive_cost_of_transport", "1", "Positive work over weight and length of the stride"),
]
"""Quantities of a stride that the unit does not report.

Each has its name, unit, meaning, and the coordinate of the stride's first apex that it is.
"""
REDUCED_QUANTITIES = """
    period length rise speed work hip_work leg_work positive_work cost_of_transport touchdowns stance_time
    duty_factor slip_distance peak_force peak_vertical_force frequency liftoff_angle external_work
    damper_loss friction_loss impact_loss apex_height apex_speed
    """
MODELS = {
    "full": (
        "com_height com_speed leg_length leg_angle leg_length_rate leg_angle_rate",
        f"""{REDUCED_QUANTITIES} apex_leg_angle foot_clearance greatest_foot_height greatest_slip_velocity
        squared_torque positive_hip_work positive_leg_work positive_cost_of_transport"""),
    "reduced": ("com_height com_speed", REDUCED_QUANTITIES),
}
"""Coordinates of an apex and quantities of a stride, in the order of the C library, by model."""
SCALES = "body.mass", "leg.stiffness", "leg.free_length"
"""Parameters that measure all other quantities."""


def runner_unit(page=None):
    """The unit of the runner's page, or of a page of that model which has been generated."""
    return RunnerUnit(page or Page(Runner))
