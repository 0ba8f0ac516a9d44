"""First variations of expressions by the chain rule, and their values on floats."""

import math
import operator

from .expressions import ARITHMETIC, COMPARE, FUNCTIONS, lift, made, ordered, selected, variation_looked_up

VARIATIONS = {
    "negative": lambda y, a, d_a: -d_a,
    "+": lambda y, a, b, d_a, d_b: d_a + d_b,
    "-": lambda y, a, b, d_a, d_b: d_a - d_b,
    "*": lambda y, a, b, d_a, d_b: 2 * (a * d_a) if a is b else d_a * b + a * d_b,
    "/": lambda y, a, b, d_a, d_b: (d_a - y * d_b) / b,
    "sqrt": lambda y, a, d_a: d_a / 2 / y,
    "sin": lambda y, a, d_a: a.cos() * d_a,
    "cos": lambda y, a, d_a: -(a.sin() * d_a),
    "exp": lambda y, a, d_a: y * d_a,
    "log": lambda y, a, d_a: d_a / a,
    "expm1": lambda y, a, d_a: (y + 1) * d_a,
    "log1p": lambda y, a, d_a: d_a / (1 + a),
    "abs": lambda y, a, d_a: a / y * d_a,
    "atan2": lambda y, a, b, d_a, d_b: (b * d_a - a * d_b) / (a * a + b * b),
    "rate": lambda y, a, d_a: made("rate", d_a),
    "looked_up": lambda y, row, own, d_row, d_own: variation_looked_up(y.value, row, d_own),
    "select": lambda y, a, b, yes, no, d_a, d_b, d_yes, d_no: selected(y.value, a, b, d_yes, d_no),
}
"""First variation of y = f(a), or f(a, b), by the variations of its operands."""


class Variation:
    """First variations of expressions by the chain rule, from the variations of their parts, `of_parts`."""

    def __init__(self, of_parts, prefix=""):
        self.found = {part: lift(variation) for part, variation in of_parts.items()}
        self.prefix = prefix

    def of(self, expression):
        """The variation of an expression."""
        for node in ordered([expression], self.found):
            if node not in self.found:
                parts = [self.found[operand] for operand in node.operands]
                varies = node.operation == "looked_up" or any(not part.is_number(0) for part in parts)
                variation = VARIATIONS[node.operation] if varies else lambda *_: lift(0)
                self.found[node] = variation(node, *node.operands, *parts)
                if varies and self.prefix and node.name:
                    self.found[node].call(self.prefix + node.name)
        return self.found[expression]


def value_of(roots, values):
    """Evaluate expressions on floats; `values` holds the symbols' values and receives all others."""
    calculate = ARITHMETIC | {"/": operator.truediv, "abs": abs}
    calculate |= {name: getattr(math, name) for name in FUNCTIONS if name != "abs"}
    for node in ordered(roots, values):
        if node in values:
            continue
        of = [values[operand] for operand in node.operands]
        if node.operation == "number":
            values[node] = float(node.value)
        elif node.operation == "select":
            values[node] = of[2] if COMPARE[node.value](of[0], of[1]) else of[3]
        else:
            values[node] = calculate[node.operation](*of)
    return [values[root] for root in roots]
