"""Proofs of the gaits and borders of independent programs and of random runners; what gaits attract."""

import functools
import json
import pathlib

import numpy as np
import pytest
import tdmf_slip
from conftest import CLAMPED, RELEASE, release, some_of
from references import FREE, FURTHER, GAITS, name_of
from tdmf_slip.errors import TdmfSlipError
from tdmf_slip.library.fixed_point import gait_near
from tdmf_slip.library.strides import strides_from

pytest.importorskip("flint")

RANDOM, PROVED_AT_LEAST = 40, 35
DOCUMENTATION = pathlib.Path(__file__).parents[2] / "documentation"
RANDOM_TABLE = DOCUMENTATION / "data/proved_random_gaits.jsonl"
FREE_SWING = {"ground.friction": 0.6, "hip.swing_clamp": False}
QUICK = [
    next(gait for gait in GAITS if gait["start_values"] == FREE_SWING),
    next(gait for gait in GAITS if "ground.stribeck_velocity" in gait["start_values"]),
    max(GAITS, key=lambda gait: len(gait["start_values"])),
]
"""Free swing, friction that falls with speed, and a slope with retraction, static friction and thrust."""


@pytest.mark.parametrize("gait", GAITS if RELEASE else QUICK, ids=name_of)
def test_a_gait_of_an_independent_program_is_proved_with_its_values(gait):
    """The programs are good to 1e-12, without the clamp to 2e-11."""
    found = gait_near(tdmf_slip.Runner(gait["start_values"]), gait["apex"])
    proof = tdmf_slip.prove(found, digits=6)
    assert proof.proved, proof.sentence
    assert (proof.word, proof.stable) == (gait["word"], found.stable)
    accuracy = 1e-12 if "rise" in gait else 2e-11
    assert [float(ball) for ball in proof.apex] == pytest.approx(gait["apex"], abs=accuracy)
    known = {name: gait[name] for name in proof.quantities if name in gait}
    assert len(known) >= 6
    proved = {name: float(proof.quantities[name]) for name in known}
    assert proved == pytest.approx(known, rel=accuracy, abs=accuracy)
    times = [float(time) for name, time in proof.events if name != "clamp"]
    wanted = [time for name, time in gait["events"] if "clamp" not in name]
    assert times == pytest.approx(wanted, abs=1e-10)


BORDERS = [(True, {"friction": 1.1441404, "from": "+0+", "to": "+0-0+"})]
BORDERS += [(False, border) for border in FREE["borders"][1:] + FREE["borders"][:1]]


@pytest.mark.parametrize(("clamp", "border"), some_of(BORDERS, 1))
def test_borders_are_proved_but_where_the_slip_would_begin_as_the_drive_ends(clamp, border):
    """Both events are at one instant there, and a proof does not say which is first, whatever the swing."""
    proof = tdmf_slip.prove_border(border["friction"], {"hip.swing_clamp": clamp}, digits=11, sides=False)
    if (border["from"], border["to"]) == ("+0+", "+0-0+"):
        assert not proof.proved and "slip onset backwards or mid-stance" in proof.sentence
    else:
        assert proof.proved and abs(float(proof.value) - border["friction"]) < 1e-10, proof.sentence
        assert proof.word_continued in (border["from"], border["to"])


def random_runner(rng):
    """Light feet, slopes, thrust and the like, as decimals."""
    draw = rng.uniform
    given = {
        "ground.friction": 10 ** draw(-1, 1),
        "foot.mass": 10 ** draw(-2.5, -0.5),
        "leg.damping": draw(0.1, 0.3),
        "hip.stance_torque": draw(0.1, 0.25),
        "hip.touchdown_angle": draw(0.56, 0.8),
        "hip.kp": draw(0.05, 0.2),
        "hip.kd": draw(0.05, 0.2),
        "gravity": 10 ** draw(-2.2, -1.6),
        "hip.liftoff_angle_factor": draw(1, 1.4),
    }
    further = {
        "ground.slope": draw(-0.05, 0.08),
        "ground.static_friction_ratio": draw(1, 1.6),
        "leg.thrust": draw(0, 0.05),
        "hip.retraction_rate": draw(-0.02, 0.05),
        "body.external_fx": draw(-0.001, 0.001),
        "body.external_fy": draw(-0.001, 0.001),
        "leg.extension": draw(-0.02, 0.02),
        "hip.external_torque": draw(-0.002, 0.002),
    }
    given |= {name: value for name, value in further.items() if rng.random() < 0.35}
    return {name: f"{value:.4g}" for name, value in given.items()}


