"""A viable set: the share of actions that are viable at each apex, and where the grid leaves it open."""

from pathlib import Path

import matplotlib
import numpy as np
import xarray
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from ..library.runner import Runner
from ..library.section import REDUCED
from ..record import runner_in
from ..variables.table import FRICTION, VARIABLES
from . import style
from .basin_map import NAMES

COLOURS = ListedColormap(matplotlib.colormaps["GnBu"](np.linspace(0.18, 1.0, 256)))
"""Without the palest, which are hardly told from the paper."""
OPEN, NOT_VIABLE = "#f0b35a", "#efe9e4"
"""Colours of cells that the grid leaves open, and of those from which no action of the grid helps."""


def draw(path: Path, found: xarray.Dataset) -> None:
    """Draw the sets into a file."""
    with style.styled():
        style.save(_figure(found), path)


def figure_of(found: xarray.Dataset) -> Figure:
    """The sets as a figure."""
    with style.styled():
        return _figure(found)


def _figure(found: xarray.Dataset) -> Figure:
    figure, axes = style.subplots(figsize=(7.6, 5.4))
    mesh = paint(axes, found)
    figure.colorbar(mesh, ax=axes, label="share of actions that lead to a viable state (inner set)", pad=0.01)
    handles = [
        Patch(color=OPEN, label="undecided on this grid"),
        Patch(
            facecolor=NOT_VIABLE,
            edgecolor=style.FAINT,
            label="no action on the grid avoids a fall",
        ),
    ]
    figure.legend(handles=handles, loc="outside lower center", ncols=2)
    friction = Runner(runner_in(found), model=found.model)[FRICTION]
    actions = found["viable_pair"].size // found["viable"].size
    axes.set_title(
        f"friction {friction:g}: {found.inner_share:.1%} to {found.outer_share:.1%} of the plane viable, "
        f"{actions} actions"
    )
    return figure


def paint(axes: Axes, found: xarray.Dataset, maximum: float | None = None) -> ScalarMappable:
    """Paint the sets into axes of a figure."""
    heights, speeds = (found[f"{axis}_edge"].values for axis in REDUCED)
    states, robustness = found["viable"].values, found["inner_robustness"].values
    for level, colour in ((0, NOT_VIABLE), (1, OPEN)):
        shown = np.ma.masked_where(states != level, np.zeros(states.shape))
        axes.pcolormesh(speeds, heights, shown, cmap=ListedColormap([colour]), rasterized=True)
    shares = np.ma.masked_where(states != 2, robustness)
    largest = maximum or float(np.max(robustness)) or 1.0
    mesh = axes.pcolormesh(speeds, heights, shares, cmap=COLOURS, vmin=0.0, vmax=largest, rasterized=True)
    runner = Runner(runner_in(found), model=found.model)
    units = [runner.label(VARIABLES[f"apex.{axis}"].unit) for axis in REDUCED]
    style.label(
        axes, style.with_unit(NAMES[REDUCED[1]], units[1]), style.with_unit(NAMES[REDUCED[0]], units[0])
    )
    return mesh
