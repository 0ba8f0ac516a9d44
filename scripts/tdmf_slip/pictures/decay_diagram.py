"""Decay from stride to stride: runners that are still up, or a deviation that is proved to die out."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from ..analysis.attraction import CONFIDENCE
from ..analysis.first_passage import FirstPassage
from ..analysis.rare_falls import RareFalls
from ..errors import InputError
from . import style

if TYPE_CHECKING:
    from ..proof.prove_attraction import Attraction

POINTS = 400
SPAN = (1e-2, 10.0)
"""Over the mean: strides that are drawn."""
SMALLEST = 1e-6
"""Share of the first distance: a deviation is followed until it is proved to be as small."""


def of_falls(found: FirstPassage | RareFalls) -> Figure:
    """The probability of still being up after so many strides, with the interval of the mean.

    The number of strides until the fall is geometric, once the start is forgotten.
    """
    low, high = found.interval
    mean = found.mean_strides if math.isfinite(found.mean_strides) else low
    strides = np.geomspace(max(1.0, SPAN[0] * low), SPAN[1] * (high if math.isfinite(high) else mean), POINTS)
    with style.styled():
        figure, axes = style.subplots(figsize=(6.8, 4.4))
        bounds = (_still_up(strides, low), _still_up(strides, high))
        axes.fill_between(
            strides, *bounds, color=style.GROUND, label=f"{CONFIDENCE:.0%} interval", linewidth=0
        )
        if math.isfinite(found.mean_strides):
            label = f"mean {mean:.4g} strides until the fall"
            axes.plot(strides, _still_up(strides, mean), color=style.CURVE, label=label)
        axes.set_xscale("log")
        axes.set_ylim(0.0, 1.02)
        style.label(axes, "strides begun", "probability of not having fallen")
        axes.set_title(
            f"gait {style.word(found.word)} on steps of {found.roughness:.4g} m, {found.falls:,} falls"
        )
        figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=2)
    return figure


def _still_up(strides: np.ndarray, mean: float) -> np.ndarray:
    """The probability that none of so many strides ends in a fall, each of which does with 1/mean."""
    return np.exp(strides * math.log1p(-1.0 / mean)) if mean > 1.0 else np.zeros(len(strides))


def of_attraction(proof: Attraction) -> Figure:
    """The proved bound on the distance from the gait, stride by stride."""
    if not proof.proved:
        raise InputError(f"plot: nothing is proved, {proof.undecided}; allowed: an attraction that is")
    count = max(1, math.ceil(math.log(SMALLEST) / math.log(proof.rate))) if proof.rate > 0.0 else 1
    strides = np.arange(count + 1)
    with style.styled():
        figure, axes = style.subplots(figsize=(6.8, 4.4))
        axes.plot(strides, proof.norm_radius * proof.rate**strides, ".-", color=style.CURVE, markersize=4.0)
        axes.set_yscale("log")
        style.label(axes, "strides", "largest distance from the gait, in the norm of the proof")
        axes.set_title(f"every apex within {proof.radius:.3g} of the scales; rate {proof.rate:.4g} a stride")
    return figure
