"""Gaits on slopes, with retraction, static friction, thrust and pushes: a stride through both interfaces."""

import json
import math
import pathlib

import fmpy
import numpy as np
import pytest
import tdmf_slip
from conftest import CLAMPED
from tdmf_slip.library.fixed_point import gait_near

GAITS = json.loads(pathlib.Path(__file__).with_name("further_gaits.json").read_text(encoding="utf-8"))[
    "gaits"
]
SCALARS = ("period", "length", "speed", "hip_work", "leg_work", "cost_of_transport")
APEX = ("com_height", "com_speed", "leg_length", "leg_angle", "leg_length_rate", "leg_angle_rate")
WORKS = {"hip.work": "hip_work", "leg.work": "leg_work", "energy.external_work": "external_work"}
LEDGER = {f"energy.{name}": name for name in ("damper_loss", "friction_loss", "impact_loss")} | WORKS
OUTPUT = (
    *(f"stride.{name}" for name in SCALARS),
    *(f"apex.{name}" for name in APEX),
    *LEDGER,
    "stride.rise",
    "stride.work",
    "energy.total",
    "hip.liftoff_angle",
    "stride.count",
    "event.count",
    "ground.pending",
)
BODY_SHARE = 1.0 / 1.1
NOT_COUNTED = ("clamp",)
"""What the reference lists among events, and the unit does not count."""


def given_of(gait):
    """Start values without a posture, angles in rad."""
    return CLAMPED | {
        name: np.radians(float(value.removesuffix(" deg"))) if isinstance(value, str) else value
        for name, value in gait["start_values"].items()
    }


def start_of(gait):
    """Start values of the gait's apex, its centre of mass at x = 0, where the ground's height is 0."""
    height, speed, length, angle, length_rate, angle_rate = gait["apex"]
    sine, cosine = math.sin(angle), math.cos(angle)
    return given_of(gait) | {
        "foot.x": BODY_SHARE * length * sine,
        "foot.y": height - BODY_SHARE * length * cosine,
        "leg.length": length,
        "leg.angle": angle,
        "foot.vx": speed + BODY_SHARE * (length_rate * sine + length * cosine * angle_rate),
        "foot.vy": BODY_SHARE * (length * sine * angle_rate - length_rate * cosine),
        "leg.length_rate": length_rate,
        "leg.angle_rate": angle_rate,
    }


def assert_is_gait(rows, gait, tolerance):
    first, last = (dict(zip(rows.dtype.names, row, strict=True)) for row in (rows[0], rows[-1]))
    assert last["stride.count"] == 1 and not last["ground.pending"]
    for name in SCALARS:
        assert last[f"stride.{name}"] == pytest.approx(gait[name], rel=tolerance), name
    assert last["stride.rise"] == pytest.approx(gait["rise"], abs=tolerance)  # of heights around 1
    assert last["stride.work"] == pytest.approx(gait["hip_work"] + gait["leg_work"], rel=tolerance)
    for name, expected in zip(APEX, gait["apex"], strict=True):
        assert last[f"apex.{name}"] == pytest.approx(expected, abs=tolerance), name
    assert last["hip.liftoff_angle"] == pytest.approx(gait["liftoff_angle"], rel=tolerance)
    # The run ends a thousandth of a stride past the apex, in which only hip and forces from outside work.
    moved = {name: last[name] - first[name] for name in (*LEDGER, "energy.total")}
    for name, key in LEDGER.items():
        if name not in ("hip.work", "energy.external_work"):
            assert moved[name] == pytest.approx(gait[key], rel=tolerance, abs=0.1 * tolerance), name
    gained = sum(moved[name] for name in WORKS) - sum(moved[name] for name in LEDGER if name not in WORKS)
    assert moved["energy.total"] == pytest.approx(gained, abs=tolerance)


@pytest.fixture(
    scope="module", params=GAITS, ids=lambda gait: " ".join(map(str, gait["start_values"].values()))
)
def gait(request):
    return request.param


def test_there_are_28():
    assert len(GAITS) == 28


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
    assert_is_gait(rows, gait, 1e-8)


def test_model_exchange(run, gait):
    output = (*OUTPUT, "hip.place_time", "hip.phase_index")
    rows, instance = run(1.001 * gait["period"], start_of(gait), tolerance=1e-11, output=output)
    assert_is_gait(rows, gait, 1e-6)
    assert instance.text("stride.word") == gait["word"]
    times, counts = np.unique(rows["time"], return_counts=True)
    events = times[counts > 1]
    for name, time in gait["events"]:
        assert np.min(np.abs(events - time)) <= 1e-6 * time, name
    listed = [name for name, _ in gait["events"] if name not in NOT_COUNTED]
    assert rows["event.count"][-1] == len(listed)
    # The clock of place is 0 but from the apex to the touchdown, where it counts the seconds.
    rows = rows[rows["time"] < 0.99 * gait["period"]]
    in_place = rows["hip.phase_index"] == 4
    assert 10 < np.sum(in_place) < len(rows) - 10
    # An event's first row shows what was before it.
    assert rows["hip.place_time"][in_place] == pytest.approx(rows["time"][in_place], abs=1e-8)
    assert np.all(rows["hip.place_time"][~in_place] == 0.0)


def test_external_work_is_that_of_the_stride(unpacked, description, gait):
    """At the apex itself, unlike at the end of a run that goes on a little."""
    rows = fmpy.simulate_fmu(
        unpacked,
        model_description=description,
        fmi_type="CoSimulation",
        stop_time=gait["period"],
        output_interval=gait["period"],
        start_values=start_of(gait),
        output=("energy.external_work",),
    )
    work = rows["energy.external_work"][-1]
    assert work == pytest.approx(gait["external_work"], rel=1e-8, abs=1e-10)


def test_the_library_finds_them(gait):
    found = gait_near(tdmf_slip.Runner(given_of(gait)), gait["apex"])
    assert found.word == gait["word"]
    assert found.apex == pytest.approx(gait["apex"], abs=1e-10)
    names = {
        "impact_loss",
        "damper_loss",
        "friction_loss",
        "external_work",
        "slip_distance",
        *SCALARS,
    } & gait.keys()
    assert len(names) > 9
    for name in names:
        assert found.stride[name] == pytest.approx(gait[name], abs=2e-10), name
    if "jacobian" in gait:
        assert found.jacobian == pytest.approx(np.array(gait["jacobian"]), abs=1e-8)
