"""All figures of the paper and our own, each with its data as CSV."""

import importlib
from collections.abc import Callable, Mapping, Sequence
from functools import cache, cached_property, partial
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
from ..evidence import SWEPT
from . import attraction, classic, energy, figure_9, guinea_fowl, reduced, retraction, strides
from .columns import Columns, Data, as_columns, columns, write_columns

if TYPE_CHECKING:
    import xarray

STORED = (
    "falling_friction",
    "feedback",
    "optimal",
    "rough",
    "slippery_patch",
    "slope",
    "thrust",
    "viability",
)
"""Modules of figures whose data takes minutes to measure, and is stored."""
FORMATS = ("png", "svg", "pdf")
"""Formats of the files."""
MEASURED = 26
"""Number of gaits whose region of attraction is measured."""
EQUAL, MEASURED_EQUAL = 48, 12
"""Number of matched gaits, and of those whose region of attraction is measured."""
CLAMP = "hip.swing_clamp"
GALLERY = ("figure_5", "figure_6", "figure_7", "figure_8", "figure_9")
"""Figures that `validate --pictures` draws."""
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
"""Recorded quantities in the data of figures of strides."""


class Results:
    """Results for the paper's runner that figures are drawn of, each computed when it is first asked for."""

    def __init__(self, measure: bool = False) -> None:
        """Read stored data, or measure it anew."""
        self.runner, self.measure = Runner(read_parameters("paper")), measure
        self.stride, self.stored = cache(self._stride), cache(self._stored)

    def _stride(self, friction: float, clamp: bool = False) -> Stride:
        return Stride(periodic_gait(self.runner.replace({FRICTION: friction, CLAMP: clamp})))

    def _stored(self, name: str) -> Columns:
        module = importlib.import_module(f".{name}", __package__)
        return as_columns(module.measure(self.runner)) if self.measure else columns(name)

    @cached_property
    def gaits(self) -> Row:
        """Gaits over friction."""
        return sweep_row(self.runner, FRICTION, SWEPT)

    @cached_property
    def equal(self) -> list[Gait]:
        """Gaits matched to the first one."""
        return matched.over_friction(self.gaits.gaits, EQUAL)

    @cached_property
    def attraction(self) -> tuple[Row, list[Judgement], list[Judgement]]:
        """Gaits over friction, what some of them attract, and what some of the matched gaits attract."""
        found = self.gaits.gaits
        chosen = [found[i] for i in np.linspace(0, len(found) - 1, MEASURED).round().astype(int)]
        equal = self.equal[:: EQUAL // MEASURED_EQUAL]
        judged, judged_equal = (judge_all([(gait, None) for gait in its]) for its in (chosen, equal))
        return self.gaits, judged, judged_equal

    @cached_property
    def retraction(self) -> tuple[Any, ...]:
        """Branches over the rate of retraction, and matched gaits."""
        return retraction.branches(self.runner), retraction.matched(self.runner)

    @cached_property
    def models(self) -> dict[str, Row]:
        """Gaits over friction of the full model and of the reduced map."""
        return {
            "full": self.gaits,
            "reduced": sweep_row(Runner(self.runner, model="reduced"), FRICTION, SWEPT),
        }

    @cached_property
    def fowl(self) -> slippery.Map:
        """Falls of runners of a guinea fowl's size."""
        return slippery.fall_map()

    @cached_property
    def regions(self) -> "dict[str, xarray.Dataset]":
        """Regions of attraction of both models."""
        return reduced.regions(self.runner)

    @cached_property
    def planes(self) -> "tuple[xarray.Dataset, xarray.Dataset]":
        """Stability of the reduced map over two planes of parameters."""
        return reduced.planes(self.runner)


def _stride_table(*strides: Stride) -> Data:
    """Recorded rows of strides in the paper's units, preceded by friction and reading of the gait."""
    lengths = [len(stride.time) for stride in strides]
    rows = {
        "friction": np.repeat([stride.gait.friction for stride in strides], lengths),
        "swing_clamp": np.repeat([int(stride.gait.runner[CLAMP]) for stride in strides], lengths),
    }
    return rows | {name: np.concatenate([s[name] for s in strides]) for name in STRIDE_COLUMNS}


Entry = tuple[Callable[..., Figure], Callable[..., Data], Callable[[Results], tuple[Any, ...]]]


def _stored(name: str) -> Entry:
    """A figure whose data is stored."""
    return (
        lambda data: importlib.import_module(f".{name}", __package__).draw(data),
        lambda data: data,
        lambda of: (of.stored(name),),
    )


FIGURES: Mapping[str, Entry] = {
    "figure_1b": (classic.draw_step, classic.step_table, lambda of: ()),
    "figure_2a": (classic.draw_maps, classic.map_table, lambda of: ()),
    "figure_2b": (classic.draw_gaits, classic.gait_table, lambda of: ()),
    "figure_3": (classic.draw_slip, classic.slip_table, lambda of: ()),
    "figure_4a": (classic.draw_friction, classic.gait_table, lambda of: ()),
    "figure_5": (
        strides.draw_sticking,
        _stride_table,
        lambda of: (of.stride(strides.STICKS), of.stride(strides.STICKS, True)),
    ),
    "figure_6": (strides.draw, _stride_table, lambda of: (of.stride(strides.LANDING),)),
    "figure_7": (strides.draw, _stride_table, lambda of: (of.stride(strides.THREE_SLIPS),)),
    "figure_8": (strides.draw_low, _stride_table, lambda of: tuple(map(of.stride, strides.LOW))),
    "figure_9": (figure_9.draw, figure_9.table, lambda of: (of.gaits, of.equal)),
    "attraction": (attraction.draw, attraction.table, lambda of: of.attraction),
    "energy": (energy.draw, energy.table, lambda of: (of.gaits, of.equal)),
    "guinea_fowl": (guinea_fowl.draw, guinea_fowl.table, lambda of: (of.fowl,)),
    "retraction": (retraction.draw, retraction.table, lambda of: of.retraction),
    "reduced_region": (reduced.draw_regions, reduced.region_table, lambda of: (of.regions,)),
    "reduced_eigenvalues": (reduced.draw_eigenvalues, reduced.eigenvalue_table, lambda of: (of.models,)),
    "reduced_stability": (reduced.draw_planes, reduced.plane_table, lambda of: (of.planes,)),
    **{name: _stored(name) for name in STORED},
}
"""Figures by name: how each is drawn, its data by column, and the results that both need."""


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
            raise InputError(f"only {begin}: no such figure; allowed: {', '.join(FIGURES)}")
    chosen, results = [name for name in FIGURES if name.startswith(tuple(only))], Results(measure)
    folder.mkdir(exist_ok=True)
    written: list[Path] = []
    with progress_bar("figures", len(chosen), "figures", progress) as bar:
        for name in chosen:
            paths, data = [folder / f"{name}.{suffix}" for suffix in formats], folder / f"{name}.csv"
            drawing, table, needed = FIGURES[name]
            _write(partial(drawing, *needed(results)), *paths, **how)
            write_columns(data, as_columns(table(*needed(results))))
            written += [*paths, data]
            bar.update()
    return written


def draw_gallery(folder: Path, progress: bool = False) -> list[Path]:
    """Draw figures 5 to 9 of the paper, one stride as snapshots and as an animation, and the model."""
    folder.mkdir(exist_ok=True)
    results = Results()

    def figure(name: str) -> Figure:
        drawing, _, needed = FIGURES[name]
        return drawing(*needed(results))

    drawings: dict[str, Callable[[Path], None]] = {
        **{f"{name}.png": partial(_write, partial(figure, name)) for name in GALLERY},
        "snapshots.png": partial(_write, lambda: model.draw_snapshots(results.stride(model.FRICTION))),
        "stride.gif": lambda path: animation.draw(path, results.stride(model.FRICTION)),
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
