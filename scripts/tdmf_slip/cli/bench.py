"""The command `bench`: runs the benchmark of a checkout, whose folder `benchmarks` no wheel has."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

from ..errors import InputError
from .command import Answer, command, option

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


@command(
    "bench",
    option("--effort", kind=float, default=1.0),
    option("--growth", "of_growth", is_flag=True),
    option("--swing-clamp/--no-swing-clamp", default=None),
    runner=False,
)
def bench_command(effort: float, of_growth: bool, swing_clamp: bool | None) -> Answer:
    """Time the solvers and the ensemble engine against other programs at equal accuracy.

    Before anything is timed, all programs must agree on the strides, with and without the clamp.

    Parameters
    ----------
    effort
        Factor on the time spent measuring.
    of_growth
        Measure instead how the time of whole tasks grows with their size: basin, ensembles, optimize,
        fit, continue.
    swing_clamp
        Value of hip.swing_clamp for the timed runners.  [default: the unit's own]
    """
    _find_benchmarks()
    measured: Growth | Bench
    if of_growth:
        from benchmarks.growth import growth

        measured = growth(effort=effort, progress=True)
    else:
        from benchmarks.running import bench

        measured = bench(effort=effort, swing_clamp=swing_clamp, progress=True)
    return Answer(measured.as_json(), measured.as_text())
