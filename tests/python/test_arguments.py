"""Arguments of the Python functions: start values stand for a runner, and what is of another kind is told."""

import numpy as np
import pytest
import tdmf_slip
from tdmf_slip import Batch, InputError, Runner, find_gait
from tdmf_slip.analysis import (
    attraction,
    basin,
    branch_problem,
    branches,
    special_points,
    sweeps,
)
from tdmf_slip.analysis.search import periodic_gait
from tdmf_slip.cli import options
from tdmf_slip.feedback import judgement
from tdmf_slip.fmu import batch, inputs
from tdmf_slip.fmu.simulation import run_unit
from tdmf_slip.paper import settling

FRICTION, ANGLE = "ground.friction", "hip.touchdown_angle"
START = {FRICTION: 0.2}
RANGES = {"com_height": (1.3, 1.4), "com_speed": (1.0, 1.1)}


@pytest.fixture(scope="module")
def runner():
    return Runner(START)


@pytest.fixture(scope="module")
def found(runner):
    return find_gait(runner)


WRONG = [
    lambda r, o: periodic_gait(r, along=3),
    lambda r, o: r.replace({FRICTION: "x"}),
    lambda r, o: Runner(r, tolerance="x"),
    lambda r, o: Batch([r, 3], [o.apex, o.apex]),
    lambda r, o: sweeps.sweep(r, {"ground.friction": "0.3:1:3"}),
    lambda r, o: sweeps.sweep(r, {"ground.friction": [0.3], "leg.damping": []}),
    lambda r, o: sweeps.sweep(r, {"ground.friction": [0.3], "leg.damping": [0.2]}, path="missing/g.nc"),
    lambda r, o: sweeps.sweep(r, {"ground.friction": [0.3], "solver.relative_tolerance": [0.2]}),
    lambda r, o: next(branch_problem.gaits_over(r, FRICTION, 0.3, o)),
    lambda r, o: next(branch_problem.gaits_over(r, FRICTION, [0.3], r)),
    lambda r, o: special_points.borders_between(r, FRICTION, r, o),
    lambda r, o: branches.trace(r, FRICTION, r, 0.3),
    lambda r, o: branches.trace(r, FRICTION, o, "x"),
    lambda r, o: branches.trace(r, FRICTION, o, float("nan")),
    lambda r, o: branches.trace(r, FRICTION, o, 0.2),
    lambda r, o: branches.trace(r, FRICTION, o, 0.3, max_points=0),
    lambda r, o: branches.trace(r, FRICTION, o, 0.3, max_step=-1),
    lambda r, o: basin.basin(r, dict.fromkeys(RANGES, 1.0)),
    lambda r, o: basin.basin(r, RANGES, 2, path="missing/map.nc"),
    lambda r, o: basin.range_around(r, "com_height"),
    lambda r, o: attraction.volume(r, 10),
    lambda r, o: attraction.volume(o, 1.5),
    lambda r, o: attraction.volume(o, 10, seed=-1),
    lambda r, o: attraction.robustness(START),
    lambda r, o: run_unit(inputs="ice.csv", stop_time=1),
    lambda r, o: settling.settle_fmu("human"),
    lambda r, o: settling.settle_fmu(max_strides="x"),
    lambda r, o: settling.settle_fmu(tolerance="x"),
    lambda r, o: options.read_gait("none.json"),
    lambda r, o: batch.simulate_many([START], strides=1, interface="x"),
    lambda r, o: batch.simulate_many([START], strides=1, tolerance=5),
    lambda r, o: inputs.read_tables("none.csv", tdmf_slip.load_fmu()),
    lambda r, o: r.state_at([1, 2]),
    lambda r, o: r.replace({"hip.touchdown_angle": "42 kg"}),
    lambda r, o: sweeps.sweep(r, {"ground.friction": ["0.3 kg"]}),
    lambda r, o: branches.trace(r, FRICTION, o, "0.3"),
    lambda r, o: tdmf_slip.continue_branch(r, {FRICTION: (0.6, "low")}),
    lambda r, o: tdmf_slip.continue_branch(r, {FRICTION: (0.6, -1.0)}),
    lambda r, o: tdmf_slip.continue_branch(r, {FRICTION: (0.6, 0.6)}),
    lambda r, o: tdmf_slip.continue_branch(r, {"foot.y": (0.6, 0.7)}),
    lambda r, o: tdmf_slip.dead_beat(o, ["leg.stiffness"]),
    lambda r, o: tdmf_slip.dead_beat(o, [ANGLE], negligible="x"),
    lambda r, o: tdmf_slip.dead_beat(o, [ANGLE], limits={ANGLE: ("x", "1")}),
    lambda r, o: tdmf_slip.lqr(o, [ANGLE], [[1.0], [2.0, 3.0]]),
    lambda r, o: tdmf_slip.lqr(o, [ANGLE], np.eye(7)),
    lambda r, o: tdmf_slip.place_poles(o, [ANGLE], np.eye(3)),
    lambda r, o: judgement.judge(r),
    lambda r, o: judgement.judge(o, roughness=[-1.0]),
    lambda r, o: judgement.judge_all(o),
]


@pytest.mark.parametrize("number", range(len(WRONG)))
def test_what_is_of_another_kind_is_told(runner, found, tmp_path, monkeypatch, number):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError) as raised:
        WRONG[number](runner, found)
    assert len(str(raised.value).splitlines()) == 1 and len(str(raised.value)) < 400
    assert list(tmp_path.iterdir()) == []
