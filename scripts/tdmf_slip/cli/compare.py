"""The command `compare`: runners matched in what could confound a comparison."""

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import click
import numpy as np

from ..analysis.comparison import compare
from ..analysis.sweeps import gaits_in
from ..errors import InputError
from ..library.gait import Gait
from ..library.quantities import QUANTITIES, known_quantities, quantities_of, unit_of
from ..library.runner import Runner
from ..record import origin_of
from ..terminal.text import headed, table
from ..variables.table import FRICTION, VARIABLES
from .command import Answer, command, option
from .options import names_given
from .runner import MODEL_OPTION, SET_OPTION, Asked, values_given

if TYPE_CHECKING:
    import xarray


@command(
    "compare",
    click.option(
        "--friction",
        "frictions",
        type=float,
        multiple=True,
        metavar="MU",
        help=f"Friction of the ground of one runner; short for {FRICTION}. Repeatable.",
    ),
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
    frictions: tuple[float, ...],
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
    files
        TOML or JSON file, or preset, of one runner. Repeatable; give one, or as many as frictions.
    """
    runners = _runners(frictions, files, settings, model)
    names = names_given(hold)
    found = compare(runners, hold=names, vary=names_given(vary), model=model, progress=True)
    gaits = gaits_in(found)
    return Answer(_plain(found, gaits), _table(found, gaits))


def _varied(found: "xarray.Dataset") -> list[str]:
    """Parameters that are varied, or of which the runners have different values."""
    return [str(name) for name in found.coords if name in VARIABLES]


def _not_held(found: "xarray.Dataset") -> list[dict[str, Any]]:
    """Quantities that could not be made equal, with what was wanted and what the runner has."""
    missed = np.argwhere(found["held"].values == 0).tolist()
    names = found["quantity"].values.tolist()
    after = found.sel(step="after")
    return [
        {
            "runner": number,
            "quantity": names[column],
            "wanted": after[names[column]].values[0].item(),
            "has": after[names[column]].values[number].item(),
        }
        for number, column in missed
    ]


def _plain(found: "xarray.Dataset", gaits: list[Gait]) -> dict[str, object]:
    """The comparison as a plain object."""
    return {
        **origin_of(gaits[0].runner),
        "hold": found.hold.split(", "),
        "vary": found.vary.split(", "),
        "runners": [
            {
                "parameters": {name: after.runner[name] for name in _varied(found)},
                "runner": dict(after.runner),
                "before": _reported(before),
                "after": _reported(after),
            }
            for before, after in zip(gaits[::2], gaits[1::2], strict=True)
        ],
        "not_held": _not_held(found),
    }


def _reported(gait: Gait) -> dict[str, object]:
    about = {"word": gait.word, "stable": gait.stable, "lambda_max": gait.lambda_max}
    return about | quantities_of(gait, known_quantities(gait.runner))


def _table(found: "xarray.Dataset", gaits: list[Gait]) -> str:
    """Every quantity of every runner, before and after, and what could not be held; a star marks what is."""
    runner = gaits[0].runner
    columns = [("runner 0", gaits[1])]
    for number, gait in enumerate(gaits[2:], start=2):
        columns.append((f"runner {number // 2}" + (" as given" if number % 2 == 0 else ""), gait))

    def row(name: str, unit: str, mark: str, values: Iterable[float]) -> tuple[str, ...]:
        return (headed(name, runner.label(unit)) + mark, *(f"{value:.6g}" for value in values))

    rows = [
        row(name, VARIABLES[name].unit, "", (gait.runner[name] for _, gait in columns))
        for name in _varied(found)
    ]
    rows.append(("word", *(gait.word for _, gait in columns)))
    rows.append(("stable", *("yes" if gait.stable else "no" for _, gait in columns)))
    for name in known_quantities(runner):
        mark = " *" if name in found["quantity"].values else ""
        rows.append(
            row(name, unit_of(name), mark, (quantities_of(gait, [name])[name] for _, gait in columns))
        )
    rows.append(("lambda_max", *(f"{gait.lambda_max:.6g}" for _, gait in columns)))
    missed = [
        f"not held: {of['quantity']} of runner {of['runner']} is {of['has']:.6g}, not {of['wanted']:.6g}"
        for of in _not_held(found)
    ]
    return "\n".join([table(("", *(title for title, _ in columns)), rows), "", "* held", *missed])


def _runners(
    frictions: tuple[float, ...], files: tuple[str, ...], settings: tuple[str, ...], model: str
) -> list[Runner]:
    """Runners of the options, in the order in which they were given."""
    count = max(len(frictions), len(files))
    if count < 2 or any(len(given) not in (0, 1, count) for given in (frictions, files)):
        raise InputError(
            f"--friction {len(frictions)} times, --parameters {len(files)} times; allowed: two runners or "
            "more by either, or by as many of both"
        )
    runners = []
    for number in range(count):
        friction = frictions[number % len(frictions)] if frictions else None
        file = files[number % len(files)] if files else None
        runners.append(Asked(file, values_given(friction, settings), model).runner())
    return runners
