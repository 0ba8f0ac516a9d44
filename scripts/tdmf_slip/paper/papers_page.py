"""Tables of the page of results about published statements, written from stored values.

`documentation/write_papers` computes the values, stores them, and writes the tables into the page.
"""

import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from .claims import CLAMP, FREE, Group
from .human_running import fit_rows
from .results_page import commands_block, markdown_table
from .validation import validate

TABLE = re.compile(r"(<!-- papers: (\w+) -->\n).*?(<!-- end -->)", re.DOTALL)
Stored = Mapping[str, Sequence[Mapping[str, Any]]]
"""Rows by table."""


def compute() -> Stored:
    """Statements of all papers with their findings, and the claims about the human fit."""
    found = validate(progress=True)
    return {
        "statements": [claim.as_json() for claim in found.claims],
        "others": [claim.as_json() for claim in found.others],
        "fit": [row._asdict() for row in fit_rows()],
    }


def read(path: Path) -> Stored:
    """Read the stored values."""
    stored: Stored = json.loads(path.read_text(encoding="utf-8"))
    return stored


def write(path: Path, stored: Stored) -> None:
    """Store the values."""
    path.write_text(json.dumps(stored, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


def filled(page: str, stored: Stored) -> str:
    """The page with its tables of published statements."""
    tables = {
        "statements": _statements(stored["statements"]),
        "others": _others(stored["others"]),
        "fit": _fit(stored["fit"]),
    }
    return TABLE.sub(lambda match: f"{match[1]}{tables[match[2]]}\n{match[3]}", page)


def _statements(claims: Sequence[Mapping[str, Any]]) -> str:
    """How many statements of the paper are in each group, and which."""
    rows = []
    for group in Group:
        chosen = [claim["what"] for claim in claims if claim["group"] == group.name.lower()]
        rows.append([group.value, str(len(chosen)), "; ".join(chosen)])
    return markdown_table(["group", "statements", "about"], rows)


def _others(claims: Sequence[Mapping[str, Any]]) -> str:
    rows = [
        [claim["source"], claim["what"], claim["published"], _computed(claim["computed"]), claim["verdict"]]
        for claim in claims
    ]
    return markdown_table(["source", "statement", "published", "computed", "verdict"], rows)


def _computed(findings: Mapping[str, Mapping[str, str]]) -> str:
    """The finding of the default, with that of the clamp where it is another."""
    free, clamp = findings[FREE]["text"], findings[CLAMP]["text"]
    return free if free == clamp else f"{free}; with the clamp {clamp}"


def _fit(rows: Sequence[Mapping[str, str]]) -> str:
    cells = [
        [f"{number}. {row['claim']}", row["value"], row["control"]]
        for number, row in enumerate(rows, start=1)
    ]
    commands = commands_block([row["command"] for row in rows])
    return f"{markdown_table(['claim', 'value', 'control'], cells)}\n\n{commands}"
