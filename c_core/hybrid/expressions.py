"""Expressions that record what a page's functions compute. Equal expressions are one object.

Numbers are exact fractions until they are written. An expression is constant if no quantity in it moves.
"""

import math
import operator
from fractions import Fraction

from .errors import PageError, Undecided
from .units import dimension_of_node

ARITHMETIC = {"+": operator.add, "-": operator.sub, "*": operator.mul, "negative": operator.neg}
COMPARE = {">": operator.gt, ">=": operator.ge, "<": operator.lt, "<=": operator.le}
POWER_LIMIT, COMPARISON_LIMIT = 64, 40
FUNCTIONS = ("sqrt", "sin", "cos", "exp", "log", "expm1", "log1p", "atan2", "abs")

_table = {}
_names = set()
_checks_units = [False]
_looks_up = [False]


def forget_expressions():
    """Clear the table of expressions before the next trace."""
    _table.clear()
    _names.clear()


class Expression:
    """A number, a symbol or an operation on operands."""

    __slots__ = ("dimension", "drifts", "is_constant", "name", "operands", "operation", "value")
    __array_ufunc__ = None  # NumPy leaves arithmetic with an array to `lift`, which refuses it

    def __neg__(self):
        return made("negative", self)

    def __pos__(self):
        return self

    def __abs__(self):
        return lift(abs(self.value)) if self.operation == "number" else made("abs", self)

    def __pow__(self, exponent):
        return power(self, exponent)

    def __rpow__(self, base):
        return power(lift(base), self)

    def __eq__(self, other):
        if isinstance(other, (int, float)):
            raise PageError("compares with ==, which rounding decides; use < or >")
        return self is other

    __hash__ = object.__hash__

    def __bool__(self):
        if self.operation == "number":
            return self.value != 0
        raise PageError("branches on a number; an event's decision may branch on a comparison")

    def __float__(self):
        if self.operation == "number":
            return float(self.value)
        raise PageError("needs a plain number here; sin, cos and sqrt come from the language, not from math")

    def __getattr__(self, name):
        if name in FUNCTIONS:
            return lambda *others: made(name, self, *map(lift, others))
        raise PageError(f"asks a number for `{name}`")

    def is_number(self, value):
        """True if the expression is this number."""
        return self.operation == "number" and self.value == value

    def call(self, name):
        """Take a name, unless the expression has one or the name is taken."""
        if self.name is None and name not in _names and self.operands:
            self.name = name
            _names.add(name)


for _sign, _name in (("+", "add"), ("-", "sub"), ("*", "mul"), ("/", "truediv")):
    setattr(Expression, f"__{_name}__", lambda a, b, sign=_sign: made(sign, a, lift(b)))
    setattr(Expression, f"__r{_name}__", lambda a, b, sign=_sign: made(sign, lift(b), a))
for _sign, _name in ((">", "gt"), (">=", "ge"), ("<", "lt"), ("<=", "le")):
    setattr(Expression, f"__{_name}__", lambda a, b, sign=_sign: Condition(sign, a, lift(b)))


def _recorded(operation, operands, value=None, constant=False):
    key = (operation, value, *map(id, operands))
    node = _table.get(key)
    if node is None:
        node = _table[key] = object.__new__(Expression)
        node.operation, node.operands, node.value = operation, operands, value
        node.name, node.drifts = None, False
        node.is_constant = (operation != "symbol" or constant) and all(o.is_constant for o in operands)
        is_checked = _checks_units[0] and operation != "symbol"
        node.dimension = dimension_of_node(node, [o.dimension for o in operands]) if is_checked else None
    return node


def symbol(text, constant=False, dimension=None):
    """The symbol of a quantity with this text in C."""
    node = _recorded("symbol", (), text, constant)
    if dimension is not None:
        node.dimension = dimension
    return node


def lift(value):
    """An expression for a Python number."""
    if isinstance(value, Expression):
        return value
    if isinstance(value, Condition):
        return selected(value.sign, value.a, value.b, lift(1), lift(0))
    if isinstance(value, (int, Fraction)) or (isinstance(value, float) and math.isfinite(value)):
        return _recorded("number", (), Fraction(value))
    if isinstance(value, float):
        raise PageError(f"uses the number {value}, which is not finite")
    item = getattr(value, "item", None)
    if item is not None and getattr(value, "ndim", None) == 0:
        return lift(item())
    raise PageError(f"computes with a {type(value).__name__}; a page computes with numbers")


