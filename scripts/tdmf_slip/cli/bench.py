"""The command `bench`: this project against its peers."""

from typing import TYPE_CHECKING

import click

from ..bench.results import Bench
from ..bench.running import bench
from .options import JSON_OPTION, Command
from .output import json_text

if TYPE_CHECKING:
    from ..bench.growth import Growth


@click.command("bench", cls=Command)
@click.option(
    "--effort",
    type=float,
    default=1.0,
    show_default=True,
    help="Factor on the time spent measuring.",
)
@click.option(
    "--growth",
    "of_growth",
    is_flag=True,
    help="Measure instead how the time of whole tasks grows with their size: basin, ensembles, optimize, "
    "fit, continue.",
)
@click.option(
    "--swing-clamp/--no-swing-clamp",
    default=None,
    help="Value of hip.swing_clamp for the timed runners.  [default: the unit's own]",
)
@JSON_OPTION
def bench_command(effort: float, of_growth: bool, swing_clamp: bool | None, as_json_object: bool) -> None:
    """Time the solvers and the ensemble engine against other programs at equal accuracy.

    Before anything is timed, all programs must agree on the strides, with and without the clamp.
    """
    measured: Growth | Bench
    if of_growth:
        from ..bench.growth import growth  # what it asks is slow to load

        measured = growth(effort=effort, progress=True)
    else:
        measured = bench(effort=effort, swing_clamp=swing_clamp, progress=True)
    print(json_text(measured.as_json()) if as_json_object else measured.as_text())
