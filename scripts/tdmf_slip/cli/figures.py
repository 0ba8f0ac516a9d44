"""The command `figures`: the paper's figures, remade."""

from pathlib import Path

import click

from ..errors import InputError
from ..files.whole import check_folder
from .command import Answer, command, option
from .options import Number

CENTIMETRES_PER_INCH = 2.54
WIDTHS = 12.0, 100.0
"""Smallest and largest width, cm. Type keeps its size, and a narrower figure has no room for it."""
RESOLUTIONS = 20.0, 2400.0


@command(
    "figures",
    option("--output", "folder", kind=click.Path(path_type=Path), default=Path("figures"), metavar="FOLDER"),
    option("--only", metavar="NAMES", default="", show_default=False),
    option("--measure", is_flag=True),
    option("--format", "formats", metavar="NAMES", default="png,svg"),
    option("--width", kind=Number(*WIDTHS), metavar="CM"),
    option("--resolution", kind=Number(*RESOLUTIONS), metavar="DPI"),
    option("--style", kind=click.Choice(["house", "print", "slides"]), default="house"),
    runner=False,
    as_json=False,
)
def figures_command(
    folder: Path,
    only: str,
    measure: bool,
    formats: str,
    width: float | None,
    resolution: float | None,
    style: str,
) -> Answer:
    """Draw the paper's figures and our own, each with its data as CSV.

    Parameters
    ----------
    folder
        Folder to write to.
    only
        Draw only the figures whose names begin with one of these, as in figure_9,energy.
    measure
        Recompute the data that take minutes instead of reading the stored ones.
    formats
        Formats of the files, separated by commas: png, svg, pdf.
    width
        Width of each figure; the height follows, and the font size stays.  [default: each its own]
    resolution
        Resolution of PNG files in dots per inch.  [default: each its own]
    style
        Fonts and line widths: house for a screen, print for a journal, slides for a projector.
    """
    from ..paper.figures import catalogue  # matplotlib is slow to load
    from ..pictures.style import check_drawing

    check_folder(folder, "--output")
    check_drawing("--output")
    names = list(dict.fromkeys(name.strip().lower() for name in formats.split(",")))
    begins = [name.strip() for name in only.split(",") if name.strip()]
    unknown = [name for name in names if name not in catalogue.FORMATS]
    if unknown:
        raise InputError(f"--format {formats}: {unknown[0]!r}: allowed: {', '.join(catalogue.FORMATS)}")
    inches = None if width is None else width / CENTIMETRES_PER_INCH
    written = catalogue.draw(
        folder,
        only=begins or [""],
        measure=measure,
        formats=names,
        look=style,
        width=inches,
        dots_per_inch=resolution,
        progress=True,
    )
    return Answer({}, "\n".join(map(str, written)))
