"""The command `bench`: this project against its peers."""

import click

from ..bench.running import bench
from .options import JSON_OPTION, Command
from .output import json_text


@click.command("bench", cls=Command)
@click.option(
    "--effort",
    type=float,
    default=1.0,
    show_default=True,
    help="Scales how long is measured.",
)
@JSON_OPTION
def bench_command(effort: float, as_json_object: bool) -> None:
    """Solvers and the ensemble engine against their peers, on the same strides at equal accuracy."""
    measured = bench(effort=effort, progress=True)
    print(json_text(measured.as_json()) if as_json_object else measured.as_text())
