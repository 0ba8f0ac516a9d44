"""Verdicts on the paper's statements, against references and independent derivations."""

import math
from copy import copy
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from conftest import reference_gaits
from tdmf_slip import Runner, find_gait, stride_map
from tdmf_slip.paper import published, results_page
from tdmf_slip.paper.claims import CLAMP, FREE, READINGS, Claim, Finding, Group
from tdmf_slip.paper.evidence import SETTLED, Evidence

STORED = results_page.read(Path(__file__).parents[2] / "documentation/data/results", results_page.PAPERS)


@pytest.fixture(scope="module")
def evidence():
    return {reading: Evidence(Runner({"hip.swing_clamp": value})) for reading, value in READINGS.items()}


@pytest.fixture(scope="module")
def claims(evidence):
    return {claim.what: claim for claim in published.claims(evidence)}


@pytest.mark.parametrize(
    ("free", "clamp", "options", "group", "verdict"),
    [
        (True, True, {}, Group.AGREES, "agrees"),
        (True, False, {}, Group.CORRECTION, "agrees: free swing only"),
        (False, True, {}, Group.CORRECTION, "agrees: clamp only"),
        (False, False, {}, Group.DIFFERS, "differs"),
        (False, False, {"misprint": True}, Group.CORRECTION, "misprint"),
        (False, False, {"beyond": True}, Group.BEYOND, "computed here"),
    ],
)
def test_the_findings_of_both_readings_decide_on_the_group(free, clamp, options, group, verdict):
    findings = {FREE: Finding("1", free), CLAMP: Finding("2", clamp)}
    claim = Claim("speed", "rises", findings, **options)
    assert (claim.group, claim.verdict) == (group, verdict)


@pytest.mark.parametrize("reading", READINGS)
def test_where_the_leg_waits_is_as_in_the_references(reading, claims):
    """The reference's leg at the apex is at eta theta_LO without the clamp, far from it with the clamp."""
    gait, *_ = gaits = reference_gaits(READINGS[reading])
    off = math.degrees(abs(gait["apex"][3] - 1.2 * gait["liftoff_angle"]))
    assert claims["theta after lift-off, mu = 10"].computed[reading].agrees == (off < 1.0)
    behind = all(gait["apex"][3] < 0.0 for gait in gaits if gait["friction"] >= 0.2)
    assert claims["trajectories"].computed[reading].agrees == behind == (reading == FREE)


@pytest.mark.parametrize("reading", READINGS)
def test_the_printed_torque_takes_energy_out(reading):
    """The leg turns backward in stance, so a positive torque does negative work."""
    gait = find_gait({"hip.swing_clamp": READINGS[reading], "ground.friction": 10.0})
    printed = gait.runner.replace({"hip.stance_torque": -gait.runner["hip.stance_torque"]})
    assert stride_map(printed, [gait.apex])["hip_work"].values[0, 0] < 0.0 < gait.stride["hip_work"]


@pytest.mark.parametrize("reading", READINGS)
def test_the_work_falls_below_friction_one_half_as_in_the_references(reading, claims):
    work = [gait["work"] for gait in reference_gaits(READINGS[reading]) if gait["friction"] <= 0.5]
    assert len(work) >= 2 and np.all(np.diff(work) < 0.0)
    assert not claims["work W below mu = 0.5"].computed[reading].agrees


def test_the_gait_with_fewest_small_eigenvalues_decides(evidence, claims):
    """The clamp's fourth smallest eigenvalue is above 0.01 at some frictions, below at others."""
    claim = claims["very small eigenvalues"]
    assert claim.computed[FREE].agrees and not claim.computed[CLAMP].agrees
    assert set(np.sum(evidence[CLAMP].moduli < 1e-2, axis=1)) == {3, 4}


@pytest.mark.parametrize("reading", READINGS)
def test_a_simulation_settles_as_fast_as_its_eigenvalue_predicts(reading, evidence):
    """A distance of order 1 shrinks by the largest eigenvalue in each stride."""
    found = evidence[reading]
    rate = -math.log(found.gaits["lambda_max"].iloc[-1])
    assert found.settling == pytest.approx(math.log(0.5 / SETTLED) / rate, rel=0.1)


def test_a_second_impact_would_be_counted(evidence):
    found = copy(evidence[FREE])
    found.further_touchdowns = 3
    (judge,) = (judge for claim, judge in published.STATEMENTS if "second impact" in claim.published)
    assert judge(found).agrees and not judge(evidence[FREE]).agrees


def test_a_gait_with_the_printed_torque_would_be_reported(evidence):
    found = evidence[FREE]
    settled = copy(found)
    settled.printed_torque = replace(found.printed_torque, gaits=tuple(found.five))
    (judge,) = (judge for claim, judge in published.STATEMENTS if claim.misprint)
    assert judge(settled).agrees and not judge(found).agrees


def test_the_stored_statements_are_what_is_computed(claims):
    stored = {row["what"]: row for row in STORED["statements"]}
    assert stored == {what: claim.as_json() for what, claim in claims.items()}
