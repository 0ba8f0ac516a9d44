"""Branches of gaits: what happens on them is located, judged by its eigenvalues, and never passed over."""

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from tdmf_slip import InputError, RunError, Runner, find_gait
from tdmf_slip.analysis.branch_problem import BranchProblem, gaits_over
from tdmf_slip.analysis.branches import trace
from tdmf_slip.analysis.special_points import SHORTEST, special_points
from tdmf_slip.variables.parameters import read_parameters
from tdmf_slip.variables.table import FRICTION

FAST_HUMAN = Path(__file__).with_name("fast_human.toml")
ANGLE = "hip.touchdown_angle"
KINDS = {"fold", "period doubling", "Neimark-Sacker", "word border", "unclassified"}
UNSTABLE_APEX = [14.1, 0.219, 1.004, 10.41, 0.0, 0.214]
"""An unstable gait is near, at a touchdown angle of 0.725, beyond the fold at 0.915."""


@pytest.fixture(scope="module")
def runner():
    return Runner({})


@pytest.fixture(scope="module")
def human():
    return Runner(read_parameters(FAST_HUMAN))


def kinds(branch):
    return [special.kind for special in branch.specials if special.kind != "word border"]


def special_points_met(branch):
    """How often the number of unstable eigenvalues changes or the branch turns: at special points."""
    specials = [special for special in branch.specials if special.kind != "word border"]
    changes = 0
    for (before, low), (after, high) in pairwise(zip(branch.gaits, branch.values, strict=True)):
        if before.unstable != after.unstable:
            slack = 0.5 * abs(high - low) + 1e-3 * abs(high)  # a fold lies beyond both
            assert any(min(low, high) - slack <= s.value <= max(low, high) + slack for s in specials)
            changes += 1
    turns = np.count_nonzero(np.diff(np.sign(np.diff(branch.values))))
    assert turns <= len(specials)
    return changes + turns


def assert_judged_rightly(special):
    """The eigenvalues at the point are asked, whoever located it."""
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
    assert bool(special.words) or special.kind != "word border"


def test_two_real_eigenvalues_that_meet_are_no_neimark_sacker_point(runner):
    """Outside the unit circle they become a complex pair: the number of unstable ones stays."""
    first = find_gait(runner.replace({ANGLE: 0.725}), guess=UNSTABLE_APEX)
    branch = trace(runner, ANGLE, first, 0.7, max_step=0.1)
    complex_pairs = [abs(gait.eigenvalues[0].imag) > 1e-3 for gait in branch.gaits]
    assert not complex_pairs[0] and complex_pairs[-1] and branch.gaits[-1].unstable == 2
    assert kinds(branch) == ["fold"]


@pytest.mark.parametrize(
    ("name", "end", "most"), [("leg.stiffness", 15000.0, 40), ("hip.kd", 75.0, 40), ("leg.damping", 24.0, 30)]
)
def test_nothing_is_passed_over_where_gaits_are_wild(human, name, end, most):
    branch = trace(human, name, find_gait(human), end, max_step=0.1, max_points=most)
    assert special_points_met(branch) >= 1
    for special in branch.specials:
        assert_judged_rightly(special)
        low, high = sorted(special.between)
        if special.kind == "unclassified":
            assert low <= special.value <= high
            assert special.as_json()["between"] == list(special.between)


class Torn(BranchProblem):
    """Gaits between two others are not found."""

    def between(self, before, after, share):
        raise RunError("torn")


def test_what_cannot_be_located_is_told_as_not_judged(human):
    problem = BranchProblem(human, FRICTION)
    branch = trace(human, FRICTION, find_gait(human), 0.2)
    (fold,) = [special for special in branch.specials if special.kind == "fold"]
    around = branch.gaits[fold.index : fold.index + 2]
    ways = zip(around, (-1.0, 1.0), strict=True)
    start, end = (problem.start(gait, problem.towards(way)) for gait, way in ways)
    assert (start.rises, end.rises) == (False, True)
    whole = special_points(problem, start, end)
    assert "fold" in [special.kind for special in whole]
    (torn,) = special_points(Torn(human, FRICTION), start, end)
    assert torn.kind == "unclassified" and "the branch turns" in torn.why
    assert torn.between == (problem.value(start), problem.value(end)) and torn.gait is end.gait


def test_a_border_on_which_the_branch_turns_is_not_judged(human):
    """As near as gaits are told apart: no eigenvalue has to be 1 there, so that it is not called a fold."""
    problem = BranchProblem(human, FRICTION)
    start = problem.start(find_gait(human), problem.towards(-1.0))
    end = problem.correct(start.x + 0.5 * SHORTEST * start.tangent, start.tangent)
    other = replace(end, gait=replace(end.gait, word="+0-0+"), tangent=-start.tangent)
    specials = special_points(problem, start, other)
    assert [special.kind for special in specials] == ["word border", "unclassified"]
    assert specials[0].words == ("+0+", "+0-0+")
    assert "the branch turns" in specials[1].why and specials[1].gait is other.gait


def test_stability_that_changes_at_a_border_is_not_judged(human):
    """Eigenvalues may jump where a contact mode appears."""
    problem = BranchProblem(human, FRICTION)
    branch = trace(human, FRICTION, find_gait(human), 0.41)
    word = branch.gaits[0].word
    last = next(k for k, gait in enumerate(branch.gaits) if gait.word != word)
    start, end = (problem.start(o, problem.towards(-1.0)) for o in branch.gaits[last - 1 : last + 1])
    jumping = replace(end, gait=replace(end.gait, jacobian=1.2 * end.gait.jacobian))
    assert (start.gait.unstable, jumping.gait.unstable) == (0, 1)
    specials = special_points(problem, start, jumping)
    assert [special.kind for special in specials if special.kind != "word border"] == ["unclassified"]


@pytest.fixture
def looked(monkeypatch):
    """What gaits were looked for: value, guess, and the gait."""
    honest, seen = BranchProblem.correct, []

    def remembered(self, goal, across, near=None):
        found = honest(self, goal, across, near)
        seen.append((self.value(found), goal[:-1] * self.scales[:-1], found.gait))
        return found

    monkeypatch.setattr(BranchProblem, "correct", remembered)
    return seen


def test_gaits_are_followed_up_to_where_they_end(human, looked):
    """The fold at 0.3836 is met from above to 1e-6."""
    found = []
    with pytest.raises(RunError):
        found.extend(gaits_over(human, FRICTION, [0.5, 0.4, 0.3], find_gait(human)))
    assert [gait.friction for gait in found] == [0.5, 0.4]
    assert 0.0 <= min(value for value, *_ in looked) - 0.38360208 < 1e-6


def test_the_range_of_a_branch_is_checked(runner):
    first = find_gait(runner)
    for end in (first.friction, float("nan")):
        with pytest.raises(InputError, match=r"end of ground\.friction = .*allowed: a number other"):
            trace(runner, FRICTION, first, end)
    with pytest.raises(InputError, match="nosuch"):
        trace(runner, "nosuch", first, 1.0)


def test_a_branch_that_leads_to_what_is_not_allowed_keeps_its_gaits(runner):
    """A step of this length from a friction of 0.05 would pass 0."""
    first = find_gait(runner.replace({FRICTION: 0.05}), guess=find_gait(runner).apex)
    branch = trace(runner, FRICTION, first, -1.0, max_step=0.3, max_points=15)
    assert len(branch.gaits) == 15 and 0.0 < min(branch.values) < 0.01
