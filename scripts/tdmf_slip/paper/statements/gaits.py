"""Claims about gaits: over friction, on friction that falls, on slopes, by thrust, and of least cost."""

import math
from collections.abc import Mapping
from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from ...analysis.branches import continue_branch
from ...analysis.special_points import FOLD, NEIMARK_SACKER, PERIOD_DOUBLING
from ...analysis.sweeps import Sweep, gait_at, sweep
from ...analysis.targeted import find_gait
from ...errors import GaitNotFoundError, RunError
from ...library.gait import Gait
from ...library.runner import Runner
from ...optimization.optimize import optimize
from ...optimization.optimum import Optimum
from ...variables.table import FRICTION
from ..along import up_to_turn
from ..matched import IN_TWO, gait_with, match_gait
from .claim import (
    ANGLE,
    CLAMPED,
    DEFAULT,
    HEAVY,
    HUMAN,
    SLIPS,
    SLOPE,
    STICKS,
    THRUST,
    TORQUE,
    Measure,
    Measures,
    Regime,
    Which,
    cached_with_errors,
    equal_to,
    gait,
    of,
    over_length,
    runner_on,
    solved,
    stride_quantity,
)

if TYPE_CHECKING:
    import xarray

# Statements on speed, cost and stability at each friction

FRICTIONS = np.geomspace(STICKS, 0.1, 200)
REFINED = 41
"""Frictions between the neighbours of the fastest gait."""
NET, POSITIVE = "cost_of_transport", "positive_cost_of_transport"
NEAR_OPTIMUM, LOW = 0.5, 0.25
"""Friction near which Table 1 runs fastest, and one at which every runner slips for most of its stance."""


@cache
def swept(regime: Regime, model: str = "full") -> Sweep:
    """Gaits at all frictions, from the greatest on."""
    return sweep(Runner(regime.values, model=model), {FRICTION: FRICTIONS})


@cache
def fastest(regime: Regime) -> Gait:
    """The fastest of all gaits."""
    speeds = swept(regime).gaits["speed"].to_series().dropna()
    number = int(np.argmax(speeds))
    begin, end = speeds.index[[max(number - 1, 0), min(number + 1, len(speeds) - 1)]]
    near = sweep(Runner(regime.values), {FRICTION: np.geomspace(begin, end, REFINED)}).gaits
    return gait_at(near, **{FRICTION: near["speed"].to_series().idxmax()})


def _over_sticking(quantity: str, which: Which) -> Measure:
    """Change of a quantity from the gait on friction 10 to another runner, in per cent."""

    def change(regime: Regime) -> float:
        return 100.0 * (which(regime).stride[quantity] / gait(regime, STICKS).stride[quantity] - 1.0)

    return solved(change)


def _changes(cost: str, friction: float) -> tuple[Measure, Measure]:
    """Changes of a cost on a friction, unmatched, and matched to the runner on friction 10."""
    return (
        _over_sticking(cost, of(gait, friction)),
        _over_sticking(cost, of(runner_on, friction, STICKS)),
    )


def _drop(regime: Regime) -> float:
    """Largest drop of the spectral radius below its value at a greater friction."""
    radii = swept(regime).gaits["lambda_max"].to_series().dropna().to_numpy()
    return round(float(np.max(np.maximum.accumulate(radii) - radii)), 6)


def _at_40_degrees(friction: float) -> Measure:
    """Spectral radius at weight 0.022 and the touchdown angle of Table 1, by either reading."""

    def radius(regime: Regime) -> float:
        if regime not in (DEFAULT, CLAMPED):
            raise RunError("not computed")
        return gait(regime, friction, gravity=HEAVY.values["gravity"]).lambda_max

    return solved(radius)


OVER_FRICTION: Measures = {
    "fastest-friction": (solved(lambda regime: fastest(regime).friction), None),
    "fastest-gain": (_over_sticking("speed", fastest), None),
    "net-cost": _changes(NET, NEAR_OPTIMUM),
    "positive-cost": _changes(POSITIVE, NEAR_OPTIMUM),
    "net-cost-slippery": _changes(NET, LOW),
    "positive-cost-slippery": _changes(POSITIVE, LOW),
    "eigenvalues-rise": (solved(_drop), None),
    "heavy-sticks": (_at_40_degrees(STICKS), None),
    "heavy-slips": (_at_40_degrees(0.3), None),
}


# Friction that falls with the speed of the foot, beside the static friction at any speed

SLIDING, RATIO, VELOCITY = 0.3, 2.0, 0.1
"""Sliding friction, static over sliding friction, and the velocity over which it falls, over l0 sqrt(k/m)."""


