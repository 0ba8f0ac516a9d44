"""Branches of gaits: special points are located, classified by eigenvalues, and never passed over."""

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from branch_rows import met, rows_of, specials
from conftest import some_of
from tdmf_slip import RunError, Runner, continue_branch, find_gait
from tdmf_slip.analysis.along import gaits_over
from tdmf_slip.analysis.gait_problem import BranchProblem
from tdmf_slip.variables.parameters import read_parameters
from tdmf_slip.variables.table import FRICTION

FAST_HUMAN = Path(__file__).with_name("fast_human.toml")
KINDS = {"fold", "period doubling", "Neimark-Sacker", "word border", "unclassified"}


@pytest.fixture(scope="module")
def human():
    return Runner(read_parameters(FAST_HUMAN))


def special_points_met(rows):
    """Number of changes of the unstable eigenvalues and turns of the branch, all at special points."""
    found = [special for special in specials(rows) if special.kind != "word border"]
    changes = 0
    for before, after in pairwise(met(rows)):
        low, high = sorted((before.value, after.value))
        if before.gait.unstable != after.gait.unstable:
            slack = 0.5 * (high - low) + 1e-3 * abs(after.value)  # a fold lies beyond both
            assert any(low - slack <= special.value <= high + slack for special in found)
            changes += 1
    turns = np.count_nonzero(np.diff(np.sign(np.diff([row.value for row in met(rows)]))))
    assert turns <= len(found)
    return changes + turns


def assert_classified_rightly(special):
    """The eigenvalues at the point are those of its kind."""
    values = special.gait.eigenvalues
    if special.kind == "fold":
        assert np.min(np.abs(values - 1.0)) < 1e-7
    elif special.kind == "period doubling":
        assert np.min(np.abs(values + 1.0)) < 1e-8
    elif special.kind == "Neimark-Sacker":
        pair = values[np.argmin(np.abs(np.abs(values) - 1.0))]
        assert abs(abs(pair) - 1.0) < 1e-8 and abs(pair.imag) > 1e-3
    assert special.kind in KINDS
    assert (special.kind == "unclassified") == bool(special.why)
    assert all(special.words) or special.kind != "word border"


@pytest.mark.parametrize(
    ("name", "end", "most"),
    some_of([("leg.stiffness", 15000.0, 40), ("hip.kd", 75.0, 40), ("leg.damping", 24.0, 30)], 1),
)
def test_no_special_point_is_passed_over_where_gaits_are_wild(human, name, end, most):
    rows = rows_of(
        continue_branch(
            find_gait(human), {name: (human[name], end)}, max_step=0.1, max_points=most, switch=False
        )
    )
    assert special_points_met(rows) >= 1
    for special in specials(rows):
        assert_classified_rightly(special)
        low, high = sorted(special.between)
        assert special.kind != "unclassified" or low <= special.value <= high


def test_gaits_are_followed_up_to_where_they_end(human, monkeypatch):
    """The fold at 0.3836 is met from above to 1e-6."""
    honest, seen, found = BranchProblem.correct, [], []

    def remembered(self, goal, across, near=None):
        point = honest(self, goal, across, near)
        seen.append(self.value(point))
        return point

    monkeypatch.setattr(BranchProblem, "correct", remembered)
    with pytest.raises(RunError):
        found.extend(gaits_over(human, FRICTION, [0.5, 0.4, 0.3], find_gait(human)))
    assert [gait.friction for gait in found] == [0.5, 0.4]
    assert 0.0 <= min(seen) - 0.38360208 < 1e-6


def test_values_that_differ_by_rounding_are_of_one_branch():
    runner, name = Runner("human"), "leg.stiffness"
    gait = find_gait(runner)
    values = [runner[name] * (1.0 + 2.0**-power) for power in (52, 50, 40, 30)]
    found = list(gaits_over(runner, name, values, gait))
    assert [other.runner[name] for other in found] == values
    assert all(np.allclose(other.apex, gait.apex, rtol=1e-6, atol=1e-6) for other in found)
