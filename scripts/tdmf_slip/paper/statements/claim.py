"""A claim of this project, and the gaits that several of them are of."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

from ...analysis.comparison import compare
from ...analysis.search import periodic_gait
from ...fmu.fmu import FRICTION
from ...library.gait import Gait

TORQUE, ANGLE, THRUST = "hip.stance_torque", "hip.touchdown_angle", "leg.thrust"
HOLD = ("speed", "apex_height", "apex_leg_angle")
"""With these equal the foot is as high at the apex, too, where the ground steps."""
VARY = (TORQUE, ANGLE, "hip.liftoff_angle_factor")
SLIPS, STICKS = 0.2, 10.0
"""Frictions of a runner that slips all the time, and of one that sticks."""


@dataclass(frozen=True)
class OwnClaim:
    """Something that this project says, and how it is recomputed."""

    what: str
    """In words."""
    command: str
    """That recomputes it, or the first of what it is made of."""
    low: float
    """Least that is stated."""
    high: float
    """Most."""
    compute: Callable[[int], float]
    """By a seed, of which only what is drawn depends."""


@cache
def gait(friction: float) -> Gait:
    """Of the paper's runner."""
    return periodic_gait({FRICTION: friction})


@cache
def matched(reference: float, other: float) -> Gait:
    """The runner on the other friction, as the control of that on the first."""
    return compare([gait(reference), gait(other)], hold=HOLD, vary=VARY).gaits[1]
