"""One stride as an animation that loops: the leg as a spring, and marks on the ground where the foot slipped.

It is a GIF, an MP4 where ffmpeg is, or a page of HTML that needs nothing else: the frames, a slider, and a
script of a few lines. Matplotlib's own page fetches its buttons from elsewhere.
"""

import base64
import io
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.animation import AbstractMovieWriter, FFMpegWriter, FuncAnimation, PillowWriter
from matplotlib.axes import Axes
from matplotlib.patches import FancyArrowPatch
from matplotlib.text import Text
from numpy.typing import NDArray

from ..checks import checked_whole
from ..errors import InputError
from ..files.whole import check_destination, whole
from ..fmu.run import SLIPS
from ..library.gait import Gait
from . import style
from .model import DrawnRunner, bare
from .panels import Stride


class PageWriter(AbstractMovieWriter):
    """Keeps the frames as PNG files in the page."""

    def setup(self, fig, outfile, dpi=None):  # type: ignore[no-untyped-def] # as Matplotlib declares it
        """Begin a page."""
        super().setup(fig, outfile, dpi=dpi)
        self._frames: list[str] = []

    def grab_frame(self, **options: object) -> None:
        """Add a frame."""
        picture = io.BytesIO()
        self.fig.savefig(picture, format="png", dpi=self.dpi, metadata={"Software": None})
        self._frames.append(base64.b64encode(picture.getvalue()).decode())

    def finish(self) -> None:
        """Write the page."""
        frames = ",\n".join(f'"{frame}"' for frame in self._frames)
        last, milliseconds = len(self._frames) - 1, round(1000 / self.fps)
        page = style.template("animation").substitute(last=last, frames=frames, milliseconds=milliseconds)
        Path(self.outfile).write_text(page, encoding="utf-8")


FRAMES = 120
FRAMES_ALLOWED = 12, 2000
"""Smallest and largest number of frames in a stride."""
FRAMES_PER_SECOND = 20
DOTS_PER_INCH = 100
SIZE = (8.0, 4.0)
HALF_WIDTH = 2.0
LOW = -0.42
"""Lowest height shown, over l0; the legend stands in the ground."""
MAX_REPEATED = 50
"""Strides drawn on either side; a shorter one is none."""
SLOWED = 40.0
"""Ratio of frames per unit of time in the stance to those in flight."""
HEADROOM = 0.15
"""Space above the highest position of body and foot, over l0."""
FORMATS = (".gif", ".mp4", ".html")
FORCE_SCALE = 1.5
"""Length of a force arrow, over l0, for a force k l0."""


def frame_times(stride: Stride, frames: int = FRAMES) -> NDArray[np.float64]:
    """Times of the frames: evenly spaced but for the stance, which is slowed down, and without the end."""
    grid = np.linspace(0.0, stride.time[-1], 20001)
    start, end = stride.stance_times
    edge = 0.25 * (end - start)
    inside = 1.0 / (1.0 + np.exp(np.clip(-(grid - start + edge) / (0.3 * edge), -50, 50)))
    outside = 1.0 / (1.0 + np.exp(np.clip((grid - end - 2 * edge) / (0.3 * edge), -50, 50)))
    density = 1.0 + (SLOWED - 1.0) * inside * outside
    share = np.concatenate([[0.0], np.cumsum(0.5 * (density[1:] + density[:-1]))])
    return np.interp(np.linspace(0.0, 1.0, frames, endpoint=False), share / share[-1], grid)


def draw(
    path: Path, stride: Stride, *, frames: int = FRAMES, step_finished: Callable[[], object] = lambda: None
) -> None:
    """Write the animation."""
    check_destination(path, FORMATS, "animation")
    writer = _writer(path)
    with style.styled():
        figure = style.Picture(figsize=SIZE, dpi=DOTS_PER_INCH)
        scene = _Scene(figure.add_axes((0.0, 0.0, 1.0, 1.0)), stride)
        film = FuncAnimation(figure, scene.show, frames=frame_times(stride, frames), blit=False)
        with whole(path) as beside:
            film.save(
                beside,
                writer=writer,
                dpi=DOTS_PER_INCH,
                progress_callback=lambda _number, _total: step_finished(),
            )


def animate(gait: Gait, path: Path | str, frames: int = FRAMES) -> Path:
    """Write one stride of a gait, as `Gait.animate` says."""
    path = style.check_picture(path, "path", FORMATS)
    draw(path, Stride(gait), frames=checked_whole("frames", frames, *FRAMES_ALLOWED))
    return path


def _writer(path: Path) -> AbstractMovieWriter:
    if path.suffix.lower() == ".gif":
        return PillowWriter(fps=FRAMES_PER_SECOND)
    if path.suffix.lower() == ".html":
        return PageWriter(fps=FRAMES_PER_SECOND)
    if not FFMpegWriter.isAvailable():
        raise InputError(f"{path}: ffmpeg is not installed; allowed without it: .gif, .html")
    return FFMpegWriter(fps=FRAMES_PER_SECOND)


