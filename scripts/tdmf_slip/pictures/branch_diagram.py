"""A branch as a diagram: a quantity of its gaits over the parameter.

Stable gaits are solid, unstable ones dashed, special points marked, and words written where they hold.
"""

from collections.abc import Iterator
from itertools import groupby, pairwise
from typing import Any

import numpy as np
import xarray
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from ..analysis.special_points import FOLD, NEIMARK_SACKER, PERIOD_DOUBLING, UNCLASSIFIED, WORD_BORDER
from ..checks import check_names, is_one_of
from ..errors import counted
from ..library.gait import first_runner_in
from ..library.quantities import QUANTITIES
from ..library.section import COORDINATES
from ..record import parts_of
from ..variables.display_units import DisplayUnits
from ..variables.table import MODELS, VARIABLES
from . import style
from .style import CurveLabel

DRAWN = "com_speed"
"""Quantity drawn by default; for a model without it, its first coordinate."""
MIN_SHOWN, LARGEST_SHOWN = 1.15, 4.0
"""Least and largest reach of the axis of eigenvalues."""
COLOURS = (style.CURVE, style.SECOND_CURVE, "#8a5a00", "#5b2a86")
"""Colours of lines, by the number of period doublings."""
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


def values_of(data: xarray.Dataset, quantity: str) -> NDArray[np.float64]:
    """A quantity of a branch's points, of each apex or of all strides: shape (points, apexes)."""
    coordinates = [str(name) for name in data["coordinate"].values]
    if is_one_of(quantity, coordinates):
        values: NDArray[np.float64] = data["apexes"].sel(coordinate=quantity).values
        return values
    known = [
        str(name) for name, of in data.data_vars.items() if of.dims == ("point",) and of.dtype.kind == "f"
    ]
    known = [name for name in known if not name.startswith("apex_") or name in QUANTITIES]
    check_names([quantity], (*coordinates, *known), "quantity")
    return np.asarray(data[quantity].values, float)[:, None]


def figure_of(data: xarray.Dataset, quantity: str = DRAWN, display: DisplayUnits | None = None) -> Figure:
    """A quantity of the gaits, and the size of their largest eigenvalue, over the parameter."""
    if quantity == DRAWN and data.model not in MODELS and DRAWN not in data["coordinate"]:
        quantity = str(data["coordinate"].values[0])
    values_of(data, quantity)
    name = data.over
    display = display or DisplayUnits(values=first_runner_in(data))
    figure, panels = style.subplots(2, 1, figsize=(8.2, 7.0), sharex=True, height_ratios=(2, 1))
    kind = "apex" if quantity in COORDINATES else "stride"
    variable = VARIABLES.get(f"{kind}.{quantity}")
    label = f"{kind}.{quantity}" if variable else quantity
    panels[0].set_ylabel(style.with_unit(label, display.label(variable.unit) if variable else ""))
    panels[1].set_ylabel("modulus of the largest eigenvalue")
    panels[1].set_xlabel(style.mark_in_display_unit(panels[1].xaxis, name, display))
    begin = display.value(name, float(data[name].values[0]))
    panels[0].set_title(f"{name} from {begin:g}: {data.ended}", wrap=True)
    branches = parts_of(data, "branch")
    for axes, drawn in zip(panels, (quantity, "lambda_max"), strict=True):
        for branch in branches:
            _draw(axes, branch, drawn)
    panels[1].axhline(1.0, **style.LIMIT_LINE)
    _bound(panels[1])
    for branch in branches:
        _write_words(panels[0], branch, quantity)
    _legend(panels[0])
    return figure


def _colour(branch: xarray.Dataset) -> str:
    depth = int(branch["branch_strides"]).bit_length() - 1
    return COLOURS[min(depth, len(COLOURS) - 1)]


def _bound(axes: Axes) -> None:
    """Limit the axis of eigenvalues to values around 1; they may be huge beside a grazed event."""
    axes.set_ylim(0.0, float(np.clip(axes.get_ylim()[1], MIN_SHOWN, LARGEST_SHOWN)))


def _draw(axes: Axes, branch: xarray.Dataset, quantity: str) -> None:
    """The lines of a branch, and its special points."""
    strides = int(branch["branch_strides"])
    x, specials = branch[branch.over].values, branch["special"].values
    y = values_of(branch, quantity)[:, :strides]
    line = specials != UNCLASSIFIED
    for stable, run in groupby(enumerate(_stable_segments(branch.isel(point=line))), key=lambda one: one[1]):
        numbers = [number for number, _ in run]
        part = slice(numbers[0], numbers[-1] + 2)
        kind = "stable" if stable else "unstable"
        label = f"{kind}, {counted(strides, 'stride')}"
        look: dict[str, Any] = {"linestyle": "-" if stable else (0, (4, 2)), "linewidth": 1.6}
        for number, column in enumerate(y[line][part].T):
            label = label if number == 0 else "_"
            axes.plot(x[line][part], column, color=_colour(branch), label=label, zorder=1 + strides, **look)
    for row in np.flatnonzero(specials != ""):
        for value in y[row]:
            kind = specials[row]
            axes.plot([x[row]], [value], linestyle="", label=kind, zorder=6, **MARKS[kind])


