"""Curves of special points over two parameters: in closed form, and against branches over one of them."""

from itertools import combinations

import numpy as np
import pytest
from branch_rows import rows_of, specials
from closed_form_maps import MapProblem, henon
from tdmf_slip import Runner, continue_branch, continue_curves, plot
from tdmf_slip.analysis.curves import BifurcationProblem, curve_through
from tdmf_slip.analysis.special_points import bialternate
from tdmf_slip.numerics.following import Limits

ANGLE, DAMPING, FRICTION = "hip.touchdown_angle", "leg.damping", "ground.friction"


class MapCurve(BifurcationProblem):
    """Bifurcations of the fixed points of x' = step(x, a, b), which gives by both parameters, too."""

    def __init__(self, step, dimension, kind):
        self.runner, self.names, self.kind = None, ("a", "b"), kind
        self.step, self.scales = step, np.ones(dimension + 2)

    def problem(self, x, along):
        *_, a, b = x
        return MapProblem(lambda point, _: self.step(point, a, b, along), len(x) - 2)

    def by_apex(self, x):
        gait, rows = self.problem(x, "a").describe(x[:-1])
        return gait.residual, rows[:, :-1]

    def linearize(self, x):
        gait, rows = self.describe(x)
        return np.append(gait.residual, self.singular(self.by_apex(x)[1])), rows

    def describe(self, x):
        gait, rows = self.problem(x, "a").describe(x[:-1])
        rows = np.hstack([rows, self.problem(x, "b").describe(x[:-1])[1][:, -1:]])
        return gait, np.vstack([rows, self._differentiated(x, rows)[1]])


def henon_over_both(point, a, b, along):
    image, jacobian, by_a, word = henon(point, a, b)
    return image, jacobian, by_a if along == "a" else np.array([0.0, point[0]]), word


def ring(x, a, b, along):
    """x' = x + x^2 + a^2 + b^2 - 1, whose folds are at x = 0 on the unit circle."""
    change = np.array([2 * (a if along == "a" else b)])
    return x + x**2 + a**2 + b**2 - 1, np.array([1 + 2 * x]), change, "x"


def followed(problem, at, low, high):
    limits = Limits(np.array(low), np.array(high), parts=15.0)
    start = problem.point(at, np.eye(len(at))[-1])
    return curve_through(problem, start, limits, problem.kind)


def fixed_point(a, b, sign=1.0):
    x = (b - 1 + sign * np.sqrt((1 - b) ** 2 + 4 * a)) / (2 * a)
    return np.array([x, b * x, a, b])


@pytest.mark.parametrize(
    ("kind", "a_of", "start"),
    [
        ("fold", lambda b: -((1 - b) ** 2) / 4, 0.3),
        ("period doubling", lambda b: 3 * (1 - b) ** 2 / 4, 0.3),
    ],
)
def test_curves_of_the_henon_map_are_parabolas(kind, a_of, start):
    problem = MapCurve(henon_over_both, 2, kind)
    curve = followed(problem, fixed_point(a_of(start), start), [-1.0, -0.5], [1.0, 0.5])
    a, b = curve.points.T
    np.testing.assert_allclose(a, a_of(b), atol=1e-9)
    assert len(b) > 10 and curve.began == curve.ended == "edge of the ranges"
    on_edge = np.isclose(np.abs(b[[0, -1]]), 0.5, atol=1e-9) | np.isclose(np.abs(a[[0, -1]]), 1.0, atol=1e-9)
    assert on_edge.all()


def test_a_curve_of_neimark_sacker_points_ends_where_the_pair_becomes_real():
    """The Henon map has one at b = -1, between the double eigenvalues 1 at a = -1 and -1 at a = 3."""
    problem = MapCurve(henon_over_both, 2, "Neimark-Sacker")
    curve = followed(problem, fixed_point(1.0, -1.0), [-2.0, -1.5], [4.0, -0.5])
    np.testing.assert_allclose(curve.points[:, 1], -1.0, atol=1e-9)
    low, high = sorted(curve.points[[0, -1], 0])
    assert -1.3 < low < -0.6 and 2.6 < high < 3.4
    ends = (curve.began, curve.ended)
    assert all(end.startswith(("the eigenvalues become real", "lost")) for end in ends), ends


