"""Gaits on slopes, with retraction, static friction and thrust: a stride each, through both interfaces."""

import json
import pathlib

import fmpy
import numpy as np
import pytest
import tdmf_slip
from tdmf_slip.library.orbit import orbit_near

GAITS = json.loads(pathlib.Path(__file__).with_name("further_gaits.json").read_text(encoding="utf-8"))[
    "gaits"
]
SCALARS = ("period", "length", "speed", "work", "cost_of_transport")
APEX = ("com_height", "com_speed", "leg_length", "leg_angle", "leg_length_rate", "leg_angle_rate")
LOSSES = ("damper_loss", "friction_loss", "impact_loss")
OUTPUT = (
    *(f"stride.{name}" for name in SCALARS),
    *(f"apex.{name}" for name in APEX),
    *(f"energy.{name}" for name in LOSSES),
    "hip.liftoff_angle",
    "stride.count",
    "event.count",
)


def start_of(gait):
    given = dict(gait["start_values"])
    for name in ("hip.touchdown_angle", "ground.slope"):
        if name in given:
            given[name] = np.radians(float(given[name].removesuffix(" deg")))
    return tdmf_slip.Runner.of(given).state_at(gait["apex"]) | given


def assert_is_gait(last, gait, tolerance):
    assert last["stride.count"] == 1
    for name in SCALARS:
        assert last[f"stride.{name}"] == pytest.approx(gait[name], rel=tolerance), name
    for name in LOSSES:
        assert last[f"energy.{name}"] == pytest.approx(gait[name], rel=tolerance), name
    for name, expected in zip(APEX, gait["apex"], strict=True):
        assert last[f"apex.{name}"] == pytest.approx(expected, abs=tolerance), name
    assert last["hip.liftoff_angle"] == pytest.approx(gait["liftoff_angle"], rel=tolerance)


@pytest.fixture(
    scope="module", params=GAITS, ids=lambda gait: " ".join(map(str, gait["start_values"].values()))
)
def gait(request):
    return request.param


def test_there_are_sixteen():
    assert len(GAITS) == 16


@pytest.mark.parametrize("method", [1, 2], ids=["native", "cvode"])
def test_co_simulation(unpacked, description, gait, method):
    rows = fmpy.simulate_fmu(
        unpacked,
        model_description=description,
        fmi_type="CoSimulation",
        stop_time=1.001 * gait["period"],
        output_interval=gait["period"] / 10,
        relative_tolerance=1e-12,
        start_values=start_of(gait) | {"solver.method": method},
        output=OUTPUT,
    )
    assert_is_gait(dict(zip(rows.dtype.names, rows[-1], strict=True)), gait, 1e-8)


def test_model_exchange(run, gait):
    rows, instance = run(1.001 * gait["period"], start_of(gait), tolerance=1e-11, output=OUTPUT)
    assert_is_gait(dict(zip(rows.dtype.names, rows[-1], strict=True)), gait, 1e-6)
    assert instance.text("stride.word") == gait["word"]
    times, counts = np.unique(rows["time"], return_counts=True)
    events = times[counts > 1]
    for name, time in gait["events"]:
        assert np.min(np.abs(events - time)) <= 1e-6 * time, name
    listed = [name for name, _ in gait["events"] if name != "retract_clamp_release"]
    assert rows["event.count"][-1] == len(listed)


def test_the_clock_of_place_tells_since_when(run, gait):
    """It is 0 but from the apex to the touchdown, where it counts the seconds."""
    rows, _ = run(0.99 * gait["period"], start_of(gait), output=("hip.place_time", "hip.phase_index"))
    in_place = rows["hip.phase_index"] == 4
    assert 10 < np.sum(in_place) < len(rows) - 10
    # An event's first row shows what was before it.
    assert rows["hip.place_time"][in_place] == pytest.approx(rows["time"][in_place], abs=1e-8)
    assert np.all(rows["hip.place_time"][~in_place] == 0.0)


def test_the_library_finds_them(gait):
    orbit = orbit_near(tdmf_slip.Runner.of(start_of(gait)), gait["apex"])
    assert orbit.word == gait["word"]
    for name in SCALARS:
        assert orbit.stride[name] == pytest.approx(gait[name], rel=1e-8), name
