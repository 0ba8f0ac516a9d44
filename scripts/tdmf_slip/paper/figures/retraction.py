"""The two largest eigenvalues against the rate of swing-leg retraction, at three frictions."""

from collections.abc import Mapping
from contextlib import suppress
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...analysis.branches import continue_branch
from ...analysis.special_points import FOLD, PERIOD_DOUBLING
from ...errors import RunError
from ...library.gait import Gait
from ...pictures import style
from ...variables.table import FRICTION
from ..along import gait_table
from ..matched import gait_with, match_gait
from ..statements.claim import RATE
from .data import Results

if TYPE_CHECKING:
    import xarray

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
COLUMNS = (
    *("friction", "matched", "retraction_rate", "special", "word", "stable", "speed", "cost_of_transport"),
    *CURVES,
)
"""Columns of the data."""
MARKS: Mapping[str, tuple[str, float]] = {FOLD: ("o", 1.0), PERIOD_DOUBLING: ("s", -1.0)}
"""Marker of each kind of special point, and the eigenvalue there."""


def along(first: Gait) -> "xarray.Dataset":
    """The branch from its fold to the largest rate."""
    range_of_rates = 2.0 * SHOWN[0], SHOWN[1]
    return continue_branch(
        first, {RATE: range_of_rates}, max_step=LARGEST_STEP, max_points=POINTS, switch=False
    )


def matched(reference: Gait) -> list[Gait]:
    """Gaits with retraction that are matched to the one without."""
    one, found = reference, list[Gait]()
    for rate in RATES:
        with suppress(RunError):
            one = match_gait(reference, gait_with(one, RATE, rate))
            found.append(one)
    return found


def table(results: Results) -> pandas.DataFrame:
    """Each branch from its fold to its largest rate, then matched runners, with their special points."""
    tables = [
        gait_table(find(results.gait(friction)), FRICTION, RATE).assign(matched=find is matched)
        for find in (along, matched)
        for friction in FRICTIONS
    ]
    return pandas.concat(tables, ignore_index=True).fillna({"special": ""})[[*COLUMNS]]


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
    gaits = own[own["special"] == ""]
    for name, (colour, label) in CURVES.items():
        style.stable_curve(axes, gaits["retraction_rate"], gaits[name], gaits["stable"], colour, label=label)
        axes.plot(alike["retraction_rate"], alike[name], "x", color=colour, markersize=4.5)
    for kind, (marker, height) in MARKS.items():
        rates = own["retraction_rate"][own["special"] == kind]
        look: dict[str, Any] = {"color": style.MODE_COLOURS["slip_negative"], "markersize": 5, "zorder": 4}
        axes.plot(rates, np.full(len(rates), height), marker, label=kind, **look)
    for border in (-1.0, 1.0):
        axes.axhline(border, **style.LIMIT_LINE)
    axes.axvline(0.0, **style.STANCE_LINE)
