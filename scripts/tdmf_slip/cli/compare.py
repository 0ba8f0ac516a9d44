"""The command `compare`: runners matched in what could confound a comparison."""

from collections.abc import Iterable
from dataclasses import asdict

import click

from ..analysis.comparison import Comparison, compare
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
    found = compare.plain(runners, hold=names, vary=names_given(vary), model=model, progress=True)
    return Answer(_plain(found), _table(found))


def _plain(found: Comparison) -> dict[str, object]:
    """The comparison as a plain object."""
    return {
        **origin_of(found.after[0].runner),
        "hold": list(found.hold),
        "vary": list(found.vary),
        "runners": [
            {
                "parameters": {name: after.runner[name] for name in found.names},
                "runner": dict(after.runner),
                "before": _reported(before),
                "after": _reported(after),
            }
            for before, after in zip(found.before, found.after, strict=True)
        ],
        "not_held": [asdict(of) for of in found.not_held],
    }


def _reported(gait: Gait) -> dict[str, object]:
    about = {"word": gait.word, "stable": gait.stable, "lambda_max": gait.lambda_max}
    return about | quantities_of(gait, known_quantities(gait.runner))


def _table(found: Comparison) -> str:
    """Every quantity of every runner, before and after, and what could not be held; a star marks what is."""
    runner = found.after[0].runner
    columns = [("runner 0", found.after[0])]
    for number, gaits in enumerate(list(zip(found.before, found.after, strict=True))[1:], start=1):
        columns += zip((f"runner {number} as given", f"runner {number}"), gaits, strict=True)

    def row(name: str, unit: str, mark: str, values: Iterable[float]) -> tuple[str, ...]:
        return (headed(name, runner.label(unit)) + mark, *(f"{value:.6g}" for value in values))

    rows = [
        row(name, VARIABLES[name].unit, "", (gait.runner[name] for _, gait in columns))
        for name in found.names
    ]
    rows.append(("word", *(gait.word for _, gait in columns)))
    rows.append(("stable", *("yes" if gait.stable else "no" for _, gait in columns)))
    for name in known_quantities(runner):
        mark = " *" if name in found.hold else ""
        rows.append(
            row(name, unit_of(name), mark, (quantities_of(gait, [name])[name] for _, gait in columns))
        )
    rows.append(("lambda_max", *(f"{gait.lambda_max:.6g}" for _, gait in columns)))
    missed = [
        f"not held: {of.quantity} of runner {of.runner} is {of.has:.6g}, not {of.wanted:.6g}"
        for of in found.not_held
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
