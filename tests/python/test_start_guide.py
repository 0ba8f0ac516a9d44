"""The ways of the start guide, as printed: each finds the gait of a runner given at random.

The Python way runs where only the wheel is installed, the C way against the installed library. All that is
changed in the printed code are the values of the runner.
"""

import os
import random
import re
import shutil

import pytest
import tdmf_slip
from conftest import ROOT, succeed

GUIDES = ROOT / "documentation" / "guides"
PRINTED = (GUIDES / "start.md").read_text(encoding="utf-8")
VALUES = {"ground.friction": (0.4, 1.2, "0.43"), "leg.damping": (0.18, 0.22, "0.2")}
"""Range of values to put for a printed one, and the printed value, by parameter."""


@pytest.fixture(scope="module")
def runner():
    """Values that a user might put for those printed; a failure tells them."""
    draw = random.SystemRandom()
    return {name: round(draw.uniform(low, high), 4) for name, (low, high, _) in VALUES.items()}


@pytest.fixture(scope="module")
def gait(runner):
    """Newton's method finds it, in this process."""
    return tdmf_slip.find_gait(runner)


def with_values(code, form, runner):
    for name, value in runner.items():
        printed = form.format(name, VALUES[name][2])
        assert code.count(printed) == 1, printed
        code = code.replace(printed, form.format(name, value))
    return code


def test_the_python_way_with_only_the_wheel(environment, wheel, runner, gait):
    (code,) = re.findall(r"```\{code-cell\} python\n:tags: \[way-python\]\n(.*?)```", PRINTED, re.DOTALL)
    environment.install(wheel)
    said = environment.python("-c", with_values(code, '"{}": {}', runner))
    word, period, speed, stable = said.split()
    assert word == gait.word and stable == str(gait.stable), runner
    assert float(period) == pytest.approx(gait.period, rel=1e-9), runner
    assert float(speed) == pytest.approx(gait.stride["speed"], rel=1e-9), runner


@pytest.mark.skipif(shutil.which("pkg-config") is None, reason="pkg-config is not installed")
def test_the_c_way_against_the_installed_library(installed_library, tmp_path, runner, gait):
    (path,) = re.findall(r"```\{literalinclude\} (\S+\.c)\n", PRINTED)
    code = with_values((GUIDES / path).read_text(encoding="utf-8"), "{} = {};", runner)
    (tmp_path / "strides.c").write_text(code, encoding="utf-8")
    (folder,) = {path.parent for path in installed_library.rglob("tdmf_slip.pc")}
    variables = os.environ | {"PKG_CONFIG_PATH": str(folder)}
    flags = succeed("pkg-config", "--cflags", "--libs", "tdmf_slip", env=variables).split()
    succeed("cc", "-std=c99", tmp_path / "strides.c", *flags, "-o", tmp_path / "strides")
    found = re.fullmatch(
        r"(\S+), speed (\S+), cost of transport (\S+)\n", succeed(tmp_path / "strides", env={})
    )
    assert found and found[1] == gait.word, runner
    assert float(found[2]) == pytest.approx(gait.stride["speed"], abs=6e-7), runner
    assert float(found[3]) == pytest.approx(gait.stride["cost_of_transport"], abs=6e-7), runner
