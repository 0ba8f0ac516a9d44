"""Regions of attraction, and the largest disturbances that are recovered from, sticking and slipping."""

from collections.abc import Callable

from ...analysis.attraction import DISTURBED, FARTHEST, Robustness, robustness, volume
from ...errors import RunError
from ...library.gait import Gait
from ...library.laws import AffineLaw
from ...library.section import COORDINATES
from .claim import (
    HEAVY,
    HUMAN,
    SLIPS,
    STICKS,
    TABLE_1,
    Check,
    Estimate,
    Measure,
    Regime,
    equal_to,
    gait,
    remembered,
)
from .rough import runner_on

SAMPLES = 4000
"""Starts for each share, drawn from a box in all six coordinates."""
LIGHT = 0.005
"""Gravity of a runner of half the weight of Table 1."""
Design = Callable[[Regime, float], AffineLaw]
"""Designs a law for the gait of a regime at a friction."""


def _share_of(one: Gait, seed: int, law: AffineLaw | None = None) -> Estimate:
    """Share of the box of `analysis.attraction` that settles on a gait."""
    found = volume(one, SAMPLES, seed=seed, law=law)
    return Estimate(found.share, *found.interval)


@remembered
def _share(
    regime: Regime, friction: float, reference: float | None, design: Design | None, seed: int
) -> Estimate:
    return _share_of(runner_on(regime, friction, reference), seed, design and design(regime, friction))


def share(friction: float, reference: float | None = None, design: Design | None = None) -> Measure:
    """Share of the box that settles on the gait. Other runners and laws have other starts than the gait."""
    other = reference is not None or design is not None
    return lambda regime, seed: _share(regime, friction, reference, design, 2 * seed + other)


def _light_gait(regime: Regime, friction: float) -> Gait:
    if regime in (HEAVY, HUMAN):
        raise RunError("not computed")
    return gait(regime, friction, gravity=LIGHT)


def _light_share(regime: Regime, seed: int) -> Estimate:
    return _share_of(_light_gait(regime, STICKS), 2 * seed)


def _light_control(regime: Regime, seed: int) -> Estimate:
    return _share_of(equal_to(_light_gait(regime, STICKS), _light_gait(regime, SLIPS)), 2 * seed + 1)


@remembered
def _robustness(
    regime: Regime, friction: float, reference: float | None, design: Design | None
) -> Robustness:
    law = design and design(regime, friction)
    return robustness(runner_on(regime, friction, reference), law=law)


def largest(
    disturbance: str, friction: float, reference: float | None = None, design: Design | None = None
) -> Measure:
    """The largest disturbance that is recovered from, over the scale of its coordinate."""

    def measure(regime: Regime, seed: int) -> Estimate:
        found = getattr(_robustness(regime, friction, reference, design), disturbance)
        scale = gait(regime, friction).runner.scales[COORDINATES.index(DISTURBED[disturbance])]
        value = float(found / scale)
        return Estimate(value, min(value, FARTHEST), value)

    return measure


CHECKS = {
    "attraction": Check(
        share(STICKS),
        share(SLIPS, STICKS),
        lambda rows: rows.below(*TABLE_1) and rows[HEAVY.name].ratio < 0.5 and not rows.below(HUMAN.name),
    ),
    "attraction-light": Check(
        _light_share, _light_control, lambda rows: all(0.9 < rows[name].ratio < 1.0 for name in TABLE_1)
    ),
    "push-forward": Check(
        largest("push_forward", STICKS),
        largest("push_forward", SLIPS, STICKS),
        lambda rows: rows.below(*TABLE_1),
    ),
    "step-up": Check(
        largest("step_up", STICKS), largest("step_up", SLIPS, STICKS), lambda rows: rows.below(*TABLE_1)
    ),
    "step-down": Check(
        largest("step_down", STICKS), largest("step_down", SLIPS, STICKS), lambda rows: rows.below(*TABLE_1)
    ),
}
