"""C functions of laws, and of their first variations.

A law is run on C structs whose members are symbols, once for each case that it asks about (`phase ==
"place"`, `if clamp_closed`), which becomes an `if` of C. What the law gives is the function's result; its
change along a direction, where `d_leg->length` is that of `leg->length`, is the result of the function's
variation.
"""

import re
from collections.abc import Callable, Iterable
from types import SimpleNamespace as Record
from typing import Any

from .c import TextOf, c_text, comment
from .expressions import FUNCTIONS, Expression, derivative, forget, leaves, lift, ordered, trace

WORDS = {"contact": "TDMF_CONTACT_", "phase": "TDMF_PHASE_"}
FLAGS = ("clamp_closed", "thrusts", "mid_stance_pending", "drives", "sticks", "falls", "upright", "rises")
POINTERS = ("model", "inputs", "mode")  # as members of a struct
LINES = ("line", "ground")  # their sine and cosine are those of their slope

decided: dict[str, bool] = {}
known: dict[Expression, str] = {}  # what C has under a name already


class UndecidedError(Exception):
    """A law asks about a case that is not decided in this run of it."""


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
        is_inside = self.own_name != self.value
        arrow = "->" if self.marks.get("pointer") or (is_inside and self.own_name in POINTERS) else "."
        if self.own_name in LINES and name in ("sine", "cosine"):
            of_slope = {"sine": self.slope.sin(), "cosine": self.slope.cos()}
            return vars(given(self.value, Record(**of_slope), arrow))[name]
        return symbol(f"{self.value}{arrow}{name}")

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


def given(name: str, record: Record, arrow: str = ".") -> Record:
    """Note that C has a record's values already, as members of a struct."""
    known.update({value: f"{name}{arrow}{member}" for member, value in vars(record).items()})
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


class Function:
    """A C function of a law.

    `types` are those of its parameters, by their names; "written" is what the function writes to. `arguments`
    makes of what is handed in what the law is handed; without it that is the same. `fixed` are parameters
    that do not change in a variation. `value` is the name under which a variation is given the value.
    """

    def __init__(
        self,
        result: str,
        name: str,
        types: dict[str, str],
        law: Callable[..., Any],
        arguments: Callable[..., Any] = lambda *handed: handed,
        fixed: tuple[str, ...] = (),
        value: str = "",
        varied: bool = True,
    ) -> None:
        self.result, self.name, self.law, self.arguments, self.varied = result, name, law, arguments, varied
        self.written = [declared(types[name], name) for name in types if name == "written"]
        self.types = {name: type_ for name, type_ in types.items() if name != "written"}
        self.fixed = {name for name, type_ in self.types.items() if is_constant(type_)} | set(fixed)
        self.value = value

    def run(self) -> dict[str, Expression]:
        """Give the law's results by their names as members, that of a single number as ''."""
        known.clear()
        handed = [symbol(name, pointer=type_.endswith("*")) for name, type_ in self.types.items()]
        results = trace(self.law, *self.arguments(*handed))
        members = vars(results) if isinstance(results, Record) else {"": results}
        return {name: lift(result) for name, result in members.items()}

    def vary(self) -> dict[str, Expression]:
        """Give the changes of the results."""
        results = self.run()
        if self.value:
            known.update({v: self.member_of_value(name) for name, v in results.items() if v.operands})
        changing = [
            leaf for leaf in leaves(results.values()) if re.split(r"\W", leaf.value)[0] not in self.fixed
        ]
        changes = {leaf: symbol(f"d_{leaf.value}") for leaf in changing}
        return {name: derivative(value, changes, "d_") for name, value in results.items()}

    def c(self) -> str:
        """Write the function, and its variation."""
        given = [declared(type_, name) for name, type_ in self.types.items()]
        text = comment(self.law.__doc__) + self.function(self.name, [*given, *self.written], self.run)
        if not self.varied:
            return text
        value = [self.value_declared()] if self.value else []
        changes = [declared(t, f"d_{name}") for name, t in self.types.items() if name not in self.fixed]
        parameters = [*given, *value, *changes, *self.written]
        return text + "\n/* Its change. */\n" + self.function(f"vary_{self.name}", parameters, self.vary)

    def value_declared(self) -> str:
        """Declare what a variation is given the value by."""
        if self.result == "void":
            return f"const double {self.value}[TDMF_STATE_COUNT]"
        return f"double {self.value}" if self.result == "double" else f"const {self.result} *{self.value}"

    def member_of_value(self, name: str) -> str:
        """Write what has a result in it."""
        if self.result == "void":
            return f"{self.value}[TDMF_{name.upper()}]"
        return self.value if self.result == "double" else f"{self.value}->{name}"

    def function(self, name: str, parameters: list[str], results: Callable[[], dict[str, Expression]]) -> str:
        """Write one C function."""
        forget()
        names = [re.findall(r"\w+", parameter.partition("[")[0])[-1] for parameter in parameters]
        body = of_all_cases(lambda: self.statements(results(), names))
        unused = [n for n in names if not re.search(rf"(?<![.>])\b{n}\b", body)]
        voids = "".join(f"(void){n};\n" for n in unused)
        return f"static inline {self.result} tdmf_{name}({', '.join(parameters)}) {{\n{voids}{body}}}\n"

    def statements(self, results: dict[str, Expression], taken: list[str]) -> str:
        """Write what makes the results, and gives them."""
        lines, text_of = local_variables(list(results.values()), taken)
        texts = {name: c_text(value, text_of) for name, value in results.items()}
        if self.result == "double":
            lines.append(f"return {texts['']};")
        elif self.result == "void":
            lines += [f"written[TDMF_{name.upper()}] = {text};" for name, text in texts.items()]
        else:
            told = {name: text for name, text in texts.items() if text != "0.0"} or texts
            members = "".join(f".{name} = {text},\n" for name, text in told.items())
            lines += [f"const {self.result} result = {{\n{members}}};", "return result;"]
        return "\n".join(lines) + "\n"


def declared(type_: str, name: str) -> str:
    """Declare a parameter."""
    before, bracket, after = type_.partition("[")
    return f"{before}{'' if before.endswith('*') else ' '}{name}{bracket}{after}"


def is_constant(type_: str) -> bool:
    """Whether a parameter has no change."""
    return type_ in ("bool", "tdmf_contact_mode", "tdmf_hip_phase")


def local_variables(roots: list[Expression], taken: Iterable[str]) -> tuple[list[str], TextOf]:
    """Write what a law has given a name as C variables; what has none stands where it is used."""
    nodes = ordered(roots, known)
    used = [operand for node in nodes if node not in known for operand in node.operands]
    written: dict[Expression, str] = {}
    lines = []

    def text_of(node: Expression) -> str | None:
        return known.get(node) or written.get(node)

    for node in nodes:
        is_result = node in roots and node not in used and roots.count(node) == 1
        if node.operands and node.name and node not in known and node.name not in taken and not is_result:
            lines.append(f"const double {node.name} = {c_text(node, text_of)};")
            written[node] = node.name
    return lines, text_of
