"""Eigenvalues beside the unit circle, with the effect of settings or the enclosures of a proof."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from ..library.section import COORDINATES
from ..variables import paper_units
from ..variables.table import VARIABLES
from . import style

if TYPE_CHECKING:
    from ..feedback.controllability import Controllability
    from ..feedback.gains import Feedback
    from ..proof.given import Exact
    from ..proof.proof import Proof
    from ..proof.prove_border import BorderProof

MARKERS: Sequence[Mapping[str, Any]] = (
    {"marker": "o", "color": style.SECOND_CURVE, "markersize": 7.0},
    {"marker": "x", "color": style.MODE_COLOURS["slip_negative"], "markersize": 8.0, "markeredgewidth": 1.8},
)
"""Markers of the first and the second set of eigenvalues."""
NARROWEST = 1e-300
"""Least radius of an enclosure that is drawn: that of a point has no logarithm."""


def of_controllability(found: Controllability) -> Figure:
    """The modes' eigenvalues, marked where no setting moves them, and what each setting moves."""
    fixed = np.atleast_1d(found.uncontrollable)
    figure, (left, right) = _panels()
    shown = {"can be moved": found.eigenvalues, "cannot be moved": fixed}
    _paint(left, {name: values for name, values in shown.items() if len(values)})
    _bars(right, found.modal_controllability.T, found.inputs, [_mode(v) for v in found.eigenvalues])
    style.label(right, "eigenvalue of the mode", "movement of the mode by a stride, over the scales")
    return figure


def of_feedback(law: Feedback) -> Figure:
    """The eigenvalues with and without the law, and its gains over the scales."""
    model = law.linearization
    gain = model.over_scales(law.gain)
    figure, (left, right) = _panels()
    _paint(left, {"with the law": law.eigenvalues, "without": model.gait.eigenvalues})
    names = [name.replace("_", " ") for name in COORDINATES[: len(model.scales)]]
    _bars(right, gain, law.inputs, names)
    style.label(right, "coordinate of the apex", "gain, settings and coordinates over their scales")
    return figure


def of_proof(proof: Proof) -> Figure:
    """The proved eigenvalues, and how narrow the enclosures of the apex are."""
    figure, (left, right) = _panels()
    _paint(left, {style.word(proof.word) or "undecided": _middles(proof)})
    radii = [float(x.rad()) for x in proof.apex] or [float(radius) for radius in proof.box.radii]
    _radii(right, list(COORDINATES), radii, proof.values)
    return figure


def of_border(proof: BorderProof) -> Figure:
    """The proved eigenvalues on both sides of the border, and how narrow its enclosures are."""
    figure, (left, right) = _panels()
    sides = {
        f"{style.word(side.word)} at {proof.name} {way} the border": _middles(side)
        for side, way in zip(proof.sides, ("below", "above"), strict=False)
    }
    _paint(left, {name: values for name, values in sides.items() if len(values)})
    enclosed = [*proof.apex, *([] if proof.value is None else [proof.value])]
    names, radii = [*COORDINATES, proof.name][: len(enclosed)], [float(x.rad()) for x in enclosed]
    _radii(right, names, radii, proof.values)
    return figure


def _middles(proof: Proof) -> NDArray[np.complex128]:
    """Centres of the discs that the eigenvalues are proved to be in."""
    return np.array([complex(value) for value in proof.eigenvalues])


def _panels() -> tuple[Figure, tuple[Axes, Axes]]:
    figure, (left, right) = style.subplots(1, 2, figsize=(9.6, 4.6))
    return figure, (left, right)


def _paint(axes: Axes, sets: Mapping[str, NDArray[Any]]) -> None:
    """Sets of eigenvalues in the complex plane, with the circle inside which deviations die out."""
    turn = np.linspace(0.0, 2.0 * np.pi, 361)
    axes.plot(np.cos(turn), np.sin(turn), label="unit circle", **style.LIMIT_LINE)
    for (name, values), marker in zip(sets.items(), MARKERS, strict=False):
        axes.plot(values.real, values.imag, linestyle="", label=name, **marker)
    axes.set_aspect("equal", adjustable="datalim")
    style.label(axes, "real part of the eigenvalue", "imaginary part of the eigenvalue")
    axes.figure.legend(*axes.get_legend_handles_labels(), loc="outside lower left", ncols=3)


def _bars(axes: Axes, rows: NDArray[np.float64], names: Sequence[str], columns: Sequence[str]) -> None:
    """A group of bars at each column, a bar of each row."""
    width, at = 0.8 / len(rows), np.arange(len(columns))
    for number, (row, name) in enumerate(zip(rows, names, strict=True)):
        axes.bar(at + (number - 0.5 * (len(rows) - 1)) * width, row, width, label=name)
    axes.axhline(0.0, color=style.INK, linewidth=0.8)
    axes.set_xticks(at, columns, rotation=30.0, ha="right")
    axes.figure.legend(*axes.get_legend_handles_labels(), loc="outside upper right", ncols=2)


def _radii(axes: Axes, names: Sequence[str], radii: Sequence[float], values: Mapping[str, Exact]) -> None:
    """Half-widths of enclosures."""
    variables = VARIABLES
    floats = {name: float(values[name].rational) for name in paper_units.SCALES if name in values}
    units = {
        name: paper_units.label(variables[f"apex.{name}" if name in COORDINATES else name].unit, floats)
        for name in names
    }
    shown = [style.with_unit(name.replace("_", " "), units[name]) for name in names]
    axes.barh(shown, np.maximum(radii, NARROWEST), color=style.SECOND_CURVE)
    axes.set_xscale("log")
    axes.invert_yaxis()
    style.label(axes, "radius of the enclosure, in the unit of each", "what is enclosed")


def _mode(value: complex) -> str:
    return (
        f"{value.real:.3g}" if value.imag == 0.0 else f"{value.real:.3g}{value.imag:+.3g}i".replace("-", "−")
    )
