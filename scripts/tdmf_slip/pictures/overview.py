"""A run at a glance: heights, leg, ground force and speed over time, with the contact modes behind them."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from ..errors import InputError
from ..fmu.run import MODE, Run
from ..variables.table import VARIABLES
from . import style

PANELS: Sequence[tuple[str, Sequence[tuple[str, str]]]] = (
    ("height", (("com.y", "centre of mass"), ("foot.y", "foot"))),
    ("leg angle", (("leg.angle", "leg angle"),)),
    ("ground force", (("contact.fy", "vertical"), ("contact.fx", "horizontal"))),
    ("foot velocity", (("foot.vx", "foot, horizontal"),)),
)
"""Label of each panel, and variables with their names."""


def draw(path: Path, run: Run) -> None:
    """Draw a run as .png, .svg or .pdf, in the units of its table."""
    style.save(figure_of(run), path)


def figure_of(run: Run) -> Figure:
    """A run's panels, in the units of its table."""
    missing = {MODE, *(name for _, curves in PANELS for name, _ in curves)} - set(run.names)
    if missing:
        raise InputError(f"plot: the run has not recorded {', '.join(sorted(missing))}")
    with style.styled():
        figure, all_axes = style.subplots(len(PANELS), 1, sharex=True, figsize=(8.4, 7.6))
        for axes, (label, curves) in zip(all_axes, PANELS, strict=True):
            _panel(axes, run, label, curves)
            _shade(axes, run)
        all_axes[-1].set_xlabel(style.with_unit("time", run.label(run.units["time"])))
        figure.legend(handles=_key(run), loc="outside lower center", ncols=len(style.LOADED) + 1)
    return figure


def _panel(axes: Axes, run: Run, label: str, curves: Sequence[tuple[str, str]]) -> None:
    for (name, what), colour in zip(curves, (style.CURVE, style.SECOND_CURVE), strict=False):
        axes.plot(run.table["time"], run.table[name], color=colour, linewidth=1.3, label=what)
    axes.set_ylabel(style.with_unit(label, run.label(run.units[curves[0][0]])))
    axes.set_xlim(run.table["time"][0], run.table["time"][-1])
    if len(curves) > 1:
        axes.legend(loc="lower right", bbox_to_anchor=(1.0, 0.97), ncols=len(curves))


def _shade(axes: Axes, run: Run) -> None:
    """The background in the colours of the contact modes, flight left white."""
    time, modes = run.table["time"], run.table[MODE]
    starts = np.flatnonzero(np.concatenate([[True], np.diff(modes) != 0]))
    for start, end in zip(starts, [*starts[1:], len(time) - 1], strict=True):
        mode = VARIABLES[MODE].items[int(modes[start])]
        if mode != "flight":
            axes.axvspan(time[start], time[end], color=style.MODE_COLOURS[mode], alpha=0.3, linewidth=0)


def _key(run: Run) -> list[Patch]:
    seen = [VARIABLES[MODE].items[int(mode)] for mode in np.unique(run.table[MODE])]
    return [
        Patch(color=style.MODE_COLOURS[mode], alpha=0.3, label=style.MODE_NAMES[mode])
        for mode in seen
        if mode != "flight"
    ]
