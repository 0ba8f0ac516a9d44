"""What came in the way of a fit's search, and what it took."""

from dataclasses import dataclass, field


@dataclass
class SearchLog:
    """What came in the way of the search."""

    strides: int = 0
    """Made by all rows."""
    lost: int = 0
    """Tries at which a row had no gait."""
    crossed: bool = False
    """The search went on across a fold."""
    words: list[list[str]] = field(default_factory=list)
    """Of each row, those that its gait had, in their order."""
