"""What this project says of its own: every claim has a command; those of gaits alone are recomputed."""

import click
import pytest
from conftest import release
from tdmf_slip.cli.main import commands
from tdmf_slip.fitting.measurements import shipped_names
from tdmf_slip.fmu.parameters import preset_names
from tdmf_slip.paper.own_claims import CLAIMS, own_claims

SOLVED = [claim for claim in CLAIMS if "tdmf-slip gait" in claim.command]


@pytest.mark.parametrize("claim", SOLVED, ids=lambda claim: claim.what.strip())
def test_a_claim_of_a_gait_holds(claim):
    assert claim.low <= claim.compute(1) <= claim.high


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: claim.what.strip())
def test_its_command_is_one(claim):
    """It parses: every option is known and has a value, and every file that it names is there."""
    name, *arguments = claim.command.replace("{seed}", "3").removeprefix("tdmf-slip ").split()
    command = commands.get_command(click.Context(commands), name)
    assert command is not None
    given = command.make_context(name, arguments).params
    assert given.get("parameters") in (None, *preset_names(), *shipped_names())


def test_each_claim_that_compares_has_its_control_beside_it():
    controls = [claim for claim in CLAIMS if claim.what.startswith("  ")]
    assert len(controls) >= 6 and not CLAIMS[0].what.startswith("  ")


def test_what_is_not_computed_is_not_said_to_hold():
    found = own_claims()
    assert found.passed and all(claim.holds is None for claim in found.claims)
    said = found.as_text(".venv/bin/tdmf-slip")
    assert ".venv/bin/tdmf-slip validate --long computes all of them" in said
    assert "verdict" not in said and said.count("  .venv/bin/tdmf-slip ") == len(CLAIMS)


@release
@pytest.mark.parametrize("seed", [1, 20])
def test_all_of_them_hold(seed):
    found = own_claims(recompute=True, seed=seed)
    assert [claim.what for claim in found.claims if not claim.holds] == []
