"""Gaits along a parameter: size of the eigenvalues, speed and cost of transport."""

from collections.abc import Mapping, Sequence
from itertools import pairwise
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, StrMethodFormatter

from ..analysis.special_points import Border
from ..analysis.sweeps import Sweep
from ..library.gait import Gait
from ..variables.display_units import DisplayUnits
from ..variables.table import VARIABLES
from . import style

PANELS: Mapping[str, str] = {"speed": "average speed", "cost_of_transport": "cost of transport"}
"""Quantities of a stride, and their names."""
LETTER_WIDTH = 11.0
"""Pixels that a letter of a word needs."""
DECADES = 10.0
"""Values that span more are shown on a logarithmic axis."""


def figure_of(
    name: str,
    values: Sequence[float],
    gaits: Sequence[Gait],
    borders: Sequence[Border],
    display: DisplayUnits | None = None,
) -> Figure:
    """Three panels over a parameter; unstable gaits are dashed."""
    display = display or DisplayUnits(values=gaits[0].runner)
    with style.styled():
        figure, panels = style.subplots(len(PANELS) + 1, 1, figsize=(7.6, 7.2), sharex=True)
        _eigenvalues(panels[0], values, gaits)
        for axes, (quantity, label) in zip(panels[1:], PANELS.items(), strict=True):
            _draw(axes, values, [gait.stride[quantity] for gait in gaits], gaits)
            unit = VARIABLES[f"stride.{quantity}"].unit
            axes.set_ylabel(style.with_unit(label, display.label(unit)))
        for axes in panels:
            for border in borders:
                axes.axvline(border.value, **style.STANCE_LINE)
        label = style.tell_in(panels[-1].xaxis, name, display)
        if display.factor(name) == 1.0 and min(values) > 0 and max(values) > DECADES * min(values):
            panels[-1].set_xscale("log")
            panels[-1].xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
            panels[-1].xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
            panels[-1].minorticks_off()
        panels[-1].set_xlabel(label)
        figure.draw_without_rendering()  # lays out the axes
        _words(panels[0], values, gaits)
    return figure


def draw(path: Path, found: Sweep, display: DisplayUnits | None = None) -> None:
    """Draw a sweep into a file."""
    style.save(figure_of(*drawn_of(found), display), path)


def drawn_of(found: Sweep) -> tuple[str, list[float], tuple[Gait, ...], tuple[Border, ...]]:
    """What `figure_of` draws of a sweep: name, values, gaits, borders."""
    return found.name, [gait.runner[found.name] for gait in found.gaits], found.gaits, found.borders


def _eigenvalues(axes: Axes, values: Sequence[float], gaits: Sequence[Gait]) -> None:
    sizes = np.array([np.abs(gait.eigenvalues[:3]) for gait in gaits])
    for column, colour in zip(sizes.T, (style.CURVE, style.SECOND_CURVE, style.FAINT), strict=True):
        _draw(axes, values, column, gaits, colour)
    axes.axhline(1.0, **style.LIMIT_LINE)
    axes.set_ylabel("moduli of the eigenvalues")


def _draw(
    axes: Axes,
    values: Sequence[float],
    heights: Sequence[float],
    gaits: Sequence[Gait],
    colour: str = style.CURVE,
) -> None:
    stable = np.array([gait.stable for gait in gaits])
    axes.plot(values, heights, color=colour, linewidth=1.0, linestyle=style.SLIP_DASHES)
    axes.plot(
        values, np.where(stable, heights, np.nan), color=colour, marker="." if len(values) < 2 else None
    )


def _words(axes: Axes, values: Sequence[float], gaits: Sequence[Gait]) -> None:
    """The gait word above each stretch of equal words that has room for it; none where a branch turns."""
    if len(set(np.sign(np.diff(values)))) > 1:
        return
    starts = [0, *(i for i in range(1, len(gaits)) if gaits[i].word != gaits[i - 1].word), len(gaits)]
    shown = axes.transData.transform([(value, 0.0) for value in values])[:, 0]
    for start, end in pairwise(starts):
        word = style.word(gaits[start].word)
        if abs(shown[end - 1] - shown[start]) > LETTER_WIDTH * len(word) or len(starts) == 2:
            middle = axes.transData.inverted().transform((0.5 * (shown[start] + shown[end - 1]), 0.0))[0]
            top = ("data", "axes fraction")
            axes.annotate(word, (middle, 1.02), xycoords=top, ha="center", fontsize=9)
