"""Gaits over two parameters: how fast they are, and by which word they go."""

import matplotlib
import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from ..analysis.grid_result import GaitGrid
from ..errors import InputError
from ..variables import paper_units
from ..variables.display_units import DisplayUnits
from . import style
from .basin_map import edges_of

WORD_COLOURS = matplotlib.colormaps["tab20"].colors  # type: ignore[attr-defined] # a list of colours


def _runner_of(grid: GaitGrid) -> dict[str, float]:
    """Mass, stiffness and length where the grid does not vary them."""
    return {name: grid.attributes[name] for name in paper_units.SCALES if name in grid.attributes}


def figure_of(grid: GaitGrid) -> Figure:
    """Speed on the left, words on the right; white where no gait was found."""
    if not grid.gaits:
        raise InputError("plot: a grid without gaits; allowed: one that has some")
    vertical, horizontal = grid.axes
    edges = edges_of(grid[horizontal]), edges_of(grid[vertical])
    display = DisplayUnits(values=_runner_of(grid))
    with style.styled():
        figure, panels = style.subplots(1, 2, figsize=(10.4, 4.6), sharey=True)
        speeds = np.ma.masked_invalid(grid["speed"])
        mesh = panels[0].pcolormesh(*edges, speeds, cmap="viridis", rasterized=True)
        figure.colorbar(mesh, ax=panels[0], label=style.with_unit("speed", display.label("m/s")), pad=0.01)
        handles = []
        for number, word in enumerate(grid.words):
            colour = WORD_COLOURS[number % len(WORD_COLOURS)]
            there = np.ma.masked_where(grid["word"] != word, np.zeros(speeds.shape))
            panels[1].pcolormesh(*edges, there, cmap=ListedColormap([colour]), rasterized=True)
            handles.append(Patch(color=colour, label=style.word(word)))
        panels[1].legend(handles=handles, title="word", loc="upper left", bbox_to_anchor=(1.01, 1.0))
        for axes in panels:
            axes.set_xlabel(style.tell_in(axes.xaxis, horizontal, display))
        panels[0].set_ylabel(style.tell_in(panels[0].yaxis, vertical, display))
        panels[0].set_title(f"{grid.gaits:,} of {grid['word'].size:,} gaits")
    return figure