class _Scene:
    """Everything in a frame; the view goes along with the centre of mass."""

    def __init__(self, axes: Axes, stride: Stride) -> None:
        self.axes = axes
        self.stride = stride
        self.length = float(stride["com.x"][-1] - stride["com.x"][0])
        self.rise = float(stride["com.y"][-1] - stride["com.y"][0])
        highest = max(
            float((stride[f"{part}.y"] - self.line(stride[f"{part}.x"])).max()) for part in ("body", "foot")
        )
        self.half_width = max(HALF_WIDTH, 0.5 * (highest + HEADROOM - LOW) * SIZE[0] / SIZE[1])
        self.top = LOW + 2 * self.half_width * SIZE[1] / SIZE[0]
        bare(axes, (-self.half_width, self.half_width), (LOW, self.top))
        self._ground()
        self.runner = DrawnRunner(axes, line_width=2.0)
        self.force = FancyArrowPatch(
            (0, 0), (0, 0), arrowstyle="-|>", mutation_scale=14, linewidth=2.0, zorder=3
        )
        axes.add_patch(self.force)
        self.streaks = [
            axes.plot([], [], linewidth=6.0, zorder=3, solid_capstyle="butt")[0]
            for _ in range(2 * len(stride.intervals))
        ]
        self.mode = self._text(0.02, 0.06, "left", size=15, weight="bold")
        self._text(0.98, 0.06, "right", size=14).set_text(rf"$\mu = {stride.gait.friction:g}$")
        self.speed = self._text(0.02, 0.95, "left", size=11, color=style.FAINT)
        self.letters = self._word()

    def _text(self, x: float, y: float, align: str, **how: Any) -> Text:
        return self.axes.text(x, y, "", transform=self.axes.transAxes, ha=align, va="center", **how)

    def _ground(self) -> None:
        """The ground with its marks, and the path of the centre of mass, over three strides."""
        length, x, y = self.length, self.stride["com.x"], self.stride["com.y"]
        count = max(1, round(abs(length)))  # a whole number in a stride, so that the loop closes
        reach = 2 + math.ceil(self.half_width / max(abs(length), 1e-9))
        if reach > MAX_REPEATED:  # it runs on the spot
            reach, count = 2, 1
        marks = np.arange(-reach * count, reach * count + 1) * length / count
        span = np.array([-1.0, 1.0]) * max(reach * abs(length), 2.0 * self.half_width) + x[0]
        line = self.line(span)
        self.axes.fill_between(span, line + 2.0 * LOW, line, color="#eef1f4", linewidth=0, zorder=0)
        self.axes.plot(span, line, color=style.INK, linewidth=1.2, zorder=2)
        self.axes.vlines(
            marks, self.line(marks) - 0.09, self.line(marks), color=style.FAINT, linewidth=1.0, zorder=1
        )
        strides = range(-reach, reach)
        self.axes.plot(
            np.concatenate([x + i * length for i in strides]),
            np.concatenate([y + i * self.rise for i in strides]),
            color=style.GROUND,
            linewidth=1.2,
            zorder=1,
        )

    def line(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """Height of the ground at a position."""
        values = self.stride.gait.runner
        height = values.get("ground.height", 0.0) / values["leg.free_length"]
        return height + np.asarray(x) * math.tan(values.get("ground.slope", 0.0))

    def _word(self) -> list[Text]:
        """The letters of the gait word, one for each contact mode with force."""
        letters, count = [], len(self.stride.loaded)
        for i, (mode, _) in enumerate(self.stride.loaded):
            letter = self._text(0.84 - 0.032 * (count - 1 - i), 0.06, "center", size=18, weight="bold")
            letter.set_text(style.LETTERS[mode])
            letters.append(letter)
        return letters

    def show(self, time: float) -> None:
        """Move everything to a time of the stride."""
        stride, mode = self.stride, self.stride.mode_at(time)
        colour = style.MODE_COLOURS[mode]
        middle = stride.at("com.x", time)
        below = float(self.line(np.array(middle)))
        self.axes.set_xlim(middle - self.half_width, middle + self.half_width)
        self.axes.set_ylim(below + LOW, below + self.top)
        self.runner.move(stride, time)
        self._push(stride.place("foot", time), time, colour)
        self._leave_streaks(time)
        self.mode.set_text(style.MODE_NAMES[mode])
        self.mode.set_color(colour)
        self._light(time)
        start, end = stride.stance_times
        self.speed.set_text("slow motion" if start - 0.2 < time < end + 0.4 else "")

    def _light(self, time: float) -> None:
        """Light the letter of the present contact mode."""
        for (mode, rows), letter in zip(self.stride.loaded, self.letters, strict=True):
            first, last = self.stride.time[rows][[0, -1]]
            letter.set_color(style.MODE_COLOURS[mode] if first <= time <= last else style.GROUND)

    def _push(self, foot: tuple[float, float], time: float, colour: str) -> None:
        """The ground force as an arrow from the foot."""
        if self.stride.mode_at(time) not in style.LOADED:
            self.force.set_visible(False)
            return
        x, y = (FORCE_SCALE * self.stride.at(name, time) for name in ("contact.fx", "contact.fy"))
        self.force.set_visible(True)
        self.force.set_positions(foot, (foot[0] + x, foot[1] + y))
        self.force.set_color(colour)

    def _leave_streaks(self, time: float) -> None:
        """Draw where the foot has slipped, also in the stride before, so that the loop closes."""
        slips = [interval for interval in self.stride.intervals if interval[0] in SLIPS]
        for streak in self.streaks:
            streak.set_data([], [])
        free = iter(self.streaks)
        for shift, until in ((-self.length, np.inf), (0.0, time)):
            for depth, (mode, rows) in enumerate(slips):
                x = self.stride["foot.x"][rows][self.stride.time[rows] <= until] + shift
                streak = next(free)
                streak.set_data(x, self.line(x) - 0.05 - 0.07 * depth)
                streak.set_color(style.MODE_COLOURS[mode])
