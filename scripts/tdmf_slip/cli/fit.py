"""The command `fit`: a runner fitted to measured gaits."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from ..checks import number_in
from ..errors import InputError
from ..fitting.fitted import MAX_STARTS, fit
from ..fitting.result import Fit, Residual
from ..terminal.text import table
from .command import Answer, command, option
from .options import NewPicture, Number, names_given
from .runner import RunnerOptions


@command(
    "fit",
    click.argument("file", type=click.Path(path_type=Path)),
    option("--vary", of=fit, default=None, metavar="NAME,NAME"),
    option("--vary-each", of=fit, default=None, metavar="NAME,NAME"),
    option("--prior", "priors", multiple=True, metavar="NAME=VALUE,ERROR"),
    option("--robust", of=fit),
    option("--scale-errors", of=fit),
    option("--linear", is_flag=True),
    option("--starts", of=fit, kind=Number(1, MAX_STARTS, whole=True)),
    option("--without-each", is_flag=True),
    option("--report", kind=NewPicture("fit_diagram"), metavar="FILE"),
    plot="data and fit",
)
def fit_command(
    options: RunnerOptions,
    file: Path,
    vary: str | None,
    vary_each: str | None,
    priors: tuple[str, ...],
    linear: bool,
    without_each: bool,
    report: Path | None,
    **given: Any,
) -> Answer:
    """Fit parameters of the runner to measured gaits, with 95 % intervals.

    FILE is a CSV table with one row per condition, or a table that comes with the package: human_running or
    human_fast_running. Both begin with the runner of --parameters human_running. A column is a quantity
    of the stride with its unit: "speed [m/s]", "frequency [Hz]", "stance_time [s]", "duty_factor [1]",
    "slip_distance [m]", "peak_force [N]" or others, such as "foot_clearance [m]". Each has its standard error
    in a second column, as "speed_error [m/s]". Lines that begin with # are skipped. A stride runs from one
    stance of the leg to the next. The exit status is 1 if the search does not converge.

    Parameters
    ----------
    priors
        Prior knowledge of a parameter: its value and standard error, as in leg.free_length=0.95,0.02. A
        parameter that is not in --vary is then fitted as well. Repeatable.
    linear
        Linearized intervals instead of the profile likelihood: faster.
    without_each
        Also fit the shared parameters without each datum in turn.
    report
        Write a report with tables and picture (.html).
    """
    names, each = names_given(vary), names_given(vary_each)
    if not names and not each:
        raise InputError("--vary is missing; allowed: --vary or --vary-each, or both")
    given |= {"vary_each": each, "priors": _priors(priors), "profile": not linear}
    found = fit(options.runner(), file, names, progress=True, **given)
    left_out = found.without_each() if without_each else {}
    if report is not None:
        from ..pictures import fit_diagram

        fit_diagram.write(report, found)
    plain, text = found.as_json(), found.as_text()
    if left_out:
        plain |= {"without": [_left(*one) for one in left_out.items()]}
        text += f"\n\n{_left_text(found, left_out)}"
    return Answer(plain, text, lambda: found, failure=None if found.converged else SystemExit(1))


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


def _left(datum: Residual, fit: Fit) -> dict[str, object]:
    """A datum that is left out, and the shared parameters without it, as a plain object."""
    shared = {of.label: of.value for of in fit.estimates if of.label == of.name}
    return {"row": datum.row, "quantity": datum.name, "parameters": shared, "chi_square": fit.chi_square}


def _left_text(found: Fit, left_out: Mapping[Residual, Fit]) -> str:
    """A row for each datum: by how many of their standard errors shared parameters move without it."""
    labels = [of.label for of in found.estimates if of.label == of.name]
    header = ("without", "of row", *(f"{label} moves by errors" for label in labels), "chi square")
    rows = []
    for datum, other in left_out.items():
        moved = found.shifts(other)
        cells = (f"{moved[label]:+.2f}" for label in labels)
        rows.append((datum.name, str(datum.row), *cells, f"{other.chi_square:.4g}"))
    return table(header, rows)
