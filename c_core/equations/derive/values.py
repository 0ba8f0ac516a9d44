"""C functions of laws, and of their first variations.

A law is run on C structs whose members are symbols, once for each case that it asks about (`phase ==
"place"`, `if clamp_closed`), which becomes an `if` of C. What the law gives is the function's result; its
change along a direction, where `d_leg->length` is that of `leg->length`, is the result of the function's
variation.
"""

import re
import textwrap
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from .expressions import LEAVES, UNARY, Expression, c_text, derivative, forget, lift, trace

WORDS = {"contact": "TDMF_CONTACT_", "phase": "TDMF_PHASE_"}
FLAGS = ("clamp_closed", "thrusts", "mid_stance_pending", "drives", "sticks", "upright", "rises")
POINTERS = ("model", "inputs", "mode")  # as members of a struct
LINES = ("line", "ground")  # their sine and cosine are those of their slope
FUNCTIONS = (*UNARY, "larger", "atan2")
WIDTH = 104


class UndecidedError(Exception):
    """A law asks about a case that is not decided in this run of it."""


decided: dict[str, bool] = {}
known: dict[Expression, str] = {}  # what C has under a name already


class Member(Expression):
    """A parameter of a C function, or what is in it: a symbol, a struct, a word or a flag of a mode."""

    @property
    def own_name(self) -> str:
        """Its name in the struct."""
        return re.split(r"\.|->", self.value)[-1]

    def __getattr__(self, name: str) -> Any:
        """Give a member of the struct."""
        if name.startswith("_") or name in FUNCTIONS:
            return Expression.__getattr__(self, name)
        if self.own_name == "state":
            return symbol(f"{self.value}[TDMF_{name.upper()}]")
        arrow = (
            "->"
            if self.marks.get("pointer")
            or (("." in self.value or ">" in self.value) and self.own_name in POINTERS)
            else "."
        )
        text = f"{self.value}{arrow}{name}"
        if self.own_name in LINES and name in ("sine", "cosine"):
            before = text.removesuffix(name)
            sine, cosine = note(before + "sine", self.slope.sin()), note(before + "cosine", self.slope.cos())
            return sine if name == "sine" else cosine
        return symbol(text)

    def __eq__(self, other: object) -> bool:
        """Whether a mode's word is this one."""
        if isinstance(other, str):
            return ask(f"{self.value} == {WORDS[self.own_name]}{other.upper()}")
        return self is other

    __hash__ = Expression.__hash__

    def __bool__(self) -> bool:
        """Whether a mode's flag is set."""
        if self.own_name not in FLAGS:
            raise TypeError(f"a law branches on the value of {self.value}")
        return ask(self.value)


def symbol(text: str, **marks: Any) -> Member:
    """Give a symbol that is written so in C."""
    return Member("symbol", value=text, **marks)  # type: ignore[return-value]


def note(text: str, expression: Expression) -> Expression:
    """Note that C has an expression's value already."""
    known[expression] = text
    return expression


def given(name: str, record: SimpleNamespace) -> SimpleNamespace:
    """Note that C has a record's values already, as members of a struct."""
    for of_record, value in vars(record).items():
        note(f"{name}.{of_record}", value)
    return record


def ask(condition: str) -> bool:
    """Whether a condition holds in this run; a subject is one word only."""
    if condition not in decided:
        subject = condition.partition(" == ")[0]
        if any(holds and other.startswith(f"{subject} == ") for other, holds in decided.items()):
            return False
        raise UndecidedError(condition)
    return decided[condition]


def of_all_cases(write: Callable[[], str]) -> str:
    """Write what depends on cases, as C with an `if` for each."""
    try:
        return write()
    except UndecidedError as met:
        condition = str(met)
    texts = []
    for holds in (True, False):
        decided[condition] = holds
        texts.append(of_all_cases(write))
        del decided[condition]
    if texts[0] == texts[1]:
        return texts[0]
    end = "" if texts[0].rstrip().rpartition("\n")[2].startswith("return") else "return;\n"
    return f"if ({condition}) {{\n{texts[0]}{end}}}\n{texts[1]}"


