"""The directive `c-header`: all that one public header of the C library declares, from the header itself.

Not by Doxygen and its bridge, which show structs without names inside structs as `@0` and want another kind
of comment: here a C parser reads the headers as they are, for the compiler and the reader alike.
"""

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from c_headers import FOLDER, INDENT, Entry, Header, headers
from docutils import nodes
from docutils.statemachine import StringList
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective

ROOT = Path(__file__).parents[2]
SPECIAL = re.compile(r"([\\*`|_<>\[\]])")
NAME = re.compile(r"\b(tdmf_\w+\b(?!\.h)|TDMF_[A-Z_0-9]+)")
CODE = re.compile(r"`([^`]+)`")


@cache
def _sources() -> dict[str, str]:
    return {
        str(path.relative_to(ROOT)): path.read_text(encoding="utf-8")
        for path in sorted((ROOT / "c_core").rglob("*.c*"))
        if path.suffix in (".c", ".in")
    }


def defined_in(name: str) -> str:
    """File and line of a function's definition."""
    definition = re.compile(rf"^(?! )[\w *]*\b{name}\([^;{{]*\{{", re.MULTILINE)
    for path, text in _sources().items():
        found = definition.search(text)
        if found:
            return f"{path}, line {text.count(chr(10), 0, found.start()) + 1}"
    raise ExtensionError(f"{name}: declared, but defined nowhere")


@cache
def _known() -> set[str]:
    """Names that have a place in the reference."""
    entries = [entry for header in headers().values() for entry in header.entries]
    return {e.name for e in entries if e.name} | {
        m.name for e in entries if e.kind == "enum" for m in e.members
    }


def marked_up(comment: str) -> list[str]:
    """A comment as reStructuredText, by lines: names of the library are links, all else is as it is."""
    lines = []
    for paragraph in comment.split("\n\n"):
        if paragraph.startswith(INDENT):
            lines += ["::", "", *paragraph.split("\n"), ""]
            continue
        parts = CODE.split(paragraph)
        text = "".join(f"``{part}``" if i % 2 else _linked(part) for i, part in enumerate(parts))
        lines += [re.sub(r"``([\w(])", r"`` \1", text) if "```" in text else text, ""]
    return lines


def _linked(text: str) -> str:
    parts = NAME.split(text)
    return "".join(
        f"\\ :c:expr:`{part}`\\ " if i % 2 and part in _known() else SPECIAL.sub(r"\\\1", part)
        for i, part in enumerate(parts)
    )


class CHeader(SphinxDirective):
    """All declarations of a header."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Functions and types, each with its comment and where it stands."""
        known = headers()
        header = known.get(self.arguments[0])
        if header is None:
            raise ExtensionError(f"c-header {self.arguments[0]}: allowed: {', '.join(known)}")
        if header.undocumented or not header.comment:
            raise ExtensionError(
                f"{header.name}: no comment tells of {', '.join(header.undocumented) or 'it'}"
            )
        self.env.note_dependency(str(FOLDER / header.name))
        shown = self.env.metadata[self.env.docname].setdefault("c_headers", "")
        self.env.metadata[self.env.docname]["c_headers"] = f"{shown} {header.name}"
        lines = StringList(
            ["````{eval-rst}", *_lines(header), "````"], source=str(FOLDER / header.name)
        )  # pages are MyST
        around = nodes.container()
        self.state.nested_parse(lines, self.content_offset, around)
        return around.children


def _lines(header: Header) -> Iterator[str]:
    yield from ["``#include <tdmf_slip/" + header.name + ">``", ""]
    yield from marked_up(header.comment)
    for entry in header.entries:
        yield from _of_entry(header, entry)


def _of_entry(header: Header, entry: Entry) -> Iterator[str]:
    directive = f"c:{entry.kind}" if entry.name or entry.kind != "enum" else ""
    indent = "   "
    if directive:
        yield from [f".. {directive}:: {entry.text or entry.name}", ""]
    else:
        yield from [f".. c:enum:: @{entry.members[0].name.lower()}", ""]
    yield from (indent + line if line else "" for line in marked_up(entry.comment))
    for member in entry.members:
        if entry.kind == "enum":
            yield from [f"{indent}.. c:enumerator:: {member.text}", ""]
            yield from (2 * indent + line if line else "" for line in marked_up(member.comment))
        else:
            yield from [f"{indent}``{member.text}``"]
            yield from (2 * indent + line if line else "" for line in marked_up(member.comment))
    location = (
        f"c\\_core/include/tdmf\\_slip/{SPECIAL.sub(chr(92) * 2 + r'1', header.name)}, line {entry.line}"
    )
    if entry.kind == "function":
        location += f"; defined in {SPECIAL.sub(chr(92) * 2 + r'1', defined_in(entry.name))}"
    yield from [f"{indent}.. container:: source-place", "", f"{indent}   {location}", ""]


def check_all_shown(app: Sphinx, env: object) -> None:
    """Every public header is on a page."""
    shown = {name for data in app.env.metadata.values() for name in str(data.get("c_headers", "")).split()}
    missing = set(headers()) - shown
    if missing and shown:
        raise ExtensionError(f"on no page of the reference: {', '.join(sorted(missing))}")


def setup(app: Sphinx) -> dict[str, bool]:
    """Tell Sphinx of the directive."""
    app.add_directive("c-header", CHeader)
    app.connect("env-check-consistency", check_all_shown)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
