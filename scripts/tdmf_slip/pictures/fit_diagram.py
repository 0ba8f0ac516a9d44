"""A fit as a diagram: each measured quantity with its error bars and the fitted one, and the residuals."""

import base64
import html
from collections.abc import Iterable, Sequence
from itertools import cycle
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..files.whole import write_whole
from ..fitting.measurements import measurable
from ..fitting.result import CONFIDENCE, PARAMETER_HEADER, QUANTILE, RESIDUAL_HEADER, Fit, Residual
from ..library.quantities import unit_of
from ..library.runner import Runner
from . import style

DATA, FITTED = style.INK, style.MODE_COLOURS["slip_positive"]
WIDTH, HEIGHT = 7.6, 2.5
"""Width of the figure and height of each row of panels, inches."""
COLOURS = ("#0b7a75", "#1f5fa8", "#b3216f", "#e07b00", "#5b2a86", "#8a5a00")
"""Colours of residuals, by quantity in the order of `measurable`, repeated."""
FEW = 12
"""Rows that are numbered each."""


def figure_of(fit: Fit) -> Figure:
    """A panel for each quantity, and one for the residuals over their errors."""
    known = measurable(fit.runners[0].model)
    names = [name for name in known if any(of.name == name for of in fit.residuals)]
    ticks, title = _tick_positions(fit)
    shown = [name for name in names if title.startswith("row") or name != "speed"] or names
    lines = (len(shown) + 1) // 2
    figure = style.Picture(figsize=(WIDTH, HEIGHT * (lines + 1)), layout="constrained")
    grid = figure.add_gridspec(lines + 1, 2)
    for number, name in enumerate(shown):
        whole = number == len(shown) - 1 and number % 2 == 0
        axes = figure.add_subplot(grid[number // 2, :] if whole else grid[number // 2, number % 2])
        _quantity(axes, [of for of in fit.residuals if of.name == name], ticks, fit.runners[0])
        axes.set_xlabel(title)
    _residuals(figure.add_subplot(grid[lines, :]), fit, names, ticks, title)
    figure.axes[0].legend()
    return figure


def _tick_positions(fit: Fit) -> tuple[Sequence[float], str]:
    """Places of the rows on the horizontal axis, and its title."""
    speeds = [row["speed"].value for row in fit.measurements.rows if "speed" in row]
    if len(speeds) > 1 and len(set(speeds)) == len(fit.measurements.rows):
        runner = fit.runners[0]
        return speeds, style.with_unit("measured speed", runner.label(unit_of("speed", runner.model)))
    return range(1, len(fit.measurements.rows) + 1), "row"


def _ticks(axes: Axes, ticks: Sequence[float]) -> None:
    """Whole numbers, and room at both sides."""
    if isinstance(ticks, range):
        if len(ticks) <= FEW:
            axes.set_xticks(list(ticks))
        axes.set_xlim(0.5, len(ticks) + 0.5)


def _quantity(axes: Axes, residuals: Sequence[Residual], ticks: Sequence[float], runner: Runner) -> None:
    """A quantity as it was measured, with one standard error, and as it was fitted."""
    at = [ticks[of.row - 1] for of in residuals]
    axes.errorbar(
        at,
        [of.measured for of in residuals],
        [of.error for of in residuals],
        fmt="o",
        color=DATA,
        markersize=4,
        linewidth=1.0,
        capsize=3,
        label="measured, ± standard error",
    )
    axes.plot(at, [of.fitted for of in residuals], "x", color=FITTED, markersize=7, label="fitted", zorder=4)
    name = residuals[0].name
    axes.set_title(style.with_unit(style.in_words(name), runner.label(unit_of(name, runner.model))))
    _ticks(axes, ticks)


def _residuals(axes: Axes, fit: Fit, names: Sequence[str], ticks: Sequence[float], title: str) -> None:
    """Residuals over their errors, and where 95 % of them are to be."""
    for name, colour in zip(measurable(fit.runners[0].model), cycle(COLOURS), strict=False):
        its = [of for of in fit.residuals if of.name == name]
        if name in names:
            at = [ticks[of.row - 1] for of in its]
            axes.plot(
                at, [of.residual for of in its], "o", color=colour, markersize=4, label=style.in_words(name)
            )
    axes.axhline(0.0, color=style.GROUND, linewidth=0.8, zorder=0)
    for quantile in (-QUANTILE, QUANTILE):
        axes.axhline(quantile, **style.LIMIT_LINE)
    largest = max(float(np.max(np.abs([of.residual for of in fit.residuals]))), QUANTILE)
    axes.set_ylim(-1.15 * largest, 1.15 * largest)
    axes.set_title("fitted less measured, over the standard error; dashed: 95 %")
    axes.set_xlabel(title)
    _ticks(axes, ticks)
    axes.legend(ncols=3)


FORMATS = (".html",)


def write(path: Path, fit: Fit) -> None:
    """Write the report of a fit, whole or not at all."""
    page = style.template("fit_report").substitute(
        where=html.escape(fit.measurements.where),
        confidence=f"{100.0 * CONFIDENCE:.0f}",
        parameters=_table(PARAMETER_HEADER, fit.parameter_rows()),
        intervals=html.escape(_intervals(fit)),
        sentences="\n".join(f"<li>{html.escape(sentence)}</li>" for sentence in fit.sentences()),
        picture=_picture(fit),
        residuals=_table(RESIDUAL_HEADER, fit.residual_rows()),
    )
    write_whole(path, lambda beside: beside.write_text(page, encoding="utf-8", errors="backslashreplace"))


def _intervals(fit: Fit) -> str:
    """Sentences about the errors of the data and the kind of each interval."""
    factor = ", known except for a common factor" if fit.request.scale_errors else ""
    linear = [estimate.label for estimate in fit.estimates if not estimate.is_profiled]
    kinds = "by the profile likelihood" if len(linear) < len(fit.estimates) else "linearized"
    exceptions = f", except those of {', '.join(linear)}, which are linearized"
    is_mixed = 0 < len(linear) < len(fit.estimates)
    return (
        f"The errors of the data are standard errors{factor}. "
        f"Intervals are {kinds}{exceptions if is_mixed else ''}."
    )


def _picture(fit: Fit) -> str:
    """The figure as PNG in base 64."""
    with style.styled():
        return base64.b64encode(style.png_of(figure_of(fit))).decode()


def _table(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    def cells(tag: str, row: Sequence[str]) -> str:
        return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in row) + "</tr>"

    return "\n".join(["<table>", cells("th", header), *(cells("td", row) for row in rows), "</table>"])
