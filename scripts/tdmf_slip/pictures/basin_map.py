"""A region of attraction: how many strides each start takes to settle on the gait, or until it falls."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import matplotlib
import numpy as np
import xarray
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.patheffects import withStroke
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from ..analysis.basin import FOLLOWED, STRIDES
from ..errors import counted
from ..library.batch_tables import CLOSED
from ..library.engine import FATES, SETTLED
from ..library.runner import Runner
from ..record import runner_in
from ..variables import paper_units
from ..variables.table import FRICTION, VARIABLES, model_recorded, paper_unit
from . import style

if TYPE_CHECKING:
    import xarray

COUNTED = {
    "settled": ("GnBu_r", "strides until the runner is known to settle"),
    "fell": ("OrRd_r", "strides until the runner falls"),
}
"""Colours of fates that are shaded by the number of strides."""
OTHERS = {
    "undecided": ("#8e44ad", "undecided"),
    "no_start": ("#5b6770", "no start: the foot is not above the ground"),
    "unsolved": ("#000000", "unsolved: no solver could follow"),
    "stopped": ("#d3d7da", "stopped by an interrupt"),
    "no_stride": ("#e0a526", "no stride: there is no next apex, or it is too low for the leg"),
}
"""Colours and labels of the other fates."""
PALEST = 0.85
"""Share of a colour map that is used; paler colours are hard to see on paper."""
SMALLEST, RIM = 3.2, 1.0
"""Points: starts that are drawn smaller are marked with a white rim, else a single one would be lost."""


def figure_of(data: "xarray.Dataset") -> Figure:
    """The map: starts that settle in blue, those that fall in red, by strides; the gait as a cross."""
    figure, axes = style.subplots(figsize=(7.6, 5.8))
    handles = paint(axes, data)
    axes.set_title(_title(data, data["fate"].values == SETTLED))
    figure.legend(handles=handles, loc="outside lower center", ncols=len(handles))
    figure.draw_without_rendering()  # now the size of a start is known
    for name, where in _others(data).items():
        _mark_small(figure, axes, data, where, OTHERS[name][0])
    return figure


def paint(axes: Axes, data: "xarray.Dataset") -> list[Artist]:
    """Paint the map into axes of a figure."""
    vertical, horizontal = map(str, data["fate"].dims)
    edges = style.edges_of(data[horizontal].values), style.edges_of(data[vertical].values)
    fate, strides = data["fate"].values, data[STRIDES].values
    axes.set_xlim(min(edges[0]), max(edges[0]))
    axes.set_ylim(min(edges[1]), max(edges[1]))
    style.label(axes, _label(data, horizontal), _label(data, vertical))
    for name, (colours, label) in COUNTED.items():
        where = fate == FATES.index(name)
        if where.any():
            palest_left_out = ListedColormap(matplotlib.colormaps[colours](np.linspace(0.0, PALEST, 256)))
            mesh = style.paint_cells(
                axes, edges, where, palest_left_out, strides, max(1, strides[where].max())
            )
            axes.figure.colorbar(mesh, ax=axes, label=label, pad=0.01, ticks=MaxNLocator(integer=True))
    handles: list[Artist] = [_cross(axes, data, horizontal, vertical)]
    for name, where in _others(data).items():
        colour, label = OTHERS[name]
        style.paint_cells(axes, edges, where, colour)
        handles.append(Patch(color=colour, label=label))
    return handles


def _others(data: "xarray.Dataset") -> dict[str, NDArray[np.bool_]]:
    """Mask of the fates that are not shaded by strides."""
    where = {name: data["fate"].values == number for number, name in enumerate(FATES) if name in OTHERS}
    return {name: starts for name, starts in where.items() if starts.any()}


def _title(data: "xarray.Dataset", settled: NDArray[np.bool_]) -> str:
    begin = _at_friction(runner_in(data))
    gait = f"gait {style.word(data.attrs['word'])}"
    title = f"{begin}{gait}: {settled.mean():.1%} of {settled.size:,} starts settle"
    if FOLLOWED in data:
        share = float(data[FOLLOWED].mean())
        title += f"\npreview: {share:.1%} of the starts followed, the rest painted; islands may be missed"
    return title


def _at_friction(values: Mapping[str, Any]) -> str:
    """Beginning of a title: the friction of a runner's ground; empty for a model without friction."""
    return f"friction {values[FRICTION]:g}, " if FRICTION in values else ""


def _cross(axes: Axes, data: "xarray.Dataset", horizontal: str, vertical: str) -> Line2D:
    """Ink with a white rim, which is seen on any colour."""
    at = data.attrs[f"gait_{horizontal}"], data.attrs[f"gait_{vertical}"]
    low, high = np.transpose([axes.get_xlim(), axes.get_ylim()])
    inside = np.all((low <= at) & (at <= high))
    (cross,) = axes.plot(
        *at,
        "+",
        color=style.INK,
        markersize=12,
        markeredgewidth=1.8,
        zorder=5,
        scalex=False,
        scaley=False,
        path_effects=[withStroke(linewidth=4.5, foreground="white")],
        label="gait" if inside else "gait: beyond the map",
    )
    return cross


def _mark_small(
    figure: Figure, axes: Axes, data: "xarray.Dataset", where: NDArray[np.bool_], colour: str
) -> None:
    """Mark starts that are too small to be seen by themselves."""
    extent, points = axes.get_window_extent(), 72.0 / figure.dpi
    rows, columns = where.shape
    if min(extent.width / columns, extent.height / rows) * points >= SMALLEST:
        return
    vertical, horizontal = map(str, data["fate"].dims)
    rows_of, columns_of = np.nonzero(where)
    at = data[horizontal].values[columns_of], data[vertical].values[rows_of]
    look: dict[str, Any] = {"markeredgewidth": 0.0, "scalex": False, "scaley": False, "rasterized": True}
    for size, filled in ((SMALLEST + 2.0 * RIM, "white"), (SMALLEST, colour)):
        axes.plot(*at, "s", color=filled, markersize=size, **look)


