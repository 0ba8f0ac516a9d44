"""Regions of attraction, and the largest disturbances that are recovered from, sticking and slipping."""

from functools import cache

from ...analysis.robustness import DISTURBED, FARTHEST, Robustness, robustness
from ...analysis.volume import volume
from ...errors import RunError
from ...library.affine_law import AffineLaw
from ...library.gait import Gait
from ...library.section import COORDINATES
from .claim import (
    CLAMPED,
    DEFAULT,
    HEAVY,
    HUMAN,
    SLIPS,
    STICKS,
    Estimate,
    Measure,
    OwnClaim,
    Regime,
    equal_to,
    gait,
)
from .rough import runner_on

SAMPLES = 4000
"""Starts for each share, drawn from a box in all six coordinates."""
LIGHT = 0.005
"""Gravity of a runner of half the weight of Table 1."""
BASIN = "tdmf-slip basin --friction 10 --n 8 --ball none"


def share_of(one: Gait, seed: int, law: AffineLaw | None = None) -> Estimate:
    """Share of the box of `analysis.volume` that settles on a gait."""
    found = volume(one, SAMPLES, seed=seed, law=law)
    return Estimate(found.share, *found.interval)


def _share(friction: float, reference: float | None = None) -> Measure:
    """Share of the box that settles on the gait. Value and control have independent starts."""
    return lambda regime, seed: share_of(
        runner_on(regime, friction, reference), 2 * seed + (reference is not None)
    )


def _light_gait(regime: Regime, friction: float) -> Gait:
    if regime in (HEAVY, HUMAN):
        raise RunError("not asked")
    return gait(regime, friction, gravity=LIGHT)


def _light_share(regime: Regime, seed: int) -> Estimate:
    return share_of(_light_gait(regime, STICKS), 2 * seed)


def _light_control(regime: Regime, seed: int) -> Estimate:
    return share_of(equal_to(_light_gait(regime, STICKS), _light_gait(regime, SLIPS)), 2 * seed + 1)


@cache
def _robustness(regime: Regime, friction: float, reference: float | None) -> Robustness:
    return robustness(runner_on(regime, friction, reference))


def over_scale(disturbance: str, found: Robustness, one: Gait) -> Estimate:
    """The largest disturbance that is recovered from, over the scale of its coordinate."""
    scale = one.runner.scales[COORDINATES.index(DISTURBED[disturbance])]
    largest = float(getattr(found, disturbance) / scale)
    return Estimate(largest, min(largest, FARTHEST), largest)


def _largest(disturbance: str, friction: float, reference: float | None = None) -> Measure:
    return lambda regime, seed: over_scale(
        disturbance, _robustness(regime, friction, reference), gait(regime, friction)
    )


CLAIMS = (
    OwnClaim(
        "attraction",
        "A slipping runner attracts more starts: share of a box in all six coordinates of the apex that "
        "settles on the gait on friction 10, and (control) on the gait of the equal runner on friction 0.2. "
        "All regimes have the same box. The human preset attracts at most about a hundredth of it, sticking "
        "or slipping.",
        _share(STICKS),
        _share(SLIPS, STICKS),
        f"{BASIN} --samples {SAMPLES}",
        lambda rows: (
            all(rows[of.name].below for of in (DEFAULT, CLAMPED))
            and rows[HEAVY.name].ratio < 0.5
            and not rows[HUMAN.name].below
        ),
    ),
    OwnClaim(
        "attraction-light",
        "Weight decides how much more: at half the weight of Table 1 the difference is less than a tenth, "
        "and at twice the weight (column of weight 0.022 in the row above) slipping attracts more than "
        "twice as much.",
        _light_share,
        _light_control,
        f"{BASIN} --samples {SAMPLES} --set gravity={LIGHT}",
        lambda rows: all(0.9 < rows[of.name].ratio < 1.0 for of in (DEFAULT, CLAMPED)),
    ),
    OwnClaim(
        "push-forward",
        "Largest push forward at the apex that is recovered from, over l₀√(k/m), on friction 10 and "
        "(control) on 0.2 at equal speed, apex height and leg angle. The largest that was tried is 5.",
        _largest("push_forward", STICKS),
        _largest("push_forward", SLIPS, STICKS),
        f"{BASIN} --samples 0",
        lambda rows: all(rows[of.name].below for of in (DEFAULT, CLAMPED)),
    ),
    OwnClaim(
        "step-up",
        "Likewise the largest step up, over l₀.",
        _largest("step_up", STICKS),
        _largest("step_up", SLIPS, STICKS),
        f"{BASIN} --samples 0",
        lambda rows: all(rows[of.name].below for of in (DEFAULT, CLAMPED)),
    ),
    OwnClaim(
        "step-down",
        "Likewise the largest step down, over l₀.",
        _largest("step_down", STICKS),
        _largest("step_down", SLIPS, STICKS),
        f"{BASIN} --samples 0",
        lambda rows: all(rows[of.name].below for of in (DEFAULT, CLAMPED)),
    ),
)
