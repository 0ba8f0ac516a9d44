"""The search over smooth regions, on functions with known kinks, and on the runner."""

from types import SimpleNamespace

import numpy as np
import pytest
from tdmf_slip import find_gait, optimize, sweep
from tdmf_slip.errors import RunError
from tdmf_slip.library.quantities import QUANTITIES
from tdmf_slip.optimization.border import between
from tdmf_slip.optimization.gaits import Candidate, Gaits, Space, Spectrum
from tdmf_slip.optimization.optimizer import Search
from tdmf_slip.optimization.problem import Goal, Problem

QUANTITY, SUM = "speed", "length"
"""Names of the functions below."""


def bend(at):
    """Function that is zero on a curved border, with its gradient."""
    return at[1] - 0.4 - 0.3 * (at[0] - 0.5) ** 2, np.array([-0.6 * (at[0] - 0.5), 1.0])


class Functions:
    """Substitute for gaits: a smooth function and a kink on a border, and words on either side."""

    def __init__(self, smooth, kink, radii=(0.5, 0.5), lost=lambda at: False):
        self.smooth, self.kink, self.radii, self.lost = smooth, kink, radii, lost

    def gait_from(self, near, at):
        if self.lost(at):
            raise RunError("the branch folds")
        word = "B" if bend(at)[0] > 0.0 else "A"
        runner = SimpleNamespace(scales=np.ones(1))
        return SimpleNamespace(word=word, sequence=(word,), runner=runner, apex=np.zeros(1))

    def candidate(self, gait, at):
        (value, slope), (side, normal) = self.smooth(at), bend(at)
        sign = 1.0 if gait.word == "B" else -1.0
        values = np.array([value + self.kink * sign * side, at.sum()])
        slopes = np.array([slope + self.kink * sign * normal, np.ones(2)])
        sizes = np.array([self.radii[gait.word == "B"]])
        spectrum = Spectrum(sizes, np.zeros((1, 2)), np.ones(1, dtype=bool), np.inf, np.zeros(2))
        return Candidate(at, gait, np.zeros((1, 2)), values, slopes, spectrum)

    def follow(self, near, at):
        return self.candidate(self.gait_from(near, at), at)


def valley(at):
    return (at[0] - 0.7) ** 2 + 0.5 * at[1], np.array([2.0 * (at[0] - 0.7), 0.5])


def found(functions, goal, begin):
    at = np.array(begin)
    start = functions.candidate(functions.gait_from(None, at), at)
    return Search(functions, Problem(goal, {QUANTITY: 1.0, SUM: 1.0})).run(start)


GOAL = Goal(QUANTITY, upper_limits={SUM: (1.0, 9.0)})
"""Goal for the quantity, with a limit on the sum that has no effect."""


@pytest.mark.parametrize("begin", [(0.1, 0.1), (0.9, 0.9), (0.2, 0.8), (0.673, 0.409)])
def test_an_optimum_on_a_curved_border_is_found_and_shown_by_both_sides(begin):
    """The function on the border is (x - 0.7)^2 + (0.4 + 0.3 (x - 0.5)^2)/2, with its least at 1.55/2.3."""
    optimum = found(Functions(valley, 2.0), GOAL, begin)
    smallest = 1.55 / 2.3
    assert optimum.gait.at == pytest.approx([smallest, 0.4 + 0.3 * (smallest - 0.5) ** 2], abs=1e-4)
    assert optimum.why == "" and set(optimum.remaining_improvement) == {"A", "B"}
    assert max(optimum.remaining_improvement.values()) <= 1e-4
    normal = bend(optimum.gait.at)[1]
    assert abs(optimum.border.normal @ normal) == pytest.approx(np.linalg.norm(normal), rel=1e-6)


def test_a_border_on_which_the_function_falls_to_one_side_is_passed():
    """A kink that is less steep than the function itself leaves the minimum at the lower bound."""
    optimum = found(Functions(valley, 0.2), GOAL, (0.9, 0.9))
    assert optimum.gait.at[1] < 1e-12 and optimum.border is None and optimum.why == ""
    x = optimum.gait.at[0]
    assert 2.0 * (x - 0.7) + 0.2 * 0.6 * (x - 0.5) == pytest.approx(0.0, abs=1e-4)


@pytest.mark.parametrize(("begin", "side"), [((0.5, 0.41), "B"), ((0.5, 0.39), "A")])
def test_a_ridge_is_no_optimum(begin, side):
    def flat(at):
        return 2.0 * (at[0] - 0.5) ** 2, np.array([4.0 * (at[0] - 0.5), 0.0])

    optimum = found(Functions(flat, -1.0), GOAL, begin)
    assert optimum.border is None and optimum.why == ""
    assert optimum.gait.gait.word == side
    assert optimum.gait.at[1] == pytest.approx(1.0 if side == "B" else 0.0, abs=1e-12)


