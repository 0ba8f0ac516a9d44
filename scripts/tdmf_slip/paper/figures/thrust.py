"""Cost of transport and slip with leg thrust and with hip torque, at equal speed."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from ...analysis.branches import Branch, continue_branch
from ...analysis.search import periodic_gait
from ...library.gait import Gait
from ...library.runner import Runner
from ...pictures import style
from ...variables.table import FRICTION
from ..matched import changed, like
from . import leading
from .columns import Columns, Data, attributes, select

TORQUE, THRUST, ANGLE = "hip.stance_torque", "leg.thrust", "hip.touchdown_angle"
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


def measure(runner: Runner) -> Data:
    """Data of the figure by column: gaits of each actuation along branches over its strength, by friction.

    If the branch ends before the torque is zero, thrust alone has no gait.
    """
    gaits: list[Gait] = []
    for friction in FRICTIONS:
        its = runner.replace({FRICTION: friction})
        first = periodic_gait(its)
        hip = _both_ways(first, TORQUE, HIGHEST_TORQUE)
        added = _branch(first, THRUST, HIGHEST_THRUST)
        gaits += (*hip.gaits, *added.gaits[1:], *_leg_alone(first), *matched(hip.gaits))
    return {
        **attributes(gaits, "friction"),
        "touchdown_angle": [gait.runner[ANGLE] for gait in gaits],
        "hip_torque": [gait.runner[TORQUE] for gait in gaits],
        "thrust": [gait.runner[THRUST] for gait in gaits],
        **attributes(gaits, "word", "stable", "speed", "cost_of_transport"),
        "slip_per_length": [gait.stride["slip_distance"] / gait.stride["length"] for gait in gaits],
        **leading.as_columns(gaits),
    }


def matched(by_hip: Sequence[Gait]) -> Iterator[Gait]:
    """Gaits with thrust that match stable gaits without thrust in speed and apex height."""
    stable = [gait for gait in by_hip if gait.stable]
    for speed in SPEEDS:
        reference = min(stable, key=lambda gait: abs(gait.stride["speed"] - speed))
        near = changed(reference, {THRUST: HELPED}, 2)
        one = near and like(reference, near, ("speed", "apex_height"), (TORQUE, ANGLE))
        if one:
            yield one


def _leg_alone(first: Gait) -> Iterator[Gait]:
    driven = _branch(first, THRUST, WITHOUT_TORQUE).gaits[-1]
    freed = _branch(driven, TORQUE, 0.0)
    if freed.values[-1] == 0.0:
        yield from _both_ways(freed.gaits[-1], THRUST, HIGHEST_THRUST).gaits


def _branch(first: Gait, name: str, end: float) -> Branch:
    return _followed(first, name, first.runner[name], end)


def _both_ways(first: Gait, name: str, end: float) -> Branch:
    return _followed(first, name, 0.0, end)


def _followed(first: Gait, name: str, begin: float, end: float) -> Branch:
    span = {name: (begin, end)}
    return continue_branch.plain(first, span, max_step=LARGEST_STEP, max_points=POINTS, switch=False)


def actuated(data: Columns) -> dict[str, NDArray[np.bool_]]:
    """Masks of the rows of each actuation."""
    torque, thrust = data["hip_torque"], data["thrust"]
    beside = torque[np.flatnonzero((torque > 0.0) & (thrust > 0.0))[0]]
    angle = data["touchdown_angle"]
    return {
        HIP_ALONE: thrust == 0.0,
        BOTH: torque == beside,
        LEG_ALONE: torque == 0.0,
        MATCHED: angle != angle[0],
    }


def draw(data: Columns) -> Figure:
    """Draw a column for each friction, a colour for each actuation; dashed where the gait is unstable."""
    figure, panels = style.subplots(2, len(FRICTIONS), figsize=(9.6, 6.4), sharex=True, sharey="row")
    for column, friction in zip(panels.T, FRICTIONS, strict=True):
        for name, chosen in actuated(data).items():
            its = select(data, chosen, friction=friction)
            for axes, key in zip(column, ("cost_of_transport", "slip_per_length"), strict=True):
                _curve(axes, its["speed"], its[key], its["stable"] > 0.0, name)
        column[0].set_title(f"friction {friction:g}")
        column[1].set_xlabel("average speed (l₀√(k/m))")
    panels[0, 0].set_ylim(*COSTS)
    panels[0, 0].set_ylabel("cost of transport")
    panels[1, 0].set_ylabel("slip distance per stride length")
    style.name_unstable(panels[1, -1])
    panels[1, -1].legend(loc="upper left")
    return figure


def _curve(
    axes: Axes, speed: NDArray[np.float64], height: NDArray[np.float64], stable: NDArray[np.bool_], name: str
) -> None:
    if name == MATCHED:
        axes.plot(speed, height, "x", color=COLOURS[name], markersize=5, label=name)
        return
    style.stable_curve(axes, speed, height, stable, COLOURS[name], label=name)
