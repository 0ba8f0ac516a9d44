"""The verdict of a validation, in an object and in words."""

import math
import re
from dataclasses import replace
from pathlib import Path

import pytest
from tdmf_slip.paper.claims import WORDS, Claim
from tdmf_slip.paper.guinea_fowl import SOURCE
from tdmf_slip.paper.reference_gaits import Drift
from tdmf_slip.paper.settling import SettledRun
from tdmf_slip.paper.validation import Validation

CLAIMS = [
    Claim("speed", "rises", "falls", False),
    Claim("cost", "least", "least", True),
    Claim("patch", "safe", "slippery", False, SOURCE),
]
MET = [
    Drift(0.6, "period", 2.0, 2.0, 3e-9, 1e-6),
    Drift(0.6, "speed", 1.0, 1.0, 5e-9, 1e-6),
    Drift(0.6, "apex", 1.0, 1.0, 7e-8, 1e-5),
    Drift(math.nan, "a border", 0.5, 0.5, 4e-5, 5e-5),
    Drift(math.nan, "of the SLIP", 1.0, 1.0, 9e-6, 1e-5),
]
MISSED = Drift(math.nan, "another border", 0.5, 0.6, 0.1, 5e-5)


@pytest.fixture
def gaits():
    one = SettledRun(
        friction=0.6,
        word=WORDS[0.6],
        period=24.764449999,
        length=26.3,
        speed=1.0617424,
        work=0.1,
        cost_of_transport=0.3717054,
        liftoff_angle=-0.5,
        apex=(1.0,) * 6,
        start_values={},
        strides=60,
        change=0.0,
    )
    return [one, replace(one, friction=0.2, word="+0-")]


def test_a_validation_passes_if_nothing_is_missed(gaits):
    assert Validation(gaits, CLAIMS, MET).passed
    assert not Validation(gaits, CLAIMS, [MISSED, *MET]).passed
    printed = Validation(gaits, CLAIMS, [*MET, MISSED]).as_json()
    assert [gait["published_word"] for gait in printed["gaits"]] == ["+0-0+", "+-"]
    assert [claim["verdict"] for claim in printed["claims"]] == ["differs", "agrees", "differs"]
    assert printed["differing"] == 2
    assert [drift["passed"] for drift in printed["drifts"]] == [True] * 5 + [False] and not printed["passed"]


def test_the_tables_of_a_validation(gaits):
    by_word, claims, drifts = Validation(gaits, CLAIMS, MET).as_text().split("\n\n")
    first, second = by_word.splitlines()[2:4]
    assert first.split() == ["0.6", "+0-0+", "+0-0+", "24.76445", "1.061742", "0.371705", "same", "word"]
    assert second.startswith("0.2") and second.endswith("OTHER WORD")
    *rows, counted = claims.splitlines()[2:]
    assert [line.split() for line in rows] == [
        ["speed", "rises", "falls", "differs"],
        ["cost", "least", "least", "agrees"],
        ["patch", "safe", "slippery", "differs"],
    ]
    assert counted == (
        "2 of 3 statements differ: 1 of the 2 of Or and Moravia 2016, 1 of the 1 of Clark and Higham 2011."
    )
    assert counted.startswith(f"{claims.count(' differs')} of ")
    assert "all 5 recorded values are met" in drifts
    assert "of a gait 5.0e-09 (allowed 1e-06), of an apex 7.0e-08 (allowed 1e-05)" in drifts


def test_what_is_missed_is_listed(gaits):
    text = Validation(gaits, CLAIMS, [*MET, MISSED, replace(MISSED, friction=0.43)]).as_text()
    said, header, rule, *rows = text.split("\n\n")[-1].splitlines()
    assert "2 of 7 recorded values are NOT met" in said
    assert header.startswith("friction") and set(rule) <= {"-", " "}
    assert rows[0].split() == ["another", "border", "0.5", "0.6", "1.0e-01", "5e-05"]
    assert rows[1].split() == ["0.43", "another", "border", "0.5", "0.6", "1.0e-01", "5e-05"]


def test_the_guide_counts_what_differs_by_the_table():
    """The number is nowhere written by hand; the guide lists the statements as the table has them."""
    text = (Path(__file__).parents[2] / "documentation/guides/paper.md").read_text(encoding="utf-8")
    assert "in validation.differing:" in text and "validation.as_text()" in text
    assert re.search(r"\b(\w+) statements of the paper differ", text) is None
