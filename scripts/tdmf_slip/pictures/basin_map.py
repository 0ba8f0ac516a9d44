"""A region of attraction: how many strides each start takes to settle on the gait, or until it falls."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import xarray
from matplotlib.patches import Patch

from . import style

NAMES = {
    "com_height": "height of the centre of mass",
    "com_speed": "speed of the centre of mass",
    "leg_length": "leg length",
    "leg_angle": "leg angle",
    "leg_length_rate": "rate of leg length",
    "leg_angle_rate": "rate of leg angle",
}
"""Of the section's coordinates, at the apex."""
OTHERS = {"undecided": "#f3d27a", "no_start": "#ffffff", "unsolved": "#8a8a8a"}


def draw(path: Path, data: xarray.Dataset) -> None:
    """Draw the map: starts that settle in blue, those that fall in red, by strides; the gait as a cross."""
    vertical, horizontal = data["fate"].dims
    fates = data["fate"].attrs["flag_meanings"].split()
    fate, strides = data["fate"].values, data["strides"].values
    with style.styled():
        figure, axes = plt.subplots(figsize=(7.6, 5.4), layout="constrained")
        for name, colours in (("settled", "GnBu_r"), ("fell", "OrRd_r")):
            shown = np.ma.masked_where(fate != fates.index(name), strides)
            if shown.count():
                mesh = axes.pcolormesh(
                    data[horizontal], data[vertical], shown, cmap=colours, shading="nearest"
                )
                figure.colorbar(mesh, ax=axes, label=f"strides until the runner {_VERBS[name]}", pad=0.01)
        handles = []
        for name, colour in OTHERS.items():
            chosen = fate == fates.index(name)
            if chosen.any():
                rows, columns = np.nonzero(chosen)
                axes.plot(data[horizontal].values[columns], data[vertical].values[rows], ",", color=colour)
                handles.append(Patch(color=colour, label=name.replace("_", " ")))
        gait = data.attrs[f"gait_{horizontal}"], data.attrs[f"gait_{vertical}"]
        (cross,) = axes.plot(
            *gait, "+", color=style.INK, markersize=11, label=f"gait {style.word(data.attrs['word'])}"
        )
        axes.legend(handles=[cross, *handles], loc="upper right")
        style.label(axes, _label(data, horizontal), _label(data, vertical))
        style.save(figure, path)


_VERBS = {"settled": "settles", "fell": "falls"}


def _label(data: xarray.Dataset, axis: str) -> str:
    return f"{NAMES[axis]}  in {data[axis].attrs['units']}"
