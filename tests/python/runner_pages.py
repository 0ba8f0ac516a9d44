"""The runner's page in tests: compiled once, started at an apex, and random runs of it with everything on."""

import functools
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
from page_runs import ROOT, CompiledPage

from c_core.pages.runner import Runner

DESCRIPTION = Path(ROOT) / "modelDescription.xml"
VARIABLES = {v.get("name"): v for v in ElementTree.parse(DESCRIPTION).iter("ScalarVariable")}
"""The unit's variables, by name."""
STATES = (
    "seen_x", "seen_y", "length", "angle", "seen_vx", "seen_vy", "length_rate", "angle_rate", "work",
    "placing", "leg_work", "damper_loss", "friction_loss", "positive_work_so_far", "external_work",
)  # fmt: skip
"""The core's states, in its order, by the names of the page."""
MECHANICAL = STATES[:8]
SECTION = (
    "apex_com_height", "apex_com_speed", "apex_length", "apex_angle", "apex_length_rate", "apex_angle_rate",
)  # fmt: skip


@functools.cache
def whole_page():
    """The whole runner's page, also in lanes."""
    return CompiledPage(Runner, level="-O1", in_lanes=True)


def world_of(apex, share=1 / 1.1):
    """The world's states at an apex, where the centre of mass is at x = 0."""
    height, speed, length, angle, length_rate, angle_rate = apex
    sine, cosine = np.sin(angle), np.cos(angle)
    body_vx = -length_rate * sine - length * angle_rate * cosine
    body_vy = length_rate * cosine - length * angle_rate * sine
    return {
        "seen_x": share * length * sine, "seen_y": height - share * length * cosine,
        "seen_vx": speed - share * body_vx, "seen_vy": -share * body_vy,
        "length": length, "angle": angle, "length_rate": length_rate, "angle_rate": angle_rate,
    }  # fmt: skip


def section(run):
    """The six coordinates of the last apex."""
    return np.array([getattr(run, name) for name in SECTION])


def word(run):
    """The gait word of the last stride."""
    code = int(run.word_code)
    letters = (np.base_repr(abs(code), 4) if code else "").translate(str.maketrans("0123", "|-0+"))
    return letters + "~" * (code < 0)


# ---- random runs -----------------------------------------------------------------------------------------

RAMPED = {
    "ground.friction": 2e-3, "leg.extension": 2e-3, "hip.external_torque": 2e-4, "body.external_fx": 1e-4,
    "body.external_fy": 1e-4,
}  # fmt: skip
"""Inputs that are ramped, and how fast at most, in units m = k = l0 = 1."""
INPUTS = (*RAMPED, "ground.height", "ground.slope", "control.touchdown_angle", "control.stance_torque",
          "control.thrust")  # fmt: skip
NEAR = {
    "leg.damping": (0.15, 0.26), "gravity": (0.0077, 0.013), "hip.liftoff_angle_factor": (0.8, 1.5),
    "leg.min_length": (0.05, 0.05), "ground.static_friction_ratio": (1, 1.6),
    "ground.stribeck_velocity": (0.01, 0.5), "ground.patch_begin": (5, 16),
    "ground.patch_friction": (0.05, 1.2),
    "ground.friction": (0.03, 1.5), "leg.extension": (-0.03, 0.03), "hip.external_torque": (-5e-3, 5e-3),
    "body.external_fx": (-1e-3, 1e-3), "body.external_fy": (-2e-3, 2e-3), "ground.height": (-0.05, 0.05),
    "ground.slope": (-0.06, 0.06), "control.touchdown_angle": (-0.1, 0.1),
    "control.stance_torque": (-0.05, 0.05), "control.thrust": (0, 0.02), "leg.thrust": (0, 0.05),
    "hip.stance_torque": (0.1, 0.3), "hip.retraction_rate": (-0.004, 0.012),
    "hip.touchdown_angle": (0.5, 0.9), "hip.kp": (0.03, 0.3), "hip.kd": (0.03, 0.3),
}  # fmt: skip
"""Ranges of a runner near Table 1, in units m = k = l0 = 1."""
FAR = {
    "leg.damping": (1e-4, 1e3), "gravity": (1e-7, 10), "hip.liftoff_angle_factor": (0.01, 100),
    "leg.min_length": (1e-3, 0.9), "ground.static_friction_ratio": (1, 1e6),
    "ground.stribeck_velocity": (1e-6, 1e4), "ground.patch_begin": (1e-3, 1e6),
    "ground.patch_friction": (1e-4, 1e6),
    "ground.friction": (1e-4, 1e6), "leg.extension": (1e-4, 0.5), "hip.external_torque": (1e-6, 1),
    "body.external_fx": (1e-7, 1), "body.external_fy": (1e-7, 1), "ground.height": (1e-3, 10),
    "ground.slope": (1e-3, 0.99), "control.touchdown_angle": (1e-3, np.pi),
    "control.stance_torque": (1e-4, 10),
    "control.thrust": (1e-4, 1), "leg.thrust": (1e-4, 1), "hip.stance_torque": (1e-4, 10),
    "hip.retraction_rate": (1e-5, 10), "hip.touchdown_angle": (1e-2, np.pi / 2), "hip.kp": (1e-4, 1e3),
    "hip.kd": (1e-4, 1e3),
}  # fmt: skip
"""Sizes that a runner far from Table 1 may have: the allowed ranges, as far as a solver can follow runs."""
SIGNED = {n for n, (low, _) in NEAR.items() if low < 0} | {
    "hip.stance_torque", "hip.touchdown_angle", "ground.patch_begin", "control.thrust",
}  # fmt: skip
STEP_LIMIT = 20000


