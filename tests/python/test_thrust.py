"""Thrust of the leg as the only drive: its work, and where the energy goes."""

import numpy as np
import pytest
from tdmf_slip import Runner, find_gait
from tdmf_slip.fmu.simulation import run_unit

LOSSES = ("damper_loss", "friction_loss", "impact_loss")
THRUST = 0.45
WORKS = ("leg.work", "hip.work")


@pytest.fixture(scope="module")
def gait():
    start = {"ground.friction": 10.0, "hip.stance_torque": 0.0, "leg.thrust": THRUST}
    return find_gait(Runner(start))


def test_without_hip_torque_the_leg_does_all_work(gait, fmu):
    """Its spring longer by the thrust has done, once flight begins, stiffness x thrust x lengthening."""
    names = [*WORKS, *(f"energy.{name}" for name in LOSSES), "leg.length"]
    run = run_unit(gait.start_values, strides=1, tolerance=1e-11, variables=names, fmu=fmu).table
    changed = np.flatnonzero(np.abs(np.diff(run["leg.work"])) > 1e-6)
    assert len(changed) == 2
    compressed, longest = run["leg.length"][changed]
    assert compressed == pytest.approx(run["leg.length"].min(), abs=1e-9)
    leg, hip, *lost = (run[name][-1] - run[name][0] for name in names[: 2 + len(LOSSES)])
    assert leg == pytest.approx(THRUST * (longest - compressed), rel=1e-8)
    assert hip < 0.0 < leg
    assert leg + hip == pytest.approx(sum(lost), rel=1e-7)
    assert gait.stride["work"] == pytest.approx(leg + hip, rel=1e-7)


def test_a_stride_gives_away_what_leg_and_hip_do(gait):
    assert gait.stable
    assert gait.stride["work"] == pytest.approx(sum(gait.stride[name] for name in LOSSES), rel=1e-10)