class Parameter:
    """A parameter of a C function, from its declaration."""

    def __init__(self, declaration: str) -> None:
        self.declaration = declaration
        matched = re.fullmatch(r"(.*?)(\w+)(\[\w+\])?", declaration)
        assert matched, declaration
        self.type, self.name, self.array = matched[1].strip(), matched[2], matched[3] or ""
        self.is_result = bool(self.array) and not self.type.startswith("const ")
        self.is_constant = self.type in ("bool", "tdmf_contact_mode", "tdmf_hip_phase")

    def symbol(self) -> Member:
        """Give it as what a law is handed."""
        return symbol(self.name, pointer=self.type.endswith("*"))

    def changed(self) -> str:
        """Declare its change."""
        space = "" if self.type.endswith("*") else " "
        return f"{self.type}{space}d_{self.name}{self.array}"


class Function:
    """A C function of a law: its declaration, and what of its parameters is handed to the law.

    `arguments` makes of the parameters the law's arguments; without it they are these. `fixed` are
    parameters that do not change in a variation. `result` is the name under which a variation is given
    the value.
    """

    def __init__(
        self,
        signature: str,
        law: Callable[..., Any],
        arguments: Callable[..., Any] | None = None,
        fixed: tuple[str, ...] = (),
        result: str = "",
        varied: bool = True,
    ) -> None:
        matched = re.fullmatch(r"(\w+) tdmf_(\w+)\((.*)\)", " ".join(signature.split()))
        assert matched, signature
        self.type, self.name = matched[1], matched[2]
        self.parameters = [Parameter(p) for p in matched[3].split(", ")]
        self.law, self.arguments, self.fixed, self.result, self.varied = law, arguments, fixed, result, varied

    def run(self) -> dict[str, Expression]:
        """Give the law's results by their names as members, that of a single number as ''."""
        known.clear()
        handed = [p.symbol() for p in self.parameters if not p.is_result]
        results = trace(self.law, *(self.arguments(*handed) if self.arguments else handed))
        if isinstance(results, SimpleNamespace):
            return {name: lift(value) for name, value in vars(results).items()}
        return {"": lift(results)}

    def vary(self) -> dict[str, Expression]:
        """Give the changes of the results."""
        results = self.run()
        if self.result:
            known.update(
                {v: self.member_of_value(name) for name, v in results.items() if v.operation not in LEAVES}
            )
        constant = {p.name for p in self.parameters if p.is_constant} | set(self.fixed)
        changes = {
            leaf: symbol(f"d_{leaf.value}")
            for leaf in leaves(results.values())
            if re.split(r"\W", leaf.value)[0] not in constant
        }
        return {name: derivative(value, changes) for name, value in results.items()}

    def c(self) -> str:
        """Write the function, and its variation."""
        text = comment(self.law.__doc__) + self.function(
            self.name, [p.declaration for p in self.parameters], self.run
        )
        if not self.varied:
            return text
        given = [p for p in self.parameters if not p.is_result]
        changing = [p for p in given if not p.is_constant and p.name not in self.fixed]
        value = [self.value_parameter()] if self.result else []
        results = [p.declaration for p in self.parameters if p.is_result]
        parameters = [p.declaration for p in given] + value + [p.changed() for p in changing] + results
        return text + "\n/* Its change. */\n" + self.function(f"vary_{self.name}", parameters, self.vary)

    def value_parameter(self) -> str:
        """Declare what a variation is given the value by."""
        if self.type == "void":
            return f"const double {self.result}[TDMF_STATE_COUNT]"
        return f"double {self.result}" if self.type == "double" else f"const {self.type} *{self.result}"

    def member_of_value(self, name: str) -> str:
        """Write what has a result in it."""
        if self.type == "void":
            return f"{self.result}[TDMF_{name.upper()}]"
        return self.result if self.type == "double" else f"{self.result}->{name}"

    def function(self, name: str, parameters: list[str], results: Callable[[], dict[str, Expression]]) -> str:
        """Write one C function."""
        forget()
        names = [Parameter(p).name for p in parameters]
        body = of_all_cases(lambda: self.statements(results(), names))
        unused = [n for n in names if not re.search(rf"(?<![.>])\b{n}\b", body)]
        voids = "".join(f"(void){n};\n" for n in unused)
        return f"static inline {self.type} tdmf_{name}({', '.join(parameters)}) {{\n{voids}{body}}}\n"

    def statements(self, results: dict[str, Expression], taken: list[str]) -> str:
        """Write what makes the results, and gives them."""
        lines, text_of = local_variables(results.values(), taken)
        texts = {name: c_text(value, text_of) for name, value in results.items()}
        if self.type == "double":
            lines.append(f"return {texts['']};")
        elif self.type == "void":
            written = next(p.name for p in self.parameters if p.is_result)
            lines += [f"{written}[TDMF_{name.upper()}] = {text};" for name, text in texts.items()]
        else:
            told = {name: text for name, text in texts.items() if text != "0.0"} or texts
            members = "".join(f".{name} = {text},\n" for name, text in told.items())
            lines += [f"const {self.type} result = {{\n{members}}};", "return result;"]
        return "\n".join(lines) + "\n"


