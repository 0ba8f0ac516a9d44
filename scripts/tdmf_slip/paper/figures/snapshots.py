"""One stride as snapshots: all of it, its stance enlarged, and the path of the foot on the ground."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...pictures import panels, style
from ...pictures.model import DrawnRunner, bare, ground
from ...pictures.panels import Stride
from .data import Results
from .strides import Which

SHOWN: Sequence[Which] = ((0.43, False),)
"""Gait of the snapshots."""
IN_STRIDE = 27
IN_STANCE = 25
SIZE = (8.4, 6.3)
LEFT, WIDTH = 0.09, 0.89
"""Place of the stance and of the foot's path below it, over the figure's width."""
HALF_WIDTH, HEIGHT, DEPTH = 1.12, 0.92, 0.05
"""Limits of the stance's axes, over l0: to either side of its middle, above and below the ground."""


def draw(results: Results) -> Figure:
    """Draw the stride above, its stance below, and below that the path of the foot over time."""
    stride = results.stride(*SHOWN[0])
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
        runner.move(stride, time)


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
        DrawnRunner(axes, size=0.6).move(stride, time)
        axes.annotate(
            name, stride.place("body", time), xytext=(0, 19), textcoords="offset points", ha="center"
        )


def _ray(axes: Axes, stride: Stride, time: float) -> None:
    """The leg as a line in the colour of the contact mode."""
    x, y = zip(stride.place("foot", time), stride.place("body", time), strict=True)
    axes.plot(x, y, color=style.MODE_COLOURS[stride.mode_at(time)], linewidth=0.9, alpha=0.55, zorder=3)


def _path(axes: Axes, stride: Stride, limits: tuple[float, float]) -> None:
    since_touchdown = stride.time - stride.stance_times[0]
    panels.modes(axes, stride.loaded, stride["foot.x"], since_touchdown, linewidth=2.4)
    axes.set_xlim(*limits)
    axes.invert_yaxis()
    style.label(axes, "position along the ground x (l₀)", "time from\ntouchdown (√(m/k))")
    axes.legend(
        handles=panels.mode_key(stride, style.LOADED),
        loc="lower left",
        title="path of the foot",
        alignment="left",
    )
