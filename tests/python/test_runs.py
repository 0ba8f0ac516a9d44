"""Runs of the unit through FMPy: many strides, ledgers, changing inputs, falls, scales, edges."""

import math
import random

import numpy as np
import pytest
from conftest import RELEASE, in_units, reference_gaits, runner_of_gait, some_of
from tdmf_slip import InputError, Profile, RunError, Runner, find_gait
from tdmf_slip.fmu import instance
from tdmf_slip.fmu.inputs import read_tables
from tdmf_slip.fmu.simulation import run_unit

LOSSES = ("energy.damper_loss", "energy.friction_loss", "energy.impact_loss")
LEDGER = ("energy.total", "hip.work", "leg.work", *LOSSES)
both_interfaces = pytest.mark.parametrize("interface", ["me", "cs"])


def gap_of_ledger(table):
    """Change of energy in each row, less all works, plus all losses."""
    moved = {name: table[name] - table[name][0] for name in LEDGER}
    assert all(np.diff(table[name]).min() >= -1e-12 and moved[name][-1] > 0 for name in LOSSES)
    return moved["energy.total"] - moved["hip.work"] - moved["leg.work"] + sum(moved[name] for name in LOSSES)


# ---- many strides ----------------------------------------------------------------------------------------


def test_many_strides_without_chatter():
    count = 2000 if RELEASE else 200
    names = ("stride.count", "event.count", "foot.y")
    run = run_unit(strides=count, tolerance=1e-6, output_interval=8.0, variables=names)
    strides, first = np.unique(run.table["stride.count"], return_index=True)
    assert strides[-1] == count
    assert set(np.diff(run.table["event.count"][first[:-1]])) == {9}
    assert run.table["foot.y"].min() > -1e-9
    assert run.stride["word"] == "+0-0+"


@pytest.mark.parametrize("gait", some_of(reference_gaits(), 1), ids=lambda gait: gait["word"])
def test_the_ledger_closes_over_a_hundred_strides(gait):
    runner = Runner(runner_of_gait(gait))
    names = (*LEDGER, "hip.positive_work")
    table = run_unit(
        runner.start_values(gait["apex"]), strides=100, output_interval=2.0, variables=names
    ).table
    assert np.abs(gap_of_ledger(table)).max() < 1e-5 * table["hip.positive_work"][-1]


@pytest.mark.parametrize(
    "given",
    [{}, {"interface": "cs"}, {"profile": Profile.random_steps(count=3, tread=7.0, roughness=0.01, seed=1)}],
)
def test_a_run_keeps_no_more_numbers_than_it_may(monkeypatch, given):
    """Rows at events count, too: five columns are recorded, the time and what is needed inside among them."""
    monkeypatch.setattr(instance, "MAX_NUMBERS", 5 * 250)
    kept = {"stop_time": 20.0, "output_interval": 0.1, "variables": ["com.x"], **given}
    assert len(run_unit(**kept).table) <= 250
    with pytest.raises(RunError, match=r"250 rows of 5 columns by t = .* fewer variables"):
        run_unit(**{**kept, "stop_time": None, "strides": 3})
    with pytest.raises(InputError, match=r"allowed: 250 rows of 5 columns"):
        run_unit(**{**kept, "stop_time": 50.0})


# ---- inputs and tunable parameters that change -----------------------------------------------------------


RECORDED = ("leg.angle", "foot.x", "energy.total", "event.count", "hip.touchdown_angle", "control.thrust")
TABLES = {
    "a ramp with kinks off the grid": {
        "hip.external_torque": ([1.0, 3.33, 7.77, 9.1], [0.0, 0.02, -0.01, 0.01])
    },
    "a ramp that jumps": {"hip.external_torque": ([0.0, 5.55, 5.55, 12.0], [0.0, 0.02, -0.01, 0.0])},
    "steps of a discrete input": {"control.touchdown_angle": ([0.0, 4.44, 14.0], [0.01, 0.03, -0.01])},
    "steps of a tunable parameter": {"hip.kp": ([2.0, 6.66], [0.1, 0.13])},
}


