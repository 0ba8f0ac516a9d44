"""What is measured along a stride: what its record holds, and more in the full model, by the C library."""

from ..variables.table import MODELS
from .runner import Runner
from .section import Apex
from .structs import Measured, Return

STRIDE_QUANTITIES = (
    "period",
    "length",
    "rise",
    "speed",
    "work",
    "hip_work",
    "leg_work",
    "positive_work",
    "cost_of_transport",
    "touchdowns",
    "stance_time",
    "duty_factor",
    "slip_distance",
    "peak_force",
    "peak_vertical_force",
)
"""What the record of any stride holds."""
MEASURES = (
    "apex_height",
    "apex_speed",
    "apex_leg_angle",
    "foot_clearance",
    "greatest_foot_height",
    "positive_hip_work",
    "positive_leg_work",
    "positive_work",
    "positive_cost_of_transport",
    "squared_torque",
    "greatest_slip_velocity",
    "friction_loss",
)
"""What else is measured along a stride of the full model."""
APEX_QUANTITIES = {q.name: q.coordinate for q in MODELS["full"].quantities.values() if q.coordinate}
"""Those of `MEASURES` that are coordinates of the apex at which a stride begins."""
_ALONG = ("positive_hip_work", "positive_leg_work", "squared_torque", "friction_loss")
_GREATEST = ("greatest_slip_velocity", "greatest_foot_height")


def apex_quantities(runner: Runner, apex: Apex) -> dict[str, float]:
    """Where a stride begins, by the names of quantities."""
    at = dict(zip(runner.coordinates, map(float, apex), strict=True))
    return {name: at[of] for name, of in APEX_QUANTITIES.items() if of in at}


def measures_of(measured: Measured) -> dict[str, float]:
    """What the library has measured along a stride, or the change of it."""
    reported = {name: float(getattr(measured.measures, name)) for name in (*_ALONG, *_GREATEST)}
    reported["foot_clearance"] = float(measured.foot_clearance)
    reported["positive_work"] = reported["positive_hip_work"] + reported["positive_leg_work"]
    return reported


def weight_of(runner: Runner) -> float:
    """Of body and foot, N."""
    return (runner["body.mass"] + runner["foot.mass"]) * runner["gravity"]


def all_measures(runner: Runner, apex: Apex, stride: Return) -> dict[str, float]:
    """Of a stride of the full model."""
    reported = {**apex_quantities(runner, apex), **measures_of(stride)}
    distance = weight_of(runner) * stride.stride.length
    reported["positive_cost_of_transport"] = reported["positive_work"] / distance if distance else 0.0
    return reported
