"""The runner as it is drawn: body, leg and foot, and one stride of it as snapshots."""

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle
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
