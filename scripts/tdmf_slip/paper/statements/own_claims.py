"""All claims by section of the page of results, in the order of the page, and their values in every regime.

`claims.toml` has what each claim says and the relations that must hold; the modules beside it compute.
"""

import importlib.resources
import textwrap
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ...terminal.progress import progress_bar
from ...terminal.text import table
from . import gaits, regions, rough_ground
from .claim import DEFAULT, REGIMES, Cell, Estimate, Measures, OwnClaim, Row, Rows

TEXTS = tomllib.loads(importlib.resources.files(__package__).joinpath("claims.toml").read_text("utf-8"))
MEASURES: Measures = gaits.MEASURES | regions.MEASURES | rough_ground.MEASURES
SECTIONS = {
    section: tuple(
        OwnClaim(name, text["claim"], text["command"], text["holds"], *MEASURES[name])
        for name, text in texts.items()
    )
    for section, texts in TEXTS.items()
}
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
        """True if the claim holds."""
        return self.claim.holds(self.rows)

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
        return cls(claim, rows)


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
        """True if all claims hold."""
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
            rows = {regime.name: claim.row(regime, seed) for regime in REGIMES}
            found.append(Recomputed(claim, rows))
            bar.update()
    return OwnClaims(seed, found)
