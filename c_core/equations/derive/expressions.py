"""Expressions, recorded while a page's functions run: equal ones are one, named as the page names them."""

import sys
from collections.abc import Callable, Iterable
from fractions import Fraction
from pathlib import Path
from typing import Any, ClassVar

UNARY = ("negative", "sqrt", "sin", "cos", "exp", "log", "expm1", "log1p")
LEAVES = ("number", "symbol")
DERIVE = Path(__file__).parent


class Expression:
    """A number (`value`), a symbol (`text`, which is its C), or an operation on operands."""

    table: ClassVar[dict[Any, "Expression"]] = {}
    names: ClassVar[set[str]] = set()

    def __new__(
        cls, operation: str, *operands: "Expression", value: Any = None, **marks: Any
    ) -> "Expression":
        """Give the expression that there is already, else a new one."""
        key = (operation, value, *(id(operand) for operand in operands))
        if key not in cls.table:
            made = super().__new__(cls)
            made.operation, made.operands, made.value, made.marks = operation, operands, value, marks
            made.name = None
            given = operation != "symbol" or bool(marks.get("constant"))
            made.is_constant = given and all(operand.is_constant for operand in operands)
            cls.table[key] = made
        return cls.table[key]

    operation: str
    operands: tuple["Expression", ...]
    value: Any  # of a number a Fraction or float, of a symbol its C text
    marks: dict[str, Any]  # of a symbol, for whoever made it
    name: str | None
    is_constant: bool  # it holds no symbol but those marked so

    def named(self, name: str) -> "Expression":
        """Give it a name, unless it has one or another has that."""
        if self.name is None and name not in Expression.names and self.operation not in LEAVES:
            self.name = name
            Expression.names.add(name)
        return self

    def is_number(self, value: float | None = None) -> bool:
        """Whether it is a number, or this one."""
        return self.operation == "number" and (value is None or self.value == value)

    def __neg__(self) -> "Expression":
        if self.is_number():
            return number(-self.value)
        if self.operation == "negative":
            return self.operands[0]
        return Expression("negative", self)

    def __add__(self, other: Any) -> "Expression":
        other = lift(other)
        if self.is_number() and other.is_number():
            return number(self.value + other.value)
        if self.is_number(0) or other.is_number(0):
            return other if self.is_number(0) else self
        if other.operation == "negative":
            return self - other.operands[0]
        return other - self.operands[0] if self.operation == "negative" else Expression("+", self, other)

    def __sub__(self, other: Any) -> "Expression":
        other = lift(other)
        if self is other:
            return number(0)
        if self.is_number() and other.is_number():
            return number(self.value - other.value)
        if self.is_number(0) or other.is_number(0):
            return -other if self.is_number(0) else self
        return self + other.operands[0] if other.operation == "negative" else Expression("-", self, other)

    def __mul__(self, other: Any) -> "Expression":
        other = lift(other)
        if self.is_number() and other.is_number():
            return number(self.value * other.value)
        for a, b in ((self, other), (other, self)):
            if a.is_number(0) or a.is_number(1):
                return b if a.is_number(1) else a
            if a.is_number(-1):
                return -b
        swaps = other.is_number() or (other.is_constant and not self.is_constant)
        return Expression("*", other, self) if swaps else Expression("*", self, other)

    def __truediv__(self, other: Any) -> "Expression":
        other = lift(other)
        if other.is_number(0):
            raise ZeroDivisionError("a page divides by zero")
        if self.is_number(0) or other.is_number(1):
            return self
        if other.is_number():
            return self * number(1 / Fraction(other.value))
        return Expression("/", self, other)

    def __radd__(self, other: Any) -> "Expression":
        return lift(other) + self

    def __rsub__(self, other: Any) -> "Expression":
        return lift(other) - self

    def __rmul__(self, other: Any) -> "Expression":
        return lift(other) * self

    def __rtruediv__(self, other: Any) -> "Expression":
        return lift(other) / self

    def __bool__(self) -> bool:
        raise TypeError("a page branches on a value")

    def atan2(self, other: Any) -> "Expression":
        """Give the angle of the point (other, self)."""
        return Expression("atan2", self, lift(other))

    def larger(self, other: Any) -> "Expression":
        """Give the larger of two."""
        return Expression("larger", self, lift(other))

    def __getattr__(self, name: str) -> Any:
        """Give the functions of one number: sqrt, sin, cos, exp, log, expm1, log1p."""
        if name not in UNARY:
            raise AttributeError(name)
        return lambda: Expression(name, self)


def number(value: Any) -> Expression:
    """Give an exact number: fractions stay fractions until they are written."""
    return Expression("number", value=Fraction(value))


def symbol(text: str, name: str | None = None, **marks: Any) -> Expression:
    """Give a leaf that is written as C `text`; `marks` are for whoever makes it, `constant` is known here."""
    made = Expression("symbol", value=text, **marks)
    made.name = name or text.replace("->", ".").split(".")[-1]
    return made


