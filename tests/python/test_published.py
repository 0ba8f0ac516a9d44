"""Verdicts on the paper's statements, against references and independent derivations."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from conftest import reference_gaits
from scipy.integrate import solve_ivp
from tdmf_slip import Runner, find_gait, stride_map
from tdmf_slip.paper import published, results_page
from tdmf_slip.paper.claims import CLAMP, FREE, READINGS, Claim, Finding, Group
from tdmf_slip.paper.evidence import SETTLED, gather, gather_classic

MASS, STIFFNESS, LENGTH, GRAVITY, ENERGY = 80.0, 20000.0, 1.0, 9.81, 6000.0
"""The paper's classic SLIP."""
STORED = results_page.read(Path(__file__).parents[2] / "documentation/data/results", results_page.PAPERS)


@pytest.fixture(scope="module")
def evidence():
    return {reading: gather(Runner({"hip.swing_clamp": value})) for reading, value in READINGS.items()}


@pytest.fixture(scope="module")
def claims(evidence):
    return {claim.what: claim for claim in published.claims(evidence, gather_classic())}


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
    counts = [np.sum(np.abs(gait.eigenvalues) < 1e-2) for gait in evidence[CLAMP].sweep.gaits]
    assert set(counts) == {3, 4}


@pytest.mark.parametrize("reading", READINGS)
def test_a_simulation_settles_as_fast_as_its_eigenvalue_predicts(reading, evidence):
    """A distance of order 1 shrinks by the largest eigenvalue in each stride."""
    found = evidence[reading]
    rate = -math.log(found.sweep.gaits[-1].lambda_max)
    assert found.settling == pytest.approx(math.log(0.5 / SETTLED) / rate, rel=0.1)


def test_a_second_impact_would_be_counted(evidence):
    found = replace(evidence[FREE], further_touchdowns=3)
    (statement,) = (s for s in published.STATEMENTS if s.published == "second impact after lift-off")
    assert statement.judge(found).agrees and not statement.judge(evidence[FREE]).agrees


def test_a_gait_with_the_printed_torque_would_be_reported(evidence):
    found = evidence[FREE]
    settled = replace(found, printed_torque=replace(found.printed_torque, gaits=tuple(found.five)))
    (statement,) = (s for s in published.STATEMENTS if s.misprint)
    assert statement.judge(settled).agrees and not statement.judge(found).agrees


def next_height(height, angle):
    """One step of the classic SLIP by SciPy, in Cartesian coordinates about the foot."""

    def rates(time, state):
        x, y, vx, vy = state
        r = math.hypot(x, y)
        pull = STIFFNESS / MASS * (LENGTH - r) / r
        return [vx, vy, pull * x, pull * y - GRAVITY]

    def relaxed(time, state):
        return math.hypot(state[0], state[1]) - LENGTH

    relaxed.terminal, relaxed.direction = True, 1.0
    low = LENGTH * math.cos(angle)
    speed = math.sqrt(2.0 * (ENERGY / MASS - GRAVITY * height))
    start = [-LENGTH * math.sin(angle), low, speed, -math.sqrt(2.0 * GRAVITY * (height - low))]
    run = solve_ivp(rates, (0.0, 2.0), start, "DOP853", events=relaxed, rtol=1e-11, atol=1e-12)
    _, y, _, vy = run.y_events[0][0]
    return y + vy**2 / (2.0 * GRAVITY)


def test_the_slip_becomes_stable_where_a_difference_of_its_map_is_minus_one():
    """An orbit of period two is born there: the slope, by differences of another integration, is -1."""
    angle = gather_classic().lowest
    low, high = LENGTH * math.cos(angle) + 1e-6, 1.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if next_height(middle, angle) > middle else (low, middle)
    step = 1e-5
    slope = (next_height(low + step, angle) - next_height(low - step, angle)) / (2.0 * step)
    assert slope == pytest.approx(-1.0, abs=1e-4)
    assert math.degrees(angle) == pytest.approx(31.28, abs=0.005)


def test_the_stored_statements_are_what_is_computed(claims):
    stored = {row["what"]: row for row in STORED["statements"]}
    assert stored == {what: claim.as_json() for what, claim in claims.items()}
