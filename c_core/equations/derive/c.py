"""C99 of expressions, and what every derived file has: comments, structs, a header around it all.

Layout is the formatter's business: lines are broken where that is easy.
"""

import textwrap
from collections.abc import Callable, Iterable
from typing import Any

from .expressions import Expression

BINARY = ("+", "-", "*", "/")
TextOf = Callable[[Expression], str | None]


def c_number(value: Any) -> str:
    """Write a number; a fraction that is not a double's value as a quotient."""
    if float(value) == value:
        return repr(float(value))
    return f"{float(value.numerator)!r} / {float(value.denominator)!r}"


def c_text(expression: Expression, text_of: TextOf = lambda node: None, functions: str = "") -> str:
    """Write an expression in C with the fewest parentheses.

    `text_of` gives the text of what has a name of its own, else None; `functions` begins those of C.
    """

    def write(node: Expression, least: int) -> str:
        own = text_of(node)
        strength, text = (3, own) if own is not None else written(node)
        return text if strength >= least else f"({text})"

    def written(node: Expression) -> tuple[int, str]:
        operation, operands = node.operation, node.operands
        if operation == "symbol":
            return 3, str(node.value)
        if operation == "number":
            text = c_number(node.value)
            return 1 if "/" in text or node.value < 0 else 3, text
        if operation == "negative":
            strength = 1 if operands[0].operation in "*/" else 2
            text = write(operands[0], strength)
            return strength, f"-({text})" if text.startswith("-") else f"-{text}"
        if operation in ("larger", "choose"):
            a, b, *chosen = (write(operand, 1) for operand in (*operands, *operands)[:4])
            return -1, f"{a} >= {b} ? {chosen[0]} : {chosen[1]}"
        if operation not in BINARY:
            return 3, f"{functions}{operation}({', '.join(write(operand, 0) for operand in operands)})"
        strength = 0 if operation in "+-" else 1
        left, right = (write(operand, strength + i) for i, operand in enumerate(operands))
        return strength, f"{left} {operation} {right}"

    return write(expression, 0)


def comment(text: str | None, more: str = "") -> str:
    """Write a docstring as a comment of C."""
    assert text, "a law says what it is"
    paragraphs = textwrap.dedent("    " + text).strip().split("\n\n")
    return "/* " + "\n *\n * ".join(" ".join(paragraph.split()) for paragraph in paragraphs) + f"{more} */\n"


def struct(name: str, members: Iterable[str], number: str = "double", size: str = "") -> str:
    """Write a struct of numbers."""
    declared = "".join(f"{number} {member}{size};\n" for member in dict.fromkeys(members))
    return f"typedef struct {{\n{declared}}} {name};\n"


def header(name: str, source: str, includes: str, *parts: str) -> str:
    """Write a file, with what it is derived from on top."""
    guard = f"TDMF_DERIVED_{name.upper()}_H"
    top = f"/* Derived from c_core/equations/{source} by equations/derive: edit that, not this. */\n"
    return "\n".join([top + f"#ifndef {guard}\n#define {guard}\n", includes, *parts, "#endif\n"])
