"""Claims about regions of attraction, viable sets, the reduced map, and feedback from stride to stride."""

from collections.abc import Callable, Mapping, Sequence
from functools import cache, partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ...analysis.attraction import DISTURBED, FARTHEST, Robustness, attraction_volume, robustness
from ...analysis.basin import basin
from ...analysis.search import periodic_gait
from ...errors import RunError
from ...feedback.gains import Feedback, dead_beat, lqr
from ...library.engine import SETTLED
from ...library.gait import Gait
from ...library.laws import AffineLaw
from ...library.runner import Runner
from ...library.section import COORDINATES
from ...variables.table import FRICTION
from ...viable_sets.viability import viability
from ..matched import IN_TWO, match_gait
from .claim import (
    ANGLE,
    HEAVY,
    HUMAN,
    RATE,
    SLIPS,
    STICKS,
    TORQUE,
    Estimate,
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
)
from .gaits import swept
from .rough_ground import STICKING, Design, faster, strides

if TYPE_CHECKING:
    import xarray


# Regions of attraction, and the largest disturbances that are recovered from, sticking and slipping

SAMPLES = 4000
"""Starts for each share, drawn from a box in all six coordinates."""
LIGHT = 0.005
"""Gravity of a runner of half the weight of Table 1."""


@cache
def _share(one: Gait, seed: int, law: AffineLaw | None = None) -> Estimate:
    """Share of the box of `analysis.attraction` that settles on a gait."""
    found = attraction_volume(one, SAMPLES, seed=seed, law=law)
    return Estimate(found.share, *found.interval)


def share(which: Which, draw: int = 0, design: Design | None = None) -> Measure:
    """Share of the box that settles on a gait; other numbers `draw` give other starts."""

    def measure(regime: Regime, seed: int) -> Estimate:
        one = which(regime)
        return _share(one, 2 * seed + draw, design and design(one))

    return measure


def _light(regime: Regime, friction: float) -> Gait:
    if regime in (HEAVY, HUMAN):
        raise RunError("not computed")
    return gait(regime, friction, gravity=LIGHT)


@cached_with_errors
def _light_control(regime: Regime) -> Gait:
    return equal_to(_light(regime, STICKS), _light(regime, SLIPS))


@cache
def _robustness(one: Gait, law: AffineLaw | None) -> Robustness:
    return robustness(one, law=law)


def largest(disturbance: str, which: Which, design: Design | None = None) -> Measure:
    """The largest disturbance that is recovered from, over the scale of its coordinate."""

    def measure(regime: Regime, seed: int) -> Estimate:
        one = which(regime)
        found = getattr(_robustness(one, design and design(one)), disturbance)
        value = float(found / one.runner.scales[COORDINATES.index(DISTURBED[disturbance])])
        return Estimate(value, min(value, FARTHEST), value)

    return measure


AS_STICKING = of(runner_on, SLIPS, STICKS)
"""The slipping runner, matched to the sticking one."""
ATTRACTION: Measures = {
    "attraction": (share(STICKING), share(AS_STICKING, 1)),
    "attraction-light": (share(of(_light, STICKS)), share(_light_control, 1)),
    "push-forward": (largest("push_forward", STICKING), largest("push_forward", AS_STICKING)),
    "step-up": (largest("step_up", STICKING), largest("step_up", AS_STICKING)),
    "step-down": (largest("step_down", STICKING), largest("step_down", AS_STICKING)),
}


# Viable sets, slipping and sticking: apexes from which some touchdown angle at each apex prevents a fall

VIABLE_CELLS = 96
Range = tuple[float, float]
VIABLE_PLANE: Mapping[str, Range] = {"com_height": (0.3, 4.0), "com_speed": (0.0, 4.0)}
VIABLE_PLANES: Mapping[str, Mapping[str, Range]] = {
    "human": {"com_height": (0.6, 1.4), "com_speed": (0.0, 6.0)}
}
"""Ranges of height in m and speed in m/s, and by regime where they differ from these."""
CHOSEN = {ANGLE: (0.1, 1.3, 24)}
"""Angles that may be chosen at each apex. Four times as many changed no share by more than 0.016."""


