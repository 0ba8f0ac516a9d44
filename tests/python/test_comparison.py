"""Matched runners: held quantities are equal, and those that cannot be held are reported."""

import re

import pytest
from conftest import CLAMPED
from tdmf_slip import compare, find_gait, gait_at
from tdmf_slip.library.fixed_point import gait_near
from tdmf_slip.library.quantities import QUANTITIES, quantities_of
from tdmf_slip.paper.matched import match_gaits

HOLD = ("speed", "apex_height", "apex_leg_angle")
VARY = ("hip.stance_torque", "hip.touchdown_angle", "hip.liftoff_angle_factor")
SLIPS, STICKS = {"ground.friction": 0.2}, {"ground.friction": 10.0}


@pytest.mark.parametrize(
    ("runners", "found"),
    [((SLIPS, STICKS), (0.16691, 0.71533, 0.75664)), ((STICKS, SLIPS), (0.27647, 0.68187, 2.28424))],
)
def test_the_matched_runners_are_met(runners, found):
    """The matched values were computed independently, with the clamp."""
    runners = [runner | CLAMPED for runner in runners]
    matched = compare(runners, hold=HOLD, vary=VARY)
    assert matched["held"].dims == ("runner", "quantity") and bool(matched["held"].all())
    reference, other = (gait_at(matched.sel(runner=number, step="after")) for number in (0, 1))
    again = gait_near(other.runner, other.apex)
    assert quantities_of(again, HOLD) == pytest.approx(quantities_of(reference, HOLD), rel=1e-9)
    assert [other.runner[name] for name in VARY] == pytest.approx(found, abs=2e-5)
    assert reference.apex == pytest.approx(find_gait(runners[0]).apex, rel=1e-12)
    assert quantities_of(other, ["foot_clearance"])["foot_clearance"] == pytest.approx(
        quantities_of(reference, ["foot_clearance"])["foot_clearance"], abs=2e-3
    )


def test_a_runner_that_cannot_be_matched_is_left_out():
    gaits = [find_gait(friction=friction) for friction in (0.43, 10.0, 0.43)]
    assert match_gaits(gaits, ["cost_of_transport"], ["hip.kp"])["runner"].values.tolist() == [2]


def test_quantities_that_cannot_be_held_are_reported(command):
    options = ("--hold", "cost_of_transport", "--vary", "hip.kp")
    status, out, _ = command("compare", "--friction", 0.43, "--friction", 10, *options)
    wanted = find_gait(friction=0.43).cost_of_transport
    missed = re.search(r"not held: cost_of_transport of runner 1 is (\S+), not (\S+)", out)
    assert status == 0 and float(missed[2]) == pytest.approx(wanted, rel=1e-5)
    assert float(missed[1]) != pytest.approx(wanted, rel=1e-3)


def test_the_command_prints_what_the_function_gives(command):
    options = ["--friction", 0.2, "--friction", 10, "--hold", ",".join(HOLD), "--vary", ",".join(VARY)]
    printed = command.json("compare", *options)
    assert printed["not_held"] == [] and len(printed["runners"]) == 2
    matched = compare([SLIPS, STICKS], hold=HOLD, vary=VARY)
    for number, runner in enumerate(printed["runners"]):
        for step in ("before", "after"):
            gait = matched.sel(runner=number, step=step)
            assert {name: float(gait[name]) for name in QUANTITIES} == {
                name: runner[step][name] for name in QUANTITIES
            }
    reference, other = printed["runners"]
    assert reference["before"] == reference["after"]
    assert other["after"]["speed"] == pytest.approx(reference["after"]["speed"], rel=1e-9)
    assert other["before"]["speed"] != pytest.approx(reference["after"]["speed"], rel=1e-3)
    assert other["parameters"]["ground.friction"] == 10.0
