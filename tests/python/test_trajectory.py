"""Trajectories of the engine: the unit's, SciPy's, and derivatives beside differences."""

import numpy as np
import pytest
import tdmf_slip
from conftest import CLAMPED
from scipy_strides import Stride
from tdmf_slip import Runner, find_gait, trajectory
from tdmf_slip.library.section import COORDINATES

RUNNERS = (
    {},
    {"friction": 0.2, **CLAMPED},
    {"friction": 0.43, "slope": 0.02, "thrust": 0.05, "retraction": 0.01},
    "human",
)


@pytest.mark.parametrize("runner", RUNNERS)
def test_a_trajectory_is_the_units_run(runner):
    """States and outputs agree at all times of two strides; events fall between the times."""
    runner = Runner(runner)
    gait = find_gait(runner)
    unit = tdmf_slip.simulate(gait, strides=2, interface="cs", tolerance=1e-13)
    run = trajectory(gait, times=unit["time"])
    compared = 0
    for name in set(run.data_vars) & set(unit.data_vars):
        if unit[name].dtype.kind in "OUT":
            assert (run[name].values == unit[name].values).all()
            continue
        values = np.asarray(unit[name], float)
        scale = max(1.0, np.abs(values).max())
        assert np.abs(run[name].values - values).max() < 1e-9 * scale, name
        compared += 1
    assert compared > 40 and len(set(unit["contact.mode"].values)) >= 3 and run.fallen == 0


@pytest.mark.parametrize("friction", [0.2, 0.6])
def test_a_trajectory_is_that_of_an_independent_integration(friction):
    gait = find_gait({"friction": friction, **CLAMPED})
    stride = Stride(friction, swing_clamp=True)
    stride.run(gait.apex)
    times = np.linspace(0.0, 0.999 * gait.period, 60)
    run = trajectory(gait, times=times)
    begin = stride.at(0.0)[0]
    for row, time in enumerate(times):
        x, y, body_x, body_y, vx, vy, body_vx, body_vy = stride.at(time)
        wanted = {"foot.x": x - begin, "foot.y": y, "body.x": body_x - begin, "body.y": body_y}
        wanted |= {"foot.vx": vx, "foot.vy": vy, "body.vx": body_vx, "body.vy": body_vy}
        for name, value in wanted.items():
            assert run[name].values[row] == pytest.approx(value, abs=1e-9), (name, time)


NAMES = (*COORDINATES, "leg.damping", "ground.friction", "body.mass", "foot.mass", "ground.slope")
STEP = 2e-7


def test_derivatives_are_differences():
    """The names are more than the engine takes at once, and some of them move the start."""
    gait = find_gait({"friction": 0.43, "slope": 0.02})
    times = np.sort(np.random.default_rng(1).uniform(0.0, 1.9 * gait.period, 25))
    run = trajectory(gait, times=times, derivatives=NAMES)
    compared = [str(name) for name in run.data_vars if str(name).startswith("d_")]
    for number, by in enumerate(NAMES):

        def at(shift, number=number, by=by):
            if by in COORDINATES:
                apex = gait.apex.copy()
                apex[number] += shift
                return trajectory(gait.runner, apex, times=times)
            runner = gait.runner.replace({by: gait.runner[by] + shift})
            return trajectory(runner, gait.apex, times=times)

        after, before = at(STEP), at(-STEP)
        for name in compared:
            difference = (after[name[2:]] - before[name[2:]]).values / (2.0 * STEP)
            close = np.isclose(run[name].sel(by=by), difference, rtol=2e-5, atol=2e-6)
            assert close.all(), (name, by, times[~close])
    assert len(compared) > 20


def test_a_trajectory_ends_where_the_runner_falls():
    run = trajectory({"friction": 10.0}, [3.0, 2.0, 1.0, 0.7, 0.0, 0.0], times=np.linspace(0.0, 400.0, 50))
    assert run.fallen == 1 and run["status.fallen"].values[-1] == 1
    last = int(np.argmax(run["status.fallen"].values))
    assert 0 < last < 49 and np.all(run["com.y"].values[last:] == run["com.y"].values[-1])
