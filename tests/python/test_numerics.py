"""Newton's method with damping and walks by halves, on equations whose roots and ways are known."""

import math
from itertools import pairwise

import numpy as np
import pytest
from tdmf_slip.errors import InputError, RunError
from tdmf_slip.numerics.following import Limits, Point, Problem, follow
from tdmf_slip.numerics.newton import NotSolvedError, solve
from tdmf_slip.numerics.walking import halved, walk


class Root:
    """Equations whose solution Newton's method is to find; counts what it evaluates."""

    def __init__(self, function, slope, domain=math.inf):
        self.function, self.slope, self.domain = function, slope, domain
        self.residuals = self.linearized = 0

    def residual(self, x):
        self.residuals += 1
        if np.max(np.abs(x)) > self.domain:
            raise RunError("outside")
        return np.atleast_1d(self.function(*x))

    def linearize(self, x):
        self.linearized += 1
        return np.atleast_1d(self.function(*x)), np.atleast_2d(self.slope(*x))


ARC = (np.arctan, lambda x: 1.0 / (1.0 + x * x))
"""Newton's method for atan(x) = 0 converges from |x| < 1.3917 only; damped, from everywhere."""
SQUARE = (lambda x: x * x - 2.0, lambda x: 2.0 * x)


def test_damping_finds_a_root_from_where_whole_steps_diverge():
    found = solve(Root(*ARC), [3.0])
    assert abs(found.x[0]) < 1e-13 and 3 < found.iterations < 20
    with pytest.raises(NotSolvedError) as stopped:
        solve(Root(*ARC), [3.0], shortenings=1)  # the first whole step makes the residual larger
    assert (stopped.value.last.x, stopped.value.last.iterations) == ([3.0], 0)


def test_the_jacobian_is_kept_while_steps_converge():
    """One Jacobian leads to the root of two from nearby; with a given one, none is computed."""
    root = Root(*SQUARE)
    found = solve(root, [1.414])
    assert found.x[0] == pytest.approx(math.sqrt(2.0), abs=1e-14)
    assert root.linearized == 1 and root.residuals == found.iterations + 1 > 3
    again = Root(*SQUARE)
    assert solve(again, [1.414], jacobian=np.array([[2.8]])).error <= 1e-13
    assert again.linearized == 0


def test_a_step_by_a_poor_jacobian_is_undone():
    """The search is then that of Newton's method, whatever the Jacobian that was given."""
    plain, misled = Root(*ARC), Root(*ARC)
    found = solve(plain, [1.2])
    for jacobian in (-1.0, 0.01, 1e6):
        other = solve(misled, [1.2], jacobian=np.array([[jacobian]]))
        assert (other.x, other.iterations) == (found.x, found.iterations)
    assert misled.linearized == 3 * plain.linearized


def test_fewer_equations_than_unknowns_are_solved_by_the_shortest_step():
    line = Root(lambda x, y: 3.0 * x + 4.0 * y - 25.0, lambda x, y: [3.0, 4.0])
    assert solve(line, [0.0, 0.0]).x == pytest.approx([3.0, 4.0], abs=1e-12)
    assert solve(line, [0.0, 0.0], longest=0.5).iterations == 8


def test_a_step_to_where_there_is_no_residual_is_shortened():
    assert abs(solve(Root(*ARC, domain=4.0), [3.9]).x[0]) < 1e-13
    with pytest.raises(NotSolvedError):
        solve(Root(*ARC, domain=4.0), [3.9], shortenings=2)
    with pytest.raises(RunError, match="outside"):
        solve(Root(*ARC, domain=4.0), [3.9], shortenings=0)
    with pytest.raises(RunError, match="outside"):
        solve(Root(*ARC, domain=4.0), [5.0])


def test_whole_steps_lead_across_a_square_root():
    """Beyond the touch at 0 the residual is larger; the root is there all the same."""
    touch = Root(
        lambda x: x + 1.0 if x < 0.0 else 0.5 + 10.0 * math.sqrt(x),
        lambda x: 1.0 if x < 0.0 else 5.0 / x**0.5,
    )
    with pytest.raises(NotSolvedError):
        solve(touch, [0.0004], shortenings=1)
    assert solve(touch, [0.0004], shortenings=0).x == pytest.approx([-1.0], abs=1e-13)


