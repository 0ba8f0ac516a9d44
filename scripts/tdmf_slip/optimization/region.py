"""Regions of the parameters' space: where no event of the stride changes in a way that makes a kink."""

from dataclasses import dataclass, field

from ..library.gait import Gait


@dataclass
class Region:
    """Sequences of events between which nothing has a kink."""

    sequences: set[tuple[object, ...]] = field(default_factory=set)
    """Of the strides, see `Gait.sequence`."""

    @classmethod
    def of(cls, gait: Gait) -> "Region":
        """That of a gait, as far as is known from it alone."""
        return cls({gait.sequence})

    def has(self, gait: Gait) -> bool:
        """Whether a gait is on it."""
        return gait.sequence in self.sequences

    def grow(self, gait: Gait) -> None:
        """Take in a gait beyond a border at which nothing has a kink."""
        self.sequences.add(gait.sequence)
