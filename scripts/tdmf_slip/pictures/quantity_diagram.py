"""Quantities of gaits: changes of all of them over those of a reference, and one over another."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..analysis.attraction import CONFIDENCE
from ..analysis.first_passage import FirstPassage
from ..analysis.rare_falls import RareFalls
from ..errors import InputError, counted
from ..library.gait import first_runner_in
from ..library.quantities import QUANTITIES, known_quantities, quantities_of, unit_of
from ..library.runner import Runner
from . import style

if TYPE_CHECKING:
    import xarray

    from ..optimization.optimum import Optimum
    from ..proof.prove_attraction import Attraction

POINTS = 400
SPAN = (1e-2, 10.0)
"""Least and largest number of strides that are drawn, over the mean."""
SMALLEST = 1e-6
"""Share of the first distance to which a deviation is followed."""


def of_falls(found: FirstPassage | RareFalls) -> Figure:
    """The probability of still being up after so many strides, with the interval of the mean.

    The number of strides until the fall is geometric, once the start is forgotten.
    """
    low, high = found.interval
    mean = found.mean_strides if math.isfinite(found.mean_strides) else low
    strides = np.geomspace(max(1.0, SPAN[0] * low), SPAN[1] * (high if math.isfinite(high) else mean), POINTS)
    figure, axes = style.subplots(figsize=(6.8, 4.4))
    bounds = (_still_up(strides, low), _still_up(strides, high))
    axes.fill_between(strides, *bounds, color=style.GROUND, label=f"{CONFIDENCE:.0%} interval", linewidth=0)
    if math.isfinite(found.mean_strides):
        label = f"mean {mean:.4g} strides until the fall"
        axes.plot(strides, _still_up(strides, mean), color=style.CURVE, label=label)
    axes.set_xscale("log")
    axes.set_ylim(0.0, 1.02)
    style.label(axes, "strides begun", "probability of not having fallen")
    axes.set_title(
        f"gait {style.word(found.word)} on steps of {found.roughness:.4g} m, {counted(found.falls, 'fall')}"
    )
    figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=2)
    return figure


def _still_up(strides: np.ndarray, mean: float) -> np.ndarray:
    """The probability that none of so many strides ends in a fall, each of which does with 1/mean."""
    return np.exp(strides * math.log1p(-1.0 / mean)) if mean > 1.0 else np.zeros(len(strides))


def of_attraction(proof: Attraction) -> Figure:
    """The proved bound on the distance from the gait, stride by stride."""
    if not proof.proved:
        raise InputError(f"plot: the attraction is undecided, {proof.undecided}; allowed: a proved one")
    count = max(1, math.ceil(math.log(SMALLEST) / math.log(proof.rate))) if proof.rate > 0.0 else 1
    strides = np.arange(count + 1)
    figure, axes = style.subplots(figsize=(6.8, 4.4))
    axes.plot(strides, proof.norm_radius * proof.rate**strides, ".-", color=style.CURVE, markersize=4.0)
    axes.set_yscale("log")
    style.label(axes, "strides", "largest distance from the gait, in the norm of the proof")
    axes.set_title(f"every apex within {proof.radius:.3g} of the scales; rate {proof.rate:.4g} a stride")
    return figure


LAMBDA_MAX = "lambda_max"
ZERO = 1e-12
"""Smallest value of a reference for which a relative change is drawn."""
HEIGHT, BAR = 1.6, 0.2
"""Heights of a figure without bars, and of a row of bars, inches."""


def of_optimum(found: Optimum) -> Figure:
    """Changes by the optimum: quantities of the gait, and the parameters that were varied."""
    names = known_quantities(found.gait.runner)
    before = quantities_of(found.before, names) | {LAMBDA_MAX: found.before.lambda_max}
    after = quantities_of(found.gait, names) | {LAMBDA_MAX: found.gait.lambda_max}
    given = {name: found.before.runner[name] for name in found.parameters}
    rows = len(before) + len(given)
    size, ratios = (7.6, HEIGHT + BAR * rows), [len(before), max(2, len(given))]
    figure, (upper, lower) = style.subplots(2, 1, figsize=size, height_ratios=ratios)
    _changes(upper, before, {"optimum": after}, bold=(found.objective,))
    _changes(lower, given, {"optimum": found.parameters})
    style.label(upper, "change from the runner that was given (%)", "quantity")
    style.label(lower, "change from the runner that was given (%)", "parameter")
    upper.set_title(f"{'least' if found.is_minimum else 'most'} {style.in_words(found.objective)}")
    return figure


def of_comparison(data: xarray.Dataset) -> Figure:
    """Differences between the matched runners' quantities and the reference's; held quantities are bold."""
    after = data.sel(step="after")
    names = [name for name in (*QUANTITIES, LAMBDA_MAX) if np.isfinite(after[name]).any()]
    reference, *others = (
        {name: float(after[name].values[number]) for name in names} for number in range(after.sizes["runner"])
    )
    figure, axes = style.subplots(figsize=(7.6, HEIGHT + BAR * len(reference) * max(1, len(others))))
    runners = {f"runner {number}": values for number, values in enumerate(others, 1)}
    _changes(axes, reference, runners, bold=data.hold.split(", "))
    style.label(axes, "difference from runner 0 (%)", "quantity; bold: held")
    figure.legend(*axes.get_legend_handles_labels(), loc="outside upper right", ncols=4)
    return figure


def of_front(data: xarray.Dataset) -> Figure:
    """One objective over the other, a mark for each runner; hollow where its gait is unstable."""
    objectives = data.objectives.split(", ")
    points = np.column_stack([data[name].values for name in objectives])
    figure, axes = style.subplots(figsize=(6.4, 4.6))
    axes.plot(*points.T, color=style.FAINT, linewidth=1.0, zorder=1)
    stable = data[LAMBDA_MAX].values < 1.0
    for where, name, face in ((stable, "stable", style.SECOND_CURVE), (~stable, "unstable", "white")):
        if where.any():
            axes.plot(
                *points[where].T,
                linestyle="",
                marker="o",
                color=style.SECOND_CURVE,
                markerfacecolor=face,
                label=name,
            )
    runner = first_runner_in(data)
    style.label(axes, *(_with_unit(name, runner) for name in objectives))
    figure.legend(*axes.get_legend_handles_labels(), loc="outside upper right", ncols=2)
    return figure


def _changes(
    axes: Axes,
    reference: Mapping[str, float],
    others: Mapping[str, Mapping[str, float]],
    bold: Sequence[str] = (),
) -> None:
    """Draw relative changes in per cent, as bars; a quantity that is zero in the reference has no bar."""
    names = list(reference)
    width = 0.8 / max(1, len(others))
    for number, (label, values) in enumerate(others.items()):
        changes = [
            100.0 * (values[name] / reference[name] - 1.0) if abs(reference[name]) > ZERO else np.nan
            for name in names
        ]
        axes.barh(
            np.arange(len(names)) + (number - 0.5 * (len(others) - 1)) * width, changes, width, label=label
        )
    axes.axvline(0.0, color=style.INK, linewidth=0.8)
    shown = [
        style.in_words(name) + ("" if abs(reference[name]) > ZERO else " (reference: 0)") for name in names
    ]
    axes.set_yticks(range(len(names)), shown)
    for name, text in zip(names, axes.get_yticklabels(), strict=True):
        text.set_fontweight("bold" if name in bold else "normal")
    axes.set_ylim(len(names) - 0.4, -0.6)


def _with_unit(name: str, runner: Runner) -> str:
    return style.with_unit(style.in_words(name), runner.label(unit_of(name)))
