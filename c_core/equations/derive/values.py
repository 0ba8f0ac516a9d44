"""C functions of laws, and of their first variations.

A law is run on C structs whose members are symbols, once for each case that it asks about (`phase ==
"place"`, `if clamp_closed`), which becomes an `if` of C. What the law gives is the function's result; its
change along a direction, where `d_leg->length` is that of `leg->length`, is the result of the function's
variation.
"""

import re
from collections.abc import Callable
from types import SimpleNamespace as Record
from typing import Any

from ..in_c import ANGLES, FIXED, FLAGS, POINTERS, TYPES, WITHOUT_VARIATION, WORDS, InC
from .c import c_text, comment
from .expressions import (
    FUNCTIONS,
    Expression,
    begin_anew,
    derivative,
    leaves,
    lift,
    ordered,
    parameters,
    trace,
)

decided: dict[str, bool] = {}
known: dict[Expression, str] = {}  # what C has under a name already


class UndecidedError(Exception):
    """A law asks about a case that is not decided in this run of it."""


class Member(Expression):
    """A parameter of a C function, or what is in it: a number, a struct, a word or a flag of a mode."""

    @property
    def own_name(self) -> str:
        """Its name in the struct."""
        return re.split(r"\.|->", self.value)[-1]

    def __getattr__(self, name: str) -> Any:
        """Give a member of the struct; the sine and cosine of a known angle are known, too."""
        if name.startswith("_") or name in FUNCTIONS:
            return Expression.__getattr__(self, name)
        if self.own_name == "state":
            return symbol(f"{self.value}[TDMF_{name.upper()}]")
        is_inside = self.own_name != self.value
        arrow = "->" if self.marks.get("pointer") or (is_inside and self.own_name in POINTERS) else "."
        before = f"{self.value}{arrow}"
        if self.own_name in ANGLES and name in ("sine", "cosine"):
            angle = symbol(ANGLES[self.own_name].format(before))
            known.update({angle.sin(): f"{before}sine", angle.cos(): f"{before}cosine"})
            return angle.sin() if name == "sine" else angle.cos()
        return symbol(before + name)

    def condition(self, word: str) -> str:
        """Write whether a mode's word is this one."""
        return f"{self.value} == {WORDS[self.marks.get('word', self.own_name)]}{word.upper()}"

    def __eq__(self, other: object) -> bool:
        """Whether a mode's word is this one."""
        return ask(self.condition(other)) if isinstance(other, str) else self is other

    def where(self, is_: str | bool, then: Any, other: Any) -> Expression:
        """Give a number by the mode's word or flag, or what it is either way."""
        holds = symbol(self.condition(is_) if isinstance(is_, str) else self.value, constant=True)
        return (
            lift(then) if lift(then) is lift(other) else Expression("where", holds, lift(then), lift(other))
        )

    __hash__ = Expression.__hash__

    def __bool__(self) -> bool:
        """Whether a mode's flag is set."""
        if self.own_name not in FLAGS:
            raise TypeError(f"a law branches on the value of {self.value}")
        return ask(self.value)


