"""Branches of gaits: what happens on them is located, judged by its eigenvalues, and never passed over."""

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from tdmf_slip import InputError, RunError, Runner, find_gait
from tdmf_slip.analysis.branch_problem import BranchProblem, gaits_over
from tdmf_slip.analysis.branches import trace
from tdmf_slip.analysis.search import periodic_gait
from tdmf_slip.analysis.special_points import SHORTEST, Border, special_points
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


def borders(branch):
    return [Border(s.value, *s.words) for s in branch.specials if s.kind == "word border"]


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


def test_a_branch_is_followed_past_loss_of_stability(runner):
    """A leg placed steeper than the paper's: an eigenvalue passes -1, and the gait goes on unstable."""
    first = find_gait(runner)
    branch = trace(runner, ANGLE, first, 0.54, max_step=0.1)
    assert branch.ended == "end of the range"
    assert all(gait.error < 1e-11 for gait in branch.gaits)
    (doubling,) = [special for special in branch.specials if special.kind != "word border"]
    assert doubling.kind == "period doubling"
    assert_judged_rightly(doubling)
    assert doubling.value == pytest.approx(doubling.gait.runner[ANGLE], abs=0.0)
    before = [
        gait.stable for gait, at in zip(branch.gaits, branch.values, strict=True) if at > doubling.value
    ]
    assert all(before) and not branch.gaits[-1].stable and branch.values[-1] == 0.54
    assert doubling.as_json() == {"kind": "period doubling", "value": doubling.value}


def test_a_branch_turns_at_a_fold(runner):
    """The leg cannot be put forward at will: two gaits meet, where an eigenvalue is 1, and none is beyond."""
    branch = trace(runner, ANGLE, find_gait(runner), 1.2, max_step=0.1, max_points=120)
    (fold,) = [special for special in branch.specials if special.kind == "fold"]
    assert_judged_rightly(fold)
    assert max(branch.values) <= fold.value + 1e-9
    assert branch.gaits[0].stable and not branch.gaits[-1].stable
    assert special_points_met(branch) >= 2


def test_a_fold_beside_word_borders_is_found(human):
    """In one step of the branch the word changes and the parameter turns back: the fold is told as well."""
    branch = trace(human, FRICTION, find_gait(human), 0.2)
    assert kinds(branch) == ["fold"]
    assert special_points_met(branch) >= 1
    assert branch.gaits[0].stable and not branch.gaits[-1].stable
    assert branch.ended == "back at ground.friction = 0.6"
    words = [branch.gaits[0].word, *(border.after for border in borders(branch))]
    assert [border.before for border in borders(branch)] == words[:-1] and words[-1] == branch.gaits[-1].word
    (fold,) = [special for special in branch.specials if special.kind == "fold"]
    assert_judged_rightly(fold)
    assert fold.value == pytest.approx(0.3836020818, abs=1e-9) and fold.value < min(branch.values)
    assert branch.began == "beginning of the range" and branch.values[-1] == 0.6
    assert sum(not gait.stable for gait in branch.gaits) >= 9
    direction = np.linalg.svd(fold.gait.jacobian - np.eye(6))[2][-1]
    here = human.replace({FRICTION: fold.value + 1e-6})
    sides = [find_gait(here, guess=fold.gait.apex + s * direction) for s in (-1e-2, 1e-2)]
    assert sides[0].stable != sides[1].stable
    with pytest.raises(RunError):
        find_gait(human.replace({FRICTION: fold.value - 1e-6}), guess=fold.gait.apex)


def test_two_real_eigenvalues_that_meet_are_no_neimark_sacker_point(runner):
    """Outside the unit circle they become a complex pair: the number of unstable ones stays."""
    first = find_gait(runner.replace({ANGLE: 0.725}), guess=UNSTABLE_APEX)
    branch = trace(runner, ANGLE, first, 0.7, max_step=0.1)
    complex_pairs = [abs(gait.eigenvalues[0].imag) > 1e-3 for gait in branch.gaits]
    assert not complex_pairs[0] and complex_pairs[-1] and branch.gaits[-1].unstable == 2
    assert kinds(branch) == ["fold"]


def test_a_complex_pair_that_crosses_the_unit_circle_is_one(runner):
    """It lies on the same branch, farther on."""
    first = find_gait(runner.replace({ANGLE: 0.725}), guess=UNSTABLE_APEX)
    branch = trace(runner, ANGLE, first, 0.7, max_step=0.1)
    back = trace(runner, ANGLE, branch.gaits[-1], 0.755, max_step=0.1)
    assert kinds(back) == ["Neimark-Sacker"]
    assert [gait.unstable for gait in (back.gaits[0], back.gaits[-1])] == [2, 0]
    assert_judged_rightly(next(special for special in back.specials if special.kind == "Neimark-Sacker"))


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


