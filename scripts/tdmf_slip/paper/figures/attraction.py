"""Two measures of a gait's stability against friction: largest eigenvalue and region of attraction."""

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

import numpy as np
import pandas
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...analysis.attraction import FARTHEST, attraction_volume, robustness
from ...analysis.sweeps import gaits_in
from ...blocks import in_order
from ...library.gait import Gait
from ...library.laws import AffineLaw
from ...pictures import style
from ...pictures.style import CurveLabel
from ...terminal.in_blocks import in_blocks
from ...variables.table import FRICTION
from ..along import gait_table
from ..statements.regions import SAMPLES
from .data import Results
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


def table(results: Results) -> pandas.DataFrame:
    """Data of the figure; inf is a disturbance beyond the largest tried. Takes minutes."""
    found, equal = gaits_in(results.sweep.gaits), gaits_in(results.equal)
    own = [found[i] for i in np.linspace(0, len(found) - 1, MEASURED).round().astype(int)]
    gaits = [*own, *equal[:: len(equal) // MEASURED_EQUAL]]
    data = gait_table(gaits, FRICTION)[["friction", "word", "lambda_max"]]
    data = data.join(judged([(gait, None) for gait in gaits]))
    data.insert(0, "matched", np.arange(len(gaits)) >= len(own))
    return data


def judged(trials: Sequence[tuple[Gait, AffineLaw | None]], seed: int = 0) -> pandas.DataFrame:
    """Share of starts that settle on each gait under its law, without noise, and the largest disturbances."""
    with in_blocks(partial(_judged, seed), trials, "attraction", "gaits", progress=True) as results:
        return pandas.DataFrame(in_order(results))


def _judged(seed: int, trial: tuple[Gait, AffineLaw | None]) -> dict[str, float]:
    gait, law = trial
    quiet = law and replace(law, noise=None)
    volume, reach = attraction_volume(gait, SAMPLES, seed=seed, law=quiet), robustness(gait, law=quiet)
    low, high = volume.interval
    return {
        "samples": volume.samples,
        "attracted_share": volume.share,
        "attracted_share_low": low,
        "attracted_share_high": high,
        **{name: getattr(reach, name) for name in PUSHES_AND_STEPS},
    }


def draw(results: Results) -> Figure:
    """Draw the share of starts that settle, the largest eigenvalue, and the largest disturbances."""
    both = results.table("attraction")
    data, equal = both[~both["matched"]], both[both["matched"]]
    figure, axes = style.subplots(3, 1, figsize=(7.6, 7.6), sharex=True)
    _draw_share(axes[0], data)
    axes[0].plot(equal["friction"], equal["attracted_share"], **CONTROL)
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
    axes[1].plot(equal["friction"], equal["lambda_max"], **CONTROL)
    axes[1].plot(results.gaits["friction"], results.gaits["lambda_max"], color=style.CURVE)
    axes[1].set_title(r"(b) largest eigenvalue $\lambda_{max}$")
    _draw_disturbances(axes[2], data)
    for name, (_, colour) in DISTURBANCES.items():
        axes[2].plot(equal["friction"], equal[name].clip(upper=FARTHEST), "--", linewidth=1.0, color=colour)
    mark_words(axes, results.sweep)
    friction_axis(axes[-1], results.gaits["friction"])
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
