"""Short names stand for the unit's own wherever a variable is named; a wrong name has the nearest."""

import inspect

import numpy as np
import pytest
import tdmf_slip
from tdmf_slip import InputError, Runner, find_gait
from tdmf_slip.library.quantities import QUANTITIES
from tdmf_slip.variables.table import ALIASES

ANGLE = "hip.touchdown_angle"


def test_an_alias_is_of_a_variable_that_can_be_set_and_stands_for_nothing_else(fmu):
    assert len(ALIASES) > 20 and len(set(ALIASES.values())) == len(ALIASES)
    assert all(fmu.variables[name].settable for name in ALIASES.values())
    assert not set(ALIASES) & {*fmu.variables, *QUANTITIES, *inspect.signature(find_gait).parameters}
    promised = ("friction", "foot_mass", "body_mass", "stiffness", "damping", "torque", "touchdown_angle")
    assert {*promised, "thrust", "slope", "retraction"} <= set(ALIASES)


def test_a_gait_is_the_same_by_either_name_and_by_keyword():
    wanted = find_gait({"ground.friction": 0.43, ANGLE: "41 deg"})
    for found in (
        find_gait(friction=0.43, touchdown_angle="41 deg"),
        find_gait({"friction": 0.43, "touchdown_angle": "41 deg"}),
        find_gait({"friction": 0.2, ANGLE: "41deg"}, friction=0.43),
        find_gait(Runner(friction=0.43), touchdown_angle="41 deg"),
        find_gait(Runner(friction=0.43).replace({"touchdown_angle": "41 deg"})),
    ):
        assert np.array_equal(found.apex, wanted.apex) and found.word == wanted.word
        assert found.runner == wanted.runner


@pytest.mark.parametrize(
    "call",
    [
        lambda name: tdmf_slip.sweep(None, {name: ["40 deg", "41 deg"]}).gaits["speed"].to_dict()["data"],
        lambda name: tdmf_slip.continue_branch(None, {name: (0.69, 0.7)}, max_points=4)[
            "speed"
        ].values.tolist(),
        lambda name: find_gait(target={"speed": 1.05}, vary=[name]).runner,
        lambda name: tdmf_slip.lqr(find_gait(), [name]).inputs,
        lambda name: tdmf_slip.stride_map(None, find_gait().apex, inputs={name: 0.7})[
            "speed"
        ].values.tolist(),
        lambda name: tdmf_slip.simulate({name: 0.7}, strides=1).attrs["stride.period"],
        lambda name: tdmf_slip.simulate(strides=1, variables=["torque", name]).to_dict()["data_vars"].keys(),
    ],
)
def test_what_varies_goes_by_either_name(call):
    assert call("touchdown_angle") == call(ANGLE)


def test_the_command_that_lists_variables_has_the_short_names(command):
    listed = {variable["name"]: variable["short_name"] for variable in command.json("variables")["variables"]}
    assert {short: full for full, short in listed.items() if short} == dict(ALIASES)
    _, printed, _ = command("variables")
    assert any(line.split()[:2] == ["ground.friction", "friction"] for line in printed.splitlines())


@pytest.mark.parametrize(
    ("call", "meant"),
    [
        (lambda: find_gait(frction=0.4), "friction"),
        (lambda: find_gait(targt={"speed": 1.0}), "target"),
        (lambda: find_gait({"stifness": 2.0}), "stiffness"),
        (lambda: find_gait(target={"speed": 1.0}, vary=["torqe"]), "torque"),
        (lambda: Runner().replace({"dampin": 0.1}), "damping"),
        (lambda: tdmf_slip.lqr(find_gait(), ["touchdown_angel"]), "touchdown_angle"),
        (lambda: tdmf_slip.stride_map(None, find_gait().apex, inputs={"torqu": 0.2}), "torque"),
    ],
)
def test_a_wrong_name_has_the_nearest_beside_it(call, meant):
    with pytest.raises(InputError) as caught:
        call()
    assert meant in str(caught.value).partition("near matches: ")[2].split(", ")


def test_a_wrong_name_that_is_near_none_brings_a_few_and_the_command_that_lists_all():
    few = (
        r"target: 'zzzz' is not allowed; allowed: speed, frequency, length and 18 more, listed by `tdmf-slip"
    )
    with pytest.raises(InputError, match=few):
        find_gait(target={"zzzz": 1.0}, vary=["torque"])
    with pytest.raises(InputError, match="and 11 more, listed by `tdmf-slip variables`"):
        tdmf_slip.lqr(find_gait(), ["zzzz"])


def test_a_variable_is_not_given_by_both_names(command):
    with pytest.raises(InputError, match=r"ground\.friction and friction are the same"):
        find_gait({"friction": 0.4, "ground.friction": 0.4})
    said = command.refusal("gait", "--set", "damping=0.1", "--set", "leg.damping=0.1")
    assert "leg.damping is given twice" in said


def test_a_target_may_be_a_quantity_with_its_unit(command):
    """Speeds in km/h, lengths in cm; a unit of something else is refused."""
    wanted = find_gait("human", target={"speed": 2.5}, vary=["torque"])
    found = find_gait("human", target={"speed": "9 km/h"}, vary=["torque"])
    assert found.runner["hip.stance_torque"] == pytest.approx(wanted.runner["hip.stance_torque"], rel=1e-9)
    with pytest.raises(InputError, match="target length = '9 km/h' is not allowed; allowed: a number in m"):
        find_gait("human", target={"length": "9 km/h"}, vary=["torque"])
    said = command.refusal("gait", "--target", "speed=9 cm", "--vary", "torque")
    assert "--target speed = '9 cm' is not allowed; allowed: a number in m/s" in said