@pytest.mark.parametrize("table", TABLES.values(), ids=TABLES)
def test_both_interfaces_follow_a_table(table):
    """Up to the end of the second stance; without the table the run is another."""
    runs = [
        run_unit(inputs=inputs, variables=RECORDED, stop_time=14.5, interface=interface, tolerance=1e-11)
        for interface, inputs in (("me", table), ("cs", table), ("cs", {}))
    ]
    last, expected, without = (run.table[-1] for run in runs)
    assert last["event.count"] == expected["event.count"]
    for name in RECORDED[:3]:
        assert last[name] == pytest.approx(expected[name], rel=1e-7), name
    assert abs(without["leg.angle"] - expected["leg.angle"]) > 1e-4
    assert not runs[0].messages and not runs[1].messages


def test_a_discrete_input_keeps_a_value_until_the_next(tmp_path, fmu):
    file = tmp_path / "inputs.csv"
    file.write_text("time,control.thrust,hip.touchdown_angle\n0,0,40 deg\n2,0.1,41 deg\n3,0.2,41 deg\n")
    table = run_unit(
        inputs=read_tables(file, fmu), variables=RECORDED, stop_time=4.0, output_interval=0.5
    ).table
    for begin, end, thrust, angle in ((0.0, 2.0, 0.0, 40.0), (2.0, 3.0, 0.1, 41.0), (3.0, 4.0, 0.2, 41.0)):
        inside = table[(table["time"] > begin) & (table["time"] < end)]
        assert len(inside) and np.all(inside["control.thrust"] == thrust)
        assert np.degrees(inside["hip.touchdown_angle"]) == pytest.approx(angle)


def test_a_table_of_a_fixed_parameter_is_refused():
    with pytest.raises(InputError, match=r"body\.mass is neither an input nor tunable"):
        run_unit(inputs={"body.mass": ([0.0, 1.0], [1.0, 2.0])}, stop_time=1.0)


def test_ice_under_a_sticking_foot_makes_it_slip_at_once():
    """The foot sticks at friction 10 from touchdown at 11.9 on; the ice comes at 12.1."""
    ice = {"ground.friction": ([0.0, 12.1, 12.1], [10.0, 10.0, 0.05])}
    table = run_unit(inputs=ice, variables=["contact.mode_index"], stop_time=12.3, output_interval=0.1).table
    assert table["contact.mode_index"][table["time"] < 12.1][-1] == 2  # sticks
    assert set(table["contact.mode_index"][table["time"] > 12.1 + 1e-9]) == {4}  # slips backward


def test_regular_rows_alone_are_those_after_events_and_the_end():
    """Friction jumps at a regular row, and the run ends between two."""
    ice = {"ground.friction": ([0.0, 1.5, 1.5], [10.0, 10.0, 0.05])}
    how = {"stop_time": 2.25, "output_interval": 0.5, "record_events": False}
    table = run_unit(inputs=ice, variables=["ground.friction"], **how).table
    assert table["time"] == pytest.approx([0.0, 0.5, 1.0, 1.5, 2.0, 2.25])
    assert table["ground.friction"].tolist() == [10.0] * 3 + [0.05] * 3


# ---- thrust as the only drive ----------------------------------------------------------------------------


def test_without_hip_torque_the_leg_does_all_work():
    """A spring longer by the thrust has done, once flight begins, stiffness x thrust x lengthening."""
    thrust = 0.45
    gait = find_gait({"ground.friction": 10.0, "hip.stance_torque": 0.0, "leg.thrust": thrust})
    table = run_unit(gait.start_values, strides=1, tolerance=1e-11, variables=[*LEDGER, "leg.length"]).table
    changed = np.flatnonzero(np.abs(np.diff(table["leg.work"])) > 1e-6)
    compressed, longest = table["leg.length"][changed]
    assert compressed == pytest.approx(table["leg.length"].min(), abs=1e-9)
    leg, hip, *lost = (table[name][-1] - table[name][0] for name in ("leg.work", "hip.work", *LOSSES))
    assert leg == pytest.approx(thrust * (longest - compressed), rel=1e-8)
    assert hip < 0.0 < leg and leg + hip == pytest.approx(sum(lost), rel=1e-7)
    assert gait.stable and gait.stride["work"] == pytest.approx(leg + hip, rel=1e-7)
    assert sum(gait.stride[name.removeprefix("energy.")] for name in LOSSES) == pytest.approx(
        gait.stride["work"], rel=1e-10
    )


