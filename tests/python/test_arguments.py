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
    search,
    special_points,
    sweeps,
)
from tdmf_slip.analysis.search import periodic_gait
from tdmf_slip.blocks import run_blocks
from tdmf_slip.cli import options
from tdmf_slip.feedback import judgement
from tdmf_slip.fmu import batch, inputs
from tdmf_slip.fmu.simulation import run_unit
from tdmf_slip.library import return_map
from tdmf_slip.paper import settling
from tdmf_slip.variables.parameters import read_parameters

FRICTION, ANGLE = "ground.friction", "hip.touchdown_angle"
START = {FRICTION: 0.2}
RANGES = {"com_height": (1.3, 1.4), "com_speed": (1.0, 1.1)}


@pytest.fixture(scope="module")
def runner():
    return Runner(START)


@pytest.fixture(scope="module")
def found(runner):
    return find_gait(runner)


TAKE_A_RUNNER = {
    "find_gait": lambda given, found: find_gait(given).apex,
    "stride_from": lambda given, found: return_map.stride_from(given, found.apex, FRICTION)[0],
    "run": lambda given, found: Batch(given, [found.apex]).run(2).apex,
    "stride": lambda given, found: Batch(given, found.apex).stride().next_apex,
    "find_gait from a guess": lambda given, found: search.periodic_gait(given, guess=found.apex).apex,
    "sweep": lambda given, found: sweeps.sweep(given, {"ground.friction": [0.3]}).gaits["period"].values,
    "grid": lambda given, found: (
        sweeps.sweep(given, {"ground.friction": [0.3], "leg.damping": [0.2]}).gaits["period"].values
    ),
    "gaits_over": lambda given, found: next(branch_problem.gaits_over(given, FRICTION, [0.3], found)).apex,
    "borders_between": lambda given, found: special_points.borders_between(given, FRICTION, found, found),
    "trace": lambda given, found: branches.trace(given, FRICTION, found, 0.21, max_points=2).values,
    "basin": lambda given, found: basin.basin(given, RANGES, 2)["strides_until_known"],
    "stable_gait": lambda given, found: basin.stable_gait(given).apex,
}


@pytest.mark.parametrize("name", TAKE_A_RUNNER)
def test_start_values_stand_for_a_runner(runner, found, tmp_path, monkeypatch, name):
    call = TAKE_A_RUNNER[name]
    answers = []
    for number, given in enumerate((runner, START)):
        folder = tmp_path / str(number)
        folder.mkdir()
        monkeypatch.chdir(folder)
        answers.append(call(given, found))
    if isinstance(answers[0], dict):
        assert answers[0] == answers[1]
    else:
        np.testing.assert_array_equal(*answers)
    takes_many = name in ("run", "stride", "fates")
    for wrong in (3, found.apex) if takes_many else (["human"], 3, found.apex):
        with pytest.raises(InputError, match=r"runner .*allowed"):
            call(wrong, found)


