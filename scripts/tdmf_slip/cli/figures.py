"""The command `figures`: the paper's figures, remade."""

from pathlib import Path

import click

from ..errors import InputError
from ..files.whole import check_folder
from .options import Command, Number

CENTIMETRES_PER_INCH = 2.54
WIDTHS = 12.0, 100.0
"""Smallest and largest width, cm. Type keeps its size, and a narrower figure has no room for it."""
RESOLUTIONS = 20.0, 2400.0


@click.command("figures", cls=Command)
@click.option(
    "--output",
    "folder",
    type=click.Path(path_type=Path),
    default=Path("figures"),
    metavar="FOLDER",
    help="Folder to write to.",
)
@click.option(
    "--only",
    metavar="NAMES",
    default="",
    show_default=False,
    help="Draw only the figures whose names begin with one of these, as in figure_9,energy.",
)
@click.option(
    "--measure",
    is_flag=True,
    help="Recompute the data that take minutes instead of reading the stored ones.",
)
@click.option(
    "--format",
    "formats",
    metavar="NAMES",
    default="png,svg",
    help="Formats of the files, separated by commas: png, svg, pdf.",
)
@click.option(
    "--width",
    type=Number(*WIDTHS),
    metavar="CM",
    help="Width of each figure; the height follows, and the font size stays.  [default: each its own]",
)
@click.option(
    "--resolution",
    type=Number(*RESOLUTIONS),
    metavar="DPI",
    help="Resolution of PNG files in dots per inch.  [default: each its own]",
)
@click.option(
    "--style",
    "style_name",
    type=click.Choice(["house", "print", "slides"]),
    default="house",
    help="Fonts and line widths: house for a screen, print for a journal, slides for a projector.",
)
def figures_command(
    folder: Path,
    only: str,
    measure: bool,
    formats: str,
    width: float | None,
    resolution: float | None,
    style_name: str,
) -> None:
    """Draw the paper's figures and our own, each with its data as CSV."""
    from ..paper.figures import catalogue  # matplotlib is slow to load
    from ..pictures import style

    check_folder(folder, "--output")
    style.check_drawing("--output")
    names = list(dict.fromkeys(name.strip().lower() for name in formats.split(",")))
    begins = [name.strip() for name in only.split(",") if name.strip()]
    unknown = [name for name in names if name not in catalogue.FORMATS]
    if unknown:
        raise InputError(f"--format {formats}: {unknown[0]!r}: allowed: {', '.join(catalogue.FORMATS)}")
    appearance = style.Appearance(
        width=None if width is None else width / CENTIMETRES_PER_INCH,
        dots_per_inch=resolution,
        style=style_name,
    )
    written = catalogue.draw(
        folder,
        only=begins or [""],
        measure=measure,
        formats=names,
        appearance=appearance,
        progress=True,
    )
    for path in written:
        print(path)
