"""Arguments that are of another kind, out of range or too large: one sentence, and nothing half-written."""

import numpy as np
import pandas
import pytest
import tdmf_slip
from tdmf_slip import (
    Batch,
    InputError,
    Profile,
    RoughGround,
    Runner,
    basin,
    compare,
    continue_branch,
    continue_curves,
    dead_beat,
    find_gait,
    lqr,
    optimize,
    place_poles,
    simulate_many,
    stride_map,
    strides_to_fall,
    sweep,
    trajectory,
)
from tdmf_slip.analysis import attraction
from tdmf_slip.analysis.along import gaits_over
from tdmf_slip.analysis.basin import range_around
from tdmf_slip.analysis.search import periodic_gait
from tdmf_slip.analysis.stability import stability
from tdmf_slip.cli import options
from tdmf_slip.fmu import inputs
from tdmf_slip.fmu.simulation import run_unit
from tdmf_slip.paper import settling
from tdmf_slip.variables.parameters import read_parameters

FRICTION, ANGLE, DAMPING = "ground.friction", "hip.touchdown_angle", "leg.damping"
TORQUE = "hip.stance_torque"
START = {FRICTION: 0.2}
RANGES = {"com_height": (1.3, 1.4), "com_speed": (1.0, 1.1)}
PATCH = {FRICTION: 0.6, "ground.patch_begin": 12.45, "ground.patch_end": 12.52}
SECOND = {"ground.patch_end": [12.45, 12.52]}
DATES = pandas.to_datetime(["2026-01-01 00:00:00", "2026-01-01 00:00:05"])
SECONDS = pandas.to_timedelta([0.0, 5.0], unit="s")
MASKED = np.ma.masked_array([0.0, 5.0], [False, True])
SIX = np.ma.masked_array(np.ones(6), [1, 0, 0, 0, 0, 0])
MANY = np.broadcast_to([1.3, 1.0, 1.0, 0.0, 0.0, 0.0], (10**9, 6))
HALF = np.broadcast_to(0.5, 10**9)
ALLOWED = "is not allowed; allowed: "


@pytest.fixture(scope="module")
def runner():
    return Runner(START)


@pytest.fixture(scope="module")
def gait(runner):
    return find_gait(runner)


def follow(times, values):
    """Run the unit with a table of friction."""
    run_unit({}, inputs={FRICTION: (times, values)}, stop_time=6.0)


def known(priors):
    """Fit two quantities with some priors."""
    data, errors = {"speed": [1.0], "frequency": [0.04]}, {"speed": 0.01, "frequency": 0.001}
    tdmf_slip.fit(None, data, ["leg.stiffness"], vary_each=[TORQUE], errors=errors, priors=priors)


