"""Branches of maps whose special points are known in closed form, by the functions that serve gaits."""

import numpy as np
import pytest
from closed_form_maps import (
    MapProblem,
    collision,
    delayed_logistic,
    falling,
    henon,
    linear,
    logistic,
    ring,
    swapping_ring,
    tent,
    torn,
    two_sheets,
)
from tdmf_slip import RunError
from tdmf_slip.analysis.along import to_value
from tdmf_slip.analysis.branches import whole_branch, with_doubled_branches
from tdmf_slip.analysis.special_points import special_points
from tdmf_slip.numerics.following import Limits, Track, follow


def between(low, high, begin, max_step=0.1, max_points=400):
    return Limits(np.array([low]), np.array([high]), max_step, max_points, begin)


def followed(problem, first, low, high, max_step=0.1, max_points=400):
    limits = between(low, high, problem.value(first), max_step, max_points)
    return whole_branch(problem, first, limits), limits


def specials_in(branch):
    return [row.special for row in branch.rows if row.special]


def met(branch):
    """Values and gaits in the branch's order, without special points."""
    return zip(*((row.value, row.gait) for row in branch.rows if not row.special), strict=True)


def specials_of(branch):
    return [(special.kind, pytest.approx(special.value, abs=1e-9)) for special in specials_in(branch)]


def test_the_logistic_map_doubles_its_period_at_3():
    problem = MapProblem(logistic, 1)
    branch, _ = followed(problem, problem.beginning(1.5, 1 / 3), 1.5, 3.8)
    assert specials_of(branch) == [("period doubling", 3.0)] and branch.ended == "end of the range"
    assert branch.rows[-1].value == 3.8
    for value, gait, special in branch.rows:
        assert gait.apex[0] == pytest.approx(1 - 1 / value, abs=1e-9 if special else 1e-12)


def logistic_period(r, longest=16):
    """The period is that of what plain iterates settle on."""
    x = 0.4
    for _ in range(200_000):
        x = r * x * (1.0 - x)
    orbit = [x]
    for _ in range(longest):
        orbit.append(r * orbit[-1] * (1.0 - orbit[-1]))
    return next(n for n in range(1, longest + 1) if abs(orbit[n] - x) < 1e-6)


def test_a_period_that_doubles_again_is_followed_and_a_third_time_is_told():
    problem = MapProblem(logistic, 1)
    branch, limits = followed(problem, problem.beginning(2.9, 0.66), 2.9, 3.56, 0.05)
    _, two, four = with_doubled_branches(branch, lambda n: MapProblem(logistic, 1, n), limits)
    assert [b.strides for b in (branch, two, four)] == [1, 2, 4]
    assert two.began.startswith("period doubling at p = 3")
    assert specials_of(two) == [("period doubling", 1 + np.sqrt(6))]
    for r, gait in zip(*met(two), strict=True):
        root = np.sqrt((r - 3) * (r + 1))
        both = sorted([gait.apex[0], gait.following[0][0]])
        assert both == pytest.approx([(r + 1 - root) / (2 * r), (r + 1 + root) / (2 * r)], abs=1e-11)
        assert gait.eigenvalues[0] == pytest.approx(4 + 2 * r - r**2, abs=1e-9)
    assert four.began.startswith("period doubling at p = 3.4494897")
    assert specials_of(four) == [("period doubling", 3.544090359551)]
    assert specials_in(four)[0].why == "gaits of 8 strides are not followed"
    orbit = [specials_in(one)[0].value for one in (branch, two, four)]
    for number, value in enumerate(orbit):
        assert [logistic_period(value + off) for off in (-3e-3, 3e-3)] == [2**number, 2 ** (number + 1)]
    compared = 0
    for r, gait in zip(*met(four), strict=True):
        x, apexes = gait.apex[0], [gait.apex, *gait.following]
        for apex in apexes:
            assert apex[0] == pytest.approx(x, abs=1e-11)
            x = r * x * (1.0 - x)
        assert x == pytest.approx(gait.apex[0], abs=1e-11)
        compared += len(apexes)
    assert compared >= 20