@pytest.mark.parametrize(
    ("preset", "name", "end"),
    [
        ({}, "hip.stance_torque", 0.3),
        ({}, "leg.damping", 0.4),
        ({}, "leg.damping", 0.06),
        (FAST_HUMAN, FRICTION, 0.2),
    ],
)
def test_a_border_is_where_the_word_changes(preset, name, end):
    """To 3e-10 of the parameter, also where a duration ends as a square root does; seen by words alone."""
    runner = Runner(read_parameters(preset) if preset else preset)
    branch = trace(runner, name, find_gait(runner), end, max_step=0.1)
    met = [special for special in branch.specials if special.kind == "word border"]
    assert len(met) == len(borders(branch)) >= 2
    for border, special in zip(borders(branch), met, strict=True):
        words = {
            find_gait(runner.replace({name: border.value * (1.0 + off)}), guess=special.gait.apex).word
            for off in (-3e-10, 3e-10)
        }
        assert words == {border.before, border.after}
        assert special.gait.word == border.after and special.value == border.value


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


def test_the_first_step_is_predicted_along_the_right_parameter(runner):
    """Whatever the first gait was differentiated by."""
    firsts = [find_gait(runner), *(periodic_gait(runner, along=name) for name in (FRICTION, "leg.damping"))]
    found = [next(gaits_over(runner, "leg.damping", [0.3], first)) for first in firsts]
    assert [gait.along for gait in found] == ["leg.damping"] * 3
    for gait in found[1:]:
        np.testing.assert_array_equal(gait.apex, found[0].apex)


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


def test_gaits_are_predicted_along_the_branch(runner, looked):
    """The guess is off by the square of the step."""
    first = periodic_gait(runner, along="leg.damping")
    list(gaits_over(runner, "leg.damping", [0.202, 0.204], first))
    for _, guess, gait in looked:
        assert np.max(np.abs(guess - gait.apex)) < 1e-4
    assert np.max(np.abs(looked[0][2].apex - first.apex)) > 1e-3


def test_steps_that_had_to_be_short_grow_again(runner, monkeypatch):
    honest, values = BranchProblem.correct, []

    def hard_at_first(self, goal, across, near=None):
        (value,) = self.values(goal)
        if len(values) == 0 and abs(value - 0.2) > 0.0101:
            raise RunError("too far")
        values.append(value)
        return honest(self, goal, across, near)

    first = periodic_gait(runner, along="leg.damping")
    monkeypatch.setattr(BranchProblem, "correct", hard_at_first)
    (last,) = gaits_over(runner, "leg.damping", [0.36], first)
    assert values == pytest.approx([0.21, 0.23, 0.27, 0.35, 0.36])
    assert last.runner["leg.damping"] == 0.36


def test_gaits_are_followed_up_to_where_they_end(human, looked):
    """The fold at 0.3836 is met from above to 1e-6."""
    found = []
    with pytest.raises(RunError):
        found.extend(gaits_over(human, FRICTION, [0.5, 0.4, 0.3], find_gait(human)))
    assert [gait.friction for gait in found] == [0.5, 0.4]
    assert 0.0 <= min(value for value, *_ in looked) - 0.38360208 < 1e-6


def test_each_gait_is_told_as_it_is_found(runner):
    steps = []
    first = find_gait(runner)
    found = list(gaits_over(runner, FRICTION, [0.7, 0.8], first, lambda: steps.append("value")))
    branch = trace(runner, FRICTION, first, 0.7, step_finished=lambda: steps.append("point"))
    assert steps == ["value"] * len(found) + ["point"] * (len(branch.gaits) - 1)
    assert np.max(np.diff(branch.values)) / 0.6 <= 0.05


def test_the_range_of_a_branch_is_checked(runner):
    first = find_gait(runner)
    for end in (first.friction, float("nan")):
        with pytest.raises(InputError, match=r"ground\.friction: allowed"):
            trace(runner, FRICTION, first, end)
    with pytest.raises(InputError, match="nosuch"):
        trace(runner, "nosuch", first, 1.0)


def test_a_branch_that_leads_to_what_is_not_allowed_keeps_its_gaits(runner):
    """A step of this length from a friction of 0.05 would pass 0."""
    first = find_gait(runner.replace({FRICTION: 0.05}), guess=find_gait(runner).apex)
    branch = trace(runner, FRICTION, first, -1.0, max_step=0.3, max_points=15)
    assert len(branch.gaits) == 15 and 0.0 < min(branch.values) < 0.01
