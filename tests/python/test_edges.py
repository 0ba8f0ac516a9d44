"""Runs of the unit at the edges of its model: friction of any size, a start at rest, a leg that has wound."""

import math

import pytest
from tdmf_slip import InputError
from tdmf_slip.fmu.simulation import run_unit

ON_THE_GROUND = {
    "foot.y": 0.0,
    "leg.angle": 0.0,
    "foot.vx": 0.0,
    "foot.vy": 0.0,
    "leg.length_rate": 0.0,
    "leg.angle_rate": 0.0,
    "leg.length": 0.99,
}
"""Upright and at rest, the spring carrying the body."""


@pytest.mark.parametrize("interface", ["me", "cs"])
def test_an_upright_runner_at_rest_stands(interface, fmu):
    names = ("leg.angle", "leg.angle_rate", "hip.work", "foot.x")
    run = run_unit(ON_THE_GROUND, stop_time=50.0, interface=interface, variables=names, fmu=fmu)
    assert not run.fallen
    for name in names[:3]:
        assert (run.table[name] == 0.0).all()


@pytest.mark.parametrize("interface", ["me", "cs"])
@pytest.mark.parametrize("friction", [5e-324, 1e-9])
def test_friction_that_vanishes_is_none(interface, friction, fmu):
    options = {"strides": 5, "interface": interface, "record_events": False, "fmu": fmu}
    none = run_unit({"ground.friction": 0.0}, **options)
    some = run_unit({"ground.friction": friction}, **options)
    assert some.stride["word"] == none.stride["word"] == "+-"
    assert some.stride["period"] == pytest.approx(none.stride["period"], rel=1e-6)


@pytest.mark.parametrize("interface", ["me", "cs"])
@pytest.mark.parametrize("friction", [1e6])
def test_friction_without_bound_never_slips(interface, friction, fmu):
    run = run_unit({"ground.friction": friction}, strides=20, interface=interface, fmu=fmu)
    assert (run.stride["count"], run.stride["word"]) == (20, "0+")
    assert run.stride["slip_distance"] < 1e-4


@pytest.mark.parametrize("friction", [1e12, 1e300, math.inf])
def test_friction_beyond_its_range_is_refused(friction, fmu):
    with pytest.raises(InputError, match=r"ground\.friction"):
        run_unit({"ground.friction": friction}, strides=1, fmu=fmu)


@pytest.mark.parametrize("interface", ["me", "cs"])
def test_a_wound_leg_falls_as_one_that_is_not(interface, fmu):
    """Without a hip, a turn more or less is none."""
    falls = []
    for turns in (0, 150):
        start = ON_THE_GROUND | {"leg.angle": 0.5 + 2.0 * math.pi * turns, "leg.angle_rate": 0.3}
        hip = {"hip.kp": 0.0, "hip.kd": 0.0, "hip.stance_torque": 0.0}
        run = run_unit(start | hip, stop_time=100.0, interface=interface, fmu=fmu)
        assert run.fallen
        falls.append(run.fall_time)
    assert falls[1] == pytest.approx(falls[0], rel=1e-5)
