"""Figures 1 to 4: the classic SLIP over a step, its return maps and gaits, and a massless foot that slips."""

import math
from typing import Any

import numpy as np
import pandas
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Polygon
from numpy.typing import NDArray

from ...library import classic_slip
from ...library.page_runner import PageRunner
from ...pictures import style
from ...pictures.model import spring
from ..evidence import SLIP_ANGLE, lowest_stable_angle
from ..published import IMPACT_FRICTION, STANCE_FRICTION
from .data import Results, table_of

POINTS = 60
"""Points of each phase of a step."""
CONE = "#dce7c8"
"""Colour of friction cones."""


def _leg(axes: Axes, foot: Any, mass: Any, colour: str = style.INK, **line: Any) -> None:
    """Draw a spring from foot to mass, and the mass."""
    axes.plot(*spring(foot, mass), color=colour, linewidth=1.0, **line)
    axes.plot(*mass, "o", color=colour, markersize=8, **line)


def _ground(axes: Axes) -> None:
    """Draw the ground line, and set axes of equal scale."""
    axes.axhline(0.0, color=style.GROUND, linewidth=3.0, zorder=0)
    axes.set_aspect("equal")
    style.label(axes, "x (m)", "y (m)")


ANGLE = math.radians(40.0)
SHOWN = (0, 1, 2, 3, 4)
"""Indices of the snapshots in stance."""


def step_table(_results: Results) -> pandas.DataFrame:
    """Path of the mass over a step of the stable gait at 40 degrees, with the foot at x = 0."""
    slip, height = classic_slip.slip(ANGLE), classic_slip.classic_gaits(ANGLE)[0].height
    step = classic_slip.step(slip, height)
    ends = np.cumsum([0.0, step.touchdown_time, step.stance_time])
    times = np.linspace(ends, [*ends[1:], step.time], POINTS).T.ravel()
    x, y, *_ = classic_slip.path(slip, height, times)
    phase = np.repeat(["fall", "stance", "rise"], POINTS)
    return pandas.DataFrame({"time": times, "x": x, "y": y, "phase": phase})


def draw_step(results: Results) -> Figure:
    """Draw figure 1(b): the path, and the leg at five instants of the stance and at both apices."""
    data = results.table("figure_1b")
    path = data[["x", "y"]].to_numpy()
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


def map_table(_: Results) -> pandas.DataFrame:
    """Return maps by column: apex height and next apex height, m."""
    rows = []
    for angle in ANGLES:
        parameters = classic_slip.slip(math.radians(angle))
        for height in classic_slip.heights(parameters, MAP_POINTS):
            step = classic_slip.step(parameters, height)
            if step.outcome in (classic_slip.FLIES, classic_slip.TURNS_BACK):
                rows.append((angle, height, step.next_height, step.outcome == classic_slip.FLIES))
    return pandas.DataFrame(rows, columns=["angle_degrees", "height", "next_height", "forwards"])


def gait_table(_: Results) -> pandas.DataFrame:
    """Gaits against the touchdown angle by column; the last one is the fold."""
    gaits = [g for angle in SWEPT for g in classic_slip.classic_gaits(math.radians(angle))]
    gaits.append(classic_slip.classic_fold())
    quantities = ("height", "slope", "stance_friction", "impact_friction")
    return table_of(gaits, *quantities, angle_degrees=lambda gait: math.degrees(gait.angle))


