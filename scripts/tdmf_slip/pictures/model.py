"""The model, as in figure 4(b): body, leg with spring and damper, foot, hip torque, ground forces."""

from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Arc, Circle, FancyArrowPatch
from numpy.typing import NDArray

from . import panels, style
from .panels import Stride

COILS = 7
BODY_RADIUS = 0.1
FOOT_RADIUS = 0.05


@dataclass(frozen=True)
class Pose:
    """Positions of body and foot, over l0."""

    body: tuple[float, float]
    """Position of the body, x and y."""
    foot: tuple[float, float]
    """Position of the foot, x and y."""


def pose(stride: Stride, time: float) -> Pose:
    """The runner's pose at a time of a stride."""
    body_x, body_y, foot_x, foot_y = (
        stride.at(name, time) for name in ("body.x", "body.y", "foot.x", "foot.y")
    )
    return Pose((body_x, body_y), (foot_x, foot_y))


def spring(
    foot: tuple[float, float], body: tuple[float, float], width: float = 0.055
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """A coil spring from foot to body, straight at both ends."""
    start, end = np.array(foot), np.array(body)
    along = end - start
    across = np.array([-along[1], along[0]]) / max(np.hypot(*along), 1e-12)
    share = np.linspace(0.0, 1.0, 40 * COILS)
    winding = np.clip((share - 0.2) / 0.55, 0.0, 1.0)
    line = start + share[:, None] * along + width * np.sin(2 * np.pi * COILS * winding)[:, None] * across
    return line[:, 0], line[:, 1]


class DrawnRunner:
    """A runner in some axes, drawn once and moved as often as needed."""

    def __init__(self, axes: Axes, opacity: float = 1.0, line_width: float = 1.6, size: float = 1.0) -> None:
        """Make the artists, without a pose yet."""
        (self.leg,) = axes.plot([], [], color=style.INK, linewidth=line_width, alpha=opacity, zorder=4)
        self.body = Circle((0, 0), size * BODY_RADIUS, facecolor=style.BODY, alpha=opacity, zorder=5)
        self.foot = Circle(
            (0, 0),
            size * FOOT_RADIUS,
            facecolor="white",
            edgecolor=style.INK,
            linewidth=1.2,
            alpha=opacity,
            zorder=5,
        )
        axes.add_patch(self.body)
        axes.add_patch(self.foot)

    def set_pose(self, where: Pose, colour: str) -> None:
        """Move the runner, and give the foot a contact mode's colour."""
        self.leg.set_data(*spring(where.foot, where.body))
        self.body.center = where.body
        self.foot.center = where.foot
        self.foot.set_facecolor(colour)


def bare(axes: Axes, x_limits: tuple[float, float], y_limits: tuple[float, float]) -> None:
    """Axes without frame, x and y at equal scale."""
    axes.set_xlim(*x_limits)
    axes.set_ylim(*y_limits)
    axes.set_aspect("equal")
    axes.set_axis_off()


def ground(axes: Axes, x_limits: tuple[float, float], depth: float = 0.03) -> None:
    """The ground, a band below y = 0."""
    axes.fill_between(x_limits, -depth, 0.0, color=style.GROUND, linewidth=0, zorder=1)
    axes.plot(x_limits, [0.0, 0.0], color=style.INK, linewidth=0.9, zorder=2)


FRICTION = 0.43
IN_STRIDE = 27
IN_STANCE = 25
SIZE = (8.4, 6.3)
LEFT, WIDTH = 0.09, 0.89
"""Place of the stance and of the foot's path below it, over the figure's width."""
HALF_WIDTH, HEIGHT, DEPTH = 1.12, 0.92, 0.05
"""Shown of the stance, over l0: to either side of its middle, above and below the ground."""


def draw_snapshots(stride: Stride) -> Figure:
    """Draw the stride above, its stance below, and below that the path of the foot over time."""
    figure = style.Picture(figsize=SIZE)
    letters = style.word(stride.gait.word)
    title = rf"One stride, gait word  {letters}, friction $\mu = {stride.gait.friction:g}$"
    figure.text(0.015, 0.955, title, size=11)
    _whole(figure.add_axes((0.01, 0.82, 0.98, 0.12)), stride)
    stance, foot = _aligned_axes(figure)
    middle = float(np.mean(stride["body.x"][stride.stance][[0, -1]]))
    limits = (middle - HALF_WIDTH, middle + HALF_WIDTH)
    _stance(stance, stride, limits)
    _path(foot, stride, limits)
    return figure


def _aligned_axes(figure: Figure) -> tuple[Axes, Axes]:
    """Axes for the stance, at equal scale, and for the foot's path, with the same scale along the ground."""
    inches = SIZE[0] * WIDTH / (2 * HALF_WIDTH)
    height = inches * (HEIGHT + DEPTH) / SIZE[1]
    bottom = 0.80 - height
    return figure.add_axes((LEFT, bottom, WIDTH, height)), figure.add_axes((LEFT, 0.09, WIDTH, bottom - 0.10))


def _whole(axes: Axes, stride: Stride) -> None:
    limits = float(stride["com.x"][0]) - 0.5, float(stride["com.x"][-1]) + 1.4
    bare(axes, limits, (-0.12, 1.75))
    ground(axes, limits, depth=0.1)
    axes.plot(stride["com.x"], stride["com.y"], color=style.FAINT, linewidth=0.8, zorder=2)
    for time in np.linspace(0.0, stride.time[-1], IN_STRIDE):
        runner = DrawnRunner(axes, line_width=0.7, size=1.2)
        runner.set_pose(pose(stride, time), style.MODE_COLOURS[stride.mode_at(time)])


def _stance(axes: Axes, stride: Stride, limits: tuple[float, float]) -> None:
    bare(axes, limits, (-DEPTH, HEIGHT))
    ground(axes, limits, depth=0.02)
    rows = slice(stride.stance.start - 100, stride.stance.stop + 100)
    axes.plot(stride["body.x"][rows], stride["body.y"][rows], color=style.FAINT, linewidth=1.0, zorder=2)
    start, end = stride.stance_times
    for time in np.linspace(start, end - 1e-9, IN_STANCE):
        _ray(axes, stride, time)
    shown = {"touchdown": start, "mid-stance": stride.times_of("midstance")[0], "lift-off": end - 1e-9}
    for name, time in shown.items():
        where = pose(stride, time)
        DrawnRunner(axes, size=0.6).set_pose(where, style.MODE_COLOURS[stride.mode_at(time)])
        axes.annotate(name, where.body, xytext=(0, 19), textcoords="offset points", ha="center")


def _ray(axes: Axes, stride: Stride, time: float) -> None:
    """The leg as a line in the colour of the contact mode."""
    where = pose(stride, time)
    x, y = zip(where.foot, where.body, strict=True)
    axes.plot(x, y, color=style.MODE_COLOURS[stride.mode_at(time)], linewidth=0.9, alpha=0.55, zorder=3)


def _path(axes: Axes, stride: Stride, limits: tuple[float, float]) -> None:
    for interval in stride.intervals:
        if interval.mode in style.LOADED:
            axes.plot(
                stride["foot.x"][interval.rows],
                stride.time[interval.rows] - stride.stance_times[0],
                linewidth=2.4,
                color=style.MODE_COLOURS[interval.mode],
                linestyle=style.dashes(interval.mode),
            )
    axes.set_xlim(*limits)
    axes.invert_yaxis()
    style.label(axes, "position along the ground x (l₀)", "time from\ntouchdown (√(m/k))")
    axes.legend(
        handles=panels.mode_key(stride, style.LOADED),
        loc="lower left",
        title="path of the foot",
        alignment="left",
    )


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


def draw() -> Figure:
    """Draw the sketch: 720 by 720 pixels at `DOTS_PER_INCH`."""
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
    return figure


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
