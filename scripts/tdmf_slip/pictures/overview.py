"""Runs over time: those of the unit with their contact modes, those of own models with all that moves."""

from collections.abc import Sequence
from typing import Any

import xarray
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from ..errors import InputError
from ..fmu.run import MODE
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
SHADED: dict[str, Any] = {"alpha": 0.3, "linewidth": 0}
"""Look of the background of contact modes."""
MAX_PANELS = 8
"""Largest number of quantities of an own model that are drawn; outputs come first."""


def figure_of(run: xarray.Dataset) -> Figure:
    """A run over time, with contact modes as shades; for a model of your own, all variables that move."""
    missing = {MODE, *(name for _, curves in PANELS for name, _ in curves)} - set(run.variables)
    if missing and run.model not in MODELS:
        return of_trajectory(run)
    if missing:
        raise InputError(f"plot: the run has not recorded {', '.join(sorted(missing))}")
    figure, panels = _over_time(run, PANELS, (8.4, 7.6))
    time, modes = run["time"].values, [VARIABLES[MODE].items[int(mode)] for mode in run[MODE].values]
    for mode, rows in style.runs_of(modes):
        for axes in panels if mode != "flight" else ():
            end = time[min(rows.stop, len(time) - 1)]
            axes.axvspan(time[rows.start], end, color=style.MODE_COLOURS[mode], **SHADED)
    seen = [mode for mode in style.MODE_NAMES if mode in set(modes) - {"flight"}]
    key = [Patch(color=style.MODE_COLOURS[mode], label=style.MODE_NAMES[mode], **SHADED) for mode in seen]
    figure.legend(handles=key, loc="outside lower center", ncols=len(style.LOADED) + 1)
    return figure


def of_trajectory(run: xarray.Dataset) -> Figure:
    """A panel for each output and state; dashed lines where the mode changes."""
    over_time = {name: of for name, of in run.data_vars.items() if of.dims == ("time",) and name != "mode"}
    moving = [str(name) for name, of in over_time.items() if len(set(of.values)) > 1][:MAX_PANELS]
    if not moving:
        raise InputError("plot: nothing changes along this trajectory, so there is nothing to draw")
    figure, panels = _over_time(
        run, [(name, [(name, "")]) for name in moving], (7.6, 1.0 + 1.3 * len(moving))
    )
    times, modes = run["time"].values, run["mode"].values if "mode" in run else ()
    for time, before, after in zip(times[1:], modes, modes[1:], strict=False):
        for axes in panels if before != after else ():
            axes.axvline(time, **style.LIMIT_LINE)
    return figure


def _over_time(
    run: xarray.Dataset, panels: Sequence[tuple[str, Sequence[tuple[str, str]]]], size: tuple[float, float]
) -> tuple[Figure, Sequence[Axes]]:
    """Figure and axes of panels over time, in the units of the run's table."""
    time, values = run["time"].values, runner_in(run)
    figure, all_axes = style.subplots(len(panels), 1, figsize=size, sharex=True, squeeze=False)
    for axes, (label, curves) in zip(all_axes[:, 0], panels, strict=True):
        for (name, what), colour in zip(curves, (style.CURVE, style.SECOND_CURVE), strict=False):
            axes.plot(time, run[name].values, color=colour, linewidth=1.3, label=what)
        unit = paper_units.label(run[curves[0][0]].attrs.get("units", ""), values)
        axes.set_ylabel(style.with_unit(label, unit))
        if len(curves) > 1:
            axes.legend(loc="lower right", bbox_to_anchor=(1.0, 0.97), ncols=len(curves))
    axes.set_xlim(time[0], time[-1])
    axes.set_xlabel(style.with_unit("time", paper_units.label("s", values)))
    return figure, all_axes[:, 0]
