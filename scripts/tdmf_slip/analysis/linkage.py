"""Of many points, those where a search is worth beginning: that have no better one near them.

This is the rule of multi-level single linkage (Rinnooy Kan and Timmer 1987, Mathematical Programming 39,
57-78): within a critical distance of a better point a search would lead into the same basin.
"""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

SIGMA = 4.0
"""From 4 on, finitely many searches are begun, however many points are drawn."""


def linked(points: NDArray[np.float64], merits: NDArray[np.float64]) -> Sequence[int]:
    """Numbers of the points that have none of less merit near them, the least merit first."""
    count = len(merits)
    if not count:
        return []
    dimension = points.shape[1]
    share = min(1.0, SIGMA * math.log(max(count, 2)) / count)
    reach = (math.gamma(1.0 + 0.5 * dimension) * share) ** (1.0 / dimension) / math.sqrt(math.pi)
    order = np.argsort(merits, kind="stable")
    taken = []
    for rank, number in enumerate(order):
        better = points[order[:rank]]
        if not np.any(np.linalg.norm(better - points[number], axis=1) < reach):
            taken.append(int(number))
    return taken
