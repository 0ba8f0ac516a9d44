"""Shortest patch on which a runner falls downhill, by friction on the patch and around it."""

import numpy as np
import pandas
from matplotlib.figure import Figure
from numpy.typing import NDArray

from ...analysis.sweeps import gaits_in
from ...library.gait import Gait
from ...pictures import style
from ...pictures.style import CurveLabel
from ..matched import IN_TWO, falls_on_patch, match_gaits
from ..statements.claim import SLOPE
from ..statements.rough_ground import DOWNHILL
from .data import Results

OUTSIDE = (10.0, 1.2, 0.6)
"""Frictions of the ground around the patch."""
ON_PATCH = np.linspace(0.0, 0.1, 11)
LENGTHS = np.geomspace(100.0, 2000.0, 14)
"""Lengths of the patch, over that of the leg."""
RUNNERS = 32
COLOURS = ("#22303c", "#0b7a75", "#e07b00")
LEADER = 14.0
"""Points between the line of the slope's tangent and its label."""
NEVER = 1.25 * LENGTHS[-1]
"""Length at which a point is drawn if no runner falls at any length."""


def gaits(results: Results) -> list[tuple[Gait, bool]]:
    """Gaits on each ground, and gaits matched in speed and apex height to the last ground's, with True."""
    own = [results.gait(friction, **{SLOPE: f"{DOWNHILL} deg"}) for friction in OUTSIDE]
    alike = gaits_in(match_gaits([own[-1], *own[:-1]], *IN_TWO))
    return [*((gait, False) for gait in own), *((gait, True) for gait in alike)]


def falls(gait: Gait, friction: float, length: float) -> int:
    """Number of runners that fall on a patch."""
    return falls_on_patch(gait, friction, length, RUNNERS)


def table(results: Results) -> pandas.DataFrame:
    """Falls by ground, friction and length of the patch; takes minutes."""
    rows = [
        (gait.friction, matched, gait.stride["speed"], friction, length, falls(gait, friction, length))
        for gait, matched in gaits(results)
        for friction in ON_PATCH
        for length in LENGTHS
    ]
    names = ["friction", "matched", "speed", "patch_friction", "length", "falls"]
    return pandas.DataFrame(rows, columns=names)


def shortest(data: pandas.DataFrame, friction: float, matched: bool) -> NDArray[np.float64]:
    """Length of the shortest patch with a fall by friction on the patch, infinite if there is none."""
    its = data[(data["friction"] == friction) & (data["matched"] == matched)]
    lengths = its["length"].where(its["falls"] > 0, np.inf).groupby(its["patch_friction"])
    found: NDArray[np.float64] = lengths.min().to_numpy()
    return found


def draw(results: Results) -> Figure:
    """Draw a curve for each ground, and crosses for runners matched to the last ground's."""
    data = results.table("slippery_patch")
    figure, axes = style.subplots(figsize=(6.4, 4.6))
    for friction, colour in zip(OUTSIDE, COLOURS, strict=True):
        own = shortest(data, friction, matched=False)
        axes.plot(
            ON_PATCH,
            np.minimum(own, NEVER),
            "o-",
            color=colour,
            label=f"friction {friction:g} around the patch",
        )
        if friction != OUTSIDE[-1]:
            alike = shortest(data, friction, matched=True)
            axes.plot(ON_PATCH, np.minimum(alike, NEVER), "x", color=colour, markersize=8)
    axes.plot([], [], "x", color=style.INK, label="speed and apex height as at friction 0.6")
    axes.axhline(LENGTHS[-1], **style.LIMIT_LINE)
    slope = float(np.tan(np.radians(-DOWNHILL)))
    axes.axvline(slope, **style.LIMIT_LINE)
    along = np.array([(slope, length) for length in LENGTHS])
    CurveLabel(axes, "tangent of the slope", along, distances=(LEADER,))
    axes.text(ON_PATCH[0], 1.1 * NEVER, "above the dashed line: no fall up to 2,000 l₀", va="bottom")
    axes.set_yscale("log")
    axes.set_ylim(0.9 * LENGTHS[0], 1.4 * NEVER)
    axes.set_xlabel("friction on the patch")
    axes.set_ylabel("shortest patch on which a runner falls (l₀)")
    axes.legend(loc="lower right")
    return figure
