"""C99 of expressions, for programs that compile the laws themselves."""

import ast
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
