"""Gaits with a target: it is met, or refused with the nearest gait."""

import json
import re
from pathlib import Path

import numpy as np
import pytest
from conftest import RELEASE, release, some_of
from tdmf_slip import InputError, Runner, TargetNotMetError, find_gait
from tdmf_slip.analysis.gait_problem import GaitProblem
from tdmf_slip.library.fixed_point import gait_near
from tdmf_slip.library.members import VARIED
from tdmf_slip.library.quantities import QUANTITIES, REDUCED_QUANTITIES, quantities_of
from tdmf_slip.variables.parameters import read_parameters

FAST_HUMAN = Path(__file__).with_name("fast_human.toml")


def relative_change(gait, name, factor):
    return {name: quantities_of(gait, [name])[name] * factor}


def assert_met(gait, target, within=1e-10):
    """The gait, searched again without the target, has the prescribed quantities."""
    again = gait_near(gait.runner, gait.apex)
    assert target
    for name, value in target.items():
        assert quantities_of(again, [name])[name] == pytest.approx(value, rel=within)


PRESCRIBED = [
    *((name, "full") for name in QUANTITIES if name != "positive_leg_work"),
    *((name, "reduced") for name in REDUCED_QUANTITIES),
]


@pytest.mark.parametrize(("quantity", "model"), PRESCRIBED)
def test_each_quantity_can_be_prescribed(quantity, model):
    target = relative_change(find_gait({"ground.friction": 0.6}, model=model), quantity, 1.03)
    gait = find_gait({"ground.friction": 0.6}, target=target, vary=["hip.stance_torque"], model=model)
    assert_met(gait, target)
    assert gait.runner.reduced == (model == "reduced")


def test_three_parameters_make_three_quantities():
    gait = find_gait()
    factors = {"speed": 1.02, "frequency": 0.98, "cost_of_transport": 1.01}
    target = {name: quantities_of(gait, [name])[name] * factor for name, factor in factors.items()}
    assert_met(find_gait(target=target, vary=["hip.stance_torque", "leg.stiffness", "leg.damping"]), target)


@pytest.mark.parametrize(
    ("target", "vary"),
    [
        ({"speed": 1.08}, ["hip.stance_torque", "leg.stiffness"]),
        pytest.param(
            {"speed": 1.2, "cost_of_transport": 0.4},
            ["leg.damping", "hip.stance_torque", "foot.mass"],
            marks=release,
        ),
    ],
)
def test_several_parameters_change_as_little_as_the_target_lets_them(target, vary):
    """Wherever one of them is held elsewhere, the others have to change more together."""
    first = find_gait({"ground.friction": 0.6})

    def change(gait):
        return np.linalg.norm([gait.runner[name] / first.runner[name] - 1.0 for name in vary])

    found = find_gait(first, target=target, vary=vary)
    assert_met(found, target)
    assert all(found.runner[name] != first.runner[name] for name in vary)
    for name in vary:
        others = [other for other in vary if other != name]
        for factor in (0.995, 1.005):
            runner = found.runner.replace({name: factor * found.runner[name]})
            beside = find_gait(runner, guess=found.apex, target=target, vary=others)
            assert change(beside) > change(found)


def test_the_preset_is_a_jogger():
    """The gait has the values measured on people that its file cites, and a straight leg's duty factor."""
    gait = find_gait(read_parameters("human"))
    values, stride = gait.runner, gait.stride
    assert gait.stable and gait.word == "+0+" and stride["touchdowns"] == 1.0
    assert stride["speed"] == pytest.approx(2.7, rel=0.01)
    assert 1.0 / stride["period"] == pytest.approx(2.62, rel=0.01)
    weight = (values["body.mass"] + values["foot.mass"]) * values["gravity"]
    assert 2.0 < stride["peak_force"] / weight < 3.0
    clears = 1.0 / (1.0 + stride["speed"] / np.sqrt(values["gravity"] * values["leg.free_length"]))
    assert 0.45 < stride["duty_factor"] < clears < 0.71
    assert values["foot.mass"] / (values["body.mass"] + values["foot.mass"]) == pytest.approx(0.061, abs=5e-4)
    assert 15800.0 < values["leg.stiffness"] < 26300.0


@pytest.mark.parametrize("target", [{"speed": 3.5, "frequency": 2.75}, {"speed": 5.0}])
def test_the_jogger_runs_with_a_target(command, target):
    options = [part for name, value in target.items() for part in ("--target", f"{name}={value}")]
    vary = "hip.stance_torque,leg.stiffness"
    status, out, said = command("gait", *options, "--vary", vary, "--parameters", "human", "--json")
    printed = json.loads(out)
    assert (status, said) == (0, "") and printed["stable"] and set(printed["free"]) == set(vary.split(","))
    assert printed["free"] == {name: printed["start_values"][name] for name in vary.split(",")}
    assert {name: printed["ordered"][name] for name in target} == pytest.approx(target, rel=1e-10)
    gait = gait_near(Runner(printed["start_values"]), printed["apex"])
    assert_met(gait, target)
    changed = {n for n, v in read_parameters("human").items() if n in VARIED and gait.runner[n] != v}
    assert changed - {"hip.touchdown_angle"} == set(vary.split(","))


