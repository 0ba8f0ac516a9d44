"""Effect of feedback from stride to stride at several frictions."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pandas
from matplotlib.figure import Figure

from ...analysis.attraction import FARTHEST
from ...analysis.sweeps import gaits_in
from ...feedback.gains import Feedback
from ...library.gait import Gait
from ...pictures import style
from ...pictures.style import CurveLabel
from ..matched import match_gaits
from ..statements.claim import ANGLE
from ..statements.regions import dead_beat_law, regulator
from ..statements.rough_ground import NOISE
from .attraction import judged
from .data import Results, table_of
from .over_friction import draw_means, friction_axis
from .rough import SEED, passages

FRICTIONS = (0.1, 0.2, 0.6, 1.0, 10.0)
ROUGHNESS = (0.3, 0.5)
"""Standard deviations of the steps, l0."""
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
BESIDE, MARGIN = 1.06, 1.2
"""Ratios of frictions: between the positions of two laws, and between the ends of the axis and the data."""
MAX_SHOWN = 5e4
"""Largest mean number of strides on the axis; some intervals extend beyond it."""


def laws(gait: Gait) -> dict[str, Feedback]:
    """Feedback laws for a gait by name."""
    return {
        "quadratic regulator: touchdown angle": regulator(gait, (ANGLE,)),
        "quadratic regulator: angle and torque": regulator(gait),
        "dead-beat: angle and torque": dead_beat_law(gait),
    }


def table(results: Results) -> pandas.DataFrame:
    """Data of the figure; inf is a disturbance beyond all tried, or a mean without falls. Takes minutes."""
    gaits = [results.gait(friction) for friction in FRICTIONS]
    noise = (NOISE * results.runner.scales).tolist()
    trials: list[tuple[str, Gait, Feedback | None]] = [(NONE, gait, None) for gait in gaits]
    trials += [(MATCHED, gait, None) for gait in gaits_in(match_gaits([results.gait(REFERENCE), *gaits]))]
    designed = [(name, gait, law) for gait in gaits for name, law in laws(gait).items()]
    designed.sort(key=lambda one: list(COLOURS).index(one[0]))
    trials += [(name, gait, replace(law, noise=noise, seed=SEED)) for name, gait, law in designed]
    data = table_of(
        trials,
        law=lambda trial: trial[0],
        friction=lambda trial: trial[1].friction,
        word=lambda trial: trial[1].word,
        lambda_max=lambda trial: (trial[2] or trial[1]).lambda_max,
    )
    tried = [(gait, law) for _, gait, law in trials]
    grounds = [
        passages([(gait, law, roughness) for gait, law in tried])
        .drop(columns=["roughness", "word"])
        .add_suffix(f"_{roughness:g}")
        for roughness in ROUGHNESS
    ]
    return data.join([judged(tried, SEED), *grounds])


def draw(results: Results) -> Figure:
    """Draw strides until the fall, share of starts that settle, and largest disturbances, by law."""
    data = results.table("feedback")
    figure, panels = style.subplots(2, 2, figsize=(8.4, 6.6), sharex=True)
    (strides, share), (step, push) = panels
    for number, (name, colour) in enumerate(SHOWN.items()):
        its = data[data["law"] == name].copy()
        its["friction"] *= BESIDE ** (number - 0.5 * (len(SHOWN) - 1))
        low_steps = its.rename(columns=lambda column: column.removesuffix("_0.3"))
        draw_means(strides, low_steps, "mean_strides", colour, label=name)
        for axes, disturbance in ((step, "step_up"), (push, "push_forward")):
            reach = its[disturbance].clip(upper=FARTHEST)
            axes.plot(its["friction"], reach, "o-", color=colour, markersize=4, linewidth=1.0)
        draw_means(share, its, "attracted_share", colour)
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
        friction_axis(axes, FRICTIONS)
    push.set_xlim(FRICTIONS[0] / MARGIN, FRICTIONS[-1] * MARGIN)
    figure.legend(*strides.get_legend_handles_labels(), loc="outside lower center", ncols=2)
    return figure
