"""Optimal runners at each friction and one speed: the cheapest one, and the one that slips least.

Touchdown angle, hip torque and leg thrust are varied. Where the second runner slips
less, the slip of the cheapest one could be avoided.
"""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from ...analysis.search import periodic_gait
from ...errors import RunError
from ...library.fixed_point import gait_near
from ...library.runner import Runner
from ...optimization.gaits import Space
from ...optimization.optimizer import Optimizer, Start
from ...optimization.optimum import Optimum
from ...optimization.problem import Goal
from ...pictures import style
from ...terminal.progress import progress_bar
from ...variables.table import FRICTION
from . import figure_9
from .columns import Columns, attributes

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
COSTS = (0.2, 0.8)
"""Range of costs on the axis."""
NAMES = {CHEAPEST: "cheapest runner", MIN_SLIP: "runner with least slip"}


def measure(runner: Runner) -> Columns:
    """Data of the figure by column: optimal runners at all frictions, each search also from the last."""
    found: list[Optimum] = []
    cheapest: list[Optimum] = []
    min_slipping: list[Optimum] = []
    with progress_bar("optimal runners", len(FRICTIONS), "frictions", True) as bar:
        for friction in FRICTIONS:
            its = runner.replace({FRICTION: float(friction)})
            cheapest = best(its, CHEAPEST, cheapest, begin=True)
            min_slipping = best(its, MIN_SLIP, [*min_slipping, *cheapest])
            found += [*cheapest, *min_slipping]
            bar.update()
    gaits = [optimum.gait for optimum in found]
    return {
        **attributes(gaits, "friction"),
        "cheapest": [optimum.objective == CHEAPEST for optimum in found],
        "touchdown_angle": [gait.runner[ANGLE] for gait in gaits],
        "stance_torque": [gait.runner[TORQUE] for gait in gaits],
        "thrust": [gait.runner[THRUST] for gait in gaits],
        **attributes(gaits, "word", "speed", "cost_of_transport", "positive_cost_of_transport"),
        **attributes(gaits, "slip_distance", "length", "lambda_max"),
        "shown": [not optimum.why for optimum in found],
    }


def best(runner: Runner, objective: str, near: Sequence[Optimum], *, begin: bool = False) -> list[Optimum]:
    """Optimal runner at one friction, searched from optima at neighbouring frictions."""
    goal = Goal(objective, at={"speed": SPEED}, radius=RADIUS)
    try:
        optimizer = Optimizer(periodic_gait(runner), Space(BOUNDS), 1)
        starts = list(_starts(optimizer.space, runner, near))
        starts += [optimizer.first] if begin or not starts else []
        with progress_bar("", len(starts), "", show=False) as bar:
            return [optimizer.optimum(goal, optimizer.best(goal, bar, starts))]
    except RunError:
        return []


def _starts(space: Space, runner: Runner, near: Sequence[Optimum]) -> Iterator[Start]:
    for optimum in near:
        at = space.coordinates_of(optimum.gait.runner)
        try:
            yield Start(at, gait_near(space.runner_at(runner, at), optimum.gait.apex))
        except RunError:
            continue


def draw(path: Path, data: Columns) -> None:
    """Draw cost and slip of both runners against friction, and what the cheapest one does.

    Runners that are not shown to be optima are left out.
    """
    columns = {name: np.asarray(values) for name, values in data.items()}
    with style.styled():
        figure, panels = style.subplots(2, 2, figsize=(9.2, 6.2), sharex=True)
        (cost, angle), (slip, drive) = panels
        for objective, chosen in ((CHEAPEST, 1.0), (MIN_SLIP, 0.0)):
            rows = (columns["cheapest"].astype(float) == chosen) & (columns["shown"].astype(float) > 0.0)
            for axes, column, factor in (
                (cost, "cost_of_transport", 1.0),
                (slip, "slip_distance", 1.0),
                (angle, "touchdown_angle", 180.0 / np.pi),
            ):
                _curve(axes, columns, column, rows, factor, color=COLOURS[objective], label=NAMES[objective])
            _curve(
                cost,
                columns,
                "positive_cost_of_transport",
                rows,
                color=COLOURS[objective],
                label=f"{NAMES[objective]}, positive work only",
                linestyle=style.SLIP_DASHES,
            )
        rows = (columns["cheapest"].astype(float) == 1.0) & (columns["shown"].astype(float) > 0.0)
        _curve(drive, columns, "stance_torque", rows, color=style.CURVE, label="hip torque (k l₀²)")
        _curve(drive, columns, "thrust", rows, color=style.SECOND_CURVE, label="leg thrust (l₀)")
        cost.set_ylim(*COSTS)
        cost.set_title(f"(a) cost of transport at speed {SPEED:g} l₀√(k/m)")
        slip.set_title("(b) slip per stride (l₀)")
        angle.set_title("(c) touchdown angle (°)")
        drive.set_title("(d) hip torque and leg thrust of the cheapest runner")
        for axes in (cost, drive):
            axes.legend()
        for axes in panels[1]:
            figure_9.friction_axis(axes, FRICTIONS)
            axes.set_xlim(FRICTIONS[-1] / MARGIN, FRICTIONS[0] * MARGIN)
        style.save(figure, path)


def _curve(
    axes: Axes,
    columns: dict[str, NDArray[np.float64]],
    column: str,
    rows: NDArray[np.bool_],
    factor: float = 1.0,
    *,
    color: str,
    label: str,
    linestyle: Any = "-",
) -> None:
    order = np.argsort(columns["friction"][rows])
    x, y = (columns[name][rows][order].astype(float) for name in ("friction", column))
    axes.plot(x, factor * y, marker="o", markersize=3.0, color=color, label=label, linestyle=linestyle)