def _stable_segments(branch: xarray.Dataset) -> Iterator[bool]:
    """Stability of the gaits between neighbouring points, from the gaits and bifurcations around them."""
    specials, unstable = branch["special"].values, branch["unstable"].values
    gaits = np.flatnonzero(specials == "")
    for before, after in pairwise(gaits):
        changes = [row for row in range(before + 1, after) if specials[row] != WORD_BORDER]
        for row in range(before, after):
            if not changes:
                yield bool(unstable[before] == unstable[after] == 0)
            else:
                yield bool(unstable[before if row < changes[0] else after] == 0)


def _write_words(axes: Axes, branch: xarray.Dataset, quantity: str) -> None:
    """Write each word beside the middle of its stretch of the branch, unless the stretch is too short."""
    first = int(branch["branch_strides"]) == 1
    points = np.column_stack([branch[branch.over].values, values_of(branch, quantity)[:, 0]])
    for word, run in _runs_of_words(branch, points):
        box = axes.get_window_extent()
        seen = axes.transData.transform(run)
        lengths = np.append(0.0, np.cumsum(np.hypot(*np.diff(seen, axis=0).T)))
        if lengths[-1] < SHORT_RUN * np.hypot(box.width, box.height):
            continue
        evenly = np.linspace(0.0, lengths[-1], WORD_PLACES)
        places = np.column_stack([np.interp(evenly, lengths, column) for column in run.T])
        colour = style.INK if first else _colour(branch)
        CurveLabel(axes, style.word(word), places, fontsize=8.5, color=colour)


def _runs_of_words(
    branch: xarray.Dataset, points: NDArray[np.float64]
) -> Iterator[tuple[str, NDArray[np.float64]]]:
    """Each word with the points of its gaits, from one border to the next, in the branch's order."""
    specials, words = branch["special"].values, branch["word"].values
    rows = [row for row, kind in enumerate(specials) if kind in ("", WORD_BORDER)]
    for is_border, run in groupby(rows, key=lambda row: (specials[row] == WORD_BORDER, words[row])):
        numbers = list(run)
        if not is_border[0]:
            first, last = rows.index(numbers[0]), rows.index(numbers[-1])
            ends = [row for row in rows[max(0, first - 1) : first] if specials[row] == WORD_BORDER]
            ends += numbers + [row for row in rows[last + 1 : last + 2] if specials[row] == WORD_BORDER]
            yield is_border[1], points[ends]


def _legend(axes: Axes) -> None:
    """Each kind of line and mark once."""
    handles, labels = axes.get_legend_handles_labels()
    once = dict(zip(labels, handles, strict=True))
    axes.legend(once.values(), once.keys(), fontsize=8.5)


BESIDE, ASLANT = 6.0, 0.35
"""Distance of a word from its curve, in points, and the slope from which the word stands beside it."""


def of_curves(data: xarray.Dataset, display: DisplayUnits | None = None) -> Figure:
    """The curves in the plane of the parameters: borders thin, with each word on its side."""
    names = str(data.over).split(", ")
    curves = parts_of(data, "curve")
    display = display or DisplayUnits(values=first_runner_in(data))
    figure, axes = style.subplots(figsize=(7.6, 5.4))
    pairs = zip((axes.xaxis, axes.yaxis), names, strict=True)
    labels = [style.mark_in_display_unit(axis, name, display) for axis, name in pairs]
    shown = set()
    for curve in curves:
        kind = curve["kind"].item()
        axes.plot(
            *(curve[name].values for name in names),
            color=MARKS[kind]["color"],
            linewidth=1.0 if kind == WORD_BORDER else 1.8,
            label="_" if kind in shown else kind,
        )
        shown.add(kind)
    style.label(axes, *labels)
    if shown:
        axes.legend()
    begin, end = data.first_range
    for curve in curves:
        points = np.column_stack([curve[name].values for name in names])
        words = [style.word(curve[side].item()) for side in ("before", "after")]
        if any(words) and len(points) > 1:
            _write_words_beside(axes, points, words if begin < end else words[::-1])
    return figure


def _write_words_beside(axes: Axes, points: NDArray[np.float64], words: list[str]) -> None:
    """The words left and right of the curve's middle; both beside it, where the curve turns back."""
    after = len(points) // 2
    begin, end = axes.transData.transform(points[after - 1 : after + 1])
    across = np.array([end[1] - begin[1], begin[0] - end[0]]) / (float(np.hypot(*(end - begin))) or 1.0)
    across *= 1.0 if across[0] >= 0.0 else -1.0
    left, right = words
    steps = np.diff(points[:, 1])
    one_way = bool(np.all(steps > 0.0) or np.all(steps < 0.0))
    texts = ((left, -across), (right, across)) if one_way else ((" | ".join(words), across),)
    for text, way in texts:
        axes.annotate(
            text,
            points[after - 1 : after + 1].mean(axis=0),
            xytext=tuple(BESIDE * way),
            textcoords="offset points",
            ha="left" if way[0] > 0.0 else "right",
            va="bottom" if way[1] > ASLANT else "top" if way[1] < -ASLANT else "center",
            fontsize=8,
        )
