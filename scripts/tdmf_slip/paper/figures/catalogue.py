"""All figures of the paper and our own, each with its data as CSV."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, partial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ...analysis.attraction import Attraction, measure_all
from ...analysis.search import periodic_gait
from ...analysis.stability import StabilityMap
from ...analysis.sweeps import Row, sweep_row
from ...errors import InputError
from ...library.gait import Gait
from ...library.runner import Runner
from ...pictures import style
from ...pictures.panels import Stride
from ...terminal.progress import progress_bar
from ...variables.parameters import read_parameters
from ...variables.table import FRICTION
from .. import guinea_fowl as slippery
from .. import matched
from ..claims import READINGS
from ..evidence import SWEPT
from . import (
    attraction,
    columns,
    energy,
    falling_friction,
    feedback,
    figure_1,
    figure_2,
    figure_3,
    figure_4,
    figure_5,
    figure_6,
    figure_7,
    figure_8,
    figure_9,
    guinea_fowl,
    optimal,
    reduced,
    retraction,
    rough,
    slippery_patch,
    slope,
    thrust,
    viability,
)

if TYPE_CHECKING:
    import xarray
from .columns import Columns, write_columns

FORMATS = ("png", "svg", "pdf")
"""Formats of the files."""
MEASURED = 26
"""Number of gaits whose region of attraction is measured."""
EQUAL, MEASURED_EQUAL = 48, 12
"""Number of matched gaits, and of those whose region of attraction is measured."""
CLAMP = "hip.swing_clamp"
STRIDE_COLUMNS = (
    "time",
    "com.y",
    "foot.x",
    "foot.y",
    "foot.vx",
    "leg.length",
    "leg.angle",
    "contact.fx",
    "contact.fy",
    "contact.mode",
)


@dataclass(frozen=True)
class Figure:
    """Functions that draw a figure and give its data."""

    draw: Callable[[Path], None]
    """Draws the figure into a file."""
    table: Callable[[], Columns]
    """Returns the data of the figure by column."""


def draw(
    folder: Path,
    *,
    only: Sequence[str] = ("",),
    measure: bool = False,
    formats: Sequence[str] = ("png", "svg"),
    appearance: style.Appearance = style.DESIGNED,
    progress: bool = False,
) -> list[Path]:
    """Draw the figures whose names begin with one of `only` into a folder."""
    known = _figures(measure)
    for begin in only:
        if not any(name.startswith(begin) for name in known):
            raise InputError(f"only {begin}: no such figure; allowed: {', '.join(known)}")
    chosen = {name: figure for name, figure in known.items() if name.startswith(tuple(only))}
    folder.mkdir(exist_ok=True)
    written = []
    with (
        style.appearing(appearance),
        progress_bar("figures", len(chosen), "figures", progress) as bar,
    ):
        for name, figure in chosen.items():
            for suffix in formats:
                figure.draw(folder / f"{name}.{suffix}")
                written.append(folder / f"{name}.{suffix}")
            write_columns(folder / f"{name}.csv", figure.table())
            written.append(folder / f"{name}.csv")
            bar.update()
    return written


def _figures(measure: bool = False) -> dict[str, Figure]:
    runner = Runner(read_parameters("paper"))

    @cache
    def stride(friction: float, clamp: bool = False) -> Stride:
        given = runner.replace({FRICTION: friction, CLAMP: clamp})
        return Stride(periodic_gait(given))

    both = [partial(stride, figure_5.FRICTION, clamp) for clamp in READINGS.values()]

    @cache
    def gaits() -> Row:
        return sweep_row(runner, FRICTION, SWEPT)

    @cache
    def measured() -> list[Attraction]:
        found = gaits().gaits
        chosen = [found[i] for i in np.linspace(0, len(found) - 1, MEASURED).round().astype(int)]
        return measure_all(chosen)

    @cache
    def equal() -> list[Gait]:
        return matched.over_friction(gaits().gaits, EQUAL)

    @cache
    def measured_equal() -> list[Attraction]:
        return measure_all(equal()[:: EQUAL // MEASURED_EQUAL])

    retracting = cache(lambda: retraction.branches(runner))
    alike = cache(lambda: retraction.matched(runner))

    @cache
    def gaits_of_both() -> dict[str, Row]:
        return {"full": gaits(), "reduced": sweep_row(Runner(runner, model="reduced"), FRICTION, SWEPT)}

    @cache
    def regions() -> dict[str, "xarray.Dataset"]:
        return reduced.regions(runner)

    @cache
    def planes() -> tuple[StabilityMap, StabilityMap]:
        return reduced.planes(runner)

    @cache
    def optima() -> Columns:
        return (
            optimal.table(optimal.measure(runner, progress=True)) if measure else columns.columns("optimal")
        )

    @cache
    def roughness() -> Columns:
        return rough.table(rough.measure(runner, progress=True)) if measure else columns.columns("rough")

    @cache
    def feedbacks() -> Columns:
        if measure:
            return feedback.table(feedback.measure(runner, progress=True))
        return columns.columns("feedback")

    @cache
    def slopes() -> Columns:
        return (
            slope.table(slope.gaits(runner), slope.matched(runner)) if measure else columns.columns("slope")
        )

    @cache
    def thrusts() -> Columns:
        return thrust.table(thrust.gaits(runner)) if measure else columns.columns("thrust")

    @cache
    def patches() -> Columns:
        return slippery_patch.measure(runner) if measure else columns.columns("slippery_patch")

    @cache
    def falling() -> Columns:
        return falling_friction.measure(runner) if measure else columns.columns("falling_friction")

    @cache
    def saved() -> Columns:
        if measure:
            return viability.table(viability.measure(Runner(runner, model="reduced"), progress=True))
        return columns.columns("viability")

    falls = cache(slippery.fall_map)

    first, second = figure_8.FRICTIONS
    return {
        "figure_1b": Figure(figure_1.draw, figure_1.table),
        "figure_2a": Figure(figure_2.draw_maps, figure_2.map_table),
        "figure_2b": Figure(figure_2.draw_gaits, figure_2.gait_table),
        "figure_3": Figure(figure_3.draw, figure_3.table),
        "figure_4a": Figure(figure_4.draw, figure_2.gait_table),
        "figure_5": Figure(
            lambda path: figure_5.draw(path, *(one() for one in both)),
            lambda: _stride_table([one() for one in both]),
        ),
        "figure_6": _of_stride(figure_6.draw, stride, figure_6.FRICTION),
        "figure_7": _of_stride(figure_7.draw, stride, figure_7.FRICTION),
        "figure_8": Figure(
            lambda path: figure_8.draw(path, (stride(first), stride(second))),
            lambda: _stride_table([stride(first), stride(second)]),
        ),
        "figure_9": Figure(
            lambda path: figure_9.draw(path, gaits(), equal()), lambda: figure_9.table(gaits(), equal())
        ),
        "attraction": Figure(
            lambda path: attraction.draw(path, gaits(), measured(), measured_equal()),
            lambda: attraction.table(measured(), measured_equal()),
        ),
        "energy": Figure(
            lambda path: energy.draw(path, gaits(), equal()), lambda: energy.table(gaits().gaits, equal())
        ),
        "falling_friction": Figure(lambda path: falling_friction.draw(path, falling()), falling),
        "feedback": Figure(lambda path: feedback.draw(path, feedbacks()), feedbacks),
        "optimal": Figure(lambda path: optimal.draw(path, optima()), optima),
        "retraction": Figure(
            lambda path: retraction.draw(path, retracting(), alike()),
            lambda: retraction.table(retracting(), alike()),
        ),
        "rough": Figure(lambda path: rough.draw(path, roughness()), roughness),
        "slope": Figure(lambda path: slope.draw(path, slopes()), slopes),
        "guinea_fowl": Figure(
            lambda path: guinea_fowl.draw(path, falls()), lambda: guinea_fowl.table(falls())
        ),
        "slippery_patch": Figure(lambda path: slippery_patch.draw(path, patches()), patches),
        "thrust": Figure(lambda path: thrust.draw(path, thrusts()), thrusts),
        "viability": Figure(lambda path: viability.draw(path, saved()), saved),
        "reduced_region": Figure(
            lambda path: reduced.draw_regions(path, regions()), lambda: reduced.region_table(regions())
        ),
        "reduced_eigenvalues": Figure(
            lambda path: reduced.draw_eigenvalues(path, gaits_of_both()),
            lambda: reduced.eigenvalue_table(gaits_of_both()),
        ),
        "reduced_stability": Figure(
            lambda path: reduced.draw_planes(path, planes()), lambda: reduced.plane_table(planes())
        ),
    }


def _of_stride(
    drawing: Callable[[Path, Stride], None], stride: Callable[[float], Stride], friction: float
) -> Figure:
    return Figure(lambda path: drawing(path, stride(friction)), lambda: _stride_table([stride(friction)]))


def _stride_table(strides: Sequence[Stride]) -> Columns:
    """Recorded rows of strides in the paper's units, preceded by friction and reading of the gait."""
    lengths = [len(stride.time) for stride in strides]
    rows = {
        "friction": np.repeat([stride.gait.friction for stride in strides], lengths),
        "swing_clamp": np.repeat([int(stride.gait.runner[CLAMP]) for stride in strides], lengths),
    }
    return rows | {name: np.concatenate([s[name] for s in strides]) for name in STRIDE_COLUMNS}
