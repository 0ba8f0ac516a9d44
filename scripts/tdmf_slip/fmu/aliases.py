"""Short names of the variables that users set most: one table for package, command and live page.

It needs nothing but Python's standard library, because the live page's generator reads it too.
"""

from collections.abc import Mapping

ALIASES: Mapping[str, str] = {
    "body_mass": "body.mass",
    "foot_mass": "foot.mass",
    "stiffness": "leg.stiffness",
    "damping": "leg.damping",
    "free_length": "leg.free_length",
    "min_length": "leg.min_length",
    "thrust": "leg.thrust",
    "extension": "leg.extension",
    "torque": "hip.stance_torque",
    "external_torque": "hip.external_torque",
    "touchdown_angle": "hip.touchdown_angle",
    "liftoff_angle_factor": "hip.liftoff_angle_factor",
    "retraction": "hip.retraction_rate",
    "kp": "hip.kp",
    "kd": "hip.kd",
    "swing_clamp": "hip.swing_clamp",
    "friction": "ground.friction",
    "static_friction_ratio": "ground.static_friction_ratio",
    "stribeck_velocity": "ground.stribeck_velocity",
    "patch_begin": "ground.patch_begin",
    "patch_end": "ground.patch_end",
    "patch_friction": "ground.patch_friction",
    "ground_height": "ground.height",
    "slope": "ground.slope",
    "external_fx": "body.external_fx",
    "external_fy": "body.external_fy",
}
"""From the short name to the unit's own. `gravity` is the unit's own name."""
