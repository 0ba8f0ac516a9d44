"""Statements on the reduced map beside the full model, at each friction."""

from collections.abc import Callable
from functools import cache

import numpy as np
from numpy.typing import NDArray

from ...analysis.basin import basin
from ...analysis.search import periodic_gait
from ...errors import RunError
from ...library.engine import SETTLED
from ...library.gait import Gait
from ...library.runner import Runner
from ...variables.table import FRICTION
from .claim import STICKS, TABLE_1, Check, Measure, Regime, solved
from .over_friction import swept
from .retraction import RATE, faster

CELLS = 64
PLANE = {"com_height": (0.6, 4.0), "com_speed": (-1.0, 2.5)}
PLANES = {"human": {"com_height": (0.85, 1.3), "com_speed": (0.5, 5.0)}}
"""Ranges of height in m and speed in m/s of the starts, and by regime where they differ from these."""


@cache
def _pairs(regime: Regime) -> tuple[tuple[Gait, Gait], ...]:
    """Gaits of both models at the frictions at which both have one."""
    full, small = (swept(regime, model).by_value for model in ("full", "reduced"))
    pairs = tuple((one, other) for one, other in zip(full, small, strict=True) if one and other)
    if not pairs:
        raise RunError("no common gait")
    return pairs


def _same_words(regime: Regime) -> float:
    """Share of the frictions with gaits of both models at which the words are the same."""
    pairs = _pairs(regime)
    return sum(full.word == small.word for full, small in pairs) / len(pairs)


def _farthest(distance: Callable[[Gait, Gait], float]) -> Measure:
    """Largest difference between the two models at any friction."""
    return solved(lambda regime: max(distance(*pair) for pair in _pairs(regime)))


def _percent_of(quantity: str) -> Measure:
    return _farthest(lambda full, small: 100.0 * abs(small.stride[quantity] / full.stride[quantity] - 1.0))


def _eigenvalue(number: int) -> Measure:
    return _farthest(lambda full, small: abs(small.eigenvalues[number] - full.eigenvalues[number]))


@cache
def _settles(regime: Regime, model: str) -> NDArray[np.bool_]:
    """Whether each start settles on the gait, over a plane of height and speed."""
    found = basin({**regime.values, FRICTION: 0.6}, PLANES.get(regime.name, PLANE), CELLS, model=model)
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


CHECKS = {
    "reduced-words": Check(
        solved(_same_words), None, lambda rows: all(rows[name].number > 0.99 for name in TABLE_1)
    ),
    "reduced-speed": Check(
        _percent_of("speed"),
        None,
        lambda rows: all(rows[name].number < 0.1 for name in TABLE_1) and rows["heavy"].number < 3.0,
    ),
    "reduced-period": Check(
        _percent_of("period"), None, lambda rows: all(rows[name].number < 1.1 for name in TABLE_1)
    ),
    "reduced-largest": Check(
        _eigenvalue(0), None, lambda rows: all(rows[name].number < 2e-3 for name in TABLE_1)
    ),
    "reduced-second": Check(
        _eigenvalue(1), None, lambda rows: rows["clamp"].number < 0.07 < rows["default"].number < 0.13
    ),
    "reduced-retraction": Check(
        _retracted("full"),
        _retracted("reduced"),
        lambda rows: rows["default"].ratio < 0.0 < rows["clamp"].ratio,
    ),
    "reduced-falls": Check(
        _only("full", "reduced"),
        _only("reduced", "full"),
        lambda rows: (
            all(rows[name].ratio > 1.0 for name in TABLE_1)
            and all(rows[name].ratio < 1.0 for name in ("heavy", "human"))
        ),
    ),
}
