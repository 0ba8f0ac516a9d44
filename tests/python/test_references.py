"""Strides that independent programs have computed, by every solver: the engine, and the unit run by FMPy."""

import fmpy
import numpy as np
import pytest
import tdmf_slip
from conftest import some_of
from references import GAITS, NAMES, RUNS, STRIDES, name_of
from tdmf_slip.library.fixed_point import gait_near
from tdmf_slip.library.section import COORDINATES

each_gait = pytest.mark.parametrize("gait", GAITS, ids=name_of)
LOSSES = ("energy.damper_loss", "energy.friction_loss", "energy.impact_loss")
WORKS = ("hip.work", "leg.work", "energy.external_work")
COUNTED = ("stride.count", "stride.word_code", "event.count")
OUTPUT = [
    *NAMES.values(),
    *(f"apex.{name}" for name in COORDINATES),
    *LOSSES,
    *WORKS,
    *COUNTED,
    "energy.total",
]
CS, ME = {"fmi_type": "CoSimulation"}, {"fmi_type": "ModelExchange"}
WAYS = {
    "Co-Simulation": (2, CS, {}, 1e-8),
    "Co-Simulation by CVODE": (2, CS, {"solver.method": 2}, 1e-8),
    "Model Exchange": (2, ME, {}, 1e-6),
    "FMI 3, event mode": (3, CS | {"use_event_mode": True}, {}, 1e-8),
    "FMI 3, early return": (3, CS | {"use_event_mode": True, "early_return_allowed": True}, {}, 1e-8),
    "FMI 3, Model Exchange": (3, ME, {}, 1e-6),
}
"""Version of FMI, FMPy's options, start values and required accuracy, by way of running."""


def by_each_way(references):
    """Pairs of a reference and a way. Both versions of FMI have one source of values: FMI 3 runs some."""
    some = some_of(references, 4)
    return [(one, way) for way, (fmi, *_) in WAYS.items() for one in (references if fmi == 2 else some)]


@pytest.fixture(scope="session")
def units(unpacked, description, unpacked3, description3):
    """Folder and description of the unit by version of FMI."""
    return {2: (unpacked, description), 3: (unpacked3, description3)}


def code_of(word):
    """The unit's number of a word: base 4, the first letter most significant."""
    return int("0" + word.translate(str.maketrans("|-0+", "0123")), 4)


def run_unit(units, way, runner, apex, time):
    """Rows of a run that ends just after a time, and the accuracy that its way is good for."""
    fmi, options, settings, accuracy = WAYS[way]
    folder, description = units[fmi]
    start = tdmf_slip.Runner(runner).start_values(apex)
    rows = fmpy.simulate_fmu(
        folder, model_description=description, stop_time=1.001 * time, output_interval=time / 200,
        relative_tolerance=1e-12, start_values={**start, **settings}, output=OUTPUT, **options,
    )  # fmt: skip
    first, last = (dict(zip(rows.dtype.names, row, strict=True)) for row in (rows[0], rows[-1]))
    moved = {name: last[name] - first[name] for name in (*LOSSES, *WORKS, "energy.total")}
    gained = sum(moved[name] for name in WORKS) - sum(moved[name] for name in LOSSES)
    assert moved["energy.total"] == pytest.approx(gained, abs=10 * accuracy * (1 + moved["hip.work"]))
    assert moved["energy.friction_loss"] >= 0
    return rows, last, accuracy


def apex_in(last):
    return [last[f"apex.{name}"] for name in COORDINATES]


@pytest.mark.parametrize(
    ("gait", "way"), by_each_way(GAITS), ids=lambda of: of if isinstance(of, str) else name_of(of)
)
def test_a_stride_of_the_unit_is_that_of_the_reference(units, gait, way):
    rows, last, accuracy = run_unit(units, way, gait["start_values"], gait["apex"], gait["period"])
    assert (last["stride.count"], last["stride.word_code"]) == (1, code_of(gait["word"]))
    assert apex_in(last) == pytest.approx(gait["apex"], abs=accuracy)
    known = {of: gait[name] for name, of in NAMES.items() if name in gait}
    assert {of: last[of] for of in known} == pytest.approx(known, rel=accuracy, abs=accuracy)
    assert last["event.count"] == len([name for name, _ in gait["events"] if "clamp" not in name])
    if way.endswith("Model Exchange"):  # rows before and after each event
        times, counts = np.unique(rows["time"], return_counts=True)
        for name, time in gait["events"]:
            assert np.min(np.abs(times[counts > 1] - time)) <= 1e-6 * time, name


