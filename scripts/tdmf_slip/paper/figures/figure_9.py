"""Figure 9: largest eigenvalue, speed and cost of transport of the gaits against friction, with their words.

The paper has no eigenvalues below friction 0.3 and no gaits below 0.1, and its axis leaves out 2 to 7. These
ranges are tinted here.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from ...analysis.sweeps import Row
from ...library.gait import Gait
from ...pictures import style
from ...pictures.style import CurveLabel
from ...variables.variable import Values
from ..published import BEST_FRICTION, COST_GAIN, SPEED_GAIN
from .columns import Data, as_columns, attributes, select

CONTROL = {
    "color": "#7a5195",
    "linestyle": "--",
    "zorder": 3,
    "label": "speed, apex height and leg angle of the gait at friction 10",
}
"""Look of matched runners."""
HEIGHTS, LEADER = np.linspace(0.05, 0.95, 19), 14.0
"""Places for the word of a narrow range: shares of the axes' height, and points beside its border."""
NARROW = 1.02
"""Largest ratio of two borders of friction between which a word does not fit above the axes."""
PAPER_SHOWS = {"eigenvalue": ((0.3, 2.0), (7.0, 10.0)), "gait": ((0.1, 2.0), (7.0, 10.0))}
"""Ranges of friction in the paper's own figure."""
TINT = "#eef3e6"
TICKS = (0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0)


def table(sweep: Row, matched: Sequence[Gait]) -> Data:
    """Data of the figure by column. `matched` is 1 for runners matched to the first gait."""
    gaits = [*sweep.gaits, *matched]
    return {
        "matched": [0] * len(sweep.gaits) + [1] * len(matched),
        **attributes(gaits, "friction", "word", "lambda_max", "speed", "cost_of_transport"),
    }


def draw(sweep: Row, matched: Sequence[Gait]) -> Figure:
    """Draw the three panels, with matched runners dashed."""
    both = as_columns(table(sweep, matched))
    data, equal = (select(both, matched=is_matched) for is_matched in (0, 1))
    panels = (
        ("lambda_max", r"(a) largest eigenvalue $\lambda_{max}$", "eigenvalue"),
        ("speed", r"(b) average speed $V$ (l₀√(k/m))", "gait"),
        ("cost_of_transport", r"(c) cost of transport $c_{mt}$", "gait"),
    )
    figure, axes = style.subplots(3, 1, figsize=(7.6, 8.4), sharex=True)
    for panel, (name, title, shown) in zip(axes, panels, strict=True):
        tint(panel, PAPER_SHOWS[shown], data["friction"])
        panel.plot(data["friction"], data[name], color=style.CURVE, zorder=3)
        (control,) = panel.plot(equal["friction"], equal[name], **CONTROL)
        panel.set_title(title, pad=18 if panel is axes[0] else None)
        mark_borders(panel, sweep)
    for panel, name, gain in ((axes[1], "speed", SPEED_GAIN), (axes[2], "cost_of_transport", COST_GAIN)):
        without = data[name][int(np.argmax(data["friction"]))]
        (mark,) = panel.plot(BEST_FRICTION, (1.0 + gain / 100.0) * without, **style.PUBLISHED)
    name_words(axes[0], sweep)
    missing = Patch(color=TINT, label="range that the paper's figure leaves out")
    figure.legend(handles=[control, mark, missing], loc="outside lower center", ncols=2)
    friction_axis(axes[-1], data["friction"])
    return figure


def tint(axes: Axes, shown: Sequence[tuple[float, float]], frictions: Values) -> None:
    """Tint the ranges that the paper's figure does not show."""
    edge = min(frictions)
    for low, high in shown:
        if low > edge:
            axes.axvspan(edge, low, color=TINT, zorder=0, linewidth=0)
        edge = high


def mark_borders(axes: Axes, sweep: Row) -> None:
    """Draw a dashed line at each border between words."""
    for border in sweep.borders:
        axes.axvline(border.value, **style.STANCE_LINE)


def name_words(axes: Axes, sweep: Row) -> None:
    """Write the gait words above the axes, between the borders; a narrow range is named inside the axes."""
    frictions = sorted(gait.friction for gait in (sweep.gaits[0], sweep.gaits[-1]))
    edges = [frictions[-1], *(border.value for border in sweep.borders), frictions[0]]
    words = [sweep.gaits[0].word, *(border.after for border in sweep.borders)]
    for word, high, low in zip(words, edges, edges[1:], strict=False):
        centre = (high * low) ** 0.5
        where: Any = {"xycoords": ("data", "axes fraction"), "fontsize": 9}
        if high > NARROW * low:
            axes.annotate(style.word(word), (centre, 1.02), ha="center", **where)
        else:
            along = np.array([(centre, height) for height in HEIGHTS])
            CurveLabel(axes, style.word(word), along, distances=(LEADER,), **where)


def friction_axis(axes: Axes, frictions: Values) -> None:
    """Make a logarithmic axis of friction with plain numbers."""
    axes.set_xscale("log")
    axes.set_xlim(min(frictions), max(frictions))
    axes.set_xticks(TICKS, [f"{tick:g}" for tick in TICKS])
    axes.minorticks_off()
    axes.set_xlabel("friction coefficient μ")
