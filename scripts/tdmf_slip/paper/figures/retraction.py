"""The two largest eigenvalues against the rate of swing-leg retraction, at three frictions."""

from collections.abc import Mapping

import numpy as np
from matplotlib.figure import Figure

from ...analysis.branches import Branch, continue_branch
from ...analysis.search import periodic_gait
from ...library.gait import Gait
from ...library.runner import Runner
from ...pictures import style
from ...variables.table import FRICTION
from ..matched import changed, like
from . import leading
from .columns import Data, attributes

RATE = "hip.retraction_rate"
FRICTIONS = (0.2, 0.6, 10.0)
SHOWN = (-0.0085, 0.035)
"""Range of rates on the axis, √(k/m)."""
EIGENVALUES = (-1.7, 1.7)
LARGEST_STEP = 0.025
RATES = np.linspace(0.0, 0.034, 18)[1:]
"""Retraction rates of matched runners."""
POINTS = 320
"""Maximum number of gaits of a branch, which continues far beyond its fold."""


def branches(runner: Runner) -> Mapping[float, tuple[Branch, Branch]]:
    """Branches from zero retraction to negative and to positive rates, by friction."""
    found = {}
    for friction in FRICTIONS:
        its = runner.replace({FRICTION: friction})
        first = periodic_gait(its)
        spans = [{RATE: (first.runner[RATE], end)} for end in (2.0 * SHOWN[0], SHOWN[1])]
        back, forth = (
            continue_branch.plain(first, span, max_step=LARGEST_STEP, max_points=POINTS, switch=False)
            for span in spans
        )
        found[friction] = back, forth
    return found


def matched(runner: Runner) -> Mapping[float, tuple[Gait, ...]]:
    """Gaits with retraction that are matched to the one without, by friction."""
    found = {}
    for friction in FRICTIONS:
        reference = one = periodic_gait(runner.replace({FRICTION: friction}))
        alike = []
        for rate in RATES:
            near = changed(one, {RATE: rate}, 2)
            one = (near and like(reference, near)) or one
            if one.runner[RATE] == rate:
                alike.append(one)
        found[friction] = tuple(alike)
    return found


def table(found: Mapping[float, tuple[Branch, Branch]], alike: Mapping[float, tuple[Gait, ...]]) -> Data:
    """Data of the figure by column: each branch from its fold to its largest rate, then matched runners."""
    rows = [
        (friction, value, gait)
        for friction, (back, forth) in found.items()
        for value, gait in [
            *reversed(list(zip(back.values, back.gaits, strict=True))[1:]),
            *zip(forth.values, forth.gaits, strict=True),
        ]
    ]
    along = len(rows)
    rows += [(friction, one.runner[RATE], one) for friction, its in alike.items() for one in its]
    gaits = [gait for _, _, gait in rows]
    return {
        "friction": [friction for friction, _, _ in rows],
        "retraction_rate": [value for _, value, _ in rows],
        "matched": [row >= along for row in range(len(rows))],
        **attributes(gaits, "word", "stable"),
        **leading.as_columns(gaits),
        **attributes(gaits, "speed", "cost_of_transport"),
    }


def draw(found: Mapping[float, tuple[Branch, Branch]], alike: Mapping[float, tuple[Gait, ...]]) -> Figure:
    """Draw a panel for each friction, with crosses for matched runners."""
    figure, panels = style.subplots(len(found), 1, figsize=(7.6, 7.6), sharex=True, sharey=True)
    for axes, letter, (friction, pair) in zip(panels, "abc", found.items(), strict=True):
        for number, branch in enumerate(pair):
            named = axes is panels[0] and number == 1
            leading.draw(axes, branch.values, branch.gaits, named=named)
            leading.mark(axes, branch, named=named)
        rates = [one.runner[RATE] for one in alike[friction]]
        for heights, colour in zip(leading.leading(alike[friction]).T, leading.COLOURS, strict=True):
            axes.plot(rates, heights, "x", color=colour, markersize=4.5)
        if axes is panels[0]:
            style.name_unstable(axes)
            axes.plot(
                [], [], "x", color=style.FAINT, markersize=4.5, label="speed, apex height and leg angle held"
            )
        axes.axvline(0.0, **style.STANCE_LINE)
        axes.set_title(f"({letter}) two largest eigenvalues at friction {friction:g}")
    panels[0].set_xlim(*SHOWN)
    panels[0].set_ylim(*EIGENVALUES)
    panels[0].legend(loc="center right")
    panels[-1].set_xlabel("retraction rate ω (√(k/m))")
    return figure
