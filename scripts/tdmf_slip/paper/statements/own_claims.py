"""All claims by section of the page of results, in the order of the page, and their values in every regime.

`claims.toml` has what each claim says and the relations that must hold; the modules beside it compute.
"""

import importlib.resources
import textwrap
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import astuple, dataclass
from typing import Any

from ...errors import counted
from ...terminal.progress import progress_bar
from ...terminal.text import table
from . import gaits, regions, rough_ground
from .claim import DEFAULT, REGIMES, Estimate, Measures, OwnClaim, Row, Rows

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
    seed: int
    """Seed of the random numbers."""
    rows: Rows
    """Values and controls by name of the regime."""

    @property
    def holds(self) -> bool:
        """True if the claim holds."""
        return self.claim.holds(self.rows)

    def as_json(self) -> dict[str, object]:
        """The claim as a plain object; a number is [value, low, high]."""
        regimes = {
            name: {
                of: list(astuple(cell)) if isinstance(cell, Estimate) else cell
                for of, cell in vars(row).items()
            }
            for name, row in self.rows.items()
        }
        about = {"name": self.claim.name, "claim": self.claim.what, "command": self.claim.command}
        return {**about, "holds": self.holds, "regimes": regimes}

    @classmethod
    def of_json(cls, claim: OwnClaim, seed: int, stored: Mapping[str, Any]) -> "Recomputed":
        """The claim with stored numbers."""

        def read(cell: Any) -> Any:
            return Estimate(*map(float, cell)) if isinstance(cell, list) else cell

        regimes = stored["regimes"].items()
        return cls(claim, seed, {name: Row(*map(read, cells.values())) for name, cells in regimes})

    def as_text(self, number: int, program: str) -> str:
        """The claim with its verdict, value and control by regime, and the command, called as `program`."""
        said = textwrap.fill(f"{number}. {self.claim.what}", 96, subsequent_indent="   ")
        head = ["regime", "value" if self.rows[DEFAULT.name].control is None else "value / control"]
        rows = [[regime.title, str(self.rows[regime.name])] for regime in REGIMES]
        verdict = "holds" if self.holds else "DOES NOT HOLD"
        command = self.claim.command.replace("tdmf-slip", program, 1).replace("{seed}", str(self.seed))
        return f"{said}\n{textwrap.indent(table(head, rows), '   ')}\n   {verdict}: {command}"


def text_of(claims: Sequence[Recomputed], program: str) -> str:
    """Number of claims that hold, and each claim with its numbers; nothing without any."""
    if not claims:
        return ""
    count, seed = sum(one.holds for one in claims), claims[0].seed
    held = f"{count} of {counted(len(claims), 'claim')} of this project hold at seed {seed}."
    return "\n\n".join([held, *(one.as_text(number, program) for number, one in enumerate(claims, start=1))])


def own_claims(
    *, sections: Sequence[str] = tuple(SECTIONS), seed: int = 1, progress: bool = False
) -> list[Recomputed]:
    """The claims of this project, computed in every regime, in the order of the page."""
    chosen, found = [claim for section in sections for claim in SECTIONS[section]], []
    with progress_bar("claims", len(chosen), "claims", progress) as bar:
        for claim in chosen:
            rows = {regime.name: claim.row(regime, seed) for regime in REGIMES}
            found.append(Recomputed(claim, seed, rows))
            bar.update()
    return found
