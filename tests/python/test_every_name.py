"""Every parameter and input by its name: swept over, given to a gait and to a map of what it attracts."""

import math

import numpy as np
import pytest
from tdmf_slip import basin, find_gait
from tdmf_slip.library.members import FLAGS, INPUTS, PARAMETERS, VARIED

NOTHING_MOVES = {"ground.height", "ground.stribeck_velocity", "ground.patch_friction", "leg.min_length"}
"""Names without effect on the unit's own gait, where static and sliding friction are the same."""


BORDERS = {"ground.patch_begin", "ground.patch_end"}
"""Ends of a patch. An apex does not know where it is, so the return map refuses a patch."""
NAMES = [name for name in VARIED if name not in BORDERS]


@pytest.fixture(scope="module")
def spans(fmu):
    """Two values near each one's own, which is the lower one where it is a bound of its range."""
    found = {}
    for name in NAMES:
        start, variable = fmu.variables.start_of(name), fmu.variables[name]
        low, high = (0.98 * start, 1.03 * start) if start else (0.0, 0.002)
        found[name] = max(low, float(variable.minimum)), high
    assert len(found) == len(PARAMETERS) + len(INPUTS) - len(FLAGS) - len(BORDERS) == 27
    return found


def test_all_can_be_swept_over(command, spans):
    swept = 0
    for name, (low, high) in spans.items():
        found = command.json("sweep", "--vary", f"{name}={low!r}:{high!r}:3")
        assert found["over"] == name
        values = [gait["value"] for gait in found["gaits"]]
        assert values == pytest.approx(np.linspace(low, high, 3), rel=1e-12) and not found["missing"]
        assert all(math.isfinite(gait["speed"]) for gait in found["gaits"])
        swept += 1
    assert swept == 27


def test_all_can_be_set_for_a_gait_and_for_what_it_attracts(command, spans):
    tried, unmoved = 0, set()
    home = find_gait({}).stride["speed"]
    for name, (_, value) in spans.items():
        gait = command.json("gait", "--set", f"{name}={value!r}")
        ends = np.array([1.0 - 1e-9, 1.0 + 1e-9])
        axes = {"com_height": ends * gait["apex"][0], "com_speed": ends * gait["apex"][1]}
        data = basin({name: value}, axes, 2)
        assert data.settled_share == 1.0 and gait["stable"], name
        unmoved |= {name} if abs(gait["speed"] - home) < 1e-9 else set()
        tried += 1
    assert tried == 27 and unmoved == NOTHING_MOVES


def test_none_takes_what_is_beyond_its_range(command, fmu):
    refused = 0
    for name in NAMES:
        variable = fmu.variables[name]
        beyond = 2.0 * float(variable.maximum)
        for arguments in (
            ("sweep", "--vary", f"{name}={fmu.variables.start_of(name)!r}:{beyond!r}:3"),
            ("continue", "--vary", f"{name}={fmu.variables.start_of(name)!r}:{beyond!r}"),
            ("gait", "--set", f"{name}={beyond!r}"),
            ("basin", "--set", f"{name}={beyond!r}"),
        ):
            sentence = command.refusal(*arguments)
            assert name in sentence and repr(beyond) in sentence and "allowed: " in sentence
            refused += 1
    assert refused == 4 * 27
