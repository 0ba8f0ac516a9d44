"""Curves of special points over two parameters, in a file."""

from collections.abc import Sequence
from pathlib import Path

import matplotlib.pyplot as plt
from matplotlib.figure import Figure

from ..analysis.bifurcations import WORD_BORDER
from ..analysis.curve import Curve
from ..unit.unit import load
from . import style
from .branch_diagram import MARKS


def figure_of(curves: Sequence[Curve], over: Sequence[str]) -> Figure:
    """The curves in the plane of the parameters: borders thin, with the words on both sides.

    Parameters
    ----------
    curves : sequence of Curve
        What is drawn.
    over : pair of str
        The parameters.

    Returns
    -------
    Figure
        Of matplotlib.
    """
    unit = load()
    with style.styled():
        figure, axes = plt.subplots(figsize=(7.6, 5.4), layout="constrained")
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
            if curve.words:
                text = f"{style.word(curve.words[0])} | {style.word(curve.words[1])}"
                middle = curve.points[len(curve.points) // 2]
                axes.annotate(text, middle, xytext=(4, 4), textcoords="offset points", fontsize=8)
        style.label(axes, *(style.with_unit(name, unit.variables[name].unit) for name in over))
        if shown:
            axes.legend()
    return figure


def draw(path: Path, curves: Sequence[Curve], over: Sequence[str]) -> None:
    """Draw the curves into a file.

    Parameters
    ----------
    path : Path
        Of the picture.
    curves : sequence of Curve
        What is drawn.
    over : pair of str
        The parameters.
    """
    style.save(figure_of(curves, over), path)
