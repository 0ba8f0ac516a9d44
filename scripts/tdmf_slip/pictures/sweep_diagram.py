"""Gaits over one parameter, by eigenvalues, speed and cost of transport; over two, by speed and word."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import LogLocator, StrMethodFormatter
from numpy.typing import NDArray

from ..analysis.sweeps import Sweep
from ..errors import InputError, counted
from ..record import runner_in
from ..variables.display_units import DisplayUnits
from ..variables.table import model_recorded
from . import style

if TYPE_CHECKING:
    import xarray

PANELS: Mapping[str, str] = {"speed": "average speed", "cost_of_transport": "cost of transport"}
"""Quantities of a stride, and their names."""
LETTER_WIDTH = 11.0
"""Pixels that a letter of a word needs."""
DECADES = 10.0
"""Values that span more are shown on a logarithmic axis."""
WORD_COLOURS = matplotlib.colormaps["tab20"].colors  # type: ignore[attr-defined] # a list of colours


def of_sweep(found: Sweep, display: DisplayUnits | None = None) -> Figure:
    """A sweep with its borders."""
    return figure_of(found.gaits, found.borders, display)


def figure_of(
    gaits: "xarray.Dataset", borders: "xarray.Dataset | None" = None, display: DisplayUnits | None = None
) -> Figure:
    """Curves over one name, or maps over two."""
    dimensions = gaits["word"].ndim
    if not np.isfinite(gaits["period"]).any():
        raise InputError("plot: this sweep found no gait, so there is nothing to draw")
    model = model_recorded(gaits.attrs)
    display = display or DisplayUnits(values=runner_in(gaits), model=model)
    return _curves(gaits, borders, display) if dimensions == 1 else _map(gaits, display)


def _curves(gaits: "xarray.Dataset", borders: "xarray.Dataset | None", display: DisplayUnits) -> Figure:
    """Three panels over a parameter; unstable gaits are dashed."""
    name = str(gaits["word"].dims[0])
    found = gaits.isel({name: np.flatnonzero(gaits["word"].values != "")})
    values = found[name].values
    shown = {quantity: label for quantity, label in PANELS.items() if quantity in found}
    shown = shown or {"period": "period"}
    figure, panels = style.subplots(len(shown) + 1, 1, figsize=(7.6, 7.2), sharex=True)
    moduli = np.hypot(found["eigenvalue_real"].values, found["eigenvalue_imag"].values)[:, :3]
    stable, marker = found["lambda_max"].values < 1.0, "." if len(values) < 2 else None
    for column, colour in zip(moduli.T, (style.CURVE, style.SECOND_CURVE, style.FAINT), strict=False):
        style.stable_curve(panels[0], values, column, stable, colour, marker=marker)
    panels[0].axhline(1.0, **style.LIMIT_LINE)
    panels[0].set_ylabel("moduli of the eigenvalues")
    for axes, (quantity, label) in zip(panels[1:], shown.items(), strict=True):
        style.stable_curve(axes, values, found[quantity].values, stable, style.CURVE, marker=marker)
        axes.set_ylabel(style.with_unit(label, display.label(found[quantity].attrs["units"])))
    for axes in panels:
        for value in [] if borders is None else borders[name].values:
            axes.axvline(value, **style.STANCE_LINE)
    label = style.mark_in_display_unit(panels[-1].xaxis, name, display)
    if display.factor(name) == 1.0 and min(values) > 0 and max(values) > DECADES * min(values):
        panels[-1].set_xscale("log")
        panels[-1].xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        panels[-1].xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
        panels[-1].minorticks_off()
    panels[-1].set_xlabel(label)
    figure.draw_without_rendering()  # lays out the axes
    _words(panels[0], values, found["word"].values.tolist())
    return figure


def _words(axes: Axes, values: NDArray[np.float64], words: Sequence[str]) -> None:
    """The gait word above each stretch of equal words that has room for it; none where a branch turns."""
    if len(set(np.sign(np.diff(values)))) > 1:
        return
    shown = axes.transData.transform([(value, 0.0) for value in values])[:, 0]
    runs = style.runs_of(words)
    for word, rows in runs:
        begin, end = shown[rows][[0, -1]]
        if abs(end - begin) > LETTER_WIDTH * len(word) or len(runs) == 1:
            middle = axes.transData.inverted().transform((0.5 * (begin + end), 0.0))[0]
            top: Any = ("data", "axes fraction")
            axes.annotate(style.word(word), (middle, 1.02), xycoords=top, ha="center", fontsize=9)


def _map(gaits: "xarray.Dataset", display: DisplayUnits) -> Figure:
    """Speed on the left, words on the right; white where no gait was found."""
    vertical, horizontal = map(str, gaits["word"].dims)
    edges = style.edges_of(gaits[horizontal].values), style.edges_of(gaits[vertical].values)
    words = gaits["word"].values
    figure, panels = style.subplots(1, 2, figsize=(10.4, 4.6), sharey=True)
    speeds = np.ma.masked_invalid(gaits["speed"].values)
    mesh = panels[0].pcolormesh(*edges, speeds, cmap="viridis", rasterized=True)
    figure.colorbar(mesh, ax=panels[0], label=style.with_unit("speed", display.label("m/s")), pad=0.01)
    handles = []
    for number, word in enumerate(sorted({word for word in words.ravel() if word})):
        colour = WORD_COLOURS[number % len(WORD_COLOURS)]
        style.paint_cells(panels[1], edges, words == word, colour)
        handles.append(Patch(color=colour, label=style.word(word)))
    panels[1].legend(handles=handles, title="word", loc="upper left", bbox_to_anchor=(1.01, 1.0))
    for axes in panels:
        axes.set_xlabel(style.mark_in_display_unit(axes.xaxis, horizontal, display))
    panels[0].set_ylabel(style.mark_in_display_unit(panels[0].yaxis, vertical, display))
    panels[0].set_title(f"{speeds.count():,} of {counted(words.size, 'gait')}")
    return figure
