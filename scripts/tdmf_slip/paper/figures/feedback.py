"""Effect of feedback from stride to stride at several frictions."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...analysis.attraction import FARTHEST
from ...analysis.search import periodic_gait
from ...feedback.gains import Feedback, dead_beat, lqr
from ...feedback.judgement import RUNNERS, Judgement, judge_all
from ...library.gait import Gait
from ...library.runner import Runner
from ...pictures import style
from ...pictures.style import CurveLabel
from ...variables.table import FRICTION
from ..matched import like
from . import figure_9
from .columns import Columns, Data, attributes, select

FRICTIONS = (0.1, 0.2, 0.6, 1.0, 10.0)
ANGLE, TORQUE = "hip.touchdown_angle", "hip.stance_torque"
REACH = {ANGLE: 0.1, TORQUE: 0.1}
"""Largest change of each setting to either side, rad and k l0^2."""
NOISE = 0.01
"""Standard deviation of the sensor noise, relative to the scales of the section."""
ROUGHNESS = (0.3, 0.5)
"""Standard deviations of the steps, l0."""
SEED = 20261122
LEFT_ALONE = 0.05
"""Modulus of eigenvalues that dead-beat laws leave alone."""

NONE, MATCHED = "no feedback", "no feedback, gait matched to friction 0.2"
REFERENCE = 0.2
"""Friction of the gait to which runners are matched."""
COLOURS: Mapping[str, str] = {
    NONE: "#22303c",
    MATCHED: "#b3216f",
    "quadratic regulator: touchdown angle": "#1f5fa8",
    "quadratic regulator: angle and torque": "#0b7a75",
    "dead-beat: angle and torque": "#e07b00",
}
SHOWN = {name: colour for name, colour in COLOURS.items() if name != "quadratic regulator: touchdown angle"}
"""Laws that are drawn; the touchdown angle alone has about the effect of angle and torque."""
DISTURBANCES = ("push_forward", "push_backward", "step_down", "step_up")
BESIDE, MARGIN = 1.06, 1.2
"""Ratios of frictions: between the positions of two laws, and between the ends of the axis and the data."""
MAX_SHOWN = 5e4
"""Largest mean number of strides on the axis; some intervals extend beyond it."""
COUNTED = ("falls", "strides", "stopped", "unsolved")
"""Counts of runners on rough ground."""


def laws(gait: Gait) -> dict[str, Feedback | None]:
    """Feedback laws for a gait by name; None is no feedback."""
    reach = {name: (gait.runner[name] - REACH[name], gait.runner[name] + REACH[name]) for name in REACH}
    alone, both = (ANGLE,), (ANGLE, TORQUE)
    made = (
        None,
        None,
        lqr(gait, alone, limits={ANGLE: reach[ANGLE]}),
        lqr(gait, both, limits=reach),
        dead_beat(gait, both, limits=reach, negligible=LEFT_ALONE),
    )
    return dict(zip(COLOURS, made, strict=True))


def measure(runner: Runner) -> Data:
    """Data of the figure by column; inf is a disturbance beyond all tried, or a mean without falls."""
    gaits = [periodic_gait(runner.replace({FRICTION: friction})) for friction in FRICTIONS]
    noise = (NOISE * runner.scales).tolist()
    alike = matched(runner, gaits)
    trials: dict[str, list[tuple[Gait, Feedback | None]]] = {name: [] for name in COLOURS}
    for gait in gaits:
        for name, law in laws(gait).items():
            noisy = None if law is None else replace(law, noise=noise, seed=SEED)
            one = alike.get(gait.friction) if name == MATCHED else gait
            if one is not None:
                trials[name].append((one, noisy))
    named = [name for name, its in trials.items() for _ in its]
    every = [trial for its in trials.values() for trial in its]
    found = judge_all(every, roughness=ROUGHNESS, seed=SEED, progress=True)
    data: dict[str, list[Any]] = {
        "law": named,
        "friction": [one.gait.friction for one in found],
        "word": [one.gait.word for one in found],
        "lambda_max": [_lambda_max(one) for one in found],
        "samples": [one.volume.samples for one in found],
        "attracted_share": [one.volume.share for one in found],
        "attracted_share_low": [one.volume.interval[0] for one in found],
        "attracted_share_high": [one.volume.interval[1] for one in found],
        **attributes([one.robustness for one in found], *DISTURBANCES),
        "runners": [RUNNERS for _ in found],
    }
    for number, roughness in enumerate(ROUGHNESS):
        passages = [one.first_passages[number] for one in found]
        counted = attributes(passages, *COUNTED)
        data |= {f"{name}_{roughness:g}": values for name, values in counted.items()}
        mean = f"mean_strides_{roughness:g}"
        data[mean] = [one.mean_strides for one in passages]
        data[f"{mean}_low"] = [one.interval[0] for one in passages]
        data[f"{mean}_high"] = [one.interval[1] for one in passages]
    return data


def matched(runner: Runner, gaits: Sequence[Gait]) -> dict[float, Gait]:
    """Gaits matched to the one on `REFERENCE`, by friction."""
    reference = periodic_gait(runner.replace({FRICTION: REFERENCE}))
    found = {gait.friction: like(reference, gait) for gait in gaits}
    return {friction: gait for friction, gait in found.items() if gait is not None}


def _lambda_max(one: Judgement) -> float:
    return one.law.lambda_max if isinstance(one.law, Feedback) else one.gait.lambda_max


def draw(data: Columns) -> Figure:
    """Draw strides until the fall, share of starts that settle, and largest disturbances, by law."""
    figure, panels = style.subplots(2, 2, figsize=(8.4, 6.6), sharex=True)
    (strides, share), (step, push) = panels
    for number, (name, colour) in enumerate(SHOWN.items()):
        its = select(data, law=name)
        its["friction"] = its["friction"] * BESIDE ** (number - 0.5 * (len(SHOWN) - 1))
        _with_confidence(strides, its, "mean_strides_0.3", colour, name)
        for axes, disturbance in ((step, "step_up"), (push, "push_forward")):
            reach = np.minimum(its[disturbance], FARTHEST)
            axes.plot(its["friction"], reach, "o-", color=colour, markersize=4, linewidth=1.0)
        _with_confidence(share, its, "attracted_share", colour, name)
    strides.set_title("(a) mean strides until the fall on steps of 0.3 l₀")
    strides.set_yscale("log")
    strides.set_ylim(top=MAX_SHOWN)
    step.set_title("(c) largest step up survived (l₀)")
    push.set_title("(d) largest push forward survived (l₀√(k/m))")
    push.axhline(FARTHEST, **style.LIMIT_LINE)
    share.set_title("(b) share of starts that settle on the gait")
    for axes in (step, push, share):
        axes.set_ylim(bottom=0.0)
    push.set_ylim(top=1.2 * FARTHEST)
    along = np.column_stack([np.geomspace(1.0, FRICTIONS[-1], 21), np.full(21, FARTHEST)])
    CurveLabel(push, "largest tried", along, fontsize=8.5)
    for axes in (step, push):
        figure_9.friction_axis(axes, FRICTIONS)
    push.set_xlim(FRICTIONS[0] / MARGIN, FRICTIONS[-1] * MARGIN)
    figure.legend(*strides.get_legend_handles_labels(), loc="outside lower center", ncols=2)
    return figure


def _with_confidence(axes: Axes, its: Columns, name: str, colour: str, label: str) -> None:
    """Draw means with their intervals, and a triangle at the lower end if no runner fell."""
    friction, mean, low, high = (its[key] for key in ("friction", name, f"{name}_low", f"{name}_high"))
    known = np.isfinite(mean)
    shown = np.where(known, mean, np.nan)
    axes.errorbar(
        friction, shown, [shown - low, high - shown], capsize=2, linewidth=0, elinewidth=1.2, color=colour
    )
    axes.plot(friction, shown, "o-", color=colour, markersize=4, linewidth=1.0, label=label)
    axes.plot(friction[~known], low[~known], "^", color=colour, markersize=5)
