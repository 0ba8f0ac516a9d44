"""Tables of the page of results, written from stored values: the page shows only computed numbers.

`documentation/write_results` computes the values, stores them, and writes the tables into the page.
"""

import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from .claims import CLAMP, FREE, Group
from .human_running import fit_rows
from .statements.claim import CLAMPED, DEFAULT, HEAVY, HUMAN
from .statements.own_claims import SECTIONS, Recomputed, own_claims
from .validation import validate

SEEDS = (1, 2, 3)
PAPERS = "papers"
"""Name of the stored values of published statements; all others are named as their section."""
NAMES = (*SECTIONS, PAPERS)
TABLE = re.compile(r"(<!-- results: (\w+) -->\n).*?(<!-- end -->)", re.DOTALL)
Rows = Sequence[Mapping[str, Any]]
Stored = Mapping[str, Rows]
"""Rows of a section by seed, or rows of published statements by table."""


def compute(name: str, progress: bool = False) -> Stored:
    """All claims of a section at every seed, or the statements of all papers and the claims about the fit.

    Words, commands and verdicts of our own claims are not stored: the code has them.
    """
    if name == PAPERS:
        found = validate(progress=progress)
        statements, others = ([claim.as_json() for claim in of] for of in (found.claims, found.others))
        return {"statements": statements, "others": others, "fit": fit_rows()}
    own = {seed: own_claims(sections=[name], seed=seed, progress=progress) for seed in SEEDS}
    return {
        str(seed): [{"name": one.claim.name, "regimes": one.as_json()["regimes"]} for one in claims]
        for seed, claims in own.items()
    }


def read(folder: Path, name: str) -> Stored:
    """Read stored values."""
    stored: Stored = json.loads((folder / f"{name}.json").read_text(encoding="utf-8"))
    return stored


def write(folder: Path, name: str, stored: Stored) -> None:
    """Store values."""
    text = json.dumps(stored, indent=1, ensure_ascii=False)
    (folder / f"{name}.json").write_text(text + "\n", encoding="utf-8")


def filled(page: str, folder: Path) -> str:
    """The page with its tables; those of sections show the stored numbers of the first seed."""
    tables = {name: _section(recomputed(name, read(folder, name), SEEDS[0])) for name in SECTIONS}
    papers = read(folder, PAPERS)
    tables |= {name: make(papers[name]) for name, make in PAPER_TABLES.items()}
    return TABLE.sub(lambda match: f"{match[1]}{tables[match[2]]}\n{match[3]}", page)


def recomputed(section: str, stored: Stored, seed: int) -> list[Recomputed]:
    """The claims of a section with their values at a seed."""
    rows = {row["name"]: row for row in stored[str(seed)]}
    return [Recomputed.of_json(claim, seed, rows[claim.name]) for claim in SECTIONS[section]]


def _section(claims: Sequence[Recomputed]) -> str:
    others = (CLAMPED, HEAVY, HUMAN)
    header = ["claim", f"{DEFAULT.title}: value", "control", *(regime.title for regime in others)]
    rows = []
    for number, one in enumerate(claims, start=1):
        default = one.rows[DEFAULT.name]
        control = "" if default.control is None else str(default.control)
        said = f'<a id="{one.claim.name}"></a>{number}. {one.claim.what}'
        rows.append([said, str(default.value), control, *(str(one.rows[regime.name]) for regime in others)])
    code = commands_block([one.claim.command for one in claims]).replace("{seed}", str(SEEDS[0]))
    return f"{markdown_table(header, rows)}\n\n{code}"


def _statements(claims: Rows) -> str:
    """Number of the paper's statements in each group, and which these are."""
    rows = []
    for group in Group:
        chosen = [claim["what"] for claim in claims if claim["group"] == group.name.lower()]
        rows.append([group.value, str(len(chosen)), "; ".join(chosen)])
    return markdown_table(["group", "statements", "about"], rows)


def _others(claims: Rows) -> str:
    """Statements of other papers; the finding with the clamp is shown where it differs."""
    rows = []
    for claim in claims:
        free, clamp = (claim["computed"][reading]["text"] for reading in (FREE, CLAMP))
        computed = free if free == clamp else f"{free}; with the clamp {clamp}"
        rows.append([claim["source"], claim["what"], claim["published"], computed, claim["verdict"]])
    return markdown_table(["source", "statement", "published", "computed", "verdict"], rows)


def _fit(rows: Rows) -> str:
    cells = [
        [f"{number}. {row['claim']}", row["value"], row["control"]] for number, row in enumerate(rows, 1)
    ]
    commands = commands_block([row["command"] for row in rows])
    return f"{markdown_table(['claim', 'value', 'control'], cells)}\n\n{commands}"


PAPER_TABLES = {"statements": _statements, "others": _others, "fit": _fit}
"""Tables of published statements by name."""


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
