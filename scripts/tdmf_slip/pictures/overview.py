"""Runs over time: those of the unit with their contact modes, those of own models with all that moves."""

from collections.abc import Sequence

import numpy as np
import xarray
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from ..analysis.trajectories import trajectory
from ..errors import InputError
from ..fmu.run import MODE
from ..library.gait import Gait
from ..record import runner_in
from ..variables import paper_units
from ..variables.table import MODELS, VARIABLES
from . import style

PANELS: Sequence[tuple[str, Sequence[tuple[str, str]]]] = (
    ("height", (("com.y", "centre of mass"), ("foot.y", "foot"))),
    ("leg angle", (("leg.angle", "leg angle"),)),
    ("ground force", (("contact.fy", "vertical"), ("contact.fx", "horizontal"))),
    ("foot velocity", (("foot.vx", "foot, horizontal"),)),
)
"""Label of each panel, and variables with their names."""
POINTS = 1001
"""Times at which the gait of an own model is drawn."""
MAX_PANELS = 8
"""Largest number of quantities of an own model that are drawn; outputs come first."""


def figure_of(run: xarray.Dataset) -> Figure:
    """A run's panels, in the units of its table; of another model's unit all that moves."""
    missing = {MODE, *(name for _, curves in PANELS for name, _ in curves)} - set(run.variables)
    if missing and run.model not in MODELS:
        return of_trajectory(run)
    if missing:
        raise InputError(f"plot: the run has not recorded {', '.join(sorted(missing))}")
    figure, all_axes = style.subplots(len(PANELS), 1, sharex=True, figsize=(8.4, 7.6))
    for axes, (label, curves) in zip(all_axes, PANELS, strict=True):
        _panel(axes, run, label, curves)
        _shade(axes, run)
    all_axes[-1].set_xlabel(style.with_unit("time", paper_units.label("s", runner_in(run))))
    figure.legend(handles=_key(run), loc="outside lower center", ncols=len(style.LOADED) + 1)
    return figure


def _panel(axes: Axes, run: xarray.Dataset, label: str, curves: Sequence[tuple[str, str]]) -> None:
    for (name, what), colour in zip(curves, (style.CURVE, style.SECOND_CURVE), strict=False):
        axes.plot(run["time"].values, run[name].values, color=colour, linewidth=1.3, label=what)
    axes.set_ylabel(
        style.with_unit(label, paper_units.label(run[curves[0][0]].attrs.get("units", ""), runner_in(run)))
    )
    axes.set_xlim(run["time"].values[0], run["time"].values[-1])
    if len(curves) > 1:
        axes.legend(loc="lower right", bbox_to_anchor=(1.0, 0.97), ncols=len(curves))


def _shade(axes: Axes, run: xarray.Dataset) -> None:
    """The background in the colours of the contact modes, flight left white."""
    time, modes = run["time"].values, run[MODE].values
    starts = np.flatnonzero(np.concatenate([[True], np.diff(modes) != 0]))
    for start, end in zip(starts, [*starts[1:], len(time) - 1], strict=True):
        mode = VARIABLES[MODE].items[int(modes[start])]
        if mode != "flight":
            axes.axvspan(time[start], time[end], color=style.MODE_COLOURS[mode], alpha=0.3, linewidth=0)


def _key(run: xarray.Dataset) -> list[Patch]:
    seen = [VARIABLES[MODE].items[int(mode)] for mode in np.unique(run[MODE].values)]
    return [
        Patch(color=style.MODE_COLOURS[mode], alpha=0.3, label=style.MODE_NAMES[mode])
        for mode in seen
        if mode != "flight"
    ]


def of_own_gait(gait: Gait) -> Figure:
    """The outputs and states over the strides of a gait."""
    return of_trajectory(trajectory(gait, times=np.linspace(0.0, gait.period, POINTS)))


def of_trajectory(run: xarray.Dataset) -> Figure:
    """A panel for each output and state; dashed lines where the mode changes."""
    over_time = {name: of for name, of in run.data_vars.items() if of.dims == ("time",) and name != "mode"}
    moving = [name for name, of in over_time.items() if len(set(of.values)) > 1]
    if not moving:
        raise InputError("plot: a trajectory on which nothing changes; allowed: one that moves")
    times, modes = run["time"].values, run["mode"].values if "mode" in run else ()
    pairs = zip(times[1:], modes, modes[1:], strict=False)
    changes = [time for time, before, after in pairs if before != after]
    count, values = min(MAX_PANELS, len(moving)), runner_in(run)
    figure, panels = style.subplots(count, 1, figsize=(7.6, 1.0 + 1.3 * count), sharex=True, squeeze=False)
    for axes, name in zip(panels[:, 0], moving, strict=False):
        axes.plot(times, run[name].values, color=style.CURVE)
        axes.set_ylabel(style.with_unit(str(name), paper_units.label(run[name].attrs["units"], values)))
        for time in changes:
            axes.axvline(time, **style.LIMIT_LINE)
    panels[-1, 0].set_xlabel(style.with_unit("time", paper_units.label("s", values)))
    return figure
