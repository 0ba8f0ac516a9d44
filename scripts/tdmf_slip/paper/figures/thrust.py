"""Cost of transport and slip with leg thrust and with hip torque, at equal speed."""

from collections.abc import Iterator, Mapping
from contextlib import suppress
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas
from matplotlib.figure import Figure

from ...analysis.branches import continue_branch
from ...analysis.sweeps import gaits_in
from ...errors import RunError
from ...library.gait import Gait
from ...pictures import style
from ...variables.table import FRICTION
from ..along import gait_table
from ..matched import IN_TWO, gait_with, match_gait
from ..statements.claim import ANGLE, THRUST, TORQUE
from .data import Results

if TYPE_CHECKING:
    import xarray

FRICTIONS = (0.2, 0.6, 10.0)
HIGHEST_TORQUE, HIGHEST_THRUST = 1.0, 0.6
WITHOUT_TORQUE = 0.45
"""Thrust at which the torque is reduced to zero."""
LARGEST_STEP = 0.2
POINTS = 70
"""Maximum number of gaits of a branch, which continues far beyond its fold."""
COSTS = (0.2, 1.2)
"""Range of costs on the axis."""

HIP_ALONE, BOTH, LEG_ALONE = "hip torque alone", "thrust added to a hip torque of 0.2 k l₀²", "thrust alone"
MATCHED = "thrust of 0.1 l₀ at equal apex height"
COLOURS: Mapping[str, str] = {HIP_ALONE: "#e07b00", BOTH: "#0b7a75", LEG_ALONE: "#22303c", MATCHED: "#b3216f"}
HELPED, SPEEDS = 0.1, np.linspace(0.8, 1.5, 8)
"""Thrust and speeds of the matched runners."""


COLUMNS = (
    *("friction", "touchdown_angle", "stance_torque", "thrust", "word", "stable", "speed"),
    *("cost_of_transport", "slip_per_length", "greater_eigenvalue", "other_eigenvalue"),
)
"""Columns of the data."""


def table(results: Results) -> pandas.DataFrame:
    """Gaits of each actuation along branches over its strength, by friction; takes minutes.

    If the branch ends before the torque is zero, thrust alone has no gait.
    """
    tables: list[pandas.DataFrame] = []
    for friction in FRICTIONS:
        first = results.gait(friction)
        hip = _branch(first, TORQUE, HIGHEST_TORQUE, 0.0)
        added = _branch(first, THRUST, HIGHEST_THRUST)
        found: list[xarray.Dataset | list[Gait]] = [
            hip,
            added.isel(point=slice(1, None)),
            *_leg_alone(first),
            matched(hip),
        ]
        tables += [gait_table(gaits, FRICTION, ANGLE, TORQUE, THRUST) for gaits in found]
    data = pandas.concat(tables, ignore_index=True)
    return data.assign(slip_per_length=data["slip_distance"] / data["length"])[[*COLUMNS]]


def matched(by_hip: "xarray.Dataset") -> list[Gait]:
    """Gaits with thrust that match stable gaits without thrust in speed and apex height."""
    stable, found = gaits_in(by_hip.isel(point=by_hip["lambda_max"].values < 1.0)), []
    for speed in SPEEDS:
        reference = min(stable, key=lambda gait: abs(gait.stride["speed"] - speed))
        with suppress(RunError):
            near = gait_with(reference, THRUST, HELPED)
            found.append(match_gait(reference, near, *IN_TWO))
    return found


def _leg_alone(first: Gait) -> Iterator["xarray.Dataset"]:
    with suppress(RunError):
        freed = gait_with(gait_with(first, THRUST, WITHOUT_TORQUE), TORQUE, 0.0)
        yield _branch(freed, THRUST, HIGHEST_THRUST, 0.0)


def _branch(first: Gait, name: str, end: float, begin: float | None = None) -> "xarray.Dataset":
    """Gaits of a branch from the first one's value, or from another one, to an end."""
    ends = first.runner[name] if begin is None else begin, end
    found = continue_branch(first, {name: ends}, max_step=LARGEST_STEP, max_points=POINTS, switch=False)
    return found.isel(point=found["special"].values == "")


def actuated(data: pandas.DataFrame) -> dict[str, Any]:
    """Masks of the rows of each actuation."""
    torque, thrust = data["stance_torque"], data["thrust"]
    beside = torque[(torque > 0.0) & (thrust > 0.0)].iloc[0]
    angle = data["touchdown_angle"]
    return {
        HIP_ALONE: thrust == 0.0,
        BOTH: torque == beside,
        LEG_ALONE: torque == 0.0,
        MATCHED: angle != angle.iloc[0],
    }


def draw(results: Results) -> Figure:
    """Draw a column for each friction, a colour for each actuation; dashed where the gait is unstable."""
    data = results.table("thrust")
    figure, panels = style.subplots(2, len(FRICTIONS), figsize=(9.6, 6.4), sharex=True, sharey="row")
    for column, friction in zip(panels.T, FRICTIONS, strict=True):
        for name, chosen in actuated(data).items():
            its = data[chosen & (data["friction"] == friction)]
            for axes, key in zip(column, ("cost_of_transport", "slip_per_length"), strict=True):
                if name == MATCHED:
                    axes.plot(its["speed"], its[key], "x", color=COLOURS[name], markersize=5, label=name)
                else:
                    style.stable_curve(axes, its["speed"], its[key], its["stable"], COLOURS[name], label=name)
        column[0].set_title(f"friction {friction:g}")
        column[1].set_xlabel("average speed (l₀√(k/m))")
    panels[0, 0].set_ylim(*COSTS)
    panels[0, 0].set_ylabel("cost of transport")
    panels[1, 0].set_ylabel("slip distance per stride length")
    style.name_unstable(panels[1, -1])
    panels[1, -1].legend(loc="upper left")
    return figure
