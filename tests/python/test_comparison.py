"""Runners made equal: what is held is equal, and what is not is told."""

import json

import pytest
from conftest import CLAMPED, assert_same
from tdmf_slip import InputError, compare, find_gait
from tdmf_slip.library.fixed_point import gait_near
from tdmf_slip.library.quantities import quantities_of

HOLD = ("speed", "apex_height", "apex_leg_angle")
VARY = ("hip.stance_torque", "hip.touchdown_angle", "hip.liftoff_angle_factor")
SLIPS, STICKS = {"ground.friction": 0.2}, {"ground.friction": 10.0}


@pytest.mark.parametrize(
    ("runners", "found"),
    [((SLIPS, STICKS), (0.16691, 0.71533, 0.75664)), ((STICKS, SLIPS), (0.27647, 0.68187, 2.28424))],
)
def test_the_matched_runners_are_met(runners, found):
    """With the clamp, as they were computed independently."""
    runners = [runner | CLAMPED for runner in runners]
    matched = compare(runners, hold=HOLD, vary=VARY)
    assert matched.not_held == ()
    reference, other = matched.gaits
    again = gait_near(other.runner, other.apex)
    assert quantities_of(again, HOLD) == pytest.approx(quantities_of(reference, HOLD), rel=1e-9)
    assert [other.runner[name] for name in VARY] == pytest.approx(found, abs=2e-5)
    assert_same(reference, find_gait(runners[0]))
    assert quantities_of(other, ["foot_clearance"])["foot_clearance"] == pytest.approx(
        quantities_of(reference, ["foot_clearance"])["foot_clearance"], abs=2e-3
    )


def test_what_cannot_be_held_is_told():
    matched = compare([{"ground.friction": 0.43}, STICKS], hold=["cost_of_transport"], vary=["hip.kp"])
    assert matched.not_held and all(of.runner == 1 for of in matched.not_held)
    for of in matched.not_held:
        assert of.has == quantities_of(matched.gaits[1], [of.quantity])[of.quantity]
        assert of.has != pytest.approx(of.wanted, rel=1e-8)
        assert f"not held: {of.quantity} of runner 1" in matched.table()


def test_the_command_prints_what_the_function_gives(command):
    options = ["--friction", 0.2, "--friction", 10, "--hold", ",".join(HOLD), "--vary", ",".join(VARY)]
    status, out, _ = command("compare", *options, "--json")
    printed = json.loads(out)
    assert status == 0 and printed["not_held"] == [] and len(printed["runners"]) == 2
    assert printed == json.loads(json.dumps(compare([SLIPS, STICKS], hold=HOLD, vary=VARY).as_json()))
    reference, other = printed["runners"]
    assert reference["before"] == reference["after"]
    assert other["after"]["speed"] == pytest.approx(reference["after"]["speed"], rel=1e-9)
    assert other["before"]["speed"] != pytest.approx(reference["after"]["speed"], rel=1e-3)
    assert other["parameters"]["ground.friction"] == 10.0


@pytest.mark.parametrize(
    ("runners", "hold", "vary", "message"),
    [
        ([SLIPS], HOLD, VARY, "runners: 1 given; allowed: two or more"),
        ([SLIPS, STICKS], [], VARY, "hold: nothing is held"),
        ([SLIPS, STICKS], ["sped"], VARY, "hold 'sped' is not allowed.*speed"),
        ([SLIPS, STICKS], ["speed", "speed"], VARY, "hold: speed is given twice"),
        ([SLIPS, STICKS], HOLD, VARY[:2], "at least as many"),
        ([SLIPS, STICKS], HOLD, [*VARY[:2], "hip.torq"], "hip.torq"),
    ],
)
def test_what_makes_no_sense_is_refused(runners, hold, vary, message):
    with pytest.raises(InputError, match=message):
        compare(runners, hold=hold, vary=vary)


def test_a_runner_of_the_command_by_frictions_and_files(command):
    names = ("--hold", "speed", "--vary", "hip.stance_torque")
    status, _, said = command("compare", "--friction", 0.2, *names)
    assert status == 2 and "allowed: two runners or more" in said
