"""Quantities of a gait: values against a finely sampled run of the unit, derivatives against differences."""

import numpy as np
import pytest
from conftest import CLAMPED, RELEASE
from references import read
from tdmf_slip import InputError, Runner, find_gait
from tdmf_slip.fmu.simulation import run_unit
from tdmf_slip.library.fixed_point import gait_near
from tdmf_slip.library.quantities import MEASURES, quantities_of, scales_of
from tdmf_slip.library.strides import varied_stride
from tdmf_slip.variables.parameters import read_parameters

RANDOM_RUNNERS = read("random_runners.json")
RUNNERS = {
    "sticks": {"ground.friction": 10.0},
    "slips": {"ground.friction": 0.2},
    "all modes": {"ground.friction": 0.6},
    "thrust on a slope": {"ground.friction": 0.6, "leg.thrust": 0.1, "ground.slope": -0.03},
    "retraction": {"ground.friction": 0.43, "hip.retraction_rate": 0.005},
    "light foot": {"ground.friction": 0.6, "foot.mass": 1e-3 if RELEASE else 1e-2},
    "heavy foot": {"foot.mass": 1.0, "hip.stance_torque": 0.3},
    "stiff hip": {"ground.friction": 0.3, "hip.kp": 30.0, "hip.kd": 20.0},
    "human": "human",
}
VARIED = (
    "hip.stance_torque",
    "hip.touchdown_angle",
    "hip.kp",
    "leg.stiffness",
    "leg.damping",
    "body.mass",
    "foot.mass",
    "gravity",
    "ground.friction",
    "ground.slope",
)
SAMPLES = 20_000


def runner_of(given):
    return read_parameters(given) if isinstance(given, str) else given


def sampled(gait):
    """The gait's stride by the unit at many instants; the lightest foot and stiffest hip are faster."""
    names = ["hip.torque", "foot.y", "foot.x", "foot.vx", "foot.vy", "contact.mode_index", "hip.work"]
    return run_unit(
        gait.start_values,
        stop_time=gait.period,
        output_interval=gait.period / SAMPLES,
        variables=[*names, "leg.work", "energy.friction_loss"],
        interface="cs",
    )


@pytest.mark.parametrize("name", ["sticks", "all modes", "thrust on a slope", "human"])
def test_values_are_those_of_a_finely_sampled_run(name):
    gait = find_gait(runner_of(RUNNERS[name]))
    has = quantities_of(gait, MEASURES)
    values = gait.runner
    rows = sampled(gait).table
    assert len(rows) >= SAMPLES
    slope = np.tan(values["ground.slope"])
    height = rows["foot.y"] - values["ground.height"] - slope * rows["foot.x"]
    along = (
        np.cos(values["ground.slope"]) * rows["foot.vx"] + np.sin(values["ground.slope"]) * rows["foot.vy"]
    )
    slips = np.isin(rows["contact.mode_index"], (3, 4))
    assert has["foot_clearance"] == pytest.approx(height[0], abs=1e-9 * values["leg.free_length"])
    assert has["greatest_foot_height"] == pytest.approx(height.max(), rel=1e-6)
    fastest = np.abs(along[slips]).max() if slips.any() else 0.0
    speed = values["leg.free_length"] * np.sqrt(values["leg.stiffness"] / values["body.mass"])
    between_rows = (
        4.0 * speed * gait.period / SAMPLES / np.sqrt(values["body.mass"] / values["leg.stiffness"])
    )
    assert has["greatest_slip_velocity"] == pytest.approx(fastest, abs=between_rows)
    assert has["greatest_slip_velocity"] >= fastest - 1e-9 * speed
    squared = np.trapezoid(rows["hip.torque"] ** 2, rows["time"])
    assert has["squared_torque"] == pytest.approx(squared, rel=2e-3)
    positive = np.clip(np.diff(rows["hip.work"]), 0.0, None).sum()
    assert has["positive_hip_work"] == pytest.approx(positive, rel=1e-3)
    thrust = np.clip(np.diff(rows["leg.work"]), 0.0, None).sum()
    assert has["positive_leg_work"] == pytest.approx(thrust, abs=1e-9)
    assert has["friction_loss"] == pytest.approx(rows["energy.friction_loss"][-1], rel=1e-6, abs=1e-9)


def differences(runner, apex, k, scales, steps):
    def moved(sign):
        at, other = apex.copy(), runner
        if k < len(at):
            at[k] += sign * steps * scales[k]
        else:
            name = VARIED[k - len(at)]
            other = other.replace({name: other[name] + sign * steps * scales[k]})
        return varied_stride(other, at, MEASURES, []).quantities

    return (moved(1.0) - moved(-1.0)) / (2.0 * steps)


def assert_differentiated(runner, apex):
    scales, steps = scales_of(runner, VARIED), 1e-6
    stride = varied_stride(runner, apex, MEASURES, VARIED)
    exact = (stride.by_all * scales)[len(apex) :]
    size = np.maximum(np.abs(stride.quantities), np.max(np.abs(exact), axis=1))
    for k in range(len(scales)):
        off = np.abs(exact[:, k] - differences(runner, apex, k, scales, steps))
        worst = int(np.argmax(off / np.maximum(size, 1e-3)))
        assert off[worst] <= 2e-5 * max(size[worst], 1e-3), (MEASURES[worst], k)


@pytest.mark.parametrize("name", RUNNERS)
def test_derivatives_are_those_of_differences(name):
    gait = find_gait(runner_of(RUNNERS[name]))
    assert_differentiated(gait.runner, gait.apex)


def test_derivatives_of_random_runners_are_those_of_differences():
    """Another search found these gaits: their foot mass, damping, hip and friction vary widely."""
    compared = 0
    for case in RANDOM_RUNNERS:
        for gait in case["gaits"][:1]:
            found = gait_near(Runner(case["runner"] | CLAMPED), gait["apex"])
            if abs(found.lambda_max) < 50.0:
                assert_differentiated(found.runner, found.apex)
                compared += 1
    assert compared >= 8


def test_the_reduced_map_refuses_what_its_leg_does_not_have():
    gait = find_gait({"ground.friction": 0.6}, model="reduced")
    assert quantities_of(gait, ["apex_height"])["apex_height"] == gait.apex[0]
    with pytest.raises(InputError, match="reduced map has no quantity foot_clearance"):
        quantities_of(gait, ["foot_clearance"])
