"""A patch of slippery ground: runs of an independent program by engine and unit, and who refuses a patch."""

import json
import pathlib

import fmpy
import numpy as np
import pytest
import tdmf_slip
from conftest import CLAMPED
from test_further_gaits import LEDGER, WORKS, start_of

RUNS = json.loads(pathlib.Path(__file__).with_name("patch_runs.json").read_text(encoding="utf-8"))["runs"]
APEX = [f"apex.{name}" for name in tdmf_slip.library.section.COORDINATES]
OUTPUT = (*APEX, "stride.count", "energy.total", *LEDGER)
PATCH = {"ground.friction": 0.6, "ground.patch_begin": 12.45, "ground.patch_end": 12.52}
each_run = pytest.mark.parametrize("run_over", RUNS, ids=lambda run_over: run_over["name"])


def moved(run_over, by):
    """The same run on ground that is moved along itself."""
    given = run_over["start_values"] | CLAMPED
    return given | {name: given.get(name, 0.0) + by for name in ("ground.patch_begin", "ground.patch_end")}


def start_with_the_foot_at_0(run_over):
    """The centre of mass is over the ground below itself, which on a slope is at another height than at 0."""
    start = start_of(run_over)
    body_ahead = -start["foot.x"]
    slope = run_over["start_values"].get("ground.slope", 0.0)
    return start | {"foot.x": 0.0, "foot.y": start["foot.y"] + body_ahead * np.tan(slope)}


@each_run
@pytest.mark.parametrize("by", [0.0, -40.0], ids=["at 0", "at -40 m"])
def test_the_engine_makes_each_stride(run_over, by):
    made = tdmf_slip.stride_map(
        moved(run_over, by), run_over["apex"], strides=len(run_over["words"]), foot_x=by, tolerance=1e-13
    )
    assert made["word"].values[0].tolist() == run_over["words"]
    assert made["next_apex"].values[0, -1] == pytest.approx(run_over["end"]["apex"], rel=1e-8, abs=1e-8)
    assert made["foot.x"].values[0, -1] == pytest.approx(run_over["end"]["foot.x"] + by, rel=1e-9)


each_closed_run = pytest.mark.parametrize(
    "run_over", [run for run in RUNS if "fall" not in run], ids=lambda run: run["name"]
)


def assert_ends_as(run_over, rows, tolerance):
    assert rows["stride.count"][-1] == len(run_over["words"])
    found = [rows[name][-1] for name in APEX]
    assert found == pytest.approx(run_over["end"]["apex"], rel=tolerance, abs=tolerance)
    given_or_taken = {name: rows[name][-1] - rows[name][0] for name in LEDGER}
    gained = sum(amount if name in WORKS else -amount for name, amount in given_or_taken.items())
    assert rows["energy.total"][-1] - rows["energy.total"][0] == pytest.approx(gained, abs=tolerance)
    assert given_or_taken["energy.friction_loss"] > 0.0


@each_closed_run
@pytest.mark.parametrize("method", [1, 2], ids=["native", "cvode"])
def test_co_simulation(run_over, method, unpacked, description):
    rows = fmpy.simulate_fmu(
        unpacked,
        model_description=description,
        fmi_type="CoSimulation",
        stop_time=run_over["end"]["time"] * 1.001,
        output_interval=run_over["end"]["time"] / 100,
        relative_tolerance=1e-13,
        start_values=start_with_the_foot_at_0(run_over) | {"solver.method": method},
        output=OUTPUT,
    )
    assert_ends_as(run_over, rows, 1e-8)


@each_closed_run
def test_model_exchange(run_over, run):
    rows, _ = run(
        run_over["end"]["time"] * 1.001, start_with_the_foot_at_0(run_over), tolerance=1e-12, output=OUTPUT
    )
    assert_ends_as(run_over, rows, 1e-6)


@pytest.mark.parametrize("friction", [0.6, 0.2])
def test_a_patch_of_no_length_changes_no_bit(friction):
    """The strides are those of the published gaits; the patch has any friction and position."""
    runner = {"ground.friction": friction}
    apex = tdmf_slip.find_gait(runner).apex
    as_ever = tdmf_slip.stride_map(runner, apex, strides=2)
    nothing = {"ground.patch_begin": 12.5, "ground.patch_end": 12.5, "ground.patch_friction": 0.01}
    with_it = tdmf_slip.stride_map(runner | nothing, apex, strides=2)
    compared = [name for name in as_ever.data_vars if as_ever[name].dtype.kind == "f"]
    assert len(compared) > 15
    for name in compared:
        assert with_it[name].values.tobytes() == as_ever[name].values.tobytes(), name


def test_where_a_foot_lands_decides():
    """Runners that differ in the position of their feet alone: over the patch, before and behind it."""
    (first,) = (run for run in RUNS if run["name"] == "P1")
    positions = np.array([0.0, -30.0, 30.0])
    made = tdmf_slip.stride_map(first["start_values"], first["apex"], foot_x=positions)
    over, before, behind = made["next_apex"].values[:, 0]
    assert before == pytest.approx(behind, rel=1e-9) and abs(over - before).max() > 0.01
    length = made["foot.x"].values[:, 0] - positions
    assert length[1] == pytest.approx(length[2], rel=1e-9) and abs(length[0] - length[1]) > 0.1


# ---- strides until the fall -----------------------------------------------------------------------------

# Downhill the foot is sped up on ice, and falls where grip returns.
DOWNHILL = {
    "ground.friction": 10.0,
    "ground.slope": np.radians(-4.0),
    "ground.patch_begin": 100.0,
    "ground.patch_end": 500.0,
    "ground.patch_friction": 0.02,
}


def test_strides_to_fall_begins_on_the_gait_without_the_patch_at_any_phase():
    """Falls are those of the same strides by the stride map, runner by runner."""
    gait = tdmf_slip.find_gait(DOWNHILL | {"ground.patch_end": 100.0})
    found = tdmf_slip.strides_to_fall(DOWNHILL, 0.0, runners=40, max_strides=120, seed=3, foot_x="random")
    assert found.word == gait.word and found.falls > 0
    positions = 100.0 - np.random.default_rng(3).uniform(1.0, 2.0, 40) * gait.stride["length"]
    run = tdmf_slip.stride_map(DOWNHILL, gait.apex, strides=120, foot_x=positions)
    fell = (run["fate"].values == 1).any(axis=1)
    assert found.falls == np.count_nonzero(fell)
    given = tdmf_slip.strides_to_fall(DOWNHILL, 0.0, runners=40, max_strides=120, foot_x=positions)
    assert (given.falls, given.strides) == (found.falls, found.strides)
    behind = tdmf_slip.strides_to_fall(DOWNHILL, 0.0, runners=4, max_strides=120, foot_x=600.0)
    assert behind.falls == 0
