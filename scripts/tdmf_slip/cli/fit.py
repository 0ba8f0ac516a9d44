"""The command `fit`: a runner fitted to measured gaits."""

from collections.abc import Sequence
from pathlib import Path

import click

from ..checks import number_in
from ..errors import InputError
from ..fitting.fitted import MAX_STARTS, STARTS, LeftOut, fit
from ..fitting.result import Fit
from ..terminal.text import table
from .options import JSON_OPTION, Command, NewPicture, Number, json_text, names_given, plot_option
from .runner import Asked, runner_options


@click.command("fit", cls=Command)
@click.argument("file", type=click.Path(path_type=Path))
@click.option(
    "--vary",
    metavar="NAMES",
    help="Parameters to fit that all rows share, as in leg.stiffness,leg.damping. The search begins at the"
    " given values.",
)
@click.option(
    "--vary-each",
    metavar="NAMES",
    help="Parameters to fit that have a value of their own in each row, as in hip.stance_torque.",
)
@click.option(
    "--prior",
    "priors",
    multiple=True,
    metavar="NAME=VALUE,ERROR",
    help="Prior knowledge of a parameter: its value and standard error, as in leg.free_length=0.95,0.02. A"
    " parameter that is not in --vary is then fitted as well. Repeatable.",
)
@click.option(
    "--robust", is_flag=True, help="Use Huber's loss instead of squares, so that outliers have less weight."
)
@click.option(
    "--scale-errors",
    is_flag=True,
    help="Treat the errors as relative weights, and estimate their common factor from the residuals.",
)
@click.option(
    "--linear", is_flag=True, help="Linearized intervals instead of the profile likelihood: faster."
)
@click.option(
    "--starts",
    type=Number(1, MAX_STARTS, whole=True),
    default=STARTS,
    help="Maximum number of starts, spread over the ranges of the parameters.",
)
@click.option(
    "--without-each", is_flag=True, help="Also fit the shared parameters without each datum in turn."
)
@plot_option("data and fit")
@click.option(
    "--report",
    type=NewPicture("fit_diagram"),
    metavar="FILE",
    help="Write a report with tables and picture (.html).",
)
@JSON_OPTION
@runner_options()
def fit_command(
    asked: Asked,
    file: Path,
    vary: str | None,
    vary_each: str | None,
    priors: tuple[str, ...],
    robust: bool,
    scale_errors: bool,
    linear: bool,
    starts: int,
    without_each: bool,
    plot: Path | None,
    report: Path | None,
    as_json_object: bool,
) -> None:
    """Fit parameters of the runner to measured gaits, with 95 % intervals.

    FILE is a CSV table with one row per condition, or a table that comes with the package: human_running or
    human_fast_running. Both begin with the runner of --parameters human_running. A column is a quantity
    of the stride with its unit: "speed [m/s]", "frequency [Hz]", "stance_time [s]", "duty_factor [1]",
    "slip_distance [m]", "peak_force [N]" or others, such as "foot_clearance [m]". Each has its standard error
    in a second column, as "speed_error [m/s]". Lines that begin with # are skipped. A stride runs from one
    stance of the leg to the next. The exit status is 1 if the search does not converge.
    """
    names, each = names_given(vary), names_given(vary_each)
    if not names and not each:
        raise InputError("--vary is missing; allowed: --vary or --vary-each, or both")
    runner = asked.runner()
    found = fit(
        runner,
        file,
        names,
        vary_each=each,
        priors=_priors(priors),
        robust=robust,
        scale_errors=scale_errors,
        profile=not linear,
        starts=starts,
        progress=True,
    )
    left_out = found.without_each() if without_each else ()
    if plot is not None:
        from ..pictures.plot import write_picture  # matplotlib is slow to load

        write_picture(plot, found)
    if report is not None:
        from ..pictures import fit_diagram

        fit_diagram.write(report, found)
    if as_json_object:
        print(
            json_text(found.as_json() | ({"without": [_left(one) for one in left_out]} if left_out else {}))
        )
    else:
        print("\n\n".join([found.as_text(), *([_left_text(found, left_out)] if left_out else [])]))
    if not found.converged:
        raise SystemExit(1)


def _priors(given: tuple[str, ...]) -> dict[str, tuple[str, float]]:
    """Priors of --prior."""
    priors: dict[str, tuple[str, float]] = {}
    for text in given:
        name, _, pair = (part.strip() for part in text.partition("="))
        value, _, error = (part.strip() for part in pair.partition(","))
        if name in priors:
            raise InputError(f"--prior {text}: {name} is given twice; allowed: once")
        try:
            priors[name] = value, number_in(error)
        except ValueError:
            raise InputError(f"--prior {text}: allowed: NAME=VALUE,ERROR") from None
    return priors


def _left(one: LeftOut) -> dict[str, object]:
    """A datum that is left out, and the shared parameters without it, as a plain object."""
    shared = {of.label: of.value for of in one.fit.estimates if of.label == of.name}
    return {"row": one.row, "quantity": one.name, "parameters": shared, "chi_square": one.fit.chi_square}


def _left_text(found: Fit, left_out: Sequence[LeftOut]) -> str:
    """A row for each datum: by how many of their standard errors shared parameters move without it."""
    labels = [of.label for of in found.estimates if of.label == of.name]
    header = ("without", "of row", *(f"{label} moves by errors" for label in labels), "chi square")
    rows = []
    for one in left_out:
        moved = one.shifts(found)
        cells = (f"{moved[label]:+.2f}" for label in labels)
        rows.append((one.name, str(one.row), *cells, f"{one.fit.chi_square:.4g}"))
    return table(header, rows)
