"""A gait whose foot sticks three times in one stance: by the law of friction, and beside its controls."""

import numpy as np
import pytest
import tdmf_slip
from tdmf_slip.fmu.simulation import run_unit

MU, RATIO, FALL = 0.275, 2.2, 0.018
SLOPE = np.radians(-3.25)
RUNNER = {
    "ground.friction": MU,
    "ground.static_friction_ratio": RATIO,
    "ground.stribeck_velocity": FALL,
    "ground.slope": SLOPE,
    "leg.stiffness": 2.13,
    "leg.damping": 0.23,
    "hip.stance_torque": 0.44,
    "hip.touchdown_angle": np.radians(43.2),
    "foot.mass": 0.135,
}


@pytest.fixture(scope="module")
def gait():
    return tdmf_slip.find_gait(RUNNER)


def test_the_foot_sticks_three_times_in_one_stance(gait):
    assert (gait.word, gait.stable) == ("+0-0-0+", True) and gait.speed > 1.4


def test_what_the_ground_does_is_the_law_of_friction(gait):
    """A slip's force follows from its speed and opposes it; a stick's force is within the static cone."""
    run = run_unit(gait.start_values, strides=1, output_interval=gait.period / 20_000)
    cosine, sine = np.cos(SLOPE), np.sin(SLOPE)
    along = cosine * run.table["contact.fx"] + sine * run.table["contact.fy"]
    normal = cosine * run.table["contact.fy"] - sine * run.table["contact.fx"]
    speed = cosine * run.table["foot.vx"] + sine * run.table["foot.vy"]
    loaded = normal > 1e-6
    slips, sticks = loaded & (np.abs(speed) > 1e-9), loaded & (np.abs(speed) <= 1e-9)
    assert min(np.count_nonzero(slips), np.count_nonzero(sticks)) > 100
    friction = MU * (1.0 + (RATIO - 1.0) * np.exp(-np.abs(speed) / FALL))
    assert along[slips] == pytest.approx((-np.sign(speed) * friction * normal)[slips], rel=1e-6, abs=1e-9)
    assert np.all(np.abs(along[sticks]) <= (1.0 + 1e-6) * RATIO * MU * normal[sticks])


def test_a_constant_friction_as_large_as_the_static_one_does_the_same(gait):
    """The fall of friction is not needed. Sliding friction alone, or a jump, gives one stick."""
    alike = RUNNER | {"ground.static_friction_ratio": 1.0}
    words = [tdmf_slip.find_gait(alike | {"ground.friction": mu}).word for mu in (MU, RATIO * MU)]
    assert words == ["+0-", gait.word]
    assert tdmf_slip.find_gait(RUNNER | {"ground.stribeck_velocity": 0.0}).word == "+0-"
