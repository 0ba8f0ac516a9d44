"""Style of all pictures: colours and names of contact modes, type, axes, and how files are written."""

from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Any, Literal, TypeAlias

import matplotlib
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.ticker import AutoLocator, FuncFormatter

from ..errors import InputError
from ..files.whole import check_destination, whole
from ..fmu.events import SLIPS
from ..variables.display_units import DisplayUnits

LineStyle: TypeAlias = Literal["-"] | tuple[float, tuple[float, ...]]

FORMATS = (".png", ".svg", ".pdf")
LONGEST_REASON = 200
"""Characters of Matplotlib's own message that are repeated."""
INK = "#22303c"
FAINT = "#8a97a3"
GROUND = "#c9d1d8"
BODY = "#22303c"
CURVE = "#22303c"
SECOND_CURVE = "#0b7a75"
"""For a second quantity in the same axes."""

MODE_COLOURS: Mapping[str, str] = {
    "flight": "#8a97a3",
    "stick": "#1f5fa8",
    "slip_positive": "#e07b00",
    "slip_negative": "#b3216f",
    "graze": "#5aa02c",
}
"""By the unit's names of contact modes; told apart by colour-blind readers too."""

MODE_NAMES: Mapping[str, str] = {
    "flight": "flight",
    "stick": "stick (0)",
    "slip_positive": "slip forward (+)",
    "slip_negative": "slip backward (−)",
    "graze": "graze",
}

PRINTED: Mapping[str, str] = {
    "l0": "l₀",
    " sqrt": "√",
    "sqrt": "√",
    "^2": "²",
    "^4": "⁴",
    ".": "·",
    "2": "²",
}
"""How parts of a unit are printed, replaced in this order."""

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
"""How a value is marked that the paper tells in words."""
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
"""By format: what is left out of the file, so that the same figure is the same bytes."""

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
"""By name: what a style has beyond the house's own, which is for pages on a screen."""


@dataclass(frozen=True)
class Appearance:
    """How figures are written, whatever they show."""

    width: float | None = None
    """Inches, with the height in proportion and type of its own size; None: as each figure was designed."""
    dots_per_inch: float | None = None
    """Resolution of PNG files; None: as each figure was designed."""
    style: str = "house"
    """One of `STYLES`."""


DESIGNED = Appearance()
"""As the figures were designed."""

_PRESENT: ContextVar[Appearance] = ContextVar("appearance")


@contextmanager
def appearing(appearance: Appearance) -> Iterator[None]:
    """An appearance for all figures that are drawn and written inside."""
    token = _PRESENT.set(appearance)
    try:
        yield
    finally:
        _PRESENT.reset(token)


@contextmanager
def styled() -> Iterator[None]:
    """The present style, for what is drawn inside."""
    with matplotlib.rc_context({**SETTINGS, **STYLES[_PRESENT.get(DESIGNED).style]}):
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
            "allowed: other settings of it"
        ) from problem


def save(figure: Figure, path: Path, dots_per_inch: int = DOTS_PER_INCH) -> None:
    """Write a figure whole or not at all."""
    present = _PRESENT.get(DESIGNED)
    if present.width is not None:
        width, height = figure.get_size_inches()
        figure.set_size_inches(present.width, height * present.width / width)
    with whole(path) as beside:
        figure.savefig(
            beside, dpi=present.dots_per_inch or dots_per_inch, metadata=UNDATED.get(path.suffix.lower())
        )


def label(axes: Axes, horizontal: str, vertical: str) -> None:
    """Name both axes."""
    axes.set_xlabel(horizontal)
    axes.set_ylabel(vertical)


class _Scaled(AutoLocator):
    """Places of marks that are round in another unit than that of what is drawn."""

    def __init__(self, factor: float) -> None:
        super().__init__()
        self.factor = factor

    def tick_values(self, vmin: float, vmax: float) -> list[float]:
        """As of the values in that unit."""
        marks = super().tick_values(vmin * self.factor, vmax * self.factor)
        return [mark / self.factor for mark in marks]


def tell_in(axis: Axis, name: str, display: DisplayUnits) -> str:
    """Have an axis, whose values are in a variable's own unit, marked in the one that it is told in."""
    factor = display.factor(name)
    if factor != 1.0:
        axis.set_major_locator(_Scaled(factor))
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value * factor:.6g}"))
    return with_unit(name, display.unit(name))


def with_unit(name: str, unit: str) -> str:
    """Label of an axis with its unit, if it has one, as it is printed: N·s/m for N.s/m, m/s² for m/s2."""
    return name if unit in ("", "1") else f"{name} ({printed(unit)})"


def printed(unit: str) -> str:
    """A unit in print: N·s/m for N.s/m, m/s² for m/s2, l₀√(k/m) for l0 sqrt(k/m)."""
    for written, shown in PRINTED.items():
        unit = unit.replace(written, shown)
    return unit


def name_unstable(axes: Axes) -> None:
    """Add an entry for unstable gaits, whose lines are thin and dashed, to the legend of the axes."""
    axes.plot([], [], color=INK, linewidth=1.0, linestyle=SLIP_DASHES, label="unstable gaits")


def dashes(mode: str) -> LineStyle:
    """Line style of a contact mode: slip dashed, all else solid."""
    return SLIP_DASHES if mode in SLIPS else "-"


def word(letters: str) -> str:
    """A gait word with a minus sign as wide as its plus."""
    return letters.replace("-", "−")
