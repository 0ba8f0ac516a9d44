"""A branch as a diagram: a quantity of its gaits over the parameter.

Stable gaits are solid, unstable ones dashed, special points marked, and words written where they hold.
"""

from collections.abc import Iterator
from itertools import groupby, pairwise
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from ..analysis.branches import Branch
from ..analysis.special_points import FOLD, NEIMARK_SACKER, PERIOD_DOUBLING, UNCLASSIFIED, WORD_BORDER
from ..checks import is_one_of, near_matches, shown
from ..errors import InputError
from ..library.gait import Gait
from ..library.section import COORDINATES
from ..variables.display_units import DisplayUnits
from ..variables.table import VARIABLES
from . import style
from .style import CurveLabel

DRAWN = "com_speed"
"""The quantity that is drawn unless another is asked for."""
MIN_SHOWN, LARGEST_SHOWN = 1.15, 4.0
"""Least and largest reach of the axis of eigenvalues."""
COLOURS = (style.CURVE, style.SECOND_CURVE, "#8a5a00", "#5b2a86")
"""Colours of lines, by how often the period was doubled."""
MARKS: dict[str, dict[str, Any]] = {
    WORD_BORDER: {"marker": "|", "color": style.FAINT, "markersize": 9, "markeredgewidth": 1.4},
    FOLD: {"marker": "o", "color": style.MODE_COLOURS["slip_negative"], "markersize": 6.5},
    PERIOD_DOUBLING: {"marker": "D", "color": style.MODE_COLOURS["slip_positive"], "markersize": 5.5},
    NEIMARK_SACKER: {"marker": "s", "color": style.MODE_COLOURS["stick"], "markersize": 6},
    UNCLASSIFIED: {"marker": "x", "color": "#c0392b", "markersize": 7, "markeredgewidth": 1.8},
}
"""Markers of special points, by kind."""
SHORT_RUN = 0.03
"""Share of the axes' diagonal: a word that holds over less is not written."""
WORD_PLACES = 21
"""Places along a line where its word may stand."""


def values_of(gait: Gait, quantity: str) -> list[float]:
    """A quantity of a gait: for each of its apexes, or one for all of its strides."""
    coordinates = gait.runner.coordinates
    if is_one_of(quantity, coordinates):
        return [float(apex[coordinates.index(quantity)]) for apex in (gait.apex, *gait.following)]
    numbers = {**gait.stride, "lambda_max": gait.lambda_max, "liftoff_angle": gait.liftoff_angle}
    if not is_one_of(quantity, numbers):
        known = (*coordinates, *numbers)
        raise InputError(
            f"quantity {shown(quantity)} is not allowed; allowed: {', '.join(known)}"
            f"{near_matches(quantity, known)}"
        )
    return [numbers[quantity]]


def figure_of(branch: Branch, quantity: str = DRAWN, display: DisplayUnits | None = None) -> Figure:
    """A quantity of the gaits, and the size of their largest eigenvalue, over the parameter."""
    values_of(branch.gaits[0], quantity)
    display = display or DisplayUnits(values=branch.gaits[0].runner)
    with style.styled():
        figure, panels = style.subplots(2, 1, figsize=(8.2, 7.0), sharex=True, height_ratios=(2, 1))
        kind = "apex" if quantity in COORDINATES else "stride"
        variable = VARIABLES.get(f"{kind}.{quantity}")
        label = f"{kind}.{quantity}" if variable else quantity
        panels[0].set_ylabel(style.with_unit(label, display.label(variable.unit) if variable else ""))
        panels[1].set_ylabel("modulus of the largest eigenvalue")
        panels[1].set_xlabel(style.tell_in(panels[1].xaxis, branch.name, display))
        begin = display.value(branch.name, branch.values[0])
        panels[0].set_title(f"{branch.name} from {begin:g}: {branch.ended}", wrap=True)
        for axes, drawn in zip(panels, (quantity, "lambda_max"), strict=True):
            _draw(axes, branch, drawn, 0)
        panels[1].axhline(1.0, **style.LIMIT_LINE)
        _bound(panels[1])
        _write_words(panels[0], branch, quantity)
        _legend(panels[0])
    return figure


def draw(path: Path, branch: Branch, quantity: str, display: DisplayUnits | None = None) -> None:
    """Draw a branch into a file."""
    style.save(figure_of(branch, quantity, display), path)


