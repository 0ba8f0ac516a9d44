"""Where strides are followed from, and how finely."""

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb

DEGREE_PER_BIT = 0.36
"""The best degree grows with the precision: N^2 10^(d/N) is least at N = 1.15 d for d digits."""


@dataclass(frozen=True)
class Fineness:
    """How finely a motion is followed."""

    bits: int
    """Bits of the working precision."""

    @property
    def degree(self) -> int:
        """Degree of a step's polynomials at which the work of a stride is least."""
        return max(12, round(DEGREE_PER_BIT * self.bits))


@dataclass(frozen=True)
class Starts:
    """A set of apexes, and of values of what is varied."""

    centre: Sequence[arb]
    """Points, shape (6,) or with what is varied (7,)."""
    radii: Sequence[arb]
    """Around them."""
    tilt: Sequence[arb] = ()
    """Points: by how much the centre moves for each unit of what is varied, shape (6,) or none."""

    def balls(self) -> list[arb]:
        """All of them."""
        found = [c + arb(0, r) for c, r in zip(self.centre, self.radii, strict=True)]
        for i, slope in enumerate(self.tilt):
            found[i] += slope * arb(0, self.radii[6])
        return found