def random_gaits():
    """Random runners that have a gait, and it."""
    rng, seen = np.random.default_rng(40), 0
    while seen < RANDOM:
        given = random_runner(rng)
        try:
            gait = tdmf_slip.find_gait({name: float(value) for name, value in given.items()} | CLAMPED)
        except TdmfSlipError:
            continue
        seen += 1
        yield given | {"hip.swing_clamp": "true"}, gait


def row_of(given, proof):
    """Row of the table that the guide to proofs shows."""
    row = {"given": given, "proved": proof.proved, "word": proof.word, "stable": proof.stable}
    time = proof.undecided.get("time")
    return row | {"undecided": None if proof.proved else [proof.undecided["guard"], f"{time:.4g}"]}


@release
def test_gaits_of_random_runners_are_proved_with_the_words_that_the_library_finds():
    rows = [(row_of(given, tdmf_slip.prove(given, digits=6)), gait) for given, gait in random_gaits()]
    stored = [json.loads(line) for line in RANDOM_TABLE.read_text(encoding="utf-8").splitlines()]
    assert [row for row, _ in rows] == stored
    proved = [(row, gait) for row, gait in rows if row["proved"]]
    assert all((row["word"], row["stable"]) == (gait.word, gait.stable) for row, gait in proved)
    assert all(row["undecided"][0] for row, _ in rows if not row["proved"])
    assert len(proved) >= PROVED_AT_LEAST
    assert sum(not gait.stable for _, gait in proved) > 0
    assert sum(float(row["given"]["foot.mass"]) < 0.01 for row, _ in proved) > 0
    assert len({row["word"] for row, _ in proved}) >= 5


def unstable_gait():
    """An independent program found it: the runner retracts its leg, and the period doubles."""
    gaits = FURTHER["gaits"]
    gait = next(one for one in gaits if one["start_values"].get("hip.touchdown_angle") == "50 deg")
    given = {"hip.touchdown_angle": "50 deg", "hip.retraction_rate": "0.02", "ground.friction": "0.6"}
    return gait_near(tdmf_slip.Runner(given | CLAMPED), gait["apex"])


def test_a_range_of_unstable_gaits_and_one_of_falling_friction_are_proved():
    proof = tdmf_slip.prove(unstable_gait(), vary={"ground.friction": ("0.6", "0.6000004")})
    assert proof.proved, proof.sentence
    assert proof.stable is False and "all are unstable" in proof.sentence
    gait = QUICK[1]
    runner = tdmf_slip.Runner(gait["start_values"])
    speed = str(gait["start_values"]["ground.stribeck_velocity"])
    span = {"ground.stribeck_velocity": (speed, f"{speed}0000004")}
    proof = tdmf_slip.prove(gait_near(runner, gait["apex"]), vary=span)
    assert proof.proved, proof.sentence
    assert proof.words == (gait["word"],) and proof.stable
    assert proof.subintervals[0].centre == pytest.approx(gait["apex"], abs=1e-5)


@functools.cache
def attraction_of(friction):
    return tdmf_slip.prove_attraction({"ground.friction": friction})


@pytest.mark.parametrize("friction", some_of(["10", "1.2", "0.6", "0.43", "0.2"], 1))
def test_starts_in_the_proved_ball_come_nearer_by_the_proved_rate(friction):
    """Two published gaits are tried, with --release all five."""
    attraction = attraction_of(friction)
    assert attraction.proved
    assert attraction.radius > 4e-7
    gait = tdmf_slip.find_gait({"ground.friction": float(friction)})
    assert gait.lambda_max <= attraction.rate < 1.0  # no norm falls faster than the largest eigenvalue
    inverse = np.linalg.inv(np.array(attraction.basis))

    def size(offset):
        return np.max(np.abs(inverse @ offset) / np.array(attraction.weights))

    rng = np.random.default_rng(1)
    for _ in range(20):
        offset = attraction.radius * rng.uniform(-1, 1, 6)
        assert size(offset) <= attraction.norm_radius
        after = offset + strides_from(gait.runner, gait.apex + offset).residual
        assert size(after) <= attraction.rate * size(offset) + 1e-9 * attraction.norm_radius + 1e-11


def test_a_ball_is_told_with_its_norm():
    attraction = attraction_of("10")
    printed = json.loads(json.dumps(attraction.as_json()))
    assert printed["proved"] is True
    basis = np.array([[complex(*entry) for entry in row] for row in printed["basis"]])
    assert np.array_equal(basis, attraction.basis)
    assert printed["weights"] == list(attraction.weights)
    assert printed["norm_radius"] == attraction.norm_radius


def test_no_ball_is_proved_around_an_unstable_gait():
    attraction = tdmf_slip.prove_attraction(unstable_gait())
    assert not attraction.proved
    assert "contracts" in attraction.undecided
