"""Proofs of gaits over whole ranges of a parameter, and the table of them that is published."""

import gzip
import hashlib
import itertools
import json
import pathlib
import sys
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
import tdmf_slip
from conftest import CLAMPED
from tdmf_slip.errors import InputError, RunError

pytest.importorskip("flint")

from tdmf_slip.library.members import MOVING
from tdmf_slip.proof.given import gait_of
from tdmf_slip.proof.parameters import Parameters
from tdmf_slip.proof.range_proof import Subinterval
from tdmf_slip.proof.range_prover import RangeProver, _write, proved_subinterval

DOCUMENTATION = pathlib.Path(__file__).parents[2] / "documentation"
TABLE = DOCUMENTATION / "data/proved_friction.jsonl"
LONG_TABLE = DOCUMENTATION / "data/proved_friction_from_0.05.jsonl.gz"


@pytest.fixture(scope="module")
def span(tmp_path_factory):
    """A short range, and the file that it is on."""
    file = tmp_path_factory.mktemp("range") / "range.jsonl"
    given = {"ground.friction": "10"}
    return tdmf_slip.prove(given, vary={"ground.friction": ("10", "10.04")}, output=file), file


@pytest.mark.skipif(sys.platform == "win32", reason="the limit of a file's size is one of POSIX")
def test_a_full_disk_leaves_a_file_of_parts_as_it_was(tmp_path):
    import resource

    file, head, part = (
        tmp_path / "range.jsonl",
        {"version": "1", "vary": "x" * 50},
        (Fraction(0), Fraction(1)),
    )
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    try:
        resource.setrlimit(resource.RLIMIT_FSIZE, (100, limits[1]))
        with pytest.raises(RunError, match=r"range\.jsonl: cannot be written: File too large"):
            _write(file, head, part, [])
        assert not file.exists()
        resource.setrlimit(resource.RLIMIT_FSIZE, (200, limits[1]))
        _write(file, head, part, [])
        whole = file.read_bytes()
        with pytest.raises(RunError, match="cannot be written"):
            _write(file, head, (Fraction(1), Fraction(2)), [Subinterval(Fraction(1), Fraction(2))])
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert file.read_bytes() == whole and whole.endswith(b"\n")


def test_a_whole_range_is_proved_by_subdivision(span):
    proof, _ = span
    assert proof.proved, proof.sentence
    assert proof.words == ("0+",)
    assert proof.stable
    assert proof.is_one_branch
    assert len(proof.subintervals) >= 2
    assert proof.subintervals[0].begin == 10
    assert proof.subintervals[-1].end == Fraction("10.04")
    assert all(
        one.end == other.begin for one, other in zip(proof.subintervals, proof.subintervals[1:], strict=False)
    )


def test_a_proof_of_a_range_goes_on_from_its_file(span):
    proof, file = span
    text = file.read_text(encoding="utf-8")
    vary = {"ground.friction": ("10", "10.04")}
    assert (
        tdmf_slip.prove({"ground.friction": "10"}, vary=vary, output=file).subintervals == proof.subintervals
    )
    assert file.read_text(encoding="utf-8") == text
    with pytest.raises(InputError, match="does not exist"):
        tdmf_slip.prove(vary=vary, output=file.parent / "none" / "range.jsonl")
    with pytest.raises(InputError, match="not of this range"):
        tdmf_slip.prove(vary={"ground.friction": ("10", "10.1")}, output=file)


@pytest.fixture(scope="module")
def table():
    """The published table of proved gaits against friction: its heading, and all its pieces."""
    head, *parts = (json.loads(line) for line in TABLE.read_text(encoding="utf-8").splitlines())
    return head, [Subinterval.of_row(row) for part in parts for row in part["pieces"]]


def test_the_published_table_covers_its_range_with_one_branch(table):
    head, subintervals = table
    assert head["range"] == ["47/100", "12/25"]
    assert (subintervals[0].begin, subintervals[-1].end) == (Fraction("0.47"), Fraction("0.48"))
    assert all(
        subinterval.proved and subinterval.stable and subinterval.word == "+0-"
        for subinterval in subintervals
    )
    assert all(one.meets(other) for one, other in itertools.pairwise(subintervals))
    assert len(subintervals) < 40


def test_the_published_table_is_of_the_runner_of_today():
    """Given the table, the command has nothing left to do."""
    text = TABLE.read_bytes()
    vary = {"ground.friction": ("0.47", "0.48")}
    proof = tdmf_slip.prove(vary=vary, output=TABLE)
    assert TABLE.read_bytes() == text
    assert proof.proved
    assert proof.is_one_branch


def test_a_file_of_another_runner_is_not_gone_on_with(span, tmp_path):
    proof, file = span
    vary = {"ground.friction": ("10", "10.04")}
    head, *parts = file.read_text(encoding="utf-8").splitlines()
    printed = json.loads(head)
    recorded = printed["parameters"]
    assert {*recorded, "ground.friction"} == {*MOVING} and recorded["ground.stribeck_velocity"] == "0"
    other = tmp_path / "other.jsonl"
    other.write_text("\n".join([json.dumps(printed | {"version": "0"}), *parts, ""]), encoding="utf-8")
    assert tdmf_slip.prove(vary=vary, output=other).subintervals == proof.subintervals
    recorded["ground.stribeck_velocity"] = "1/10"
    other.write_text("\n".join([json.dumps(printed), *parts, ""]), encoding="utf-8")
    with pytest.raises(InputError, match="not of this range and runner"):
        tdmf_slip.prove(vary=vary, output=other)


