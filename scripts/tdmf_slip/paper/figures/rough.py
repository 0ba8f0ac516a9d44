"""Strides until the fall on rough ground, against friction.

The control are runners matched to the gait on one friction.
"""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...analysis.first_passage import FirstPassage, strides_to_fall
from ...blocks import in_order, run_blocks
from ...library.runner import Runner
from ...pictures import style
from ...terminal.progress import progress_bar
from ...variables.table import FRICTION
from ..matched import at_frictions
from . import figure_9
from .columns import Columns, Data, attributes, select

FRICTIONS = (0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.36, 0.43, 0.5, 0.6, 0.8, 1.2, 2.5, 5.0, 10.0)
ROUGHNESS = (0.2, 0.3, 0.4, 0.5)
"""Standard deviations of the steps, l0."""
RUNNERS, MAX_STRIDES, SEED = 256, 400, 20261122
COLOURS = ("#0b7a75", "#1f5fa8", "#b3216f", "#e07b00")
DRAWN = ("friction", "mean_strides", "mean_strides_low", "mean_strides_high")

REFERENCE, MATCHED_ROUGHNESS = 0.2, 0.3
"""Friction of the gait to which runners are matched, and roughness of their ground."""


def measure(runner: Runner) -> Data:
    """Data of the figure by column; if no runner fell, the mean and its upper bound are inf."""
    trials = [
        (runner.replace({FRICTION: friction}), roughness) for roughness in ROUGHNESS for friction in FRICTIONS
    ]
    as_they_come = len(trials)
    matched = at_frictions(runner, REFERENCE, FRICTIONS)
    trials += [(gait.runner, MATCHED_ROUGHNESS) for gait in matched if gait.stable]
    with progress_bar("rough", len(trials), "means", True) as bar, run_blocks(_passage, trials) as results:
        found = in_order(results, lambda _: bar.update())
    return {
        "matched": [float(number >= as_they_come) for number in range(len(trials))],
        **attributes(found, "roughness"),
        "friction": [one[FRICTION] for one, _ in trials],
        **attributes(found, "word", "runners", "falls", "strides", "stopped", "unsolved", "mean_strides"),
        "mean_strides_low": [one.interval[0] for one in found],
        "mean_strides_high": [one.interval[1] for one in found],
    }


def _passage(trial: tuple[Runner, float]) -> FirstPassage:
    return strides_to_fall(*trial, RUNNERS, SEED, MAX_STRIDES)


def draw(data: Columns) -> Figure:
    """Draw the mean number of strides against friction, a curve for each roughness."""
    figure, axes = style.subplots(figsize=(7.6, 4.8))
    for roughness, colour in zip(ROUGHNESS, COLOURS, strict=True):
        for matched in (False, True):
            drawn = select(data, roughness=roughness, matched=matched)
            if drawn["friction"].size:
                _curve(axes, drawn, colour, f"{roughness:g}{', matched' * matched}", matched)
    axes.set_yscale("log")
    axes.set_ylabel("mean number of strides until the fall")
    figure_9.friction_axis(axes, FRICTIONS)
    axes.plot([], [], "^", color=style.FAINT, markersize=5, label="no runner fell: lower bound")
    axes.legend(title="size of the steps (l₀)", loc="upper right")
    axes.set_title(
        "matched: every runner with the speed, apex height and leg angle of the gait at friction 0.2",
        fontsize="small",
    )
    return figure


def _curve(axes: Axes, data: Columns, colour: str, label: str, matched: bool) -> None:
    """Draw means with their intervals, and a triangle at the lower end if no runner fell."""
    friction, mean, low, high = (data[name] for name in DRAWN)
    fell, marks = np.isfinite(mean), "s--" if matched else "o-"
    shown = np.where(fell, mean, np.nan)
    axes.plot(friction, shown, marks, color=colour, markersize=3.5, label=label, clip_on=False)
    axes.fill_between(friction, low, high, where=fell, color=colour, alpha=0.18, linewidth=0)
    axes.vlines(friction[fell], low[fell], high[fell], color=colour, alpha=0.4, linewidth=1.0, clip_on=False)
    axes.plot(friction[~fell], low[~fell], "^", color=colour, markersize=5)
