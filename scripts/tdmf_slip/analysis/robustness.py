"""How hard a runner may be pushed at an apex, and how high a step may be, so that it goes on running."""

import functools
import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass

import numpy as np

from ..library.engine import SETTLED
from ..library.gait import Gait
from ..library.laws import Law
from ..library.section import COORDINATES
from .controlled_gait import check_attracts
from .fates import fates

FARTHEST = 5.0
"""Over the scales: beyond this no disturbance is tried."""
COARSE, REFINEMENTS = 500, 2
"""Tries along the line, and how often the interval between two of them is divided again."""
EDGE_TOLERANCE = 1e-8
"""Relative tolerance of a step there: a stride errs by less than a hundredth of what the tries are apart."""
DISTURBED: Mapping[str, str] = {
    "push_forward": "com_speed",
    "push_backward": "com_speed",
    "step_down": "com_height",
    "step_up": "com_height",
}
"""By disturbance: the coordinate of the section that it changes."""


@dataclass(frozen=True)
class Robustness:
    """The largest disturbances at an apex that a runner is known to recover from, each by itself.

    Infinite where the largest that is tried, `FARTHEST`, is recovered from.
    """

    push_forward: float
    """Of the speed, m/s."""
    push_backward: float
    """Likewise, the other way."""
    step_down: float
    """Of the ground, m: the runner then starts so much higher."""
    step_up: float
    """Likewise, upwards."""

    def as_json(self) -> dict[str, float | None]:
        """The disturbances as a plain object."""
        values: dict[str, float] = asdict(self)
        return {name: value if math.isfinite(value) else None for name, value in values.items()}


def robustness(gait: Gait, law: Law | None = None) -> Robustness:
    """How far the region of attraction reaches from the gait's apex, without gap, in height and speed."""
    check_attracts(gait, law)
    reach = functools.partial(_reach, gait, law)
    return Robustness(
        push_forward=reach("push_forward", 1.0),
        push_backward=reach("push_backward", -1.0),
        step_down=reach("step_down", 1.0),
        step_up=reach("step_up", -1.0),
    )


def _reach(gait: Gait, law: Law | None, disturbance: str, direction: float) -> float:
    """The first disturbance that is not recovered from, between the tries of a line that is refined."""
    index = COORDINATES.index(DISTURBED[disturbance])
    runner = gait.runner
    recovered, lost = 0.0, FARTHEST * runner.scales[index]
    for _ in range(REFINEMENTS):
        tries = np.linspace(recovered, lost, COARSE + 1)[1:]
        starts = np.tile(gait.apex, (COARSE, 1))
        starts[:, index] += direction * tries
        found = fates(runner, gait.apex, starts, tolerance=EDGE_TOLERANCE, law=law)
        fails = np.flatnonzero(found.fate != SETTLED)
        if not fails.size:
            return math.inf
        first = fails[0]
        recovered, lost = tries[first - 1] if first else recovered, tries[first]
    return float(recovered)
