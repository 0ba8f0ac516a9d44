"""Solvers against proved enclosures, and what the page on accuracy says of them."""

import json
from dataclasses import replace

import pytest
import tdmf_slip
from conftest import some_of

pytest.importorskip("flint")

from tdmf_slip.errors import InputError
from tdmf_slip.proof.accuracy import QUANTITIES, error_table, solver_errors

EXACT, BY_CVODE = 1e-12, 1e-7
"""As the page on accuracy says."""


@pytest.fixture(scope="module", params=some_of(["0.2", "0.6"], 1))
def proof(request):
    return tdmf_slip.prove({"ground.friction": request.param}, digits=15)


def test_every_solver_is_as_near_to_the_proved_gait_as_is_told(proof):
    errors = solver_errors(proof)
    assert {"native", "lanes, two lanes"} < set(errors)
    assert sum("unit" in solver for solver in errors) == 3
    assert sum("CVODE" in solver for solver in errors) == 2
    for solver, of in errors.items():
        assert set(of) == {*QUANTITIES, "apex"}
        for name, error in of.items():
            assert 0 < error < (BY_CVODE if "CVODE" in solver else EXACT), (solver, name)


def test_the_table_has_the_largest_error_of_each_solver(proof):
    heading, *rows = error_table([proof])
    assert heading == ["solver", *QUANTITIES, "apex"]
    errors = solver_errors(proof)
    assert [row[0] for row in rows] == list(errors)
    native = dict(zip(heading, rows[0], strict=True))
    assert native["period"] == f"{errors['native']['period']:.1e}"


def test_what_is_undecided_is_no_measure(proof):
    with pytest.raises(InputError, match="undecided"):
        solver_errors(replace(proof, proved=False))


def test_the_command_compares():
    from click.testing import CliRunner
    from tdmf_slip.cli.prove import prove_command

    options = ["--friction", "10", "--digits", "13", "--compare"]
    ran = CliRunner().invoke(prove_command, [*options, "--json"], standalone_mode=False)
    assert json.loads(ran.stdout)["solvers"]["native"]["period"] < EXACT
    ran = CliRunner().invoke(
        prove_command, [*options, "--vary", "ground.friction=1:2"], standalone_mode=False
    )
    assert isinstance(ran.exception, InputError)
