"""Viable sets, slipping and sticking: apexes from which some touchdown angle at each apex prevents a fall."""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from ...analysis.search import periodic_gait
from ...library.runner import Runner
from ...variables.table import FRICTION
from ...viable_sets.viability import viability
from .claim import (
    ALL_BUT_HUMAN,
    ANGLE,
    SLIPS,
    STICKS,
    TABLE_1,
    TORQUE,
    Check,
    Estimate,
    Measure,
    Regime,
    made_equal,
    remembered,
)

if TYPE_CHECKING:
    import xarray

CELLS = 96
Range = tuple[float, float]
PLANE: Mapping[str, Range] = {"com_height": (0.3, 4.0), "com_speed": (0.0, 4.0)}
PLANES: Mapping[str, Mapping[str, Range]] = {"human": {"com_height": (0.6, 1.4), "com_speed": (0.0, 6.0)}}
"""Ranges of height in m and speed in m/s, and by regime where they differ from these."""
CHOSEN = {ANGLE: (0.1, 1.3, 24)}


@remembered
def _viable(regime: Regime, friction: float, reference: float | None = None) -> "xarray.Dataset":
    """Viable set of the reduced map, which has no swing and is the same in both readings."""
    runner = Runner({**regime.values, FRICTION: friction}, model="reduced")
    if reference is not None:
        gaits = periodic_gait(runner.replace({FRICTION: reference})), periodic_gait(runner)
        runner = made_equal(*gaits, ("speed", "apex_height"), (TORQUE, ANGLE)).runner
    return viability(runner, axes=PLANES.get(regime.name, PLANE), vary=CHOSEN, n=CELLS)


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


_share = _enclosed(lambda found: found.inner_share, lambda found: found.outer_share)
_robustness = _enclosed(
    lambda found: float(found["inner_robustness"].mean()),
    lambda found: float(found["outer_robustness"].mean()),
)

CHECKS = {
    "viable": Check(_share(SLIPS), _share(STICKS, SLIPS), lambda rows: rows.above(*ALL_BUT_HUMAN)),
    "viable-angles": Check(_robustness(SLIPS), _robustness(STICKS, SLIPS), lambda rows: rows.below(*TABLE_1)),
    "viable-angles-between": Check(
        _robustness(1.2, SLIPS), _robustness(SLIPS), lambda rows: rows.above(*TABLE_1)
    ),
}
