"""Whose gait is proved may be given in every way that other functions take; exactly, where it can be."""

from fractions import Fraction

import pandas
import pytest
import tdmf_slip
from tdmf_slip.proof.given import gait_of, runner_of

VALUES = {"ground.friction": 0.6, "leg.damping": 0.19}


def ways(tmp_path):
    """The same runner, in each way."""
    path = tmp_path / "runner.toml"
    path.write_text("ground.friction = 0.6\nleg.damping = 0.19\n")
    return {
        "mapping": VALUES,
        "Series": pandas.Series(VALUES),
        "file": path,
        "its name": str(path),
        "Runner": tdmf_slip.Runner(VALUES),
        "Gait": tdmf_slip.find_gait(VALUES),
    }


def test_every_way_gives_the_same_gait_and_the_same_exact_values(tmp_path):
    found = {name: gait_of(given) for name, given in ways(tmp_path).items()}
    wanted, values = found["mapping"]
    assert values["leg.damping"].rational == Fraction(0.19) != Fraction(19, 100)
    for name, (gait, exact) in found.items():
        assert gait.apex == pytest.approx(wanted.apex, abs=1e-12), name
        assert exact["leg.damping"] == values["leg.damping"], name
    runner, given = runner_of({"leg.damping": Fraction(19, 100), "hip.touchdown_angle": "40 deg"})
    assert runner["leg.damping"] == pytest.approx(0.19, rel=1e-15)
    assert given["leg.damping"] == Fraction(19, 100)


def test_the_gait_of_a_preset_is_that_of_its_runner():
    assert gait_of("human")[0].runner == tdmf_slip.Runner("human")


@pytest.mark.parametrize("prove", [tdmf_slip.prove, tdmf_slip.prove_attraction])
def test_what_is_no_runner_is_refused_in_a_sentence(prove):
    with pytest.raises(tdmf_slip.InputError, match=r"3 is not allowed; allowed: a Runner or Gait"):
        prove(3)
    with pytest.raises(tdmf_slip.InputError, match="neither a preset"):
        prove("nobody")