def lift(value: Any) -> Expression:
    """Give an expression for a Python number."""
    return value if isinstance(value, Expression) else number(value)


def forget() -> None:
    """Begin anew, so that one file does not depend on what was written before it."""
    Expression.table.clear()
    Expression.names.clear()


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


def trace(function: Callable[..., Any], *arguments: Any, **named: Any) -> Any:
    """Run a page's function: what it assigns to a local variable, or to a record's member, gets that name."""

    def read_names(frame: Any, event: str, result: Any) -> None:
        code = frame.f_code
        if event != "return" or DERIVE in Path(code.co_filename).parents:
            return
        given = code.co_argcount + code.co_kwonlyargcount
        for name in code.co_varnames[given:]:
            value = frame.f_locals.get(name)
            if isinstance(value, Expression):
                value.named(name)
        if code.co_name != "__init__":
            name_members(result)

    before = sys.getprofile()
    sys.setprofile(read_names)
    try:
        return function(*arguments, **named)
    finally:
        sys.setprofile(before)


def name_members(record: Any) -> None:
    """Name what a record holds as its members, where it has no name yet."""
    for name, value in getattr(record, "__dict__", {}).items() if not isinstance(record, type) else ():
        if isinstance(value, Expression):
            value.named(name)


def derivative(expression: Expression, changes: dict[Expression, Any]) -> Expression:
    """Give the first variation, where `changes` has that of each leaf, or other part, that varies."""
    found = {leaf: lift(change) for leaf, change in changes.items()}
    for node in ordered([expression], found):
        if node not in found:
            found[node] = change_of(node, [found[operand] for operand in node.operands])
            if node.name and node.operation not in LEAVES:
                found[node].named("d_" + node.name)
    return found[expression]


def change_of(node: Expression, changes: list[Expression]) -> Expression:
    """Give the first variation of an operation, by those of its operands."""
    if not node.operands:
        return number(0)
    a, d_a, operation = node.operands[0], changes[0], node.operation
    if operation in ("+", "-"):
        return d_a + changes[1] if operation == "+" else d_a - changes[1]
    if operation == "*" and a is node.operands[1]:
        return 2 * a * d_a
    if operation == "*":
        return d_a * node.operands[1] + a * changes[1]
    if operation == "larger":
        return Expression("choose", a, node.operands[1], d_a, changes[1])
    if operation == "atan2":
        b = node.operands[1]
        return (b * d_a - a * changes[1]) / (a * a + b * b)
    if operation == "/" and a.is_number(1):
        return -(node * node * changes[1])
    if operation == "/":
        return (d_a - node * changes[1]) / node.operands[1]
    if operation == "sqrt":
        return d_a / (2 * node)
    rates: dict[str, Callable[[], Expression]] = {
        "negative": lambda: number(-1),
        "sin": lambda: a.cos(),
        "cos": lambda: -a.sin(),
        "exp": lambda: node,
        "log": lambda: number(1) / a,
        "expm1": lambda: node + 1,
        "log1p": lambda: 1 / (a + 1),
    }
    return rates[operation]() * d_a


def c_number(value: Any) -> str:
    """Write a number; a fraction that is not a double's value as a quotient."""
    if Fraction(float(value)) == value:
        return repr(float(value))
    return f"{float(value.numerator)!r} / {float(value.denominator)!r}"


def c_text(
    expression: Expression,
    text_of: Callable[[Expression], str | None] = lambda node: None,
    functions: str = "",
) -> str:
    """Write an expression in C with the fewest parentheses.

    `text_of` gives the text of what has a name of its own, else None; `functions` begins those of C.
    """

    def write(node: Expression, least: int) -> str:
        text = text_of(node)
        if text is not None:
            return text
        if node.operation == "symbol":
            return str(node.value)
        if node.operation == "number":
            strength, text = (
                (3 if "/" not in c_number(node.value) and node.value >= 0 else 1),
                c_number(node.value),
            )
        elif node.operation == "negative":
            strength = 1 if node.operands[0].operation in "*/" else 2
            text = f"-{write(node.operands[0], strength)}"
        elif node.operation in UNARY:
            strength, text = 3, f"{functions}{node.operation}({write(node.operands[0], 0)})"
        elif node.operation == "atan2":
            strength, text = 3, f"{functions}atan2({', '.join(write(o, 0) for o in node.operands)})"
        elif node.operation in ("larger", "choose"):
            a, b, *chosen = (write(o, 1) for o in (*node.operands, *node.operands)[:4])
            strength, text = -1, f"{a} >= {b} ? {chosen[0]} : {chosen[1]}"
        else:
            strength = 0 if node.operation in "+-" else 1
            left, right = (write(o, strength + i) for i, o in enumerate(node.operands))
            text = f"{left} {node.operation} {right}"
        return text if strength >= least else f"({text})"

    return write(expression, 0)
