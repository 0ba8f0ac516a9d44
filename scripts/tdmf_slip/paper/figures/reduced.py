"""The reduced map beside the full model: regions of attraction, eigenvalues and stability."""

from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh
from matplotlib.colors import TwoSlopeNorm
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import NDArray

from ...analysis.basin import basin
from ...analysis.stability import stability
from ...analysis.sweeps import sweep
from ...library.runner import Runner
from ...pictures import basin_map, style
from ...variables.table import FRICTION
from ..evidence import SWEPT
from .data import Results
from .over_friction import TICKS, friction_axis, mark_words

if TYPE_CHECKING:
    import xarray

PLANE = {"com_height": (0.6, 4.0), "com_speed": (-1.0, 2.5)}
"""Ranges of height and speed for regions of attraction, l0 and l0 sqrt(k/m)."""
STARTS = 137, 141
"""Number of starts along each axis."""
ANGLES = np.radians(np.linspace(20.0, 70.0, 81))
DAMPINGS = np.linspace(0.0, 0.6, 61)
"""Damping, sqrt(m k)."""
RETRACTED_ANGLE = np.radians(45.0)
RETRACTIONS = np.linspace(-0.02, 0.02, 81)
"""Retraction rates, sqrt(k/m)."""
FRICTIONS = np.geomspace(0.05, 5.0, 61)
COLOURS = {"full": style.CURVE, "reduced": "#e07b00"}
COORDINATES = {"full": "full model, six coordinates", "reduced": "reduced map, two coordinates"}
TITLES = {"full": "(a) full model", "reduced": "(b) reduced map"}


@cache
def regions(results: Results) -> dict[str, "xarray.Dataset"]:
    """Regions of attraction of both models; that of the full model is a slice."""
    return {name: basin(results.runner, PLANE, STARTS, model=name) for name in ("full", "reduced")}


def region_table(results: Results) -> pandas.DataFrame:
    """Fate and number of strides of all starts."""
    tables = [
        data[["fate", "strides_until_known"]].to_dataframe().add_suffix(f"_{name}")
        for name, data in regions(results).items()
    ]
    return pandas.concat(tables, axis=1).reset_index()


def draw_regions(results: Results) -> Figure:
    """Draw the full model's slice and the reduced map's plane, one beside the other."""
    figure, panels = style.subplots(1, 2, figsize=(8.6, 4.9), sharey=True)
    handles: dict[object, Artist] = {}
    for panel, (name, data) in zip(panels, regions(results).items(), strict=True):
        handles |= {handle.get_label(): handle for handle in basin_map.paint(panel, data)}
        panel.set_title(f"{TITLES[name]}: {data.settled_share:.1%} of starts settle")
    panels[1].set_ylabel("")
    figure.legend(handles=list(handles.values()), loc="outside lower center", ncols=len(handles))
    return figure


def eigenvalue_table(results: Results) -> pandas.DataFrame:
    """The two largest eigenvalues of both models by friction."""
    reduced = sweep(Runner(results.runner, model="reduced"), {FRICTION: SWEPT}).gaits
    columns: dict[str, Any] = {"friction": SWEPT}
    for name, gaits in {"full": results.sweep.gaits, "reduced": reduced}.items():
        columns[f"word_{name}"] = gaits["word"].values
        for number in (1, 2):
            columns[f"eigenvalue_{number}_{name}"] = gaits["eigenvalue_real"].values[:, number - 1]
    return pandas.DataFrame(columns)


