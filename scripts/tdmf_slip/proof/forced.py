"""An event that is taken as it would be on one side of a border between gait words.

On the border two things happen at once, and what follows is the same on both sides. The stride of one side,
taken also where it is not what the foot does, is smooth across the border; the border is where a further
number, the margin of the event, vanishes.
"""

from dataclasses import dataclass
from typing import Literal

Kind = Literal["rest at the limit of the cone", "rest as it lifts off", "impact at the limit of the cone"]


@dataclass(frozen=True)
class Forced:
    """Which event, and what is made of it."""

    index: int
    """Index among the stride's events, from 0 on."""
    event: str
    """Its name."""
    kind: Kind
    """Kind of the two events that happen at once there."""
    sign: int = 0
    """Sign of the slip with which a foot at the limit of the cone goes on."""

    @property
    def rival(self) -> str:
        """The guard that vanishes together with the event's; empty for none."""
        return "end of slip" if self.kind == "rest as it lifts off" else ""
