"""Proofs of gaits off Table 1: slopes, thrust, retraction, pushes; of random runners; what they attract."""

import functools
import json
import pathlib

import numpy as np
import pytest
import tdmf_slip
from conftest import CLAMPED, release, some_of
from tdmf_slip.errors import TdmfSlipError
from tdmf_slip.library.fixed_point import gait_near
from tdmf_slip.library.strides import strides_from

pytest.importorskip("flint")


FURTHER = json.loads(pathlib.Path(__file__).with_name("further_gaits.json").read_text(encoding="utf-8"))[
    "gaits"
]
PUBLISHED = [
    gait["friction"]
    for gait in json.loads(pathlib.Path(__file__).with_name("proved_gaits.json").read_text(encoding="utf-8"))[
        "gaits"
    ]
]
FALLING = [gait for gait in FURTHER if "ground.stribeck_velocity" in gait["start_values"]]
EVERYTHING = next(gait for gait in FURTHER if len(gait["start_values"]) > 4 and gait not in FALLING)
RANDOM, PROVED_AT_LEAST = 40, 35
DOCUMENTATION = pathlib.Path(__file__).parents[2] / "documentation"
RANDOM_TABLE = DOCUMENTATION / "data/proved_random_gaits.jsonl"


def check_further(gait):
    """Against a gait that an independent program has computed to 1e-12."""
    given = {name: np.radians(float(value.removesuffix(" deg"))) if isinstance(value, str) else value
             for name, value in gait["start_values"].items()}  # fmt: skip
    found = gait_near(tdmf_slip.Runner(given | CLAMPED), gait["apex"])
    proof = tdmf_slip.prove(found, digits=6)
    assert proof.proved, proof.sentence
    assert proof.word == gait["word"]
    for ball, value in zip(proof.apex, gait["apex"], strict=True):
        assert abs(float(ball) - value) < 1e-12
    for name in ("period", "length", "hip_work", "leg_work", "speed", "cost_of_transport", "liftoff_angle"):
        assert abs(float(proof.quantities[name]) - gait[name]) < 1e-12 * max(1.0, abs(gait[name])), name
    assert proof.stable is found.stable


def test_a_gait_with_slope_retraction_static_friction_and_thrust_is_proved():
    check_further(EVERYTHING)


@release
@pytest.mark.parametrize("gait", FURTHER, ids=lambda gait: str(gait["start_values"]))
def test_every_gait_of_an_independent_program_is_proved(gait):
    check_further(gait)


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
    """Of the table that the guide to proofs shows."""
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
    gait = next(one for one in FURTHER if one["start_values"].get("hip.touchdown_angle") == "50 deg")
    given = {"hip.touchdown_angle": "50 deg", "hip.retraction_rate": "0.02", "ground.friction": "0.6"}
    return gait_near(tdmf_slip.Runner(given | CLAMPED), gait["apex"])


def test_a_whole_range_of_unstable_gaits_is_proved_to_be():
    gait = unstable_gait()
    proof = tdmf_slip.prove(gait, vary={"ground.friction": ("0.6", "0.6000004")})
    assert proof.proved, proof.sentence
    assert proof.stable is False
    assert "all are unstable" in proof.sentence


@functools.cache
def attraction_of(friction):
    return tdmf_slip.prove_attraction({"ground.friction": friction})


@pytest.mark.parametrize("friction", some_of(PUBLISHED, 1))
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
    attraction = attraction_of(PUBLISHED[0])
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
