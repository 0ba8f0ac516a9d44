"""Figures 1 to 4: the classic SLIP over a step, its return maps and gaits, and a massless foot that slips."""

import math
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Polygon
from numpy.typing import NDArray

from ...library import classic_slip
from ...library.page import PageMap
from ...pictures import style
from ..evidence import SLIP_ANGLE, gather_classic
from ..published import IMPACT_FRICTION, STANCE_FRICTION
from .columns import Columns, attributes

COILS = 7
POINTS = 60
"""Points of each phase of a step."""


@dataclass(frozen=True, eq=False)
class Step:
    """One step of the classic SLIP from apex to apex, with the foot at x = 0."""

    time: NDArray[np.float64]
    """Time since the apex."""
    x: NDArray[np.float64]
    """Horizontal position of the mass."""
    y: NDArray[np.float64]
    """Height of the mass."""
    phase: list[str]
    """Phases: fall, stance or rise."""


def _step(slip: PageMap, height: float) -> Step:
    """Path of the mass from one apex to the next."""
    step = classic_slip.step(slip, height)
    ends = np.cumsum([0.0, step.touchdown_time, step.stance_time])
    times = np.linspace(ends, [*ends[1:], step.time], POINTS).T.ravel()
    x, y, *_ = classic_slip.path(slip, height, times)
    phases = [phase for phase in ("fall", "stance", "rise") for _ in range(POINTS)]
    return Step(times, x, y, phases)


