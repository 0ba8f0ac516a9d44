"""Mode and motion that an event leads to."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from .dual import Number
from .modes import Mode


@dataclass
class Entered:
    """The mode that an event leads to."""

    mode: Mode
    """After the event and what follows it at the same instant."""
    values: dict[str, Number]
    """Numbers of the motion, by the names of the mode."""
    zeros: Mapping[str, int] = field(default_factory=dict)
    """By guard: to which order in time it begins at exactly zero."""
    closes: bool = False
    """A stride ends here, at an apex in flight."""
    impact: bool = False
    """The foot came down."""
    margin: Number | None = None
    """Margin of an event that is forced: zero on the border."""
