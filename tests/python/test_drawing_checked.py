"""A Matplotlib that cannot draw is told before the work that a picture is of."""

import importlib
import os

import matplotlib
import pytest
from conftest import run_python
from tdmf_slip.cli.main import module_of

WORK = ("find_gait", "fit", "simulate", "validate", "basin", "viability", "sweep", "continue_branch")
COMMANDS = [
    ("gait", "--plot", "run.png"),
    ("simulate", "--plot", "run.png"),
    ("sweep", "--friction", "0.5:0.6:2", "--plot", "run.svg"),
    ("continue", "--vary", "ground.friction=0.5:0.6", "--plot", "run.pdf"),
    ("basin", "--plot", "run.png"),
    ("viability", "--axes", "com_height=1:2", "--vary", "hip.touchdown_angle=0:1:2", "--plot", "run.png"),
    ("fit", "human_running", "--vary", "leg.stiffness", "--plot", "run.png"),
    ("fit", "human_running", "--vary", "leg.stiffness", "--report", "run.html"),
    ("animate", "--output", "run.gif"),
    ("figures", "--output", "run"),
    ("validate", "--pictures", "run"),
]


@pytest.mark.parametrize("arguments", COMMANDS, ids=lambda command: f"{command[0]} {command[-2]}")
def test_texts_by_latex_where_there_is_none_are_told_before_the_work(
    arguments, command, tmp_path, monkeypatch
):
    module = importlib.import_module(f"tdmf_slip.cli.{module_of(arguments[0])}")
    for work in WORK:
        monkeypatch.setattr(module, work, lambda *_, **__: pytest.fail("work before"), raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    with matplotlib.rc_context({"text.usetex": True}):
        sentence = command.refusal(*arguments)
    assert arguments[-2] in sentence and "Matplotlib cannot draw" in sentence and "latex" in sentence
    assert list(tmp_path.iterdir()) == []


def test_a_backend_that_is_none_is_told(tmp_path):
    surroundings = {"cwd": tmp_path, "env": os.environ | {"MPLBACKEND": "nothing"}}
    done = run_python("-m", "tdmf_slip", "simulate", "--plot", "run.png", **surroundings)
    assert (done.returncode, done.stdout) == (2, "")
    (sentence,) = done.stderr.splitlines()
    assert "Matplotlib does not start" in sentence and "nothing" in sentence
