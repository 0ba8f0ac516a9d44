"""One stride of a gait, normalised as in the paper, and cut into contact modes, for the pictures."""

from collections.abc import Collection, Iterable, Sequence
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from ..errors import InputError
from ..fmu.run import MODE
from ..library.gait import Gait
from ..variables import paper_units
from ..variables.table import Model
from . import style

Values: TypeAlias = NDArray[np.float64]
POINTS, TRAJECTORY_POINTS = 6000, 1001
"""Recorded points in the stride, to which each event adds two; times of the gait of a model of one's own."""


DRAWN = "body.x", "contact.mode", "hip.phase"
"""Outputs without which no runner is drawn."""


def check_is_drawn(model: Model) -> None:
    """Refuse a model of one's own that has no body, leg and foot."""
    if model.is_page:
        missing = [name for name in DRAWN if name not in {of["public"] for of in model.table["outputs"]}]  # type: ignore[attr-defined]
        if missing:
            raise InputError(
                f"model {model.name}: cannot be drawn as a runner, because it has no {', '.join(missing)}; "
                "plot draws its outputs over time"
            )


class Stride:
    """One stride from apex to apex, in units of l0, sqrt(m/k) and m. Angles in rad."""

    def __init__(self, gait: Gait) -> None:
        """Run the unit for one stride from the gait's apex."""
        from ..fmu.simulation import run_unit  # FMPy loads only where the unit is run

        self.gait = gait
        check_is_drawn(gait.runner.model)
        run = run_unit(gait, strides=1, output_interval=gait.period / POINTS)
        self.events = run.events
        self._table, self._variables = run.table, run.variables

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        """A recorded variable, one value per row."""
        rows: NDArray[np.float64] = self._table[name]
        return rows / paper_units.scale(self._variables[name].unit or "1", self.gait.runner)

    @cached_property
    def time(self) -> NDArray[np.float64]:
        """Time since the apex."""
        return self["time"]

    @cached_property
    def modes(self) -> list[str]:
        """Contact mode of each row."""
        items = self._variables[MODE].items
        return [items[int(mode)] for mode in self._table[MODE]]

    @cached_property
    def intervals(self) -> list[tuple[str, slice]]:
        """The stride cut at every change of contact mode, in order: each mode, and its rows."""
        return style.runs_of(self.modes)

    @cached_property
    def loaded(self) -> list[tuple[str, slice]]:
        """Intervals in which the ground bears the foot."""
        return [interval for interval in self.intervals if interval[0] in style.LOADED]

    @cached_property
    def stance(self) -> slice:
        """Rows on the ground with force, from the first contact to the last."""
        return slice(self.loaded[0][1].start, self.loaded[-1][1].stop)

    def times_of(self, what: str) -> list[float]:
        """Times of the events of one kind."""
        return [
            event.time / paper_units.scale("s", self.gait.runner)
            for event in self.events
            if event.what == what
        ]

    @cached_property
    def stance_times(self) -> tuple[float, float]:
        """First and last time of the stance."""
        return float(self.time[self.stance][0]), float(self.time[self.stance][-1])

    @property
    def impulse_ratio(self) -> float:
        """F_x / F_y of the impact at touchdown: the foot's change of velocity, horizontal over vertical."""
        after = self.stance.start
        change_x, change_y = (self[name][after] - self[name][after - 1] for name in ("foot.vx", "foot.vy"))
        return float(change_x / change_y)

    def at(self, name: str, time: float) -> float:
        """A variable at a time, interpolated between rows."""
        return float(np.interp(time, self.time, self[name]))

    def place(self, part: str, time: float) -> tuple[float, float]:
        """Position of the body or the foot at a time."""
        return self.at(f"{part}.x", time), self.at(f"{part}.y", time)

    def mode_at(self, time: float) -> str:
        """Contact mode at a time."""
        return self.modes[max(0, int(np.searchsorted(self.time, time, side="right")) - 1)]


