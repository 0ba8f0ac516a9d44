"""How many times longer one runner stays up than another: a factor, with its interval."""

import math
from dataclasses import dataclass

from .first_passage import FirstPassage
from .volume import CONFIDENCE

ENOUGH_FALLS = 30
"""On either side: from fewer, a factor is told by its interval alone."""


@dataclass(frozen=True)
class Factor:
    """The ratio of two mean numbers of strides until the fall."""

    value: float
    """The estimate."""
    interval: tuple[float, float]
    """Of confidence; an end is 0 or infinite where a side has not fallen."""
    falls: tuple[int, int]
    """On either side."""

    @property
    def is_reported(self) -> bool:
        """There are falls enough for the estimate to be printed."""
        return min(self.falls) >= ENOUGH_FALLS

    def __str__(self) -> str:
        """With the interval; from few falls it is all that is told."""
        low, high = self.interval
        ends = f"{low:.3g} to {high:.3g}" if math.isfinite(high) else f"above {low:.3g}"
        few = f" ({self.falls[0]} and {self.falls[1]} falls are too few for more)"
        return f"{self.value:.3g} ({ends})" if self.is_reported else f"{ends}{few}"


def factor_of(longer: FirstPassage, shorter: FirstPassage) -> Factor:
    """How many times longer a runner stays up than another.

    Times between falls are taken as exponential, so that the ratio of the means has an F distribution.
    """
    from scipy import stats  # slow to load

    falls = longer.falls, shorter.falls
    tail = 0.5 * (1.0 - CONFIDENCE)
    strides = longer.strides / shorter.strides
    low, high = 0.0, math.inf
    # Runs end after a given number of strides, not at a fall: the next one may have been about to come.
    if falls[1]:
        more = falls[0] + 1
        low = strides * falls[1] / more / float(stats.f.ppf(1.0 - tail, 2 * more, 2 * falls[1]))
    if falls[0]:
        more = falls[1] + 1
        high = strides * more / falls[0] * float(stats.f.ppf(1.0 - tail, 2 * more, 2 * falls[0]))
    both = falls[0] and falls[1]
    value = longer.mean_strides / shorter.mean_strides if both else (math.inf if falls[1] else math.nan)
    return Factor(value, (low, high), falls)