def test_a_search_ends_without_a_step_and_without_gain():
    with pytest.raises(RunError, match="singular"):
        solve(Root(np.cos, lambda x: -math.sin(x)), [0.0])
    double = (lambda x: x * x, lambda x: 2.0 * x)  # each step leaves a quarter of the residual
    assert solve(Root(*double), [1.0], shortenings=1, gain=0.3).error <= 1e-11
    with pytest.raises(NotSolvedError, match="after 0 iterations with a residual of 1"):
        solve(Root(*double), [1.0], shortenings=1, gain=0.2)
    with pytest.raises(RunError):
        solve(Root(lambda x: math.nan, lambda x: 1.0), [1.0])


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


@pytest.mark.parametrize("problem", [RunError, InputError])
def test_a_walk_stops_before_a_wall(problem):
    def advance(_known, _at, to):
        if to > math.pi:
            raise problem("a wall")
        return to

    values = [0.0]
    with pytest.raises(problem, match="a wall"):
        for value, _ in walk(0.0, 0.0, 10.0, advance, shortest=1e-6):
            values.append(value)
    assert 0.0 <= math.pi - values[-1] < 2e-6  # the last step that failed was shorter than twice the shortest


def test_halving_finds_the_longest_step_that_succeeds():
    """Halving ends if no step succeeds, even if the step is not a number."""

    def attempt(step):
        if not step <= 0.3:
            raise RunError("too long")
        return "found"

    assert halved(attempt, 1.0, 0.25) == ("found", 0.25)
    for step in (1.0, math.nan):
        with pytest.raises(RunError, match="too long"):
            halved(attempt, step, 0.26)


class Graph(Problem):
    """The graph of a function over the last unknown; it counts its residuals."""

    def __init__(self, function, slope):
        self.function, self.slope, self.residuals = function, slope, 0
        self.scales, self.names = np.ones(2), ("t",)

    def residual(self, x):
        self.residuals += 1
        return np.array([x[0] - self.function(x[1])])

    def describe(self, x):
        return None, np.array([[1.0, -self.slope(x[1])]])

    def linearize(self, x):
        return self.residual(x), self.describe(x)[1]


def test_a_cubic_is_extrapolated_exactly():
    graph = Graph(lambda t: t**3 - 2.0 * t, lambda t: 3.0 * t**2 - 2.0)
    up = np.array([0.0, 1.0])
    first, second = (graph.point(np.array([graph.function(t), t]), up) for t in (0.5, 0.6))
    known = Point(second.x, second.tangent, None, second.rows, before=first)
    for t in (0.55, 0.61, 0.64):
        goal = np.array([graph.function(0.6) + (t - 0.6) * graph.slope(0.6), t])
        assert known.extrapolated(goal, up) == pytest.approx([graph.function(t), t], abs=1e-14)
        assert abs(graph.residual(goal)[0]) > 1e-4 and second.extrapolated(goal, up) is goal


def test_what_the_cubic_promises_far_from_the_tangent_is_not_trusted():
    graph = Graph(lambda t: 1e3 * t**3, lambda t: 3e3 * t**2)
    up, goal = np.array([0.0, 1.0]), np.array([0.5, 0.3])
    first, second = (graph.point(np.array([graph.function(t), t]), up) for t in (0.0, 0.1))
    known = Point(second.x, second.tangent, None, second.rows, before=first)
    assert known.extrapolated(goal, up) is goal


def test_a_smooth_curve_takes_few_residuals_a_point():
    graph = Graph(math.sin, math.cos)
    start = graph.point(np.zeros(2), np.array([0.0, 1.0]))
    limits = Limits(np.zeros(1), np.ones(1), max_step=0.003, first_step=0.003)
    points, ended = follow(graph, start, 1.0, limits)
    assert ended == "edge of the ranges" and len(points) > 100
    assert all(abs(point.x[0] - math.sin(point.x[1])) < 1e-13 for point in points)
    assert graph.residuals < 2.5 * len(points)  # along the tangent alone it takes 3.6
