"""A published statement beside computed results for both readings of the swing law (12)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import Enum

from ..record import entries

PAPER = "Or and Moravia 2016"
WORDS: Mapping[float, str] = {10.0: "0+", 1.2: "+0+", 0.6: "+0-0+", 0.43: "+0-", 0.2: "+-"}
"""Friction and gait word of the periodic solutions in the paper's figures 5 to 8."""
FREE, CLAMP = "free swing", "clamp"
READINGS: Mapping[str, bool] = {FREE: False, CLAMP: True}
"""Value of `hip.swing_clamp` by reading; the first is the default."""


class Group(Enum):
    """Groups of the paper's statements, with their headings."""

    AGREES = "Agrees in both readings"
    CORRECTION = "Depends on a correction of the print: (11) -tau0 for +tau0; (12) no clamp, or max for min"
    BEYOND = "Beyond what the paper could compute"
    DIFFERS = "Differs in both readings, and no correction of the print explains it"


@dataclass(frozen=True)
class Finding:
    """Computed result for one reading, and whether it agrees."""

    text: str
    """Numbers, with a few words."""
    agrees: bool
    """True if the result agrees with the published statement."""


@dataclass(frozen=True)
class Claim:
    """One published statement beside the computed ones."""

    what: str
    """Quantity or property."""
    published: str
    """Published words or number."""
    computed: Mapping[str, Finding]
    """Findings by reading."""
    where: str = ""
    """Section of the paper."""
    source: str = PAPER
    """Paper that makes the statement."""
    misprint: bool = False
    """True if the statement is about a formula as it is printed."""
    beyond: bool = False
    """True if the paper says that it could not compute this."""

    @property
    def group(self) -> Group:
        """Group of the statement."""
        agrees = {finding.agrees for finding in self.computed.values()}
        if self.beyond:
            return Group.BEYOND
        if self.misprint or len(agrees) > 1:
            return Group.CORRECTION
        return Group.AGREES if agrees == {True} else Group.DIFFERS

    @property
    def verdict(self) -> str:
        """The verdict in a few words."""
        if self.group is Group.BEYOND:
            return "computed here"
        if self.misprint:
            return "misprint"
        agreeing = [reading for reading, finding in self.computed.items() if finding.agrees]
        if not agreeing:
            return "differs"
        return "agrees" if len(agreeing) == len(self.computed) else f"agrees: {agreeing[0]} only"

    def as_json(self) -> dict[str, object]:
        """The statement as a plain object."""
        return {
            **entries(self, "source", "where", "what", "published"),
            "computed": {
                reading: {"text": finding.text, "agrees": bool(finding.agrees)}
                for reading, finding in self.computed.items()
            },
            "group": self.group.name.lower(),
            "verdict": self.verdict,
        }


def both_readings(text: str, agrees: bool) -> dict[str, Finding]:
    """One finding for both readings, if the result does not depend on the swing."""
    return {reading: Finding(text, agrees) for reading in READINGS}


def of_group(claims: Sequence[Claim], group: Group) -> list[Claim]:
    """The statements of one group, in their order."""
    return [claim for claim in claims if claim.group is group]
