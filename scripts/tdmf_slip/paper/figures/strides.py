"""Figures 5 to 8: strides of the gaits at frictions from 10 to 0.2.

Solid lines of figure 5 are the default reading, dotted lines the reading with the clamp of equation (12).
"""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import pandas
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...pictures import panels, style
from ...pictures.panels import Stride
from .data import Results

Which = tuple[float, bool]
"""Friction of a stride's gait, and whether the swing has the clamp of (12)."""
STICKING: Sequence[Which] = (10.0, False), (10.0, True)
LANDING: Sequence[Which] = ((1.2, False),)
THREE_SLIPS: Sequence[Which] = ((0.6, False),)
LOW: Sequence[Which] = (0.43, False), (0.2, False)
"""Gaits whose foot only sticks, slides on landing, or slips three times, and those at low friction."""
CLAMPED: Mapping[str, Any] = {"linestyle": (0.0, (1.0, 1.2)), "linewidth": 1.3, "zorder": 2}
COLUMNS = (
    *("time", "com.y", "foot.x", "foot.y", "foot.vx"),
    *("leg.length", "leg.angle", "contact.fx", "contact.fy", "contact.mode"),
)
"""Recorded quantities in the data."""


def table(which: Sequence[Which], results: Results) -> pandas.DataFrame:
    """Recorded rows of strides in the paper's units, after friction and reading of the gait."""
    tables = []
    for friction, clamp in which:
        stride = results.stride(friction, clamp)
        begin = {"friction": friction, "swing_clamp": int(clamp)}
        tables.append(pandas.DataFrame({**begin, **{name: stride[name] for name in COLUMNS}}))
    return pandas.concat(tables)


def draw_sticking(results: Results) -> Figure:
    """Draw figure 5: heights, leg, foot velocity and force ratio by both readings."""
    stride, clamped = (results.stride(*which) for which in STICKING)
    figure, axes = style.subplots(2, 2, figsize=(8.4, 6.2))
    _heights(axes[0, 0], stride, clamped)
    _leg(axes[0, 1], stride, clamped)
    _velocity(axes[1, 0], stride, clamped)
    _ratio(axes[1, 1], stride)
    figure.suptitle(
        rf"Periodic gait at $\mu = {stride.gait.friction:g}$, word  {style.word(stride.gait.word)};  "
        "dotted: with the clamp of equation (12)",
        x=0.02,
        ha="left",
    )
    return figure


def _heights(axes: Axes, stride: Stride, clamped: Stride) -> None:
    panels.mark_stance(axes, stride)
    axes.plot(stride.time, stride["com.y"], color=style.CURVE, label=r"centre of mass $y_c$")
    axes.plot(stride.time, stride["foot.y"], color=style.SECOND_CURVE, label=r"foot $y$")
    axes.plot(clamped.time, clamped["com.y"], color=style.CURVE, **CLAMPED)
    axes.plot(clamped.time, clamped["foot.y"], color=style.SECOND_CURVE, **CLAMPED)
    axes.set_title("(a) heights")
    axes.set_ylim(-0.05, 1.75)
    axes.legend(loc="upper center", ncols=2, bbox_to_anchor=(0.5, 1.0))
    style.label(axes, panels.TIME_LABEL, "height (l₀)")


def _leg(axes: Axes, stride: Stride, clamped: Stride) -> None:
    panels.mark_stance(axes, stride)
    axes.plot(stride.time, stride["leg.length"], color=style.CURVE)
    axes.set_title("(b) leg length and angle")
    axes.set_ylim(0.0, 1.25)
    style.label(axes, panels.TIME_LABEL, "leg length r (l₀)")
    angle = axes.twinx()
    angle.spines["right"].set_visible(True)
    angle.plot(stride.time, np.degrees(stride["leg.angle"]), color=style.SECOND_CURVE)
    angle.plot(clamped.time, np.degrees(clamped["leg.angle"]), color=style.SECOND_CURVE, **CLAMPED)
    waits = np.degrees(stride.gait.runner["hip.liftoff_angle_factor"] * stride.gait.liftoff_angle)
    angle.axhline(waits, **style.LIMIT_LINE)
    angle.annotate(r"$\eta\,\theta_{LO}$", (0.02, waits - 3.0), xycoords=("axes fraction", "data"), va="top")
    angle.set_ylabel("leg angle θ (°)", color=style.SECOND_CURVE)
    angle.tick_params(axis="y", colors=style.SECOND_CURVE)
    angle.set_ylim(-65, 75)


def _velocity(axes: Axes, stride: Stride, clamped: Stride) -> None:
    panels.mark_stance(axes, stride)
    panels.foot_velocity(axes, stride, stance_only=False)
    axes.plot(clamped.time, clamped["foot.vx"], color=style.FAINT, **CLAMPED)
    axes.set_title("(c) foot velocity")
    axes.legend(handles=panels.mode_key(stride, style.MODE_COLOURS), loc="center", bbox_to_anchor=(0.27, 0.3))


def _ratio(axes: Axes, stride: Stride) -> None:
    panels.mark_stance(axes, stride)
    panels.mark_mid_stance(axes, stride)
    panels.force_ratio(axes, stride)
    axes.set_title("(d) force ratio in stance; × impulses at the impact")


def draw(which: Sequence[Which], results: Results) -> Figure:
    """Draw figure 6 or 7: foot velocity and force ratio of a stride."""
    (one,) = which
    return panels.velocity_and_ratio(results.stride(*one))


def draw_low(results: Results) -> Figure:
    """Draw figure 8: foot velocity in the stance of the two gaits at low friction."""
    strides = [results.stride(*which) for which in LOW]
    figure, both = style.subplots(1, 2, figsize=(8.4, 3.7))
    for axes, stride, letter in zip(both, strides, "ab", strict=True):
        panels.mark_stance(axes, stride)
        panels.mark_mid_stance(axes, stride)
        panels.foot_velocity(axes, stride, stance_only=True)
        axes.set_title(rf"({letter}) $\mu = {stride.gait.friction:g}$, word  {style.word(stride.gait.word)}")
    figure.suptitle("Periodic gaits at low friction", x=0.02, ha="left")
    panels.key_below(figure, strides)
    return figure
