"""Claims about gaits: over friction, on friction that falls, on slopes, by thrust, and of least cost."""

import math
from collections.abc import Callable, Mapping
from functools import cache

import numpy as np

from ...analysis.targeted import find_gait
from ...errors import GaitNotFoundError, RunError
from ...library.fixed_point import gait_near
from ...library.gait import Gait
from ...library.runner import Runner
from ...optimization.optimize import optimize
from ...optimization.optimum import Optimum
from ...variables.table import FRICTION
from .. import along
from ..along import Swept
from .claim import (
    ALL,
    ALL_BUT_HUMAN,
    ANGLE,
    CLAMPED,
    DEFAULT,
    HEAVY,
    HUMAN,
    INFINITE,
    SLIPS,
    STICKS,
    TABLE_1,
    THRUST,
    TORQUE,
    Check,
    Condition,
    Estimate,
    Measure,
    Regime,
    above,
    below,
    between,
    cached_with_errors,
    changed_to,
    check,
    equal_to,
    gait,
    made_equal,
    matched,
    over_length,
    ratio,
    solved,
    stride_quantity,
)

# Statements on speed, cost and stability at each friction

FRICTIONS = np.geomspace(STICKS, 0.1, 200)
REFINED = 41
"""Frictions between the neighbours of the fastest gait."""
NET, POSITIVE = "cost_of_transport", "positive_cost_of_transport"
NEAR_OPTIMUM, LOW = 0.5, 0.25
"""Friction near which Table 1 runs fastest, and one at which every runner slips for most of its stance."""


@cache
def swept(regime: Regime, model: str = "full") -> Swept:
    """Gaits at all frictions, from the greatest on."""
    return along.swept(Runner(regime.values, model=model), FRICTIONS)


@cache
def fastest(regime: Regime) -> Gait:
    """The fastest of all gaits."""
    found = swept(regime).gaits
    number = int(np.argmax([one.stride["speed"] for one in found]))
    ends = found[max(number - 1, 0)].friction, found[min(number + 1, len(found) - 1)].friction
    near = along.swept(Runner(regime.values), np.geomspace(*ends, REFINED)).gaits
    best: Gait = max(near, key=lambda one: one.stride["speed"])
    return best


def _over_sticking(quantity: str, of: Callable[[Regime], Gait]) -> Measure:
    """Change of a quantity from the gait on friction 10 to another runner, in per cent."""

    def change(regime: Regime) -> float:
        return 100.0 * (of(regime).stride[quantity] / gait(regime, STICKS).stride[quantity] - 1.0)

    return solved(change)


def _cost_check(cost: str, friction: float, *conditions: Condition) -> Check:
    """Change of a cost on a friction, unmatched, and matched to the runner on friction 10."""
    value = _over_sticking(cost, lambda regime: gait(regime, friction))
    return check(value, _over_sticking(cost, lambda regime: matched(regime, STICKS, friction)), *conditions)


def _drop(regime: Regime) -> float:
    """Largest drop of the spectral radius below its value at a greater friction."""
    radii = np.array([one.lambda_max for one in swept(regime).gaits])
    return round(float(np.max(np.maximum.accumulate(radii) - radii)), 6)


def _at_40_degrees(friction: float) -> Measure:
    """Spectral radius at weight 0.022 and the touchdown angle of Table 1, by either reading."""

    def radius(regime: Regime) -> float:
        if regime not in (DEFAULT, CLAMPED):
            raise RunError("not computed")
        return gait(regime, friction, gravity=HEAVY.values["gravity"]).lambda_max

    return solved(radius)