def test_the_henon_map_folds_and_doubles_its_period():
    """The period doubling is at 3 (1-b)^2/4 and the fold at -(1-b)^2/4; x is infinite at a = 0."""
    problem = MapProblem(henon, 2)
    branch, _ = followed(problem, problem.beginning(0.6, [0.7, 0.2], -1.0), -1.0, 0.6)
    assert specials_of(branch) == [("period doubling", 3 * 0.49 / 4), ("fold", -0.49 / 4)]
    assert branch.ended == "number of points: 400" and -0.1 < branch.rows[-1].value < 0.0
    assert (branch.rows[0].gait.unstable, branch.rows[-1].gait.unstable) == (1, 1)
    assert any(row.gait.stable for row in branch.rows)


def test_the_delayed_logistic_map_has_a_neimark_sacker_point_at_2():
    problem = MapProblem(delayed_logistic, 2)
    branch, _ = followed(problem, problem.beginning(1.5, [1 / 3, 1 / 3]), 1.5, 2.5)
    assert specials_of(branch) == [("Neimark-Sacker", 2.0)]
    values = specials_in(branch)[0].gait.eigenvalues
    assert np.abs(np.angle(values)) == pytest.approx([np.pi / 3, np.pi / 3], abs=1e-9)


def real(*values):
    return np.diag(values)


def pair(radius, angle=1.0):
    return radius * np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


def both(one, other):
    nothing = np.zeros((len(one), len(other)))
    return np.block([[one, nothing], [nothing.T, other]])


@pytest.mark.parametrize(
    ("matrix_of", "wanted"),
    [
        (lambda p: real(-(p**9), 0.2), [("period doubling", 1.0)]),
        (pair, [("Neimark-Sacker", 1.0)]),
        # Several special points within one step are distinguished.
        (lambda p: real(-p, -p - 0.05), [("period doubling", 0.95), ("period doubling", 1.0)]),
        (
            lambda p: both(pair(p + 0.2), real(-p - 0.03, 0.1)),
            [("Neimark-Sacker", 0.8), ("period doubling", 0.97)],
        ),
        # No special point without a passage of the unit circle: a neutral saddle, and two that become a pair.
        (lambda p: real(p + 1.0, 0.5), []),
        (lambda p: real(2.2 - p, 1.2) if p < 1.0 else pair(1.2, p - 1.0), []),
        (lambda p: real(0.5 * p, -0.3), []),
        # Unclassified points are kept: eigenvalues that jump, two at once, and a branch that does not turn.
        (lambda p: real(0.9 if p < 1.0 else 1.1, 0.0), [("unclassified", 1.0)]),
        (lambda p: pair(0.9 if p < 1.0 else 1.1), [("unclassified", 1.0)]),
        (lambda p: pair(0.9) if p < 1.0 else real(1.1, 1.2), [("unclassified", 1.0)]),
        (lambda p: real(-p - 1e-7, -p - 1e-7), [("unclassified", 1.0)]),
        (lambda p: both(pair(p + 1e-7), real(-p - 1e-7)), [("unclassified", 1.0)]),
    ],
)
def test_special_points_are_classified_by_the_eigenvalues(matrix_of, wanted):
    problem = MapProblem(linear(matrix_of), len(matrix_of(0.5)))
    branch, _ = followed(problem, problem.beginning(0.5, np.zeros(len(matrix_of(0.5)))), 0.5, 1.5, 0.4)
    found = specials_in(branch)
    assert [(special.kind, pytest.approx(special.value, abs=2e-6)) for special in found] == wanted
    assert all((special.kind == "unclassified") == bool(special.why) for special in found)
    assert branch.ended == "end of the range"


