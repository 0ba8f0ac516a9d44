"""The command `fit`: a runner fitted to measured gaits."""

from pathlib import Path

import click

from ..errors import InputError
from ..files.whole import check_place
from ..fitting.fitted import fit
from ..unit.unit import load
from .options import (
    FRICTION_OPTION,
    JSON_OPTION,
    MODEL_OPTION,
    PARAMETERS_OPTION,
    SET_OPTION,
    Command,
    values_given,
)
from .output import json_text
from .runner import runner_of


@click.command("fit", cls=Command)
@click.argument("file", type=click.Path(path_type=Path))
@click.option(
    "--free",
    metavar="NAMES",
    help="Parameters to be found that all rows share, as in leg.stiffness,leg.damping; they begin with the "
    "values given.",
)
@click.option(
    "--free-each",
    metavar="NAMES",
    help="Parameters to be found of which each row has its own value, as in hip.stance_torque.",
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
    free: str | None,
    free_each: str | None,
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
    human_fast_running. Its header has any of "speed [m/s]", "frequency [Hz]",
    "stance_time [s]", "duty_factor [1]", "slip_distance [m]", "peak_force [N]", each with its standard error,
    as "speed_error [m/s]"; lines that begin with # are skipped. A stride is from one stance of the leg to the
    next. The status is 1 where the search does not end.
    """
    unit = load()
    names, each = _names(free), _names(free_each)
    if not names and not each:
        raise InputError("--free is missing; allowed: --free or --free-each, or both")
    if plot is not None:
        from ..pictures import overview  # matplotlib is slow to load

        check_place(plot, overview.FORMATS, "--plot")
    if report is not None:
        from ..pictures import fit_page

        check_place(report, fit_page.FORMATS, "--report")
    runner = runner_of(unit, parameters, values_given(friction, settings), model)
    found = fit(file, names, free_each=each, runner=runner, show_progress=True, unit=unit)
    if plot is not None:
        from ..pictures import fit_diagram

        fit_diagram.draw(plot, found)
    if report is not None:
        fit_page.write(report, found)
    print(json_text(found.as_json()) if as_json_object else found.as_text())
    if not found.converged:
        raise SystemExit(1)


def _names(given: str | None) -> list[str]:
    return [] if given is None else [name.strip() for name in given.split(",")]