def leaves(roots: Any) -> list[Expression]:
    """Give the symbols that expressions are made of."""
    found: dict[Expression, None] = {}
    seen: set[Expression] = set()

    def visit(node: Expression) -> None:
        if node not in seen:
            seen.add(node)
            if node.operation == "symbol":
                found[node] = None
            for operand in node.operands:
                visit(operand)

    for root in roots:
        visit(root)
    return list(found)


def local_variables(roots: Any, taken: list[str]) -> tuple[list[str], Callable[[Expression], str | None]]:
    """Write what a law has given a name as C variables; what has none stands where it is used."""
    roots = list(roots)
    uses: dict[Expression, int] = {}
    order: dict[Expression, None] = {}

    def visit(node: Expression) -> None:
        uses[node] = uses.get(node, 0) + 1
        if node in known or node in order:
            return
        for operand in node.operands:
            visit(operand)
        order[node] = None

    for root in roots:
        visit(root)
    written: dict[Expression, str] = {}
    lines = []

    def text_of(node: Expression) -> str | None:
        return known.get(node) or written.get(node)

    for node in order:
        if (
            node.operation in LEAVES
            or not node.name
            or node.name in taken
            or (node in roots and uses[node] == 1)
        ):
            continue
        lines.append(f"const double {node.name} = {c_text(node, text_of)};")
        written[node] = node.name
    return lines, text_of


def comment(docstring: str | None) -> str:
    """Write a law's docstring as a comment of C."""
    assert docstring, "a law says what it is"
    paragraphs = [
        " ".join(p.split()) if not p.startswith("    ") else p
        for p in textwrap.dedent("    " + docstring).strip().split("\n\n")
    ]
    text = "\n\n".join(textwrap.fill(p, WIDTH) for p in paragraphs)
    return "/* " + text.replace("\n", "\n * ").replace(" * \n", " *\n") + " */\n"


def struct(name: str, record: Callable[..., Any]) -> str:
    """Write the C struct of a record that a page makes, with all its members at their defaults."""
    members = "".join(f"double {member};\n" for member in vars(record()))
    return f"{comment(record.__doc__)}typedef struct {{\n{members}}} {name};\n"


def header(
    topic: str, functions: list[Function], structs: str = "quantities.h", records: tuple[str, ...] = ()
) -> str:
    """Write a header of C functions, and of structs that their pages make."""
    title = f"{topic}_laws"
    guard = f"TDMF_DERIVED_{title.upper()}_H"
    source = Path(functions[0].law.__code__.co_filename).name
    parts = [
        f"/* Derived from c_core/equations/{source} by equations/derive: edit that, not this. */",
        f"#ifndef {guard}\n#define {guard}\n",
        f'#include "{structs}"\n\n#include <math.h>\n',
        *records,
        "\n".join(function.c() for function in functions),
        "#endif\n",
    ]
    return "\n".join(parts)