@cached_with_errors
def _viable(regime: Regime, friction: float, reference: float | None = None) -> "xarray.Dataset":
    """Viable set of the reduced map, which has no swing and is the same in both readings."""
    runner = Runner({**regime.values, FRICTION: friction}, model="reduced")
    if reference is not None:
        gaits = periodic_gait(runner.replace({FRICTION: reference})), periodic_gait(runner)
        runner = match_gait(*gaits, *IN_TWO).runner
    return viability(runner, axes=VIABLE_PLANES.get(regime.name, VIABLE_PLANE), vary=CHOSEN, n=VIABLE_CELLS)


def _enclosed(
    inner: Callable[["xarray.Dataset"], float], outer: Callable[["xarray.Dataset"], float]
) -> Callable[..., Measure]:
    def of(friction: float, reference: float | None = None) -> Measure:
        def measure(regime: Regime, seed: int) -> Estimate:
            found = _viable(regime, friction, reference)
            low, high = inner(found), outer(found)
            return Estimate(0.5 * (low + high), low, high)

        return measure

    return of


_viable_share = _enclosed(lambda found: found.inner_share, lambda found: found.outer_share)
_viable_actions = _enclosed(
    lambda found: float(found["inner_robustness"].mean()),
    lambda found: float(found["outer_robustness"].mean()),
)

VIABLE: Measures = {
    "viable": (_viable_share(SLIPS), _viable_share(STICKS, SLIPS)),
    "viable-angles": (_viable_actions(SLIPS), _viable_actions(STICKS, SLIPS)),
    "viable-angles-between": (_viable_actions(1.2, SLIPS), _viable_actions(SLIPS)),
}


# Statements on the reduced map beside the full model, at each friction

STARTS = 64
STARTS_PLANE = {"com_height": (0.6, 4.0), "com_speed": (-1.0, 2.5)}
STARTS_PLANES = {"human": {"com_height": (0.85, 1.3), "com_speed": (0.5, 5.0)}}
"""Ranges of height in m and speed in m/s of the starts, and by regime where they differ from these."""


@cache
def _both(regime: Regime) -> "tuple[xarray.Dataset, xarray.Dataset]":
    """Gaits of the full model and of the reduced map at the frictions at which both have one."""
    models = [swept(regime, model).gaits for model in ("full", "reduced")]
    found = np.all([gaits["word"].values != "" for gaits in models], axis=0)
    if not found.any():
        raise RunError("no common gait")
    full, small = (gaits.isel({FRICTION: found}) for gaits in models)
    return full, small


def _same_words(regime: Regime) -> float:
    """Share of the frictions with gaits of both models at which the words are the same."""
    full, small = _both(regime)
    return float(np.mean(full["word"].values == small["word"].values))


def _percent_of(quantity: str) -> Measure:
    """Largest difference in a quantity at any friction, per cent of that of the full model."""

    def percent(regime: Regime) -> float:
        full, small = (gaits[quantity].values for gaits in _both(regime))
        return float(np.max(100.0 * np.abs(small / full - 1.0)))

    return solved(percent)


def _eigenvalue(number: int) -> Measure:
    """Largest difference between an eigenvalue of both models at any friction."""

    def distance(regime: Regime) -> float:
        full, small = (
            gaits["eigenvalue_real"].values[:, number] + 1j * gaits["eigenvalue_imag"].values[:, number]
            for gaits in _both(regime)
        )
        return float(np.max(np.abs(small - full)))

    return solved(distance)


@cache
def _settles(regime: Regime, model: str) -> NDArray[np.bool_]:
    """Mask of the starts that settle on the gait, over a plane of height and speed."""
    found = basin(
        {**regime.values, FRICTION: 0.6}, STARTS_PLANES.get(regime.name, STARTS_PLANE), STARTS, model=model
    )
    settled: NDArray[np.bool_] = found["fate"].values == SETTLED
    return settled


