"""Losses that the hip's work pays for, per weight and stride length, against friction."""

from functools import partial

import pandas
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...library.gait import Gait
from ...library.quantities import weight_of
from ...pictures import style
from .data import Results, table_by
from .over_friction import friction_axis, mark_words

SHARES = {
    "impact_loss": ("lost at the impact", "#1f5fa8"),
    "damper_loss": ("lost in the damper", "#9bb8d3"),
    "friction_loss": ("lost to friction", "#e07b00"),
}
"""Labels and colours of the losses, from bottom to top."""
TITLES = (
    "(a) the paper's runner: only friction varies",
    "(b) every runner with the speed, apex height and leg angle of the gait at friction 10",
)


def table(results: Results) -> pandas.DataFrame:
    """Energies per weight and stride length. `matched` is 1 for runners matched to the first gait."""
    losses = {name: partial(_per_distance, name) for name in SHARES}
    return table_by(["matched"], results.both, "friction", "word", "cost_of_transport", **losses)


def _per_distance(name: str, gait: Gait) -> float:
    energy: float = gait.stride[name] / (weight_of(gait.runner) * gait.stride["length"])
    return energy


def draw(results: Results) -> Figure:
    """Draw the stacked losses and the hip's work, for the paper's runner and for matched runners."""
    figure, panels = style.subplots(2, 1, figsize=(7.6, 7.6), sharex=True, sharey=True)
    data = results.table("energy")
    for number, (axes, title) in enumerate(zip(panels, TITLES, strict=True)):
        _draw_shares(axes, data[data["matched"] == number])
        axes.set_title(title, pad=18 if axes is panels[0] else None)
    mark_words(panels[:1], results.sweep)
    friction_axis(panels[1], data["friction"])
    panels[0].set_ylim(0.0, 1.2 * data["cost_of_transport"].max())
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=4)
    return figure


def _draw_shares(axes: Axes, data: pandas.DataFrame) -> None:
    labels, colours = zip(*SHARES.values(), strict=True)
    axes.stackplot(data["friction"], data[[*SHARES]].T, labels=labels, colors=colours, linewidth=0)
    axes.plot(data["friction"], data["cost_of_transport"], color=style.INK, label="work of the hip")
    axes.set_ylabel("energy per stride (weight × stride length)")
