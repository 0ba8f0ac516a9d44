"""Random runs with everything on, as the hand-written core had them before the page replaced it.

`core_runs.json` has the ends of 500 runs of `runner_pages.drawn`, in units m = k = l0 = 1.
"""

from functools import reduce

import numpy as np
import pytest
from conftest import some_of
from references import read
from runner_pages import INPUTS, MECHANICAL, STEP_LIMIT, drawn
from tdmf_slip.library.binding import c, ffi
from tdmf_slip.variables.table import VARIABLES

RUNS = read("core_runs.json")
STATES = [
    getattr(c, f"TDMF_{name[4:-1].upper().replace('.', '_')}")
    for name in VARIABLES
    if name.startswith("der(")
]
"""Numbers of the unit's continuous states."""


def write(struct, values):
    """Write values to a struct by the unit's names, "ground.friction"."""
    for name, value in values.items():
        *path, last = name.split(".")
        setattr(reduce(getattr, path, struct), last, value)


@pytest.mark.parametrize("expected", some_of(RUNS, 60), ids=lambda row: row["number"])
def test_runs_end_where_the_hand_written_core_ended_them(expected):
    parameters, inputs, world, segments, (length, rate, force) = drawn(expected["number"])
    values = ffi.new("tdmf_parameters *", c.tdmf_default_parameters())
    given, rates = ffi.new("tdmf_inputs *", c.tdmf_default_inputs()), ffi.new("tdmf_inputs *")
    model, motion = ffi.new("tdmf_model *"), ffi.new("tdmf_motion *")
    system = ffi.new("tdmf_system *", {"model": model, "inputs": given})
    solver = ffi.new("tdmf_solver *", c.tdmf_solver_default())
    solver.relative_tolerance, solver.step_limit = 1e-13, STEP_LIMIT
    write(values, parameters | {"hip.swing_clamp": bool(expected["number"] % 2)})
    write(given, inputs)
    assert not c.tdmf_model_create(model, values).variable
    motion.state[c.TDMF_FOOT_X : c.TDMF_FOOT_X + 8] = [world[name] for name in MECHANICAL]
    assert not c.tdmf_start(system[0], motion).variable
    for duration, sets, ramps in segments[: expected["segments"]]:
        write(values, {name: value for name, value in sets.items() if name not in INPUTS})
        write(given, {name: value for name, value in sets.items() if name in INPUTS})
        write(rates, ramps)
        assert not c.tdmf_model_create(model, values).variable
        end = motion.time + duration
        c.tdmf_native_advance(solver, system[0], rates, end, motion)
        given[0] = c.tdmf_inputs_after(given, rates, duration)
    speed, energy = length * rate, force * length
    units = [length, length, length, 1, speed, speed, speed, rate, energy, 1 / rate, *[energy] * 5]
    found, outputs = np.array([motion.state[number] for number in STATES]) / units, ffi.new("tdmf_outputs *")
    c.tdmf_outputs_of(system[0], motion, outputs)
    stride = outputs.stride
    assert motion.mode.fallen == expected["fell"]
    assert motion.time * rate == pytest.approx(expected["time"], rel=1e-9)
    assert found == pytest.approx(expected["state"], rel=1e-8, abs=1e-8)
    assert (stride.count, ffi.string(stride.word).decode()) == (expected["strides"], expected["word"])
