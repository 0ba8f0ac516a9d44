"""The command `new`: begins a page of your own."""

from pathlib import Path

import click

from ..building.new import STARTS, new
from .command import Answer, command, option


@command(
    "new",
    click.argument("folder", type=click.Path(path_type=Path)),
    option("--from", "start", of=new, kind=click.Choice(STARTS)),
    runner=False,
    as_json=False,
)
def new_command(folder: Path, start: str) -> Answer:
    """Start a page of your own: a folder with a page, parameters, a test and a README.

    The folder's name is that of the model, as in my_runner.
    """
    return Answer({}, "\n".join(map(str, sorted(new(folder, start=start).iterdir()))))
