"""Why slipping pays: where the hip's work goes, per weight and stride length, against friction."""

from collections.abc import Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...analysis.sweeps import Row
from ...library.gait import Gait
from ...library.quantities import weight_of
from ...pictures import style
from . import figure_9
from .columns import Columns, Data, as_columns, attributes, select

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


def table(sweep: Row, matched: Sequence[Gait]) -> Data:
    """Data of the figure by column: energies per weight and stride length. `matched` is 1 or 0."""
    rows = [*sweep.gaits, *matched]
    return {
        "matched": [0] * len(sweep.gaits) + [1] * len(matched),
        **attributes(rows, "friction", "word", "cost_of_transport"),
        **{
            name: [gait.stride[name] / (weight_of(gait.runner) * gait.stride["length"]) for gait in rows]
            for name in SHARES
        },
    }


def draw(sweep: Row, matched: Sequence[Gait]) -> Figure:
    """Draw the stacked losses and the hip's work, for the paper's runner and for matched runners."""
    figure, panels = style.subplots(2, 1, figsize=(7.6, 7.6), sharex=True, sharey=True)
    data = as_columns(table(sweep, matched))
    for number, (axes, title) in enumerate(zip(panels, TITLES, strict=True)):
        _draw_shares(axes, select(data, matched=number))
        axes.set_title(title, pad=18 if axes is panels[0] else None)
    figure_9.mark_borders(panels[0], sweep)
    figure_9.name_words(panels[0], sweep)
    figure_9.friction_axis(panels[1], [gait.friction for gait in sweep.gaits])
    panels[0].set_ylim(0.0, 1.2 * data["cost_of_transport"].max())
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=4)
    return figure


def _draw_shares(axes: Axes, data: Columns) -> None:
    axes.stackplot(
        data["friction"],
        [data[name] for name in SHARES],
        labels=[label for label, _ in SHARES.values()],
        colors=[colour for _, colour in SHARES.values()],
        linewidth=0,
    )
    axes.plot(data["friction"], data["cost_of_transport"], color=style.INK, label="work of the hip")
    axes.set_ylabel("energy per stride (weight × stride length)")
