"""The command `validate`: the paper's statements beside results for both readings of its swing law."""

from functools import partial
from pathlib import Path
from textwrap import fill, indent

import click

from ..errors import InputError
from ..files.whole import check_folder
from ..fmu.simulation import TOLERANCES
from ..paper.statements.own_claims import LAST_SEED
from ..paper.validation import validate
from .command import Answer, command, option
from .options import Number, program


@command(
    "validate",
    option("--tolerance", of=validate, kind=Number(*TOLERANCES)),
    option("--pictures", kind=click.Path(path_type=Path), metavar="FOLDER"),
    option("--gaits", "only_gaits", of=validate),
    option("--long", "own", of=validate),
    option("--seed", of=validate, kind=Number(0, LAST_SEED, whole=True), metavar="K"),
    runner=False,
)
def validate_command(
    tolerance: float, pictures: Path | None, only_gaits: bool, own: bool, seed: int
) -> Answer:
    """Check the paper's gaits and statements by both readings of its swing law, and our claims.

    The exit status is 1 if a computed value is too far from its recorded reference, or if a claim does not
    hold.

    Parameters
    ----------
    pictures
        Also draw figures 5 to 9 of the paper, and one stride as snapshots.
    """
    if only_gaits and own:
        raise InputError("--gaits and --long: allowed: one of the two")
    if pictures is not None:
        from ..pictures import style  # matplotlib is slow to load

        check_folder(pictures, "--pictures")
        style.check_drawing("--pictures")
    validation = validate(tolerance=tolerance, only_gaits=only_gaits, own=own, seed=seed, progress=True)
    return Answer(
        validation.as_json(),
        validation.as_text(program()),
        then=None if pictures is None else partial(_draw, pictures),
        failure=None if validation.passed else SystemExit(1),
    )


def _draw(folder: Path) -> str:
    """Draw the pictures, and list them."""
    from ..paper.figures import catalogue

    written = catalogue.draw(folder, only=catalogue.GALLERY, formats=["png"], progress=True)
    names = ", ".join(path.name for path in written)
    return f"\nPictures in {folder.resolve()}, each with its data:\n{indent(fill(names, 96), '  ')}"
