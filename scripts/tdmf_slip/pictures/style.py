"""Style of all pictures: colours and names of contact modes, type, axes, and how files are written."""

import importlib.resources
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from io import BytesIO
from itertools import product
from pathlib import Path
from string import Template
from typing import Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.backend_bases import RendererBase
from matplotlib.collections import QuadMesh
from matplotlib.colors import Colormap, ListedColormap
from matplotlib.figure import Figure
from matplotlib.path import Path as Outline
from matplotlib.patheffects import withStroke
from matplotlib.text import Annotation, Text
from matplotlib.ticker import AutoLocator, FuncFormatter
from matplotlib.transforms import Bbox
from numpy.typing import NDArray

from ..errors import InputError
from ..files.whole import check_destination, whole
from ..fmu.run import SLIPS
from ..variables.display_units import DisplayUnits

FORMATS = (".png", ".svg", ".pdf")
LONGEST_REASON = 200
"""Characters of Matplotlib's own message that are repeated."""
INK = "#22303c"
FAINT = "#8a97a3"
GROUND = "#c9d1d8"
BODY = "#22303c"
CURVE = "#22303c"
SECOND_CURVE = "#0b7a75"
"""Colour of a second quantity in the same axes."""

MODE_COLOURS: Mapping[str, str] = {
    "flight": "#8a97a3",
    "stick": "#1f5fa8",
    "slip_positive": "#e07b00",
    "slip_negative": "#b3216f",
    "graze": "#5aa02c",
}
"""Colours by the unit's names of contact modes; colour-blind readers can tell them apart."""

MODE_NAMES: Mapping[str, str] = {
    "flight": "flight",
    "stick": "stick (0)",
    "slip_positive": "slip forward (+)",
    "slip_negative": "slip backward (−)",
    "graze": "graze",
}

PRINTED: Mapping[str, str] = {"l0": "l₀", " sqrt": "√", "sqrt": "√", "^2": "²", "^4": "⁴", ".": "·", "2": "²"}
"""Parts of a unit and their printed form, replaced in this order."""

LETTERS: Mapping[str, str] = {"stick": "0", "slip_positive": "+", "slip_negative": "−"}
"""Letters of the gait word."""

STANCE_LINE: Mapping[str, Any] = {"color": FAINT, "linestyle": (0, (5, 3)), "linewidth": 1.0, "zorder": 1}
MID_STANCE_LINE: Mapping[str, Any] = {"color": FAINT, "linestyle": "-.", "linewidth": 1.0, "zorder": 1}
PUBLISHED: Mapping[str, Any] = {
    "linestyle": "",
    "marker": "o",
    "markersize": 8.0,
    "markerfacecolor": "none",
    "markeredgecolor": "#b3216f",
    "markeredgewidth": 1.6,
    "zorder": 5,
    "label": "in the paper's text",
}
"""Marker of a value that the paper states in words."""
LIMIT_LINE: Mapping[str, Any] = {"color": INK, "linestyle": (0, (4, 2)), "linewidth": 0.9, "zorder": 1}
SLIP_DASHES = (0, (3.0, 1.4))

LOADED = ("stick", "slip_positive", "slip_negative")
"""Modes in which the ground bears the foot."""

DOTS_PER_INCH = 150
UNDATED: Mapping[str, dict[str, Any]] = {
    ".png": {"Software": None},
    ".svg": {"Date": None},
    ".pdf": {"CreationDate": None},
}
"""Metadata that is left out of a file, by format: equal figures are equal bytes."""

SETTINGS: dict[Any, Any] = {
    "font.size": 9.5,
    "font.family": "DejaVu Sans",
    "mathtext.fontset": "dejavusans",
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.titlesize": 10,
    "axes.titlelocation": "left",
    "text.color": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "legend.frameon": True,
    "legend.framealpha": 1.0,
    "legend.edgecolor": "white",
    "legend.borderpad": 0.2,
    "legend.fontsize": 8.5,
    "lines.linewidth": 1.7,
    "figure.facecolor": "white",
}


