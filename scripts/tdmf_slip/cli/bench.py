"""The command `bench`: runs the benchmark of a checkout, whose folder `benchmarks` no wheel has."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..errors import InputError
from .options import JSON_OPTION, Command, json_text

if TYPE_CHECKING:
    from benchmarks.growth import Growth
    from benchmarks.results import Bench


def _find_benchmarks() -> None:
    """Make `benchmarks` importable from the checkout that the working directory is in."""
    here = Path.cwd()
    for folder in (here, *here.parents):
        if (folder / "benchmarks" / "running.py").is_file():
            sys.path.insert(0, str(folder))
            return
    raise InputError(f"{here} is not in a checkout of TDMF-SLIP, whose folder benchmarks holds the benchmark")


@click.command("bench", cls=Command)
@click.option(
    "--effort",
    type=float,
    default=1.0,
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
    _find_benchmarks()
    measured: Growth | Bench
    if of_growth:
        from benchmarks.growth import growth

        measured = growth(effort=effort, progress=True)
    else:
        from benchmarks.running import bench

        measured = bench(effort=effort, swing_clamp=swing_clamp, progress=True)
    print(json_text(measured.as_json()) if as_json_object else measured.as_text())
