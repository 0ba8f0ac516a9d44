"""The two largest eigenvalues against the rate of swing-leg retraction, at three frictions."""

from collections.abc import Mapping
from contextlib import suppress
from typing import Any

import numpy as np
import pandas
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...analysis.special_points import FOLD, PERIOD_DOUBLING
from ...errors import RunError
from ...library.gait import Gait
from ...pictures import style
from ..along import Row, followed
from ..matched import gait_with, match_gait
from .data import LEADING, Results, table_by

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
CURVES: Mapping[str, tuple[str, str]] = {
    "greater_eigenvalue": (style.CURVE, "largest eigenvalue, of speed"),
    "other_eigenvalue": (style.SECOND_CURVE, "second eigenvalue, of height"),
}
"""Colour and name of each curve by column."""
MARKS: Mapping[str, tuple[str, float]] = {FOLD: ("o", 1.0), PERIOD_DOUBLING: ("s", -1.0)}
"""Marker of each kind of special point, and the eigenvalue there."""


def along(first: Gait) -> list[Row]:
    """Gaits and special points of the branch from its fold to the largest rate."""
    back, forth = (
        followed(first, RATE, first.runner[RATE], end, max_step=LARGEST_STEP, max_points=POINTS)
        for end in (2.0 * SHOWN[0], SHOWN[1])
    )
    return [*back[:0:-1], *forth]


def matched(reference: Gait) -> list[Row]:
    """Gaits with retraction that are matched to the one without."""
    one, found = reference, []
    for rate in RATES:
        with suppress(RunError):
            one = match_gait(reference, gait_with(one, RATE, rate, 2))
            found.append(Row(rate, "", one))
    return found


def table(results: Results) -> pandas.DataFrame:
    """Each branch from its fold to its largest rate, then matched runners; special points have a `kind`."""
    rows = [
        (friction, is_matched, *point)
        for is_matched, find in ((False, along), (True, matched))
        for friction in FRICTIONS
        for point in find(results.gait(friction))
    ]
    names = ["friction", "matched", "retraction_rate", "kind"]
    return table_by(names, rows, "word", "stable", "speed", "cost_of_transport", **LEADING)


def draw(results: Results) -> Figure:
    """Draw a panel for each friction, with crosses for matched runners."""
    data = results.table("retraction")
    figure, panels = style.subplots(len(FRICTIONS), 1, figsize=(7.6, 7.6), sharex=True, sharey=True)
    for axes, letter, friction in zip(panels, "abc", FRICTIONS, strict=True):
        its = data[data["friction"] == friction]
        _draw(axes, its[~its["matched"]], its[its["matched"]])
        axes.set_title(f"({letter}) two largest eigenvalues at friction {friction:g}")
    style.name_unstable(panels[0])
    held = "speed, apex height and leg angle held"
    panels[0].plot([], [], "x", color=style.FAINT, markersize=4.5, label=held)
    panels[0].set_xlim(*SHOWN)
    panels[0].set_ylim(*EIGENVALUES)
    panels[0].legend(loc="center right")
    panels[-1].set_xlabel("retraction rate ω (√(k/m))")
    return figure


def _draw(axes: Axes, own: pandas.DataFrame, alike: pandas.DataFrame) -> None:
    """Draw both eigenvalues, solid for stable gaits, with special points and the borders of stability."""
    gaits = own[own["kind"] == ""]
    for name, (colour, label) in CURVES.items():
        style.stable_curve(axes, gaits["retraction_rate"], gaits[name], gaits["stable"], colour, label=label)
        axes.plot(alike["retraction_rate"], alike[name], "x", color=colour, markersize=4.5)
    for kind, (marker, height) in MARKS.items():
        rates = own["retraction_rate"][own["kind"] == kind]
        look: dict[str, Any] = {"color": style.MODE_COLOURS["slip_negative"], "markersize": 5, "zorder": 4}
        axes.plot(rates, np.full(len(rates), height), marker, label=kind, **look)
    for border in (-1.0, 1.0):
        axes.axhline(border, **style.LIMIT_LINE)
    axes.axvline(0.0, **style.STANCE_LINE)
