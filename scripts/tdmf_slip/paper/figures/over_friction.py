"""Parts of figures over friction: axis, gait words, matched runners, and means with intervals."""

from typing import Any

import numpy as np
import pandas
from matplotlib.axes import Axes

from ...analysis.sweeps import Sweep
from ...pictures import style
from ...pictures.style import CurveLabel
from ...variables.table import FRICTION
from ...variables.variable import Values
from ..along import words_over

CONTROL = {
    "color": "#7a5195",
    "linestyle": "--",
    "zorder": 3,
    "label": "speed, apex height and leg angle of the gait at friction 10",
}
"""Line style of matched runners."""
HEIGHTS, LEADER = np.linspace(0.05, 0.95, 19), 14.0
"""Places for the word of a narrow range: shares of the axes' height, and points beside its border."""
NARROW = 1.02
"""Largest ratio of two borders of friction between which a word does not fit above the axes."""
TICKS = (0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0)


def mark_words(panels: Any, sweep: Sweep) -> None:
    """Draw the borders between words in all panels, and write the words above the first one.

    The word of a narrow range stands inside the first panel.
    """
    for axes in panels:
        for border in sweep.borders[FRICTION].values:
            axes.axvline(border, **style.STANCE_LINE)
    for word, high, low in words_over(sweep):
        centre = (high * low) ** 0.5
        where: Any = {"xycoords": ("data", "axes fraction"), "fontsize": 9}
        if high > NARROW * low:
            panels[0].annotate(style.word(word), (centre, 1.02), ha="center", **where)
        else:
            along = np.array([(centre, height) for height in HEIGHTS])
            CurveLabel(panels[0], style.word(word), along, distances=(LEADER,), **where)


def friction_axis(axes: Axes, frictions: Values) -> None:
    """Make a logarithmic axis of friction with plain numbers."""
    axes.set_xscale("log")
    axes.set_xlim(min(frictions), max(frictions))
    axes.set_xticks(TICKS, [f"{tick:g}" for tick in TICKS])
    axes.minorticks_off()
    axes.set_xlabel("friction coefficient μ")


def draw_means(
    axes: Axes, data: pandas.DataFrame, name: str, colour: str, marks: str = "o-", **look: Any
) -> None:
    """Draw means with their intervals, and a triangle at the lower end where no runner fell."""
    friction, mean, low, high = (
        data[of].to_numpy() for of in ("friction", name, f"{name}_low", f"{name}_high")
    )
    known = np.isfinite(mean)
    shown = np.where(known, mean, np.nan)
    bars: dict[str, Any] = {"capsize": 2, "linewidth": 0, "elinewidth": 1.2}
    axes.errorbar(friction, shown, [shown - low, high - shown], color=colour, **bars)
    axes.plot(friction, shown, marks, color=colour, markersize=4, linewidth=1.0, **look)
    axes.plot(friction[~known], low[~known], "^", color=colour, markersize=5)
