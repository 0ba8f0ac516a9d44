"""Figure 2: return maps of the classic SLIP at four touchdown angles, and its gaits against the angle."""

import math
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from ...library import classic_slip
from ...pictures import style
from ..evidence import gather_classic
from .columns import Columns

ANGLES = (38.0, 40.0, 42.0, 44.0)
"""Touchdown angles of the maps, degrees."""
COLOURS = ("#9bb8d3", "#1f5fa8", "#e07b00", "#b3216f")
POINTS = 400
SWEPT = 44.588 - 13.288 * np.linspace(1.0, 0.0, 100) ** 2
"""Touchdown angles of the gaits, degrees, closer together towards the fold."""


def map_table() -> Columns:
    """Return maps by column: apex height and next apex height, m."""
    columns: dict[str, list[Any]] = {"angle_degrees": [], "height": [], "next_height": [], "forwards": []}
    for angle in ANGLES:
        parameters = classic_slip.slip(math.radians(angle))
        for height in classic_slip.heights(parameters, POINTS):
            step = classic_slip.step(parameters, height)
            if step.outcome in (classic_slip.FLIES, classic_slip.TURNS_BACK):
                forwards = step.outcome == classic_slip.FLIES
                for name, value in zip(columns, (angle, height, step.next_height, forwards), strict=True):
                    columns[name].append(value)
    return columns


@cache
def gait_table() -> Columns:
    """Gaits by column."""
    gaits = [g for angle in SWEPT for g in classic_slip.fixed_points(math.radians(angle))]
    gaits.append(classic_slip.fold())
    return {
        "angle_degrees": [math.degrees(gait.angle) for gait in gaits],
        "height": [gait.height for gait in gaits],
        "slope": [gait.slope for gait in gaits],
        "stance_friction": [gait.stance_friction for gait in gaits],
        "impact_friction": [gait.impact_friction for gait in gaits],
    }


def draw_maps(path: Path) -> None:
    """Draw figure 2(a)."""
    data = {name: np.array(values) for name, values in map_table().items()}
    with style.styled():
        figure, axes = style.subplots(figsize=(5.6, 5.2))
        for angle, colour in zip(ANGLES, COLOURS, strict=True):
            chosen = data["angle_degrees"] == angle
            for forwards, line in ((True, "-"), (False, ":")):
                rows = chosen & (data["forwards"] == forwards)
                label = rf"$\theta_0$ = {angle:g}°" if forwards else None
                axes.plot(
                    data["height"][rows],
                    _cut(data["next_height"][rows], data["height"][rows]),
                    line,
                    color=colour,
                    label=label,
                )
            for gait in classic_slip.fixed_points(math.radians(angle)):
                axes.plot(gait.height, gait.height, "^" if gait.stable else "s", color=colour, markersize=7)
        _diagonal(axes)
        axes.legend(title="▲ stable   ■ unstable\n… runs backwards", loc="upper left")
        style.label(axes, "apex height (m)", "next apex height (m)")
        style.save(figure, path)


def _cut(values: NDArray[np.float64], at: NDArray[np.float64]) -> NDArray[np.float64]:
    """Insert a gap where the curve is not connected."""
    cut = values.copy()
    if len(at) > 1:
        cut[np.flatnonzero(np.diff(at) > 2.0 * np.median(np.diff(at))) + 1] = np.nan
    return cut


def _diagonal(axes: Axes) -> None:
    top = classic_slip.highest(classic_slip.slip(math.radians(ANGLES[0])))
    axes.plot([0.5, top], [0.5, top], color=style.FAINT, linestyle="-.", linewidth=1.0, zorder=1)
    axes.set_xlim(0.5, 5.5)
    axes.set_ylim(0.5, 8.0)


def branches(data: Columns) -> list[tuple[str, NDArray[np.float64]]]:
    """Rows of the stable and of the unstable gaits, each with the fold."""
    slope = np.array(data["slope"])
    fold = len(slope) - 1
    stable = np.flatnonzero(np.abs(slope[:-1]) < 1.0)
    unstable = np.flatnonzero(slope[:-1] >= 1.0)
    return [("stable", np.append(stable, fold)), ("unstable", np.append(unstable, fold))]


def draw_gaits(path: Path) -> None:
    """Draw figure 2(b)."""
    data = gait_table()
    with style.styled():
        figure, axes = style.subplots(figsize=(5.6, 4.2))
        for (name, rows), line in zip(branches(data), ("-", "--"), strict=True):
            angles = np.array(data["angle_degrees"])[rows]
            axes.plot(angles, np.array(data["height"])[rows], line, color=style.CURVE, label=name)
        angle, height = data["angle_degrees"][-1], data["height"][-1]
        axes.plot(angle, height, "o", color=style.SECOND_CURVE, label=f"fold at {angle:.2f}°")
        lowest = gather_classic().lowest
        angle, height = math.degrees(lowest), classic_slip.fixed_points(lowest)[0].height
        axes.plot(angle, height, "s", color=style.SECOND_CURVE, label=f"period doubling at {angle:.2f}°")
        axes.legend()
        style.label(axes, r"touchdown angle $\theta_0$ (°)", "apex height $y^*$ (m)")
        style.save(figure, path)
