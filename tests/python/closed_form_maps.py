"""Maps whose bifurcations are known in closed form, as problems to be followed."""

import numpy as np
from tdmf_slip import InputError, RunError
from tdmf_slip.analysis.gait_problem import BranchProblem
from tdmf_slip.library.gait import Gait


class MapProblem(BranchProblem):
    """Fixed points of the n-th iterate of x' = step(x, p), with derivatives by x and p.

    `step` gives the next point, the Jacobian, the change by the parameter, and the word.
    """

    def __init__(self, step, dimension, strides=1, low=-np.inf):
        self.step, self.strides, self.low = step, strides, low
        self.names, self.doublings = ("p",), ()
        self.scales = np.ones(dimension + 1)

    def strides_at(self, x):
        apex, value = x[:-1], x[-1]
        if value < self.low:
            raise InputError(f"p = {value:g} is not allowed")
        point, jacobian, change = np.array(apex, dtype=float), np.eye(len(apex)), np.zeros(len(apex))
        points, words = [], []
        for _ in range(self.strides):
            points.append(point)
            point, by_point, by_parameter, word = self.step(point, value)
            jacobian, change = by_point @ jacobian, by_point @ change + by_parameter
            words.append(word)
        residual = point - points[0]
        return Gait(
            runner=None,
            apex=points[0],
            word=" ".join(words),
            liftoff_angle=0.0,
            stride={"p": value},
            jacobian=jacobian,
            along="p",
            by_parameter=change,
            error=float(np.max(np.abs(residual))),
            iterations=0,
            events=(),
            following=tuple(points[1:]),
            residual=residual,
        )

    def describe(self, x):
        gait = self.strides_at(x)
        return gait, np.hstack([gait.jacobian - np.eye(len(gait.apex)), gait.by_parameter[:, None]])

    def residual(self, x):
        return self.strides_at(x).residual

    def linearize(self, x):
        gait, rows = self.describe(x)
        return gait.residual, rows

    def word_at(self, x, varied=True):
        return self.strides_at(x).word

    def beginning(self, value, guess, towards=1.0):
        """A first point, in the direction in which the parameter grows or falls."""
        goal = np.append(np.atleast_1d(np.array(guess, dtype=float)), value)
        return self.correct(goal, self.towards(towards))


def logistic(x, p):
    return p * x * (1 - x), np.array([p * (1 - 2 * x)]), x * (1 - x), "x"


def henon(point, a, b=0.3):
    x, y = point
    return (
        np.array([1 - a * x**2 + y, b * x]),
        np.array([[-2 * a * x, 1.0], [b, 0.0]]),
        np.array([-(x**2), 0.0]),
        "x",
    )


def delayed_logistic(point, p):
    x, y = point
    return (
        np.array([p * x * (1 - y), x]),
        np.array([[p * (1 - y), -p * x], [1.0, 0.0]]),
        np.array([x * (1 - y), 0.0]),
        "x",
    )


def ring(x, p):
    """Fixed points on the circle x^2 + p^2 = 1."""
    return x + 0.3 * (x**2 + p**2 - 1), np.array([1 + 0.6 * x]), np.array([0.6 * p]), "x"


def swapping_ring(x, p):
    """Gaits of two strides on the same circle, whose halves are x and -x."""
    off = x**2 + p**2 - 1
    return -x * (1 + 0.3 * off), np.array([-(1 + 0.3 * off) - 0.6 * x**2]), -0.6 * x * p, "x"


def tent(left, right):
    """Border collision in one dimension: slopes on both sides of x = 0, where the fixed point is at p = 0."""

    def step(x, p):
        slope, word = (left, "-") if x[0] < 0.0 else (right, "+")
        return slope * x + p, np.array([[slope]]), np.ones(1), word

    return step


def collision(left, right):
    """The normal form in two dimensions: trace and determinant on both sides of x = 0."""

    def step(point, p):
        (trace, determinant), word = (left, "-") if point[0] < 0.0 else (right, "+")
        matrix = np.array([[trace, 1.0], [-determinant, 0.0]])
        return matrix @ point + np.array([p, 0.0]), matrix, np.array([1.0, 0.0]), word

    return step


def torn(x, p):
    """Beyond x = 1 the map jumps."""
    return p + 0.5 * x + (3.0 if x[0] > 1.0 else 0.0), np.array([[0.5]]), np.ones(1), "+" if x[0] > 1 else "-"


def two_sheets(gap):
    """Fixed points at 2 p up to x = 1, and beyond it at 2 p and a gap: side by side where p is just below."""

    def step(x, p):
        lifted = x[0] > 1.0
        return p + 0.5 * x + lifted * gap / 2, np.array([[0.5]]), np.ones(1), "+" if lifted else "-"

    return step


def falling(x, p):
    """Beyond x = 1 there is no next point."""
    if x[0] > 1.0:
        raise RunError("the runner fell")
    return p + 0.5 * x, np.array([[0.5]]), np.ones(1), "-"


def linear(matrix_of):
    """x' = M(p) x, whose fixed point is 0: eigenvalues that are any functions of p."""

    def step(point, p):
        matrix = np.asarray(matrix_of(p), dtype=float)
        return matrix @ point, matrix, np.zeros(len(point)), "x"

    return step