WRONG = [
    lambda r, o: find_gait(r, guess=["a"] * 6),
    lambda r, o: find_gait(r, guess=o),
    lambda r, o: periodic_gait(r, along=3),
    lambda r, o: periodic_gait(r, along=[FRICTION]),
    lambda r, o: Runner(3),
    lambda r, o: Runner({3: 4}),
    lambda r, o: r.replace({FRICTION: "x"}),
    lambda r, o: r.replace({FRICTION: None}),
    lambda r, o: r.replace({FRICTION: [1, 2]}),
    lambda r, o: Runner(r, tolerance="x"),
    lambda r, o: Batch([r, 3], [o.apex, o.apex]),
    lambda r, o: Batch(r, o),
    lambda r, o: Batch(r, [o.apex]).run(2, r),
    lambda r, o: Batch(r, o.apex).stride(along=[3]),
    lambda r, o: sweeps.sweep(r, {"ground.friction": 0.3}),
    lambda r, o: sweeps.sweep(r, {"ground.friction": "0.3:1:3"}),
    lambda r, o: sweeps.sweep(r, {"ground.friction": ["x"]}),
    lambda r, o: sweeps.sweep(r, {"ground.friction": []}),
    lambda r, o: sweeps.sweep(r, {"ground.friction": [[0.3]]}),
    lambda r, o: sweeps.sweep(r, {"ground.friction": [0.3], "leg.damping": []}),
    lambda r, o: sweeps.sweep(r, {"ground.friction": [0.3], "leg.damping": 0.2}),
    lambda r, o: sweeps.sweep(r, {"ground.friction": [0.3], "leg.damping": ["x"]}),
    lambda r, o: sweeps.sweep(r, {"ground.friction": [0.3], "leg.damping": [0.2]}, path="missing/g.nc"),
    lambda r, o: sweeps.sweep(r, {"ground.friction": [0.3], "leg.damping": [0.2]}, path=3),
    lambda r, o: sweeps.sweep(r, {"ground.friction": [0.3], "solver.relative_tolerance": [0.2]}),
    lambda r, o: next(branch_problem.gaits_over(r, FRICTION, 0.3, o)),
    lambda r, o: next(branch_problem.gaits_over(r, FRICTION, [0.3], r)),
    lambda r, o: next(branch_problem.gaits_over(r, FRICTION, [0.3], o.apex)),
    lambda r, o: special_points.borders_between(r, FRICTION, r, o),
    lambda r, o: branches.trace(r, FRICTION, r, 0.3),
    lambda r, o: branches.trace(r, FRICTION, o, "x"),
    lambda r, o: branches.trace(r, FRICTION, o, float("nan")),
    lambda r, o: branches.trace(r, FRICTION, o, 0.2),
    lambda r, o: branches.trace(r, FRICTION, o, 0.3, max_points=0),
    lambda r, o: branches.trace(r, FRICTION, o, 0.3, max_step=-1),
    lambda r, o: basin.basin(r, {"com_height": (1.3, 1.4)}),
    lambda r, o: basin.basin(r, "com_height"),
    lambda r, o: basin.basin(r, 3),
    lambda r, o: basin.basin(r, RANGES, None),
    lambda r, o: basin.basin(r, dict.fromkeys(RANGES, 1.0)),
    lambda r, o: basin.basin(r, dict.fromkeys(RANGES, "1:2:3")),
    lambda r, o: basin.basin(r, {**RANGES, "com_height": (1, "x")}),
    lambda r, o: basin.basin(r, {**RANGES, "com_height": [[1, 2]]}),
    lambda r, o: basin.basin(r, RANGES, 2, path="missing/map.nc"),
    lambda r, o: basin.basin(r, RANGES, 2, path=3),
    lambda r, o: basin.range_around(r, "com_height"),
    lambda r, o: attraction.volume(r, 10),
    lambda r, o: attraction.volume(o, 1.5),
    lambda r, o: attraction.volume(o, float("nan")),
    lambda r, o: attraction.volume(o, 10, seed=-1),
    lambda r, o: attraction.robustness(START),
    lambda r, o: run_unit("nobody", stop_time=1),
    lambda r, o: run_unit(3, stop_time=1),
    lambda r, o: run_unit({None: 1}, stop_time=1),
    lambda r, o: run_unit(variables=3, stop_time=1),
    lambda r, o: run_unit(variables=[3], stop_time=1),
    lambda r, o: run_unit(inputs="ice.csv", stop_time=1),
    lambda r, o: run_unit(interface=["me"], stop_time=1),
    lambda r, o: run_unit(fmu=3, stop_time=1),
    lambda r, o: settling.settle_fmu("human"),
    lambda r, o: settling.settle_fmu(max_strides="x"),
    lambda r, o: settling.settle_fmu(tolerance="x"),
    lambda r, o: read_parameters(3),
    lambda r, o: options.read_gait("none.json"),
    lambda r, o: tdmf_slip.load_fmu(3),
    lambda r, o: tdmf_slip.fmu_path([2]),
    lambda r, o: batch.simulate_many(START, strides=1),
    lambda r, o: batch.simulate_many(iter([START]), strides=1),
    lambda r, o: batch.simulate_many([3], strides=1),
    lambda r, o: batch.simulate_many([START], strides=0),
    lambda r, o: batch.simulate_many([START], strides=1, interface="x"),
    lambda r, o: batch.simulate_many([START], strides=1, tolerance=5),
    lambda r, o: inputs.read_tables("none.csv", tdmf_slip.load_fmu()),
    lambda r, o: r.state_at([1, 2]),
    lambda r, o: r.start_values("human"),
    lambda r, o: r.replace({"hip.touchdown_angle": "42 kg"}),
    lambda r, o: sweeps.sweep(r, {"ground.friction": ["0.3 kg"]}),
    lambda r, o: branches.trace(r, FRICTION, o, "0.3"),
    lambda r, o: tdmf_slip.continue_branch(r, {FRICTION: (0.6, "low")}),
    lambda r, o: tdmf_slip.continue_branch(r, {FRICTION: (0.6, -1.0)}),
    lambda r, o: tdmf_slip.continue_branch(r, {FRICTION: (0.6, 0.6)}),
    lambda r, o: tdmf_slip.continue_branch(r, {"foot.y": (0.6, 0.7)}),
    lambda r, o: run_blocks(abs, [1, 2], "x").__enter__(),
    lambda r, o: tdmf_slip.controllability(r, [ANGLE]),
    lambda r, o: tdmf_slip.controllability(o, 3),
    lambda r, o: tdmf_slip.controllability(o, [3]),
    lambda r, o: tdmf_slip.controllability(o, [[ANGLE]]),
    lambda r, o: tdmf_slip.dead_beat(START, [ANGLE]),
    lambda r, o: tdmf_slip.dead_beat(o, ["leg.stiffness"]),
    lambda r, o: tdmf_slip.dead_beat(o, [ANGLE], negligible="x"),
    lambda r, o: tdmf_slip.dead_beat(o, [ANGLE], limits={ANGLE: ("x", "1")}),
    lambda r, o: tdmf_slip.lqr(o, [ANGLE], "x"),
    lambda r, o: tdmf_slip.lqr(o, [ANGLE], [[1.0], [2.0, 3.0]]),
    lambda r, o: tdmf_slip.lqr(o, [ANGLE], 1.0, None),
    lambda r, o: tdmf_slip.lqr(o, [ANGLE], np.eye(7)),
    lambda r, o: tdmf_slip.place_poles(o, [ANGLE], 0.3),
    lambda r, o: tdmf_slip.place_poles(o, [ANGLE], "abc"),
    lambda r, o: tdmf_slip.place_poles(o, [ANGLE], np.eye(3)),
    lambda r, o: tdmf_slip.apex_covariance(o),
    lambda r, o: judgement.judge(r),
    lambda r, o: judgement.judge(o, roughness=[-1.0]),
    lambda r, o: judgement.judge_all(o),
    lambda r, o: judgement.judge_all([o]),
]