@pytest.mark.parametrize("begin", [(0.1, 0.1), (0.9, 0.9)])
def test_an_equation_is_met_on_a_border_too(begin):
    """The optimum is the point at which the border meets the line x + y = 1."""
    optimum = found(Functions(valley, 2.0), Goal(QUANTITY, at={SUM: 1.0}), begin)
    x = optimum.gait.at[0]
    assert optimum.gait.at.sum() == pytest.approx(1.0, abs=1e-8)
    assert x + 0.4 + 0.3 * (x - 0.5) ** 2 == pytest.approx(1.0, abs=1e-6)
    assert optimum.why == "" and set(optimum.remaining_improvement) == {"A", "B"}


def test_where_eigenvalues_jump_the_optimum_is_that_of_the_stable_side():
    def rising(at):
        return -at[1] + (at[0] - 0.6) ** 2, np.array([2.0 * (at[0] - 0.6), -1.0])

    goal = Goal(QUANTITY, upper_limits={SUM: (1.0, 9.0)}, radius=1.0)
    optimum = found(Functions(rising, 0.1, radii=(0.9, 1.2)), goal, (0.2, 0.1))
    assert optimum.gait.gait.word == "A" and set(optimum.remaining_improvement) == {"A"} and optimum.why == ""
    x = optimum.gait.at[0]
    assert optimum.gait.at[1] == pytest.approx(bend(np.array([x, 0.0]))[0] * -1.0, abs=1e-8)
    assert 2.0 * (x - 0.6) - 0.6 * (x - 0.5) == pytest.approx(0.0, abs=1e-3)


def test_where_gaits_end_the_search_backs_off_and_says_so():
    optimum = found(Functions(valley, 0.2, lost=lambda at: at[1] < 0.2), GOAL, (0.9, 0.9))
    assert optimum.why == "the branch folds" and optimum.gait.at[1] >= 0.2


@pytest.mark.parametrize(("friction", "words"), [(0.26585, ("+-", "+0-")), (1.14414, ("+0-0+", "+0+"))])
def test_gradients_are_the_same_on_both_sides_of_borders_between_words(friction, words):
    """A slip begins and ends with velocity zero, and a new mode has no duration, so there is no kink."""
    space = Space({"ground.friction": (0.1, 2.0), "hip.touchdown_angle": (0.6, 0.8)})
    ends = [find_gait({"ground.friction": value}) for value in (0.99 * friction, 1.01 * friction)]
    gaits = Gaits(ends[0].runner, space, QUANTITIES)
    inside, outside = (gaits.candidate(gait, space.coordinates_of(gait.runner)) for gait in ends)

    class WithWord:
        def __contains__(self, sequence):
            return sequence[0] == words[0]

    border = between(gaits, inside, outside, WithWord())
    assert (border.short.gait.word, border.beyond.gait.word) == words
    assert border.is_smooth
    assert border.beyond.slopes == pytest.approx(border.short.slopes, rel=1e-5, abs=1e-6)
    borders = sweep({}, {"ground.friction": [0.99 * friction, 1.01 * friction]}).borders["ground.friction"]
    assert space.values(border.short.at)["ground.friction"] == pytest.approx(borders.item(), rel=1e-8)


def test_the_cheapest_runner_on_slippery_ground_is_at_a_border():
    """All gaits of the same speed nearby, by Newton's method on the torque, cost more."""
    angle, torque, thrust = "hip.touchdown_angle", "hip.stance_torque", "leg.thrust"
    near = {"ground.friction": 0.2924, angle: 0.62, torque: 0.12, thrust: 0.06}
    over = {angle: (0.5, 0.7), torque: (0.08, 0.16), thrust: (0.0, 0.15)}
    best = optimize(near, over, minimize="cost_of_transport", target={"speed": 0.8}, starts=1)
    assert best.why == "" and set(best.remaining_improvement) == {"+0-", "+0-0-"}
    assert max(best.remaining_improvement.values()) <= 1e-4
    words = set()
    for turn in np.linspace(0.0, 2.0 * np.pi, 8, endpoint=False):
        aside = {**near, angle: best.parameters[angle] + 2e-3 * np.cos(turn)}
        aside |= {thrust: best.parameters[thrust] + 2e-3 * np.sin(turn), torque: best.parameters[torque]}
        gait = find_gait(aside, target={"speed": 0.8}, vary=[torque], guess=best.gait.apex)
        assert gait.stride["cost_of_transport"] > best.value
        words.add(gait.word)
    assert words >= {"+0-", "+0-0-"}
