"""Pieces of the parameters' space: where no event of the stride changes in a way that makes a kink."""

from dataclasses import dataclass, field

from ..library.orbit import Orbit


@dataclass
class Piece:
    """Sequences of events between which nothing has a kink."""

    sequences: set[tuple[object, ...]] = field(default_factory=set)
    """Of the strides, see `Orbit.sequence`."""

    @classmethod
    def of(cls, orbit: Orbit) -> "Piece":
        """That of a gait, as far as is known from it alone."""
        return cls({orbit.sequence})

    def has(self, orbit: Orbit) -> bool:
        """Whether a gait is on it."""
        return orbit.sequence in self.sequences

    def grow(self, orbit: Orbit) -> None:
        """Take in a gait beyond a border at which nothing has a kink."""
        self.sequences.add(orbit.sequence)
