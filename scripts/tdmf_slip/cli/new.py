"""The command `new`: begins a page of one's own."""

from pathlib import Path

import click

from ..building.new import STARTS, new
from .options import Command


@click.command("new", cls=Command)
@click.argument("folder", type=click.Path(path_type=Path))
@click.option(
    "--from",
    "start",
    type=click.Choice(STARTS),
    default="runner",
    help="runner: override one law of the runner. scratch: a bouncing ball.",
)
def new_command(folder: Path, start: str) -> None:
    """Begin a page of your own: a folder with a page, parameters, a test and a README.

    The folder's name is that of the model, as in my_runner.
    """
    made = new(folder, start=start)
    for path in sorted(made.iterdir()):
        print(path)
