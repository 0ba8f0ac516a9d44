"""Tables of the page of results, written from stored values: the page shows only computed numbers.

`documentation/write_results` computes the values, stores them, and writes the tables into the page.
"""

import json
import re
import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..errors import RunError
from ..terminal.progress import progress_bar
from ..terminal.text import table
from .statements.claim import CLAMPED, DEFAULT, HEAVY, HUMAN, REGIMES, Cell, Estimate, OwnClaim, Row, Rows
from .statements.table import SECTIONS

LAST_SEED = 2**62 - 1
"""Largest seed: claims draw from up to three times a seed, and `volume` takes seeds up to 2**63."""


@dataclass(frozen=True, eq=False)
class Recomputed:
    """A claim with its values in every regime."""

    claim: OwnClaim
    """The claim."""
    rows: Rows
    """Values and controls by name of the regime."""

    @property
    def holds(self) -> bool:
        """Whether the claim is true; false if it needs a number that does not exist."""
        try:
            return self.claim.check.holds(self.rows)
        except RunError:
            return False

    def as_json(self) -> dict[str, object]:
        """The claim as a plain object; a number is [value, low, high]."""
        return {
            "name": self.claim.name,
            "claim": self.claim.what,
            "command": self.claim.command,
            "holds": self.holds,
            "regimes": {
                name: {"value": _plain(row.value), "control": _plain(row.control)}
                for name, row in self.rows.items()
            },
        }

    @classmethod
    def of_json(cls, claim: OwnClaim, stored: Mapping[str, Any]) -> "Recomputed":
        """The claim with stored numbers."""
        regimes = stored["regimes"].items()
        rows = {name: Row(_read(cells["value"]), _read(cells["control"])) for name, cells in regimes}
        return cls(claim, Rows(rows))


def _plain(cell: Cell | None) -> object:
    return [cell.value, cell.low, cell.high] if isinstance(cell, Estimate) else cell


def _read(cell: Any) -> Any:
    return Estimate(*map(float, cell)) if isinstance(cell, list) else cell


@dataclass(frozen=True, eq=False)
class OwnClaims:
    """Claims of this project with their values at one seed."""

    seed: int
    """Seed of the random numbers."""
    claims: Sequence[Recomputed]
    """Claims in the order of the page."""

    @property
    def passed(self) -> bool:
        """Whether all of them hold."""
        return all(claim.holds for claim in self.claims)

    def as_json(self) -> list[dict[str, object]]:
        """The claims as plain objects."""
        return [claim.as_json() for claim in self.claims]

    def as_text(self, program: str = "tdmf-slip") -> str:
        """Each claim with its verdict, value and control by regime, and the command, called as `program`."""
        count = sum(one.holds for one in self.claims)
        parts = [f"{count} of {len(self.claims)} claims of this project hold at seed {self.seed}."]
        for number, one in enumerate(self.claims, start=1):
            verdict = "holds" if one.holds else "DOES NOT HOLD"
            said = textwrap.fill(f"{number}. {one.claim.what}", 96, subsequent_indent="   ")
            head = ["regime", "value" if one.rows[DEFAULT.name].control is None else "value / control"]
            rows = [[regime.title, str(one.rows[regime.name])] for regime in REGIMES]
            command = one.claim.command.replace("tdmf-slip", program, 1).replace("{seed}", str(self.seed))
            numbers = textwrap.indent(table(head, rows), "   ")
            parts.append(f"{said}\n{numbers}\n   {verdict}: {command}")
        return "\n\n".join(parts)


def own_claims(
    *, sections: Sequence[str] = tuple(SECTIONS), seed: int = 1, progress: bool = False
) -> OwnClaims:
    """The claims of this project, computed in every regime."""
    chosen = [claim for section in sections for claim in SECTIONS[section]]
    found = []
    with progress_bar("claims", len(chosen), "claims", progress) as bar:
        for claim in chosen:
            rows = Rows({regime.name: claim.row(regime, seed) for regime in REGIMES})
            found.append(Recomputed(claim, rows))
            bar.update()
    return OwnClaims(seed, found)


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