def _bound(axes: Axes) -> None:
    """Eigenvalues may be large beside an event that is just touched: what matters is around 1."""
    axes.set_ylim(0.0, float(np.clip(axes.get_ylim()[1], MIN_SHOWN, LARGEST_SHOWN)))


def _draw(axes: Axes, branch: Branch, quantity: str, depth: int) -> None:
    """The lines of a branch and of those from it, and their special points."""
    colour = COLOURS[min(depth, len(COLOURS) - 1)]
    for stable, run in groupby(_segments(branch, quantity), key=lambda segment: segment[0]):
        segments = list(run)
        x = [segments[0][1][0], *(end[0] for _, _, end in segments)]
        y = np.array([segments[0][1][1], *(end[1] for _, _, end in segments)])
        kind = "stable" if stable else "unstable"
        label = f"{kind}, {branch.strides} stride{'s' if branch.strides > 1 else ''}"
        for number, line in enumerate(y.T):
            look: dict[str, Any] = {
                "color": colour,
                "linestyle": "-" if stable else (0, (4, 2)),
                "linewidth": 1.6,
            }
            axes.plot(x, line, label=label if number == 0 else "_", zorder=2 + depth, **look)
    for special in branch.specials:
        for value in values_of(special.gait, quantity):
            label = special.kind
            axes.plot([special.value], [value], linestyle="", label=label, zorder=6, **MARKS[special.kind])
    for other in branch.branches:
        _draw(axes, other, quantity, depth + 1)


def _segments(
    branch: Branch, quantity: str
) -> list[tuple[bool, tuple[float, list[float]], tuple[float, list[float]]]]:
    """Straight segments between neighbouring gaits, special ones too: whether stable, begin and end."""
    found = []
    by_index = {index: list(of) for index, of in groupby(branch.specials, key=lambda s: s.index)}
    gaits = list(zip(branch.values, branch.gaits, strict=True))
    for index, ((low, before), (high, after)) in enumerate(pairwise(gaits)):
        met = [special for special in by_index.get(index, []) if special.kind != UNCLASSIFIED]
        points = [(low, before), *((s.value, s.gait) for s in met), (high, after)]
        changes = [number for number, s in enumerate(met, 1) if s.kind != WORD_BORDER]
        change = changes[0] if changes else len(points) - 1
        for number, (begin, end) in enumerate(pairwise(points)):
            stable = before.stable if number < change else after.stable
            if not changes:
                stable = before.stable and after.stable
            ends = [(value, values_of(gait, quantity)) for value, gait in (begin, end)]
            found.append((stable, ends[0], ends[1]))
    return found


def _write_words(axes: Axes, branch: Branch, quantity: str, depth: int = 0) -> None:
    """Each word beside the middle of where it holds, unless that is too short to be seen."""
    for word, run in _runs_of_words(branch, quantity):
        box = axes.get_window_extent()
        seen = axes.transData.transform(run)
        lengths = np.append(0.0, np.cumsum(np.hypot(*np.diff(seen, axis=0).T)))
        if lengths[-1] < SHORT_RUN * np.hypot(box.width, box.height):
            continue
        evenly = np.linspace(0.0, lengths[-1], WORD_PLACES)
        points = np.column_stack([np.interp(evenly, lengths, column) for column in run.T])
        colour = style.INK if depth == 0 else COLOURS[min(depth, len(COLOURS) - 1)]
        CurveLabel(axes, style.word(word), points, fontsize=8.5, color=colour)
    for other in branch.branches:
        _write_words(axes, other, quantity, depth + 1)


def _runs_of_words(branch: Branch, quantity: str) -> Iterator[tuple[str, NDArray[np.float64]]]:
    """Each word with the points of its gaits, from one border to the next, in the branch's order."""
    gaits = list(zip(branch.values, branch.gaits, strict=True))
    borders = {s.index: (s.value, s.gait) for s in branch.specials if s.kind == WORD_BORDER}
    begin = 0
    for word, run in groupby(gaits, key=lambda gait: gait[1].word):
        end = begin + len(list(run))
        ends = [borders.get(begin - 1), *gaits[begin:end], borders.get(end - 1)]
        points = [(gait[0], values_of(gait[1], quantity)[0]) for gait in ends if gait is not None]
        yield word, np.array(points)
        begin = end


def _legend(axes: Axes) -> None:
    """Each kind of line and mark once."""
    handles, labels = axes.get_legend_handles_labels()
    once = dict(zip(labels, handles, strict=True))
    axes.legend(once.values(), once.keys(), fontsize=8.5)
