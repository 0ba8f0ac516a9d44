"""Log of a fit's search: obstacles and effort."""

from dataclasses import dataclass, field


@dataclass
class SearchLog:
    """Obstacles of the search."""

    strides: int = 0
    """Made by all rows."""
    lost: int = 0
    """Tries at which a row had no gait."""
    crossed: bool = False
    """The search went on across a fold."""
    words: list[list[str]] = field(default_factory=list)
    """Words of each row's gait, in their order."""