STYLES: Mapping[str, Mapping[Any, Any]] = {
    "house": {},
    "print": {
        "font.family": "serif",
        "mathtext.fontset": "stix",
        "font.size": 8.0,
        "axes.titlesize": 8.0,
        "legend.fontsize": 7.0,
        "lines.linewidth": 1.1,
        "axes.linewidth": 0.6,
        "pdf.fonttype": 42,  # a journal wants its type embedded whole
    },
    "slides": {
        "font.size": 13.0,
        "axes.titlesize": 14.0,
        "legend.fontsize": 11.0,
        "lines.linewidth": 2.4,
        "axes.linewidth": 1.2,
    },
}
"""Settings by name of the style, over those for pages on a screen."""


@contextmanager
def styled(name: str = "house") -> Iterator[None]:
    """One of the `STYLES`, for what is drawn and written inside."""
    with matplotlib.rc_context({**SETTINGS, **STYLES[name]}):
        yield


class Picture(Figure):
    """A figure made without pyplot, which would choose Matplotlib's backend for the whole process."""

    def _repr_png_(self) -> bytes:
        """Image for a notebook in which pyplot has not been imported."""
        return png_of(self)


def png_of(figure: Figure) -> bytes:
    """An image that does not depend on the date."""
    file = BytesIO()
    figure.savefig(file, format="png", dpi=DOTS_PER_INCH, metadata=UNDATED[".png"])
    return file.getvalue()


def subplots(
    rows: int = 1, columns: int = 1, *, figsize: tuple[float, float], **axes: Any
) -> tuple[Picture, Any]:
    """Make a picture and its axes, as `pyplot.subplots` does, in a constrained layout."""
    figure = Picture(figsize=figsize, layout="constrained")
    return figure, figure.subplots(rows, columns, **axes)


def check_picture(path: Path | str, what: str, formats: Iterable[str] = FORMATS) -> Path:
    """Refuse, before any work, a picture that cannot be written, or that Matplotlib cannot draw."""
    path = check_destination(path, formats, what)
    check_drawing(f"{what}: {path}")
    return path


def check_drawing(what: str) -> None:
    """Refuse, before any work, a Matplotlib that cannot draw, as with `text.usetex` but no LaTeX."""
    try:
        with styled():
            figure = Picture(figsize=(1.0, 1.0))
            figure.text(0.0, 0.5, f"{with_unit('torque', 'N.m')}, {word('+-')}")
            figure.savefig(BytesIO(), format="png")
    except Exception as problem:  # raised by any backend, or by a program that it calls
        raise InputError(
            f"{what}: Matplotlib cannot draw: {' '.join(str(problem).split())[:LONGEST_REASON]}; "
            "check its settings"
        ) from problem


def save(
    figure: Figure, path: Path, *, width: float | None = None, dots_per_inch: float | None = None
) -> None:
    """Write a figure whole or not at all; with a width, in inches, the height is in proportion."""
    if width is not None:
        old_width, height = figure.get_size_inches()
        figure.set_size_inches(width, height * width / old_width)
    with whole(path) as beside:
        metadata = UNDATED.get(path.suffix.lower())
        figure.savefig(beside, dpi=dots_per_inch or DOTS_PER_INCH, metadata=metadata)


def template(name: str) -> Template:
    """A page of HTML beside this module, with $names for what goes into it."""
    return Template(importlib.resources.files(__package__).joinpath(f"{name}.html").read_text("utf-8"))


def label(axes: Axes, horizontal: str, vertical: str) -> None:
    """Name both axes."""
    axes.set_xlabel(horizontal)
    axes.set_ylabel(vertical)


def runs_of(values: Sequence[Any]) -> list[tuple[Any, slice]]:
    """Each stretch of equal values: the value, and the rows of the stretch."""
    starts = [row for row in range(len(values)) if row == 0 or values[row] != values[row - 1]]
    ends = [*starts[1:], len(values)]
    return [(values[start], slice(start, end)) for start, end in zip(starts, ends, strict=True)]