REFUSED = [
    (lambda r, g: periodic_gait(r, along=3), "."),
    (lambda r, g: r.replace({FRICTION: "x"}), "."),
    (lambda r, g: Runner(r, tolerance="x"), "."),
    (lambda r, g: Batch([r, 3], [g.apex, g.apex]), "."),
    (lambda r, g: sweep(r, {"ground.friction": "0.3:1:3"}), "."),
    (lambda r, g: sweep(r, {"ground.friction": [0.3], "leg.damping": []}), "."),
    (lambda r, g: sweep(r, {"ground.friction": [0.3], "leg.damping": [0.2]}, path="missing/g.nc"), "."),
    (lambda r, g: sweep(r, {"ground.friction": [0.3], "solver.relative_tolerance": [0.2]}), "."),
    (lambda r, g: next(gaits_over(r, FRICTION, 0.3, g)), "."),
    (lambda r, g: next(gaits_over(r, FRICTION, [0.3], r)), "."),
    (lambda r, g: basin(r, dict.fromkeys(RANGES, 1.0)), "."),
    (lambda r, g: basin(r, RANGES, 2, path="missing/map.nc"), "."),
    (lambda r, g: range_around(r, "com_height"), "."),
    (lambda r, g: attraction.attraction_volume(r, 10), "."),
    (lambda r, g: attraction.attraction_volume(g, 1.5), "."),
    (lambda r, g: attraction.attraction_volume(g, 10, seed=-1), "."),
    (lambda r, g: attraction.robustness(START), "."),
    (lambda r, g: run_unit(inputs="ice.csv", stop_time=1), "."),
    (lambda r, g: settling.settle_fmu("human"), "."),
    (lambda r, g: settling.settle_fmu(tolerance="x"), "."),
    (lambda r, g: options.read_gait("none.json"), "."),
    (lambda r, g: simulate_many([START], strides=1, interface="x"), "."),
    (lambda r, g: simulate_many([START], strides=1, tolerance=5), "."),
    (lambda r, g: inputs.read_tables("none.csv", tdmf_slip.load_fmu()), "."),
    (lambda r, g: r.state_at([1, 2]), "."),
    (lambda r, g: r.replace({"hip.touchdown_angle": "42 kg"}), "."),
    (lambda r, g: sweep(r, {"ground.friction": ["0.3 kg"]}), "."),
    (lambda r, g: continue_branch(r, {FRICTION: (0.6, "low")}), "."),
    (lambda r, g: continue_branch(g, {FRICTION: (0.2, float("nan"))}), "."),
    (lambda r, g: continue_branch(g, {FRICTION: (0.2, 0.3)}, max_points=0), "."),
    (lambda r, g: continue_branch(g, {FRICTION: (0.2, 0.3)}, max_step=-1), "."),
    (lambda r, g: continue_branch(r, {FRICTION: (0.6, -1.0)}), "."),
    (lambda r, g: continue_branch(r, {FRICTION: (0.6, 0.6)}), "."),
    (lambda r, g: continue_branch(r, {"foot.y": (0.6, 0.7)}), "."),
    (lambda r, g: dead_beat(g, ["leg.stiffness"]), "."),
    (lambda r, g: dead_beat(g, [ANGLE], negligible="x"), "."),
    (lambda r, g: dead_beat(g, [ANGLE], limits={ANGLE: ("x", "1")}), "."),
    (lambda r, g: lqr(g, [ANGLE], [[1.0], [2.0, 3.0]]), "."),
    (lambda r, g: lqr(g, [ANGLE], np.eye(7)), "."),
    (lambda r, g: place_poles(g, [ANGLE], np.eye(3)), "."),
    (lambda r, g: stride_map({}, MANY), "apices: 6,000,000,000 numbers; allowed: up to"),
    (lambda r, g: Batch(g.runner, g.apex).run(1, MANY), "until: 6,000,000,000 .*up to"),
    (lambda r, g: sweep({}, {FRICTION: HALF}), "vary ground.friction: 1,000,000,000 values; allowed: up to"),
    (lambda r, g: Batch(r, MANY), "apices: 6,000,000,000 numbers; allowed: up to"),
    (lambda r, g: stride_map(r, [g.apex] * 100, strides=10**6), "100,000,000 strides in all; allowed: up to"),
    (lambda r, g: stride_map({DAMPING: HALF}, g.apex), "1,000,000,000 numbers; allowed: up to"),
    (lambda r, g: stride_map(r, g.apex, strides=10**6, inputs={TORQUE: HALF}), "1,000,000,000 numbers; all"),
    (lambda r, g: basin(r, n=100_000), r"10,000,000,000 starts \(100,000 by 100,000\); allowed: up to"),
    (lambda r, g: stability({}, {FRICTION: HALF, DAMPING: [0.2]}), "1,000,000,000 values; allowed: up to"),
    (lambda r, g: run_unit(interface=np.array(["me", "cs"])), "interface array.*allowed: me, cs"),
    (lambda r, g: find_gait(r, model=np.zeros(2)), "model array.*allowed"),
    (lambda r, g: Batch(r, g.apex, instructions=np.zeros(2)), "instructions array.*allowed"),
    (lambda r, g: optimize(r, {TORQUE: (0.1, 0.3)}, minimize=np.zeros(2)), "minimize: array.*allowed"),
    (lambda r, g: strides_to_fall(r, 0.1, runners=np.zeros(2)), "runners = array.*allowed"),
    (lambda r, g: basin(r, path="\0.nc"), "null"),
    (lambda r, g: sweep({}, {3: [0.5]}), "vary: 3 is not allowed"),
    (lambda r, g: basin({}, np.zeros(2)), "axes: 0.0 is not allowed; allowed: com_height"),
    (lambda r, g: strides_to_fall({}, 0.5, gait=g.apex), "gait = array.*allowed: a Gait"),
    (lambda r, g: run_unit(profile=(1, 2)), r"profile = \(1, 2\) is not allowed; allowed: a Profile"),
    (lambda r, g: continue_curves({}, None), "vary: 0 names; .*two parameters"),
    (lambda r, g: continue_curves({}, 0.3), r"vary = 0\.3 .*two parameters"),
    (
        lambda r, g: continue_curves({}, {FRICTION: (0.3, 0.4, 0.5), DAMPING: (0.2, 0.3)}),
        r"vary ground\.friction = \(0.*ends",
    ),
    (lambda r, g: tdmf_slip.load_fmu("\0"), "cannot be read as an FMU"),
    (lambda r, g: read_parameters("\0.toml"), "null"),
    (
        lambda r, g: find_gait({}, guess=pandas.Series(dict.fromkeys("abcdef", 1.0))),
        "with a, b, c, d, e, f; allowed: com_h",
    ),
    (
        lambda r, g: find_gait(pandas.Series([0.5, 0.6], index=[FRICTION] * 2)),
        r"ground\.friction is given twice",
    ),
    (lambda r, g: run_unit({}, inputs=pandas.DataFrame({FRICTION: [0.5]})), "time"),
    (lambda r, g: follow(DATES, [0.6, 0.3]), ALLOWED),
    (lambda r, g: run_unit({}, stop_time=np.datetime64("2026-01-01")), ALLOWED),
    (lambda r, g: follow([0.0, 5.0], SECONDS), ALLOWED),
    (lambda r, g: find_gait({FRICTION: np.timedelta64(1, "s")}), ALLOWED),
    (lambda r, g: Profile(DATES, [0.0, 1.0]), ALLOWED),
    (lambda r, g: sweep({}, {FRICTION: SECONDS}), ALLOWED),
    (lambda r, g: follow([0.0, 5.0], [0.6, 0.3 + 1j]), ALLOWED),
    (lambda r, g: find_gait({}, guess=np.ones(6) * (1 + 1j)), ALLOWED),
    (lambda r, g: find_gait({FRICTION: np.complex128(0.6 + 1j)}), ALLOWED),
    (lambda r, g: follow(MASKED, [0.6, 0.3]), ALLOWED),
    (lambda r, g: Profile(MASKED, [0.0, 1.0]), ALLOWED),
    (lambda r, g: find_gait({}, guess=SIX), ALLOWED),
    (lambda r, g: stride_map({}, [np.ones(6), SIX]), ALLOWED),
    (lambda r, g: find_gait({FRICTION: np.ma.masked}), ALLOWED),
    (lambda r, g: sweep({}, {FRICTION: np.ma.masked_array([0.5, 0.6], [1, 0])}), ALLOWED),
    (lambda r, g: continue_branch({}, {FRICTION: MASKED}), ALLOWED),
    (lambda r, g: follow([0.0, 5.0], [True, False]), ALLOWED),
    (lambda r, g: Profile.steps(DATES, [0.0, 1.0, 0.0]), ALLOWED),
    (lambda r, g: lqr(g, [ANGLE], np.eye(6) * 1j), ALLOWED),
    (lambda r, g: stride_map({FRICTION: SIX}, np.ones((6, 6))), ALLOWED),
    (lambda r, g: stride_map({}, np.ones((6, 6)), foot_x=SIX), ALLOWED),
    (lambda r, g: stride_map({}, np.ones(6), strides=6, inputs={FRICTION: SIX}), ALLOWED),
    (lambda r, g: RoughGround(friction_spread=-1.0), "friction_spread"),
    (lambda r, g: RoughGround(friction_spread=np.nan), "friction_spread"),
    (lambda r, g: RoughGround(step_weights=(np.nan,)), "step_weights"),
    (lambda r, g: RoughGround(step_weights=[1.0] * 5000), "step_weights"),
    (lambda r, g: RoughGround(friction_weights="no"), "friction_weights"),
    (lambda r, g: RoughGround(segment_length=-1.0), "segment_length"),
    (lambda r, g: RoughGround(heights=(0.1, 0.2)), "heights without a segment_length"),
    (lambda r, g: RoughGround(0.1, segment_length=1.0, heights=(0.1,)), "roughness = 0.1 with heights"),
    (lambda r, g: RoughGround(segment_length=1.0, heights=(np.nan,)), "heights"),
    (
        lambda r, g: Batch(r, g.apex, RoughGround(segment_length=1e-4)),
        "segment_length = 0.0001 m .* allowed: 0.001 m or",
    ),
    (
        lambda r, g: Batch({"ground.slope": 0.05}, g.apex, RoughGround(segment_length=1.0)),
        "slope = 0.05 on a terrain",
    ),
    (
        lambda r, g: Batch({"body.external_fx": 1e-3}, g.apex, RoughGround(segment_length=1.0)),
        "body.external_fx",
    ),
    (lambda r, g: Batch(r, g.apex, RoughGround(segment_length=1.0)).run(1, g), "gaits on a terrain"),
    (
        lambda r, g: Batch(Runner(model="reduced"), [1.4, 1.05], RoughGround(friction_spread=0.1)),
        "ground: the reduced map has no ground that varies",
    ),
    (lambda r, g: tdmf_slip.rare_falls(r, RoughGround(0.1, segment_length=1.0), gait=g), "segment_length"),
    (lambda r, g: Profile([0.0, 1.0], [0.0]), "equally long"),
    (lambda r, g: Profile([1.0, 0.0], [0.0, 0.0]), "ascending"),
    (lambda r, g: Profile([0.0, np.nan], [0.0, 0.0]), "finite"),
    (lambda r, g: Profile(["a"], [0.0]), "numbers"),
    (lambda r, g: Profile.steps([1.0, 2.0], [0.0, 1.0]), "a height more than edges"),
    (lambda r, g: Profile.random_steps(0, 1.0, 0.1, 1), "count"),
    (lambda r, g: Profile.random_steps(5, 1.0, -0.1, 1), "roughness"),
    (lambda r, g: run_unit(profile=Profile([0.0], [0.0]), interface="me"), "interface = 'me'"),
    (
        lambda r, g: run_unit(profile=Profile([0.0], [0.0]), inputs={"ground.slope": ([0.0], [0.0])}),
        "one of them",
    ),
    (lambda r, g: run_unit(profile=Profile([0.0, 1.0], [0.0, 3.0]), strides=1), "ground.slope"),
    (lambda r, g: find_gait(PATCH), r"patch_end = 12\.52"),
    (lambda r, g: find_gait(PATCH, model="reduced"), r"patch_end = 12\.52"),
    (lambda r, g: basin(PATCH, n=2), r"patch_end = 12\.52"),
    (lambda r, g: stride_map(PATCH | SECOND, [[1.4, 1.05]] * 2, model="reduced"), r"patch_end = 12\.52"),
    (lambda r, g: Batch(PATCH, g.apex).run(1, g.apex), r"patch_end = 12\.52"),
    (lambda r, g: Batch(PATCH, g.apex).stride(), r"patch_end = 12\.52"),
    (
        lambda r, g: stride_map(PATCH, [g.apex] * 2, foot_x=[0.0, 1.0, 2.0]),
        "apices of 2 runners, foot_x of 3",
    ),
    (lambda r, g: stride_map(PATCH, [g.apex] * 2, foot_x=np.nan), "foot_x.*nan"),
    (lambda r, g: stride_map(PATCH, [g.apex] * 2, foot_x=[[0.0]]), "foot_x"),
    (lambda r, g: stride_map(PATCH, [g.apex] * 2, foot_x="here"), "foot_x"),
    (lambda r, g: strides_to_fall(PATCH, 0.0, runners=3, max_strides=1, foot_x="anywhere"), "foot_x"),
    (lambda r, g: r.replace({FRICTION: -1.0}), r"ground\.friction = -1"),
    (lambda r, g: r.replace({"nosuch": 1.0}), "nosuch"),
    (lambda r, g: Runner(r, tolerance=np.nan), "tolerance"),
    (lambda r, g: Runner(r, tolerance=0.0), "tolerance"),
    (lambda r, g: find_gait(r.replace({"foot.y": 0.0, "leg.length_rate": 1.0})), "begins in flight"),
    (lambda r, g: find_gait(r.replace({"foot.y": -0.1})), r"foot\.y = -0\.1"),
    (lambda r, g: find_gait(r.replace({FRICTION: 0.0})), "speed"),
    (lambda r, g: find_gait(r, guess=[1.0, 2.0]), "shape"),
    (lambda r, g: find_gait(r, guess=[np.nan] * 6), "guess = .*finite"),
    (lambda r, g: periodic_gait(r, along="nosuch"), "nosuch"),
    (lambda r, g: trajectory(r, times=[1.0, 0.5]), "times = .*rising order"),
    (lambda r, g: trajectory(r, times=[-1.0]), "times"),
    (lambda r, g: trajectory(r, times=[]), "times"),
    (lambda r, g: trajectory(r, times=[np.nan]), "times"),
    (lambda r, g: trajectory(r, times=[0.0], derivatives=["speed"]), "derivatives: 'speed' .*com_speed"),
    (lambda r, g: trajectory(r, times=[0.0], derivatives=3), "derivatives"),
    (lambda r, g: trajectory(r, [1.0, 1.0], times=[0.0]), "an apex of shape"),
    (lambda r, g: trajectory(r, [0.1, 1.0, 1.0, 0.1, 0.0, 0.0], times=[0.0]), r"foot\.y"),
    (lambda r, g: compare([r], hold=["speed"], vary=[TORQUE]), "runners: 1 given; allowed: two or more"),
    (lambda r, g: compare([r, {}], hold=[], vary=[TORQUE]), "hold: nothing is held"),
    (
        lambda r, g: compare([r, {}], hold=["velocity"], vary=[TORQUE]),
        "hold: 'velocity' is not allowed; near",
    ),
    (lambda r, g: compare([r, {}], hold=["speed"] * 2, vary=[TORQUE]), "hold: speed is given twice"),
    (lambda r, g: compare([r, {}], hold=["speed", "length"], vary=[TORQUE]), "at least as many"),
    (lambda r, g: compare([r, {}], hold=["speed"], vary=["hip.torq"]), "hip.torq"),
    *(
        (lambda r, g, ends=ends: basin(r, RANGES | {"com_speed": ends}, 2), "axes: com_speed = .*two finite")
        for ends in ((), (1.0,), (1.5, 1.2), (1.0, 1.0), (1.0, np.nan))
    ),
    *((lambda r, g, n=n: basin(r, RANGES, n), "n = .*allowed") for n in (1, 0, 2.5, (3,), (3, 4, 5), "3")),
    (lambda r, g: basin(r, RANGES, 2, refine="coarse"), "refine = 'coarse' .*allowed: exact, preview"),
    (lambda r, g: stability(r, {}), "vary"),
    (lambda r, g: stability(r, {"leg.damp": [0.1]}), "vary"),
    (lambda r, g: stability(r, {"foot.x": [0.0]}), "vary"),
    (lambda r, g: known({"leg.stifness": (1.0, 0.1)}), "leg.stiffness"),
    (lambda r, g: known({"leg.stiffness": 1.0}), "a value and its standard error"),
    (lambda r, g: known({"leg.stiffness": (1.0, 0.0)}), "a standard error above 0"),
    (lambda r, g: known({"leg.stiffness": (1.0, np.nan)}), "a standard error above 0"),
    (lambda r, g: known({"leg.stiffness": (-1.0, 0.1)}), "-1"),
    (lambda r, g: known({TORQUE: (0.2, 0.1)}), "a parameter that all rows share"),
    (lambda r, g: known(3), "priors"),
]


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("number", range(len(REFUSED)))
def test_what_cannot_be_gets_one_sentence(runner, gait, tmp_path, monkeypatch, number):
    call, sentence = REFUSED[number]
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError, match=sentence) as raised:
        call(runner, gait)
    assert len(str(raised.value).splitlines()) == 1 and len(str(raised.value)) < 400
    assert list(tmp_path.iterdir()) == []
