"""The two largest eigenvalues of gaits along a branch, with their signs."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from ...analysis.branches import Branch
from ...analysis.special_points import FOLD, PERIOD_DOUBLING
from ...library.gait import Gait
from ...pictures import style

COLOURS = (style.CURVE, style.SECOND_CURVE)
MARKS: Mapping[str, str] = {FOLD: "o", PERIOD_DOUBLING: "s"}


def leading(gaits: Sequence[Gait]) -> NDArray[np.float64]:
    """Real parts of the two eigenvalues of largest modulus, the greater one first, shape (gaits, 2)."""
    return np.array([np.sort(gait.eigenvalues[:2].real)[::-1] for gait in gaits])


def as_columns(gaits: Sequence[Gait]) -> dict[str, NDArray[np.float64]]:
    """Both eigenvalues by column."""
    return dict(zip(("greater_eigenvalue", "other_eigenvalue"), leading(gaits).T, strict=True))


def draw(axes: Axes, values: Sequence[float], gaits: Sequence[Gait], *, named: bool = False) -> None:
    """Draw both against a parameter, solid for stable gaits, with the borders of stability."""
    stable = np.array([gait.stable for gait in gaits])
    for heights, colour, name in zip(
        leading(gaits).T,
        COLOURS,
        ("largest eigenvalue, of speed", "second eigenvalue, of height"),
        strict=True,
    ):
        style.stable_curve(axes, values, heights, stable, colour, label=name if named else None)
    for border in (-1.0, 1.0):
        axes.axhline(border, **style.LIMIT_LINE)


def mark(axes: Axes, branch: Branch, *, named: bool = False) -> None:
    """Mark folds at +1 and period doublings at -1."""
    for kind, marker in MARKS.items():
        found = [special.value for special in branch.specials if special.kind == kind]
        height = 1.0 if kind == FOLD else -1.0
        axes.plot(
            found,
            np.full(len(found), height),
            marker,
            color=style.MODE_COLOURS["slip_negative"],
            markersize=5,
            zorder=4,
            label=kind if named else None,
        )
