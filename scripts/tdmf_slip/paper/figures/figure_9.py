"""Figure 9: largest eigenvalue, speed and cost of transport of the gaits against friction, with their words.

The paper has no eigenvalues below friction 0.3 and no gaits below 0.1, and its axis leaves out 2 to 7. These
ranges are tinted here.
"""

from collections.abc import Sequence

import pandas
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from ...pictures import style
from ..published import BEST_FRICTION, COST_GAIN, SPEED_GAIN
from .data import Results, table_by
from .over_friction import CONTROL, friction_axis, mark_words

PAPER_SHOWS = {"eigenvalue": ((0.3, 2.0), (7.0, 10.0)), "gait": ((0.1, 2.0), (7.0, 10.0))}
"""Ranges of friction in the paper's own figure."""
TINT = "#eef3e6"
PANELS = (
    ("lambda_max", r"(a) largest eigenvalue $\lambda_{max}$", "eigenvalue"),
    ("speed", r"(b) average speed $V$ (l₀√(k/m))", "gait"),
    ("cost_of_transport", r"(c) cost of transport $c_{mt}$", "gait"),
)


def table(results: Results) -> pandas.DataFrame:
    """Data of the figure. `matched` is 1 for runners matched to the first gait."""
    columns = "friction", "word", "lambda_max", "speed", "cost_of_transport"
    return table_by(["matched"], results.both, *columns)


def draw(results: Results) -> Figure:
    """Draw the three panels, with matched runners dashed."""
    both = results.table("figure_9")
    data, equal = both[both["matched"] == 0], both[both["matched"] == 1]
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
