"""(m, k, l0) scaled by any factors, the dimensionless groups fixed, is the same motion in scaled units."""

import math
import random

import pytest
from conftest import apex_start, reference_gaits, runner_of_gait

GAITS = reference_gaits()


def scaled_parameters(m, k, l0):
    """Table 1 of the paper at human, insect or any other scale."""
    return {
        "body.mass": m,
        "foot.mass": 0.1 * m,
        "leg.stiffness": k,
        "leg.damping": 2 * 0.1 * math.sqrt(m * k),
        "leg.free_length": l0,
        "leg.min_length": 0.05 * l0,
        "gravity": 0.01 * k * l0 / m,
        "hip.stance_torque": 0.2 * k * l0**2,
        "hip.kp": 0.1 * k * l0**2,
        "hip.kd": 0.1 * l0**2 * math.sqrt(m * k),
    }


def scaled_start(apex, l0, time):
    units = {"foot.x": l0, "foot.y": l0, "leg.length": l0, "leg.angle": 1.0}
    rates = {
        "foot.vx": l0 / time,
        "foot.vy": l0 / time,
        "leg.length_rate": l0 / time,
        "leg.angle_rate": 1 / time,
    }
    return {name: value * (units | rates)[name] for name, value in apex_start(apex).items()}


@pytest.mark.parametrize("seed", range(3))
def test_scaling(run, seed):
    draw = random.Random(seed)
    gait = draw.choice(GAITS)
    m, k, l0 = (10 ** draw.uniform(-3, 4) for _ in range(3))
    time, energy = math.sqrt(m / k), k * l0**2
    values = scaled_parameters(m, k, l0) | scaled_start(gait["apex"], l0, time)
    values |= runner_of_gait(gait)
    _, instance = run(3.3 * gait["period"] * time, values, output_interval=gait["period"] * time / 20)
    assert instance.text("stride.word") == gait["word"]
    found = instance.real("stride.period", "stride.length", "stride.work", "stride.cost_of_transport")
    wanted = (gait["period"] * time, gait["length"] * l0, gait["work"] * energy, gait["cost_of_transport"])
    assert found == pytest.approx(wanted, rel=1e-6)
