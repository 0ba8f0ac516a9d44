"""The tracer of laws, by which peers of the benchmark compile them."""

import importlib
import math
import re
import sys
from pathlib import Path

import pytest

CORE = Path(__file__).parents[2] / "c_core"


@pytest.fixture(scope="module")
def expressions():
    sys.path.insert(0, str(CORE))
    try:
        module = importlib.import_module("equations.derive.expressions")
        module.c_text = importlib.import_module("equations.derive.c").c_text
    finally:
        sys.path.remove(str(CORE))
    return module


@pytest.fixture(autouse=True)
def fresh(expressions):
    expressions.begin_anew()


def spring(stiffness, damping, rest_length, length, rate):
    force = stiffness * (rest_length - length) - damping * rate
    axial = force / length
    return axial * axial


def symbols(expressions):
    return [expressions.symbol(name) for name in ("k", "c", "l", "r", "v")]


def test_local_variables_name_what_they_hold(expressions):
    square = expressions.trace(spring, *symbols(expressions))
    assert expressions.c_text(square, lambda node: node.name) == "axial * axial"
    axial = square.operands[0]
    assert expressions.c_text(axial, lambda node: node.name if node is not axial else None) == "force / r"
    force = axial.operands[0]
    assert expressions.c_text(force) == "k * (l - r) - c * v"


def test_equal_expressions_are_one(expressions):
    k, _, _, r, v = symbols(expressions)
    assert k * r + v is k * r + v
    assert 0 * k + 1 * r - 0 is r
    assert k + -r is k - r


def test_a_page_may_not_branch_on_a_value(expressions):
    k, *_ = symbols(expressions)
    with pytest.raises(TypeError, match="branches"):
        _ = 1 if k else 0


def test_parentheses_are_those_that_are_needed(expressions):
    k, c, rest, r, v = symbols(expressions)

    def text(node):
        return expressions.c_text(node, lambda node: None)

    assert text(k - (c - rest)) == "k - (c - l)"
    assert text(k / (c / rest) * (r + v)) == "k / (c / l) * (r + v)"
    assert text(-(k + c) * rest) == "-(k + c) * l"
    assert text(k / 2 + c / 3) == "0.5 * k + 1.0 / 3.0 * c"


def evaluate(node, values, expressions):
    text = expressions.c_text(node, lambda node: None)
    text = re.sub(r"^\((.*) >= (.*) \? (.*) : (.*)\)$", r"\3 if \1 >= \2 else \4", text)
    functions = {
        name: getattr(math, name) for name in ("sqrt", "sin", "cos", "exp", "expm1", "log1p", "atan2")
    }
    return eval(text, {**functions, **values})


def test_derivatives_agree_with_differences(expressions):
    names = ["a", "b", "c"]
    a, b, c = (expressions.symbol(name) for name in names)
    made = {
        "sum": a + b - c,
        "product": a * b * c,
        "quotient": a * b / (c - 3 * a),
        "root": (a * a + b * b).sqrt(),
        "circle": (a * b).sin() * (c - a).cos(),
        "exponentials": (-a * c).exp() + (a / b).expm1(),
        "inverse": 1 / (a + b * c),
        "angle": (a * b).atan2(c - a),
        "larger": (a * b).larger(c),
        "smaller": (a - b).larger(c * c * a),
        "logarithm": (b * c).log1p() - (-a),
    }
    changes = {a: 0.3, b: -0.7, c: 1.1}
    at = {"a": 0.8, "b": 1.7, "c": 0.6}
    step = 1e-5
    for name, node in made.items():
        exact = evaluate(expressions.derivative(node, changes), at, expressions)
        ends = [
            evaluate(
                node,
                {n: at[n] + sign * step * changes[x] for n, x in zip(names, (a, b, c), strict=True)},
                expressions,
            )
            for sign in (1, -1)
        ]
        assert exact == pytest.approx((ends[0] - ends[1]) / (2 * step), rel=1e-8), name
