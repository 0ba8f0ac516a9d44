"""Gaits with friction that falls with speed: speed, cost and eigenvalues against the Stribeck velocity."""

from collections.abc import Mapping
from itertools import pairwise

import numpy as np
import pandas
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...analysis.branches import continue_branch
from ...analysis.search import periodic_gait
from ...analysis.special_points import FOLD, WORD_BORDER
from ...library.runner import Runner
from ...pictures import style
from ...pictures.style import CurveLabel
from ...variables.table import FRICTION
from ..along import gait_table
from ..matched import gait_with
from ..statements.claim import SLOPE
from .data import Results

RATIO, VELOCITY = "ground.static_friction_ratio", "ground.stribeck_velocity"
LEVEL, DOWNHILL = 0.0, -3.0
"""Slopes, degrees."""
FRICTIONS: Mapping[float, float] = {LEVEL: 0.3, DOWNHILL: 0.0515}
"""Sliding friction by slope; downhill it is a little less than the slope's tangent."""
RATIOS: Mapping[float, tuple[float, ...]] = {LEVEL: (1.2, 1.5, 2.0, 3.0), DOWNHILL: (1.5, 2.0, 3.0)}
COLOURS: Mapping[float, str] = {1.2: "#5b2a86", 1.5: "#0b7a75", 2.0: "#e07b00", 3.0: "#22303c"}
"""Colour by ratio of static to sliding friction."""
DECADES = (1e-3, 1e-2, 1e-1, 1.0, 10.0)
"""Ends of branches on level ground: steps are relative to the first velocity, so each decade is a branch."""
BEGIN, RANGE, POINTS = 0.1, (0.005, 1.0), 110
"""Branch downhill: velocity at which it begins, range in both directions, and maximum number of gaits."""
MARKS: Mapping[str, str] = {WORD_BORDER: "|", FOLD: "o"}
DRAWN = {
    "speed": "average speed (l₀√(k/m))",
    "cost_of_transport": "cost of transport",
    "lambda_max": "modulus of the largest eigenvalue",
}
COLUMNS = (
    *("slope_degrees", "static_friction_ratio", "stribeck_velocity", "special", "word", "stable"),
    *DRAWN,
)
"""Columns of the data."""
SHOWN = 2.0
"""Largest speed that is drawn; gaits whose foot never sticks go on beyond it."""
SHORT_RUN = 0.4
"""Decades of velocity below which a word is not written."""


def runner_of(runner: Runner, slope: float, ratio: float, velocity: float) -> Runner:
    """Runner for one slope, ratio and Stribeck velocity."""
    ground = {SLOPE: float(np.radians(slope)), FRICTION: FRICTIONS[slope]}
    return runner.replace({**ground, RATIO: ratio, VELOCITY: velocity})


def level(runner: Runner, ratio: float) -> pandas.DataFrame:
    """Gaits and special points of the branch on level ground, decade by decade."""
    return pandas.concat(
        gait_table(
            continue_branch(runner_of(runner, LEVEL, ratio, begin), {VELOCITY: (begin, end)}, switch=False)
        )
        for begin, end in pairwise(DECADES)
    )


def downhill(runner: Runner, ratio: float) -> pandas.DataFrame:
    """Gaits and special points of the branch downhill, through its fold to gaits whose foot never sticks."""
    first = periodic_gait(runner_of(runner, DOWNHILL, RATIOS[DOWNHILL][0], BEGIN))
    low, high = RANGE
    return gait_table(
        continue_branch(
            gait_with(first, RATIO, ratio), {VELOCITY: (high, low)}, max_points=POINTS, switch=False
        )
    )


def table(results: Results) -> pandas.DataFrame:
    """Data of all branches; takes some minutes."""
    found = {
        (slope, ratio): find
        for find, slope in ((level, LEVEL), (downhill, DOWNHILL))
        for ratio in RATIOS[slope]
    }
    tables = [
        find(results.runner, ratio).assign(slope_degrees=slope, static_friction_ratio=ratio)
        for (slope, ratio), find in found.items()
    ]
    return pandas.concat(tables, ignore_index=True)[[*COLUMNS]]


def branch_of(data: pandas.DataFrame, slope: float, ratio: float) -> pandas.DataFrame:
    """Data of one branch, in its order."""
    chosen = (data["slope_degrees"] == slope) & (data["static_friction_ratio"] == ratio)
    return data[chosen].reset_index(drop=True)


def _shown(its: pandas.DataFrame) -> pandas.DataFrame:
    return its[its["speed"] < SHOWN]


def draw(results: Results) -> Figure:
    """Draw level ground on the left and the slope on the right; dashed where gaits are unstable."""
    data = results.table("falling_friction")
    figure, panels = style.subplots(3, 2, figsize=(9.6, 9.0), sharex="col")
    for column, slope in zip(panels.T, RATIOS, strict=True):
        for axes, (name, what) in zip(column, DRAWN.items(), strict=True):
            for ratio in RATIOS[slope]:
                _curve(axes, _shown(branch_of(data, slope, ratio)), name, COLOURS[ratio])
            axes.set_ylabel(what)
            axes.set_xscale("log")
        _write_words(column[0], data, slope)
        column[2].axhline(1.0, **style.LIMIT_LINE)
        column[0].set_title(f"{_named(slope)}, sliding friction {FRICTIONS[slope]:g}")
        column[2].set_xlabel("Stribeck velocity $v_s$ (l₀√(k/m))")
    _key(panels[0, 0])
    figure.legend(loc="outside lower center", ncols=5)
    return figure


def _named(slope: float) -> str:
    return f"slope of {slope:g}°".replace("-", "−") if slope else "level ground"


def _curve(axes: Axes, its: pandas.DataFrame, name: str, colour: str) -> None:
    velocities, heights = its["stribeck_velocity"], its[name]
    style.stable_curve(axes, velocities, heights, its["stable"], colour)
    for kind, marker in MARKS.items():
        here = its["special"] == kind
        axes.plot(velocities[here], heights[here], marker, color=colour, markersize=6, zorder=4)


def _key(axes: Axes) -> None:
    for ratio, colour in COLOURS.items():
        axes.plot([], [], color=colour, label=f"static / sliding friction {ratio:g}")
    style.name_unstable(axes)
    for kind, marker in MARKS.items():
        axes.plot([], [], marker, color=style.INK, label=kind)


def _write_words(axes: Axes, data: pandas.DataFrame, slope: float) -> None:
    """Write each word beside its curve if it holds for long enough."""
    for ratio in RATIOS[slope]:
        its = _shown(branch_of(data, slope, ratio))
        points = its[["stribeck_velocity", "speed"]].to_numpy()
        for word, rows in style.runs_of(its["word"].to_numpy()):
            if np.ptp(np.log10(points[rows, 0])) >= SHORT_RUN:
                CurveLabel(axes, style.word(word), points[rows], color=COLOURS[ratio])
