"""Random runs with everything on, as the hand-written core had them before the page replaced it.

`core_runs.json` has the ends of 500 runs of `test_page_random.drawn`, in units m = k = l0 = 1.
"""

import json
from pathlib import Path

import numpy as np
import pytest
from conftest import some_of
from native_runs import STATES, NativeRun
from test_page_random import INPUTS, STEP_LIMIT, drawn

RUNS = json.loads((Path(__file__).parent / "core_runs.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("expected", some_of(RUNS, 60), ids=lambda row: row["number"])
def test_runs_end_where_the_hand_written_core_ended_them(expected):
    parameters, inputs, world, segments, (length, rate, force) = drawn(expected["number"])
    clamps = {"hip.swing_clamp": bool(expected["number"] % 2)}
    run = NativeRun(parameters | clamps, inputs, [world[n] for n in STATES[:8]], 1e-13, STEP_LIMIT)
    until = 0.0
    for duration, sets, rates in segments[: expected["segments"]]:
        tunable, given = ({n: v for n, v in sets.items() if (n in INPUTS) is of} for of in (False, True))
        run.set(tunable, given, rates)
        until += duration
        run.to(until)
    speed, energy = length * rate, force * length
    units = [length, length, length, 1, speed, speed, speed, rate, energy, 1 / rate, *[energy] * 5]
    found = np.array(list(run.motion.state)) / units
    assert run.fell == expected["fell"]
    assert run.motion.time * rate == pytest.approx(expected["time"], rel=1e-9)
    assert found == pytest.approx(expected["state"], rel=1e-8, abs=1e-8)
    assert (run.motion.record.stride.count, run.word) == (expected["strides"], expected["word"])