def draw_eigenvalues(results: Results) -> Figure:
    """Draw the two largest eigenvalues of both models against friction, and how far apart they are."""
    data = results.table("reduced_eigenvalues")
    friction = data["friction"]
    figure, axes = style.subplots(3, 1, figsize=(7.6, 8.0), sharex=True, height_ratios=(3, 3, 2))
    for panel, number in zip(axes, (1, 2), strict=False):
        for name, dashes in (("full", "-"), ("reduced", (0, (4, 2)))):
            values, label = data[f"eigenvalue_{number}_{name}"], COORDINATES[name]
            panel.plot(friction, values, color=COLOURS[name], linestyle=dashes, label=label)
    axes[0].set_title("(a) largest eigenvalue, of speed", pad=18)
    axes[1].set_title("(b) second eigenvalue, of height")
    axes[0].legend(loc="lower left")
    for number, colour in ((1, style.CURVE), (2, style.SECOND_CURVE)):
        reduced, full = (data[f"eigenvalue_{number}_{name}"] for name in ("reduced", "full"))
        label = f"{('largest', 'second')[number - 1]} eigenvalue"
        axes[2].semilogy(friction, np.abs(reduced - full), color=colour, label=label)
    axes[2].set_title("(c) absolute difference between the two models")
    axes[2].legend(loc="center right")
    mark_words(axes, results.sweep)
    friction_axis(axes[-1], data["friction"])
    return figure


@cache
def planes(results: Results) -> "tuple[xarray.Dataset, xarray.Dataset]":
    """Stability of the reduced map by touchdown angle and damping, and by retraction rate and friction."""
    small = Runner(results.runner, model="reduced")
    return (
        stability(small, {"leg.damping": DAMPINGS, "hip.touchdown_angle": ANGLES}),
        stability(
            small.replace({"hip.touchdown_angle": RETRACTED_ANGLE}),
            {FRICTION: FRICTIONS, "hip.retraction_rate": RETRACTIONS},
        ),
    )


def plane_table(results: Results) -> pandas.DataFrame:
    """Data of both planes: parameters, largest eigenvalue and word."""
    tables = []
    for one in planes(results):
        first, second = map(str, one["word"].dims)
        table = one[["lambda_max", "word"]].to_dataframe().reset_index()
        table.insert(0, "first_parameter", first)
        table.insert(2, "second_parameter", second)
        tables.append(table.rename(columns={first: "first_value", second: "second_value"}))
    return pandas.concat(tables, ignore_index=True)


def draw_planes(results: Results) -> Figure:
    """Draw the largest eigenvalue over both planes, with the border of stability."""
    first, second = maps = planes(results)
    shares = [float((one["lambda_max"] < 1.0).mean()) for one in maps]
    figure, (left, right) = style.subplots(1, 2, figsize=(8.4, 4.5))
    mesh = _draw_plane(left, first, np.degrees(ANGLES), DAMPINGS)
    left.set_title(f"(a) friction 0.6: {shares[0]:.0%} of the plane has a stable gait")
    style.label(left, "touchdown angle θ₀ (°)", "damping c (√(mk))")
    _draw_plane(right, second, RETRACTIONS, FRICTIONS)
    right.set_yscale("log")
    right.set_title(f"(b) touchdown angle 45°: {shares[1]:.0%} has a stable gait")
    style.label(right, "retraction rate ω (√(k/m))", "friction coefficient μ")
    right.set_yticks(TICKS[:-1], [f"{tick:g}" for tick in TICKS[:-1]])
    right.minorticks_off()
    right.set_xticks([-0.02, -0.01, 0.0, 0.01, 0.02])
    figure.colorbar(mesh, ax=(left, right), label="modulus of the largest eigenvalue", pad=0.01)
    border = Line2D([], [], color=style.INK, linewidth=1.2, label="modulus 1: border of stability")
    missing = Patch(color=style.GROUND, label="no gait found")
    figure.legend(handles=[border, missing], loc="outside lower center", ncols=2)
    return figure


def _draw_plane(
    axes: Axes, one: "xarray.Dataset", across: NDArray[np.float64], up: NDArray[np.float64]
) -> QuadMesh:
    """Paint stable gaits blue and unstable ones red; grey marks where no gait was found."""
    axes.set_facecolor(style.GROUND)
    shown = np.ma.masked_invalid(one["lambda_max"].values)
    scale = TwoSlopeNorm(1.0, 0.5, 1.5)
    mesh = axes.pcolormesh(across, up, shown, cmap="RdBu_r", norm=scale, shading="nearest", rasterized=True)
    if shown.min() < 1.0 < shown.max():
        axes.contour(across, up, shown, [1.0], colors=style.INK, linewidths=1.2)
    axes.spines[["top", "right"]].set_visible(True)
    return mesh
