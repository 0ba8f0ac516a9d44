"""Missing extras: other features work, and those that need one say in one sentence what to install."""

import json

import pytest
from conftest import run_python

PARTS = {
    "plots": {"matplotlib"},
    "cluster": {"dask", "distributed"},
    "proof": {"flint"},
}
"""Importable packages of each extra."""
WITHOUT = """
import sys
for name in sys.argv[1].split(","):
    sys.modules[name] = None
sys.argv[:2] = ["tdmf-slip"]
"""


def run_without(extras, program, *arguments):
    """A program in a Python that cannot import what the extras bring."""
    missing = ",".join(name for extra in extras for name in PARTS[extra])
    return run_python("-c", WITHOUT + program, missing, *arguments)


COMMAND = "from tdmf_slip.__main__ import main; sys.exit(main())"


NEEDING = {
    "plots": ("sweep", "--friction", "0.5:0.6:3", "--plot", "gait.png"),
    "cluster": ("basin", "--n", "2", "--scheduler", "tcp://127.0.0.1:1"),
    "proof": ("prove", "--friction", "0.6"),
}
"""Commands that need an extra."""


@pytest.mark.parametrize("extra", NEEDING)
def test_a_command_names_what_is_missing_before_it_computes(extra, tmp_path):
    done = run_without([extra], f"import os; os.chdir({str(tmp_path)!r}); {COMMAND}", *NEEDING[extra])
    assert done.returncode == 2 and done.stdout == "", done.stderr
    (said,) = done.stderr.splitlines()
    assert f"(the extra {extra})" in said and "missing" in said and ": pip install " in said
    assert list(tmp_path.iterdir()) == []


RESULTS = """
import tdmf_slip
try:
    {}
except tdmf_slip.InputError as problem:
    print(problem)
"""


@pytest.mark.parametrize(
    ("extra", "call"), [("plots", "tdmf_slip.find_gait().plot()"), ("proof", "tdmf_slip.prove")]
)
def test_a_function_names_what_is_missing(extra, call):
    done = run_without([extra], RESULTS.format(call))
    assert done.returncode == 0 and f"(the extra {extra})" in done.stdout, done.stderr


def test_gaits_runs_sweeps_branches_ensembles_and_feedback_need_no_extra():
    program = """
import tdmf_slip
gait = tdmf_slip.find_gait({"ground.friction": 0.43})
tdmf_slip.simulate({}, strides=1)
tdmf_slip.sweep({}, {"ground.friction": [0.6, 0.7]})
tdmf_slip.continue_branch({}, {"ground.friction": (0.6, 0.61)})
tdmf_slip.Batch(gait).run(2)
tdmf_slip.basin(gait, n=2)
tdmf_slip.stride_map(gait, gait.apex, strides=2)
tdmf_slip.simulate_many([{}, {}], strides=1)
axes, angles = {"com_height": (1.2, 1.8), "com_speed": (0.5, 1.2)}, {"hip.touchdown_angle": (0.6, 0.7, 2)}
tdmf_slip.viability({}, axes=axes, vary=angles, n=4)
tdmf_slip.dead_beat(gait, ["hip.stance_torque", "hip.touchdown_angle"])
"""
    done = run_without(PARTS, program)
    assert done.returncode == 0, done.stderr


COMMANDS = {
    "gait": ("--friction", "0.43", "--json"),
    "sweep": ("--friction", "0.5:0.6:2", "--output", "sweep.json"),
    "continue": ("--vary", "ground.friction=0.6:0.59", "--json"),
    "simulate": ("--strides", "1", "--output", "run.csv"),
    "basin": ("--n", "4", "--samples", "100", "--json"),
    "optimize": ("--minimize", "cost_of_transport", "--vary", "hip.stance_torque=0.19:0.21", "--starts", "1"),
    "viability": (
        *("--axes", "com_height=1:2", "--axes", "com_speed=0.5:1.5"),
        *("--vary", "hip.touchdown_angle=0.3:1.1:3", "--n", "2"),
    ),
    "variables": (),
}
ALL_COMMANDS = """
import json, os, tdmf_slip
from tdmf_slip.cli import main as command
os.chdir(sys.argv[1])
for name, options in json.loads(sys.argv[2]).items():
    print(name, command.main([name, *options]), file=sys.stderr)
"""


def test_commands_need_no_extra(tmp_path):
    """All that neither draw nor prove, in one process."""
    done = run_without(PARTS, ALL_COMMANDS, str(tmp_path), json.dumps(COMMANDS))
    said = [line for line in done.stderr.splitlines() if line.split(" ")[0] in COMMANDS]
    assert said == [f"{name} 0" for name in COMMANDS], done.stderr
    assert {path.name for path in tmp_path.iterdir()} == {"sweep.json", "run.csv"}


def test_every_command_helps_without_any_extra(tmp_path):
    """Commands that need an extra print their help without it, too."""
    others = ("animate", "bench", "compare", "figures", "fit", "prove", "rough", "validate")
    helps = dict.fromkeys((*COMMANDS, *others), ("--help",))
    done = run_without(PARTS, ALL_COMMANDS, str(tmp_path), json.dumps(helps))
    assert done.stderr.splitlines() == [f"{name} 0" for name in helps]
    assert done.stdout.count("Usage: tdmf-slip") == len(helps) == 16
