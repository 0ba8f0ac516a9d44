"""Two measures of a gait's stability against friction: largest eigenvalue and region of attraction."""

from collections.abc import Mapping

import numpy as np
import pandas
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...analysis.attraction import FARTHEST
from ...feedback.judgement import judge_all
from ...pictures import style
from ...pictures.style import CurveLabel
from .data import Column, Results, table_by, table_of
from .over_friction import CONTROL, friction_axis, mark_words

MEASURED, MEASURED_EQUAL = 26, 12
"""Numbers of gaits whose region of attraction is measured: those of the runner, and matched ones."""
PUSHES_AND_STEPS = ("push_forward", "push_backward", "step_down", "step_up")
"""Kinds of disturbances."""
DISTURBANCES = {
    "step_down": ("step down (l₀)", "#1f5fa8"),
    "push_forward": ("push forward (l₀√(k/m))", "#e07b00"),
}
"""Labels and colours of the disturbances that are drawn."""


JUDGED: Mapping[str, Column] = {
    "samples": "volume.samples",
    "attracted_share": "volume.share",
    "attracted_share_low": lambda row: row.volume.interval[0],
    "attracted_share_high": lambda row: row.volume.interval[1],
    **{name: f"robustness.{name}" for name in PUSHES_AND_STEPS},
}
"""Columns of a judgement: share of starts that settle, with its interval, and the largest disturbances."""


def table(results: Results) -> pandas.DataFrame:
    """Data of the figure; inf is a disturbance beyond the largest tried. Takes minutes."""
    found, equal = results.gaits, results.equal
    chosen = [(0, found[i]) for i in np.linspace(0, len(found) - 1, MEASURED).round().astype(int)]
    chosen += [(1, gait) for gait in equal[:: len(equal) // MEASURED_EQUAL]]
    judged = judge_all([(gait, None) for _, gait in chosen], progress=True)
    gaits = table_by(["matched"], chosen, "friction", "word", "lambda_max")
    return gaits.join(table_of(judged, **JUDGED))


def draw(results: Results) -> Figure:
    """Draw the share of starts that settle, the largest eigenvalue, and the largest disturbances."""
    both = results.table("attraction")
    data, equal = both[both["matched"] == 0], both[both["matched"] == 1]
    figure, axes = style.subplots(3, 1, figsize=(7.6, 7.6), sharex=True)
    _draw_share(axes[0], data)
    axes[0].plot(equal["friction"], equal["attracted_share"], **CONTROL)
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
    axes[1].plot(equal["friction"], equal["lambda_max"], **CONTROL)
    along = table_of(results.gaits, "friction", "lambda_max")
    axes[1].plot(along["friction"], along["lambda_max"], color=style.CURVE)
    axes[1].set_title(r"(b) largest eigenvalue $\lambda_{max}$")
    _draw_disturbances(axes[2], data)
    for name, (_, colour) in DISTURBANCES.items():
        axes[2].plot(equal["friction"], equal[name].clip(upper=FARTHEST), "--", linewidth=1.0, color=colour)
    mark_words(axes, results.sweep)
    friction_axis(axes[-1], along["friction"])
    return figure


def _draw_share(axes: Axes, data: pandas.DataFrame) -> None:
    ends = data["attracted_share_low"], data["attracted_share_high"]
    axes.fill_between(data["friction"], *ends, color="#9bd3c4", label="95 % confidence interval")
    label = f"{data['samples'].iloc[0]:,} random starts around the apex"
    axes.plot(data["friction"], data["attracted_share"], color=style.SECOND_CURVE, label=label)
    axes.set_ylim(0.0, 1.0)
    axes.set_title("(a) share of starts that settle on the gait", pad=18)


def _draw_disturbances(axes: Axes, data: pandas.DataFrame) -> None:
    for name, (label, colour) in DISTURBANCES.items():
        sizes = data[name].clip(upper=FARTHEST)
        axes.plot(data["friction"], sizes, "o-", markersize=3, color=colour, label=label)
    axes.axhline(FARTHEST, **style.LIMIT_LINE)
    along = np.array([(friction, FARTHEST) for friction in data["friction"] if friction > 1.0])
    CurveLabel(axes, "largest tried", along, fontsize=8.5)
    axes.set_ylim(0.0, 1.15 * FARTHEST)
    axes.set_title("(c) largest disturbance at the apex from which the runner recovers")
    axes.legend(loc="center right")
