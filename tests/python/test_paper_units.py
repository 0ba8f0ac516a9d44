"""Labels in the paper's units, and the warning for runners that mix them with SI units; values stay."""

import warnings

import matplotlib.pyplot as plt
import numpy as np
import pytest
import tdmf_slip
from tdmf_slip import Runner, find_gait
from tdmf_slip.variables.paper_units import MixedUnitsWarning, scale
from tdmf_slip.variables.table import DIMENSIONS, paper_unit


@pytest.mark.parametrize("unit", DIMENSIONS)
def test_a_label_says_how_large_its_scale_is(unit):
    """The label, evaluated with a runner's mass, stiffness and length, is the unit's scale."""
    mass, stiffness, length = 75.1, 20500.0, 0.93
    text = paper_unit(unit).replace("^", "**").replace(" ", "*")
    said = eval(text, {"m": mass, "k": stiffness, "l0": length, "sqrt": np.sqrt, "rad": 1.0})
    values = {"body.mass": mass, "leg.stiffness": stiffness, "leg.free_length": length}
    assert said == pytest.approx(scale(unit, values), rel=1e-12)


def test_labels_of_common_quantities_are_those_of_the_paper():
    wanted = {"m": "l0", "s": "sqrt(m/k)", "m/s": "l0 sqrt(k/m)", "N": "k l0", "rad": "rad", "1": "1"}
    assert {unit: paper_unit(unit) for unit in wanted} == wanted


def test_a_gait_says_its_units_and_keeps_its_values():
    paper, human = find_gait(), find_gait("human")
    assert f"period {paper.period:.6g} sqrt(m/k), speed {paper.speed:.6g} l0 sqrt(k/m)" in repr(paper)
    assert f"period {human.period:.6g} s, speed {human.speed:.6g} m/s" in repr(human)
    assert paper.period == paper.stride["period"] == paper.as_json()["period"]
    assert tdmf_slip.sweep(None, {"friction": [0.5, 0.6]}).gaits["speed"].attrs["units"] == "m/s"


@pytest.mark.parametrize(
    "arguments",
    [
        ("gait", "--friction", "0.43"),
        ("simulate", "--strides", "1"),
        ("sweep", "--friction", "0.5:0.6:2"),
    ],
)
def test_the_command_labels_by_the_runner(command, arguments):
    status, paper, _ = command(*arguments)
    assert status == 0 and "l0 sqrt(k/m)" in paper and "m/s" not in paper
    if arguments[0] in ("gait", "simulate"):
        status, human, _ = command(*arguments, "--parameters", "human")
        assert status == 0 and "m/s" in human and "l0" not in human


@pytest.mark.parametrize(
    "result",
    [
        lambda runner: tdmf_slip.simulate(runner, strides=1),
        lambda runner: tdmf_slip.sweep(runner, {"friction": [0.5, 0.6]}),
    ],
)
def test_pictures_label_by_the_runner(result):
    for runner, wanted, other in ((None, "l₀", "m/s"), ("human", "m/s", "l₀√")):
        figure = tdmf_slip.plot(result(runner))
        texts = [text.get_text() for text in figure.findobj(plt.Text)]
        assert other not in " ".join(texts), runner
        assert any(wanted in text for text in texts), texts


@pytest.mark.parametrize(
    "given",
    [
        {"leg.stiffness": "20 kN/m"},
        {"stiffness": 20e3},
        {"gravity": 9.81},
        {"body_mass": 80.0},
        {"body_mass": 80.0, "stiffness": 20e3, "gravity": 9.81, "foot_mass": 4.0},
        {"torque": "336 N m"},
    ],
)
def test_a_mixture_is_warned_of_with_what_is_still_the_papers(given):
    with pytest.warns(MixedUnitsWarning, match='preset "human"') as caught:
        runner = Runner(given)
    said = str(caught[0].message)
    assert caught[0].filename == __file__
    left = said.partition("still the paper's, ")[2]
    assert "hip.kp = 0.1" in left and not any(f"{name} = " in left for name in runner if name in given)


@pytest.mark.parametrize(
    "given",
    [
        None,
        "human",
        "paper",
        {"friction": 0.05, "damping": 1e-4, "foot_mass": 1e-5},
        {"torque": 0.6, "thrust": 0.2, "gravity": 0.002},
        {"stiffness": 2.0, "body_mass": 0.5},
    ],
)
def test_runners_of_one_system_of_units_are_not_warned_of(given):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        Runner(given)
        large = {"body.mass": 60.0, "leg.stiffness": 3e4, "leg.free_length": 0.8}
        variables = tdmf_slip.load_fmu().variables
        paper = Runner()
        Runner({n: v * scale(variables[n].unit or "1", large) for n, v in paper.items() if v != 0.05})


def test_the_command_warns_in_one_line_and_goes_on(command):
    status, out, said = command("simulate", "--set", "gravity=9.81", "--stop-time", "0.1")
    assert status == 0 and out
    assert said.count("\n") == 1 and said.startswith("tdmf-slip: warning: this runner may mix units")