@cached_with_errors
def _falling(regime: Regime) -> Gait:
    scale = gait(regime, SLIDING).runner.scales[1]
    return gait(
        regime,
        SLIDING,
        ground__static_friction_ratio=RATIO,
        ground__stribeck_velocity=VELOCITY * float(scale),
    )


_static = of(gait, RATIO * SLIDING)


@cached_with_errors
def _equal_to_falling(regime: Regime) -> Gait:
    return equal_to(_falling(regime), _static(regime))


FALLING: Measures = {
    "falling-speed": (stride_quantity(_falling, "speed"), stride_quantity(_static, "speed")),
    "falling-cost": (stride_quantity(_falling, NET), stride_quantity(_equal_to_falling, NET)),
    "falling-positive-cost": (
        stride_quantity(_falling, POSITIVE),
        stride_quantity(_equal_to_falling, POSITIVE),
    ),
}


# Slopes: the speed uphill, the steepest slope with a gait, and the steepest on which it is stable

HIGHEST, POINTS = math.radians(30.0), 100
"""Slope up to which branches are followed, rad, and the largest number of their gaits."""
BIFURCATIONS = (FOLD, PERIOD_DOUBLING, NEIMARK_SACKER)
FLAT = 0.85
"""Touchdown angle that lays the leg flatter than the paper's 40 degrees, rad."""
BELOW_TOP = math.radians(0.1)
"""Difference from the steepest slope, rad."""
UPHILL = math.radians(1.5)
"""Slope on which the gaits of both frictions are stable in Table 1, rad."""


def _level(regime: Regime, friction: float, reference: float | None, angle: float | None = None) -> Gait:
    """The gait on level ground, or the runner made equal to the one on friction `reference`."""
    if reference is not None:
        return runner_on(regime, friction, reference)
    return gait(regime, friction, hip__touchdown_angle=angle)


@cached_with_errors
def climb(regime: Regime, friction: float, reference: float | None, angle: float | None) -> "xarray.Dataset":
    """Gaits and special points up to the fold at which the branch from level ground turns back."""
    level = _level(regime, friction, reference, angle)
    return up_to_turn(continue_branch(level, {SLOPE: (0.0, HIGHEST)}, max_points=POINTS, switch=False))


def steepest(friction: float, angle: float | None = None) -> Measure:
    """Slope of the steepest gait, degrees."""
    return solved(lambda regime: math.degrees(climb(regime, friction, None, angle)[SLOPE][-1]))


def stable_to(friction: float, angle: float | None = None, reference: float | None = None) -> Measure:
    """Slope at which the gait loses stability, or of the steepest gait, degrees."""

    def degrees(regime: Regime) -> float:
        branch = climb(regime, friction, reference, angle)
        lost = np.isin(branch["special"].values, BIFURCATIONS) | (branch["lambda_max"].values >= 1.0)
        if lost[0]:
            raise RunError("unstable")
        return math.degrees(branch[SLOPE][np.argmax(lost) if lost.any() else -1])

    return solved(degrees)


def speed_near_top(friction: float) -> Measure:
    """Speed of the gait on a slope just below the steepest.

    On a slope of arctan(friction) a gait that slips backward throughout may have any of a range of speeds,
    because gravity and friction cancel along the ground.
    """

    def speed(regime: Regime) -> float:
        slope = float(climb(regime, friction, None, None)[SLOPE][-1]) - BELOW_TOP
        return gait_with(_level(regime, friction, None), SLOPE, slope).stride["speed"]

    return solved(speed)


def slowed(friction: float, reference: float | None = None) -> Measure:
    """Speed uphill over the speed on level ground."""

    def over(regime: Regime) -> float:
        one = _level(regime, friction, reference)
        uphill = gait_with(one, SLOPE, UPHILL)
        return uphill.stride["speed"] / one.stride["speed"]

    return solved(over)


SLOPES: Measures = {
    "slope-speed": (slowed(SLIPS), slowed(STICKS, SLIPS)),
    "slope-steepest": (steepest(SLIPS), steepest(STICKS)),
    "slope-top-speed": (speed_near_top(SLIPS), stride_quantity(of(gait, SLIPS), "speed")),
    "slope-stable": (stable_to(SLIPS), stable_to(STICKS)),
    "slope-stable-matched": (stable_to(SLIPS), stable_to(STICKS, None, SLIPS)),
    "slope-flat": (stable_to(SLIPS, FLAT), stable_to(STICKS, FLAT)),
    "slope-flat-0.6": (steepest(0.6, FLAT), steepest(SLIPS, FLAT)),
}


# Thrust of the leg beside torque of the hip, at equal speed

FASTER = 1.3
"""Speed over that of the unmatched gait on friction 0.2."""
HELPED = 0.1
"""Thrust, over the leg's length."""