def test_a_branch_that_cannot_be_divided_is_unclassified(monkeypatch):
    """Newton's method may come back to the same gait again and again."""
    problem = MapProblem(linear(lambda p: real(-p, -p - 0.05)), 2)
    start, end = (problem.beginning(p, [0.0, 0.0]) for p in (0.5, 1.5))
    monkeypatch.setattr(problem, "between", lambda before, after, share: after)
    (special,) = special_points(problem, start, end)
    why = "0 eigenvalues outside the unit circle become 2"
    assert special[:2] == ("unclassified", 1.0) and special[3:5] == ((0.5, 1.5), why)


def test_a_crossing_of_two_branches_is_unclassified():
    """The logistic map's other fixed point passes 0 at r = 1."""
    problem = MapProblem(logistic, 1)
    branch, _ = followed(problem, problem.beginning(0.5, 0.0), 0.5, 1.7)
    (crossing,) = specials_in(branch)
    assert crossing.kind == "unclassified" and crossing.why
    assert min(crossing.between) - 1e-6 <= 1.0 <= max(crossing.between) + 1e-6
    assert np.ptp(crossing.between) < 1e-5


def test_a_branch_that_closes_ends_where_it_began():
    problem = MapProblem(ring, 1)
    branch, _ = followed(problem, problem.beginning(0.0, 0.9), -2.0, 2.0)
    assert specials_of(branch) == [("fold", 1.0), ("fold", -1.0)]
    assert branch.ended == branch.began == "closed: back at the gait at p = 0"
    values, gaits = met(branch)
    np.testing.assert_allclose(np.array([o.apex[0] for o in gaits]) ** 2, 1 - np.array(values) ** 2)


@pytest.mark.parametrize(
    ("left", "right", "kinds"),
    [
        (0.5, -0.5, ["word border"]),
        (0.5, 0.8, ["word border"]),
        (0.5, -1.5, ["word border", "period doubling"]),
        (-1.5, -1.2, ["word border"]),
        (0.5, 1.5, ["word border", "fold"]),
        (0.2, 1.1, ["word border", "fold"]),
        (-3.0, 6.0, ["word border", "fold", "period doubling"]),  # turns by 140 degrees
        (-8.0, 9.0, ["word border", "fold", "period doubling"]),
    ],
)
def test_a_border_collision_is_classified_by_the_maps_of_both_sides(left, right, kinds):
    """Feigin: where det(I - J) changes its sign the branch turns; where det(I + J) does, it doubles."""
    problem = MapProblem(tent(left, right), 1)
    branch, _ = followed(problem, problem.beginning(-1.0, -1.0 / (1.0 - left)), -1.0, 1.0)
    assert specials_of(branch) == [(kind, 0.0) for kind in kinds]
    assert all(special.words == ("-", "+") for special in specials_in(branch))
    assert branch.ended == ("back at p = -1" if "fold" in kinds else "end of the range")
    for value, gait in zip(*met(branch), strict=True):
        slope = left if gait.word == "-" else right
        assert gait.apex[0] == pytest.approx(value / (1.0 - slope), abs=1e-10)


@pytest.mark.parametrize(
    ("left", "right", "kinds"),
    [
        ((0.5, 0.9), (0.5, 0.5), ["word border"]),
        ((0.5, 0.9), (0.5, 1.1), ["word border", "unclassified"]),  # a pair jumps out of the unit circle
        ((0.5, 0.9), (-2.5, 0.9), ["word border", "period doubling"]),
        ((0.5, 0.9), (2.5, 0.9), ["word border", "fold"]),
        ((0.5, 1.2), (2.5, 0.9), ["word border", "fold"]),  # from two eigenvalues outside to one
    ],
)
def test_eigenvalues_that_jump_at_a_border_are_classified_or_kept(left, right, kinds):
    problem = MapProblem(collision(left, right), 2)
    branch, _ = followed(problem, problem.beginning(-1.0, [-0.5, 0.3]), -1.0, 1.0)
    assert specials_of(branch) == [(kind, 0.0) for kind in kinds]
    for special in specials_in(branch):
        assert (special.kind == "unclassified") == bool(special.why)


