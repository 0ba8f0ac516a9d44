"""Pictures of models of one's own: the outputs and states of a run over time."""

from typing import TYPE_CHECKING

from matplotlib.figure import Figure

from ..errors import InputError
from ..fmu.simulation import simulate
from ..library.gait import Gait
from . import style

if TYPE_CHECKING:
    import xarray

MAX_PANELS = 8
"""Largest number of quantities that are drawn; outputs come first."""


def of_gait(gait: Gait) -> Figure:
    """The outputs and states over the strides of a gait."""
    run: xarray.Dataset = simulate(gait, stop_time=gait.period)
    return figure_of(run)


def figure_of(run: "xarray.Dataset") -> Figure:
    """A panel for each output and state; dashed lines where the mode changes."""
    moving = [name for name, of in run.data_vars.items() if name != "mode" and len(set(of.values)) > 1]
    if not moving:
        raise InputError("plot: a trajectory on which nothing changes; allowed: one that moves")
    times, modes = run["time"].values, run["mode"].values
    pairs = zip(times[1:], modes, modes[1:], strict=False)
    changes = [time for time, before, after in pairs if before != after]
    with style.styled():
        count = min(MAX_PANELS, len(moving))
        figure, panels = style.subplots(
            count, 1, figsize=(7.6, 1.0 + 1.3 * count), sharex=True, squeeze=False
        )
        for axes, name in zip(panels[:, 0], moving, strict=False):
            axes.plot(times, run[name].values, color=style.CURVE)
            axes.set_ylabel(style.with_unit(str(name), run[name].attrs["units"]))
            for time in changes:
                axes.axvline(time, **style.LIMIT_LINE)
        panels[-1, 0].set_xlabel(style.with_unit("time", "s"))
    return figure
