"""Figure 1(b): the classic SLIP over one step of its stable gait at 40 degrees."""

import math
from pathlib import Path

import numpy as np

from ...library import classic_slip
from ...pictures import style
from . import slip_path
from .columns import Columns

ANGLE = math.radians(40.0)
SHOWN = (0, 1, 2, 3, 4)
"""Indices of the snapshots in stance."""


def table() -> Columns:
    """Path of the mass by column, with the foot at x = 0."""
    path = _path()
    return {"time": path.time, "x": path.x, "y": path.y, "phase": path.phase}


def _path() -> slip_path.Path:
    return slip_path.of_step(classic_slip.slip(ANGLE), classic_slip.fixed_points(ANGLE)[0].height)


def draw(path: Path) -> None:
    """Draw the path, and the leg at five instants of the stance and at both apices."""
    step = _path()
    with style.styled():
        figure, axes = style.subplots(figsize=(8.0, 3.6))
        slip_path.ground(axes)
        axes.plot(step.x, step.y, color=style.SECOND_CURVE, linestyle="--", linewidth=1.2)
        stance = [i for i, phase in enumerate(step.phase) if phase == "stance"]
        for i in (stance[round(s * (len(stance) - 1) / 4)] for s in SHOWN):
            slip_path.leg(axes, (0.0, 0.0), (step.x[i], step.y[i]))
        reach = np.array([math.sin(ANGLE), -math.cos(ANGLE)])
        for i in (0, -1):
            mass = np.array([step.x[i], step.y[i]])
            slip_path.leg(axes, tuple(mass + reach), tuple(mass), style.FAINT)
        axes.set_ylim(-0.1, 1.25)
        style.save(figure, path)
