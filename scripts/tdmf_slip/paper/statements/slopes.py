"""The steepest slope of a gait that is followed from level ground, at two touchdown angles."""

import math
from collections.abc import Callable
from functools import cache

import numpy as np

from ...analysis.search import periodic_gait
from ...errors import RunError
from ...fmu.fmu import FRICTION
from ...library.gait import Gait, gait_near
from ..matched import changed
from .claim import ANGLE, SLIPS, STICKS, OwnClaim, gait, matched
from .rough import MATCH

SLOPE = "ground.slope"
FIRST, SHORTEST = 0.005, 1e-5
"""Steps of the slope, rad."""
AWAY = 0.1
"""Of the scales: farther from where it is predicted a gait is of another branch."""
FLAT = 0.85
"""A touchdown angle, rad, that lays the leg flatter than the paper's 40 degrees."""


@cache
def climb(friction: float, angle: float | None = None) -> tuple[Gait, ...]:
    """Gaits up to the fold at which the branch from level ground turns back."""
    first = periodic_gait({FRICTION: friction} if angle is None else {FRICTION: friction, ANGLE: angle})
    found, step = [first], FIRST
    while step > SHORTEST:
        last = found[-1]
        guess = last.apex
        if len(found) > 1:
            guess = guess + (last.apex - found[-2].apex) * step / (_slope(last) - _slope(found[-2]))
        try:
            next_one = gait_near(last.runner.but(SLOPE, _slope(last) + step), guess)
        except RunError:
            step *= 0.5
            continue
        if np.max(np.abs(next_one.apex - guess) / last.runner.scales) > AWAY:
            step *= 0.5
            continue
        found.append(next_one)
    return tuple(found)


def _slope(one: Gait) -> float:
    return one.runner.values[SLOPE]


def _steepest(friction: float, angle: float | None = None) -> Callable[[int], float]:
    return lambda seed: math.degrees(_slope(climb(friction, angle)[-1]))


def _steadily(friction: float, angle: float | None = None) -> Callable[[int], float]:
    """Up to where the gait first is unstable."""

    def degrees(seed: int) -> float:
        gaits = climb(friction, angle)
        unstable = next((k for k, one in enumerate(gaits) if not one.stable), len(gaits))
        return math.degrees(_slope(gaits[unstable - 1]))

    return degrees


def _climb_command(friction: float, angle: float | None = None) -> str:
    setting = "" if angle is None else f" --set {ANGLE}={angle}"
    return f"tdmf-slip continue --vary ground.slope=0:0.33 --friction {friction:g}{setting} --no-switch"


UPHILL = math.radians(1.5)
"""A slope at which all of these are stable."""


def _slowed(one: Gait) -> float:
    """Speed on that slope over that on the level."""
    uphill = changed(one, {SLOPE: UPHILL}, 6)
    assert uphill is not None
    return uphill.stride["speed"] / one.stride["speed"]


CLAIMS = (
    OwnClaim(
        "speed 1.5 degrees uphill over that on the level: friction 0.2",
        _climb_command(SLIPS),
        0.89,
        0.92,
        lambda seed: _slowed(gait(SLIPS)),
    ),
    OwnClaim(
        "  its control: friction 10 with speed, apex height and leg angle of the former on the level",
        MATCH.format(SLIPS, STICKS),
        0.99,
        1.02,
        lambda seed: _slowed(matched(SLIPS, STICKS)),
    ),
    OwnClaim(
        "steepest slope with a gait at the paper's touchdown angle, degrees: friction 0.2",
        _climb_command(SLIPS),
        9.2,
        9.24,
        _steepest(SLIPS),
    ),
    OwnClaim("  friction 0.6", _climb_command(0.6), 2.64, 2.67, _steepest(0.6)),
    OwnClaim("  friction 10", _climb_command(STICKS), 2.3, 2.33, _steepest(STICKS)),
    OwnClaim(
        "  its control: the former's speed there",
        _climb_command(SLIPS),
        0.17,
        0.19,
        lambda seed: climb(SLIPS)[-1].stride["speed"],
    ),
    OwnClaim(
        "  and its cost of transport",
        _climb_command(SLIPS),
        2.2,
        2.3,
        lambda seed: climb(SLIPS)[-1].stride["cost_of_transport"],
    ),
    OwnClaim(
        "  its control: up to which slope its gaits are stable, to 0.3 degrees: friction 0.2",
        _climb_command(SLIPS),
        1.7,
        2.0,
        _steadily(SLIPS),
    ),
    OwnClaim("  friction 0.6", _climb_command(0.6), 2.64, 2.67, _steadily(0.6)),
    OwnClaim("  friction 10", _climb_command(STICKS), 2.3, 2.33, _steadily(STICKS)),
    OwnClaim(
        f"  its control: steepest slope at a touchdown angle of {FLAT} rad, friction 0.6",
        _climb_command(0.6, FLAT),
        18.0,
        18.4,
        _steepest(0.6, FLAT),
    ),
    OwnClaim("  friction 10", _climb_command(STICKS, FLAT), 7.73, 7.77, _steepest(STICKS, FLAT)),
    OwnClaim(
        "  and up to which they are stable there, friction 0.6",
        _climb_command(0.6, FLAT),
        4.0,
        4.4,
        _steadily(0.6, FLAT),
    ),
    OwnClaim("  friction 10", _climb_command(STICKS, FLAT), 3.9, 4.4, _steadily(STICKS, FLAT)),
)