def test_a_curve_that_closes_is_followed_once():
    curve = followed(MapCurve(ring, 1, "fold"), np.array([0.0, 1.0, 0.0]), [-2.0, -2.0], [2.0, 2.0])
    assert curve.began == curve.ended == "closed: back where it has been"
    np.testing.assert_allclose(np.linalg.norm(curve.points, axis=1), 1.0, atol=1e-9)
    angles = np.unwrap(np.arctan2(*curve.points.T))
    assert abs(angles[-1] - angles[0]) == pytest.approx(2.0 * np.pi) and np.ptp(np.sign(np.diff(angles))) == 0


def test_the_bialternate_product_has_the_products_of_pairs():
    matrix = np.random.default_rng(0).normal(size=(5, 5))
    values = np.linalg.eigvals(matrix)
    wanted = np.sort_complex([a * b for a, b in combinations(values, 2)])
    np.testing.assert_allclose(np.sort_complex(np.linalg.eigvals(bialternate(matrix))), wanted, atol=1e-12)


def test_period_doublings_over_two_parameters(command, tmp_path):
    options = ("--vary", f"{ANGLE}=0.575:0.555", "--vary", f"{DAMPING}=0.199:0.201", "--plot", "curves.png")
    printed = command.json("continue", *options)
    assert printed["over"] == [ANGLE, DAMPING]
    (curve,) = (curve for curve in printed["curves"] if curve["kind"] == "period doubling")
    assert curve["ended"] == "edge of the ranges"
    ends = sorted((curve["points"][0], curve["points"][-1]))
    assert sorted(damping for _, damping in ends) == pytest.approx([0.199, 0.201], abs=1e-9)
    angle, damping = curve["points"][len(curve["points"]) // 4]
    runner = Runner({DAMPING: damping})
    branch = continue_branch(runner, {ANGLE: (angle + 2e-3, angle - 2e-3)}, switch=False)
    (doubling,) = specials(rows_of(branch), "period doubling")
    assert doubling.value == pytest.approx(angle, rel=1e-8)
    assert (tmp_path / "curves.png").read_bytes()[:4] == b"\x89PNG"


def test_a_word_border_crosses_the_ranges_of_two_parameters_and_has_each_word_on_its_side():
    """The word of a lower friction stands left of the curve, whichever way the first range leads."""
    curves = continue_curves({}, {FRICTION: (1.1, 1.2), DAMPING: (0.198, 0.202)})
    names = "kind", "before", "after", "began", "ended"
    assert [curves[name].item() for name in names] == [
        "word border",
        "+0-0+",
        "+0+",
        *["edge of the ranges"] * 2,
    ]
    points = np.column_stack([curves[FRICTION], curves[DAMPING]])
    assert len(points) < 60 and sorted(points[[0, -1], 1]) == pytest.approx([0.198, 0.202])
    friction, damping = points[len(points) // 4]
    runner = Runner({DAMPING: damping})
    branch = continue_branch(runner, {FRICTION: (friction + 1e-4, friction - 1e-4)}, switch=False)
    (value,) = (of.value for of in specials(rows_of(branch)) if of.words == ("+0+", "+0-0+"))
    assert value == pytest.approx(friction, rel=1e-8)
    figure = plot(curves)
    figure.canvas.draw()
    axes = figure.axes[0]
    texts = sorted(axes.texts, key=lambda text: text.get_window_extent().x0)
    assert [text.get_text() for text in texts] == ["+0−0+", "+0+"]
    line = axes.transData.transform(points)
    for text in texts:
        assert not any(text.get_window_extent().contains(*point) for point in line)


def test_ranges_without_special_points_have_no_curves(command):
    status, out, _ = command("continue", "--vary", f"{FRICTION}=0.6:0.58", "--vary", f"{DAMPING}=0.2:0.21")
    assert status == 0 and out.startswith(f"no curves: gaits over {FRICTION} have no special points")