def edges_of(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Edges midway between values, and as far beyond the outer values; for a single value, around it."""
    if len(values) == 1:
        around: NDArray[np.float64] = values[0] + max(0.05 * abs(values[0]), 0.05) * np.array([-1.0, 1.0])
        return around
    between = 0.5 * (values[1:] + values[:-1])
    return np.concatenate([[2.0 * values[0] - between[0]], between, [2.0 * values[-1] - between[-1]]])


def paint_cells(
    axes: Axes,
    edges: Any,
    where: NDArray[np.bool_],
    colours: Any,
    values: Any = 0.0,
    largest: float = 1.0,
) -> QuadMesh:
    """Paint the cells of a mask in one colour, or in shades of a colour map from 0 to the largest value."""
    shades = colours if isinstance(colours, Colormap) else ListedColormap([colours])
    shown = np.ma.masked_where(~where, np.broadcast_to(values, where.shape))
    return axes.pcolormesh(*edges, shown, cmap=shades, vmin=0.0, vmax=largest, rasterized=True)


class _Scaled(AutoLocator):
    """Places of marks that are round in another unit than that of what is drawn."""

    def __init__(self, factor: float) -> None:
        super().__init__()
        self.factor = factor

    def tick_values(self, vmin: float, vmax: float) -> list[float]:
        """Ticks that are round in the other unit."""
        marks = super().tick_values(vmin * self.factor, vmax * self.factor)
        return [mark / self.factor for mark in marks]


def mark_in_display_unit(axis: Axis, name: str, display: DisplayUnits) -> str:
    """Mark an axis, whose values are in a variable's own unit, in the display unit, and return its label."""
    factor = display.factor(name)
    if factor != 1.0:
        axis.set_major_locator(_Scaled(factor))
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value * factor:.6g}"))
    return with_unit(name, display.unit(name))


NAMES = {
    "com_height": "height of the centre of mass",
    "com_speed": "speed of the centre of mass",
    "leg_length_rate": "rate of leg length",
    "leg_angle_rate": "rate of leg angle",
    "lambda_max": "largest eigenvalue",
}
"""Names of coordinates and quantities that do not read as words by themselves."""


def in_words(name: str) -> str:
    """A coordinate or quantity as it is read; a parameter, whose name has a dot, as it is."""
    return NAMES.get(name, name if "." in name else name.replace("_", " "))


def with_unit(name: str, unit: str) -> str:
    """Label of an axis with its unit, if it has one, as it is printed: N·s/m for N.s/m, m/s² for m/s2."""
    return name if unit in ("", "1") else f"{name} ({printed(unit)})"


def printed(unit: str) -> str:
    """A unit in print: N·s/m for N.s/m, m/s² for m/s2, l₀√(k/m) for l0 sqrt(k/m)."""
    for written, shown in PRINTED.items():
        unit = unit.replace(written, shown)
    return unit


def stable_curve(axes: Axes, x: Any, y: Any, stable: Any, colour: str, **look: Any) -> None:
    """Draw a curve of gaits, solid where they are stable, else thin and dashed."""
    axes.plot(x, y, color=colour, linewidth=1.0, linestyle=SLIP_DASHES)
    axes.plot(x, np.where(stable, y, np.nan), color=colour, **look)


def name_unstable(axes: Axes) -> None:
    """Add an entry for unstable gaits, whose lines are thin and dashed, to the legend of the axes."""
    axes.plot([], [], color=INK, linewidth=1.0, linestyle=SLIP_DASHES, label="unstable gaits")


def line_of(mode: str) -> dict[str, Any]:
    """Line of a contact mode: slip dashed, all else solid."""
    return {"color": MODE_COLOURS[mode], "linestyle": SLIP_DASHES if mode in SLIPS else "-", "linewidth": 2.0}


def word(letters: str) -> str:
    """A gait word with a minus sign as wide as its plus."""
    return letters.replace("-", "−")


