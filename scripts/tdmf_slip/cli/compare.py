"""The command `compare`: runners matched in quantities that could confound a comparison."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import click
import numpy as np

from ..analysis.comparison import compare
from ..errors import InputError
from ..library.quantities import QUANTITIES, known_quantities, unit_of
from ..library.runner import Runner
from ..record import origin_of, runner_in
from ..terminal.text import headed, table
from ..variables.table import VARIABLES
from .command import Answer, command, option
from .options import names_given
from .runner import MODEL_OPTION, SET_OPTION, RunnerOptions, values_given

if TYPE_CHECKING:
    import xarray


@command(
    "compare",
    option("--friction", "frictions", multiple=True, metavar="MU"),
    option("--parameters", "files", multiple=True, metavar="FILE"),
    click.option(
        "--hold",
        required=True,
        metavar="NAMES",
        help=f"Quantities to match, as in speed,apex_height: {', '.join(QUANTITIES)}.",
    ),
    option("--vary", of=compare, required=True, metavar="NAME,NAME"),
    SET_OPTION,
    MODEL_OPTION,
    runner=False,
)
def compare_command(
    frictions: tuple[str, ...],
    files: tuple[str, ...],
    hold: str,
    vary: str,
    settings: tuple[str, ...],
    model: str,
) -> Answer:
    """Match runners in speed, foot clearance or other quantities, to rule these out as causes.

    The first runner is the reference. A quantity that could not be matched is reported; it is not an error.

    Parameters
    ----------
    frictions
        Friction of the ground of one runner; short for ground.friction. Repeatable.
    files
        TOML or JSON file, or preset, of one runner. Repeatable; give one, or as many as frictions.
    """
    runners = _runners(frictions, files, settings, model)
    names = names_given(hold)
    found = compare(runners, hold=names, vary=names_given(vary), model=model, progress=True)
    missed, quantities = _not_held(found), known_quantities(runners[0])
    plain = {
        **origin_of(runners[0]),
        "hold": found.hold.split(", "),
        "vary": found.vary.split(", "),
        "runners": [_runner_object(found.sel(runner=number), quantities) for number in found["runner"]],
        "not_held": missed,
    }
    lines = [
        f"not held: {of['quantity']} of runner {of['runner']} is {of['has']:.6g}, not {of['wanted']:.6g}"
        for of in missed
    ]
    return Answer(plain, "\n".join([_table(found, runners[0], quantities), "", "* held", *lines]))


def _varied(found: "xarray.Dataset") -> list[str]:
    """Parameters that are varied, or that differ between the runners."""
    return [str(name) for name in found.coords if name in VARIABLES]


def _not_held(found: "xarray.Dataset") -> list[dict[str, Any]]:
    """Quantities that could not be made equal, with the wanted and the actual value."""
    missed, names = np.argwhere(found["held"].values == 0).tolist(), found["quantity"].values.tolist()
    after = {name: found[name].sel(step="after").values.tolist() for name in names}
    return [
        {"runner": number, "quantity": name, "wanted": after[name][0], "has": after[name][number]}
        for number, name in ((number, names[column]) for number, column in missed)
    ]


def _runner_object(found: "xarray.Dataset", quantities: Sequence[str]) -> dict[str, Any]:
    """A runner before and after as a plain object."""
    parameters = {name: found[name].sel(step="after").item() for name in _varied(found)}
    gaits = {}
    for step in ("before", "after"):
        gait = found.sel(step=step)
        largest = gait["lambda_max"].item()
        about = {"word": gait["word"].item(), "stable": largest < 1.0, "lambda_max": largest}
        gaits[step] = about | {name: gait[name].item() for name in quantities}
    return {"parameters": parameters, "runner": {**runner_in(found), **parameters}, **gaits}


def _table(found: "xarray.Dataset", runner: Runner, quantities: Sequence[str]) -> str:
    """Every quantity of every runner, as given and after; a star marks what is held."""
    steps = [("runner 0", 0, "after")]
    for number in range(1, found.sizes["runner"]):
        steps += [(f"runner {number} as given", number, "before"), (f"runner {number}", number, "after")]

    def row(name: str, head: str, show: Callable[[Any], str] = "{:.6g}".format) -> tuple[str, ...]:
        values = (found[name].sel(runner=number, step=step).item() for _, number, step in steps)
        return (head, *map(show, values))

    rows = [row(name, headed(name, runner.label(VARIABLES[name].unit))) for name in _varied(found)]
    rows += [
        row("word", "word", str),
        row("lambda_max", "stable", lambda value: "yes" if value < 1.0 else "no"),
    ]
    for name in quantities:
        mark = " *" if name in found["quantity"] else ""
        rows.append(row(name, headed(name, runner.label(unit_of(name))) + mark))
    return table(("", *(head for head, _, _ in steps)), [*rows, row("lambda_max", "lambda_max")])


def _runners(
    frictions: tuple[str, ...], files: tuple[str, ...], settings: tuple[str, ...], model: str
) -> list[Runner]:
    """Runners of the options, in the order in which they were given."""
    count = max(len(frictions), len(files))
    if count < 2 or any(len(given) not in (0, 1, count) for given in (frictions, files)):
        raise InputError(
            f"{len(frictions)} of --friction and {len(files)} of --parameters; allowed: two or more of one "
            "option, and none, one or as many of the other"
        )
    runners = []
    for number in range(count):
        friction = frictions[number % len(frictions)] if frictions else None
        file = files[number % len(files)] if files else None
        runners.append(RunnerOptions(file, values_given(friction, settings), model).runner())
    return runners