def _label(data: "xarray.Dataset", axis: str) -> str:
    """Label with its unit; in SI units it also gives the runner's own scale."""
    unit, values = data[axis].attrs["units"], runner_in(data)
    label = style.with_unit(style.in_words(axis), paper_units.label(unit, values))
    has_scales = set(paper_units.SCALES) <= values.keys()
    if unit == "rad" or paper_units.are_in_use(values) or not has_scales:
        return label
    size = paper_units.scale(unit, values)
    return f"{label[:-1]};  {style.printed(paper_unit(unit))} = {size:.4g} {unit})"


DRAWN = ("com_height", "com_speed")
"""Coordinates of the apices."""
MAX_LINES = 20
"""Largest number of runners drawn one by one; of more, the median and the middle nine tenths are drawn."""
REPORTED = ("speed", "cost_of_transport")
"""Quantities of a run's last stride that are drawn."""


def of_strides(made: "xarray.Dataset") -> Figure:
    """Height and speed of the apices, stride by stride."""
    apices = np.concatenate([made["apex"].values[:, :1], made["next_apex"].values], axis=1)
    figure, panels = style.subplots(2, 1, figsize=(6.8, 5.4), sharex=True)
    model, names = model_recorded(made.attrs), made["coordinate"].values.tolist()
    drawn = DRAWN if set(DRAWN) <= set(names) else names[: len(DRAWN)]
    for axes, name in zip(panels, drawn, strict=False):
        _draw_runners(axes, apices[..., names.index(name)])
        unit = paper_units.label(model.coordinate(name).unit, runner_in(made))
        style.label(axes, "", style.with_unit(style.in_words(name), unit))
    panels[-1].set_xlabel("strides")
    panels[-1].xaxis.set_major_locator(MaxNLocator(integer=True))
    if len(apices) > MAX_LINES:
        figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
    runners, strides = made["fate"].shape
    closed = int((made["fate"] == CLOSED).sum())
    panels[0].set_title(
        f"{counted(runners, 'runner')}, {closed:,} of {counted(runners * strides, 'stride')} closed"
    )
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
    """Speed and cost of transport of each run's last stride, over the parameter that differs."""
    name = next((str(name) for name in runs.coords if len(np.unique(runs[name])) > 1), None)
    numeric = name is not None and runs[name].dtype.kind in "iuf"
    along = runs[name].values if name is not None and numeric else np.arange(len(runs["fallen"]))
    values = {of: float((runs[of] == 1.0).all()) if of in runs else 1.0 for of in paper_units.SCALES}
    figure, panels = style.subplots(2, 1, figsize=(6.8, 5.4), sharex=True)
    for axes, quantity in zip(panels, REPORTED, strict=True):
        for fell, colour, label in ((False, style.CURVE, "ran"), (True, "#b3216f", "fell in the end")):
            where = runs["fallen"].values == fell
            if where.any():
                axes.plot(
                    along[where], runs[quantity].values[where], "o", color=colour, markersize=4.5, label=label
                )
        unit = paper_units.label(VARIABLES[f"stride.{quantity}"].unit, values)
        axes.set_ylabel(style.with_unit(style.in_words(quantity), unit))
    unit = paper_units.label(VARIABLES[name].unit, values) if name and numeric else ""
    panels[-1].set_xlabel(style.with_unit(name, unit) if name and numeric else "run")
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
    panels[0].set_title(f"last stride of {counted(len(along), 'run')}")
    return figure


VIABLE_COLOURS = ListedColormap(matplotlib.colormaps["GnBu"](np.linspace(0.18, 1.0, 256)))
"""Colours without the palest, which are hardly distinguished from the paper."""
OPEN, NOT_VIABLE = "#f0b35a", "#efe9e4"
"""Colours of cells that the grid leaves open, and of those from which no action of the grid helps."""


def of_viable_set(found: xarray.Dataset) -> Figure:
    """The sets as a figure."""
    figure, axes = style.subplots(figsize=(7.6, 5.4))
    vertical, horizontal = map(str, found["viable"].dims)
    edges = found[f"{horizontal}_edge"].values, found[f"{vertical}_edge"].values
    states, robustness = found["viable"].values, found["inner_robustness"].values
    for level, colour in ((0, NOT_VIABLE), (1, OPEN)):
        style.paint_cells(axes, edges, states == level, colour)
    largest = float(np.max(robustness)) or 1.0
    mesh = style.paint_cells(axes, edges, states == 2, VIABLE_COLOURS, robustness, largest)
    figure.colorbar(mesh, ax=axes, label="share of actions that lead to a viable state (inner set)", pad=0.01)
    handles = [
        Patch(color=OPEN, label="undecided on this grid"),
        Patch(facecolor=NOT_VIABLE, edgecolor=style.FAINT, label="no action on the grid avoids a fall"),
    ]
    figure.legend(handles=handles, loc="outside lower center", ncols=2)
    runner = Runner(runner_in(found), model=found.model)
    labels = [
        style.with_unit(style.in_words(axis), runner.label(runner.model.coordinate(axis).unit))
        for axis in (horizontal, vertical)
    ]
    style.label(axes, *labels)
    begin = _at_friction(runner).replace(", ", ": ")
    actions = found["viable_pair"].size // found["viable"].size
    axes.set_title(
        f"{begin}{found.inner_share:.1%} to {found.outer_share:.1%} of the plane viable, {actions} actions"
    )
    return figure