REFUSED = {
    "fast": (str(FAST_HUMAN), {"speed": 3.5, "frequency": 2.75}, ["hip.stance_torque", "leg.stiffness"]),
    "slow": ("paper", {"speed": 1.0, "frequency": 0.1}, ["hip.stance_torque", "leg.damping"]),
    "far": ("paper", {"speed": 3.0}, ["hip.touchdown_angle"]),
}


@pytest.fixture(scope="module", params=some_of(REFUSED, 2))
def refused(request):
    """A target that is not met: parameters, target, varied names, error, and number of strides."""
    name, target, vary = REFUSED[request.param]
    strides, honest = [], GaitProblem.linearize

    def counted(self, at):
        strides.append(at)
        return honest(self, at)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(GaitProblem, "linearize", counted)
        with pytest.raises(TargetNotMetError, match="the nearest one has speed") as error:
            find_gait(read_parameters(name), target=target, vary=vary)
    return read_parameters(name), target, vary, error.value, len(strides)


def gap(gait, target):
    has = quantities_of(gait, list(target))
    return np.linalg.norm([has[name] / value - 1.0 for name, value in target.items()])


def test_the_nearest_gait_is_nearer_than_the_first(refused):
    """It is found by a bounded number of strides, however hopeless the target."""
    parameters, target, _vary, error, strides = refused
    assert strides < 2400
    nearest = error.nearest
    assert 1e-10 < gap(nearest, target) < gap(find_gait(parameters), target)
    again = gait_near(nearest.runner, nearest.apex)
    assert gap(again, target) == pytest.approx(gap(nearest, target), rel=1e-6)
    assert {n for n in VARIED if nearest.runner[n] != again.runner[n]} == set()


def test_a_suggested_parameter_meets_the_target(refused):
    """Each help is tried as printed, varied too or instead of another: the target is met, or nearer."""
    parameters, target, vary, error, _ = refused
    printed = re.findall(
        r"vary ([\w.]+) (too|instead of ([\w.]+)) \((meets the target|comes nearer)\)", str(error)
    )
    assert 1 <= len(printed) <= 3 and tuple(name for name, *_ in printed) == error.helps[: len(printed)]
    assert printed[0][-1] == "meets the target"
    for name, _, instead, result in printed[: 3 if RELEASE else 1]:
        mended = [*(one for one in vary if one != instead), name]
        try:
            gait = find_gait(parameters, target=target, vary=mended)
            assert_met(gait, target)
        except TargetNotMetError as problem:
            assert result == "comes nearer"
            assert gap(problem.nearest, target) < 0.96 * gap(error.nearest, target)


def test_the_command_reports_the_nearest_gait_and_the_helps(command):
    target = ["--target", "cost_of_transport=0.001", "--vary", "hip.stance_torque"]
    status, out, said = command("gait", "--friction", "0.6", "--model", "reduced", *target, "--json")
    printed = json.loads(out)
    assert status == 1 and "no gait with cost_of_transport 0.001" in said
    assert printed["nearest"]["cost_of_transport"] > 0.001
    assert set(printed["nearest"]["free"]) == {"hip.stance_torque"}
    assert "hip.stance_torque" not in printed["helps"]


@pytest.mark.parametrize("target", [{}, {"velocity": 1.0}, {"speed": "fast"}, 3.0])
def test_a_target_of_the_wrong_kind_is_refused(target):
    with pytest.raises(InputError, match=r"target|speed"):
        find_gait({}, target=target, vary=["leg.stiffness"])


HAD = {
    "friction 0.163": (
        {"ground.friction": 0.163},
        {"speed": 0.79559, "duty_factor": 0.03504},
        ["leg.thrust", "leg.stiffness"],
    ),
    "friction 2.5479": (
        {"ground.friction": 2.5479},
        {"length": 4.0397, "peak_force": 0.25307},
        ["hip.stance_torque", "hip.touchdown_angle"],
    ),
}
"""Targets that stable gaits have, far from the runner's own: by thrust 0.00867 and stiffness 1.2766, and by
torque 0.11006 and angle 0.71879."""


@pytest.mark.parametrize("name", HAD)
def test_gaits_far_from_the_runners_own_are_found(name):
    runner, target, vary = HAD[name]
    gait = find_gait(runner, target=target, vary=vary)
    assert_met(gait, target)
    values = Runner(runner)
    assert {n for n in VARIED if gait.runner[n] != values[n]} <= set(vary)


def test_the_target_of_a_random_runner_is_met():
    """Each target is read off a runner with random values, so that it can be met."""
    ranges = {
        "hip.stance_torque": (0.1, 0.45),
        "hip.touchdown_angle": (0.4, 0.9),
        "leg.damping": (0.08, 0.35),
        "leg.stiffness": (0.7, 1.6),
        "hip.kd": (0.05, 0.2),
        "leg.thrust": (0.0, 0.2),
    }
    random, met = np.random.default_rng(2026), 0
    for _ in range(12 if RELEASE else 6):
        vary = [str(name) for name in random.choice(list(ranges), size=2, replace=False)]
        true = find_gait({name: random.uniform(*ranges[name]) for name in vary})
        names = [str(name) for name in random.choice(QUANTITIES, size=2, replace=False)]
        target = quantities_of(true, names)
        if min(map(abs, target.values())) > 1e-6:
            assert_met(find_gait({}, target=target, vary=vary), target, 1e-9)
            met += 1
    assert met >= (10 if RELEASE else 4)
