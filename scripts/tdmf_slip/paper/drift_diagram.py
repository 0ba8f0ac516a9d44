"""Deviation of every value of the five gaits from its recorded reference, over the allowed deviation."""

import numpy as np
from matplotlib.figure import Figure

from ..errors import counted
from ..pictures import style
from .reference_gaits import Drift
from .validation import Validation

SMALLEST, LARGEST = 1e-6, 1e6
"""Least and largest share of the allowed drift that is drawn; shares beyond are drawn at these."""
OTHER = "of no single gait"


def of_validation(found: Validation) -> Figure:
    """Draw a mark for each value, over the share of the allowed deviation; values beyond the line differ."""
    drifts = found.drifts
    names = list(dict.fromkeys(_gait(drift) for drift in drifts))
    shares = np.clip([_share(drift) for drift in drifts], SMALLEST, LARGEST)
    rows = np.array([names.index(_gait(drift)) for drift in drifts])
    passed = np.array([drift.passed for drift in drifts], dtype=bool)
    figure, axes = style.subplots(figsize=(7.2, 3.8))
    for where, name, colour in (
        (passed, "as recorded", style.SECOND_CURVE),
        (~passed, "differs", style.MODE_COLOURS["slip_negative"]),
    ):
        if where.any():
            label = f"{name}: {counted(np.sum(where), 'value')}"
            axes.plot(shares[where], rows[where], "o", color=colour, alpha=0.5, label=label)
    axes.axvline(1.0, label="allowed", **style.LIMIT_LINE)
    axes.set_xscale("log")
    axes.set_yticks(range(len(names)), names)
    axes.set_ylim(len(names) - 0.5, -0.5)
    style.label(axes, f"deviation over what is allowed ({SMALLEST:g}: as little or less)", "gait at friction")
    figure.legend(*axes.get_legend_handles_labels(), loc="outside upper right", ncols=3)
    return figure


def _gait(drift: Drift) -> str:
    if not np.isfinite(drift.friction):
        return OTHER
    return ", ".join(filter(None, (f"{drift.friction:g}", drift.reading)))


def _share(drift: Drift) -> float:
    """Drift as a share of the allowed one; a word has to be the same."""
    if drift.allowed > 0.0:
        return drift.deviation / drift.allowed
    return 0.0 if drift.passed else LARGEST
