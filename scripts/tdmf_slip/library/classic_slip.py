"""The classic SLIP: a point mass on a massless spring leg, the sections 2 and 3 of the paper."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .binding import c, ffi

ENERGY = 6000.0
"""E0 of the paper, J."""
SPACING = 0.02
"""Of the heights from which fixed points are sought, m."""


@dataclass(frozen=True)
class Gait:
    """A fixed point of the return map."""

    angle: float
    """Touchdown angle, rad."""
    height: float
    """Of the apex, m."""
    slope: float
    stance_friction: float
    impact_friction: float

    @property
    def stable(self) -> bool:
        """The map's slope is below 1 in size."""
        return abs(self.slope) < 1.0


def slip(angle: float, friction: float = math.inf) -> object:
    """The paper's SLIP with a touchdown angle in rad."""
    parameters = ffi.new("tdmf_classic *", c.tdmf_classic_default())
    parameters.touchdown_angle = angle
    parameters.friction = friction
    return parameters


def step(parameters: object, height: float, energy: float = ENERGY) -> object:
    """One step of the return map from an apex height, the C struct `tdmf_classic_step`."""
    return c.tdmf_classic_return_map(parameters, energy, height)


def stance(parameters: object, height: float, times: Sequence[float], energy: float = ENERGY) -> np.ndarray:
    """The mass as seen from the foot at times after touchdown: rows x, y, vx, vy."""
    points = [c.tdmf_classic_stance(parameters, energy, height, time) for time in times]
    return np.array([(p.x, p.y, p.vx, p.vy) for p in points]).T


def highest(parameters: object, energy: float = ENERGY) -> float:
    """Apex height at which all energy is potential."""
    return energy / (parameters.mass * parameters.gravity)


def heights(parameters: object, count: int, energy: float = ENERGY) -> np.ndarray:
    """Apex heights from that of touchdown to the highest, both left out."""
    low = parameters.free_length * math.cos(parameters.touchdown_angle)
    return np.linspace(low, highest(parameters, energy), count + 2)[1:-1]


def fixed_points(angle: float, energy: float = ENERGY) -> list[Gait]:
    """All gaits of a touchdown angle, in rad, by rising height."""
    parameters = slip(angle)
    found: list[Gait] = []
    tried = heights(parameters, int(highest(parameters, energy) / SPACING), energy)
    steps = [step(parameters, height, energy) for height in tried]
    flies = c.TDMF_CLASSIC_FLIES
    for (low, before), (high, after) in zip(
        zip(tried, steps, strict=True), zip(tried[1:], steps[1:], strict=True), strict=False
    ):
        crosses = (before.next_height - low) * (after.next_height - high) <= 0.0
        if before.outcome == flies and after.outcome == flies and crosses:
            height = ffi.new("double *")
            if c.tdmf_classic_fixed_point(parameters, energy, 0.5 * (low + high), height):
                found.append(_gait(parameters, angle, height[0], energy))
    return found


def fold(energy: float = ENERGY) -> Gait:
    """Where the stable and the unstable gait meet and vanish."""
    angle, height = ffi.new("double *", math.radians(44.0)), ffi.new("double *", 2.0)
    c.tdmf_classic_fold(slip(angle[0]), energy, angle, height)
    return _gait(slip(angle[0]), angle[0], height[0], energy)


def _gait(parameters: object, angle: float, height: float, energy: float) -> Gait:
    there = step(parameters, height, energy)
    return Gait(angle, height, there.slope, there.stance_friction, there.impact_friction)