# ---- scales ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", range(3))
def test_any_units_of_mass_stiffness_and_length_give_the_same_motion(seed):
    """The dimensionless groups are those of Table 1: a human's, an insect's or any other scale."""
    draw = random.Random(seed)
    gait = draw.choice(reference_gaits())
    m, k, l0 = (10 ** draw.uniform(-3, 4) for _ in range(3))
    time, energy = math.sqrt(m / k), k * l0**2
    runner = in_units(m, k, l0, **runner_of_gait(gait))
    stride = run_unit(runner.start_values(runner.scales * gait["apex"]), strides=3).stride
    assert stride["word"] == gait["word"]
    found = [stride[name] for name in ("period", "length", "work", "cost_of_transport")]
    wanted = [gait["period"] * time, gait["length"] * l0, gait["work"] * energy, gait["cost_of_transport"]]
    assert found == pytest.approx(wanted, rel=1e-6)


# ---- falls, and edges of the model -----------------------------------------------------------------------


AT_REST = dict.fromkeys(("leg.angle", "foot.vx", "foot.vy", "leg.length_rate", "leg.angle_rate"), 0.0)
WITHOUT_HIP = {"hip.kp": 0.0, "hip.kd": 0.0, "hip.stance_torque": 0.0}
ON_THE_GROUND = {"foot.y": 0.0, "leg.length": 0.99, **AT_REST}
"""Upright and at rest, the spring carrying the body."""
DROP = {"hip.touchdown_angle": 0.0, "hip.stance_torque": 0.0, "leg.damping": 0.0, **AT_REST}
DROP |= {"leg.length": 1.0, "foot.y": 80.0}
"""A vertical drop from high above onto a leg that cannot take it."""


def test_a_fall_ends_the_run_or_freezes_the_motion():
    run = run_unit(DROP, stop_time=200.0)
    assert run.fallen and 126.0 < run.fall_time < 128.0
    assert run.final["leg.length"] == pytest.approx(0.05)
    frozen = run_unit(
        DROP | {"status.terminate_on_fall": False}, stop_time=200.0, variables=["leg.length", "body.y"]
    )
    fallen = frozen.table[frozen.table["time"] > 140.0]
    assert frozen.fallen and fallen["time"][-1] == pytest.approx(200.0)
    assert np.ptp(fallen["leg.length"]) == 0 and np.ptp(fallen["body.y"]) == 0


@both_interfaces
def test_an_upright_runner_at_rest_stands(interface):
    names = ("leg.angle", "leg.angle_rate", "hip.work")
    run = run_unit(ON_THE_GROUND, stop_time=50.0, interface=interface, variables=names)
    assert not run.fallen
    assert all((run.table[name] == 0.0).all() for name in names)


@both_interfaces
def test_friction_that_vanishes_is_none_and_a_huge_one_never_slips(interface):
    none, some, less = (
        run_unit({"ground.friction": friction}, strides=5, interface=interface).stride
        for friction in (0.0, 1e-9, 5e-324)
    )
    assert none["word"] == some["word"] == less["word"] == "+-"
    assert [some["period"], less["period"]] == pytest.approx([none["period"]] * 2, rel=1e-6)
    huge = run_unit({"ground.friction": 1e6}, strides=20, interface=interface).stride
    assert (huge["count"], huge["word"]) == (20, "0+") and huge["slip_distance"] < 1e-4


@both_interfaces
def test_a_wound_leg_falls_as_one_that_is_not(interface):
    """A full turn of the leg changes nothing without a hip."""
    falls = []
    for turns in (0, 150):
        start = ON_THE_GROUND | {"leg.angle": 0.5 + 2.0 * math.pi * turns, "leg.angle_rate": 0.3}
        run = run_unit(start | WITHOUT_HIP, stop_time=100.0, interface=interface)
        assert run.fallen
        falls.append(run.fall_time)
    assert falls[1] == pytest.approx(falls[0], rel=1e-5)