def test_pieces_of_the_published_table_are_proved_again(table):
    _, values = gait_of({"ground.friction": "0.47"})
    parameters = Parameters(values, "ground.friction")
    for subinterval in table[1][:: len(table[1]) - 1]:
        again, _ = proved_subinterval(parameters, subinterval)
        assert (again.word, again.stable) == (subinterval.word, subinterval.stable)
        assert all(a < b for a, b in zip(again.enclosure, subinterval.box, strict=True))
        assert np.allclose(again.enclosure, subinterval.enclosure, rtol=0.02)


def test_the_guide_has_the_hashes_of_both_tables(table, long_table):
    guide = (DOCUMENTATION / "guides/proof_ranges.md").read_text(encoding="utf-8")
    for content, subintervals in (
        (TABLE.read_bytes(), table[1]),
        (gzip.decompress(LONG_TABLE.read_bytes()), long_table),
    ):
        assert hashlib.sha256(content).hexdigest() in guide
        assert f"{len(subintervals):,} subintervals" in guide


@pytest.fixture(scope="module")
def long_table():
    """Subintervals of an hour's run over [0.05, 10], in order."""
    with gzip.open(LONG_TABLE, "rt", encoding="utf-8") as file:
        head, *parts = (json.loads(line) for line in file)
    assert head["range"] == ["1/20", "10"] and head["parameters"]["hip.swing_clamp"] == "true"
    subintervals = [Subinterval.of_row(row) for part in parts for row in part["pieces"]]
    return sorted(subintervals, key=lambda subinterval: subinterval.begin)


def test_the_long_table_has_no_gap_but_at_the_border_of_a_word(long_table):
    """The open part is narrower than 1e-9. Gaits up to 3e-6 above it are proved, but not to be one branch."""
    assert long_table[0].begin == Fraction("0.05") and long_table[-1].end > Fraction("0.477")
    assert all(one.end == other.begin for one, other in itertools.pairwise(long_table))
    below, left_open, above = (
        list(run) for _, run in itertools.groupby(long_table, key=lambda subinterval: subinterval.proved)
    )
    assert left_open[-1].end - left_open[0].begin < Fraction("1e-9")
    assert ({subinterval.word for subinterval in below}, {subinterval.word for subinterval in above}) == (
        {"+-"},
        {"+0-"},
    )
    assert all(subinterval.stable for subinterval in below + above)
    apart = [other.end for one, other in itertools.pairwise(long_table) if not one.meets(other)]
    assert left_open[0].begin < apart[0] and apart[-1] < left_open[-1].end + Fraction("3e-6")


def test_pieces_of_the_long_table_are_proved_again(long_table):
    chosen = long_table[::1900]
    assert len(chosen) >= 2
    for subinterval in chosen:
        _, values = gait_of({"ground.friction": str(float(subinterval.begin)), **CLAMPED})
        again, _ = proved_subinterval(Parameters(values, "ground.friction"), subinterval)
        assert (again.word, again.stable) == (subinterval.word, subinterval.stable)
        assert np.allclose(again.enclosure, subinterval.enclosure, rtol=0.02)


def test_a_piece_is_cut_until_its_gaits_are_told_to_be_stable(monkeypatch):
    """Every subinterval above a width is left open."""
    prove, widest = RangeProver._subinterval, Fraction("0.0000011")

    def open_if_wide(self, begin, end, gait):
        subinterval = prove(self, begin, end, gait)
        return replace(subinterval, stable=None) if end - begin > widest else subinterval

    monkeypatch.setattr(RangeProver, "_subinterval", open_if_wide)
    proof = tdmf_slip.prove({"ground.friction": "10"}, vary={"ground.friction": ("10", "10.000002")})
    assert proof.stable is True
    assert proof.is_one_branch
    assert all(subinterval.end - subinterval.begin <= widest for subinterval in proof.subintervals)
    assert proof.subintervals[0].begin == 10
    assert proof.subintervals[-1].end == Fraction("10.000002")


def test_pieces_that_do_not_meet_are_no_branch(span):
    first, second = span[0].subintervals[:2]
    assert first.meets(second)
    apart = Subinterval.of_row({**second.as_row(), "centre": [x + 1e-3 for x in second.centre]})
    assert not first.meets(apart)


@pytest.mark.parametrize(
    "vary",
    [{}, {"ground.friction": ("0.6", "0.5")}, {"ground.friction": ("0.5", "x")}, {"nothing": ("0", "1")},
     {"ground.friction": "0.5"}],
)  # fmt: skip
def test_a_range_that_is_none_is_refused(vary):
    with pytest.raises(InputError):
        tdmf_slip.prove(vary=vary)
