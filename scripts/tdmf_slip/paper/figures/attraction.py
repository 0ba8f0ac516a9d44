"""Two measures of a gait's stability against friction: its largest eigenvalue, and what it attracts."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...analysis.attraction import FARTHEST
from ...analysis.sweeps import Row
from ...feedback.judgement import Judgement
from ...pictures import style
from ...pictures.style import CurveLabel
from . import figure_9
from .columns import Columns, Data, as_columns, attributes

DISTURBANCES = {
    "step_down": ("step down (l₀)", "#1f5fa8"),
    "push_forward": ("push forward (l₀√(k/m))", "#e07b00"),
}
"""Labels and colours of the disturbances that are drawn."""


def table(_sweep: Row, measured: Sequence[Judgement], matched: Sequence[Judgement] = ()) -> Data:
    """Data of the figure by column. `matched` is 1 or 0; inf is a disturbance beyond the largest tried."""
    rows = [*measured, *matched]
    return {
        "matched": [0] * len(measured) + [1] * len(matched),
        **attributes([one.gait for one in rows], "friction", "word", "lambda_max"),
        "attracted_share": [one.volume.share for one in rows],
        "attracted_share_low": [one.volume.interval[0] for one in rows],
        "attracted_share_high": [one.volume.interval[1] for one in rows],
        "samples": [one.volume.samples for one in rows],
        **attributes(
            [one.robustness for one in rows], "push_forward", "push_backward", "step_down", "step_up"
        ),
    }


def draw(sweep: Row, measured: Sequence[Judgement], matched: Sequence[Judgement]) -> Figure:
    """Draw the share of starts that settle, the largest eigenvalue, and the largest disturbances."""
    data, equal = as_columns(table(sweep, measured)), as_columns(table(sweep, matched))
    figure, axes = style.subplots(3, 1, figsize=(7.6, 7.6), sharex=True)
    _draw_share(axes[0], data)
    axes[0].plot(equal["friction"], equal["attracted_share"], **figure_9.CONTROL)
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
    axes[1].plot(equal["friction"], equal["lambda_max"], **figure_9.CONTROL)
    axes[1].plot(
        [gait.friction for gait in sweep.gaits], [gait.lambda_max for gait in sweep.gaits], color=style.CURVE
    )
    axes[1].set_title(r"(b) largest eigenvalue $\lambda_{max}$")
    _draw_disturbances(axes[2], data)
    for name, (_, colour) in DISTURBANCES.items():
        axes[2].plot(equal["friction"], np.minimum(equal[name], FARTHEST), "--", linewidth=1.0, color=colour)
    for panel in axes:
        figure_9.mark_borders(panel, sweep)
    figure_9.name_words(axes[0], sweep)
    figure_9.friction_axis(axes[-1], [gait.friction for gait in sweep.gaits])
    return figure


def _draw_share(axes: Axes, data: Columns) -> None:
    axes.fill_between(
        data["friction"],
        data["attracted_share_low"],
        data["attracted_share_high"],
        color="#9bd3c4",
        label="95 % confidence interval",
    )
    axes.plot(
        data["friction"],
        data["attracted_share"],
        color=style.SECOND_CURVE,
        label=f"{data['samples'][0]:,} random starts around the apex",
    )
    axes.set_ylim(0.0, 1.0)
    axes.set_title("(a) share of starts that settle on the gait", pad=18)


def _draw_disturbances(axes: Axes, data: Columns) -> None:
    for name, (label, colour) in DISTURBANCES.items():
        axes.plot(
            data["friction"], np.minimum(data[name], FARTHEST), "o-", markersize=3, color=colour, label=label
        )
    axes.axhline(FARTHEST, **style.LIMIT_LINE)
    along = np.array([(friction, FARTHEST) for friction in data["friction"] if friction > 1.0])
    CurveLabel(axes, "largest tried", along, fontsize=8.5)
    axes.set_ylim(0.0, 1.15 * FARTHEST)
    axes.set_title("(c) largest disturbance at the apex from which the runner recovers")
    axes.legend(loc="center right")
