"""The runner as it is drawn: body, leg and foot on the ground."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle
from numpy.typing import NDArray

from . import style
from .panels import Stride

COILS, WIDTH = 7, 0.055
"""Number of the coils of a spring, and their size, over l0."""
BODY_RADIUS = 0.1
FOOT_RADIUS = 0.05


def spring(
    foot: tuple[float, float], body: tuple[float, float]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """A coil spring from foot to body, straight at both ends."""
    start, end = np.array(foot), np.array(body)
    along = end - start
    across = np.array([-along[1], along[0]]) / max(np.hypot(*along), 1e-12)
    share = np.linspace(0.0, 1.0, 40 * COILS)
    winding = np.clip((share - 0.2) / 0.55, 0.0, 1.0)
    line = start + share[:, None] * along + WIDTH * np.sin(2 * np.pi * COILS * winding)[:, None] * across
    return line[:, 0], line[:, 1]


class DrawnRunner:
    """A runner in some axes, drawn once and moved as often as needed."""

    def __init__(self, axes: Axes, line_width: float = 1.6, size: float = 1.0) -> None:
        """Make the artists, without a pose yet."""
        (self.leg,) = axes.plot([], [], color=style.INK, linewidth=line_width, zorder=4)
        self.body = Circle((0, 0), size * BODY_RADIUS, facecolor=style.BODY, zorder=5)
        self.foot = Circle(
            (0, 0),
            size * FOOT_RADIUS,
            facecolor="white",
            edgecolor=style.INK,
            linewidth=1.2,
            zorder=5,
        )
        axes.add_patch(self.body)
        axes.add_patch(self.foot)

    def move(self, stride: Stride, time: float) -> None:
        """Move the runner to its place at a time of a stride, and give the foot the contact mode's colour."""
        self.foot.center, self.body.center = stride.place("foot", time), stride.place("body", time)
        self.leg.set_data(*spring(self.foot.center, self.body.center))
        self.foot.set_facecolor(style.MODE_COLOURS[stride.mode_at(time)])


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
