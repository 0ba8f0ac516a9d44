"""Expressions, recorded while a page's functions run: equal ones are one, named as the page names them."""

import operator
import sys
from collections.abc import Callable, Iterable
from fractions import Fraction
from pathlib import Path
from typing import Any, ClassVar

ARITHMETIC = {"+": operator.add, "-": operator.sub, "*": operator.mul, "negative": operator.neg}
FUNCTIONS = ("sqrt", "sin", "cos", "exp", "expm1", "log1p", "atan2", "abs", "larger")
DERIVE = Path(__file__).parent

Variations = dict["Expression", Any]


def both_ways(operation: str) -> tuple[Callable[..., Any], Callable[..., Any]]:
    """Give an operator of Python, and the same with a number on its left."""
    return (
        lambda a, b: made(operation, a, lift(b)),
        lambda b, a: made(operation, lift(a), b),
    )


class Expression:
    """A number, a symbol or an operation on operands."""

    all: ClassVar[dict[Any, "Expression"]] = {}
    names: ClassVar[set[str]] = set()

    operation: str
    operands: tuple["Expression", ...]
    value: Any  # of a number a Fraction, of a symbol its C text
    marks: dict[str, Any]  # of a symbol, for whoever made it
    name: str | None
    is_constant: bool  # it holds no symbol but those marked so

    def __new__(cls, operation: str, *operands: "Expression", value: Any = None, **marks: Any) -> Any:
        """Give the expression that there is already, else a new one."""
        key = (operation, value, *map(id, operands))
        if key not in cls.all:
            new = cls.all[key] = super().__new__(cls)
            new.operation, new.operands, new.value, new.marks = operation, operands, value, marks
            new.name = None
            given = operation != "symbol" or bool(marks.get("constant"))
            new.is_constant = given and all(operand.is_constant for operand in operands)
        return cls.all[key]

    __add__, __radd__ = both_ways("+")
    __sub__, __rsub__ = both_ways("-")
    __mul__, __rmul__ = both_ways("*")
    __truediv__, __rtruediv__ = both_ways("/")

    def __neg__(self) -> "Expression":
        return made("negative", self)

    def __abs__(self) -> "Expression":
        return Expression("abs", self)

    def __bool__(self) -> bool:
        raise TypeError("a page branches on a value")

    def __getattr__(self, name: str) -> Any:
        """Give a function of this number, and of another where it is one of two."""
        if name not in FUNCTIONS:
            raise AttributeError(name)
        return lambda *others: Expression(name, self, *map(lift, others))

    def named(self, name: str) -> "Expression":
        """Give it a name, unless it has one or another has that."""
        if self.name is None and name not in Expression.names and self.operands:
            self.name = name
            Expression.names.add(name)
        return self

    def is_number(self, value: float) -> bool:
        """Whether it is this number."""
        return self.operation == "number" and bool(self.value == value)


def symbol(text: str, name: str | None = None, **marks: Any) -> Expression:
    """Give a leaf that is written as C `text`; `marks` are for whoever makes it, `constant` is known here."""
    made = Expression("symbol", value=text, **marks)
    made.name = name or text.replace("->", ".").split(".")[-1]
    return made


def lift(value: Any) -> Expression:
    """Give an expression for a Python number, exactly: fractions stay fractions until they are written."""
    return value if isinstance(value, Expression) else Expression("number", value=Fraction(value))


def begin_anew() -> None:
    """Begin anew, so that one file does not depend on what was written before it."""
    Expression.all.clear()
    Expression.names.clear()


# ---- operations -------------------------------------------------------------------------------------------


def made(operation: str, *operands: Expression) -> Expression:
    """Give an operation on operands: done where these are numbers, left out where it changes nothing.

    Of a product the number comes first, then what is constant.
    """
    a, b = operands[0], operands[-1]
    if operation in ARITHMETIC and all(operand.operation == "number" for operand in operands):
        return lift(ARITHMETIC[operation](*(operand.value for operand in operands)))
    match operation:
        case "negative" if a.operation == "negative":
            return a.operands[0]
        case "+" | "-" if b.is_number(0):
            return a
        case "+" | "-" if a.is_number(0):
            return b if operation == "+" else -b
        case "+" | "-" if b.operation == "negative":
            return made("-" if operation == "+" else "+", a, b.operands[0])
        case "+" if a.operation == "negative":
            return b - a.operands[0]
        case "*" if steadiness(b) > steadiness(a):
            return b * a
        case "*" if a.is_number(1):
            return b
        case "*" | "/" if a.is_number(0):
            return a
        case "*" if is_minus(a) or is_minus(b):
            return -(-a * b) if is_minus(a) else -(a * -b)
        case "/" if b.operation == "number":
            return a * lift(1 / b.value)
    return Expression(operation, *operands)


