"""Curves of special points over two parameters, in a file."""

from pathlib import Path

import numpy as np
import xarray
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..analysis.curves import Curve, curves_in
from ..analysis.special_points import WORD_BORDER
from ..library.runner import Runner
from ..record import runner_in
from ..variables.display_units import DisplayUnits
from . import style
from .branch_diagram import MARKS

BESIDE, ASLANT = 6.0, 0.35
"""Distance of a word from its curve, in points, and the slope from which the word stands beside it."""


def figure_of(data: xarray.Dataset, display: DisplayUnits | None = None) -> Figure:
    """The curves in the plane of the parameters: borders thin, with each word on its side."""
    curves, names = curves_in(data), str(data.over).split(", ")
    display = display or DisplayUnits(values=Runner(runner_in(data), model=data.model))
    with style.styled():
        figure, axes = style.subplots(figsize=(7.6, 5.4))
        labels = [
            style.tell_in(axis, name, display)
            for axis, name in zip((axes.xaxis, axes.yaxis), names, strict=True)
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
        begin, end = data.first_range
        for curve in curves:
            _write_words(axes, curve, begin < end)
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


def draw(path: Path, data: xarray.Dataset, display: DisplayUnits | None = None) -> None:
    """Draw the curves into a file."""
    style.save(figure_of(data, display), path)
