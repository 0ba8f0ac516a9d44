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
    help="Scales how long is measured.",
)
@click.option(
    "--growth",
    "of_growth",
    is_flag=True,
    help="Instead, how the time of whole questions grows with their size: basin, ensembles, optimize, fit, "
    "continue.",
)
@click.option(
    "--swing-clamp/--no-swing-clamp",
    default=None,
    help="Value of hip.swing_clamp for the runners that are timed; by default the unit's own.",
)
@JSON_OPTION
def bench_command(effort: float, of_growth: bool, swing_clamp: bool | None, as_json_object: bool) -> None:
    """Solvers and the ensemble engine against their peers, on the same strides at equal accuracy.

    Nothing is timed before all of them have made the same strides, with the clamp and without it.
    """
    measured: Growth | Bench
    if of_growth:
        from ..bench.growth import growth  # what it asks is slow to load

        measured = growth(effort=effort, progress=True)
    else:
        measured = bench(effort=effort, swing_clamp=swing_clamp, progress=True)
    print(json_text(measured.as_json()) if as_json_object else measured.as_text())
