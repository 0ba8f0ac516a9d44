"""Proofs of gaits off Table 1: slopes, thrust, retraction, pushes; of whole ranges; of random runners."""

import hashlib
import itertools
import json
import os
import pathlib
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
import tdmf_slip
from tdmf_slip.errors import InputError, TdmfSlipError
from tdmf_slip.library.gait import gait_near
from tdmf_slip.library.strides import strides_from

pytest.importorskip("flint")

from tdmf_slip.proof.given import gait_of
from tdmf_slip.proof.parameters import Parameters
from tdmf_slip.proof.range_proof import Piece
from tdmf_slip.proof.range_prover import RangeProver, proved_piece

READ = json.loads(pathlib.Path(__file__).with_name("further_gaits.json").read_text(encoding="utf-8"))["gaits"]
FURTHER = [gait for gait in READ if "ground.stribeck_velocity" not in gait["start_values"]]
LONG = pytest.mark.skipif("TDMF_SLIP_LONG" not in os.environ, reason="proofs that take minutes: --long")
EVERYTHING = next(gait for gait in FURTHER if len(gait["start_values"]) > 4)
RANDOM, PROVED_AT_LEAST = 40, 35
DOCUMENTATION = pathlib.Path(__file__).parents[2] / "documentation"
RANDOM_TABLE = DOCUMENTATION / "data/proved_random_gaits.jsonl"
TABLE = DOCUMENTATION / "data/proved_friction.jsonl"


def check_further(gait):
    """Against a gait that an independent program has computed to 1e-12."""
    given = {name: np.radians(float(value.removesuffix(" deg"))) if isinstance(value, str) else value
             for name, value in gait["start_values"].items()}  # fmt: skip
    found = gait_near(tdmf_slip.Runner.of(given), gait["apex"])
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


@LONG
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
            gait = tdmf_slip.find_gait({name: float(value) for name, value in given.items()})
        except TdmfSlipError:
            continue
        seen += 1
        yield given, gait


def row_of(given, proof):
    """Of the table that the guide to proofs shows."""
    told = {"given": given, "proved": proof.proved, "word": proof.word, "stable": proof.stable}
    time = proof.undecided.get("time")
    return told | {"undecided": None if proof.proved else [proof.undecided["guard"], f"{time:.4g}"]}


@LONG
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


@pytest.fixture(scope="module")
def span(tmp_path_factory):
    """A short range, and the file that it is on."""
    file = tmp_path_factory.mktemp("range") / "range.jsonl"
    given = {"ground.friction": "10"}
    return tdmf_slip.prove(given, vary={"ground.friction": ("10", "10.000004")}, output=file, workers=1), file


def test_a_whole_range_is_proved_by_subdivision(span):
    proof, _ = span
    assert proof.proved, proof.sentence
    assert proof.words == ("0+",)
    assert proof.stable
    assert proof.is_one_branch
    assert len(proof.pieces) >= 2
    assert proof.pieces[0].begin == 10
    assert proof.pieces[-1].end == Fraction("10.000004")
    assert all(one.end == other.begin for one, other in zip(proof.pieces, proof.pieces[1:], strict=False))


def test_a_proof_of_a_range_goes_on_from_its_file(span):
    proof, file = span
    text = file.read_text(encoding="utf-8")
    vary = {"ground.friction": ("10", "10.000004")}
    assert (
        tdmf_slip.prove({"ground.friction": "10"}, vary=vary, output=file, workers=1).pieces == proof.pieces
    )
    assert file.read_text(encoding="utf-8") == text
    with pytest.raises(InputError, match="not of this range"):
        tdmf_slip.prove(vary={"ground.friction": ("10", "10.1")}, output=file)


@pytest.fixture(scope="module")
def table():
    """The published table of proved gaits over the friction: its heading, and all its pieces."""
    head, *parts = (json.loads(line) for line in TABLE.read_text(encoding="utf-8").splitlines())
    return head, [Piece.of_row(row) for part in parts for row in part["pieces"]]


def test_the_published_table_has_no_gaps_and_is_of_one_branch(table):
    head, pieces = table
    assert head["range"] == ["47/100", "12/25"]
    assert pieces[0].begin == Fraction("0.47")
    assert all(piece.proved and piece.stable and piece.word == "+0-" for piece in pieces)
    assert all(one.meets(other) for one, other in itertools.pairwise(pieces))
    assert len(pieces) > 200


