"""What a branch's eigenvalues say: made branches, of which it is known what happens where."""

from dataclasses import replace

import numpy as np
import pytest
from tdmf_slip import Runner, find_gait
from tdmf_slip.analysis.branch_problem import BranchProblem
from tdmf_slip.analysis.special_points import special_points
from tdmf_slip.numerics.following import Point

NAME = "leg.damping"


@pytest.fixture(scope="module")
def gait():
    return find_gait(Runner({}))


class Made(BranchProblem):
    """A branch by its arclength s: eigenvalues, the parameter's value, and the word."""

    def __init__(self, gait, eigenvalues, value=lambda s: s, word=lambda s: "+0+"):
        self.gait, self.eigenvalues, self.at, self.word = gait, eigenvalues, value, word
        self.names, self.scales = (NAME,), np.ones(7)

    def made(self, s, along=1.0):
        jacobian = np.zeros((6, 6))
        for number, entry in enumerate(self.eigenvalues(s)):
            jacobian[2 * number : 2 * number + 2, 2 * number : 2 * number + 2] = entry
        value = float(self.at(s))
        gait = replace(
            self.gait,
            runner=self.gait.runner.replace({NAME: value}),
            apex=np.array([s, 0, 0, 0, 0, 0]),
            jacobian=jacobian,
            word=self.word(s),
        )
        slope = (self.at(s + 1e-7) - self.at(s - 1e-7)) / 2e-7
        direction = np.array([1.0, 0, 0, 0, 0, 0, slope]) / np.hypot(1.0, slope)
        return Point(np.append(gait.apex, value), along * direction, gait, np.empty((6, 7)))

    def point(self, x, along):
        return self.made(x[0], 1.0 if along[0] > 0.0 else -1.0)

    def look(self, begin, end, across, _rows):
        found = self.correct(0.5 * (begin + end), across)
        return found.x, found.gait.word

    def correct(self, goal, normal, _near=None):
        """Halves the way through the plane until the point is found."""
        low, high = goal[0] - 0.3, goal[0] + 0.3

        def beyond(s):
            return (s - goal[0]) * normal[0] + (self.at(s) - goal[-1]) * normal[-1] > 0.0

        at_high = beyond(high)
        assert beyond(low) != at_high
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (low, middle) if beyond(middle) == at_high else (middle, high)
        return self.made(high, 1.0 if normal[0] > 0.0 else -1.0)

    def reported(self, low=0.5, high=1.5):
        specials = special_points(self, self.made(low), self.made(high))
        return [(special.kind, pytest.approx(special.value, abs=2e-6)) for special in specials]


def real(first, second=0.0):
    return np.diag([first, second])


def pair(radius, angle=1.0):
    return radius * np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


def test_located_where_it_is(gait):
    """However curved the way there is."""
    found = special_points(made := Made(gait, lambda s: [real(-(s**9))]), made.made(0.5), made.made(1.5))
    assert [special.kind for special in found] == ["period doubling"]
    assert found[0].value == pytest.approx(1.0, abs=1e-10)
    assert found[0].between == (0.5, 1.5) and found[0].gait.runner[NAME] == found[0].value


@pytest.mark.parametrize(
    "eigenvalues",
    [
        lambda s: [
            real(2.0 * s + 0.5, 0.4)
        ],  # a neutral saddle: the product passes 1, no eigenvalue the circle
        lambda s: [real(1.2 + max(0.0, 1.0 - s), 1.2)] if s < 1.0 else [pair(1.2, s - 1.0)],
        lambda s: [real(2.0 * s + 0.5, 0.4), real(1.0 - 1e-7)],
        lambda s: [real(0.5 * s, -0.3)],
    ],
)
def test_nothing_is_told_where_none_passes_the_unit_circle(gait, eigenvalues):
    assert Made(gait, eigenvalues).reported() == []


def test_what_happens_within_one_step_is_told_apart(gait):
    two = Made(gait, lambda s: [real(-s, -s - 0.05)])
    assert two.reported() == [("period doubling", 0.95), ("period doubling", 1.0)]
    mixed = Made(gait, lambda s: [pair(s + 0.2), real(-s - 0.03), real(0.1)])
    assert mixed.reported() == [("Neimark-Sacker", 0.8), ("period doubling", 0.97)]
    turning = Made(gait, lambda s: [real(s - 0.03), real(-s - 0.07)], value=lambda s: 2.0 - (s - 1.03) ** 2)
    assert turning.reported() == [("period doubling", 1.99), ("fold", 2.0)]


@pytest.mark.parametrize(
    "eigenvalues",
    [
        lambda s: [real(0.9 if s < 1.0 else 1.1)],  # jumps
        lambda s: [pair(0.9 if s < 1.0 else 1.1)],
        lambda s: [pair(0.9) if s < 1.0 else real(1.1, 1.2)],
        lambda s: [real(s)],  # passes +1, but the branch goes on: two branches cross
        lambda s: [real(-s - 1e-7, -s - 1e-7)],  # two at once
        lambda s: [pair(s + 1e-7), real(-s - 1e-7)],
    ],
)
def test_what_is_none_of_them_is_not_judged(gait, eigenvalues):
    assert Made(gait, eigenvalues).reported() == [("unclassified", 1.0)]


def test_a_turn_without_an_eigenvalue_of_one_is_not_judged(gait):
    made = Made(gait, lambda s: [real(0.5)], value=lambda s: 2.0 - (s - 1.0) ** 2)
    assert made.reported() == [("unclassified", 2.0)]


def test_a_branch_that_cannot_be_parted_is_not_judged(gait):
    """Newton's method may come back to the same gait again and again."""
    made = Made(gait, lambda s: [real(-s, -s - 0.05)])
    made.between = lambda before, after, share: after
    (special,) = special_points(made, made.made(0.5), made.made(1.5))
    assert (special.kind, special.between) == ("unclassified", (0.5, 1.5))
    assert special.why == "0 eigenvalues outside the unit circle become 2"
    assert special.as_json() == {
        "kind": "unclassified",
        "value": 1.0,
        "between": [0.5, 1.5],
        "why": special.why,
    }