@cached_with_errors
def by_torque(regime: Regime) -> Gait:
    """The runner whose torque gives the speed."""
    return _at_speed(regime, TORQUE, 0.0)


@cached_with_errors
def by_thrust(regime: Regime) -> Gait:
    """The runner whose thrust, added to its torque, gives the speed."""
    return _at_speed(regime, THRUST, HELPED)


def _at_speed(regime: Regime, name: str, added: float) -> Gait:
    one = gait(regime, SLIPS)
    begin = one.runner[name] + added * one.runner["leg.free_length"]
    values = {**regime.values, FRICTION: SLIPS, name: begin}
    try:
        return find_gait(values, target={"speed": FASTER * one.stride["speed"]}, vary=[name])
    except RunError as error:
        raise GaitNotFoundError(str(error)) from error


@cached_with_errors
def as_high(regime: Regime) -> Gait:
    """The runner with thrust that has the speed and apex height of the runner driven by torque."""
    reference = by_torque(regime)
    helped = gait_with(reference, THRUST, HELPED * reference.runner["leg.free_length"])
    return match_gait(reference, helped, *IN_TWO)


def _by_way(which: Which) -> Measure:
    return solved(lambda regime: which(regime).stride["slip_distance"] / which(regime).stride["length"])


THRUSTS: Measures = {
    "thrust-slip": (_by_way(by_thrust), _by_way(by_torque)),
    "thrust-slip-stride": (over_length(by_thrust, "slip_distance"), over_length(by_torque, "slip_distance")),
    "thrust-height": (over_length(by_thrust, "apex_height"), over_length(by_torque, "apex_height")),
    "thrust-slip-matched": (_by_way(as_high), _by_way(by_torque)),
    "thrust-cost-matched": (stride_quantity(as_high, NET), stride_quantity(by_torque, NET)),
    "thrust-positive-cost-matched": (
        stride_quantity(as_high, POSITIVE),
        stride_quantity(by_torque, POSITIVE),
    ),
}


# The cheapest runners at one speed: by net work, and by positive work, which refunds no braking

SLIPPERY, BETWEEN = 0.3, 0.85
"""Frictions at which the runner of least net work slips for most of its stance, and for some of it."""
SPEED, RADIUS = 0.8, 0.95
"""Speed, l0 sqrt(k/m), and the largest spectral radius: a disturbance is halved within 14 strides."""
BOUNDS: Mapping[str, tuple[float, float]] = {ANGLE: (0.3, 1.1), TORQUE: (0.0, 0.6), THRUST: (0.0, 0.4)}
HUMAN_SPEED, HUMAN_RADIUS = 2.5, 0.975
HUMAN_BOUNDS: Mapping[str, tuple[float, float]] = {
    ANGLE: (0.2, 0.8),
    TORQUE: (0.0, 1000.0),
    THRUST: (0.0, 0.02),
}
"""Speed in m/s, largest spectral radius, and what may vary, of the human preset."""


@cached_with_errors
def _best(regime: Regime, friction: float, quantity: str) -> Optimum:
    """The runner with the least value of a quantity; the search begins at the regime's own runner."""
    is_human = regime is HUMAN
    return optimize(
        {**regime.values, FRICTION: friction},
        HUMAN_BOUNDS if is_human else BOUNDS,
        minimize=quantity,
        target={"speed": HUMAN_SPEED if is_human else SPEED},
        stable=HUMAN_RADIUS if is_human else RADIUS,
        starts=1,
    )


def _cost(friction: float, least: str, counted: str) -> Measure:
    """The cost `counted` of the runner that has the least cost `least`."""
    return solved(lambda regime: _best(regime, friction, least).gait.stride[counted])


def _slip(regime: Regime) -> float:
    stride = _best(regime, SLIPPERY, NET).gait.stride
    return 100.0 * stride["slip_distance"] / stride["length"]


OPTIMA: Measures = {
    "optimal-net": (_cost(SLIPPERY, NET, NET), _cost(STICKS, NET, NET)),
    "optimal-slip": (solved(_slip), None),
    "optimal-net-positive": (_cost(SLIPPERY, NET, POSITIVE), _cost(STICKS, POSITIVE, POSITIVE)),
    "optimal-positive": (_cost(BETWEEN, POSITIVE, POSITIVE), _cost(STICKS, POSITIVE, POSITIVE)),
    "optimal-positive-slippery": (_cost(SLIPPERY, POSITIVE, POSITIVE), _cost(STICKS, POSITIVE, POSITIVE)),
}

MEASURES = OVER_FRICTION | FALLING | SLOPES | THRUSTS | OPTIMA