@pytest.mark.parametrize("number", range(len(WRONG)))
def test_what_is_of_another_kind_is_told(runner, found, tmp_path, monkeypatch, number):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError) as raised:
        WRONG[number](runner, found)
    assert len(str(raised.value).splitlines()) == 1 and len(str(raised.value)) < 400
    assert list(tmp_path.iterdir()) == []


def test_a_wrong_name_is_told_with_the_nearest(runner, found):
    for call in (
        lambda: runner.replace({"leg.dampin": 1.0}),
        lambda: periodic_gait(runner, along="leg.dampin"),
        lambda: branches.trace(runner, "leg.dampin", found, 1.0),
        lambda: run_unit({"leg.dampin": 1.0}),
    ):
        with pytest.raises(InputError, match=r"near matches: leg\.damping"):
            call()


def test_start_values_may_be_texts_with_a_unit():
    angle = "hip.touchdown_angle"
    assert Runner({angle: "42 deg"})[angle] == pytest.approx(np.radians(42.0))
    assert run_unit({angle: "42 deg"}, stop_time=1).final[angle] == pytest.approx(np.radians(42.0))


def test_a_unit_may_be_given_as_it_is_or_by_its_path():
    fmu = tdmf_slip.load_fmu()
    assert tdmf_slip.load_fmu(fmu) is fmu
    assert run_unit(fmu=tdmf_slip.fmu_path(), stop_time=1).final["time"] == 1.0


def test_start_values_of_a_gait_begin_on_it(found):
    run = run_unit(found.start_values, strides=1)
    assert run.stride["word"] == found.word
    assert run.stride["period"] == pytest.approx(found.period, rel=1e-6)
