"""Optimal runners at each friction and one speed: the cheapest one, and the one that slips least.

Touchdown angle, hip torque and leg thrust are varied. Where the second runner slips less, the slip of the
cheapest one could be avoided. At high friction many runners do not slip at all. The search finds an arbitrary
one of them, so the figure shows only its slip.
"""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import pandas
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...analysis.search import periodic_gait
from ...errors import RunError
from ...library.fixed_point import gait_near
from ...library.gait import Gait
from ...library.runner import Runner
from ...optimization.gaits import Space
from ...optimization.optimizer import Optimizer
from ...optimization.optimum import Optimum
from ...optimization.problem import Goal
from ...pictures import style
from ...terminal.progress import progress_bar
from ...variables.table import FRICTION
from .data import Results, table_of
from .over_friction import friction_axis

FRICTIONS = np.geomspace(10.0, 0.05, 16)[:12]
"""Frictions from high to low; below the last one the search ends in worse optima."""
SPEED = 0.8
"""Speed, l0 sqrt(k/m)."""
RADIUS = 0.95
"""Largest spectral radius: a disturbance is halved within 14 strides."""
ANGLE, TORQUE, THRUST = "hip.touchdown_angle", "hip.stance_torque", "leg.thrust"
BOUNDS = {ANGLE: (0.3, 1.1), TORQUE: (0.0, 0.6), THRUST: (0.0, 0.4)}
"""Bounds, rad, k l0^2 and l0."""
CHEAPEST, MIN_SLIP = "cost_of_transport", "slip_distance"
COLOURS = {CHEAPEST: "#e07b00", MIN_SLIP: "#1f5fa8"}
MARGIN = 1.1
"""Ratio of frictions between the ends of the axis and the data."""
NO_SLIP = 1e-8
"""Slip distance that counts as none, l0."""
COSTS = (0.2, 0.8)
"""Range of costs on the axis."""
NAMES = {CHEAPEST: "cheapest runner", MIN_SLIP: "runner with least slip"}


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
    columns = "word", "speed", CHEAPEST, "positive_cost_of_transport", MIN_SLIP, "length", "lambda_max"
    return table_of(
        found,
        friction="gait.friction",
        cheapest=lambda optimum: optimum.objective == CHEAPEST,
        touchdown_angle=lambda optimum: optimum.parameters[ANGLE],
        stance_torque=lambda optimum: optimum.parameters[TORQUE],
        thrust=lambda optimum: optimum.parameters[THRUST],
        **{name: f"gait.{name}" for name in columns},
        shown=lambda optimum: not optimum.why,
    )


def best(runner: Runner, objective: str, near: Sequence[Optimum], *, begin: bool = False) -> list[Optimum]:
    """Optimal runner at one friction, searched from optima at neighbouring frictions."""
    goal = Goal(objective, at={"speed": SPEED}, radius=RADIUS)
    try:
        optimizer = Optimizer(periodic_gait(runner), Space(BOUNDS), 1)
        starts = list(_starts(optimizer.space, runner, near))
        starts += [optimizer.first] if begin or not starts else []
        with progress_bar("", len(starts), "", show=False) as bar:
            return [optimizer.best(goal, bar, starts)]
    except RunError:
        return []


def _starts(space: Space, runner: Runner, near: Sequence[Optimum]) -> Iterator[Gait]:
    for optimum in near:
        at = space.coordinates_of(optimum.gait.runner)
        try:
            yield gait_near(space.runner_at(runner, at), optimum.gait.apex)
        except RunError:
            continue


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
