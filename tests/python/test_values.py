"""C of values and first variations, on an oscillator that bounces off a wall, against its closed form."""

import importlib
import math
import shutil
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace as Record

import pytest

CORE = Path(__file__).parents[2] / "c_core"
COMPILER = shutil.which("cc")
GIVEN = {"stiffness": 1.7, "wall": 0.3, "bounce": 0.8, "x": 1.1, "v": -0.2}
LATER = 0.9  # of time, after which states are compared; the wall is met before

pytestmark = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")

STRUCTS = """
#include <stdbool.h>
#include <stdio.h>
enum { TDMF_X, TDMF_V, TDMF_STATE_COUNT };
typedef struct { double stiffness, wall, bounce; } oscillator;
"""
PROGRAM = """
#include "oscillator_laws.h"
int main(void) {{
    const oscillator model = {{{stiffness}, {wall}, {bounce}}};
    const oscillator d_model = {{{d_stiffness}, {d_wall}, {d_bounce}}};
    const double before[] = {{{x}, {v}}}, d_before[] = {{{d_x}, {d_v}}};
    double rates[2], after[2], rates_after[2], d_met[2], d_after[2];
    tdmf_rates(&model, before, rates);
    tdmf_reset(&model, before, true, after);
    tdmf_rates(&model, after, rates_after);
    const oscillator held = {{0}};
    const double shift = -tdmf_vary_guard(&model, before, &d_model, d_before) /
                         tdmf_vary_guard(&model, before, &held, rates);
    for (int i = 0; i < 2; ++i) d_met[i] = d_before[i] + rates[i] * shift;
    tdmf_vary_reset(&model, before, true, after, &d_model, d_met, d_after);
    for (int i = 0; i < 2; ++i) d_after[i] -= rates_after[i] * shift;
    double d_rates[2];
    tdmf_vary_rates(&model, before, &d_model, d_before, d_rates);
    printf("%.17g %.17g %.17g %.17g %.17g\\n", tdmf_guard(&model, before), after[1], d_after[0], d_after[1],
           d_rates[1]);
    return 0;
}}
"""


def rates(model, state):
    """Xdot = v, vdot = -k x."""
    return Record(x=state.v, v=-model.stiffness * state.x)


def guard(model, state):
    """X - h, the distance from the wall."""
    return state.x - model.wall


def reset(model, state, sticks):
    """V+ = -e v where the wall gives back, else v+ = v."""
    return Record(x=state.x, v=-(model.bounce * state.v) if sticks else state.v)


@pytest.fixture(scope="module")
def values():
    sys.path.insert(0, str(CORE))
    try:
        return importlib.import_module("equations.derive.values")
    finally:
        sys.path.remove(str(CORE))


def flow(stiffness, x, v, time):
    w = math.sqrt(stiffness)
    sine, cosine = math.sin(w * time), math.cos(w * time)
    return x * cosine + v / w * sine, v * cosine - x * w * sine


def meeting(stiffness, wall, x, v, **_):
    """When the wall is met: x falls to h."""
    w = math.sqrt(stiffness)
    return (math.acos(wall / math.hypot(x, v / w)) + math.atan2(v / w, x)) / w


def later(**given):
    """The state after the bounce, in closed form."""
    time = meeting(**given)
    _, v = flow(given["stiffness"], given["x"], given["v"], time)
    return flow(given["stiffness"], given["wall"], -given["bounce"] * v, LATER - time)


def change(function, name):
    """By differences, whose error falls with the fourth power of the step."""
    step = 1e-3
    at = [function(**{**GIVEN, name: GIVEN[name] + share * step}) for share in (1, -1, 2, -2)]
    return [(8 * (a - b) - (c - d)) / (12 * step) for a, b, c, d in zip(*at, strict=True)]


@pytest.mark.parametrize("name", GIVEN)
def test_saltation_of_an_oscillator_is_that_of_its_closed_form(values, tmp_path, name):
    handed = {"model": "const oscillator *", "state": "const double[TDMF_STATE_COUNT]"}
    written = {"written": "double[TDMF_STATE_COUNT]"}
    functions = [
        values.Function(values.InC("void rates", rates), {**handed, **written}),
        values.Function(values.InC("double guard", guard), handed),
        values.Function(values.InC("void reset", reset, value="after"), {**handed, **written}),
    ]
    laws = '#include "quantities.h"\n' + "\n".join(function.c() for function in functions)
    time = meeting(**GIVEN)
    k = GIVEN["stiffness"]
    met = flow(k, GIVEN["x"], GIVEN["v"], time)
    d_x, d_v = change(lambda **given: flow(given["stiffness"], given["x"], given["v"], time), name)
    constants = {c: GIVEN[c] for c in ("stiffness", "wall", "bounce")}
    changes = {f"d_{c}": float(c == name) for c in constants}
    (tmp_path / "quantities.h").write_text(STRUCTS)
    (tmp_path / "oscillator_laws.h").write_text(laws)
    program = PROGRAM.format(**constants, **changes, x=met[0], v=met[1], d_x=d_x, d_v=d_v)
    (tmp_path / "main.c").write_text(program)
    flags = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-o", "main", "main.c", "-lm"]
    subprocess.run([COMPILER, *flags], cwd=tmp_path, check=True)
    printed = subprocess.run([tmp_path / "main"], check=True, capture_output=True, text=True).stdout
    distance, v_after, d_x_after, d_v_after, d_rate = map(float, printed.split())
    assert distance == pytest.approx(0.0, abs=1e-15)
    assert v_after == -GIVEN["bounce"] * met[1]
    assert d_rate == pytest.approx(-k * d_x - changes["d_stiffness"] * met[0])
    # On from the event, where the flow is linear in the state, and the stiffness changes it too.
    rest = LATER - time
    expected = change(later, name)
    on = flow(k, d_x_after, d_v_after, rest)
    if name == "stiffness":
        by_stiffness = change(
            lambda **given: flow(given["stiffness"], GIVEN["wall"], -GIVEN["bounce"] * met[1], rest), name
        )
        on = [a + b for a, b in zip(on, by_stiffness, strict=True)]
    assert on == pytest.approx(expected, rel=1e-9, abs=1e-9)
