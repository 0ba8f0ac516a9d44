"""All figures of the paper and our own, each with its data as CSV."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import pandas
from matplotlib.figure import Figure

from ...errors import InputError
from ...files.whole import whole
from ...pictures import style
from ...terminal.progress import progress_bar
from . import (
    attraction,
    classic,
    falling_friction,
    feedback,
    guinea_fowl,
    optimal,
    over_friction,
    reduced,
    retraction,
    rough,
    slippery_patch,
    slope,
    snapshots,
    strides,
    thrust,
    viability,
)
from .data import Results


class Entry(NamedTuple):
    """Data and drawing of a figure."""

    table: Callable[[Results], pandas.DataFrame]
    """Computes the data that are written as CSV, or stored."""
    draw: Callable[[Results], Figure]
    """Draws the figure."""


FIGURES: Mapping[str, Entry] = {
    "figure_1b": Entry(classic.step_table, classic.draw_step),
    "figure_2a": Entry(classic.map_table, classic.draw_maps),
    "figure_2b": Entry(classic.gait_table, classic.draw_gaits),
    "figure_3": Entry(classic.slip_table, classic.draw_slip),
    "figure_4a": Entry(lambda results: results.table("figure_2b"), classic.draw_friction),
    "figure_5": Entry(partial(strides.table, strides.STICKING), strides.draw_sticking),
    "figure_6": Entry(partial(strides.table, strides.LANDING), partial(strides.draw, strides.LANDING)),
    "figure_7": Entry(
        partial(strides.table, strides.THREE_SLIPS), partial(strides.draw, strides.THREE_SLIPS)
    ),
    "figure_8": Entry(partial(strides.table, strides.LOW), strides.draw_low),
    "snapshots": Entry(partial(strides.table, snapshots.SHOWN), snapshots.draw),
    "figure_9": Entry(over_friction.figure_9_table, over_friction.draw_figure_9),
    "attraction": Entry(attraction.table, attraction.draw),
    "energy": Entry(over_friction.energy_table, over_friction.draw_energy),
    "guinea_fowl": Entry(guinea_fowl.table, guinea_fowl.draw),
    "retraction": Entry(retraction.table, retraction.draw),
    "reduced_region": Entry(reduced.region_table, reduced.draw_regions),
    "reduced_eigenvalues": Entry(reduced.eigenvalue_table, reduced.draw_eigenvalues),
    "reduced_stability": Entry(reduced.plane_table, reduced.draw_planes),
    "falling_friction": Entry(falling_friction.table, falling_friction.draw),
    "feedback": Entry(feedback.table, feedback.draw),
    "optimal": Entry(optimal.table, optimal.draw),
    "rough": Entry(rough.table, rough.draw),
    "slippery_patch": Entry(slippery_patch.table, slippery_patch.draw),
    "slope": Entry(slope.table, slope.draw),
    "thrust": Entry(thrust.table, thrust.draw),
    "viability": Entry(viability.table, viability.draw),
}
"""All figures by name. Data that take minutes are stored as `NAME.csv` in this folder."""
FORMATS = ("png", "svg", "pdf")
"""Formats of the files."""
GALLERY = ("figure_5", "figure_6", "figure_7", "figure_8", "figure_9", "snapshots")
"""Figures that `validate --pictures` draws."""


def results(measure: bool = False) -> Results:
    """Results for the figures; with `measure`, stored data are computed anew."""
    return Results({name: entry.table for name, entry in FIGURES.items()}, measure)


def draw(
    folder: Path,
    *,
    only: Sequence[str] = ("",),
    measure: bool = False,
    formats: Sequence[str] = ("png", "svg"),
    look: str = "house",
    width: float | None = None,
    dots_per_inch: float | None = None,
    progress: bool = False,
) -> list[Path]:
    """Draw the figures whose names begin with one of `only` into a folder.

    `look` is one of `style.STYLES`; width, in inches, and resolution are by default those of each figure.
    """
    how: dict[str, Any] = {"look": look, "width": width, "dots_per_inch": dots_per_inch}
    for begin in only:
        if not any(name.startswith(begin) for name in FIGURES):
            raise InputError(f"--only {begin}: no such figure; allowed: {', '.join(FIGURES)}")
    chosen, found = [name for name in FIGURES if name.startswith(tuple(only))], results(measure)
    folder.mkdir(exist_ok=True)
    written: list[Path] = []
    with progress_bar("figures", len(chosen), "figures", progress) as bar:
        for name in chosen:
            paths, data = [folder / f"{name}.{suffix}" for suffix in formats], folder / f"{name}.csv"
            _write(partial(FIGURES[name].draw, found), *paths, **how)
            with whole(data) as beside:
                found.table(name).to_csv(beside, index=False, lineterminator="\n")
            written += [*paths, data]
            bar.update()
    return written


def _write(draw: Callable[[], Figure], *paths: Path, look: str = "house", **how: float | None) -> None:
    """Draw a figure, and write it into files."""
    with style.styled(look):
        figure = draw()
        for path in paths:
            style.save(figure, path, **how)