OVER_FRICTION_CHECKS = {
    "fastest-friction": check(
        solved(lambda regime: fastest(regime).friction),
        None,
        between(0.445, 0.5, *ALL_BUT_HUMAN),
        between(0.85, INFINITE, "human"),
    ),
    "fastest-gain": check(
        _over_sticking("speed", fastest),
        None,
        between(10.0, 13.0, *ALL_BUT_HUMAN),
        lambda rows: 0.0 <= rows["human"].number < 0.1,
    ),
    "net-cost": _cost_check(
        NET,
        NEAR_OPTIMUM,
        between(-INFINITE, -15.0, *ALL_BUT_HUMAN),
        ratio(0.0, 1.0, *ALL_BUT_HUMAN),
        between(0.0, INFINITE, "human"),
        ratio(-INFINITE, 0.0, "human"),
    ),
    "positive-cost": _cost_check(
        POSITIVE, NEAR_OPTIMUM, between(-INFINITE, 0.0, *ALL), ratio(0.0, INFINITE, *ALL)
    ),
    "net-cost-slippery": _cost_check(
        NET,
        LOW,
        between(-INFINITE, 0.0, *ALL_BUT_HUMAN),
        ratio(0.0, 30.0, *ALL_BUT_HUMAN),
        between(0.0, INFINITE, "human"),
        ratio(-INFINITE, 0.0, "human"),
    ),
    "positive-cost-slippery": _cost_check(
        POSITIVE,
        LOW,
        between(-INFINITE, 0.0, "default", "human"),
        between(0.0, INFINITE, "clamp"),
        ratio(-INFINITE, 0.0, "default"),
        ratio(0.0, INFINITE, "clamp", "human"),
    ),
    "eigenvalues-rise": check(
        solved(_drop),
        None,
        between(-INFINITE, 0.001, *TABLE_1),
        between(0.01, INFINITE, "heavy", "human"),
    ),
    "heavy-sticks": check(_at_40_degrees(STICKS), None, between(1.0, INFINITE, *TABLE_1)),
    "heavy-slips": check(
        _at_40_degrees(0.3), None, between(-INFINITE, 1.0, "clamp"), between(1.0, INFINITE, "default")
    ),
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


def _static(regime: Regime) -> Gait:
    return gait(regime, RATIO * SLIDING)


@cached_with_errors
def _equal_to_falling(regime: Regime) -> Gait:
    return equal_to(_falling(regime), _static(regime))


FALLING_CHECKS = {
    "falling-speed": check(
        stride_quantity(_falling, "speed"),
        stride_quantity(_static, "speed"),
        above(*ALL_BUT_HUMAN),
        below("human"),
    ),
    **{
        name: check(
            stride_quantity(_falling, quantity), stride_quantity(_equal_to_falling, quantity), below(*ALL)
        )
        for name, quantity in (
            ("falling-cost", NET),
            ("falling-positive-cost", POSITIVE),
        )
    },
}


# Slopes: the speed uphill, the steepest slope with a gait, and the steepest on which it is stable

SLOPE = "ground.slope"
FIRST, SHORTEST = 0.005, 1e-5
"""First step of the slope along a branch, and the step at which its fold counts as reached, rad."""
AWAY = 0.1
"""Distance from its prediction, over the scales, beyond which a gait belongs to another branch."""
FLAT = 0.85
"""Touchdown angle that lays the leg flatter than the paper's 40 degrees, rad."""
UPHILL = math.radians(1.5)
"""Slope on which the gaits of both frictions are stable in Table 1, rad."""


def _level(regime: Regime, friction: float, reference: float | None, angle: float | None = None) -> Gait:
    """The gait on level ground, or the runner made equal to the one on friction `reference`."""
    if reference is not None:
        return matched(regime, reference, friction)
    return gait(regime, friction, hip__touchdown_angle=angle)


@cached_with_errors
def climb(regime: Regime, friction: float, reference: float | None, angle: float | None) -> tuple[Gait, ...]:
    """Gaits up to the fold at which the branch from level ground turns back."""
    found, step = [_level(regime, friction, reference, angle)], FIRST
    while step > SHORTEST:
        last = found[-1]
        guess = last.apex
        if len(found) > 1:
            guess = guess + (last.apex - found[-2].apex) * step / (_slope(last) - _slope(found[-2]))
        try:
            next_one = gait_near(last.runner.replace({SLOPE: _slope(last) + step}), guess)
        except RunError:
            step *= 0.5
            continue
        if np.max(np.abs(next_one.apex - guess) / last.runner.scales) > AWAY:
            step *= 0.5
            continue
        found.append(next_one)
    return tuple(found)


def _slope(one: Gait) -> float:
    return one.runner[SLOPE]


def steepest(friction: float, angle: float | None = None) -> Measure:
    """Slope of the steepest gait, degrees."""
    return solved(lambda regime: math.degrees(_slope(climb(regime, friction, None, angle)[-1])))


def stable_to(friction: float, angle: float | None = None, reference: float | None = None) -> Measure:
    """Slope of the last stable gait, degrees; the interval ends at the first unstable gait."""

    def degrees(regime: Regime, seed: int) -> Estimate:
        gaits = climb(regime, friction, reference, angle)
        unstable = next((k for k, one in enumerate(gaits) if not one.stable), len(gaits))
        if not unstable:
            raise RunError("unstable")
        last = math.degrees(_slope(gaits[unstable - 1]))
        return Estimate(last, last, math.degrees(_slope(gaits[min(unstable, len(gaits) - 1)])))

    return degrees


def at_the_top(quantity: str, friction: float) -> Measure:
    """A quantity of the steepest gait."""
    return stride_quantity(lambda regime: climb(regime, friction, None, None)[-1], quantity)


def slowed(friction: float, reference: float | None = None) -> Measure:
    """Speed uphill over the speed on level ground."""

    def over(regime: Regime) -> float:
        one = _level(regime, friction, reference)
        uphill = changed_to(one, SLOPE, UPHILL, 6)
        return uphill.stride["speed"] / one.stride["speed"]

    return solved(over)


SLOPES_CHECKS = {
    "slope-speed": check(
        slowed(SLIPS), slowed(STICKS, SLIPS), below(*ALL_BUT_HUMAN), between(1.0, INFINITE, "human")
    ),
    "slope-steepest": check(steepest(SLIPS), steepest(STICKS), above(*ALL)),
    "slope-top-speed": check(
        at_the_top("speed", SLIPS),
        stride_quantity(lambda regime: gait(regime, SLIPS), "speed"),
        ratio(-INFINITE, 0.05, "default"),
        ratio(-INFINITE, 0.25, "clamp"),
    ),
    "slope-stable": check(stable_to(SLIPS), stable_to(STICKS), above("default"), below("clamp")),
    "slope-stable-matched": check(
        stable_to(SLIPS), stable_to(STICKS, None, SLIPS), ratio(1.0, 1.4, "default")
    ),
    "slope-flat": check(
        stable_to(SLIPS, FLAT),
        stable_to(STICKS, FLAT),
        above(*ALL_BUT_HUMAN),
        between(11.2, INFINITE, *ALL_BUT_HUMAN),
    ),
    "slope-flat-0.6": check(steepest(0.6, FLAT), steepest(SLIPS, FLAT), below("default"), above("clamp")),
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
    helped = changed_to(reference, THRUST, HELPED * reference.runner["leg.free_length"], 2)
    return made_equal(reference, helped, ("speed", "apex_height"), (TORQUE, ANGLE))


def _by_way(of: Callable[[Regime], Gait]) -> Measure:
    return solved(lambda regime: of(regime).stride["slip_distance"] / of(regime).stride["length"])


THRUST_CHECKS = {
    "thrust-slip": check(_by_way(by_thrust), _by_way(by_torque), below(*TABLE_1)),
    "thrust-slip-stride": check(
        over_length(by_thrust, "slip_distance"), over_length(by_torque, "slip_distance"), above(*TABLE_1)
    ),
    "thrust-height": check(
        over_length(by_thrust, "apex_height"), over_length(by_torque, "apex_height"), above(*TABLE_1)
    ),
    "thrust-slip-matched": check(_by_way(as_high), _by_way(by_torque), above(*ALL_BUT_HUMAN)),
    "thrust-cost-matched": check(
        stride_quantity(as_high, NET), stride_quantity(by_torque, NET), below(*ALL_BUT_HUMAN)
    ),
    "thrust-positive-cost-matched": check(
        stride_quantity(as_high, POSITIVE), stride_quantity(by_torque, POSITIVE), below(*ALL_BUT_HUMAN)
    ),
}


# The cheapest runners at one speed: by net work, and by positive work, which refunds no braking

SLIPPERY, BETWEEN = 0.3, 0.85
"""Frictions at which the runner of least net work slips for most of its stance, and for some of it."""
SPEED, RADIUS = 0.8, 0.95
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


OPTIMA_CHECKS = {
    "optimal-net": check(
        _cost(SLIPPERY, NET, NET),
        _cost(STICKS, NET, NET),
        ratio(0.78, 0.84, *ALL_BUT_HUMAN),
        ratio(0.95, 1.0, "human"),
    ),
    "optimal-slip": check(solved(_slip), None, between(0.5, 2.5, *ALL)),
    "optimal-net-positive": check(
        _cost(SLIPPERY, NET, POSITIVE), _cost(STICKS, POSITIVE, POSITIVE), ratio(1.04, INFINITE, *TABLE_1)
    ),
    "optimal-positive": check(
        _cost(BETWEEN, POSITIVE, POSITIVE),
        _cost(STICKS, POSITIVE, POSITIVE),
        ratio(0.97, 0.985, *ALL_BUT_HUMAN),
        ratio(0.99, 1.0, "human"),
    ),
    "optimal-positive-slippery": check(
        _cost(SLIPPERY, POSITIVE, POSITIVE),
        _cost(STICKS, POSITIVE, POSITIVE),
        ratio(-INFINITE, 1.0, "default"),
        ratio(1.0, INFINITE, "clamp"),
    ),
}

CHECKS = {
    "over_friction": OVER_FRICTION_CHECKS,
    "falling": FALLING_CHECKS,
    "slopes": SLOPES_CHECKS,
    "thrust": THRUST_CHECKS,
    "optima": OPTIMA_CHECKS,
}
