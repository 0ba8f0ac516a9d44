"""Path and leg of the classic SLIP over a step, for figures 1 and 3."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from ...library import classic_slip
from ...library.page import PageMap
from ...pictures import style

COILS = 7
POINTS = 60


@dataclass(frozen=True, eq=False)
class Path:
    """One step from apex to apex, with the foot at x = 0."""

    time: NDArray[np.float64]
    """Time since the apex."""
    x: NDArray[np.float64]
    """Horizontal position of the mass."""
    y: NDArray[np.float64]
    """Height of the mass."""
    phase: list[str]
    """Phases: fall, stance or rise."""


def of_step(slip: PageMap, height: float) -> Path:
    """Path of the mass from one apex to the next."""
    step = classic_slip.step(slip, height)
    ends = np.cumsum([0.0, step.touchdown_time, step.stance_time])
    times = np.linspace(ends, [*ends[1:], step.time], POINTS).T.ravel()
    x, y, *_ = classic_slip.path(slip, height, times)
    phases = [phase for phase in ("fall", "stance", "rise") for _ in range(POINTS)]
    return Path(times, x, y, phases)


def leg(
    axes: Axes, foot: tuple[float, float], mass: tuple[float, float], colour: str = style.INK, **line: Any
) -> None:
    """Draw a spring from foot to mass, and the mass."""
    (x0, y0), (x1, y1) = foot, mass
    length = math.hypot(x1 - x0, y1 - y0)
    along = np.array([0.0, 0.15, *np.linspace(0.2, 0.8, 2 * COILS), 0.85, 1.0]) * length
    across = np.array([0.0, 0.0, *(0.05 * (-1) ** i for i in range(2 * COILS)), 0.0, 0.0])
    ux, uy = (x1 - x0) / length, (y1 - y0) / length
    axes.plot(
        x0 + along * ux - across * uy, y0 + along * uy + across * ux, color=colour, linewidth=1.0, **line
    )
    axes.plot([x1], [y1], "o", color=colour, markersize=8, **line)


def ground(axes: Axes) -> None:
    """Draw the ground line, and set axes of equal scale."""
    axes.axhline(0.0, color=style.GROUND, linewidth=3.0, zorder=0)
    axes.set_aspect("equal")
    style.label(axes, "x (m)", "y (m)")
