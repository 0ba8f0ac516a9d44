"""Declarations of the C library's public headers, with their comments.

The headers are plain C99 with plain comments. A comment documents what follows it without an empty line, and
what stands before it on the same line; the first comment of a header documents the header.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from pycparser import c_ast, c_generator, c_parser

FOLDER = Path(__file__).parents[2] / "c_core/include/tdmf_slip"
TYPES = "".join(
    f"typedef int {name};" for name in ("bool", "size_t", "int32_t", "int64_t", "uint32_t", "uint64_t")
)
"""Types of the standard headers, which the parser does not read."""
INDENT = " " * 4
"""Beginning of each line of code in a comment."""
COMMENT = re.compile(r"/\*(.*?)\*/", re.DOTALL)
FOR_CPLUSPLUS = re.compile(r'#ifdef __cplusplus\n(extern "C" \{|\})\n#endif')
INCLUDE = re.compile(r'#include "tdmf_slip/([\w/]+\.h)"')
MACRO = re.compile(r"^#define (TDMF_\w+) (\S+)", re.MULTILINE)
WRITTEN = c_generator.CGenerator()


@dataclass(frozen=True)
class Member:
    """A member of a struct, or an enumerator."""

    name: str
    """Name, after the names of the structs around it, as in `leg.stiffness`."""
    text: str
    """Declaration; for an enumerator, with its value where one is given."""
    comment: str


@dataclass(frozen=True)
class Entry:
    """A declaration."""

    kind: str
    """function, struct, enum, type or macro."""
    name: str
    """Empty for an enumeration without one."""
    text: str
    line: int
    comment: str
    members: tuple[Member, ...] = ()

    @property
    def undocumented(self) -> Iterator[str]:
        """Names of what no comment tells of."""
        if not self.comment:
            yield self.name or self.members[0].name
        for member in self.members:
            if not member.comment:
                yield f"{self.name}: {member.name}".strip(": ")


@dataclass
class Header:
    """One public header."""

    name: str
    comment: str = ""
    entries: list[Entry] = field(default_factory=list)

    @property
    def undocumented(self) -> list[str]:
        """Names of what no comment tells of."""
        return [name for entry in self.entries for name in entry.undocumented]


def _paragraph(text: str) -> str:
    """A paragraph in one line; one that is indented is code, and keeps its lines."""
    lines = text.rstrip().strip("\n").split("\n")
    return "\n".join(lines) if all(line.startswith(INDENT) for line in lines) else " ".join(text.split())


class _Comments:
    """Comments of a text by line, and the text without them, its lines where they were."""

    def __init__(self, text: str) -> None:
        self.before: dict[int, str] = {}
        self.beside: dict[int, str] = {}
        self.last_lines: dict[int, int] = {}
        self.ends: set[int] = set()
        for found in COMMENT.finditer(text):
            line = text.count("\n", 0, found.start()) + 1
            end = line + found[0].count("\n")
            words = re.sub(r"^ *\* ?", "", found[1], flags=re.MULTILINE)
            paragraphs = map(_paragraph, words.split("\n\n"))
            comment = "\n\n".join(part for part in paragraphs if part)
            alone = not text[text.rfind("\n", 0, found.start()) + 1 : found.start()].strip()
            (self.before if alone else self.beside)[end if alone else line] = comment
            if not alone:
                self.ends.update(range(line, end + 1))
        blank = COMMENT.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)
        self.code = [line.strip() for line in blank.split("\n")]

    def of(self, line: int, *, beside: bool = True) -> str:
        """Comment on the declaration that begins on a line: above it or, with `beside`, on the same line."""
        if beside and line in self.beside:
            return self.beside[line]
        while True:
            line -= 1
            if line in self.before:
                return self.before[line]
            is_sibling = line > 0 and (self.code[line - 1] or line in self.ends)
            if not is_sibling or self.code[line - 1].endswith("{"):
                return ""


def _without_preprocessor(text: str) -> str:
    def blank(found: re.Match[str]) -> str:
        return "\n" * found[0].count("\n")

    text = COMMENT.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)
    text = FOR_CPLUSPLUS.sub(blank, text)
    return re.sub(r"^#.*$|^TDMF_API ", "", text, flags=re.MULTILINE)


def _in_order(folder: Path) -> list[str]:
    """Names of all headers, each after those that it includes."""
    names: list[str] = []

    def visit(name: str) -> None:
        if name not in names:
            for included in INCLUDE.findall((folder / name).read_text(encoding="utf-8")):
                visit(included)
            names.append(name)

    for path in sorted(folder.glob("*.h")):
        visit(path.name)
    return names


@cache
def headers(folder: Path = FOLDER) -> dict[str, Header]:
    """Public headers by name."""
    names = _in_order(folder)
    texts = {name: (folder / name).read_text(encoding="utf-8") for name in names}
    whole = "".join(f'\n# 1 "{name}"\n{_without_preprocessor(text)}' for name, text in texts.items())
    tree = c_parser.CParser().parse(TYPES + whole, "types")
    found = {}
    for name, text in texts.items():
        comments = _Comments(text)
        first = COMMENT.search(text)
        header = found[name] = Header(name)
        if first and text[: first.start()].strip() in ("", f"#ifndef TDMF_SLIP_{name[:-2].upper()}_H"):
            header.comment = comments.before[text.count("\n", 0, first.end()) + 1]
        nodes = [node for node in tree.ext if node.coord and node.coord.file == name]
        starts = _starts(_without_preprocessor(text))
        assert len(nodes) == len(starts), f"{name}: {len(nodes)} declarations begin on {len(starts)} lines"
        header.entries += [_entry(node, line, comments) for node, line in zip(nodes, starts, strict=True)]
        macros = {macro[1]: macro.start() for macro in reversed([*MACRO.finditer(text)])}  # the first of each
        for macro, start in macros.items():
            line = text.count("\n", 0, start) + 1
            header.entries.append(Entry("macro", macro, macro, line, comments.of(line)))
        header.entries.sort(key=lambda entry: entry.line)
    return found


def _starts(code: str) -> list[int]:
    """Lines on which the declarations begin."""
    starts, depth, inside, line = [], 0, False, 1
    for character in code:
        if character == "\n":
            line += 1
        elif not character.isspace() and not inside:
            inside = True
            starts.append(line)
        depth += {"{": 1, "}": -1}.get(character, 0)
        if character == ";" and depth == 0:
            inside = False
    return starts


def _entry(node: c_ast.Node, line: int, comments: _Comments) -> Entry:
    inner = node.type.type if isinstance(node.type, c_ast.TypeDecl) else node.type
    has_members = isinstance(inner, c_ast.Enum) or (isinstance(inner, c_ast.Struct) and bool(inner.decls))
    comment = comments.of(line, beside=not has_members)  # beside it stands what is said of a member
    if isinstance(inner, c_ast.Enum):
        members = tuple(_enumerators(inner, comments))
        return Entry("enum", getattr(node, "name", None) or "", "", line, comment, members)
    if isinstance(inner, c_ast.Struct) and inner.decls:
        return Entry("struct", node.name, node.name, line, comment, tuple(_members(inner, comments)))
    text = " ".join(WRITTEN.visit(node).split())
    kind = "function" if isinstance(node.type, c_ast.FuncDecl) else "type"
    return Entry(kind, node.name, text.removeprefix("typedef "), line, comment)


def _enumerators(enum: c_ast.Enum, comments: _Comments) -> Iterator[Member]:
    for item in enum.values.enumerators:
        value = f" = {WRITTEN.visit(item.value)}" if item.value is not None else ""
        comment = comments.of(item.coord.line)
        comment = comment or ("How many there are." if item.name.endswith("_COUNT") else "")
        yield Member(item.name, f"{item.name}{value}", comment)


def _members(struct: c_ast.Struct, comments: _Comments, outer: str = "") -> Iterator[Member]:
    for declared in struct.decls:
        inner = declared.type.type if isinstance(declared.type, c_ast.TypeDecl) else None
        name = f"{outer}{declared.name}"
        if isinstance(inner, c_ast.Struct) and inner.decls:
            yield from _members(inner, comments, f"{name}.")
        else:
            written = " ".join(WRITTEN.visit(declared).split())
            text = re.sub(rf"\b{declared.name}\b", name, written, count=1)
            yield Member(name, text, comments.of(declared.coord.line))
