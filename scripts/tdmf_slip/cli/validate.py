"""The command `validate`: what the paper says, beside what is computed for both readings of its swing law."""

from pathlib import Path
from textwrap import fill, indent

import click

from ..errors import InputError
from ..files.whole import check_folder
from ..fmu.simulation import TOLERANCES
from ..paper.results_page import LAST_SEED
from ..paper.settling import DEFAULT_TOLERANCE
from ..paper.validation import validate
from .options import JSON_OPTION, Command, Number, json_text, program


@click.command("validate", cls=Command)
@click.option(
    "--tolerance",
    type=Number(*TOLERANCES),
    default=DEFAULT_TOLERANCE,
    help="Relative tolerance of CVODE.",
)
@click.option(
    "--pictures",
    type=click.Path(path_type=Path),
    metavar="FOLDER",
    help="Also draw figures 5 to 9 of the paper, one stride, and the model.",
)
@click.option(
    "--gaits",
    "only_gaits",
    is_flag=True,
    help="Compute only the five gaits of both readings, without the statements.",
)
@click.option(
    "--long", "own", is_flag=True, help="Also compute this project's own claims, which takes some minutes."
)
@click.option(
    "--seed",
    type=Number(0, LAST_SEED, whole=True),
    default=1,
    metavar="K",
    help="Seed of the random numbers of --long.",
)
@JSON_OPTION
def validate_command(
    tolerance: float, pictures: Path | None, only_gaits: bool, own: bool, seed: int, as_json_object: bool
) -> None:
    """Compare the paper's gaits and statements with both readings of (12); with --long also our own claims.

    The exit status is 1 if a computed value is too far from its recorded reference, or if a claim does not
    hold.
    """
    if only_gaits and own:
        raise InputError("--gaits and --long: allowed: one of the two")
    if pictures is not None:
        from ..paper.figures import catalogue  # matplotlib is slow to load
        from ..pictures import style

        check_folder(pictures, "--pictures")
        style.check_drawing("--pictures")
    validation = validate(tolerance=tolerance, only_gaits=only_gaits, own=own, seed=seed, progress=True)
    print(json_text(validation.as_json()) if as_json_object else validation.as_text(program()))
    if pictures is not None:
        written = catalogue.draw_gallery(pictures, progress=True)
        if not as_json_object:
            names = fill(", ".join(path.name for path in written), 96)
            print(f"\nPictures in {pictures.resolve()}:\n{indent(names, '  ')}")
    if not validation.passed:
        raise SystemExit(1)
