"""Tables of the page of results, written from stored values: the page shows only computed numbers.

`documentation/write_results` computes the values, stores them, and writes the tables into the page.
"""

import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from .own_claims import Recomputed, own_claims
from .statements.claim import CLAMPED, DEFAULT, HEAVY, HUMAN
from .statements.table import SECTIONS

SEEDS = (1, 2, 3)
TABLE = re.compile(r"(<!-- results: (\w+) -->\n).*?(<!-- end -->)", re.DOTALL)
Stored = Mapping[str, Sequence[Mapping[str, Any]]]
"""Rows of a section by seed."""


def compute(section: str, progress: bool = False) -> Stored:
    """All claims of a section at every seed."""
    return {
        str(seed): own_claims(sections=[section], seed=seed, progress=progress).as_json() for seed in SEEDS
    }


def read(folder: Path, section: str) -> Stored:
    """Read the stored values of a section."""
    stored: Stored = json.loads((folder / f"{section}.json").read_text(encoding="utf-8"))
    return stored


def write(folder: Path, section: str, stored: Stored) -> None:
    """Store the values of a section. Words, commands and verdicts are not stored: the code has them."""
    values = {
        seed: [{"name": row["name"], "regimes": row["regimes"]} for row in rows]
        for seed, rows in stored.items()
    }
    text = json.dumps(values, indent=1)
    (folder / f"{section}.json").write_text(text + "\n", encoding="utf-8")


def recomputed(section: str, stored: Stored, seed: int) -> list[Recomputed]:
    """The claims of a section with their values at a seed."""
    rows = {row["name"]: row for row in stored[str(seed)]}
    return [Recomputed.of_json(claim, rows[claim.name]) for claim in SECTIONS[section]]


def filled(page: str, folder: Path, sections: Sequence[str] = tuple(SECTIONS)) -> str:
    """The page with the tables of the sections, which show the stored numbers of the first seed."""

    def tables(match: re.Match[str]) -> str:
        section = match[2]
        if section not in sections:
            return match[0]
        return match[1] + _markdown(recomputed(section, read(folder, section), SEEDS[0])) + match[3]

    return TABLE.sub(tables, page)


def _markdown(claims: Sequence[Recomputed]) -> str:
    others = (CLAMPED, HEAVY, HUMAN)
    header = ["claim", f"{DEFAULT.title}: value", "control", *(regime.title for regime in others)]
    rows = []
    for number, one in enumerate(claims, start=1):
        default = one.rows[DEFAULT.name]
        control = "" if default.control is None else str(default.control)
        said = f'<a id="{one.claim.name}"></a>{number}. {one.claim.what}'
        rows.append([said, str(default.value), control, *(str(one.rows[regime.name]) for regime in others)])
    code = commands_block([one.claim.command for one in claims]).replace("{seed}", str(SEEDS[0]))
    return f"{markdown_table(header, rows)}\n\n{code}\n"


def markdown_table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table of Markdown."""
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def commands_block(commands: Sequence[str]) -> str:
    """The commands of numbered rows, each once, under the numbers of its rows."""
    numbers: dict[str, list[str]] = {}
    for number, command in enumerate(commands, start=1):
        numbers.setdefault(command, []).append(str(number))
    listed = [f"# {', '.join(rows)}\n{command}" for command, rows in numbers.items()]
    return "\n".join(["```sh", *listed, "```"])