@each_gait
def test_the_search_finds_each_gait_with_its_jacobian(gait):
    runner, apex = tdmf_slip.Runner(gait["start_values"]), np.array(gait["apex"])
    found = gait_near(runner, apex + 1e-4 * np.array([1, -1, 0, 1, 0, 0]) * runner.scales)
    assert found.word == gait["word"]
    assert found.error < 1e-12
    assert found.apex == pytest.approx(apex, abs=1e-11)
    known = {name: gait[name] for name in found.stride if name in gait and name not in ("word", "apex")}
    assert len(known) >= 5
    assert {name: found.stride[name] for name in known} == pytest.approx(known, abs=2e-10)
    assert found.liftoff_angle == pytest.approx(gait["liftoff_angle"], abs=1e-10)
    if "jacobian" in gait:
        assert found.jacobian == pytest.approx(np.array(gait["jacobian"]), abs=1e-8)
    if "eigenvalues" in gait:
        count = 3 if "0" in gait["word"] else 4  # others vanish; without stick the fourth is not quite 0
        assert found.eigenvalues[:3] == pytest.approx(np.array(gait["eigenvalues"])[:3], abs=1e-8)
        assert np.abs(found.eigenvalues[count:]).max() < 1e-9


@pytest.mark.parametrize("stride", STRIDES, ids=lambda stride: stride["word"])
def test_strides_of_random_runners_are_those_of_the_reference(stride):
    found = tdmf_slip.stride_map(stride["start_values"], stride["apex"], tolerance=1e-12)
    assert found["word"].item() == stride["word"]
    assert found["next_apex"].values[0, 0] == pytest.approx(stride["end"], abs=1e-9)
    for name in ("period", "length", "work", "touchdowns"):
        assert found[name].item() == pytest.approx(stride[name], abs=1e-8), name


@pytest.mark.parametrize("by", [0.0, -40.0], ids=["at 0", "at -40 m"])
@pytest.mark.parametrize("run", RUNS, ids=lambda run: run["name"])
def test_the_engine_runs_over_a_patch_as_the_reference_wherever_it_is(run, by):
    given = run["start_values"]
    moved = given | {name: given.get(name, 0.0) + by for name in ("ground.patch_begin", "ground.patch_end")}
    count = len(run["words"])
    made = tdmf_slip.stride_map(moved, run["apex"], strides=count, foot_x=by, tolerance=1e-13)
    assert made["word"].values[0].tolist() == run["words"]
    assert made["next_apex"].values[0, -1] == pytest.approx(run["end"]["apex"], rel=1e-8, abs=1e-8)
    assert made["foot.x"].values[0, -1] == pytest.approx(run["end"]["foot.x"] + by, rel=1e-9)


OVER_PATCHES = some_of([run for run in RUNS if "fall" not in run], 4)


@pytest.mark.parametrize("way", list(WAYS)[:3])
@pytest.mark.parametrize("run", OVER_PATCHES, ids=lambda run: run["name"])
def test_the_unit_runs_over_a_patch_as_the_reference(units, run, way):
    end = run["end"]
    _, last, accuracy = run_unit(units, way, run["start_values"], run["apex"], end["time"])
    assert last["stride.count"] == len(run["words"])
    assert apex_in(last) == pytest.approx(end["apex"], rel=accuracy, abs=accuracy)


SLIPPERY_POINT = {"ground.patch_begin": 12.5, "ground.patch_end": 12.5, "ground.patch_friction": 0.01}
NOTHING = {
    "a patch of no length": SLIPPERY_POINT,
    "a static friction that is the sliding one": {"ground.stribeck_velocity": 0.1},
}


@pytest.mark.parametrize("friction", [0.6, 0.2])
@pytest.mark.parametrize("nothing", NOTHING.values(), ids=NOTHING)
def test_what_does_nothing_changes_no_bit(nothing, friction):
    runner = {"ground.friction": friction}
    apex = tdmf_slip.find_gait(runner).apex
    one, other = (tdmf_slip.stride_map(given, apex, strides=2) for given in (runner, runner | nothing))
    compared = [name for name in one.data_vars if one[name].dtype.kind == "f"]
    assert len(compared) > 15
    assert [name for name in compared if one[name].values.tobytes() != other[name].values.tobytes()] == []
