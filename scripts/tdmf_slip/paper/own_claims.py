"""What this project says of its own, recomputed and held against what is stated."""

from collections.abc import Sequence
from dataclasses import dataclass

from ..contents import ByContents
from ..terminal.progress import progress_bar
from ..terminal.text import table
from .statements.table import CLAIMS


@dataclass(frozen=True)
class Recomputed:
    """A claim beside what it is now."""

    what: str
    """In words."""
    command: str
    """That recomputes it."""
    low: float
    """Least that is stated."""
    high: float
    """Most."""
    computed: float | None
    """Now; None where it was not computed."""

    @property
    def holds(self) -> bool | None:
        """Whether it is within what is stated; None where it was not computed."""
        return None if self.computed is None else self.low <= self.computed <= self.high


@dataclass(frozen=True, eq=False)
class OwnClaims(ByContents):
    """All claims."""

    seed: int
    """Of what is drawn."""
    claims: Sequence[Recomputed]
    """In the order in which they are told."""

    @property
    def passed(self) -> bool:
        """None that was computed is beyond what is stated."""
        return all(claim.holds is not False for claim in self.claims)

    def as_json(self) -> list[dict[str, object]]:
        """All as plain objects."""
        return [
            {
                "claim": claim.what,
                "command": claim.command,
                "interval": [claim.low, claim.high],
                "computed": claim.computed,
                "holds": claim.holds,
            }
            for claim in self.claims
        ]

    def as_text(self, program: str = "tdmf-slip") -> str:
        """A table, and the commands with the name by which `program` is called."""
        header = ["", "what this project says", "stated"]
        rows = [
            [str(number), claim.what, f"{claim.low:g} to {claim.high:g}"]
            for number, claim in enumerate(self.claims, start=1)
        ]
        recomputed = any(claim.computed is not None for claim in self.claims)
        if recomputed:
            header += [f"computed, seed {self.seed}", "verdict"]
            verdicts = {True: "holds", False: "DOES NOT HOLD", None: ""}
            for row, claim in zip(rows, self.claims, strict=True):
                row += [f"{claim.computed:.5g}", verdicts[claim.holds]]
        how = [] if recomputed else [f"{program} validate --long computes all of them; one by one:"]
        commands = [
            f"{number:>2}  {claim.command.replace('tdmf-slip', program, 1)}"
            for number, claim in enumerate(self.claims, start=1)
        ]
        return "\n".join([table(header, rows), *how, "", *commands])


def own_claims(*, recompute: bool = False, seed: int = 1, progress: bool = False) -> OwnClaims:
    """The claims of this project, on request recomputed."""
    found = []
    with progress_bar("claims", len(CLAIMS), "claims", progress and recompute) as bar:
        for claim in CLAIMS:
            computed = claim.compute(seed) if recompute else None
            command = claim.command.replace("{seed}", str(seed))
            found.append(Recomputed(claim.what, command, claim.low, claim.high, computed))
            bar.update()
    return OwnClaims(seed, found)