def clipped(name, value):
    """A value within the allowed range of a variable."""
    limits = VARIABLES[name][0]
    return float(np.clip(value, float(limits.get("min")), float(limits.get("max"))))


def drawn(number):
    """A random runner, its start, and the segments of its run.

    Inputs and tunable parameters may be set where a segment begins, and inputs are ramped within it.

    In a third of the runners, some or all parameters are drawn over their whole range, and the masses,
    the stiffness and the length over many powers of ten.
    """
    random = np.random.default_rng([48, number])
    u, is_far = random.uniform, number % 3 == 0
    share_far = random.choice([0.05, 0.15, 0.5]) if is_far else 0.0
    mass, stiffness, length = (10 ** u(-most, most) if is_far else 1.3 ** u(-1, 1) for most in (8, 8, 5))
    foot_mass = mass * (10 ** u(-4, 1) if u() < share_far else u(0.03, 0.3))
    rate, force = np.sqrt(stiffness / mass), stiffness * length
    torque = force * length
    units = {
        "leg.damping": np.sqrt(stiffness * mass), "gravity": force / mass, "leg.extension": length,
        "hip.external_torque": torque, "body.external_fx": force, "body.external_fy": force,
        "ground.height": length, "control.stance_torque": torque, "control.thrust": length,
        "leg.thrust": length,
        "hip.stance_torque": torque, "hip.retraction_rate": rate, "hip.kp": torque, "hip.kd": torque / rate,
        "leg.min_length": length, "ground.stribeck_velocity": length * rate, "ground.patch_begin": length,
    }  # fmt: skip

    def draw(name):
        value = u(*NEAR[name])
        if u() < share_far:
            low, high = np.log10(FAR[name])
            value = 0.0 if u() < 0.1 else 10 ** u(low, high)
            value *= random.choice([-1, 1]) if name in SIGNED else 1
        return clipped(name, value * units.get(name, 1))

    parameters = {n: draw(n) for n in NEAR if n not in INPUTS}
    parameters |= {"ground.static_friction_ratio": 1.0} if u() < 0.3 else {}
    parameters |= {"ground.stribeck_velocity": 0.0} if u() < 0.4 else {}
    patch = (0 if u() < 0.3 else 10 ** u(-2, 1)) * length
    parameters |= {
        "body.mass": mass, "foot.mass": foot_mass, "leg.stiffness": stiffness, "leg.free_length": length,
        "ground.patch_end": parameters["ground.patch_begin"] + patch,
    }  # fmt: skip
    inputs = {n: draw(n) if n == "ground.friction" or u() < 0.6 else 0.0 for n in INPUTS}
    apex = [u(1.2, 2.0) * length, u(0.2, 1.5) * length * rate, u(0.9, 1.1) * length, u(-0.8, 1.4),
            u(-0.05, 0.05) * length * rate, u(-0.3, 0.3) * rate]  # fmt: skip
    segments = []
    changing = sorted(n for n in NEAR if n in INPUTS or VARIABLES[n].get("variability") == "tunable")
    for duration in [u(6, 14), *u(0.02, 0.5, 6), u(5, 15), *u(0.02, 0.5, 4), u(5, 15)]:
        sets = {}
        if u() < 0.4:
            names = random.choice(changing, size=3, replace=False)
            sets = {str(name): draw(name) for name in names}
        faster = 10 ** u(0, 3) if u() < share_far else 1
        rates = {n: u(-1, 1) * most * faster * units.get(n, 1) * rate if u() < 0.5 else 0.0
                 for n, most in RAMPED.items()}  # fmt: skip
        segments.append((duration / rate, sets, rates))
    world = world_of(apex, mass / (mass + foot_mass))
    world["seen_vy"] += 0.0 if u() < 0.3 else u(-0.1, 0.1) * length * rate  # else it starts at an apex
    world["seen_y"] += inputs["ground.height"] + abs(np.tan(inputs["ground.slope"])) * 3 * length
    return parameters, inputs, world, segments, (length, rate, force)
