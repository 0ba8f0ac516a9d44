"""All figures of the paper and our own, each with its data as CSV."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from ...analysis.search import periodic_gait
from ...analysis.sweeps import Row, sweep_row
from ...errors import InputError
from ...feedback.judgement import Judgement, judge_all
from ...library.gait import Gait
from ...library.runner import Runner
from ...pictures import animation, model, style
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
    classic,
    energy,
    falling_friction,
    feedback,
    figure_9,
    guinea_fowl,
    optimal,
    reduced,
    retraction,
    rough,
    slippery_patch,
    slope,
    strides,
    thrust,
    viability,
)
from .columns import Data, as_columns, columns, write_columns

if TYPE_CHECKING:
    import xarray

STORED: Mapping[str, Any] = {
    "falling_friction": falling_friction,
    "feedback": feedback,
    "optimal": optimal,
    "rough": rough,
    "slippery_patch": slippery_patch,
    "slope": slope,
    "thrust": thrust,
    "viability": viability,
}
"""Modules of figures whose data takes minutes to measure, and is stored."""
FORMATS = ("png", "svg", "pdf")
"""Formats of the files."""
MEASURED = 26
"""Number of gaits whose region of attraction is measured."""
EQUAL, MEASURED_EQUAL = 48, 12
"""Number of matched gaits, and of those whose region of attraction is measured."""
CLAMP = "hip.swing_clamp"
PAPERS_GAITS = [f"figure_{number}" for number in range(5, 10)]
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
class Entry:
    """A figure: how it is drawn, and its data."""

    draw: Callable[[], Figure]
    """Draws the figure."""
    table: Callable[[], Data]
    """Returns the data of the figure by column."""


def _entry(draw: Callable[..., Figure], table: Callable[..., Data], *results: Callable[[], Any]) -> Entry:
    """A figure whose drawing and data take the same results."""
    return Entry(
        lambda: draw(*(result() for result in results)), lambda: table(*(result() for result in results))
    )


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
    known = _figures(measure)
    for begin in only:
        if not any(name.startswith(begin) for name in known):
            raise InputError(f"only {begin}: no such figure; allowed: {', '.join(known)}")
    chosen = {name: figure for name, figure in known.items() if name.startswith(tuple(only))}
    folder.mkdir(exist_ok=True)
    written = []
    with progress_bar("figures", len(chosen), "figures", progress) as bar:
        for name, figure in chosen.items():
            paths = [folder / f"{name}.{suffix}" for suffix in formats]
            _write(figure.draw, *paths, **how)
            written += paths
            write_columns(folder / f"{name}.csv", as_columns(figure.table()))
            written.append(folder / f"{name}.csv")
            bar.update()
    return written


def draw_gallery(folder: Path, progress: bool = False) -> list[Path]:
    """Draw figures 5 to 9 of the paper, one stride as snapshots and as an animation, and the model."""
    folder.mkdir(exist_ok=True)
    figures = _figures()
    stride = cache(lambda: Stride(periodic_gait(_paper_runner().replace({FRICTION: model.FRICTION}))))
    drawings: dict[str, Callable[[Path], None]] = {
        **{f"{name}.png": partial(_write, figures[name].draw) for name in PAPERS_GAITS},
        "snapshots.png": partial(_write, lambda: model.draw_snapshots(stride())),
        "stride.gif": lambda path: animation.draw(path, stride()),
        "model.png": partial(_write, model.draw, dots_per_inch=model.DOTS_PER_INCH),
    }
    with progress_bar("pictures", len(drawings), "", progress) as bar:
        for name, drawing in drawings.items():
            drawing(folder / name)
            bar.update()
    return [folder / name for name in drawings]


def _write(draw: Callable[[], Figure], *paths: Path, look: str = "house", **how: float | None) -> None:
    """Draw a figure, and write it into files."""
    with style.styled(look):
        figure = draw()
        for path in paths:
            style.save(figure, path, **how)


def _paper_runner() -> Runner:
    return Runner(read_parameters("paper"))


def _figures(measure: bool = False) -> dict[str, Entry]:
    runner = _paper_runner()

    @cache
    def stride(friction: float, clamp: bool = False) -> Stride:
        return Stride(periodic_gait(runner.replace({FRICTION: friction, CLAMP: clamp})))

    @cache
    def gaits() -> Row:
        return sweep_row(runner, FRICTION, SWEPT)

    @cache
    def measured() -> list[Judgement]:
        found = gaits().gaits
        chosen = [found[i] for i in np.linspace(0, len(found) - 1, MEASURED).round().astype(int)]
        return judge_all([(gait, None) for gait in chosen])

    @cache
    def equal() -> list[Gait]:
        return matched.over_friction(gaits().gaits, EQUAL)

    @cache
    def measured_equal() -> list[Judgement]:
        return judge_all([(gait, None) for gait in equal()[:: EQUAL // MEASURED_EQUAL]])

    @cache
    def gaits_of_both() -> dict[str, Row]:
        return {"full": gaits(), "reduced": sweep_row(Runner(runner, model="reduced"), FRICTION, SWEPT)}

    @cache
    def regions() -> "dict[str, xarray.Dataset]":
        return reduced.regions(runner)

    @cache
    def planes() -> "tuple[xarray.Dataset, xarray.Dataset]":
        return reduced.planes(runner)

    retracting = cache(lambda: retraction.branches(runner))
    alike = cache(lambda: retraction.matched(runner))

    def of_strides(
        drawing: Callable[..., Figure], frictions: Sequence[float], clamps: Sequence[bool] = (False,)
    ) -> Entry:
        its = [partial(stride, friction, clamp) for friction in frictions for clamp in clamps]
        return _entry(drawing, _stride_table, *its)

    def stored(name: str) -> Entry:
        module = STORED[name]
        data = cache(lambda: as_columns(module.measure(runner)) if measure else columns(name))
        return Entry(lambda: module.draw(data()), data)

    return {
        "figure_1b": Entry(classic.draw_step, classic.step_table),
        "figure_2a": Entry(classic.draw_maps, classic.map_table),
        "figure_2b": Entry(classic.draw_gaits, classic.gait_table),
        "figure_3": Entry(classic.draw_slip, classic.slip_table),
        "figure_4a": Entry(classic.draw_friction, classic.gait_table),
        "figure_5": of_strides(strides.draw_sticking, [strides.STICKS], list(READINGS.values())),
        "figure_6": of_strides(strides.draw, [strides.LANDING]),
        "figure_7": of_strides(strides.draw, [strides.THREE_SLIPS]),
        "figure_8": of_strides(strides.draw_low, strides.LOW),
        "figure_9": _entry(figure_9.draw, figure_9.table, gaits, equal),
        "attraction": Entry(
            lambda: attraction.draw(gaits(), measured(), measured_equal()),
            lambda: attraction.table(measured(), measured_equal()),
        ),
        "energy": Entry(lambda: energy.draw(gaits(), equal()), lambda: energy.table(gaits().gaits, equal())),
        "guinea_fowl": _entry(guinea_fowl.draw, guinea_fowl.table, cache(slippery.fall_map)),
        "retraction": _entry(retraction.draw, retraction.table, retracting, alike),
        "reduced_region": _entry(reduced.draw_regions, reduced.region_table, regions),
        "reduced_eigenvalues": _entry(reduced.draw_eigenvalues, reduced.eigenvalue_table, gaits_of_both),
        "reduced_stability": _entry(reduced.draw_planes, reduced.plane_table, planes),
        **{name: stored(name) for name in STORED},
    }


def _stride_table(*strides: Stride) -> Data:
    """Recorded rows of strides in the paper's units, preceded by friction and reading of the gait."""
    lengths = [len(stride.time) for stride in strides]
    rows = {
        "friction": np.repeat([stride.gait.friction for stride in strides], lengths),
        "swing_clamp": np.repeat([int(stride.gait.runner[CLAMP]) for stride in strides], lengths),
    }
    return rows | {name: np.concatenate([s[name] for s in strides]) for name in STRIDE_COLUMNS}
