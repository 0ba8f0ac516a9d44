"""Panels that several of the paper's figures have in common."""

from collections.abc import Collection, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from . import style
from .stride import Stride

TIME_LABEL = "time t (√(m/k))"
VELOCITY_LABEL = "foot velocity ẋ (l₀√(k/m))"
RATIO_LABEL = r"force ratio $f_x/f_y$"
MARGIN = 0.08
"""Shown before and after the stance, over its length."""
SHORT = 0.004
"""A mode that lasts less than this share of what is shown gets a dot: its line would not be seen."""


def mark_stance(axes: Axes, stride: Stride) -> None:
    """Enclose the stance in vertical dashed lines."""
    for time in stride.stance_times:
        axes.axvline(time, **style.STANCE_LINE)


def mark_mid_stance(axes: Axes, stride: Stride) -> None:
    """A vertical dash-dotted line where theta = 0 and the torque ends."""
    for time in stride.times_of("midstance"):
        axes.axvline(time, **style.MID_STANCE_LINE)


def modes(
    axes: Axes, stride: Stride, values: NDArray[np.float64], shown: float, wanted: Collection[str]
) -> None:
    """A curve over time in the colours of the contact modes: slip dashed, all else solid."""
    for interval in stride.intervals:
        if interval.mode not in wanted:
            continue
        time, value, colour = (
            stride.time[interval.rows],
            values[interval.rows],
            style.MODE_COLOURS[interval.mode],
        )
        if np.ptp(time) < SHORT * shown:
            axes.plot(time[-1], value[-1], "o", color=colour, markersize=5, zorder=4)
        else:
            axes.plot(
                time, value, color=colour, linestyle=style.dashes(interval.mode), linewidth=2.0, zorder=3
            )


def mode_key(stride: Stride, wanted: Collection[str]) -> list[Line2D]:
    """Legend entries of the contact modes that occur, in the order of their first appearance."""
    names = [name for name in dict.fromkeys(stride.modes) if name in wanted]
    return [
        Line2D(
            [],
            [],
            color=style.MODE_COLOURS[name],
            linewidth=2.0,
            linestyle=style.dashes(name),
            label=style.MODE_NAMES[name],
        )
        for name in names
    ]


def key_below(figure: Figure, strides: Sequence[Stride]) -> None:
    """One row of legend below everything, for the modes of all strides shown."""
    entries = {line.get_label(): line for stride in strides for line in mode_key(stride, style.MODE_COLOURS)}
    figure.legend(handles=list(entries.values()), loc="outside lower center", ncols=len(entries))


def foot_velocity(axes: Axes, stride: Stride, stance_only: bool) -> None:
    """The foot's tangential velocity; its jump is the impact."""
    start, end = stride.stance_times
    shown = (1.0 + 2.0 * MARGIN) * (end - start) if stance_only else stride.time[-1]
    modes(axes, stride, stride["foot.vx"], shown, style.MODE_COLOURS)
    rows = stride.stance
    before, after = rows.start - 1, rows.start
    axes.plot(
        stride.time[[before, after]],
        stride["foot.vx"][[before, after]],
        color=style.FAINT,
        linewidth=1.0,
        linestyle=":",
        zorder=2,
    )
    axes.axhline(0.0, color=style.GROUND, linewidth=0.8, zorder=0)
    if stance_only:
        near_stance(axes, stride)
    style.label(axes, TIME_LABEL, VELOCITY_LABEL)


def force_ratio(axes: Axes, stride: Stride) -> None:
    """f_x/f_y in the stance, the friction cone's edges, and the ratio of impulses at the impact."""
    ratio = np.full(len(stride.time), np.nan)
    rows = stride.stance
    ratio[rows] = stride["contact.fx"][rows] / stride["contact.fy"][rows]
    start, end = stride.stance_times
    modes(axes, stride, ratio, end - start, style.LOADED)
    friction = stride.gait.friction
    for edge, name in ((friction, r"$+\mu$"), (-friction, r"$-\mu$")):
        axes.axhline(edge, **style.LIMIT_LINE)
        axes.annotate(
            name,
            (1.0, edge),
            xycoords=("axes fraction", "data"),
            xytext=(4, 0),
            textcoords="offset points",
            va="center",
        )
    axes.plot(
        stride.stance_times[0],
        stride.impulse_ratio,
        "x",
        color=style.INK,
        markersize=8,
        markeredgewidth=1.8,
        zorder=4,
        clip_on=False,
    )
    axes.set_ylim(-1.18 * friction, 1.18 * friction)
    near_stance(axes, stride)
    style.label(axes, TIME_LABEL, RATIO_LABEL)


def near_stance(axes: Axes, stride: Stride) -> None:
    """Show the stance and a little before and after."""
    start, end = stride.stance_times
    margin = MARGIN * (end - start)
    axes.set_xlim(start - margin, end + margin)
