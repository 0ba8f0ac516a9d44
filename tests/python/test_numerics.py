"""Newton's method with damping and walks by halves, on equations whose roots and ways are known."""

import math
from itertools import pairwise

import numpy as np
import pytest
from tdmf_slip.errors import InputError, RunError
from tdmf_slip.numerics.halving import halved, walk
from tdmf_slip.numerics.newton import last_iterate, newton_iterates


class Root:
    """A function of one number whose root Newton's method is to find."""

    def __init__(self, function, slope, domain=math.inf):
        self.function, self.slope, self.domain = function, slope, domain

    def error(self, x):
        return abs(self.function(x))

    def is_solved(self, x):
        return self.error(x) < 1e-14

    def step(self, x):
        if self.slope(x) == 0.0:
            raise np.linalg.LinAlgError("no step")
        return -self.function(x) / self.slope(x)

    def moved(self, x, step):
        if abs(x + step) > self.domain:
            raise RunError("outside")
        return x + step


ARC = (math.atan, lambda x: 1.0 / (1.0 + x * x))
"""Newton's method for atan(x) = 0 converges from |x| < 1.3917 only; damped, from everywhere."""


def test_damping_finds_a_root_from_where_whole_steps_diverge():
    found, steps = last_iterate(Root(*ARC), 3.0, iterations=40, shortenings=12)
    assert abs(found) < 1e-14 and 3 < steps < 20
    whole = [x for x, _ in newton_iterates(Root(*ARC), 3.0, iterations=40, shortenings=1)]
    assert whole == [3.0]  # the first whole step makes the error larger


def test_newton_converges_quadratically_at_the_root_of_two():
    root = Root(lambda x: x * x - 2.0, lambda x: 2.0 * x)
    errors = [abs(x - math.sqrt(2.0)) for x, _ in newton_iterates(root, 1.5, iterations=3, shortenings=1)]
    assert len(errors) == 4
    for before, after in pairwise(errors[:3]):
        assert after == pytest.approx(before**2 / (2.0 * math.sqrt(2.0)), rel=0.1)


def test_a_step_to_where_nothing_is_evaluated_is_shortened_or_told():
    found, _ = last_iterate(Root(*ARC, domain=4.0), 3.9, iterations=40, shortenings=12)
    assert abs(found) < 1e-14
    with pytest.raises(RunError, match="outside"):
        list(newton_iterates(Root(*ARC, domain=4.0), 3.9, iterations=40, shortenings=2))
    assert last_iterate(Root(*ARC, domain=4.0), 3.9, iterations=40, shortenings=2) == (3.9, 0)


def test_newton_ends_without_a_step_and_below_the_bound():
    assert last_iterate(Root(math.cos, lambda x: -math.sin(x)), 0.0, iterations=5, shortenings=5) == (0.0, 0)
    double = Root(lambda x: x * x, lambda x: 2.0 * x)  # each step leaves a quarter of the error
    assert last_iterate(double, 1.0, iterations=5, shortenings=1, bound=lambda error: 0.3 * error)[1] == 5
    assert last_iterate(double, 1.0, iterations=5, shortenings=1, bound=lambda error: 0.2 * error)[1] == 0


@pytest.mark.parametrize(("begin", "end"), [(0.0, 1.0), (2.0, -1.0), (-1e3, 1e3)])
def test_a_walk_goes_no_farther_at_once_than_it_may_and_ends_at_the_end(begin, end):
    longest = abs(end - begin) / 11.0
    tried = []

    def advance(known, at, to):
        tried.append(to)
        assert known == at
        if abs(to - at) > longest:
            raise RunError("too far")
        return to

    way = list(walk(begin, begin, end, advance, shortest=1e-6))
    values = [value for value, _ in way]
    assert values == [known for _, known in way] and values[-1] == end
    steps = np.diff([begin, *values])
    assert np.all(np.sign(steps) == np.sign(end - begin)) and np.max(np.abs(steps)) <= longest
    assert len(values) == 16 and len(tried) < 40  # each step is the way over 16; doubled, each fails once


def test_a_walk_lengthens_its_steps_behind_a_narrow_stretch():
    def advance(_known, at, to):
        if at < 0.1 and to - at > 0.01:
            raise RunError("narrow")
        return to

    values = [value for value, _ in walk(0.0, 0.0, 1.0, advance, shortest=1e-6)]
    steps = [after - before for before, after in pairwise(values)]
    assert sum(value > 0.1 for value in values) <= 8 and steps[-2] > 30.0 * steps[0]


def test_a_walk_stops_before_what_cannot_be_passed():
    def advance(_known, _at, to):
        if to > math.pi:
            raise RunError("a wall")
        return to

    values = []
    with pytest.raises(RunError, match="a wall"):
        for value, _ in walk(0.0, 0.0, 10.0, advance, shortest=1e-6):
            values.append(value)
    assert 0.0 < math.pi - values[-1] < 2e-6  # the step that failed last was shorter than twice the shortest


def test_what_is_refused_ends_a_walk_at_once():
    tried = []

    def advance(_known, _at, to):
        tried.append(to)
        raise InputError("refused")

    with pytest.raises(InputError, match="refused"):
        list(walk(0.0, 0.0, 1.0, advance, shortest=1e-6))
    assert tried == [1.0]


def test_halving_finds_the_longest_step_that_succeeds():
    def attempt(step):
        if step > 0.3:
            raise RunError("too long")
        return "found"

    assert halved(attempt, 1.0, 0.25) == ("found", 0.25)
    with pytest.raises(RunError, match="too long"):
        halved(attempt, 1.0, 0.26)


def test_a_step_that_is_not_a_number_ends_with_the_failure():
    def refuse(step):
        raise RunError("nothing there")

    with pytest.raises(RunError, match="nothing there"):
        halved(refuse, math.nan, 0.1)