def draw_maps(results: Results) -> Figure:
    """Draw figure 2(a): return maps at four touchdown angles."""
    data = results.table("figure_2a")
    figure, axes = style.subplots(figsize=(5.6, 5.2))
    for angle, colour in zip(ANGLES, COLOURS, strict=True):
        for forwards, line in ((True, "-"), (False, ":")):
            its = data[(data["angle_degrees"] == angle) & (data["forwards"] == forwards)]
            heights, next_heights = its["height"].to_numpy(), its["next_height"].to_numpy(copy=True)
            apart = np.diff(heights)
            if apart.size:  # a gap where the curve is not connected
                next_heights[np.flatnonzero(apart > 2.0 * np.median(apart)) + 1] = np.nan
            label = rf"$\theta_0$ = {angle:g}°" if forwards else None
            axes.plot(heights, next_heights, line, color=colour, label=label)
        for gait in classic_slip.classic_gaits(math.radians(angle)):
            axes.plot(gait.height, gait.height, "^" if gait.stable else "s", color=colour, markersize=7)
    top = classic_slip.highest(classic_slip.slip(math.radians(ANGLES[0])))
    axes.plot([0.5, top], [0.5, top], color=style.FAINT, linestyle="-.", linewidth=1.0, zorder=1)
    axes.set_xlim(0.5, 5.5)
    axes.set_ylim(0.5, 8.0)
    axes.legend(title="▲ stable   ■ unstable\n… runs backwards", loc="upper left")
    style.label(axes, "apex height (m)", "next apex height (m)")
    return figure


def _branches(data: pandas.DataFrame) -> list[tuple[str, str, pandas.DataFrame]]:
    """Name, line and rows of the stable and of the unstable gaits, each with the fold, the last row."""
    is_fold = data.index == len(data) - 1
    return [
        ("stable", "-", data[is_fold | (data["slope"].abs() < 1.0)]),
        ("unstable", "--", data[is_fold | (data["slope"] >= 1.0)]),
    ]


def draw_gaits(results: Results) -> Figure:
    """Draw figure 2(b): apex heights of gaits against the touchdown angle."""
    data = results.table("figure_2b")
    figure, axes = style.subplots(figsize=(5.6, 4.2))
    for name, line, its in _branches(data):
        axes.plot(its["angle_degrees"], its["height"], line, color=style.CURVE, label=name)
    lowest = lowest_stable_angle()
    for mark, name, angle, height in (
        ("o", "fold", data["angle_degrees"].iloc[-1], data["height"].iloc[-1]),
        ("s", "period doubling", math.degrees(lowest), classic_slip.classic_gaits(lowest)[0].height),
    ):
        axes.plot(angle, height, mark, color=style.SECOND_CURVE, label=f"{name} at {angle:.2f}°")
    axes.legend()
    style.label(axes, ANGLE_LABEL, "apex height $y^*$ (m)")
    return figure


def draw_friction(results: Results) -> Figure:
    """Draw figure 4(a): friction that gaits need in stance and at the impact of a small foot."""
    data = results.table("figure_2b")
    figure, axes = style.subplots(figsize=(5.6, 4.2))
    for name, line, its in _branches(data):
        label = f"at impact, {name} gait"
        axes.plot(its["angle_degrees"], its["impact_friction"], line, color=style.CURVE, label=label)
    its = data.sort_values("angle_degrees")
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


def _stance(slip: PageRunner) -> NDArray[np.float64]:
    """Position and velocity of the mass relative to the foot along a stance: a row for each."""
    step = classic_slip.step(slip, HEIGHT)
    times = step.touchdown_time + step.stance_time * np.linspace(0.0, 1.0, POINTS)
    return classic_slip.path(slip, HEIGHT, times)


def slip_table(_: Results) -> pandas.DataFrame:
    """Data of figure 3 by column, a row for each panel."""
    friction, early = _early()
    slip = classic_slip.slip(TOUCHDOWN_ANGLE)
    needed = classic_slip.step(slip, HEIGHT).impact_friction
    at = np.stack([_stance(slip)[:, 0], early[:, -1], _stance(slip)[:, 0]], axis=1)
    frictions = [MARGIN * math.tan(TOUCHDOWN_ANGLE), friction, needed]
    state = dict(zip(("x", "y", "vx", "vy"), at, strict=True))
    return pandas.DataFrame({"panel": ["a", "b", "c"], "friction": frictions, **state})


def draw_slip(_: Results) -> Figure:
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