def made(operation, *operands):
    """An operation, simplified: numbers are folded, neutral elements dropped, signs pulled out of products.

    The factors of a product are ordered: a number first, then a constant.
    """
    a, b = operands[0], operands[-1]
    if operation in ARITHMETIC and all(o.operation == "number" for o in operands):
        return lift(ARITHMETIC[operation](*(o.value for o in operands)))
    match operation:
        case "negative" if a.operation == "negative":
            return a.operands[0]
        case "+" | "-" if b.is_number(0):
            return a
        case "+" if a.is_number(0):
            return b
        case "-" if a.is_number(0):
            return -b
        case "-" if a is b:
            return lift(0)
        case "+" | "-" if b.operation == "negative":
            return made("-" if operation == "+" else "+", a, b.operands[0])
        case "+" if a.operation == "negative":
            return b - a.operands[0]
        case "*" if _steadiness(b) > _steadiness(a):
            return b * a
        case "*" if a.is_number(1):
            return b
        case "/" if b.is_number(0):
            raise ZeroDivisionError("division by zero")
        case "*" | "/" if a.is_number(0):
            return a
        case "*" if a.is_number(-1):
            return -b
        case "/" if a.operation == "number" and a.value < 0:
            return -made("/", lift(-a.value), b)
        case "*" | "/" if a.operation == "negative":
            return -made(operation, a.operands[0], b)
        case "*" | "/" if b.operation == "negative":
            return -made(operation, a, b.operands[0])
        case "/" if b.operation == "number":
            return a * lift(1 / b.value)
        case "rate" if a.is_constant:
            return lift(0)
    return _recorded(operation, operands)


def _steadiness(a):
    return 2 if a.operation == "number" else 1 if a.is_constant else 0


def power(base, exponent):
    """A power: products for an integer, a square root for a half, else exp(exponent log(base))."""
    exponent = lift(exponent)
    if exponent.operation != "number":
        if base.operation == "number" and base.value <= 0:
            raise PageError(f"raises {float(base.value):g} to a power; the base has to be above 0")
        return (exponent * base.log()).exp()
    n = exponent.value
    if n.denominator > 2:
        return (exponent * base.log()).exp()
    if n < 0:
        return 1 / power(base, -n)
    if n.denominator == 2:
        return power(base, n - Fraction(1, 2)) * base.sqrt()
    if n > POWER_LIMIT:
        raise PageError(f"raises to the power {n}; at most {POWER_LIMIT} is allowed")
    found, square, left = lift(1), base, int(n)
    while left:
        found = found * square if left & 1 else found
        left >>= 1
        square = square * square if left else square
    return found


def selected(sign, a, b, yes, no):
    """One of two numbers, selected by a comparison without a branch."""
    if a.operation == b.operation == "number":
        return yes if COMPARE[sign](a.value, b.value) else no
    return yes if yes is no else _recorded("select", (a, b, yes, no), sign)


def looked_up(entry, row, own):
    """The entry of a run's table in a row, or the page's own entry."""
    return _recorded("looked_up", (row, own), entry)


def variation_looked_up(entry, row, of_own):
    """The variation of an entry."""
    return _recorded("variation_looked_up", (row, of_own), entry)


# ---- comparisons ---------------------------------------------------------------------------------------


class Condition:
    """A comparison. A decision may branch on it: `explore` runs the decision for both answers."""

    answers = None
    asked = ()

    def __init__(self, sign, a, b):
        self.sign, self.a, self.b = sign, a, b
        made("-", a, b)  # refuses what has different units

    def __bool__(self):
        if self.a.operation == self.b.operation == "number":
            return COMPARE[self.sign](self.a.value, self.b.value)
        if Condition.answers is None:
            text = "branches on a number that moves; let an event change a word of the mode, or use "
            raise PageError(f"{text}`select` of held states")
        for asked, answer in zip(Condition.asked, Condition.answers, strict=False):
            if (asked.sign, asked.a, asked.b) == (self.sign, self.a, self.b):
                return answer
        Condition.asked.append(self)
        if len(Condition.asked) > COMPARISON_LIMIT:
            text = f"asks more than {COMPARISON_LIMIT} comparisons one after the other"
            raise PageError(f"{text}; a loop on a number does not end")
        if len(Condition.asked) > len(Condition.answers):
            raise Undecided
        return Condition.answers[len(Condition.asked) - 1]


def explore(run, answers=()):
    """Run a page's function for every combination of answers: a tree of conditions and results."""
    Condition.answers, Condition.asked = list(answers), []
    try:
        return run()
    except Undecided:
        condition = Condition.asked[-1]
    finally:
        Condition.answers = None
    return condition, explore(run, (*answers, True)), explore(run, (*answers, False))


# ---- walking and changing --------------------------------------------------------------------------------


def ordered(roots, known=()):
    """Expressions and all their operands, operands first; the operands of `known` ones are left out."""
    found, todo = {}, [(root, False) for root in reversed(list(roots))]
    while todo:
        node, is_ready = todo.pop()
        if node in found:
            continue
        if is_ready or node in known or not node.operands:
            found[node] = None
        else:
            todo.append((node, True))
            todo += [(operand, False) for operand in reversed(node.operands) if operand not in found]
    return list(found)


def leaves_of(roots):
    """The symbols in expressions."""
    return [node for node in ordered(roots) if node.operation == "symbol"]


def remade(node, operands):
    """The operation of a node, applied to other operands."""
    return selected(node.value, *operands) if node.operation == "select" else made(node.operation, *operands)


def replaced(roots, new, change=remade):
    """Expressions with some parts replaced; names stay. `new` also receives every part that is rebuilt."""
    for node in ordered(roots, new):
        if node not in new:
            new[node] = change(node, [new[o] for o in node.operands]) if node.operands else node
            new[node].name = new[node].name or node.name
    return [new[root] for root in roots]
