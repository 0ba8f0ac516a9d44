"""Many runners: their apices from stride to stride, or the last strides of their runs."""

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from ..library.batch_tables import CLOSED
from ..record import runner_in
from ..variables import paper_units
from ..variables.table import VARIABLES
from . import style
from .basin_map import NAMES

if TYPE_CHECKING:
    import xarray

DRAWN = ("com_height", "com_speed")
"""Coordinates of the apices."""
MAX_LINES = 20
"""Runners that are drawn one by one; of more their median, and where nine of ten are."""
REPORTED = ("speed", "cost_of_transport")
"""Quantities of a run's last stride that are drawn."""


def of_strides(made: "xarray.Dataset") -> Figure:
    """Height and speed of the apices, stride by stride."""
    apices = np.concatenate([made["apex"].values[:, :1], made["next_apex"].values], axis=1)
    with style.styled():
        figure, panels = style.subplots(2, 1, figsize=(6.8, 5.4), sharex=True)
        for axes, name in zip(panels, DRAWN, strict=True):
            _draw_runners(axes, apices[..., made["coordinate"].values.tolist().index(name)])
            unit = paper_units.label(VARIABLES[f"apex.{name}"].unit, runner_in(made))
            style.label(axes, "", style.with_unit(NAMES[name], unit))
        panels[-1].set_xlabel("strides")
        panels[-1].xaxis.set_major_locator(MaxNLocator(integer=True))
        if len(apices) > MAX_LINES:
            figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
        runners, strides = made["fate"].shape
        closed = int((made["fate"] == CLOSED).sum())
        panels[0].set_title(f"{runners:,} runners, {closed:,} of {runners * strides:,} strides closed")
    return figure


def _draw_runners(axes: Axes, values: NDArray[np.float64]) -> None:
    """Each runner's values over the strides, which end where it falls."""
    strides = np.arange(values.shape[1])
    if len(values) <= MAX_LINES:
        axes.plot(strides, values.T, ".-", color=style.CURVE, linewidth=0.9, markersize=3.5, alpha=0.7)
        return
    up = np.isfinite(values).any(axis=0)
    low, median, high = np.nanquantile(values[:, up], (0.05, 0.5, 0.95), axis=0)
    axes.fill_between(
        strides[up], low, high, color=style.GROUND, linewidth=0, label="nine of ten that are up"
    )
    axes.plot(strides[up], median, color=style.CURVE, label="median of those that are up")


def of_runs(runs: "xarray.Dataset") -> Figure:
    """Speed and cost of transport of each run's last stride, over what the runners differ in."""
    name = next((str(name) for name in runs.coords if len(np.unique(runs[name])) > 1), None)
    numeric = name is not None and runs[name].dtype.kind in "iuf"
    along = runs[name].values if name is not None and numeric else np.arange(len(runs["fallen"]))
    variables = VARIABLES
    values = {
        of: 1.0 if of not in runs.coords or np.all(runs[of] == 1.0) else np.nan for of in paper_units.SCALES
    }
    with style.styled():
        figure, panels = style.subplots(2, 1, figsize=(6.8, 5.4), sharex=True)
        for axes, quantity in zip(panels, REPORTED, strict=True):
            for fell, colour, label in ((False, style.CURVE, "ran"), (True, "#b3216f", "fell in the end")):
                where = runs["fallen"].values == fell
                if not where.any():
                    continue
                axes.plot(
                    along[where], runs[quantity].values[where], "o", color=colour, markersize=4.5, label=label
                )
            words = quantity.replace("_", " ")
            style.label(
                axes,
                "",
                style.with_unit(words, paper_units.label(variables[f"stride.{quantity}"].unit, values)),
            )
        label = "run"
        if name is not None and numeric:
            label = style.with_unit(name, paper_units.label(variables[name].unit, values))
        panels[-1].set_xlabel(label)
        figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
        panels[0].set_title(f"last stride of {len(along):,} runs")
    return figure