def symbol(text: str, **marks: Any) -> Member:
    """Give a symbol that is written so in C."""
    return Member("symbol", value=text, **marks)  # type: ignore[return-value]


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
    """A C function of a row of the table of what C has.

    `types` are those of its parameters, where they have not the types of the table, by their names; "written"
    is what a function of no result writes to.
    """

    def __init__(self, row: InC, types: dict[str, str] | None = None) -> None:
        self.law, self.call, self.value, self.is_varied = row.law, row.call, row.value, row.varied
        self.result, self.name = row.declared.split()
        types = types or {}
        names = dict.fromkeys([*parameters(row.call or row.law), *types])
        given = {name: (TYPES | types).get(name, "double") for name in [*names, "written"]}
        written = given.pop("written")
        self.types, self.written = given, {"written": written} if self.result == "void" else {}
        self.fixed = {n for n, type_ in self.types.items() if type_ in WITHOUT_VARIATION or n in FIXED}

    def run(self) -> dict[str, Expression]:
        """Give the law's results by their names as members, that of a single number as ''."""
        begin_anew()
        known.clear()
        handed = [symbol(name, pointer=type_.endswith("*")) for name, type_ in self.types.items()]
        law = (lambda *given: self.law(*self.call(*given))) if self.call else self.law
        results = trace(law, *handed)
        members = vars(results) if isinstance(results, Record) else {"": results}
        return {name: lift(result) for name, result in members.items()}

    def vary(self) -> dict[str, Expression]:
        """Give the changes of the results."""
        results = self.run()
        if self.value:
            known.update({v: self.member(self.value, name) for name, v in results.items() if v.operands})
        variations = {
            leaf: symbol(f"d_{leaf.value}")
            for leaf in leaves(results.values())
            if re.split(r"\W", leaf.value)[0] not in self.fixed and not leaf.is_constant
        }
        return {name: derivative(value, variations, "d_") for name, value in results.items()}

    def member(self, of: str, name: str) -> str:
        """Write where a result is, in what has all."""
        written = "".join(self.written.values())
        if "[" in written:
            return f"{of}[TDMF_{name.upper()}]"
        return f"{of}->{name}" if name else of

    def c(self) -> str:
        """Write the function, and its variation."""
        return f"{self.c_of_value()}\n{self.c_of_variation()}" if self.is_varied else self.c_of_value()

    def c_of_value(self) -> str:
        """Write the function alone."""
        return comment(self.law.__doc__) + self.function(self.name, self.types | self.written, self.run)

    def c_of_variation(self) -> str:
        """Write its variation, which is handed the value, if it asks for that, and the changes."""
        types = dict(self.types)
        if self.value:
            of_struct = f"const {self.result} *" if self.result != "double" else self.result
            types[self.value] = f"const {self.written['written']}" if self.written else of_struct
        types |= {
            f"d_{name}": type_ for name, type_ in self.types.items() if name not in self.fixed
        } | self.written
        return "/* Its change. */\n" + self.function(f"vary_{self.name}", types, self.vary)

    def function(self, name: str, types: dict[str, str], results: Callable[[], dict[str, Expression]]) -> str:
        """Write one C function."""
        body = of_all_cases(lambda: self.statements(results(), types))
        voids = "".join(f"(void){n};\n" for n in types if not re.search(rf"(?<![.>])\b{n}\b", body))
        declared = ", ".join(f"{type_} {n}" for n, type_ in types.items())
        declared = re.sub(r"(\[\w+\]) (\w+)", r" \2\1", declared)
        return f"static inline {self.result} tdmf_{name}({declared}) {{\n{voids}{body}}}\n"

    def statements(self, results: dict[str, Expression], taken: dict[str, str]) -> str:
        """Write what makes the results, and gives them.

        What the law has given a name is a C variable; what has none stands where it is used.
        """
        roots, variables, lines = list(results.values()), dict(known), list[str]()
        nodes = ordered(roots, known)
        used = {operand for node in nodes if node not in known for operand in node.operands}
        for node in nodes:
            is_result = node in roots and node not in used and roots.count(node) == 1
            if node.operands and node.name and node not in known and node.name not in taken and not is_result:
                lines.append(f"const double {node.name} = {c_text(node, variables.get)};")
                variables[node] = node.name
        texts = {name: c_text(value, variables.get) for name, value in results.items()}
        if self.written:
            lines += [f"{self.member('written', name)} = {text};" for name, text in texts.items()]
        elif "" in texts:
            lines.append(f"return {texts['']};")
        else:
            given = {name: text for name, text in texts.items() if text != "0.0"} or texts
            members = "".join(f".{name} = {text},\n" for name, text in given.items())
            lines += [f"const {self.result} result = {{\n{members}}};", "return result;"]
        return "\n".join(lines) + "\n"
