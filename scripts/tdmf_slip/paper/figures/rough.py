"""Strides until the fall on rough ground, against friction.

The control are runners matched to the gait on one friction.
"""

import pandas
from matplotlib.figure import Figure

from ...analysis.first_passage import FirstPassage, strides_to_fall
from ...blocks import in_order
from ...library.runner import Runner
from ...pictures import style
from ...terminal.in_blocks import in_blocks
from ...variables.table import FRICTION
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
    runners = [results.runner.replace({FRICTION: friction}) for friction in FRICTIONS]
    trials = [(runner, roughness) for roughness in ROUGHNESS for runner in runners]
    own = len(trials)
    matched = match_gaits([results.runner.replace({FRICTION: REFERENCE}), *runners])
    trials += [(gait.runner, MATCHED_ROUGHNESS) for gait in matched if gait.stable]
    with in_blocks(_passage, trials, "rough", "means", progress=True) as passages:
        found = in_order(passages)
    data = means(found, "mean_strides", "roughness", "word", "runners", *COUNTED)
    data.insert(0, "matched", [number >= own for number in range(len(trials))])
    data.insert(2, "friction", [runner[FRICTION] for runner, _ in trials])
    return data


COUNTED = ("falls", "strides", "stopped", "unsolved")
"""Counts of runners on rough ground."""


def means(found: list[FirstPassage], name: str, *attributes: str) -> pandas.DataFrame:
    """Attributes of first passages, and their mean number of strides with its interval."""
    ends = {f"{name}_low": lambda one: one.interval[0], f"{name}_high": lambda one: one.interval[1]}
    return table_of(found, *attributes, **{name: "mean_strides"}, **ends)


def _passage(trial: tuple[Runner, float]) -> FirstPassage:
    return strides_to_fall(*trial, RUNNERS, SEED, MAX_STRIDES)


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