def test_pieces_of_the_published_table_are_proved_again(table):
    _, values = gait_of({"ground.friction": "0.47"})
    parameters = Parameters(values, "ground.friction")
    for piece in table[1][:: len(table[1]) // 2]:
        again, _ = proved_piece(parameters, piece)
        assert (again.word, again.stable) == (piece.word, piece.stable)
        assert all(a < b for a, b in zip(again.enclosure, piece.box, strict=True))
        assert np.allclose(again.enclosure, piece.enclosure, rtol=0.02)


def test_the_guide_has_the_hash_of_the_published_table(table):
    guide = (DOCUMENTATION / "guides/proofs.md").read_text(encoding="utf-8")
    assert hashlib.sha256(TABLE.read_bytes()).hexdigest() in guide
    told = float(table[1][-1].end)
    assert f"from 0.47 to {told:.6g}" in guide
    assert f"{len(table[1])} pieces" in guide


def unstable_gait():
    """Of an independent program: it retracts its leg and doubles its period."""
    gait = next(one for one in FURTHER if one["start_values"].get("hip.touchdown_angle") == "50 deg")
    given = {"hip.touchdown_angle": "50 deg", "hip.retraction_rate": "0.02", "ground.friction": "0.6"}
    return gait_near(tdmf_slip.Runner.of(given), gait["apex"])


def test_a_whole_range_of_unstable_gaits_is_proved_to_be():
    gait = unstable_gait()
    proof = tdmf_slip.prove(gait, vary={"ground.friction": ("0.6", "0.6000004")}, workers=1)
    assert proof.proved, proof.sentence
    assert proof.stable is False
    assert "all are unstable" in proof.sentence


def test_a_piece_is_cut_until_its_gaits_are_told_to_be_stable(monkeypatch):
    """Where every piece of more than a width is left open."""
    prove, widest = RangeProver._piece, Fraction("0.0000006")

    def open_if_wide(self, begin, end, gait):
        piece = prove(self, begin, end, gait)
        return replace(piece, stable=None) if end - begin > widest else piece

    monkeypatch.setattr(RangeProver, "_piece", open_if_wide)
    proof = tdmf_slip.prove(
        {"ground.friction": "10"}, vary={"ground.friction": ("10", "10.000004")}, workers=1
    )
    assert proof.stable is True
    assert proof.is_one_branch
    assert all(piece.end - piece.begin <= widest for piece in proof.pieces)
    assert proof.pieces[0].begin == 10
    assert proof.pieces[-1].end == Fraction("10.000004")


def test_pieces_that_do_not_meet_are_no_branch(span):
    first, second = span[0].pieces[:2]
    assert first.meets(second)
    apart = Piece.of_row({**second.as_row(), "centre": [x + 1e-3 for x in second.centre]})
    assert not first.meets(apart)


@pytest.mark.parametrize(
    "vary",
    [{}, {"ground.friction": ("0.6", "0.5")}, {"ground.friction": ("0.5", "x")}, {"nothing": ("0", "1")},
     {"ground.friction": "0.5"}],
)  # fmt: skip
def test_a_range_that_is_none_is_refused(vary):
    with pytest.raises(InputError):
        tdmf_slip.prove(vary=vary)


@pytest.fixture(scope="module")
def attraction():
    return tdmf_slip.prove_attraction({"ground.friction": "10"})


def test_starts_in_the_proved_ball_come_nearer_by_the_proved_rate(attraction):
    assert attraction.proved
    assert attraction.radius > 1e-7
    gait = tdmf_slip.find_gait({"ground.friction": 10.0})
    inverse = np.linalg.inv(np.array(attraction.basis))

    def size(offset):
        return np.max(np.abs(inverse @ offset) / np.array(attraction.weights))

    rng = np.random.default_rng(1)
    for _ in range(20):
        offset = attraction.radius * rng.uniform(-1, 1, 6)
        assert size(offset) <= attraction.norm_radius
        after = offset + strides_from(gait.runner, gait.apex + offset).left_over
        assert size(after) <= attraction.rate * size(offset) + 1e-9 * attraction.norm_radius + 1e-11


def test_no_ball_is_proved_around_an_unstable_gait():
    attraction = tdmf_slip.prove_attraction(unstable_gait())
    assert not attraction.proved
    assert "contracts" in attraction.undecided
