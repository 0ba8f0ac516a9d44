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

    def as_text(self) -> str:
        """A table, and the commands."""
        verdicts = {None: "--long computes it", True: "holds", False: "DOES NOT HOLD"}
        rows = [
            (
                str(number),
                claim.what,
                f"{claim.low:g} to {claim.high:g}",
                "" if claim.computed is None else f"{claim.computed:.5g}",
                verdicts[claim.holds],
            )
            for number, claim in enumerate(self.claims, start=1)
        ]
        commands = [f"{number:>2}  {claim.command}" for number, claim in enumerate(self.claims, start=1)]
        reported = table(
            ["", "what this project says", "stated", f"computed, seed {self.seed}", "verdict"], rows
        )
        return "\n".join([reported, "", *commands])


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
