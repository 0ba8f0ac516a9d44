"""The verdict of a validation, in an object, in JSON, in words and as an exit status."""

import json
import math
from dataclasses import replace

import pytest
from tdmf_slip.cli import validate as command_module
from tdmf_slip.paper.claims import CLAMP, FREE, WORDS, Claim, Finding, both_readings
from tdmf_slip.paper.guinea_fowl import SOURCE
from tdmf_slip.paper.reference_gaits import Drift, drifts
from tdmf_slip.paper.reference_gaits import gaits as recorded_gaits
from tdmf_slip.paper.settling import SettledRun
from tdmf_slip.paper.validation import Validation

CLAIMS = [
    Claim("speed", "rises", both_readings("falls", False), "5.2"),
    Claim("cost", "least", both_readings("least", True), "5.2"),
    Claim("leg", "waits", {FREE: Finding("waits", True), CLAMP: Finding("turns", False)}, "5.1"),
    Claim("low friction", "no gaits", both_readings("gaits", False), "5.1", beyond=True),
]
OTHERS = [Claim("patch", "safe", both_readings("slippery", False), source=SOURCE)]
MET = [
    Drift(0.6, "period", 2.0, 2.0, 3e-9, 1e-6, FREE),
    Drift(0.6, "speed", 1.0, 1.0, 5e-9, 1e-6, CLAMP),
    Drift(0.6, "apex", 1.0, 1.0, 7e-8, 1e-5, CLAMP),
    Drift(math.nan, "a border", 0.5, 0.5, 4e-5, 5e-5, FREE),
    Drift(math.nan, "of the SLIP", 1.0, 1.0, 9e-6, 1e-5),
]
MISSED = Drift(math.nan, "another border", 0.5, 0.6, 0.1, 5e-5, CLAMP)


STRIDE = {"period": 24.764449999, "length": 26.3, "speed": 1.0617424, "work": 0.1}
STRIDE |= {"cost_of_transport": 0.3717054, "liftoff_angle": -0.5}


@pytest.fixture
def gaits():
    one = SettledRun(0.6, WORDS[0.6], STRIDE, (1.0,) * 6, start_values={}, strides=60, change=0.0)
    other = replace(one, friction=0.2, word="+-")
    return {
        FREE: [one, replace(other, word="+0-")],
        CLAMP: [replace(one, stride={**STRIDE, "speed": 1.06}), other],
    }


def test_json_has_both_readings_of_every_statement(gaits):
    printed = json.loads(json.dumps(Validation(gaits, CLAIMS, [*MET, MISSED], OTHERS).as_json()))
    assert [(gait["reading"], gait["published_word"], gait["word"]) for gait in printed["gaits"]] == [
        (FREE, "+0-0+", "+0-0+"),
        (FREE, "+-", "+0-"),
        (CLAMP, "+0-0+", "+0-0+"),
        (CLAMP, "+-", "+-"),
    ]
    assert [claim["group"] for claim in printed["claims"]] == ["differs", "agrees", "correction", "beyond"]
    assert printed["claims"][2]["computed"] == {
        FREE: {"text": "waits", "agrees": True},
        CLAMP: {"text": "turns", "agrees": False},
    }
    assert printed["counts"] == {"agrees": 1, "correction": 1, "beyond": 1, "differs": 1}
    assert [claim["source"] for claim in printed["other_papers"]] == [SOURCE]
    assert [drift["passed"] for drift in printed["drifts"]] == [True] * 5 + [False] and not printed["passed"]


def test_json_has_deviations_of_a_run_from_its_reference():
    """The deviations of an apex are computed with arrays, but JSON knows only Python's own numbers."""
    known = recorded_gaits()[0]
    values = {name: getattr(known, name) for name in STRIDE}
    start = {"ground.friction": known.friction, "hip.swing_clamp": known.swing_clamp}
    run = SettledRun(known.friction, known.word, values, tuple(known.apex), start, strides=60, change=0.0)
    text = json.dumps(Validation({FREE: [run]}, (), drifts(run, known)).as_json())
    assert [drift["deviation"] for drift in json.loads(text)["drifts"]] == [0.0] * 12


def test_the_tables_of_a_validation(gaits):
    parts = Validation(gaits, CLAIMS, MET, OTHERS).as_text().split("\n\n")
    by_word, agree, correction, beyond, differ, counted, others, drifts = parts
    first, second = by_word.splitlines()[2:4]
    assert max(map(len, by_word.splitlines())) <= 100  # the columns that ./scripts/run promises
    speeds = ["+0-0+", "24.7644", "1.06174", "0.37171", "+0-0+", "24.7644", "1.06000", "0.37171"]
    assert first.split() == ["0.6", "+0-0+", *speeds, "same", "words"]
    assert second.startswith("0.2") and second.endswith("OTHER")
    assert agree.splitlines()[-1].split() == ["5.2", "cost", "least", "least", "same", "agrees"]
    assert " ".join(correction.split()[-6:]) == "waits turns agrees: free swing only"
    assert beyond.splitlines()[-1].endswith("computed here") and differ.splitlines()[-1].endswith("differs")
    assert counted.startswith("4 statements of Or and Moravia 2016: 1 agree, 1 depend")
    assert others.splitlines()[-1].split() == [
        *SOURCE.split(),
        *["patch", "safe", "slippery", "same", "differs"],
    ]
    assert "all 5 recorded values are met" in drifts
    assert "of a gait 5.0e-09 (allowed 1e-06), of an apex 7.0e-08 (allowed 1e-05)" in drifts


@pytest.mark.parametrize(("drifts", "expected"), [(MET, 0), ([*MET, MISSED], 1)])
def test_the_exit_status_says_whether_the_reference_is_met(gaits, drifts, expected, command, monkeypatch):
    monkeypatch.setattr(command_module, "validate", lambda **_: Validation(gaits, CLAIMS, drifts))
    status, printed, _ = command("validate", "--json")
    assert status == expected and json.loads(printed)["passed"] == (expected == 0)
    text = Validation(gaits, CLAIMS, drifts).as_text()
    assert ("1 of 6 recorded values are NOT met" in text and MISSED.what in text) == (expected == 1)
