"""Friction that falls with the foot's speed: the limits in which it is another law, by each solver."""

import fmpy
import numpy as np
import pytest
import tdmf_slip
from conftest import CLAMPED
from tdmf_slip import Batch
from tdmf_slip.library.engine import instruction_sets
from tdmf_slip.library.section import COORDINATES

SLOW = 10.0 ** np.array([-4.0, -5.0, -6.0])
FAST = 10.0 ** np.array([5.0, 6.0, 7.0])


def end_of_stride(runner, apex, velocities=0.0):
    """Word and end of a stride, for each velocity at which the friction falls."""
    made = tdmf_slip.stride_map(
        runner | {"ground.stribeck_velocity": np.atleast_1d(velocities)}, apex, tolerance=1e-13
    )
    assert (made["fate"] == 0).all()
    return made["word"].values[:, 0].tolist(), made["next_apex"].values[:, 0]


def runner_and_apex(friction, ratio):
    runner = {"ground.friction": friction, "ground.static_friction_ratio": ratio, **CLAMPED}
    return runner, tdmf_slip.find_gait(runner).apex


@pytest.mark.parametrize(("friction", "ratio"), [(0.3, 2.0), (0.2, 1.5)])
def test_friction_that_falls_at_once_is_static_and_sliding_friction(friction, ratio):
    """The distance goes to 0 as v ln(1/v): so long the foot lingers in the layer when its slip begins."""
    runner, apex = runner_and_apex(friction, ratio)
    (word,), at_once = end_of_stride(runner, apex)
    words, ends = end_of_stride(runner, apex, SLOW)
    assert words == [word] * 3 == ["+0-"] * 3
    distance = np.abs(ends - at_once).max(axis=1) / SLOW
    steps = np.diff(distance) / np.diff(np.log(1.0 / SLOW))
    assert steps[1] == pytest.approx(steps[0], rel=0.03) and steps[0] > 0.1


def test_a_slip_that_begins_just_before_lift_off_leaves_the_layer_late():
    """The distance goes to 0 as v ln(1/v), with a larger factor where the slip leaves the layer.

    The slip begins 4.6e-4 before the force is gone: as this falls as a t, a slip grows by itself while
    mu (rho - 1) a t^2 / (m_f v) is some 10, so for v above 1e-7 it is in the layer until the end.
    """
    runner, apex = runner_and_apex(0.6, 1.5)
    velocities = 10.0 ** -np.arange(3.0, 12.0)
    (word,), at_once = end_of_stride(runner, apex)
    words, ends = end_of_stride(runner, apex, velocities)
    assert words == [word] * len(velocities) == ["+0-0+"] * len(velocities)
    distance = np.abs(ends - at_once).max(axis=1) / velocities
    factor = np.diff(distance) / np.log(10.0)
    assert factor[1] == pytest.approx(factor[0], rel=0.02)
    assert factor[-1] == pytest.approx(factor[-2], rel=0.02) and factor[-1] > 5.0 * factor[0]
    assert np.all(np.diff(factor[1:]) > 0.0)


# ---- a velocity so small that a step may jump over the layer ----------------------------------------

SMALLEST = 1e-6
OUTPUT = [f"apex.{name}" for name in COORDINATES] + [
    "stride.count",
    "solver.layer_steps",
]


@pytest.mark.parametrize(
    ("interface", "method", "tolerance", "version"),
    [
        ("CoSimulation", 1, 1e-11, ""),
        ("CoSimulation", 2, 1e-11, ""),
        ("ModelExchange", 1, 1e-11, ""),
        ("ModelExchange", 1, 1e-11, "3"),
    ],
    ids=["native", "CVODE", "Model Exchange", "Model Exchange, FMI 3"],
)
@pytest.mark.parametrize(("friction", "ratio"), [(0.6, 1.5), (0.3, 2.0)])
def test_no_solver_jumps_over_the_layer(friction, ratio, interface, method, tolerance, version, request):
    """Each solver keeps a hundredth of the layer's effect, which is the distance to the stride at v = 0."""
    runner, apex = runner_and_apex(friction, ratio)
    falling = runner | {"ground.stribeck_velocity": SMALLEST}
    _, (at_once,) = end_of_stride(runner, apex)
    _, (end,) = end_of_stride(runner, apex, SMALLEST)
    period = tdmf_slip.stride_map(falling, apex)["period"].item()
    rows = fmpy.simulate_fmu(
        request.getfixturevalue(f"unpacked{version}"),
        model_description=request.getfixturevalue(f"description{version}"),
        fmi_type=interface,
        stop_time=1.001 * period,
        output_interval=period / 100,
        relative_tolerance=tolerance,
        start_values=tdmf_slip.Runner(falling).start_values(apex) | {"solver.method": method},
        output=OUTPUT,
    )
    assert rows["stride.count"][-1] == 1
    found = np.array([rows[name][-1] for name in OUTPUT[:6]])
    assert np.abs(found - end).max() < 0.05 * np.abs(end - at_once).max()
    assert interface == "ModelExchange" or rows["solver.layer_steps"][-1] > 0


@pytest.mark.parametrize("instructions", instruction_sets())
def test_the_engine_counts_the_steps_in_the_layer(instructions):
    runner, apex = runner_and_apex(0.3, 2.0)
    counted = []
    for velocity in (0.0, SMALLEST):
        batch = Batch(runner | {"ground.stribeck_velocity": velocity}, [apex], instructions=instructions)
        work = batch.run(1).attributes["work_done"]
        counted.append(work["layer_steps"])
        assert work["layer_steps"] < work["steps"]
    assert counted[0] == 0 < 10 < counted[1]


@pytest.mark.parametrize(("friction", "ratio"), [(0.6, 1.5), (0.3, 2.0), (0.2, 1.5)])
def test_friction_that_hardly_falls_is_the_static_one(friction, ratio):
    """The distance goes to 0 as 1/v."""
    runner, apex = runner_and_apex(friction, ratio)
    _, static = end_of_stride({"ground.friction": friction * ratio, **CLAMPED}, apex)
    _, ends = end_of_stride(runner, apex, FAST)
    distance = np.abs(ends - static).max(axis=1) * FAST
    assert distance == pytest.approx(distance[0], rel=1e-3) and distance[0] > 0.01
