"""Results in a line, as datasets and as JSON: each says what it is, who ran, and by which version."""

import inspect
import json
import pickle
from xml.etree import ElementTree

import numpy as np
import pytest
import tdmf_slip
import xarray
from conftest import RELEASE, assert_same
from tdmf_slip.cli.command import json_text
from tdmf_slip.files.netcdf import netcdf_of
from tdmf_slip.record import runner_in
from tdmf_slip.variables.table import STATES

ANGLE, TORQUE = "hip.touchdown_angle", "hip.stance_torque"
MADE = {
    "gait": lambda gait: gait,
    "run": lambda gait: tdmf_slip.simulate(gait, strides=2),
    "basin": lambda gait: tdmf_slip.basin(gait, n=3),
    "falls": lambda gait: tdmf_slip.strides_to_fall(gait, 0.5, runners=20),
    "viability": lambda gait: tdmf_slip.viability(
        {}, axes={"com_height": (1.2, 1.8), "com_speed": (0.5, 1.2)}, vary={ANGLE: (0.6, 0.7, 2)}, n=4
    ),
    "runs": lambda gait: tdmf_slip.simulate_many(
        [{"ground.friction": 0.6}, {"ground.friction": 1.2}], strides=2
    ),
    "strides": lambda gait: tdmf_slip.stride_map(gait, [gait.apex] * 2, strides=3),
    "grid": lambda gait: tdmf_slip.sweep({}, {"leg.damping": [0.2, 0.21], "ground.friction": [0.6, 0.55]}),
    "sweep": lambda gait: tdmf_slip.sweep({}, {"ground.friction": [0.6, 0.5]}),
    "controllability": lambda gait: tdmf_slip.controllability(gait, [ANGLE, TORQUE]),
    "feedback": lambda gait: tdmf_slip.dead_beat(gait, [ANGLE, TORQUE]),
    "optimum": lambda gait: tdmf_slip.optimize(gait, {TORQUE: (0.19, 0.21)}, maximize="speed", starts=1),
    "front": lambda gait: tdmf_slip.pareto_front(
        gait.runner,
        {TORQUE: (0.19, 0.21)},
        minimize=["cost_of_transport"],
        maximize=["speed"],
        points=2,
        starts=1,
    ),
    "curves": lambda gait: tdmf_slip.continue_curves(
        {}, {"ground.friction": (0.51, 0.49), "leg.damping": (0.199, 0.201)}, max_points=3
    ),
    "branch": lambda gait: tdmf_slip.continue_branch(gait.runner, {TORQUE: (0.2, 0.21)}),
    "comparison": lambda gait: tdmf_slip.compare(
        [{"ground.friction": 0.6}, {"ground.friction": 0.7}], hold=["speed"], vary=[TORQUE]
    ),
}


GAITS = {"sweep", "grid"}
"""Results whose gaits are one dataset, and their borders another."""
VARIES = {
    "runs": {"ground.friction"},
    "grid": {"leg.damping", "ground.friction"},
    "sweep": {"ground.friction"},
    "curves": {"ground.friction", "leg.damping"},
    "branch": {TORQUE},
    "front": {TORQUE},
    "comparison": {TORQUE, "ground.friction"},
}
"""Names whose values are a result's coordinates, by result."""
MADE_TWICE = {"run", "runs", "basin", "falls", "strides", "feedback"}


@pytest.mark.parametrize("name", [name for name in MADE if RELEASE or name not in ("curves", "front")])
def test_a_result_says_what_it_is_who_ran_and_by_which_version(name, gait, tmp_path):
    result = MADE[name](gait)
    if name in MADE_TWICE:
        assert_same(MADE[name](gait), result)
    assert_same(pickle.loads(pickle.dumps(result)), result)
    if hasattr(type(result), "as_json"):
        check_record(json.loads(json_text(result.as_json())), gait)
    if hasattr(type(result), "as_json") and not hasattr(result, "gaits"):
        assert (text := repr(result)).startswith("<") and len(text) < 400 and "\n" not in text
    data = result.gaits if name in GAITS else gait.to_dataset() if name == "gait" else result
    if isinstance(data, xarray.Dataset):
        check_dataset(name, data, gait, tmp_path)


