"""Statements on speed, cost and stability at each friction."""

from collections.abc import Callable
from functools import cache

import numpy as np

from ...analysis.sweeps import Row, sweep_row
from ...errors import RunError
from ...library.gait import Gait
from ...library.runner import Runner
from ...variables.table import FRICTION
from .claim import (
    ALL_BUT_HUMAN,
    CLAMPED,
    DEFAULT,
    HEAVY,
    STICKS,
    TABLE_1,
    Check,
    Measure,
    Regime,
    gait,
    matched,
    solved,
)

FRICTIONS = np.geomspace(STICKS, 0.1, 200)
REFINED = 41
"""Frictions between the neighbours of the fastest gait."""
NEAR_OPTIMUM, LOW = 0.5, 0.25
"""Friction near which Table 1 runs fastest, and one at which every runner slips for most of its stance."""


@cache
def swept(regime: Regime, model: str = "full") -> Row:
    """Gaits at all frictions, from the greatest on."""
    return sweep_row(Runner(regime.values, model=model), FRICTION, FRICTIONS)


@cache
def fastest(regime: Regime) -> Gait:
    """The fastest of all gaits."""
    found = swept(regime).gaits
    number = int(np.argmax([one.stride["speed"] for one in found]))
    ends = found[max(number - 1, 0)].friction, found[min(number + 1, len(found) - 1)].friction
    near = sweep_row(Runner(regime.values), FRICTION, np.geomspace(*ends, REFINED)).gaits
    best: Gait = max(near, key=lambda one: one.stride["speed"])
    return best


def _over_sticking(quantity: str, of: Callable[[Regime], Gait]) -> Measure:
    """Change of a quantity from the gait on friction 10 to another runner, in per cent."""

    def change(regime: Regime) -> float:
        return 100.0 * (of(regime).stride[quantity] / gait(regime, STICKS).stride[quantity] - 1.0)

    return solved(change)


def _as_it_comes(friction: float) -> Callable[[Regime], Gait]:
    return lambda regime: gait(regime, friction)


def _equal(friction: float) -> Callable[[Regime], Gait]:
    """The runner on a friction with speed, apex height and leg angle of the one on friction 10."""
    return lambda regime: matched(regime, STICKS, friction)


def _drop(regime: Regime) -> float:
    """How far the spectral radius falls below what it was at a greater friction."""
    radii = np.array([one.lambda_max for one in swept(regime).gaits])
    return round(float(np.max(np.maximum.accumulate(radii) - radii)), 6)


def _at_40_degrees(friction: float) -> Measure:
    """Spectral radius at weight 0.022 and the touchdown angle of Table 1, by either reading."""

    def radius(regime: Regime) -> float:
        if regime not in (DEFAULT, CLAMPED):
            raise RunError("not computed")
        return gait(regime, friction, gravity=HEAVY.values["gravity"]).lambda_max

    return solved(radius)


CHECKS = {
    "fastest-friction": Check(
        solved(lambda regime: fastest(regime).friction),
        None,
        lambda rows: (
            all(0.445 < rows[name].number < 0.5 for name in ALL_BUT_HUMAN) and rows["human"].number > 0.85
        ),
    ),
    "fastest-gain": Check(
        _over_sticking("speed", fastest),
        None,
        lambda rows: (
            all(10.0 < rows[name].number < 13.0 for name in ALL_BUT_HUMAN)
            and 0.0 <= rows["human"].number < 0.1
        ),
    ),
    "net-cost": Check(
        _over_sticking("cost_of_transport", _as_it_comes(NEAR_OPTIMUM)),
        _over_sticking("cost_of_transport", _equal(NEAR_OPTIMUM)),
        lambda rows: (
            all(rows[name].number < -15.0 and 0.0 < rows[name].ratio < 1.0 for name in ALL_BUT_HUMAN)
            and rows["human"].number > 0.0 > rows["human"].ratio
        ),
    ),
    "positive-cost": Check(
        _over_sticking("positive_cost_of_transport", _as_it_comes(NEAR_OPTIMUM)),
        _over_sticking("positive_cost_of_transport", _equal(NEAR_OPTIMUM)),
        lambda rows: all(row.number < 0.0 < row.ratio for row in rows.values()),
    ),
    "net-cost-slippery": Check(
        _over_sticking("cost_of_transport", _as_it_comes(LOW)),
        _over_sticking("cost_of_transport", _equal(LOW)),
        lambda rows: (
            all(rows[name].number < 0.0 < rows[name].ratio < 30.0 for name in ALL_BUT_HUMAN)
            and rows["human"].number > 0.0 > rows["human"].ratio
        ),
    ),
    "positive-cost-slippery": Check(
        _over_sticking("positive_cost_of_transport", _as_it_comes(LOW)),
        _over_sticking("positive_cost_of_transport", _equal(LOW)),
        lambda rows: (
            rows["default"].number < 0.0 < rows["clamp"].number
            and rows["default"].ratio < 0.0 < rows["clamp"].ratio
            and rows["human"].number < 0.0 < rows["human"].ratio
        ),
    ),
    "eigenvalues-rise": Check(
        solved(_drop),
        None,
        lambda rows: (
            all(rows[name].number < 0.001 for name in TABLE_1)
            and all(rows[name].number > 0.01 for name in ("heavy", "human"))
        ),
    ),
    "heavy-sticks": Check(
        _at_40_degrees(STICKS), None, lambda rows: all(rows[name].number > 1.0 for name in TABLE_1)
    ),
    "heavy-slips": Check(
        _at_40_degrees(0.3), None, lambda rows: rows["clamp"].number < 1.0 < rows["default"].number
    ),
}
