"""The command `compare`: runners matched in what could confound a comparison."""

import click

from ..analysis.comparison import compare
from ..errors import InputError
from ..library.quantities import QUANTITIES
from ..library.runner import Runner
from ..variables.table import FRICTION
from .options import JSON_OPTION, Command, json_text
from .runner import MODEL_OPTION, SET_OPTION, Asked, values_given


@click.command("compare", cls=Command)
@click.option(
    "--friction",
    "frictions",
    type=float,
    multiple=True,
    metavar="MU",
    help=f"Friction of the ground of one runner; short for {FRICTION}. Repeatable.",
)
@click.option(
    "--parameters",
    "files",
    multiple=True,
    metavar="FILE",
    help="TOML or JSON file, or preset, of one runner. Repeatable; give one, or as many as frictions.",
)
@click.option(
    "--hold",
    required=True,
    metavar="NAMES",
    help=f"Quantities to match, as in speed,apex_height: {', '.join(QUANTITIES)}.",
)
@click.option(
    "--vary",
    required=True,
    metavar="NAMES",
    help="Parameters to adjust, at least as many as quantities, as in hip.stance_torque,hip.touchdown_angle.",
)
@SET_OPTION
@MODEL_OPTION
@JSON_OPTION
def compare_command(
    frictions: tuple[float, ...],
    files: tuple[str, ...],
    hold: str,
    vary: str,
    settings: tuple[str, ...],
    model: str,
    as_json_object: bool,
) -> None:
    """Match runners in speed, foot clearance or other quantities, to rule these out as causes.

    The first runner is the reference. A quantity that could not be matched is reported; it is not an error.
    """
    found = compare(
        _runners(frictions, files, settings, model),
        hold=_names(hold),
        vary=_names(vary),
        model=model,
        progress=True,
    )
    print(json_text(found.as_json()) if as_json_object else found.table())


def _names(text: str) -> list[str]:
    return [name.strip() for name in text.split(",")]


def _runners(
    frictions: tuple[float, ...], files: tuple[str, ...], settings: tuple[str, ...], model: str
) -> list[Runner]:
    """Those of the options, in the order in which they were given."""
    count = max(len(frictions), len(files))
    if count < 2 or any(len(given) not in (0, 1, count) for given in (frictions, files)):
        raise InputError(
            f"--friction {len(frictions)} times, --parameters {len(files)} times; allowed: two runners or "
            "more by either, or by as many of both"
        )
    of_each = [
        (
            frictions[number % len(frictions)] if frictions else None,
            files[number % len(files)] if files else None,
        )
        for number in range(count)
    ]
    return [Asked(file, values_given(friction, settings), model).runner() for friction, file in of_each]
