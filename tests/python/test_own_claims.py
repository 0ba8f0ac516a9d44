"""Claims of this project: their commands parse, stored values bear them out, the page shows stored values."""

import math
import os
from pathlib import Path

import click
import pytest
from conftest import release, some_of
from tdmf_slip.cli.main import commands
from tdmf_slip.errors import RunError
from tdmf_slip.paper import results_page
from tdmf_slip.paper.statements.claim import DEFAULT, REGIMES, Estimate, OwnClaim, Row, solved
from tdmf_slip.paper.statements.own_claims import LAST_SEED, SECTIONS, Recomputed, own_claims, text_of
from tdmf_slip.variables.parameters import preset_names

DOCUMENTATION = Path(__file__).parents[2] / "documentation"
FOLDER = DOCUMENTATION / "data" / "results"
CLAIMS = [claim for claims in SECTIONS.values() for claim in claims]
SOLVED = [claim for claim in CLAIMS if "tdmf-slip gait" in claim.command]
PAGE = (DOCUMENTATION / "results.md").read_text(encoding="utf-8")


def name_of(claim):
    return claim.name


def stored_claims(section, seed):
    """Claims of a section with their stored values for a seed."""
    return results_page.recomputed(section, results_page.read(FOLDER, section), seed)


@pytest.mark.parametrize("section", SECTIONS)
@pytest.mark.parametrize("seed", results_page.SEEDS)
def test_every_claim_holds_of_the_stored_values(section, seed):
    found = stored_claims(section, seed)
    assert [one.claim.name for one in found if not one.holds] == []
    assert all(list(one.rows) == [regime.name for regime in REGIMES] for one in found)


def test_the_page_has_the_stored_values_and_a_table_of_every_section():
    assert results_page.filled(PAGE, FOLDER) == PAGE
    tables = [match[2] for match in results_page.TABLE.finditer(PAGE)]
    assert sorted(tables) == sorted([*SECTIONS, *results_page.PAPER_TABLES])


@pytest.mark.parametrize("claim", CLAIMS, ids=name_of)
def test_its_command_is_one(claim):
    """The command parses: all options are known and have values, and all files that it names exist."""
    name, *arguments = claim.command.replace("{seed}", "3").removeprefix("tdmf-slip ").split()
    command = commands.get_command(click.Context(commands), name)
    assert command is not None
    given = command.make_context(name, arguments).params
    assert given.get("parameters") in (None, *preset_names())


@pytest.mark.parametrize("claim", some_of(SOLVED, 4), ids=name_of)
def test_stored_values_of_single_gaits_are_computed_again(claim):
    section = next(name for name, claims in SECTIONS.items() if claim in claims)
    stored = stored_claims(section, 1)
    rows = next(one.rows for one in stored if one.claim is claim)
    for regime in REGIMES:
        compare(claim.row(regime, 1), rows[regime.name])


def compare(row, stored):
    """Numbers without chance are equal; intervals of estimates overlap, as processors round differently."""
    for now, then in ((row.value, stored.value), (row.control, stored.control)):
        if not isinstance(then, Estimate):
            assert now == then
        elif then.low == then.high:
            assert now.value == pytest.approx(then.value, rel=1e-6)
        else:
            assert now.low <= then.high and then.low <= now.high


def one_claim(measure):
    return OwnClaim("name", "two", "tdmf-slip gait --seed {seed}", ["1 < value < 3: default"], measure)


def test_a_claim_that_needs_a_missing_number_does_not_hold():
    def fails(regime):
        raise RunError("unstable")

    for measure, holds, cell in ((lambda regime: 2.0, True, "2"), (fails, False, "unstable")):
        claim = one_claim(solved(measure))
        row = claim.row(DEFAULT, 1)
        assert str(row) == cell
        found = Recomputed(claim, 7, {regime.name: row for regime in REGIMES})
        assert found.holds is holds
        text = text_of([found], ".venv/bin/tdmf-slip")
        assert ("DOES NOT HOLD" in text) is not holds and ".venv/bin/tdmf-slip gait --seed 7" in text
        assert text.count(cell) >= len(REGIMES)
        assert Recomputed.of_json(claim, 7, found.as_json()).rows == found.rows


def test_an_estimate_shows_its_interval_or_a_bound_where_no_runner_fell():
    assert str(Estimate(12.34, 10.0, 15.06)) == "12.3 (10 to 15.1)"
    assert str(Estimate(float("inf"), 12345.6, float("inf"))) == "> 12,346"
    assert str(Row(Estimate.exact(0.25), "no gait")) == "0.25 / no gait"


def test_a_row_is_above_its_control_where_the_intervals_are_apart():
    higher, lower, between = Estimate(3.0, 2.5, 3.5), Estimate(2.0, 1.5, 2.4), Estimate(2.4, 2.0, 2.6)
    above, below = "value > control", "value < control"
    assert Row(higher, lower).meets(above) and Row(lower, higher).meets(below)
    assert Row(higher, lower).meets("1.4 < value / control < 1.6")
    assert not Row(higher, between).meets(above) and not Row(between, higher).meets(below)
    nan = Estimate.exact(math.nan)
    for row in (
        Row("no gait", lower),
        Row(lower, "no gait"),
        Row(lower, None),
        Row(nan, lower),
        Row(lower, nan),
    ):
        assert not row.meets(above) and not row.meets(f"not {above}")


@pytest.mark.parametrize("name", some_of(["feedback-matched", "attraction"], 1))
def test_the_largest_seed_suits_the_claims_that_draw_from_its_multiples(name):
    (claim,) = (claim for claim in CLAIMS if claim.name == name)
    row = claim.row(DEFAULT, LAST_SEED)
    assert isinstance(row.value, Estimate) and isinstance(row.control, Estimate)


@release
@pytest.mark.parametrize("section", SECTIONS)
def test_every_claim_computed_again_holds(section):
    seed = int(os.environ.get("TDMF_SLIP_SEED", "1"))
    found = own_claims(sections=[section], seed=seed)
    stored = stored_claims(section, seed)
    for one, then in zip(found, stored, strict=True):
        assert one.holds, one.claim.name
        for regime in REGIMES:
            compare(one.rows[regime.name], then.rows[regime.name])


def test_names_are_unique():
    assert len({claim.name for claim in CLAIMS}) == len(CLAIMS)
