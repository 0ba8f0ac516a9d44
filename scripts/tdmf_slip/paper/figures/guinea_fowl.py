"""Falls of runners of a guinea fowl's size on a slippery patch, by speed and contact angle."""

import numpy as np
import pandas
import xarray
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from ...pictures import style
from .. import guinea_fowl
from .data import Results

FALLS, UP = "#b3216f", "#cfe8e6"
NOT_CONTROLLED = (
    "At each speed only the contact angle varies. Apex height, hip torque and retraction change with speed."
)
"""Text above the panels."""
SHOWN = (50.5, 75.5)
"""Range of contact angles on the axis, degrees."""


def table(_: Results) -> pandas.DataFrame:
    """Data of the figure, for all angles at which the leg can be placed."""
    found = guinea_fowl.fall_map()[["fell", "slip_distance"]].to_dataframe().reset_index()
    return found[found["fell"].notna()]


def draw(_: Results) -> Figure:
    """Draw a panel for each friction on the patch; in the last one it is that of the ground."""
    found = guinea_fowl.fall_map()
    figure, panels = style.subplots(2, 2, figsize=(7.6, 6.6), sharex=True, sharey=True)
    for axes, friction in zip(panels.flat, found["friction"].values, strict=True):
        _panel(axes, found.sel(friction=friction))
    for axes in panels[1]:
        axes.set_xlabel("speed (m/s)")
    for axes in panels[:, 0]:
        axes.set_ylabel("contact angle of the leg (°)")
    figure.suptitle(NOT_CONTROLLED, fontsize=9)
    figure.legend(handles=_key(), loc="outside lower center", ncols=3)
    return figure


def _panel(axes: Axes, found: xarray.Dataset) -> None:
    fell, slips = found["fell"].values, found["slip_distance"].values
    speeds, angles, friction = (found[name].values for name in ("speed", "contact_angle", "friction"))
    said = guinea_fowl.published()["published"]
    axes.pcolormesh(
        speeds,
        angles,
        fell.T,
        cmap=ListedColormap([UP, FALLS]),
        vmin=0.0,
        vmax=1.0,
        shading="nearest",
    )
    slipped = (fell == 0.0) & (slips >= said["slip_distance"])
    rows, columns = np.nonzero(slipped)
    axes.plot(speeds[rows], angles[columns], ".", color=style.INK, markersize=3)
    axes.plot(speeds, found["own_angle"].values, color=style.SECOND_CURVE)
    axes.axhline(said["contact_angle"], **style.LIMIT_LINE)
    axes.axvline(said["fast"], **style.LIMIT_LINE)
    high = guinea_fowl.published()["runner"]["high_friction"]
    axes.set_title(
        f"friction {friction:g}" + (": the patch is like the ground" if friction == high else " on the patch")
    )
    axes.set_ylim(*SHOWN)


def _key() -> list[Line2D | Patch]:
    return [
        Patch(color=FALLS, label="falls"),
        Patch(color=UP, label="stays up"),
        Line2D(
            [],
            [],
            color=style.INK,
            marker=".",
            markersize=4,
            linestyle="",
            label="stays up after slipping at least 10 cm",
        ),
        Line2D([], [], color=style.SECOND_CURVE, label="contact angle of the gait"),
        Line2D([], [], **style.LIMIT_LINE, label="70° and 3 m/s, as in Clark and Higham"),
    ]