TIME_LABEL = "time t (√(m/k))"
VELOCITY_LABEL = "foot velocity ẋ (l₀√(k/m))"
RATIO_LABEL = r"force ratio $f_x/f_y$"
MARGIN = 0.08
"""Time shown before and after the stance, over the duration of the stance."""
SHORT = 0.004
"""Share of the shown time below which a mode gets a dot, because its line would be too short to see."""


def mark_stance(axes: Axes, stride: Stride) -> None:
    """Enclose the stance in vertical dashed lines."""
    for time in stride.stance_times:
        axes.axvline(time, **style.STANCE_LINE)


def mark_mid_stance(axes: Axes, stride: Stride) -> None:
    """A vertical dash-dotted line where theta = 0 and the torque ends."""
    for time in stride.times_of("midstance"):
        axes.axvline(time, **style.MID_STANCE_LINE)


def modes(
    axes: Axes, intervals: Iterable[tuple[str, slice]], x: Values, y: Values, shown: float = 0.0, **look: Any
) -> None:
    """A curve in the colours of the contact modes, slip dashed; `shown` is the range of the axis of x."""
    for mode, rows in intervals:
        if np.ptp(x[rows]) < SHORT * shown:
            axes.plot(x[rows][-1], y[rows][-1], "o", color=style.MODE_COLOURS[mode], markersize=5, zorder=4)
        else:
            axes.plot(x[rows], y[rows], **{**style.line_of(mode), **look}, zorder=3)


def mode_key(stride: Stride, wanted: Collection[str]) -> list[Line2D]:
    """Legend entries of the contact modes that occur, in the order of their first appearance."""
    names = [name for name in dict.fromkeys(stride.modes) if name in wanted]
    return [Line2D([], [], **style.line_of(name), label=style.MODE_NAMES[name]) for name in names]


def key_below(figure: Figure, strides: Sequence[Stride]) -> None:
    """One row of legend below everything, for the modes of all strides shown."""
    entries = {line.get_label(): line for stride in strides for line in mode_key(stride, style.MODE_COLOURS)}
    figure.legend(handles=list(entries.values()), loc="outside lower center", ncols=len(entries))


def foot_velocity(axes: Axes, stride: Stride, stance_only: bool) -> None:
    """The foot's tangential velocity; its jump is the impact."""
    start, end = stride.stance_times
    shown = (1.0 + 2.0 * MARGIN) * (end - start) if stance_only else stride.time[-1]
    modes(axes, stride.intervals, stride.time, stride["foot.vx"], shown)
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
    modes(axes, stride.loaded, stride.time, ratio, end - start)
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


def of_gait(gait: Gait) -> Figure:
    """The two panels of a gait's stride; of a model of one's own, its outputs and states over time."""
    if gait.runner.model.is_page:
        from ..analysis.trajectories import trajectory
        from .overview import of_trajectory  # xarray is slow to load

        return of_trajectory(trajectory(gait, times=np.linspace(0.0, gait.period, TRAJECTORY_POINTS)))
    return velocity_and_ratio(Stride(gait))


def velocity_and_ratio(stride: Stride) -> Figure:
    """Draw the velocity of the foot and the ratio of its forces, along the stance."""
    figure, (left, right) = style.subplots(1, 2, figsize=(8.4, 3.7))
    for axes in (left, right):
        mark_stance(axes, stride)
        mark_mid_stance(axes, stride)
    foot_velocity(left, stride, stance_only=True)
    left.set_title("(a) foot velocity; the jump is the slipping impact")
    force_ratio(right, stride)
    right.set_title("(b) force ratio; × impulses at the impact")
    figure.suptitle(
        rf"Periodic gait at $\mu = {stride.gait.friction:g}$, word  {style.word(stride.gait.word)}",
        x=0.02,
        ha="left",
    )
    key_below(figure, [stride])
    return figure