def test_each_reason_to_stop_has_its_own_words():
    def ended(step, begin, guess, towards, low, high, **settings):
        problem = MapProblem(step, 1, low=settings.pop("lowest", -np.inf))
        return followed(problem, problem.beginning(begin, guess, towards), low, high, **settings)[0].ended

    reasons = {
        "limit of what is allowed at p = 0.5": ended(tent(0.5, 0.5), 1.0, 2.0, -1.0, -1.0, 1.0, lowest=0.5),
        "the gait is lost at p = 0.5: just beyond, the runner fell": ended(falling, 0.0, 0.0, 1.0, 0.0, 1.0),
        "the gait is lost at p = 0.5: at the border from - to +": ended(torn, 0.0, 0.0, 1.0, 0.0, 1.0),
        "number of points: 5": ended(logistic, 1.5, 1 / 3, 1.0, 1.5, 2.5, max_points=5),
    }
    for begin, reason in reasons.items():
        assert reason.startswith(begin)


def test_a_branch_that_begins_inside_its_range_is_followed_both_ways():
    problem = MapProblem(henon, 2)
    first = problem.beginning(0.2, [0.9, 0.3], -1.0)
    branch = whole_branch(problem, first, between(-1.0, 0.6, 0.6))
    assert (branch.rows[0].value, branch.began) == (0.6, "beginning of the range")
    assert specials_of(branch) == [("period doubling", 3 * 0.49 / 4), ("fold", -0.49 / 4)]


@pytest.mark.parametrize("gap", [0.02, 0.05])
def test_a_branch_that_ends_does_not_go_on_from_another(gap):
    problem = MapProblem(two_sheets(gap), 1)
    branch, _ = followed(problem, problem.beginning(0.3, 0.6), 0.3, 0.7)
    assert branch.ended.startswith("the gait is lost at p = 0.5: at the border from - to +")
    assert {row.gait.word for row in branch.rows} == {"-"} and branch.rows[-1].value == pytest.approx(0.5)


def test_a_walk_along_a_parameter_does_not_change_the_sheet():
    problem = MapProblem(two_sheets(0.3), 1)
    with pytest.raises(RunError, match=r"the branch ends at p = 0\.(4999|5)"):
        to_value(problem, problem.beginning(0.45, 0.9), 0.55)
    last = to_value(problem, problem.beginning(0.6, 1.5), 0.4)
    assert last.gait.apex[0] == pytest.approx(1.1) and last.gait.word == "+"


def test_gaits_of_two_strides_are_met_again_by_their_other_half():
    problem = MapProblem(swapping_ring, 1, 2)
    first = problem.beginning(0.1, np.sqrt(0.99))
    points, ended = follow(problem, first, 1.0, between(-2.0, 2.0, 0.1))
    assert ended.startswith("retraced: back") and ended.endswith("begun by another of its strides")
    assert any(points[-1] is point for point in points[:-1])
    assert 0.99 < problem.value(points[-2]) <= 1.0 and points[-2].gait.apex[0] < 0.1


def test_a_branch_that_comes_back_over_itself_says_so():
    problem = MapProblem(ring, 1)
    points, _ = follow(problem, problem.beginning(0.0, 0.9), 1.0, between(-2.0, 2.0, 0.0, 0.1, 12))
    track = Track(problem, points)
    back = problem.between(points[7], points[8], 0.5).reversed()
    met, ended = track.met(points[-1], back)
    assert met in points[8:11] and ended.endswith("from the other side") and ended.startswith("retraced")
    assert not track.is_new([points[-1], back])
    further, _ = follow(problem, points[-1], 1.0, between(-2.0, 2.0, 0.0, 0.1, 5))
    assert track.is_new(further)
