"""Why slipping pays: where the hip's work of a stride goes, over the friction, by weight and length."""

from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np

from ...analysis.sweep import Sweep
from ...pictures import style
from . import figure_9
from .columns import Columns

SHARES = {
    "impact_loss": ("impact", "#1f5fa8"),
    "damper_loss": ("damper", "#9bb8d3"),
    "friction_loss": ("friction", "#e07b00"),
}
"""Names and colours of what takes energy, from below."""


def table(sweep: Sweep) -> Columns:
    """The figure's data, by column: energies of a stride over weight and length."""
    columns: dict[str, list[Any]] = {
        "friction": [],
        "word": [],
        "cost_of_transport": [],
        **{n: [] for n in SHARES},
    }
    for gait in sweep.gaits:
        values = gait.runner.values
        weight = (values["body.mass"] + values["foot.mass"]) * values["gravity"]
        columns["friction"].append(gait.friction)
        columns["word"].append(gait.word)
        columns["cost_of_transport"].append(gait.stride["cost_of_transport"])
        for name in SHARES:
            columns[name].append(gait.stride[name] / (weight * gait.stride["length"]))
    return columns


def draw(path: Path, sweep: Sweep) -> None:
    """Draw the losses one on the other, under the hip's work."""
    data = table(sweep)
    with style.styled():
        figure, axes = plt.subplots(figsize=(7.6, 4.4), layout="constrained")
        axes.stackplot(
            data["friction"],
            [data[name] for name in SHARES],
            labels=[label for label, _ in SHARES.values()],
            colors=[colour for _, colour in SHARES.values()],
            linewidth=0,
        )
        axes.plot(data["friction"], data["cost_of_transport"], color=style.INK, label="work of the hip")
        figure_9.mark_borders(axes, sweep)
        figure_9.name_words(axes, sweep, height=0.2)
        figure_9.friction_axis(axes, data["friction"])
        axes.set_ylim(0.0, 1.2 * np.max(data["cost_of_transport"]))
        axes.set_ylabel("energy of a stride  / weight · length")
        axes.legend(loc="upper center", ncols=4)
        style.save(figure, path)
