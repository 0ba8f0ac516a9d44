"""Figure 9 and the losses over friction, and parts of such figures: axis, words, matched runners, means.

Figure 9 has the largest eigenvalue, speed and cost of transport of the gaits. The paper has no eigenvalues
below friction 0.3 and no gaits below 0.1, and its axis leaves out 2 to 7. These ranges are tinted here.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
import pandas
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from ...analysis.sweeps import Sweep
from ...library.quantities import weight_of
from ...pictures import style
from ...pictures.style import CurveLabel
from ...variables.table import FRICTION
from ...variables.variable import Values
from ..along import words_over
from ..published import BEST_FRICTION, COST_GAIN, SPEED_GAIN
from .data import Results

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


PAPER_SHOWS = {"eigenvalue": ((0.3, 2.0), (7.0, 10.0)), "gait": ((0.1, 2.0), (7.0, 10.0))}
"""Ranges of friction in the paper's own figure."""
TINT = "#eef3e6"
PANELS = (
    ("lambda_max", r"(a) largest eigenvalue $\lambda_{max}$", "eigenvalue"),
    ("speed", r"(b) average speed $V$ (l₀√(k/m))", "gait"),
    ("cost_of_transport", r"(c) cost of transport $c_{mt}$", "gait"),
)


def figure_9_table(results: Results) -> pandas.DataFrame:
    """Data of figure 9."""
    return results.both[["matched", "friction", "word", "lambda_max", "speed", "cost_of_transport"]]


def draw_figure_9(results: Results) -> Figure:
    """Draw the three panels, with matched runners dashed."""
    both = results.table("figure_9")
    data, equal = both[~both["matched"]], both[both["matched"]]
    figure, axes = style.subplots(3, 1, figsize=(7.6, 8.4), sharex=True)
    for panel, (name, title, shown) in zip(axes, PANELS, strict=True):
        _tint(panel, PAPER_SHOWS[shown], min(data["friction"]))
        panel.plot(data["friction"], data[name], color=style.CURVE, zorder=3)
        (control,) = panel.plot(equal["friction"], equal[name], **CONTROL)
        panel.set_title(title, pad=18 if panel is axes[0] else None)
    for panel, name, gain in ((axes[1], "speed", SPEED_GAIN), (axes[2], "cost_of_transport", COST_GAIN)):
        without = data[name][data["friction"].idxmax()]
        (mark,) = panel.plot(BEST_FRICTION, (1.0 + gain / 100.0) * without, **style.PUBLISHED)
    mark_words(axes, results.sweep)
    missing = Patch(color=TINT, label="range that the paper's figure leaves out")
    figure.legend(handles=[control, mark, missing], loc="outside lower center", ncols=2)
    friction_axis(axes[-1], data["friction"])
    return figure


def _tint(axes: Axes, shown: Sequence[tuple[float, float]], edge: float) -> None:
    """Tint the ranges that the paper's figure does not show."""
    for low, high in shown:
        if low > edge:
            axes.axvspan(edge, low, color=TINT, zorder=0, linewidth=0)
        edge = high


SHARES = {
    "impact_loss": ("lost at the impact", "#1f5fa8"),
    "damper_loss": ("lost in the damper", "#9bb8d3"),
    "friction_loss": ("lost to friction", "#e07b00"),
}
"""Labels and colours of the losses, from bottom to top."""
TITLES = (
    "(a) the paper's runner: only friction varies",
    "(b) every runner with the speed, apex height and leg angle of the gait at friction 10",
)


def energy_table(results: Results) -> pandas.DataFrame:
    """Energies per weight and stride length."""
    data = results.both
    losses = data[[*SHARES]].div(weight_of(results.runner) * data["length"], axis=0)
    return data[["matched", "friction", "word", "cost_of_transport"]].join(losses)


def draw_energy(results: Results) -> Figure:
    """Draw the stacked losses and the hip's work, for the paper's runner and for matched runners."""
    figure, panels = style.subplots(2, 1, figsize=(7.6, 7.6), sharex=True, sharey=True)
    data = results.table("energy")
    for axes, title, matched in zip(panels, TITLES, (False, True), strict=True):
        _draw_shares(axes, data[data["matched"] == matched])
        axes.set_title(title, pad=18 if axes is panels[0] else None)
    mark_words(panels[:1], results.sweep)
    friction_axis(panels[1], data["friction"])
    panels[0].set_ylim(0.0, 1.2 * data["cost_of_transport"].max())
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=4)
    return figure


def _draw_shares(axes: Axes, data: pandas.DataFrame) -> None:
    labels, colours = zip(*SHARES.values(), strict=True)
    axes.stackplot(data["friction"], data[[*SHARES]].T, labels=labels, colors=colours, linewidth=0)
    axes.plot(data["friction"], data["cost_of_transport"], color=style.INK, label="work of the hip")
    axes.set_ylabel("energy per stride (weight × stride length)")
