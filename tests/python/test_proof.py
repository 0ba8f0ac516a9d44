"""Proofs of gaits: against values that were proved by another program, and where they have to fail."""

import json
from dataclasses import replace
from fractions import Fraction

import pytest
import tdmf_slip
from conftest import CLAMPED, RELEASE, release
from references import read

pytest.importorskip("flint")

from click.testing import CliRunner
from flint import arb, ctx
from tdmf_slip.cli.prove import prove_command
from tdmf_slip.errors import InputError
from tdmf_slip.library.members import MOVING
from tdmf_slip.proof.accuracy import QUANTITIES, error_table, solver_errors
from tdmf_slip.proof.given import Exact, check_laws, gait_of
from tdmf_slip.proof.laws import NAMES_ON_PAGE

PROVED = read("proved_gaits.json")
GAITS = {gait["friction"]: gait for gait in PROVED["gaits"]}
EXACT, BY_CVODE = 1e-12, 1e-7
"""Errors of solvers, as the page on accuracy says."""
EVENTS = {
    "end of slip": "rest",
    "slip onset forwards": "slip+",
    "slip onset backwards": "slip-",
    "mid-stance": "midstance",
    "lift-off": "liftoff",
    "flight": "fly",
}


@pytest.fixture(autouse=True)
def precise():
    with ctx.workprec(400):
        yield


def agree(text, known):
    """Two enclosures of one number overlap, and are both narrow."""
    return arb(text).overlaps(arb(known))


def check(proof, known):
    printed = proof.as_json()
    assert proof.proved
    assert printed["word"] == known["word"]
    assert printed["stable"] is known["stable"]
    for name in ("period", "length", "speed"):
        assert agree(printed[name], known[name]), name
    for kind in ("apex", "eigenvalues"):
        assert len(printed[kind]) == 6
        assert all(agree(one, other) for one, other in zip(printed[kind], known[kind], strict=True)), kind
    assert [EVENTS.get(name, name) for name, _ in printed["events"]] == [name for name, _ in known["events"]]
    for (_, time), (_, known_time) in zip(printed["events"], known["events"], strict=True):
        assert agree(time, known_time)


@pytest.fixture(scope="module")
def proof():
    return tdmf_slip.prove({"ground.friction": "0.6", **CLAMPED})


@pytest.mark.parametrize("friction", GAITS if RELEASE else ["0.6"])
def test_a_published_gait_is_proved_with_the_values_that_another_program_proved(proof, friction):
    given = {"ground.friction": friction, **CLAMPED}
    check(proof if friction == "0.6" else tdmf_slip.prove(given, digits=30, box="1e-32"), GAITS[friction])


def test_a_proof_is_narrow_and_says_what_is_proved(proof):
    printed = proof.as_json()
    assert all(
        arb(value).rad() < 1e-20 for value in (*printed["apex"], *printed["eigenvalues"], printed["speed"])
    )
    assert "3/5" in proof.sentence
    assert "exactly one" in proof.sentence
    assert max(proof.box.radii) == Fraction(1, 10**6)


def test_every_solver_is_as_near_to_the_proved_gait_as_is_reported(proof):
    errors = solver_errors(proof)
    assert {"native", "lanes, two lanes"} < set(errors)
    assert sum("unit" in solver for solver in errors) == 3
    assert sum("CVODE" in solver for solver in errors) == 2
    for solver, of in errors.items():
        assert set(of) == {*QUANTITIES, "apex"}
        for name, error in of.items():
            assert 0 < error < (BY_CVODE if "CVODE" in solver else EXACT), (solver, name)
    smaller = {solver: dict.fromkeys(of, 1e-20) for solver, of in errors.items()}
    heading, *rows = error_table([smaller, errors])
    assert heading == ["solver", *QUANTITIES, "apex"]
    assert [row[0] for row in rows] == list(errors)
    assert dict(zip(heading, rows[0], strict=True))["period"] == f"{errors['native']['period']:.1e}"
    with pytest.raises(InputError, match="undecided"):
        solver_errors(replace(proof, proved=False))


@pytest.mark.parametrize(("box", "proved"), [(1e-10, False), (2e-9, True)])
def test_a_displaced_centre_is_proved_where_the_box_reaches_the_gait(box, proved):
    gait = tdmf_slip.find_gait({"ground.friction": 10.0, **CLAMPED})
    proof = tdmf_slip.prove(replace(gait, apex=gait.apex + 1e-9), box=box, digits=5)
    assert (proof.proved, proof.word) == (proved, "0+" if proved else "")
    if not proved:
        assert "inclusion" in proof.undecided["guard"]
        assert proof.sentence.startswith("Undecided")
        assert proof.as_json()["undecided"]["guard"] == proof.undecided["guard"]


def test_a_box_across_a_border_is_undecided_with_guard_and_time():
    proof = tdmf_slip.prove({"ground.friction": "0.49911", **CLAMPED}, box="1e-3", digits=5)
    assert not proof.proved
    assert 12 < proof.undecided["time"] < 14


@pytest.mark.parametrize("box", [0, -1, 2, "x", float("nan")])
def test_a_box_that_is_none_is_refused(box):
    with pytest.raises(InputError, match="box"):
        tdmf_slip.prove(box=box)


