"""Figure 3: a massless foot that slips, at touchdown and in stance, and the cone that an impact must meet."""

import math
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Polygon
from numpy.typing import NDArray

from ...library import classic_slip
from ...library.page import PageMap
from ...pictures import style
from . import slip_path
from .columns import Columns

TOUCHDOWN_ANGLE = math.radians(40.0)
STANCE_ANGLE = math.radians(30.0)
HEIGHT = 1.2
"""Height of the previous apex, m."""
MARGIN = 0.8
"""Friction relative to the friction needed."""
COMPRESSED = 0.85
"""Length of the leg in (a), a little after touchdown, where the slip is visible."""


def _early() -> tuple[float, NDArray[np.float64]]:
    """A friction that ends the stance early, and the path of the mass in this stance."""
    friction = MARGIN * classic_slip.step(classic_slip.slip(STANCE_ANGLE), HEIGHT).stance_friction
    return friction, _stance(classic_slip.slip(STANCE_ANGLE, friction))


def _stance(slip: PageMap) -> NDArray[np.float64]:
    """Position and velocity of the mass relative to the foot along a stance: a row for each."""
    step = classic_slip.step(slip, HEIGHT)
    times = step.touchdown_time + step.stance_time * np.linspace(0.0, 1.0, slip_path.POINTS)
    return classic_slip.path(slip, HEIGHT, times)


def table() -> Columns:
    """Data of the three panels by column."""
    friction, early = _early()
    slip = classic_slip.slip(TOUCHDOWN_ANGLE)
    needed = classic_slip.step(slip, HEIGHT).impact_friction
    at = np.stack([_stance(slip)[:, 0], early[:, -1], _stance(slip)[:, 0]], axis=1).tolist()
    return {
        "panel": ["a", "b", "c"],
        "friction": [MARGIN * math.tan(TOUCHDOWN_ANGLE), friction, needed],
        **dict(zip(("x", "y", "vx", "vy"), at, strict=True)),
    }


def draw(path: Path) -> None:
    """Draw the three panels."""
    with style.styled():
        figure, axes = style.subplots(1, 3, figsize=(9.6, 3.8), sharey=True)
        _touchdown(axes[0])
        _take_off(axes[1])
        _impact(axes[2])
        for panel in axes:
            panel.set_xlim(-1.05, 1.05)
            panel.set_ylim(-0.35, 1.3)
        for panel in axes[1:]:
            panel.set_ylabel("")
        style.save(figure, path)


def _cone(axes: Axes, friction: float, up: float = 1.0, reach: float = 0.55) -> None:
    """Draw the friction cone at the foot."""
    half_width = friction * reach
    axes.add_patch(
        Polygon(
            [(0, 0), (-half_width, up * reach), (half_width, up * reach)],
            color="#dce7c8",
            linewidth=0,
            zorder=0,
        )
    )


def _velocity(axes: Axes, x: float, y: float, vx: float, vy: float) -> None:
    size = 0.45 / math.hypot(vx, vy)
    axes.annotate(
        "",
        (x + size * vx, y + size * vy),
        (x, y),
        arrowprops={"arrowstyle": "-|>", "color": style.SECOND_CURVE},
    )


def _extended(axes: Axes, x: float, y: float, towards: float) -> None:
    """Draw the leg after the foot has slid until the spring is at its free length."""
    foot = x + towards * math.sqrt(max(0.0, 1.0 - y * y))
    slip_path.leg(axes, (foot, 0.0), (x, y), style.FAINT, linestyle=":")
    axes.annotate("", (foot, -0.12), (0.0, -0.12), arrowprops={"arrowstyle": "-|>", "color": "#e07b00"})


def _touchdown(axes: Axes) -> None:
    slip_path.ground(axes)
    axes.set_title("(a) outside the cone at touchdown:\nthe foot slides out, the mass falls")
    _cone(axes, MARGIN * math.tan(TOUCHDOWN_ANGLE))
    x, y, *velocity = _stance(classic_slip.slip(TOUCHDOWN_ANGLE))[:, 0]
    x, y = COMPRESSED * x, COMPRESSED * y
    slip_path.leg(axes, (0.0, 0.0), (x, y))
    _extended(axes, x, y, 1.0)
    _velocity(axes, x, y, *velocity)


def _take_off(axes: Axes) -> None:
    friction, path = _early()
    slip_path.ground(axes)
    axes.set_title("(b) reaching its edge in stance:\nan early take-off")
    _cone(axes, friction)
    axes.plot(path[0], path[1], color=style.SECOND_CURVE, linestyle="--", linewidth=1.2)
    x, y, *velocity = path[:, -1]
    slip_path.leg(axes, (0.0, 0.0), (x, y))
    _extended(axes, x, y, -1.0)
    _velocity(axes, x, y, *velocity)


def _impact(axes: Axes) -> None:
    slip_path.ground(axes)
    axes.set_title("(c) a foot with mass sticks if its\nvelocity points into the cone")
    slip, foot = classic_slip.slip(TOUCHDOWN_ANGLE), (0.0, 0.3)
    x, y, *velocity = _stance(slip)[:, 0]
    axes.add_patch(Polygon([foot, (-0.3, 0.0), (0.3, 0.0)], color="#dce7c8", linewidth=0, zorder=0))
    slip_path.leg(axes, foot, (foot[0] + x, foot[1] + y))
    axes.plot(*foot, "o", color=style.INK, markersize=5)
    _velocity(axes, *foot, *velocity)
    axes.annotate(
        f"needs μ ≥ {classic_slip.step(slip, HEIGHT).impact_friction:.2f}", (0.42, 0.16), fontsize=8.5
    )
