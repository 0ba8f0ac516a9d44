"""Optimal runners at each friction and one speed: the cheapest one, and the one that slips least.

Touchdown angle, hip torque and leg thrust are varied. Where the second runner slips less, the slip of the
cheapest one could be avoided. At high friction many runners do not slip at all. The search finds an arbitrary
one of them, so the figure shows only its slip.
"""

from collections.abc import Sequence
from contextlib import suppress
from typing import Any

import numpy as np
import pandas
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...errors import RunError
from ...library.runner import Runner
from ...optimization.optimize import optimize
from ...optimization.optimum import Optimum
from ...pictures import style
from ...terminal.progress import progress_bar
from ...variables.table import FRICTION
from ..along import gait_table
from ..statements.claim import ANGLE, THRUST, TORQUE
from ..statements.gaits import BOUNDS, RADIUS, SPEED
from .data import Results
from .over_friction import friction_axis

FRICTIONS = np.geomspace(10.0, 0.05, 16)[:12]
"""Frictions from high to low; below the last one the search ends in worse optima."""
CHEAPEST, MIN_SLIP = "cost_of_transport", "slip_distance"
COLOURS = {CHEAPEST: "#e07b00", MIN_SLIP: "#1f5fa8"}
MARGIN = 1.1
"""Ratio of frictions between the ends of the axis and the data."""
NO_SLIP = 1e-8
"""Slip distance that counts as none, l0."""
COSTS = (0.2, 0.8)
"""Range of costs on the axis."""
NAMES = {CHEAPEST: "cheapest runner", MIN_SLIP: "runner with least slip"}


COLUMNS = (
    *("friction", "cheapest", "touchdown_angle", "stance_torque", "thrust", "word", "speed", CHEAPEST),
    *("positive_cost_of_transport", MIN_SLIP, "length", "lambda_max", "shown"),
)
"""Columns of the data."""


def table(results: Results) -> pandas.DataFrame:
    """Optimal runners at all frictions, each search also from the last; takes minutes."""
    found: list[Optimum] = []
    cheapest: list[Optimum] = []
    min_slipping: list[Optimum] = []
    with progress_bar("optimal runners", len(FRICTIONS), "frictions", True) as bar:
        for friction in FRICTIONS:
            its = results.runner.replace({FRICTION: float(friction)})
            cheapest = best(its, CHEAPEST, cheapest, begin=True)
            min_slipping = best(its, MIN_SLIP, [*min_slipping, *cheapest])
            found += [*cheapest, *min_slipping]
            bar.update()
    data = gait_table([one.gait for one in found], FRICTION, ANGLE, TORQUE, THRUST)
    data["cheapest"] = [one.objective == CHEAPEST for one in found]
    data["shown"] = [not one.why for one in found]
    return data[[*COLUMNS]]


def best(runner: Runner, objective: str, near: Sequence[Optimum], *, begin: bool = False) -> list[Optimum]:
    """Optimal runner at one friction, searched from optima at neighbouring frictions."""
    starts = [runner.replace(optimum.parameters) for optimum in near]
    found = []
    for start in [*starts, *([runner] if begin or not starts else [])]:
        with suppress(RunError):
            found.append(
                optimize(start, BOUNDS, minimize=objective, target={"speed": SPEED}, stable=RADIUS, starts=1)
            )
    return [min(found, key=lambda one: (one.why != "", one.value))] if found else []


def draw(results: Results) -> Figure:
    """Draw cost and slip of both runners against friction, and the drive of the cheapest one.

    Runners that are not shown to be optima are left out. A second runner that does not slip is one of many.
    Only its slip is drawn.
    """
    figure, panels = style.subplots(2, 2, figsize=(9.2, 6.2), sharex=True)
    (cost, angle), (slip, drive) = panels
    data = results.table("optimal").sort_values("friction")
    cheapest, least = (data[(data["cheapest"] == chosen) & data["shown"]] for chosen in (True, False))
    for its, objective in ((cheapest, CHEAPEST), (least, MIN_SLIP)):
        colour, name = COLOURS[objective], NAMES[objective]
        _curve(slip, its, its["slip_distance"], colour, name)
        its = its[its["slip_distance"] > NO_SLIP] if objective == MIN_SLIP else its
        _curve(cost, its, its["cost_of_transport"], colour, name)
        _curve(angle, its, np.degrees(its["touchdown_angle"]), colour, name)
        positive, dashes = its["positive_cost_of_transport"], style.SLIP_DASHES
        _curve(cost, its, positive, colour, f"{name}, positive work only", linestyle=dashes)
    _curve(drive, cheapest, cheapest["stance_torque"], style.CURVE, "hip torque (k l₀²)")
    _curve(drive, cheapest, cheapest["thrust"], style.SECOND_CURVE, "leg thrust (l₀)")
    cost.set_ylim(*COSTS)
    cost.set_title(f"(a) cost of transport at speed {SPEED:g} l₀√(k/m)")
    slip.set_title("(b) slip per stride (l₀)")
    angle.set_title("(c) touchdown angle (°)")
    drive.set_title("(d) hip torque and leg thrust of the cheapest runner")
    for axes in (cost, drive):
        axes.legend()
    for axes in panels[1]:
        friction_axis(axes, FRICTIONS)
        axes.set_xlim(FRICTIONS[-1] / MARGIN, FRICTIONS[0] * MARGIN)
    return figure


def _curve(axes: Axes, its: pandas.DataFrame, values: Any, colour: str, label: str, **look: Any) -> None:
    axes.plot(its["friction"], values, marker="o", markersize=3.0, color=colour, label=label, **look)
