"""The model, as in figure 4(b): body, leg with spring and damper, foot, hip torque, ground forces."""

from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Arc, Circle, FancyArrowPatch
from numpy.typing import NDArray

from . import style
from .drawn_runner import spring

Point: TypeAlias = tuple[float, float] | NDArray[np.float64]
"""A point, x and y."""
ANGLE = np.radians(33.0)
LENGTH = 1.0
FOOT = np.array([0.0, 0.0])
BODY = FOOT + LENGTH * np.array([-np.sin(ANGLE), np.cos(ANGLE)])
ALONG = (BODY - FOOT) / LENGTH
ACROSS = np.array([-ALONG[1], ALONG[0]])
"""Left of the leg, as seen from the foot."""
FORCE = style.MODE_COLOURS["slip_positive"]
TORQUE = style.MODE_COLOURS["slip_negative"]
MEASURE = style.MODE_COLOURS["stick"]
TEXT = 15
INCHES, DOTS_PER_INCH = 5.0, 144


def draw(path: Path) -> None:
    """Draw the sketch: 720 by 720 pixels."""
    with style.styled():
        figure = style.Picture(figsize=(INCHES, INCHES))
        axes = figure.add_axes((0, 0, 1, 1))
        axes.set_xlim(-1.0, 0.62)
        axes.set_ylim(-0.38, 1.24)
        axes.set_axis_off()
        _ground(axes)
        _leg(axes)
        _masses(axes)
        _measures(axes)
        _forces(axes)
        style.save(figure, path, dots_per_inch=DOTS_PER_INCH)


def _ground(axes: Axes) -> None:
    y = -0.055
    axes.fill_between(
        [-1.0, 0.62], y - 0.06, y, facecolor="#eef1f4", edgecolor=style.FAINT, hatch="////", linewidth=0
    )
    axes.plot([-1.0, 0.62], [y, y], color=style.INK, linewidth=1.8)


def _leg(axes: Axes) -> None:
    """Spring and damper side by side, between two cross bars."""
    low, high, apart = FOOT + 0.22 * ALONG, FOOT + 0.74 * ALONG, 0.075 * ACROSS
    line: dict[str, Any] = {"color": style.INK, "linewidth": 2.0, "solid_capstyle": "round"}
    for a, b in ((FOOT, low), (high, BODY), (low - apart, low + apart), (high - apart, high + apart)):
        axes.plot(*zip(a, b, strict=True), **line)
    axes.plot(*spring(tuple(low + apart), tuple(high + apart), 0.045), **line)
    _damper(axes, low - apart, high - apart, line)
    _name(axes, FOOT + 0.48 * ALONG + 0.19 * ACROSS, "$k$")
    _name(axes, FOOT + 0.44 * ALONG - 0.185 * ACROSS, "$c$")


def _damper(axes: Axes, low: NDArray[np.float64], high: NDArray[np.float64], line: dict[str, Any]) -> None:
    """A cylinder, open above, with a piston in it."""
    along, half_width = high - low, 0.042 * ACROSS
    bottom, top, piston = low + 0.32 * along, low + 0.68 * along, low + 0.52 * along
    for a, b in (
        (low, bottom),
        (bottom - half_width, bottom + half_width),
        (bottom - half_width, top - half_width),
        (bottom + half_width, top + half_width),
        (piston - 0.75 * half_width, piston + 0.75 * half_width),
        (piston, high),
    ):
        axes.plot(*zip(a, b, strict=True), **line)


def _masses(axes: Axes) -> None:
    axes.add_patch(Circle(_pair(BODY), 0.095, facecolor=style.BODY, zorder=5))
    _name(axes, BODY, "$m$", "white")
    _name(axes, BODY + np.array([-0.24, -0.02]), "$(x_m, y_m)$", style.FAINT, -2)
    axes.add_patch(
        Circle(_pair(FOOT), 0.055, facecolor="white", edgecolor=style.INK, linewidth=2.0, zorder=5)
    )
    _name(axes, (-0.13, 0.0), "$m_f$")
    _name(axes, (0.145, -0.175), "$(x, y)$", style.FAINT, -2)


def _measures(axes: Axes) -> None:
    """Leg angle and length, the axes, and which way gravity points."""
    axes.plot([0, 0], [0.06, 0.98], color=style.FAINT, linewidth=1.1, linestyle=(0, (5, 3)))
    around, degrees = 2 * 0.83, float(np.degrees(ANGLE))
    axes.add_patch(Arc((0, 0), around, around, theta1=90, theta2=90 + degrees, color=MEASURE, linewidth=1.8))
    _name(axes, (-0.25, 0.9), r"$\theta$", MEASURE, 2)
    offset = -0.5 * ACROSS
    for end in (FOOT, BODY):
        along = zip(end + 0.25 * offset, end + 1.05 * offset, strict=True)
        axes.plot(*along, color=style.GROUND, linewidth=1.0)
    _arrow(axes, FOOT + offset, BODY + offset, MEASURE, "<|-|>", 1.4)
    _name(axes, (0.24, 0.77), "$r$", MEASURE, 2)
    corner = np.array([-0.92, -0.32])
    for name, way in (("$x$", np.array([1.0, 0.0])), ("$y$", np.array([0.0, 1.0]))):
        _arrow(axes, corner, corner + 0.15 * way, style.FAINT)
        _name(axes, corner + 0.1 * way + 0.05 * way[::-1], name, style.FAINT, -2)
    _arrow(axes, (-0.9, 1.12), (-0.9, 0.92), style.FAINT)
    _name(axes, (-0.945, 1.02), "$g$", style.FAINT, -2)


def _forces(axes: Axes) -> None:
    """Hip torque, positive where it turns theta up, and the ground force on the foot."""
    start, end = BODY + np.array([0.16, 0.03]), BODY + np.array([-0.1, 0.13])
    _arrow(axes, start, end, TORQUE, width=2.2, bend=0.75)
    _name(axes, BODY + np.array([0.16, 0.17]), r"$\tau$", TORQUE, 3)
    _arrow(axes, (0.07, 0.0), (0.36, 0.0), FORCE, width=2.4)
    _arrow(axes, (0.0, -0.34), (0.0, -0.06), FORCE, width=2.4)
    _name(axes, (0.42, 0.0), "$f_x$", FORCE)
    _name(axes, (-0.065, -0.26), "$f_y$", FORCE)
    _name(axes, (0.42, -0.175), r"friction $\mu$", size=-3)


def _name(axes: Axes, point: Point, text: str, colour: str = style.INK, size: int = 0) -> None:
    """A text centred at a point; `size` is in points over the usual one."""
    x, y = point
    axes.text(x, y, text, size=TEXT + size, color=colour, ha="center", va="center", zorder=6)


def _arrow(
    axes: Axes,
    start: Point,
    end: Point,
    colour: str,
    head: str = "-|>",
    width: float = 1.6,
    bend: float = 0.0,
) -> None:
    arrow = FancyArrowPatch(
        _pair(start),
        _pair(end),
        arrowstyle=head,
        mutation_scale=15,
        color=colour,
        linewidth=width,
        shrinkA=0,
        shrinkB=0,
    )
    arrow.set_connectionstyle("arc3", rad=bend)
    axes.add_patch(arrow)


def _pair(point: Point) -> tuple[float, float]:
    x, y = point
    return float(x), float(y)
