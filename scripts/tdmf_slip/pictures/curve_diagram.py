"""Curves of special points over two parameters, in a file."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..analysis.curves import Curve
from ..analysis.special_points import WORD_BORDER
from ..variables.display_units import DisplayUnits
from . import style
from .branch_diagram import MARKS

BESIDE, ASLANT = 6.0, 0.35
"""Distance of a word from its curve, in points, and the slope from which the word stands beside it."""


def figure_of(
    curves: Sequence[Curve], over: Mapping[str, tuple[float, float]], display: DisplayUnits | None = None
) -> Figure:
    """The curves in the plane of the parameters: borders thin, with each word on its side."""
    display = display or DisplayUnits()
    with style.styled():
        figure, axes = style.subplots(figsize=(7.6, 5.4))
        labels = [
            style.tell_in(axis, name, display)
            for axis, name in zip((axes.xaxis, axes.yaxis), over, strict=True)
        ]
        shown = set()
        for curve in curves:
            border = curve.kind == WORD_BORDER
            axes.plot(
                *curve.points.T,
                color=MARKS[curve.kind]["color"],
                linewidth=1.0 if border else 1.8,
                label="_" if curve.kind in shown else curve.kind,
            )
            shown.add(curve.kind)
        style.label(axes, *labels)
        if shown:
            axes.legend()
        begin, end = over[curves[0].names[0]] if curves else (0.0, 0.0)
        for curve in curves:
            _write_words(axes, curve, begin < end)
    return figure


def figure_of_one(curve: Curve) -> Figure:
    """A curve alone: its legend names the words on its sides."""
    bounds = {
        name: (float(row.min()), float(row.max()))
        for name, row in zip(curve.names, curve.points.T, strict=True)
    }
    display = DisplayUnits(values=curve.runner)
    figure = figure_of([replace(curve, words=None)], bounds, display)
    (axes,) = figure.axes
    words = "" if curve.words is None else f": {style.word(curve.words[0])} | {style.word(curve.words[1])}"
    axes.legend([curve.kind + words])
    return figure


def _write_words(axes: Axes, curve: Curve, rises: bool) -> None:
    """Each word on its side of the curve's middle; both beside it, where the curve turns back.

    The first of the two holds towards the beginning of the first parameter's range.
    """
    if curve.words is None or len(curve.points) < 2:
        return
    words = [style.word(word) for word in curve.words]
    after = len(curve.points) // 2
    begin, end = axes.transData.transform(curve.points[after - 1 : after + 1])
    across = np.array([end[1] - begin[1], begin[0] - end[0]]) / (float(np.hypot(*(end - begin))) or 1.0)
    across *= 1.0 if across[0] >= 0.0 else -1.0
    left, right = words if rises else reversed(words)
    steps = np.diff(curve.points[:, 1])
    one_way = bool(np.all(steps > 0.0) or np.all(steps < 0.0))
    texts = ((left, -across), (right, across)) if one_way else ((" | ".join(words), across),)
    for text, way in texts:
        axes.annotate(
            text,
            curve.points[after - 1 : after + 1].mean(axis=0),
            xytext=tuple(BESIDE * way),
            textcoords="offset points",
            ha="left" if way[0] > 0.0 else "right",
            va="bottom" if way[1] > ASLANT else "top" if way[1] < -ASLANT else "center",
            fontsize=8,
        )


def draw(
    path: Path,
    curves: Sequence[Curve],
    over: Mapping[str, tuple[float, float]],
    display: DisplayUnits | None = None,
) -> None:
    """Draw the curves into a file."""
    style.save(figure_of(curves, over, display), path)
