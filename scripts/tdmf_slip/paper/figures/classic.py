"""Figures 1 to 4: the classic SLIP over a step, its return maps and gaits, and a massless foot that slips."""

import math
from functools import cache
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Polygon
from numpy.typing import NDArray

from ...library import classic_slip
from ...library.page import PageMap
from ...pictures import style
from ..evidence import SLIP_ANGLE, gather_classic
from ..published import IMPACT_FRICTION, STANCE_FRICTION
from .columns import Columns, Data, as_columns, attributes, select

COILS = 7
POINTS = 60
"""Points of each phase of a step."""
CONE = "#dce7c8"
"""Colour of friction cones."""


def _leg(axes: Axes, foot: Any, mass: Any, colour: str = style.INK, **line: Any) -> None:
    """Draw a spring from foot to mass, and the mass."""
    (x0, y0), (x1, y1) = foot, mass
    length = math.hypot(x1 - x0, y1 - y0)
    along = np.array([0.0, 0.15, *np.linspace(0.2, 0.8, 2 * COILS), 0.85, 1.0]) * length
    across = np.array([0.0, 0.0, *(0.05 * (-1) ** i for i in range(2 * COILS)), 0.0, 0.0])
    ux, uy = (x1 - x0) / length, (y1 - y0) / length
    x, y = x0 + along * ux - across * uy, y0 + along * uy + across * ux
    axes.plot(x, y, color=colour, linewidth=1.0, **line)
    axes.plot([x1], [y1], "o", color=colour, markersize=8, **line)


def _ground(axes: Axes) -> None:
    """Draw the ground line, and set axes of equal scale."""
    axes.axhline(0.0, color=style.GROUND, linewidth=3.0, zorder=0)
    axes.set_aspect("equal")
    style.label(axes, "x (m)", "y (m)")


ANGLE = math.radians(40.0)
SHOWN = (0, 1, 2, 3, 4)
"""Indices of the snapshots in stance."""


def step_table() -> Data:
    """Path of the mass over a step of the stable gait at 40 degrees, with the foot at x = 0."""
    slip, height = classic_slip.slip(ANGLE), classic_slip.fixed_points(ANGLE)[0].height
    step = classic_slip.step(slip, height)
    ends = np.cumsum([0.0, step.touchdown_time, step.stance_time])
    times = np.linspace(ends, [*ends[1:], step.time], POINTS).T.ravel()
    x, y, *_ = classic_slip.path(slip, height, times)
    return {"time": times, "x": x, "y": y, "phase": np.repeat(["fall", "stance", "rise"], POINTS)}


def draw_step() -> Figure:
    """Draw figure 1(b): the path, and the leg at five instants of the stance and at both apices."""
    data = as_columns(step_table())
    path = np.stack([data["x"], data["y"]], axis=1)
    figure, axes = style.subplots(figsize=(8.0, 3.6))
    _ground(axes)
    axes.plot(*path.T, color=style.SECOND_CURVE, linestyle="--", linewidth=1.2)
    stance = np.flatnonzero(data["phase"] == "stance")
    for k in (stance[round(s * (len(stance) - 1) / 4)] for s in SHOWN):
        _leg(axes, (0.0, 0.0), path[k])
    reach = np.array([math.sin(ANGLE), -math.cos(ANGLE)])
    for mass in path[[0, -1]]:
        _leg(axes, mass + reach, mass, style.FAINT)
    axes.set_ylim(-0.1, 1.25)
    return figure


ANGLES = (38.0, 40.0, 42.0, 44.0)
"""Touchdown angles of the maps, degrees."""
COLOURS = ("#9bb8d3", "#1f5fa8", "#e07b00", "#b3216f")
MAP_POINTS = 400
SWEPT = 44.588 - 13.288 * np.linspace(1.0, 0.0, 100) ** 2
"""Touchdown angles of the gaits, degrees, closer together towards the fold."""
ANGLE_LABEL = r"touchdown angle $\theta_0$ (°)"


def map_table() -> Data:
    """Return maps by column: apex height and next apex height, m."""
    rows = []
    for angle in ANGLES:
        parameters = classic_slip.slip(math.radians(angle))
        for height in classic_slip.heights(parameters, MAP_POINTS):
            step = classic_slip.step(parameters, height)
            if step.outcome in (classic_slip.FLIES, classic_slip.TURNS_BACK):
                rows.append((angle, height, step.next_height, step.outcome == classic_slip.FLIES))
    names = ("angle_degrees", "height", "next_height", "forwards")
    return dict(zip(names, zip(*rows, strict=True), strict=True))


