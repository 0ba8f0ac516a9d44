"""Every parameter and input by its name: swept over, given to a gait and to a map of what it attracts."""

import json
import math

import numpy as np
import pytest
from tdmf_slip import basin, find_gait
from tdmf_slip.library.members import INPUTS, PARAMETERS, VARIED

NOTHING_MOVES = {"ground.height", "ground.stribeck_velocity", "leg.min_length"}
"""Of these the unit's own gait does not depend: its foot at rest has no more friction than one that slips."""


@pytest.fixture(scope="module")
def spans(unit):
    """Two values near each one's own, which is the lower one where it is a bound of its range."""
    found = {}
    for name in VARIED:
        start, variable = unit.start_of(name), unit.variables[name]
        low, high = (0.98 * start, 1.03 * start) if start else (0.0, 0.002)
        found[name] = max(low, float(variable.minimum)), high
    assert len(found) == len(PARAMETERS) + len(INPUTS) == 26
    return found


def test_all_can_be_swept_over(command, spans):
    swept = 0
    for name, (low, high) in spans.items():
        status, out, err = command("sweep", "--vary", f"{name}={low!r}:{high!r}:3", "--json")
        assert status == 0, f"{name}: {err}"
        found = json.loads(out)
        assert found["over"] == name
        values = [gait["value"] for gait in found["gaits"]]
        assert values == pytest.approx(np.linspace(low, high, 3), rel=1e-12) and not found["missing"]
        assert all(math.isfinite(gait["speed"]) for gait in found["gaits"])
        swept += 1
    assert swept == 26


def test_all_can_be_set_for_a_gait_and_for_what_it_attracts(command, spans, unit):
    tried, unmoved = 0, set()
    home = find_gait({}, fmu=unit).stride["speed"]
    for name, (_, value) in spans.items():
        status, out, err = command("gait", "--set", f"{name}={value!r}", "--json")
        assert status == 0, f"{name}: {err}"
        gait = json.loads(out)
        sizes = [1.0 + 1e-9, 1.0 - 1e-9]
        axes = [[size * gait["apex"][0] for size in sizes], [size * gait["apex"][1] for size in sizes]]
        data = basin({name: value}, ("com_height", "com_speed"), axes, threads=1, fmu=unit)
        assert data.attrs["settled_share"] == 1.0 and gait["stable"], name
        unmoved |= {name} if abs(gait["speed"] - home) < 1e-9 else set()
        tried += 1
    assert tried == 26 and unmoved == NOTHING_MOVES


def test_none_takes_what_is_beyond_its_range(command, unit):
    refused = 0
    for name in VARIED:
        variable = unit.variables[name]
        beyond = 2.0 * float(variable.maximum)
        for arguments in (
            ("sweep", "--vary", f"{name}={unit.start_of(name)!r}:{beyond!r}:3"),
            ("continue", "--vary", f"{name}={unit.start_of(name)!r}:{beyond!r}"),
            ("gait", "--set", f"{name}={beyond!r}"),
            ("basin", "--set", f"{name}={beyond!r}"),
        ):
            status, out, err = command(*arguments)
            assert status == 2 and not out
            (sentence,) = err.splitlines()
            assert name in sentence and repr(beyond) in sentence and "allowed: " in sentence
            refused += 1
    assert refused == 4 * 26
