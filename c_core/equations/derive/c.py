"""C99 of expressions, and what every derived file has: comments, a header around it all.

Layout is the formatter's business: lines are broken where that is easy.
"""

import ast
import textwrap
from collections.abc import Callable

from .expressions import Expression

OPERATORS = {"+": ast.Add(), "-": ast.Sub(), "*": ast.Mult(), "/": ast.Div()}
NAMES = {"abs": "fabs"}  # functions that have another name in C
TextOf = Callable[[Expression], str | None]


def c_text(expression: Expression, text_of: TextOf = lambda node: None) -> str:
    """Write an expression in C, whose operators and parentheses are those of Python.

    `text_of` gives the text of what has a name of its own, else None.
    """

    def tree(node: Expression) -> ast.expr:
        own = text_of(node) or (str(node.value) if node.operation == "symbol" else None)
        operands = () if own else [tree(operand) for operand in node.operands]
        match node.operation:
            case _ if own:
                return ast.Name(own)
            case "number" if float(node.value) == node.value:
                return ast.Constant(float(node.value))
            case "number":  # it is no double's value
                parts = [ast.Constant(float(part)) for part in node.value.as_integer_ratio()]
                return ast.BinOp(parts[0], ast.Div(), parts[1])
            case "negative":
                return ast.UnaryOp(ast.USub(), operands[0])
            case "where":
                return ast.Name("({} ? {} : {})".format(*map(ast.unparse, operands)))
            case "larger" | "choose":
                a, b, *chosen = map(ast.unparse, (*operands, *operands)[:4])
                return ast.Name(f"({a} >= {b} ? {chosen[0]} : {chosen[1]})")
            case operation if operation in OPERATORS:
                return ast.BinOp(operands[0], OPERATORS[operation], operands[1])
        return ast.Call(ast.Name(NAMES.get(node.operation, node.operation)), operands, [])

    return ast.unparse(tree(expression))


def comment(text: str | None, more: str = "") -> str:
    """Write a docstring as a comment of C."""
    assert text, "a law says what it is"
    paragraphs = textwrap.dedent("    " + text).strip().split("\n\n")
    return "/* " + "\n *\n * ".join(" ".join(paragraph.split()) for paragraph in paragraphs) + f"{more} */\n"


def header(name: str, source: str, includes: str, *parts: str) -> str:
    """Write a file, with what it is derived from on top."""
    guard = f"TDMF_DERIVED_{name.upper()}_H"
    top = f"/* Derived from c_core/equations/{source} by equations/derive: edit that, not this. */\n"
    return "\n".join([top + f"#ifndef {guard}\n#define {guard}\n", includes, *parts, "#endif\n"])
