"""The command `validate`: what the paper says, published beside computed."""

from pathlib import Path

import click

from ..files.whole import check_folder
from ..paper.settling import DEFAULT_TOLERANCE
from ..paper.validation import validate
from ..unit.simulation import TOLERANCES
from ..unit.unit import load
from .options import JSON_OPTION, Command, Number
from .output import json_text


@click.command("validate", cls=Command)
@click.option(
    "--tolerance",
    type=Number(*TOLERANCES),
    default=DEFAULT_TOLERANCE,
    show_default=True,
    help="Relative tolerance of CVODE.",
)
@click.option(
    "--pictures",
    type=click.Path(path_type=Path),
    metavar="FOLDER",
    help="Also draw the paper's figures 5 to 8, one stride, and the model.",
)
@JSON_OPTION
def validate_command(tolerance: float, pictures: Path | None, as_json_object: bool) -> None:
    """The five published gaits, published beside computed.

    The exit status is 1 where a computed value is farther from its recorded reference than allowed.
    """
    if pictures is not None:
        check_folder(pictures, "--pictures")
    validation = validate(relative_tolerance=tolerance, show_progress=True)
    print(json_text(validation.as_json()) if as_json_object else validation.as_text())
    if pictures is not None:
        from ..paper.figures import gallery  # matplotlib is slow to load

        gallery.draw(pictures, load(), show_progress=True)
    if not validation.passed:
        raise SystemExit(1)