def test_the_command_prints_the_proof():
    ran = CliRunner().invoke(
        prove_command,
        ["--friction", "10", "--set", "hip.swing_clamp=true", "--digits", "13", "--compare", "--json"],
        standalone_mode=False,
    )
    printed = json.loads(ran.stdout)
    assert printed["proved"]
    assert printed["word"] == "0+"
    assert printed["solvers"]["native"]["period"] < EXACT
    assert agree(printed["period"], GAITS["10"]["period"])
    assert printed["parameters"]["ground.friction"] == "10"
    of_gait = {"proved", "sentence", "assumptions", "word", "stable", "box", "undecided"}
    assert of_gait | {"apex", "period", "speed", "cost_of_transport", "slip_distance", "eigenvalues"} <= set(
        printed
    )


def check_border(proof, known):
    assert proof.proved
    assert agree(proof.as_json()["value"], known["friction"])
    assert proof.value.rad() < 1e-8
    assert (proof.kind, proof.word_continued) == (known["kind"], known["word_continued"])


@pytest.fixture(scope="module")
def border():
    return tdmf_slip.prove_border(
        0.26585156,
        tdmf_slip.find_gait({"ground.friction": 0.25, **CLAMPED}),
        digits=5,
        sides=False,
    )


def test_a_border_is_proved_where_another_program_proved_it(border):
    check_border(border, PROVED["borders"][0])
    printed = border.as_json()
    assert printed["box"]["coordinates"][-1] == "ground.friction"
    assert len(printed["box"]["centre"]) == len(printed["box"]["radii"]) == 7


def test_no_border_is_proved_where_there_is_none():
    proof = tdmf_slip.prove_border(0.6, digits=5, sides=False)
    assert not proof.proved and "same" in proof.undecided["guard"]


def test_the_sides_of_a_border_are_reported_with_their_words(border, proof):
    below, above = (
        replace(proof, word=word, values=border.values | {"ground.friction": Exact(Fraction(value))})
        for word, value in (("+-", "0.2658"), ("+0-", "0.2659"))
    )
    whole = replace(border, sides=(below, above))
    assert whole.words == ("+-", "+0-")
    assert "The word changes: +- at 0.2658" in whole.sentence
    assert [side["word"] for side in whole.as_json()["sides"]] == ["+-", "+0-"]
    open_side = replace(below, proved=False, word="", undecided={"guard": "touchdown", "time": 12.0})
    half_open = replace(border, sides=(open_side, above))
    assert half_open.words == ("+0-",)
    assert "changes" not in half_open.sentence
    assert "the gait at 0.2658 is undecided, +0- at 0.2659" in half_open.sentence
    assert [side["proved"] for side in half_open.as_json()["sides"]] == [False, True]


@release
@pytest.mark.parametrize("known", PROVED["borders"], ids=lambda known: known["kind"])
def test_every_border_is_proved_with_a_gait_on_each_side(known):
    proof = tdmf_slip.prove_border(float(arb(known["friction"]).mid()), CLAMPED, digits=25)
    check_border(proof, known)
    assert len(set(proof.words)) == 2
    below, above = proof.sides
    assert below.values["ground.friction"].ball() < proof.value < above.values["ground.friction"].ball()
    assert all(side.proved for side in proof.sides)
    assert known["word_continued"] in proof.words


# ---- runners: given in any way, exactly ------------------------------------------------------------------


VALUES = {"ground.friction": 0.6, "leg.damping": 0.19}


def test_values_of_a_runner_are_exact(tmp_path):
    """Floats are the binary fractions that they are, texts and fractions what they say."""
    path = tmp_path / "runner.toml"
    path.write_text("ground.friction = 0.6\nleg.damping = 0.19\n")
    for given in (VALUES, path, tdmf_slip.Runner(VALUES), tdmf_slip.find_gait(VALUES)):
        assert gait_of(given)[1]["leg.damping"].rational == Fraction(0.19) != Fraction(19, 100)
    texts = {"ground.friction": "0.6", "hip.touchdown_angle": "40 deg", "leg.damping": Fraction(19, 100)}
    read = {name: str(value) for name, value in gait_of(texts)[1].items()}
    assert (read["ground.friction"], read["hip.touchdown_angle"]) == ("3/5", "2 pi/9")
    assert (read["leg.damping"], read["hip.stance_torque"]) == ("19/100", "1/5")


@pytest.mark.parametrize("prove", [tdmf_slip.prove, tdmf_slip.prove_attraction])
def test_what_is_no_runner_is_refused_in_a_sentence(prove):
    with pytest.raises(tdmf_slip.InputError, match=r"3 is not allowed; allowed: a Runner or Gait"):
        prove(3)
    with pytest.raises(tdmf_slip.InputError, match="neither a preset"):
        prove("nobody")


def test_what_the_enclosures_do_not_know_of_is_refused():
    known = NAMES_ON_PAGE.keys() & set(MOVING)
    starts = {name: tdmf_slip.load_fmu().variables.start_of(name) for name in MOVING}
    check_laws(starts | dict.fromkeys(known, 0.123))
    assert set(MOVING) - known == {f"ground.patch_{of}" for of in ("begin", "end", "friction")}
    for name in set(MOVING) - known:
        with pytest.raises(InputError, match=name):
            check_laws(starts | {name: starts[name] + 1.0})
