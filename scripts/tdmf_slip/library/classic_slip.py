"""The classic SLIP: a point mass on a massless spring leg, the sections 2 and 3 of the paper.

The ground may have a slope, and the leg may retract: it turns back at a constant rate from the apex on.

An apex has a height above the ground vertically below it, and an energy m (v^2/2 + g times this height).
The energy of the motion is conserved. On a slope the ground below the next apex is higher or lower, and the
energy above it is less by m g L tan(slope), L being the length of the step, which is positive. So on a slope
no gait repeats both height and energy: uphill the runner loses energy above the ground with every step,
downhill it gains. What `fixed_points` gives there are gaits that repeat their height at one energy: those of
a runner to which something gives back at each apex, as speed, what the climb has cost, or takes what the
descent has gained. `step` goes on without.
"""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import RunError
from .binding import c, ffi

ENERGY = 6000.0
"""E0 of the paper, J."""
SPACING = 0.02
"""Of the heights from which fixed points are sought, m."""
FOLD_STEPS = 11
"""In which a fold is followed to a slope and a rate of retraction."""
FLIES: int = c.TDMF_CLASSIC_FLIES
"""Outcome of a step that leads to the next apex; as the following."""
TURNS_BACK: int = c.TDMF_CLASSIC_TURNS_BACK
"""It does, but backwards."""


@dataclass(frozen=True)
class FixedPoint:
    """A fixed point of the return map from apex height to apex height, at one energy.

    On level ground it is a periodic gait. On a slope it is one if the energy above the ground, of which the
    step takes `energy_loss`, is restored at each apex by a change of speed.
    """

    angle: float
    """Touchdown angle, rad, at the apex where the leg retracts."""
    height: float
    """Of the apex above the ground below it, m."""
    slope: float
    """Of the map at one energy, its eigenvalue."""
    stance_friction: float
    """Friction needed in the stance."""
    impact_friction: float
    """Friction needed at the impact of an infinitesimal foot mass."""
    length: float
    """Of the step, m, from apex to apex, horizontally."""
    energy_loss: float
    """What the step takes of the energy above the ground, J; negative downhill, 0 on level ground."""

    @property
    def stable(self) -> bool:
        """The map's slope is below 1 in size."""
        return abs(self.slope) < 1.0


def slip(
    angle: float, friction: float = math.inf, *, ground_slope: float = 0.0, retraction_rate: float = 0.0
) -> Any:
    """The paper's SLIP."""
    parameters: Any = ffi.new("tdmf_classic *", c.tdmf_classic_default())
    parameters.touchdown_angle = angle
    parameters.friction = friction
    parameters.ground_slope = ground_slope
    parameters.retraction_rate = retraction_rate
    return parameters


def step(parameters: Any, height: float, energy: float = ENERGY) -> Any:
    """One step of the return map."""
    made: Any = c.tdmf_classic_return_map(parameters, energy, height)
    return made


def stance(parameters: Any, height: float, times: ArrayLike, energy: float = ENERGY) -> NDArray[np.float64]:
    """The mass as seen from the foot, in a stance after an apex."""
    points: list[Any] = [
        c.tdmf_classic_stance(parameters, energy, height, time) for time in np.atleast_1d(times)
    ]
    return np.array([(p.x, p.y, p.vx, p.vy) for p in points]).T


def highest(parameters: Any, energy: float = ENERGY) -> float:
    """Apex height, m, at which all energy, J, is potential."""
    return energy / float(parameters.mass * parameters.gravity)


def heights(parameters: Any, count: int, energy: float = ENERGY) -> NDArray[np.float64]:
    """So many apex heights, m, from that at which the foot is on the ground to the highest, both left out."""
    angle = parameters.touchdown_angle
    low = parameters.free_length * (math.cos(angle) + math.sin(angle) * math.tan(parameters.ground_slope))
    return np.linspace(low, highest(parameters, energy), count + 2)[1:-1]


def fixed_points(
    angle: float,
    energy: float = ENERGY,
    *,
    ground_slope: float = 0.0,
    retraction_rate: float = 0.0,
) -> list[FixedPoint]:
    """All gaits of a touchdown angle that repeat their height at one energy."""
    parameters = slip(angle, ground_slope=ground_slope, retraction_rate=retraction_rate)
    found: list[FixedPoint] = []
    tried = heights(parameters, int(highest(parameters, energy) / SPACING), energy)
    steps = [step(parameters, height, energy) for height in tried]
    for (low, before), (high, after) in zip(
        zip(tried, steps, strict=True), zip(tried[1:], steps[1:], strict=True), strict=False
    ):
        crosses = (before.next_height - low) * (after.next_height - high) <= 0.0
        if before.outcome == FLIES and after.outcome == FLIES and crosses:
            height = ffi.new("double *")
            if c.tdmf_classic_fixed_point(parameters, energy, 0.5 * (low + high), height):
                found.append(_fixed_point(parameters, angle, height[0], energy))
    return found


def fold(energy: float = ENERGY, *, ground_slope: float = 0.0, retraction_rate: float = 0.0) -> FixedPoint:
    """Where, over the touchdown angle, the stable and the unstable gait of an energy meet and vanish.

    On a slope, or of a leg that retracts, it is followed there from that on level ground of a leg that is
    held.
    """
    angle, height = ffi.new("double *", math.radians(44.0)), ffi.new("double *", 2.0)
    moves = ground_slope != 0.0 or retraction_rate != 0.0
    for share in np.linspace(0.0, 1.0, FOLD_STEPS) if moves else (0.0,):
        its = {"ground_slope": share * ground_slope, "retraction_rate": share * retraction_rate}
        if not c.tdmf_classic_fold(slip(angle[0], **its), energy, angle, height):
            where = f"ground_slope = {its['ground_slope']:g}, retraction_rate = {its['retraction_rate']:g}"
            raise RunError(f"no fold of the classic SLIP was found at energy = {energy:g} J, {where}")
    return _fixed_point(slip(angle[0], **its), angle[0], height[0], energy)


def _fixed_point(parameters: Any, angle: float, height: float, energy: float) -> FixedPoint:
    there = step(parameters, height, energy)
    return FixedPoint(
        angle,
        height,
        there.by_height.height,
        there.stance_friction,
        there.impact_friction,
        there.length,
        parameters.mass * parameters.gravity * there.length * math.tan(parameters.ground_slope),
    )
