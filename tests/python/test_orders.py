"""Gaits to order: what is ordered is met, and what cannot be met is told with the nearest gait."""

import json
from pathlib import Path

import numpy as np
import pytest
from tdmf_slip import InputError, OrderNotMetError, find_gait, find_orbit, read_parameters
from tdmf_slip.library.orbit import orbit_near
from tdmf_slip.library.quantities import QUANTITIES, quantities_of, scales_of, varied_stride

FAST_HUMAN = Path(__file__).with_name("fast_human.toml")


def relative_change(orbit, name, factor):
    return {name: quantities_of(orbit, [name])[name] * factor}


def assert_met(gait, order, within=1e-10):
    """By the strides of a runner that knows nothing of the order."""
    again = orbit_near(gait.runner, gait.apex)
    assert order
    for name, value in order.items():
        assert quantities_of(again, [name])[name] == pytest.approx(value, rel=within)


@pytest.mark.parametrize("model", ["full", "reduced"])
@pytest.mark.parametrize("parameters", [{"ground.friction": 0.6}, read_parameters(FAST_HUMAN)])
def test_derivatives_of_what_is_ordered_are_those_of_differences(model, parameters):
    orbit = find_orbit(parameters, model=model)
    names = ["hip.stance_torque", "leg.stiffness", "body.mass", "gravity"]
    scales, steps = scales_of(orbit.runner, names), 1e-6
    exact = varied_stride(orbit.runner, orbit.apex, QUANTITIES, names).by_all * scales

    def moved(k, sign):
        apex, runner = orbit.apex.copy(), orbit.runner
        if k < len(apex):
            apex[k] += sign * steps * scales[k]
        else:
            name = names[k - len(apex)]
            runner = runner.but(name, runner.values[name] * (1.0 + sign * steps))
        stride = varied_stride(runner, apex, QUANTITIES, [])
        return np.append(stride.left_over, stride.quantities)

    for k in range(len(scales)):
        difference = (moved(k, 1.0) - moved(k, -1.0)) / (2.0 * steps)
        size = max(1.0, np.max(np.abs(exact[:, k])))
        assert exact[:, k] == pytest.approx(difference, abs=1e-6 * size), (k, names)


@pytest.mark.parametrize("model", ["full", "reduced"])
@pytest.mark.parametrize("quantity", QUANTITIES)
def test_each_quantity_can_be_ordered(quantity, model):
    order = relative_change(find_orbit({"ground.friction": 0.6}, model=model), quantity, 1.03)
    gait = find_gait({"ground.friction": 0.6}, order, ["hip.stance_torque"], model=model)
    assert_met(gait, order)
    assert gait.runner.reduced == (model == "reduced")


def test_three_parameters_make_three_quantities():
    gait = find_orbit({"ground.friction": 0.6})
    order = {
        **relative_change(gait, "speed", 1.02),
        **relative_change(gait, "frequency", 0.98),
        **relative_change(gait, "cost_of_transport", 1.01),
    }
    free = ["hip.stance_torque", "leg.stiffness", "leg.damping"]
    assert_met(find_gait({"ground.friction": 0.6}, order, free), order)


def test_the_fast_human_runs_at_five_metres_a_second():
    gait = find_gait(read_parameters(FAST_HUMAN), {"speed": 5.0}, ["hip.stance_torque"])
    assert_met(gait, {"speed": 5.0})
    assert gait.runner.values["leg.stiffness"] == 20000.0


def test_the_fast_human_jogs_by_another_touchdown_angle():
    order = {"speed": 3.5, "frequency": 2.75}
    gait = find_gait(read_parameters(FAST_HUMAN), order, ["hip.touchdown_angle", "leg.stiffness"])
    assert_met(gait, order)
    assert gait.stride["length"] == pytest.approx(3.5 / 2.75, rel=1e-10)


def test_the_fast_human_is_no_jogger_at_its_touchdown_angle():
    order = {"speed": 3.5, "frequency": 2.75}
    parameters = read_parameters(FAST_HUMAN)
    with pytest.raises(OrderNotMetError, match="the nearest has speed") as refused:
        find_gait(parameters, order, ["hip.stance_torque", "leg.stiffness"])
    assert "hip.touchdown_angle" in refused.value.helps
    has = quantities_of(refused.value.nearest, list(order))
    first = quantities_of(find_orbit(parameters), list(order))

    def gap(quantities):
        return np.hypot(quantities["speed"] / 3.5 - 1.0, quantities["frequency"] / 2.75 - 1.0)

    assert 1e-10 < gap(has) < 0.5 * gap(first)


def test_the_command_prints_a_gait_with_what_was_freed(command):
    status, out, said = command(
        "gait", "--parameters", str(FAST_HUMAN), "--speed", "5", "--free", "hip.stance_torque", "--json"
    )
    told = json.loads(out)
    assert (status, said) == (0, "")
    assert told["speed"] == pytest.approx(5.0, rel=1e-10) == told["ordered"]["speed"]
    assert told["free"] == {"hip.stance_torque": told["start_values"]["hip.stance_torque"]}


def test_the_command_tells_what_is_nearest_and_what_helps(command):
    order = ["--cost-of-transport", "0.001", "--free", "hip.stance_torque"]
    status, out, said = command("gait", "--friction", "0.6", "--model", "reduced", *order, "--json")
    told = json.loads(out)
    assert status == 1 and "no gait with cost_of_transport 0.001" in said
    assert told["nearest"]["cost_of_transport"] > 0.001
    assert set(told["nearest"]["free"]) == {"hip.stance_torque"}
    assert "hip.stance_torque" not in told["helps"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--speed", "1"], "--free is missing"),
        (["--free", "leg.stiffness"], "nothing is ordered"),
        (["--speed", "1", "--free", "leg.stiffness,leg.damping"], "as many parameters as are ordered, 1"),
        (["--speed", "1", "--frequency", "1", "--free", "leg.damping"], "as many parameters"),
        (["--speed", "1", "--frequency", "1", "--free", "leg.damping,leg.damping"], "given twice"),
        (["--speed", "1", "--free", "leg.stifness"], "leg.stiffness"),
        (["--speed", "1", "--free", "leg.min_length"], "does not act"),
        (
            ["--speed", "1", "--length", "9", "--free", "hip.stance_torque,control.stance_torque"],
            "each in its own way",
        ),
        (["--speed", "nan", "--free", "leg.stiffness"], "speed = nan is not allowed"),
        (["--frequency", "-1", "--free", "leg.stiffness"], "frequency = -1.0 is not allowed"),
        (["--duty-factor", "1.5", "--free", "leg.stiffness"], "duty_factor = 1.5 is not allowed"),
        (
            [
                "--speed",
                "1",
                "--length",
                "1",
                "--frequency",
                "1",
                "--free",
                "leg.stiffness,leg.damping,hip.kp",
            ],
            "two of them",
        ),
    ],
)
def test_a_bad_order_gets_one_sentence(command, arguments, words):
    status, out, said = command("gait", *arguments)
    assert (status, out) == (2, "")
    assert words in said and len(said.strip().splitlines()) == 1


@pytest.mark.parametrize("order", [{}, {"velocity": 1.0}, {"speed": "fast"}, 3.0])
def test_what_is_no_order_is_refused(order):
    with pytest.raises(InputError, match=r"order|speed"):
        find_gait({}, order, ["leg.stiffness"])