@cache
def gait_table() -> Columns:
    """Gaits against the touchdown angle by column; the last one is the fold."""
    gaits = [g for angle in SWEPT for g in classic_slip.fixed_points(math.radians(angle))]
    gaits.append(classic_slip.fold())
    angles = [math.degrees(gait.angle) for gait in gaits]
    quantities = attributes(gaits, "height", "slope", "stance_friction", "impact_friction")
    return as_columns({"angle_degrees": angles, **quantities})


def draw_maps() -> Figure:
    """Draw figure 2(a): return maps at four touchdown angles."""
    data = as_columns(map_table())
    figure, axes = style.subplots(figsize=(5.6, 5.2))
    for angle, colour in zip(ANGLES, COLOURS, strict=True):
        for forwards, line in ((True, "-"), (False, ":")):
            its = select(data, angle_degrees=angle, forwards=forwards)
            heights, next_heights = its["height"], its["next_height"].copy()
            apart = np.diff(heights)
            if apart.size:  # a gap where the curve is not connected
                next_heights[np.flatnonzero(apart > 2.0 * np.median(apart)) + 1] = np.nan
            label = rf"$\theta_0$ = {angle:g}°" if forwards else None
            axes.plot(heights, next_heights, line, color=colour, label=label)
        for gait in classic_slip.fixed_points(math.radians(angle)):
            axes.plot(gait.height, gait.height, "^" if gait.stable else "s", color=colour, markersize=7)
    top = classic_slip.highest(classic_slip.slip(math.radians(ANGLES[0])))
    axes.plot([0.5, top], [0.5, top], color=style.FAINT, linestyle="-.", linewidth=1.0, zorder=1)
    axes.set_xlim(0.5, 5.5)
    axes.set_ylim(0.5, 8.0)
    axes.legend(title="▲ stable   ■ unstable\n… runs backwards", loc="upper left")
    style.label(axes, "apex height (m)", "next apex height (m)")
    return figure


def _branches(data: Columns) -> list[tuple[str, str, Columns]]:
    """Name, line and rows of the stable and of the unstable gaits, each with the fold."""
    fold = len(data["slope"]) - 1
    stable = np.flatnonzero(np.abs(data["slope"][:-1]) < 1.0)
    unstable = np.flatnonzero(data["slope"][:-1] >= 1.0)
    return [
        (name, line, select(data, np.append(rows, fold)))
        for name, line, rows in (("stable", "-", stable), ("unstable", "--", unstable))
    ]


def draw_gaits() -> Figure:
    """Draw figure 2(b): apex heights of gaits against the touchdown angle."""
    data = gait_table()
    figure, axes = style.subplots(figsize=(5.6, 4.2))
    for name, line, its in _branches(data):
        axes.plot(its["angle_degrees"], its["height"], line, color=style.CURVE, label=name)
    lowest = gather_classic().lowest
    for mark, name, angle, height in (
        ("o", "fold", data["angle_degrees"][-1], data["height"][-1]),
        ("s", "period doubling", math.degrees(lowest), classic_slip.fixed_points(lowest)[0].height),
    ):
        axes.plot(angle, height, mark, color=style.SECOND_CURVE, label=f"{name} at {angle:.2f}°")
    axes.legend()
    style.label(axes, ANGLE_LABEL, "apex height $y^*$ (m)")
    return figure


def draw_friction() -> Figure:
    """Draw figure 4(a): friction that gaits need in stance and at the impact of a small foot."""
    data = gait_table()
    figure, axes = style.subplots(figsize=(5.6, 4.2))
    for name, line, its in _branches(data):
        label = f"at impact, {name} gait"
        axes.plot(its["angle_degrees"], its["impact_friction"], line, color=style.CURVE, label=label)
    its = select(data, np.argsort(data["angle_degrees"]))
    label = r"in stance: $\tan\theta_0$"
    axes.plot(its["angle_degrees"], its["stance_friction"], "-.", color=style.SECOND_CURVE, label=label)
    axes.plot([SLIP_ANGLE] * 2, [STANCE_FRICTION, IMPACT_FRICTION], **style.PUBLISHED)
    axes.set_ylim(0.0, 6.0)
    axes.legend()
    style.label(axes, ANGLE_LABEL, "friction needed μ")
    return figure


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
    times = step.touchdown_time + step.stance_time * np.linspace(0.0, 1.0, POINTS)
    return classic_slip.path(slip, HEIGHT, times)


