"""Speed, cost of transport and eigenvalues against the slope of the ground."""

from collections.abc import Iterator, Mapping
from contextlib import suppress

import numpy as np
import pandas
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...analysis.branches import continue_branch
from ...analysis.sweeps import gaits_in
from ...errors import RunError
from ...library.gait import Gait
from ...pictures import style
from ...variables.table import FRICTION
from ..along import gait_table, up_to_turn
from ..matched import gait_with, match_gaits
from ..statements.claim import SLOPE
from .data import Results

COLOURS: Mapping[float, str] = {0.2: "#e07b00", 0.6: "#0b7a75", 10.0: "#22303c"}
"""Colour by friction."""
LOWEST, HIGHEST = np.radians(-5.0), np.radians(15.0)
LARGEST_STEP = 0.03
STEP = np.radians(0.25)
"""Step between slopes of matched runners."""
POINTS = 260
"""Maximum number of gaits of a branch uphill; gaits beyond the steepest slope are not drawn."""

HIGHEST_COST = 3.0
"""Largest cost on the axis; near its steepest slope the runner on friction 0.2 hardly advances."""

DRAWN = {"speed": 0, "cost_of_transport": 1, "greater_eigenvalue": 2, "other_eigenvalue": 2}
"""Panel of each column."""

COLUMNS = "friction", "matched", "slope_degrees", "word", "stable", *DRAWN
"""Columns of the data."""


def own(first: Gait) -> pandas.DataFrame:
    """Gaits from five degrees downhill to the steepest slope of their branch."""
    branch = up_to_turn(
        continue_branch(
            first, {SLOPE: (LOWEST, HIGHEST)}, max_step=LARGEST_STEP, max_points=POINTS, switch=False
        )
    )
    rows = gait_table(branch, FRICTION)
    return rows[(rows["special"] == "") | (rows.index == len(rows) - 1)]


def matched(first: Gait) -> pandas.DataFrame:
    """Gaits of a runner along the slope, each found from the one before."""
    down, up = ([*_stepped(first, step)] for step in (-STEP, STEP))
    return gait_table([*down[::-1], first, *up], FRICTION, SLOPE)


def _stepped(gait: Gait, step: float) -> Iterator[Gait]:
    """Yields gaits as far as there are any, each found from the one before."""
    slope = step
    with suppress(RunError):
        while LOWEST <= slope <= HIGHEST:
            gait = gait_with(gait, SLOPE, slope)
            yield gait
            slope += step


def table(results: Results) -> pandas.DataFrame:
    """Data of the figure, with runners matched to the one on the first friction last; takes minutes."""
    gaits = [results.gait(friction) for friction in COLOURS]
    tables = [own(gait).assign(matched=False) for gait in gaits]
    tables += [matched(gait).assign(matched=True) for gait in gaits_in(match_gaits(gaits))]
    found = pandas.concat(tables, ignore_index=True)
    return found.assign(slope_degrees=np.degrees(found["slope"]))[[*COLUMNS]]


def draw(results: Results) -> Figure:
    """Draw three panels, a colour for each friction; dashed where the gait is unstable."""
    data = results.table("slope")
    figure, panels = style.subplots(3, 1, figsize=(7.6, 8.4), sharex=True)
    for friction, colour in COLOURS.items():
        of_friction = data[data["friction"] == friction]
        its, alike = of_friction[~of_friction["matched"]], of_friction[of_friction["matched"]]
        for name, panel in DRAWN.items():
            panels[panel].plot(alike["slope_degrees"], alike[name], ":", color=colour, linewidth=1.4)
            label = f"friction {friction:g}" if name == "speed" else None
            _curve(panels[panel], its, name, colour, label)
    for border in (-1.0, 1.0):
        panels[2].axhline(border, **style.LIMIT_LINE)
    for axes in panels:
        axes.axvline(0.0, **style.STANCE_LINE)
    panels[0].set_title("(a) average speed (l₀√(k/m))")
    panels[1].set_title("(b) cost of transport")
    panels[2].set_title("(c) two largest eigenvalues")
    panels[1].set_ylim(0.0, HIGHEST_COST)
    panels[2].set_ylim(-2.5, 1.2)
    style.name_unstable(panels[0])
    panels[0].plot(
        [], [], ":", color=style.FAINT, label="matched on level ground to the gait at friction 0.2"
    )
    panels[0].legend(loc="lower left")
    panels[2].set_xlabel("slope of the ground (°); dots mark the steepest climb")
    return figure


def _curve(axes: Axes, data: pandas.DataFrame, name: str, colour: str, label: str | None) -> None:
    slopes, heights = data["slope_degrees"], data[name]
    style.stable_curve(axes, slopes, heights, data["stable"], colour, label=label)
    axes.plot(slopes.iloc[-1], heights.iloc[-1], "o", color=colour, markersize=4)