def steadiness(a: Expression) -> int:
    """Rank factors."""
    return 3 if a.operation == "number" else 2 if a.is_constant else 0


def is_minus(a: Expression) -> bool:
    """Whether it is a constant with a sign in front."""
    return a.is_number(-1) or (a.operation == "negative" and a.is_constant)


# The first variation of y = f(a), or f(a, b).
VARIATIONS: dict[str, Callable[..., Expression]] = {
    "negative": lambda y, a, d_a: -d_a,
    "+": lambda y, a, b, d_a, d_b: d_a + d_b,
    "-": lambda y, a, b, d_a, d_b: d_a - d_b,
    "*": lambda y, a, b, d_a, d_b: 2 * (a * d_a) if a is b else d_a * b + a * d_b,
    "/": lambda y, a, b, d_a, d_b: -(y * y * d_b) if a.is_number(1) else (d_a - y * d_b) / b,
    "sqrt": lambda y, a, d_a: d_a / 2 / y,
    "sin": lambda y, a, d_a: a.cos() * d_a,
    "cos": lambda y, a, d_a: -(a.sin() * d_a),
    "exp": lambda y, a, d_a: y * d_a,
    "expm1": lambda y, a, d_a: (y + 1) * d_a,
    "log1p": lambda y, a, d_a: d_a / (a + 1),
    "atan2": lambda y, a, b, d_a, d_b: (b * d_a - a * d_b) / (a * a + b * b),
    "larger": lambda y, a, b, d_a, d_b: Expression("choose", a, b, d_a, d_b),
    "where": lambda y, word, a, b, d_word, d_a, d_b: Expression("where", word, d_a, d_b),
}


def derivative(expression: Expression, variations: Variations, prefix: str = "") -> Expression:
    """Give the first variation, where `variations` has that of each leaf, or other part, that varies.

    With a prefix, the variation of what has a name is called so, with that in front.
    """
    found = {leaf: lift(variation) for leaf, variation in variations.items()}
    for node in ordered([expression], variations):
        if node not in found:
            of_operands = [found[operand] for operand in node.operands]
            varies = any(not variation.is_number(0) for variation in of_operands)
            found[node] = lift(0)
            if varies:
                found[node] = VARIATIONS[node.operation](node, *node.operands, *of_operands)
            if prefix and node.name:
                found[node].named(prefix + node.name)
    return found[expression]


# ---- graphs of them ---------------------------------------------------------------------------------------


def ordered(roots: Iterable[Expression], known: Iterable[Expression] = ()) -> list[Expression]:
    """Give expressions and all that they are made of, operands first; what is known is not looked into."""
    found: dict[Expression, None] = {}
    closed = set(known)

    def visit(expression: Expression) -> None:
        if expression not in found:
            for operand in expression.operands if expression not in closed else ():
                visit(operand)
            found[expression] = None

    for root in roots:
        visit(root)
    return list(found)


def leaves(roots: Iterable[Expression]) -> list[Expression]:
    """Give the symbols that expressions are made of."""
    return [node for node in ordered(roots) if node.operation == "symbol"]


def parameters(function: Callable[..., Any]) -> list[str]:
    """Name what a page's function is handed."""
    return list(function.__code__.co_varnames[: function.__code__.co_argcount])


def trace(function: Callable[..., Any], *arguments: Any, **named: Any) -> Any:
    """Run a page's function: what it assigns to a local variable, or to a record's member, gets that name."""

    def read_names(frame: Any, event: str, result: Any) -> None:
        code = frame.f_code
        if event != "return" or DERIVE in Path(code.co_filename).parents:
            return
        given = code.co_argcount + code.co_kwonlyargcount
        variables = {name: frame.f_locals.get(name) for name in code.co_varnames[given:]}
        for name, value in [*variables.items(), *getattr(result, "__dict__", {}).items()]:
            if isinstance(value, Expression):
                value.named(name)

    before = sys.getprofile()
    sys.setprofile(read_names)
    try:
        return function(*arguments, **named)
    finally:
        sys.setprofile(before)