CLEARANCE = 1.5
"""Points left free around a word."""
DISTANCES = (5.0, 14.0, 28.0)
"""Points between a word and its place on the curve; tried in this order."""
LEADER = 10.0
"""Points from which on a thin line joins a word to its curve."""
DIRECTIONS = ((0, 1), (0, -1), (-1, 1), (1, 1), (-1, -1), (1, -1), (-1, 0), (1, 0))
HORIZONTAL, VERTICAL = ("right", "center", "left"), ("top", "center", "bottom")
"""Alignments of a word by the sign of its direction plus one."""
PLACES = 21
"""Places tried along a curve, the middle one first."""
LEADING = {"arrowstyle": "-", "color": FAINT, "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0}
"""Look of the line from a word to its curve."""


class CurveLabel(Annotation):
    """A word that finds its place whenever it is drawn, so that it fits a figure of any size."""

    def __init__(
        self,
        axes: Axes,
        word: str,
        points: NDArray[np.float64],
        distances: Sequence[float] = DISTANCES,
        **look: Any,
    ) -> None:
        """Label the curve through `points`, shape (n, 2), in data coordinates unless `xycoords` differs."""
        super().__init__(
            word,
            tuple(points[0]),
            xytext=(0.0, 0.0),
            textcoords="offset points",
            arrowprops=dict(LEADING),
            path_effects=[withStroke(linewidth=2.0, foreground="white")],
            zorder=7,
            **look,
        )
        self._points, self._distances = points, distances
        axes.add_artist(self)
        self.set_in_layout(False)

    def draw(self, renderer: RendererBase) -> None:
        """Draw the word at the first place where it touches nothing, or else where it touches least."""
        lines, boxes = self._obstacles(renderer)
        count = min(PLACES, len(self._points))
        rows = np.linspace(0, len(self._points) - 1, count).round().astype(int)
        from_middle = sorted(rows, key=lambda row: abs(2 * row - len(self._points) + 1))
        least, best = np.inf, (0.0, 0, DIRECTIONS[0])
        for place in product(self._distances, from_middle, DIRECTIONS):
            touched = self._touched(self._move(*place).box_of_word(renderer), lines, boxes)
            if touched < least:
                least, best = touched, place
            if not touched:
                break
        self._move(*best)
        super().draw(renderer)

    def box_of_word(self, renderer: RendererBase) -> Bbox:
        """Extent of the word without its leader."""
        self.update_positions(renderer)
        return Text.get_window_extent(self, renderer)

    def _move(self, distance: float, row: int, direction: tuple[int, int]) -> "CurveLabel":
        across, up = direction
        self.xy = tuple(self._points[row])
        self.set_position((distance * across, distance * up))
        self.set(horizontalalignment=HORIZONTAL[across + 1], verticalalignment=VERTICAL[up + 1])
        self.arrow_patch.set_visible(distance > LEADER)  # type: ignore[union-attr]
        return self

    def _obstacles(self, renderer: RendererBase) -> tuple[list[Outline], list[Bbox]]:
        """Lines of the axes, and the boxes of marks, of words drawn before and of the legend."""
        axes = self.axes
        assert axes is not None
        lines = [line.get_transform().transform_path(line.get_path()) for line in axes.lines]
        texts = list(axes.texts)
        placed = [text for text in texts[: texts.index(self)] if isinstance(text, CurveLabel)]
        boxes = [text.box_of_word(renderer) for text in placed]
        boxes += [text.get_window_extent(renderer) for text in texts if not isinstance(text, CurveLabel)]
        legend = axes.get_legend()
        if legend is not None:
            boxes.append(legend.get_window_extent(renderer))
        for line, path in zip(axes.lines, lines, strict=True):
            if line.get_marker() not in ("None", "", " ", None):
                half = 0.5 * line.get_markersize() * float(np.asarray(renderer.points_to_pixels(1.0)))
                marks = np.asarray(path.vertices)[np.isfinite(path.vertices).all(axis=1)]
                boxes += [Bbox([mark - half, mark + half]) for mark in marks]
        return [path.cleaned(remove_nans=True) for path in lines], boxes

    def _touched(self, box: Bbox, lines: list[Outline], boxes: list[Bbox]) -> int:
        """Number of things that a word would touch; a place outside the axes counts as a hundred."""
        box = box.padded(CLEARANCE)
        frame = self.axes.bbox  # type: ignore[union-attr]
        inside = frame.x0 <= box.x0 and box.x1 <= frame.x1 and frame.y0 <= box.y0 and box.y1 <= frame.y1
        touched = sum(line.intersects_bbox(box, filled=False) for line in lines)
        return touched + sum(box.overlaps(other) for other in boxes) + (0 if inside else 100)
