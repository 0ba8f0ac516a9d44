"""The command `figures`: the paper's figures, remade."""

from pathlib import Path

import click

from ..files.whole import check_folder
from ..unit.unit import load
from .options import Command


@click.command("figures", cls=Command)
@click.option(
    "--output",
    "folder",
    type=click.Path(path_type=Path),
    default=Path("figures"),
    show_default=True,
    metavar="FOLDER",
    help="Where the figures go.",
)
@click.option("--only", metavar="NAME", help="Only the figures whose name begins like this, as in figure_9.")
def figures_command(folder: Path, only: str | None) -> None:
    """The paper's figures, remade: PNG and SVG, with the data of each beside it as CSV."""
    from ..paper.figures import catalogue  # matplotlib is slow to load

    check_folder(folder, "--output")
    for path in catalogue.draw(folder, load(), only=only, show_progress=True):
        print(path)
