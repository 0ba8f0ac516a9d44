"""Runners that meet a slippery patch, and whether they fall, by the angle at which the leg comes down on it.

A runner on its gait comes to an apex with the patch before it. For that landing the leg is placed at a
contact angle of its own, and for some strides the friction is another one; then all is as before. By the
reduced map, whose leg is where it is to be placed.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError
from ..library.batch import Batch
from ..library.engine import SETTLED, UNDECIDED
from ..library.gait import Gait
from ..library.runner import Runner
from ..library.varied_stride import plain_stride
from ..variables.table import FRICTION

AFTER = 30
"""Strides after the patch: a runner that has made them is up."""
UP = (SETTLED, UNDECIDED)
"""Fates of runners that are up: one that has made its strides without a gait to settle on is undecided."""
STEEPEST = math.pi / 2.0
"""Bound of the angle at which a leg may be placed, rad from the vertical."""


@dataclass(frozen=True, eq=False)
class PatchOutcomes:
    """Falls and slip of gaits on a patch, by contact angle."""

    fell: NDArray[np.float64]
    """1 or 0, shape (gaits, angles); not a number where the leg cannot be placed so."""
    slip_distance: NDArray[np.float64]
    """Slip distance of the first stride on the patch, m; NaN where the stride does not close."""


def contact_angle_of(gait: Gait) -> float:
    """The angle of the leg from the ground at touchdown, on a gait."""
    angle = dict(zip(("x", "y", "length", "angle"), gait.events[0].state, strict=False))["angle"]
    return 90.0 - math.degrees(angle)


def landing_at(gait: Gait, contact_angle: float) -> Runner | None:
    """The runner of a gait whose leg is placed so that it comes down at an angle, from the gait's apex."""
    values, at = gait.runner, math.radians(90.0 - contact_angle)
    share = values["body.mass"] / (values["body.mass"] + values["foot.mass"])
    drop = float(gait.apex[0]) - share * values["leg.free_length"] * math.cos(at)
    if drop <= 0.0:
        return None
    touchdown_angle = at + values["hip.retraction_rate"] * math.sqrt(2.0 * drop / values["gravity"])
    return (
        gait.runner.replace({"hip.touchdown_angle": touchdown_angle}) if touchdown_angle < STEEPEST else None
    )


def meet_patch(
    gaits: Sequence[Gait], contact_angles: Sequence[float], friction: float, strides: int = 1
) -> PatchOutcomes:
    """Falls and slip of runners on gaits that meet a patch."""
    shape = len(gaits), len(contact_angles)
    fell, slips = np.full(shape, np.nan), np.full(shape, np.nan)
    landings = {
        (row, column): runner.replace({FRICTION: friction})
        for row, gait in enumerate(gaits)
        for column, angle in enumerate(contact_angles)
        if (runner := landing_at(gait, angle)) is not None
    }
    cells, apices = list(landings), [gaits[row].apex for row, _ in landings]
    for cell, apex in zip(cells, apices, strict=True):
        slips[cell] = _slip(landings[cell], apex)
    for cell in cells:
        fell[cell] = 1.0
    up, apices = _followed(cells, [landings[cell] for cell in cells], apices, 1)
    if strides > 1:
        on_patch = [gaits[row].runner.replace({FRICTION: friction}) for row, _ in up]
        up, apices = _followed(up, on_patch, apices, strides - 1)
    after = [gaits[row].runner for row, _ in up]
    for cell in _followed(up, after, apices, AFTER, [[gaits[row].apex] for row, _ in up])[0]:
        fell[cell] = 0.0
    return PatchOutcomes(fell, slips)


def _followed(
    cells: Sequence[tuple[int, int]],
    runners: Sequence[Runner],
    apices: Sequence[NDArray[np.float64]],
    strides: int,
    until: Sequence[Sequence[NDArray[np.float64]]] | None = None,
) -> tuple[list[tuple[int, int]], list[NDArray[np.float64]]]:
    """Those that are up after some strides, and their apices then."""
    if not cells:
        return [], []
    run = Batch(runners, np.array(apices)).run(strides, until)
    kept = np.flatnonzero(np.isin(run.fate, UP)).tolist()
    return [cells[k] for k in kept], list(run.apex[kept])


def _slip(runner: Runner, apex: NDArray[np.float64]) -> float:
    """Slip distance of one stride; NaN where it does not close."""
    try:
        return float(plain_stride(runner, apex, ["slip_distance"]).quantities[0])
    except (InputError, RunError):
        return math.nan
