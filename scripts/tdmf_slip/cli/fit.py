"""The command `fit`: a runner fitted to measured gaits."""

from collections.abc import Sequence
from pathlib import Path

import click

from ..checks import number_in
from ..errors import InputError
from ..fitting.fitted import MAX_STARTS, STARTS, fit
from ..fitting.measurements import shipped, shipped_names
from ..fitting.result import Fit
from ..fitting.without import LeftOut
from ..fmu.fmu import load_fmu
from ..terminal.text import table
from .options import (
    FRICTION_OPTION,
    JSON_OPTION,
    MODEL_OPTION,
    PARAMETERS_OPTION,
    SET_OPTION,
    Command,
    Number,
    names_given,
    values_given,
)
from .output import json_text
from .runner import runner_of


@click.command("fit", cls=Command)
@click.argument("file", type=click.Path(path_type=Path))
@click.option(
    "--vary",
    metavar="NAMES",
    help="Parameters to be found that all rows share, as in leg.stiffness,leg.damping; they begin with the "
    "values given.",
)
@click.option(
    "--vary-each",
    metavar="NAMES",
    help="Parameters to be found of which each row has its own value, as in hip.stance_torque.",
)
@click.option(
    "--prior",
    "priors",
    multiple=True,
    metavar="NAME=VALUE,ERROR",
    help="What is known of a parameter beside the data: its value and standard error, as in "
    "leg.free_length=0.95,0.02. One that is not among --vary is fitted, too. Repeatable.",
)
@click.option(
    "--robust", is_flag=True, help="Huber's loss instead of squares: data that are far off change little."
)
@click.option(
    "--scale-errors",
    is_flag=True,
    help="The errors are known but for a common factor, which the residuals tell.",
)
@click.option(
    "--linear", is_flag=True, help="Intervals by slopes alone instead of the profile likelihood: quicker."
)
@click.option(
    "--starts",
    type=Number(1, MAX_STARTS, whole=True),
    default=STARTS,
    show_default=True,
    help="How many fits are made at the most, from gaits all over what varies.",
)
@click.option(
    "--without-each", is_flag=True, help="Also the shared parameters without one datum, for each datum."
)
@FRICTION_OPTION
@SET_OPTION
@PARAMETERS_OPTION
@MODEL_OPTION
@click.option(
    "--plot", type=click.Path(path_type=Path), metavar="FILE", help="Draw data and fit: .png, .svg or .pdf."
)
@click.option(
    "--report",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Write tables, picture and what the fit says as a page (.html).",
)
@JSON_OPTION
def fit_command(
    file: Path,
    vary: str | None,
    vary_each: str | None,
    priors: tuple[str, ...],
    robust: bool,
    scale_errors: bool,
    linear: bool,
    starts: int,
    without_each: bool,
    friction: float | None,
    settings: tuple[str, ...],
    parameters: str | None,
    model: str,
    plot: Path | None,
    report: Path | None,
    as_json_object: bool,
) -> None:
    """Parameters of the runner whose gaits are nearest to measured ones, with 95 % intervals.

    FILE is a CSV table with a row for each condition, or one that comes with the package: human_running,
    human_fast_running; --parameters human_running.toml is the runner that their fits begin with. The
    header has any of "speed [m/s]", "frequency [Hz]",
    "stance_time [s]", "duty_factor [1]", "slip_distance [m]", "peak_force [N]", or another quantity of a
    stride, as "foot_clearance [m]", each with its standard error, as "speed_error [m/s]"; lines that begin
    with # are skipped. A stride is from one stance of the leg to the next. The status is 1 where the search
    does not end.
    """
    fmu = load_fmu()
    names, each = names_given(vary), names_given(vary_each)
    if not names and not each:
        raise InputError("--vary is missing; allowed: --vary or --vary-each, or both")
    if plot is not None:
        from ..pictures import style  # matplotlib is slow to load

        style.check_picture(plot, "--plot")
    if report is not None:
        from ..pictures import fit_page, style

        style.check_picture(report, "--report", fit_page.FORMATS)
    if parameters is not None and not Path(parameters).exists() and parameters in shipped_names():
        parameters = str(shipped(parameters))
    runner = runner_of(fmu, parameters, values_given(friction, settings), model)
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
        fmu=fmu,
    )
    left_out = found.without_each() if without_each else ()
    if plot is not None:
        from ..pictures import fit_diagram

        fit_diagram.draw(plot, found)
    if report is not None:
        fit_page.write(report, found)
    if as_json_object:
        print(
            json_text(found.as_json() | ({"without": [_left(one) for one in left_out]} if left_out else {}))
        )
    else:
        print("\n\n".join([found.as_text(), *([_left_text(found, left_out)] if left_out else [])]))
    if not found.converged:
        raise SystemExit(1)


def _priors(given: tuple[str, ...]) -> dict[str, tuple[str, float]]:
    """Of --prior."""
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