def check_record(plain, gait):
    assert plain["version"] == tdmf_slip.__version__ and plain["model"] == "full"
    values = plain.get("runner") or plain["start_values"]
    same = {of for of, value in gait.runner.items() if values.get(of) == value}
    assert set(values) >= {*gait.runner} - {ANGLE, TORQUE}
    assert len(same) >= len(gait.runner) - len(STATES) - 2


def check_dataset(name, data, gait, tmp_path):
    """Attributes say what it is; the file has all of it."""
    model = "reduced" if name == "viability" else "full"
    assert data.attrs["version"] == tdmf_slip.__version__ and data.attrs["model"] == model
    assert data.attrs["result"] == {"grid": "sweep"}.get(name, name)
    states = set(STATES) if name == "strides" else set()
    assert {*gait.runner} - {*runner_in(data)} - states == VARIES.get(name, set())
    assert VARIES.get(name, set()) <= {*map(str, data.coords)}
    data.to_netcdf(tmp_path / "data.nc")
    with xarray.open_dataset(tmp_path / "data.nc", decode_times=False) as read:
        assert read.load().equals(data) and read.attrs.keys() == data.attrs.keys()
    assert netcdf_of(data)


def test_a_run_has_its_events_its_end_and_its_last_stride(gait):
    run = tdmf_slip.simulate(gait, strides=1)
    assert run["com.x"].dims == ("time",) and run["com.x"].attrs["units"] == "m"
    assert run["event"].values[-1] == "apex" and float(run["event_time"][-1]) == run.attrs["apex.time"]
    assert run.attrs["stride.word"] == gait.word and run.fallen == 0 and "fall_time" not in run.attrs
    fallen = tdmf_slip.simulate({"ground.friction": 10, "foot.y": 2.5, "foot.vx": 2.0}, stop_time=400)
    assert fallen.fallen == 1 and fallen.fall_time == float(fallen["time"][-1])


def test_what_may_be_given_for_a_runner_is_the_same_everywhere():
    named = 0
    for name in tdmf_slip.__all__:
        thing = getattr(tdmf_slip, name)
        parameters = inspect.signature(thing).parameters if inspect.isfunction(thing) else {}
        if "runner" in parameters:
            assert parameters["runner"].annotation == "RunnerLike", name
            named += 1
        if "runners" in parameters and name != "strides_to_fall":
            assert parameters["runners"].annotation == "Sequence[RunnerLike]", name
            named += 1
    assert named == 18


def test_a_gait_runs_in_a_file_that_says_its_speed(tmp_path):
    gait = tdmf_slip.find_gait()
    assert gait.speed == gait.stride["length"] / gait.stride["period"]
    written = gait.animate(tmp_path / "stride.gif", frames=12)
    assert written.read_bytes().startswith(b"GIF8")
    with pytest.raises(tdmf_slip.InputError, match="frames = 5 is not allowed"):
        gait.animate(tmp_path / "few.gif", frames=5)


@pytest.mark.parametrize("model", ["full", "reduced"])
def test_the_box_of_a_gait_has_eight_rows_and_a_mark_for_each_eigenvalue(model):
    gait = tdmf_slip.find_gait("human", model=model)
    box = gait._repr_html_()
    table, picture = box.split("</table>")
    assert table.count("<tr>") == 8 and f"<td>{gait.speed:.6g} m/s</td>" in table and "stable" in table
    marks = [
        (mark.get("cx"), mark.get("cy"))
        for mark in ElementTree.fromstring(picture).iter("circle")
        if mark.get("cx")
    ]
    found = sorted((float(x), -float(y)) for x, y in marks)
    wanted = sorted((value.real, value.imag) for value in gait.eigenvalues.astype(complex))
    np.testing.assert_allclose(found, wanted, atol=1e-4)
