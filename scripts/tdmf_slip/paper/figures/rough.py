"""Strides until the fall on rough ground, against friction.

The control are runners matched to the gait on one friction.
"""

from collections.abc import Sequence

import numpy as np
import pandas
from matplotlib.figure import Figure

from ...analysis.first_passage import FirstPassage, strides_to_fall
from ...analysis.sweeps import gaits_in
from ...blocks import in_order
from ...library.gait import Gait
from ...library.laws import AffineLaw
from ...pictures import style
from ...terminal.in_blocks import in_blocks
from ..matched import match_gaits
from .data import Results, table_of
from .over_friction import draw_means, friction_axis

FRICTIONS = (0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.36, 0.43, 0.5, 0.6, 0.8, 1.2, 2.5, 5.0, 10.0)
ROUGHNESS = (0.2, 0.3, 0.4, 0.5)
"""Standard deviations of the steps, l0."""
RUNNERS, MAX_STRIDES, SEED = 256, 400, 20261122
COLOURS = ("#0b7a75", "#1f5fa8", "#b3216f", "#e07b00")
REFERENCE, MATCHED_ROUGHNESS = 0.2, 0.3
"""Friction of the gait to which runners are matched, and roughness of their ground."""


def table(results: Results) -> pandas.DataFrame:
    """Mean strides until the fall; inf if no runner fell. Takes minutes."""
    own = [results.gait(friction) for friction in FRICTIONS]
    matched = gaits_in(match_gaits([results.gait(REFERENCE), *own]))
    trials = [(gait, None, roughness) for roughness in ROUGHNESS for gait in own]
    trials += [(gait, None, MATCHED_ROUGHNESS) for gait in matched if gait.stable]
    data = passages(trials)
    data.insert(0, "matched", np.arange(len(trials)) >= len(ROUGHNESS) * len(own))
    data.insert(2, "friction", [gait.friction for gait, *_ in trials])
    return data


def passages(trials: Sequence[tuple[Gait, AffineLaw | None, float]]) -> pandas.DataFrame:
    """Falls and mean number of strides until the fall of runners on gaits, under laws, on rough ground."""
    with in_blocks(_passage, trials, "rough", "means", progress=True) as results:
        return table_of(
            in_order(results),
            *("roughness", "word", "runners", "falls", "strides", "stopped", "unsolved", "mean_strides"),
            mean_strides_low=lambda one: one.interval[0],
            mean_strides_high=lambda one: one.interval[1],
        )


def _passage(trial: tuple[Gait, AffineLaw | None, float]) -> FirstPassage:
    gait, law, roughness = trial
    return strides_to_fall(gait.runner, roughness, RUNNERS, SEED, MAX_STRIDES, gait=gait, law=law)


def draw(results: Results) -> Figure:
    """Draw the mean number of strides against friction, a curve for each roughness."""
    figure, axes = style.subplots(figsize=(7.6, 4.8))
    colours = dict(zip(ROUGHNESS, COLOURS, strict=True))
    for (matched, roughness), its in results.table("rough").groupby(["matched", "roughness"]):
        label, marks = f"{roughness:g}{', matched' * bool(matched)}", "s--" if matched else "o-"
        draw_means(axes, its, "mean_strides", colours[roughness], marks, label=label, clip_on=False)
    axes.set_yscale("log")
    axes.set_ylabel("mean number of strides until the fall")
    friction_axis(axes, FRICTIONS)
    axes.plot([], [], "^", color=style.FAINT, markersize=5, label="no runner fell: lower bound")
    axes.legend(title="size of the steps (l₀)", loc="upper right")
    axes.set_title(
        "matched: every runner with the speed, apex height and leg angle of the gait at friction 0.2",
        fontsize="small",
    )
    return figure
