"""Characters that an encoding lacks are replaced in print, and never cause an error after the work."""

import io
import json
import os
import pathlib
import re
import sys

import pytest
import tdmf_slip
from conftest import run_python
from tdmf_slip.terminal import encoding

PACKAGE = pathlib.Path(tdmf_slip.__file__).parent
NO_LOCALE = {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
COMMANDS = {
    "gait": ("gait",),
    "sweep": ("sweep", "--vary", "hip.touchdown_angle=40 deg:41 deg:2"),
    "simulate": ("simulate", "--strides", "2"),
    "rough": ("rough", "--roughness", "0.3", "--runners", "10", "--max-strides", "10"),
    "viability": (
        *("viability", "--axes", "com_height=1:2", "--axes", "com_speed=0.5:1.5"),
        *("--vary", "hip.touchdown_angle=20 deg:60 deg:3", "--n", "2"),
    ),
    "help": ("sweep", "--help"),
}


VALIDATE = """
import math
from tdmf_slip.cli import validate
from tdmf_slip.cli.main import main
from tdmf_slip.paper.claims import Claim, both_readings
from tdmf_slip.paper.reference_gaits import Drift
from tdmf_slip.paper.validation import Validation

claims = [Claim("speed", "≈ +10 %", both_readings("≈ +9 %", True))]
claims += [Claim("SLIP at 44°", "stable", both_readings("unstable", False))]
met = [Drift(0.6, "period", 2.0, 2.0, 3e-9, 1e-6), Drift(0.6, "apex", 1.0, 1.0, 7e-8, 1e-5)]
met += [Drift(math.nan, name, 0.5, 0.5, 4e-5, 5e-5) for name in ("a border", "of the SLIP")]
validate.validate = lambda **_: Validation({}, claims, met)
main(["validate"])
"""
"""The command at work, but with a verdict that took no minutes."""


EVERY_COMMAND = """
import json, sys
from tdmf_slip.cli.main import main

for options in json.loads(sys.argv[1]):
    status = main(options)
    for stream in (sys.stdout, sys.stderr):
        print("== ended:", status, file=stream, flush=True)
"""
"""Runs commands one after the other: to start a process for each takes most of the time."""


def run(arguments, environment, folder):
    return run_python(*arguments, text=False, cwd=folder, env=os.environ | environment)


def test_the_validation_is_told_in_the_encoding_of_a_redirect_on_windows(tmp_path):
    done = run(("-c", VALIDATE), {"PYTHONIOENCODING": "cp1252"}, tmp_path)
    assert done.returncode == 0 and b"Traceback" not in done.stderr, done.stderr
    text = done.stdout.decode("cp1252")
    assert text.count("differs") == 1 and text.count("agrees") == 1
    assert "SLIP at 44°" in text and "~ +10 %" in text


def test_every_command_prints_in_ascii(tmp_path):
    done = run(("-c", EVERY_COMMAND, json.dumps(list(COMMANDS.values()))), NO_LOCALE, tmp_path)
    assert done.returncode == 0 and b"Traceback" not in done.stderr, done.stderr
    printed, said = (re.split(r"== ended: (\d+)\n", of.decode("ascii")) for of in (done.stdout, done.stderr))
    assert len(printed) == len(said) == 2 * len(COMMANDS) + 1
    for number, name in enumerate(COMMANDS):
        assert (printed[2 * number] + said[2 * number]).strip(), name
        assert int(printed[2 * number + 1]) == 0, said[2 * number]


def test_a_name_that_is_no_ascii_is_refused_in_ascii(tmp_path):
    done = run(("-m", "tdmf_slip", "gait", "--set", "größe=√3"), NO_LOCALE, tmp_path)
    assert done.returncode == 2 and b"Traceback" not in done.stderr
    assert done.stderr.decode("ascii").strip()


@pytest.mark.parametrize("codec", ["ascii", "cp1252", "cp437", "latin-1", "utf-8", "utf-16"])
def test_equivalents_stand_for_what_is_missing(codec, monkeypatch):
    stream = io.TextIOWrapper(io.BytesIO(), encoding=codec)
    monkeypatch.setattr(sys, "stdout", stream)
    encoding.prints_anything()
    text = "40° ≈ m·s, l₀√(k/m), é, ∮ λ…"
    print(text, end="")
    stream.flush()
    printed = stream.buffer.getvalue().decode(codec)
    if codec == "ascii":
        assert printed == "40 deg ~ m.s, l0sqrt(k/m), e, ? lambda..."
    assert printed == text or codec not in ("utf-8", "utf-16")
    for character in text:
        assert character in printed or character not in character.encode(codec, "ignore").decode(codec)


def test_names_that_are_no_text_are_printed_as_they_are(monkeypatch):
    for codec in ("ascii", "cp1252", "utf-8"):
        stream = io.TextIOWrapper(io.BytesIO(), encoding=codec)
        monkeypatch.setattr(sys, "stdout", stream)
        encoding.prints_anything()
        print(os.fsdecode(b"caf\xe9 ") + "≈", end="")
        stream.flush()
        assert stream.buffer.getvalue().startswith(b"caf\xe9 ")