def _leg(
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


def _ground(axes: Axes) -> None:
    """Draw the ground line, and set axes of equal scale."""
    axes.axhline(0.0, color=style.GROUND, linewidth=3.0, zorder=0)
    axes.set_aspect("equal")
    style.label(axes, "x (m)", "y (m)")


ANGLE = math.radians(40.0)
SHOWN = (0, 1, 2, 3, 4)
"""Indices of the snapshots in stance."""


def step_table() -> Columns:
    """Path of the mass over a step of the stable gait at 40 degrees, with the foot at x = 0."""
    step = _stable_step()
    return {"time": step.time, "x": step.x, "y": step.y, "phase": step.phase}


def _stable_step() -> Step:
    return _step(classic_slip.slip(ANGLE), classic_slip.fixed_points(ANGLE)[0].height)


def draw_step(path: Path) -> None:
    """Draw figure 1(b): the path, and the leg at five instants of the stance and at both apices."""
    step = _stable_step()
    with style.styled():
        figure, axes = style.subplots(figsize=(8.0, 3.6))
        _ground(axes)
        axes.plot(step.x, step.y, color=style.SECOND_CURVE, linestyle="--", linewidth=1.2)
        stance = [i for i, phase in enumerate(step.phase) if phase == "stance"]
        for i in (stance[round(s * (len(stance) - 1) / 4)] for s in SHOWN):
            _leg(axes, (0.0, 0.0), (step.x[i], step.y[i]))
        reach = np.array([math.sin(ANGLE), -math.cos(ANGLE)])
        for i in (0, -1):
            mass = np.array([step.x[i], step.y[i]])
            _leg(axes, tuple(mass + reach), tuple(mass), style.FAINT)
        axes.set_ylim(-0.1, 1.25)
        style.save(figure, path)


ANGLES = (38.0, 40.0, 42.0, 44.0)
"""Touchdown angles of the maps, degrees."""
COLOURS = ("#9bb8d3", "#1f5fa8", "#e07b00", "#b3216f")
MAP_POINTS = 400
SWEPT = 44.588 - 13.288 * np.linspace(1.0, 0.0, 100) ** 2
"""Touchdown angles of the gaits, degrees, closer together towards the fold."""


def map_table() -> Columns:
    """Return maps by column: apex height and next apex height, m."""
    columns: dict[str, list[Any]] = {"angle_degrees": [], "height": [], "next_height": [], "forwards": []}
    for angle in ANGLES:
        parameters = classic_slip.slip(math.radians(angle))
        for height in classic_slip.heights(parameters, MAP_POINTS):
            step = classic_slip.step(parameters, height)
            if step.outcome in (classic_slip.FLIES, classic_slip.TURNS_BACK):
                forwards = step.outcome == classic_slip.FLIES
                for name, value in zip(columns, (angle, height, step.next_height, forwards), strict=True):
                    columns[name].append(value)
    return columns


@cache
def gait_table() -> Columns:
    """Gaits against the touchdown angle by column; the last one is the fold."""
    gaits = [g for angle in SWEPT for g in classic_slip.fixed_points(math.radians(angle))]
    gaits.append(classic_slip.fold())
    return {
        "angle_degrees": [math.degrees(gait.angle) for gait in gaits],
        **attributes(gaits, "height", "slope", "stance_friction", "impact_friction"),
    }


def draw_maps(path: Path) -> None:
    """Draw figure 2(a): return maps at four touchdown angles."""
    data = {name: np.array(values) for name, values in map_table().items()}
    with style.styled():
        figure, axes = style.subplots(figsize=(5.6, 5.2))
        for angle, colour in zip(ANGLES, COLOURS, strict=True):
            chosen = data["angle_degrees"] == angle
            for forwards, line in ((True, "-"), (False, ":")):
                rows = chosen & (data["forwards"] == forwards)
                label = rf"$\theta_0$ = {angle:g}°" if forwards else None
                axes.plot(
                    data["height"][rows],
                    _cut(data["next_height"][rows], data["height"][rows]),
                    line,
                    color=colour,
                    label=label,
                )
            for gait in classic_slip.fixed_points(math.radians(angle)):
                axes.plot(gait.height, gait.height, "^" if gait.stable else "s", color=colour, markersize=7)
        _diagonal(axes)
        axes.legend(title="▲ stable   ■ unstable\n… runs backwards", loc="upper left")
        style.label(axes, "apex height (m)", "next apex height (m)")
        style.save(figure, path)


def _cut(values: NDArray[np.float64], at: NDArray[np.float64]) -> NDArray[np.float64]:
    """Insert a gap where the curve is not connected."""
    cut = values.copy()
    if len(at) > 1:
        cut[np.flatnonzero(np.diff(at) > 2.0 * np.median(np.diff(at))) + 1] = np.nan
    return cut


def _diagonal(axes: Axes) -> None:
    top = classic_slip.highest(classic_slip.slip(math.radians(ANGLES[0])))
    axes.plot([0.5, top], [0.5, top], color=style.FAINT, linestyle="-.", linewidth=1.0, zorder=1)
    axes.set_xlim(0.5, 5.5)
    axes.set_ylim(0.5, 8.0)


def _branches(data: Columns) -> list[tuple[str, NDArray[np.float64]]]:
    """Rows of the stable and of the unstable gaits, each with the fold."""
    slope = np.array(data["slope"])
    fold = len(slope) - 1
    stable = np.flatnonzero(np.abs(slope[:-1]) < 1.0)
    unstable = np.flatnonzero(slope[:-1] >= 1.0)
    return [("stable", np.append(stable, fold)), ("unstable", np.append(unstable, fold))]


def draw_gaits(path: Path) -> None:
    """Draw figure 2(b): apex heights of gaits against the touchdown angle."""
    data = gait_table()
    with style.styled():
        figure, axes = style.subplots(figsize=(5.6, 4.2))
        for (name, rows), line in zip(_branches(data), ("-", "--"), strict=True):
            angles = np.array(data["angle_degrees"])[rows]
            axes.plot(angles, np.array(data["height"])[rows], line, color=style.CURVE, label=name)
        angle, height = data["angle_degrees"][-1], data["height"][-1]
        axes.plot(angle, height, "o", color=style.SECOND_CURVE, label=f"fold at {angle:.2f}°")
        lowest = gather_classic().lowest
        angle, height = math.degrees(lowest), classic_slip.fixed_points(lowest)[0].height
        axes.plot(angle, height, "s", color=style.SECOND_CURVE, label=f"period doubling at {angle:.2f}°")
        axes.legend()
        style.label(axes, r"touchdown angle $\theta_0$ (°)", "apex height $y^*$ (m)")
        style.save(figure, path)


def draw_friction(path: Path) -> None:
    """Draw figure 4(a): friction that gaits need in stance and at the impact of a small foot."""
    data = gait_table()
    with style.styled():
        figure, axes = style.subplots(figsize=(5.6, 4.2))
        for (name, rows), line in zip(_branches(data), ("-", "--"), strict=True):
            angles = np.array(data["angle_degrees"])[rows]
            needed = np.array(data["impact_friction"])[rows]
            axes.plot(angles, needed, line, color=style.CURVE, label=f"at impact, {name} gait")
        order = np.argsort(data["angle_degrees"])
        angles = np.array(data["angle_degrees"])[order]
        stance = np.array(data["stance_friction"])[order]
        axes.plot(angles, stance, "-.", color=style.SECOND_CURVE, label=r"in stance: $\tan\theta_0$")
        axes.plot([SLIP_ANGLE] * 2, [STANCE_FRICTION, IMPACT_FRICTION], **style.PUBLISHED)
        axes.set_ylim(0.0, 6.0)
        axes.legend()
        style.label(axes, r"touchdown angle $\theta_0$ (°)", "friction needed μ")
        style.save(figure, path)


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


def slip_table() -> Columns:
    """Data of figure 3 by column, a row for each panel."""
    friction, early = _early()
    slip = classic_slip.slip(TOUCHDOWN_ANGLE)
    needed = classic_slip.step(slip, HEIGHT).impact_friction
    at = np.stack([_stance(slip)[:, 0], early[:, -1], _stance(slip)[:, 0]], axis=1).tolist()
    return {
        "panel": ["a", "b", "c"],
        "friction": [MARGIN * math.tan(TOUCHDOWN_ANGLE), friction, needed],
        **dict(zip(("x", "y", "vx", "vy"), at, strict=True)),
    }


def draw_slip(path: Path) -> None:
    """Draw figure 3: a massless foot that slips at touchdown and in stance, and the cone of an impact."""
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
    _leg(axes, (foot, 0.0), (x, y), style.FAINT, linestyle=":")
    axes.annotate("", (foot, -0.12), (0.0, -0.12), arrowprops={"arrowstyle": "-|>", "color": "#e07b00"})


def _touchdown(axes: Axes) -> None:
    _ground(axes)
    axes.set_title("(a) outside the cone at touchdown:\nthe foot slides out, the mass falls")
    _cone(axes, MARGIN * math.tan(TOUCHDOWN_ANGLE))
    x, y, *velocity = _stance(classic_slip.slip(TOUCHDOWN_ANGLE))[:, 0]
    x, y = COMPRESSED * x, COMPRESSED * y
    _leg(axes, (0.0, 0.0), (x, y))
    _extended(axes, x, y, 1.0)
    _velocity(axes, x, y, *velocity)


def _take_off(axes: Axes) -> None:
    friction, path = _early()
    _ground(axes)
    axes.set_title("(b) reaching its edge in stance:\nan early take-off")
    _cone(axes, friction)
    axes.plot(path[0], path[1], color=style.SECOND_CURVE, linestyle="--", linewidth=1.2)
    x, y, *velocity = path[:, -1]
    _leg(axes, (0.0, 0.0), (x, y))
    _extended(axes, x, y, -1.0)
    _velocity(axes, x, y, *velocity)


def _impact(axes: Axes) -> None:
    _ground(axes)
    axes.set_title("(c) a foot with mass sticks if its\nvelocity points into the cone")
    slip, foot = classic_slip.slip(TOUCHDOWN_ANGLE), (0.0, 0.3)
    x, y, *velocity = _stance(slip)[:, 0]
    axes.add_patch(Polygon([foot, (-0.3, 0.0), (0.3, 0.0)], color="#dce7c8", linewidth=0, zorder=0))
    _leg(axes, foot, (foot[0] + x, foot[1] + y))
    axes.plot(*foot, "o", color=style.INK, markersize=5)
    _velocity(axes, *foot, *velocity)
    axes.annotate(
        f"needs μ ≥ {classic_slip.step(slip, HEIGHT).impact_friction:.2f}", (0.42, 0.16), fontsize=8.5
    )