def slip_table() -> Data:
    """Data of figure 3 by column, a row for each panel."""
    friction, early = _early()
    slip = classic_slip.slip(TOUCHDOWN_ANGLE)
    needed = classic_slip.step(slip, HEIGHT).impact_friction
    at = np.stack([_stance(slip)[:, 0], early[:, -1], _stance(slip)[:, 0]], axis=1)
    frictions = [MARGIN * math.tan(TOUCHDOWN_ANGLE), friction, needed]
    state = dict(zip(("x", "y", "vx", "vy"), at, strict=True))
    return {"panel": ["a", "b", "c"], "friction": frictions, **state}


def draw_slip() -> Figure:
    """Draw figure 3: a massless foot that slips at touchdown and in stance, and the cone of an impact."""
    figure, axes = style.subplots(1, 3, figsize=(9.6, 3.8), sharey=True)
    for panel, draw in zip(axes, (_touchdown, _take_off, _impact), strict=True):
        _ground(panel)
        draw(panel)
        panel.set_xlim(-1.05, 1.05)
        panel.set_ylim(-0.35, 1.3)
        if panel is not axes[0]:
            panel.set_ylabel("")
    return figure


def _cone(axes: Axes, half_width: float, reach: float, top: float = 0.0) -> None:
    """Draw a friction cone, open upwards from the foot, or downwards from a height."""
    corners = [(0.0, top), (-half_width, reach), (half_width, reach)]
    axes.add_patch(Polygon(corners, color=CONE, linewidth=0, zorder=0))


def _velocity(axes: Axes, x: float, y: float, vx: float, vy: float) -> None:
    size = 0.45 / math.hypot(vx, vy)
    arrow = {"arrowstyle": "-|>", "color": style.SECOND_CURVE}
    axes.annotate("", (x + size * vx, y + size * vy), (x, y), arrowprops=arrow)


def _extended(axes: Axes, x: float, y: float, towards: float) -> None:
    """Draw the leg after the foot has slid until the spring is at its free length."""
    foot = x + towards * math.sqrt(max(0.0, 1.0 - y * y))
    _leg(axes, (foot, 0.0), (x, y), style.FAINT, linestyle=":")
    axes.annotate("", (foot, -0.12), (0.0, -0.12), arrowprops={"arrowstyle": "-|>", "color": "#e07b00"})


def _touchdown(axes: Axes) -> None:
    axes.set_title("(a) outside the cone at touchdown:\nthe foot slides out, the mass falls")
    _cone(axes, 0.55 * MARGIN * math.tan(TOUCHDOWN_ANGLE), 0.55)
    x, y, *velocity = _stance(classic_slip.slip(TOUCHDOWN_ANGLE))[:, 0]
    x, y = COMPRESSED * x, COMPRESSED * y
    _leg(axes, (0.0, 0.0), (x, y))
    _extended(axes, x, y, 1.0)
    _velocity(axes, x, y, *velocity)


def _take_off(axes: Axes) -> None:
    friction, path = _early()
    axes.set_title("(b) reaching its edge in stance:\nan early take-off")
    _cone(axes, 0.55 * friction, 0.55)
    axes.plot(path[0], path[1], color=style.SECOND_CURVE, linestyle="--", linewidth=1.2)
    x, y, *velocity = path[:, -1]
    _leg(axes, (0.0, 0.0), (x, y))
    _extended(axes, x, y, -1.0)
    _velocity(axes, x, y, *velocity)


def _impact(axes: Axes) -> None:
    axes.set_title("(c) a foot with mass sticks if its\nvelocity points into the cone")
    slip, foot = classic_slip.slip(TOUCHDOWN_ANGLE), (0.0, 0.3)
    x, y, *velocity = _stance(slip)[:, 0]
    _cone(axes, 0.3, 0.0, top=0.3)
    _leg(axes, foot, (foot[0] + x, foot[1] + y))
    axes.plot(*foot, "o", color=style.INK, markersize=5)
    _velocity(axes, *foot, *velocity)
    needed = classic_slip.step(slip, HEIGHT).impact_friction
    axes.annotate(f"needs μ ≥ {needed:.2f}", (0.42, 0.16), fontsize=8.5)
