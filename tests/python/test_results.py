"""Results show themselves: in a line, as a table of a notebook, as a dataset; arrays go by names."""

import functools
import inspect
import json
import pickle
import pydoc

import numpy as np
import pytest
import tdmf_slip
from conftest import assert_same
from tdmf_slip import InputError
from tdmf_slip.cli.output import json_text
from tdmf_slip.drawable import Drawable
from tdmf_slip.files.netcdf import netcdf_of
from tdmf_slip.fitting.measurements import Measured, Measurements
from tdmf_slip.fmu.run import Run
from tdmf_slip.labelled import LabelledArrays
from tdmf_slip.variables.table import STATES

ANGLE, TORQUE = "hip.touchdown_angle", "hip.stance_torque"
RESULTS = [
    *("Attraction", "Basin", "BorderProof", "Branch", "Comparison", "Controllability", "Curve", "Feedback"),
    *(
        "FirstPassage",
        "Fit",
        "Front",
        "Gait",
        "GaitGrid",
        "Optimum",
        "Proof",
        "RareFalls",
        "Run",
        "Runs",
        "Strides",
    ),
    *("Sweep", "Validation", "Viability"),
]
MADE = {
    "gait": lambda gait: gait,
    "run": lambda gait: tdmf_slip.simulate(gait, strides=2),
    "basin": lambda gait: tdmf_slip.basin(gait, n=3),
    "falls": lambda gait: tdmf_slip.strides_to_fall(gait, 0.5, runners=20),
    "viability": lambda gait: tdmf_slip.viability(
        {},
        axes={"com_height": (1.2, 1.8), "com_speed": (0.5, 1.2)},
        vary={ANGLE: (0.6, 0.7, 2)},
        n=4,
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
    "curve": lambda gait: tdmf_slip.Curve(
        gait.runner, "fold", (TORQUE, ANGLE), np.array([[0.2, 0.6], [0.3, 0.7]]), "edge", "edge"
    ),
    "comparison": lambda gait: tdmf_slip.compare(
        [{"ground.friction": 0.6}, {"ground.friction": 0.7}], hold=["speed"], vary=[TORQUE]
    ),
}


@pytest.fixture(scope="module")
def gait():
    return tdmf_slip.find_gait({"ground.friction": 0.6})


@pytest.fixture(scope="module")
def result_of(gait):
    """Each result of `MADE`, made once."""
    return functools.cache(lambda name: MADE[name](gait))


@pytest.mark.parametrize("name", RESULTS)
def test_results_have_a_picture_a_dataset_and_a_table(name):
    assert issubclass(getattr(tdmf_slip, name), Drawable)


@pytest.mark.parametrize("name", MADE)
def test_a_result_fits_a_page_and_is_equal_to_itself_made_anew(name, gait, result_of, tmp_path):
    result, again = result_of(name), MADE[name](gait)
    text = repr(result)
    assert text.startswith("<") and len(text) < 400 and "\n" not in text
    page = result._repr_html_()
    assert page.startswith("<table>") and len(page) < 6000 and page.count("<tr>") >= 2
    assert_same(result, again)
    data = result.to_xarray()
    assert len(data.data_vars) >= 2 and data.identical(again.to_xarray())
    data.to_netcdf(tmp_path / "data.nc", format="NETCDF3_CLASSIC")  # which has no empty dimensions


VARIES = {
    "viability": {ANGLE},
    "runs": {"ground.friction"},
    "grid": {"leg.damping", "ground.friction"},
    "sweep": {"ground.friction"},
    "curve": {TORQUE, ANGLE},
}
"""By result: names whose values are its coordinates."""


def recorded_names(data):
    """Names whose values a dataset has: its attributes, and variables, also those of rows, by their names."""
    rows = {name.removeprefix("front.start_values.").removeprefix("runners.runner.") for name in data}
    return {*data.attrs, *rows, *data.coords}


@pytest.mark.parametrize("name", MADE)
def test_a_dataset_records_version_model_and_every_value_of_the_runner(name, gait, result_of):
    data = result_of(name).to_xarray()
    model = "reduced" if name == "viability" else "full"
    assert data.attrs["version"] == tdmf_slip.__version__ and data.attrs["model"] == model
    states = set(STATES) if name in ("strides", "comparison") else set()
    missing = {*gait.runner} - recorded_names(data) - states
    assert missing <= VARIES.get(name, set()) - {*data.coords}
    assert netcdf_of(data)


ROWS = {"front": "front", "comparison": "runners"}
"""Entries whose rows have a runner each."""


@pytest.mark.parametrize("name", MADE)
def test_json_records_them_too(name, gait, result_of):
    result = result_of(name)
    if not hasattr(result, "as_json"):
        assert isinstance(result, LabelledArrays | Run)
        return
    plain = json.loads(json_text(result.as_json()))
    model = "reduced" if name == "viability" else "full"
    assert plain["version"] == tdmf_slip.__version__ and plain["model"] == model
    for row in plain[ROWS[name]] if name in ROWS else [plain]:
        values = row.get("runner") or row["start_values"]
        same = {of for of, value in gait.runner.items() if values.get(of) == value}
        assert set(values) >= {*gait.runner} - VARIES.get(name, set()), name
        assert len(same) >= len(gait.runner) - len(STATES) - 2


@pytest.mark.parametrize("name", MADE)
def test_a_pickle_is_read_as_it_was_written(name, result_of):
    assert_same(pickle.loads(pickle.dumps(result_of(name))), result_of(name))


def test_a_fit_without_priors_has_no_empty_dimension(gait, tmp_path):
    """A file of the classic format cannot have one."""
    speed = Measurements(({"speed": Measured(1.06, 0.01)},), "one gait")
    data = tdmf_slip.fit(gait, speed, [TORQUE], profile=False).to_xarray()
    data.to_netcdf(tmp_path / "data.nc", format="NETCDF3_CLASSIC")
    assert "chi_square" in data and 0 not in data.sizes.values()


def test_the_columns_of_a_run_go_by_their_names(gait):
    run = tdmf_slip.simulate(gait, strides=1)
    assert run["com.x"] is not None and np.array_equal(run["com.x"], run.table["com.x"])
    with pytest.raises(InputError, match=r"'com.z' was not recorded.*com.x"):
        run["com.z"]


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
    assert named == 16


def test_help_names_the_types_of_arrays():
    """And not what stands behind that name, which fills a screen."""
    shown = 0
    for name in tdmf_slip.__all__:
        thing = getattr(tdmf_slip, name)
        if inspect.isfunction(thing) or inspect.isclass(thing):
            assert "_NestedSequence" not in pydoc.plain(pydoc.render_doc(thing)), name
            shown += 1
    assert shown > 40 and "ArrayLike" in pydoc.render_doc(tdmf_slip.stride_map)


def test_a_gait_runs_in_a_file_that_says_its_speed(tmp_path):
    gait = tdmf_slip.find_gait()
    assert gait.speed == gait.stride["length"] / gait.stride["period"]
    written = gait.animate(tmp_path / "stride.gif", frames=12)
    assert written.read_bytes().startswith(b"GIF8")
    with pytest.raises(tdmf_slip.InputError, match="frames = 5 is not allowed"):
        gait.animate(tmp_path / "few.gif", frames=5)