def _only(model: str, other: str) -> Measure:
    """Share of the starts that settle by one model but not by the other."""
    return solved(lambda regime: float(np.mean(_settles(regime, model) & ~_settles(regime, other))))


def _retracted(model: str) -> Measure:
    """Growth of the size of the second eigenvalue, which belongs to height, with the rate of retraction."""

    def growth(regime: Regime) -> float:
        runner = Runner({**regime.values, FRICTION: STICKS}, model=model)
        retracting = runner.replace({RATE: faster(runner)})
        sizes = [abs(periodic_gait(one).eigenvalues[1]) for one in (runner, retracting)]
        return float(sizes[1] - sizes[0])

    return solved(growth)


REDUCED: Measures = {
    "reduced-words": (solved(_same_words), None),
    "reduced-speed": (_percent_of("speed"), None),
    "reduced-period": (_percent_of("period"), None),
    "reduced-largest": (_eigenvalue(0), None),
    "reduced-second": (_eigenvalue(1), None),
    "reduced-retraction": (_retracted("full"), _retracted("reduced")),
    "reduced-falls": (_only("full", "reduced"), _only("reduced", "full")),
}


# Feedback from stride to stride, beside a runner that carries its foot higher without any

SETTINGS = (ANGLE, TORQUE)
MODERATE, SLIPPERY = 0.6, 0.1
NEGLIGIBLE = 0.05
"""Size of an eigenvalue that a dead-beat law leaves as it is."""
ANGLE_REACH, TORQUE_REACH = 0.1, 0.5
"""Largest change of a setting: rad, and as a share of the gait's own torque."""
MAX_STRIDES = 400


@cache
def regulator(one: Gait, settings: Sequence[str] = SETTINGS) -> Feedback:
    """A quadratic regulator of touchdown angle and stance torque, within limits."""
    return lqr(one, settings, limits=_limits(one, settings))


@cache
def dead_beat_law(one: Gait) -> Feedback:
    """A law of both settings, within the same limits, that removes a small disturbance in two strides."""
    return dead_beat(one, SETTINGS, limits=_limits(one, SETTINGS), negligible=NEGLIGIBLE)


def _limits(one: Gait, settings: Sequence[str]) -> dict[str, tuple[float, float]]:
    reach = {ANGLE: ANGLE_REACH, TORQUE: TORQUE_REACH * one.runner[TORQUE]}
    return {name: (one.runner[name] - reach[name], one.runner[name] + reach[name]) for name in settings}


_of_400 = partial(strides, max_strides=MAX_STRIDES)
BETWEEN, ON_ICE, AS_HIGH = of(runner_on, MODERATE), of(runner_on, SLIPPERY), of(runner_on, MODERATE, SLIPS)
"""Runners on moderate and on slippery ground, and the one with its foot as high as on friction 0.2."""
CLEARANCE = over_length(BETWEEN, "foot_clearance")

FEEDBACK: Measures = {
    "feedback-strides": (_of_400(BETWEEN, draw=(3, 1), design=regulator), _of_400(BETWEEN, draw=(3, 0))),
    "feedback-without": (largest("step_up", BETWEEN), CLEARANCE),
    "feedback-with": (largest("step_up", BETWEEN, regulator), CLEARANCE),
    "feedback-matched": (_of_400(AS_HIGH, draw=(3, 2)), _of_400(BETWEEN, draw=(3, 0))),
    "feedback-dead-beat": (
        _of_400(ON_ICE, draw=(3, 1), design=dead_beat_law),
        _of_400(ON_ICE, draw=(3, 0)),
    ),
    "feedback-step-down": (largest("step_down", STICKING, regulator), largest("step_down", STICKING)),
    "feedback-attraction": (share(STICKING, 1, regulator), share(STICKING)),
}

MEASURES = ATTRACTION | VIABLE | REDUCED | FEEDBACK
