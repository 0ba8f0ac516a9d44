"""Results show themselves: in a line, as a table of a notebook, as a dataset; arrays go by names."""

import inspect
import pydoc

import numpy as np
import pytest
import tdmf_slip
from tdmf_slip import InputError
from tdmf_slip.drawable import Drawable

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
    "basin": lambda gait: tdmf_slip.basin(gait, n=3, threads=1),
    "falls": lambda gait: tdmf_slip.strides_to_fall(gait, 0.5, runners=20, threads=1),
    "viability": lambda gait: tdmf_slip.viability(
        {},
        axes={"com_height": (1.2, 1.8), "com_speed": (0.5, 1.2)},
        vary={ANGLE: (0.6, 0.7, 2)},
        n=4,
        threads=1,
    ),
    "runs": lambda gait: tdmf_slip.simulate_many(
        [{"ground.friction": 0.6}, {"ground.friction": 1.2}], strides=2, threads=1
    ),
    "strides": lambda gait: tdmf_slip.stride_map(gait, [gait.apex] * 2, strides=3, threads=1),
    "grid": lambda gait: tdmf_slip.sweep(
        {}, {"leg.damping": [0.2, 0.21], "ground.friction": [0.6, 0.55]}, threads=1
    ),
    "sweep": lambda gait: tdmf_slip.sweep({}, {"ground.friction": [0.6, 0.5]}),
    "controllability": lambda gait: tdmf_slip.controllability(gait, [ANGLE, TORQUE]),
    "feedback": lambda gait: tdmf_slip.dead_beat(gait, [ANGLE, TORQUE]),
    "optimum": lambda gait: tdmf_slip.optimize(gait, {TORQUE: (0.19, 0.21)}, maximize="speed", starts=1),
    "comparison": lambda gait: tdmf_slip.compare(
        [{"ground.friction": 0.6}, {"ground.friction": 0.7}], hold=["speed"], vary=[TORQUE]
    ),
}


@pytest.fixture(scope="module")
def gait():
    return tdmf_slip.find_gait({"ground.friction": 0.6})


@pytest.mark.parametrize("name", RESULTS)
def test_results_have_a_picture_a_dataset_and_a_table(name):
    assert issubclass(getattr(tdmf_slip, name), Drawable)


@pytest.mark.parametrize("name", MADE)
def test_a_result_fits_a_page_and_is_equal_to_itself_made_anew(name, gait):
    result, again = MADE[name](gait), MADE[name](gait)
    text = repr(result)
    assert text.startswith("<") and len(text) < 400 and "\n" not in text
    page = result._repr_html_()
    assert page.startswith("<table>") and len(page) < 6000 and page.count("<tr>") >= 3
    assert result == again
    data = result.to_xarray()
    assert len(data.data_vars) >= 2 and data.identical(again.to_xarray())


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
