"""The command `sweep`: gaits over a range of a parameter, or over two."""

from collections.abc import Mapping
from pathlib import Path

import click
import numpy as np
from numpy.typing import NDArray

from ..analysis.sweeps import Row, check_values, short, sweep, sweep_of_row, sweep_row
from ..errors import InputError, RunError
from ..files.whole import check_destination, whole
from ..library.members import check_varied
from ..library.runner import Runner
from ..terminal.text import table
from ..variables.display_units import DisplayUnits
from ..variables.table import FRICTION, VARIABLES
from .command import Answer, command, json_text, option
from .options import SPACINGS, pairs_given, values_of
from .runner import MODEL_OPTION, PARAMETERS_OPTION, SET_OPTION, Asked, refuse_given, values_given
from .workers import Workers

NETCDF, CSV = ".nc", ".csv"
FORMATS = (NETCDF, ".json", CSV)
"""Formats of --output."""
STDOUT = Path("-")


@command(
    "sweep",
    option("--friction", metavar="A:B:N"),
    option("--vary", multiple=True, metavar="NAME=A:B:N"),
    option("--spacing", kind=click.Choice(list(SPACINGS)), default="linear"),
    option("--output", kind=click.Path(path_type=Path), metavar="FILE"),
    SET_OPTION,
    PARAMETERS_OPTION,
    MODEL_OPTION,
    runner=False,
    workers=True,
    plot="the gaits",
)
def sweep_command(
    workers: Workers,
    friction: str | None,
    vary: tuple[str, ...],
    spacing: str,
    output: Path | None,
    settings: tuple[str, ...],
    parameters: str | None,
    model: str,
) -> Answer:
    """Find gaits over a range of one or two parameters, and the borders between gait words.

    If there is no gait at the first value, the sweep begins at the first value that has one, and goes both
    ways. Where a fold ends a branch, the sweep continues on another one and says so. If gaits are missing,
    those that were found are printed and written, and the exit status is 1. The rows of a grid are computed
    in parallel.

    Parameters
    ----------
    friction
        N values from A to B. With --vary, one value MU for all gaits is allowed too.
    vary
        Parameter or input to vary, as in leg.damping=0.1:0.3:20 or hip.touchdown_angle='35 deg:45
        deg:11'. Given twice, or with a range of friction, it gives a grid of gaits, written to --output
        row by row. An existing file is resumed.
    spacing
        Spacing of the values in a range.
    output
        Write the gaits as NetCDF (.nc), JSON (.json) or CSV (.csv); - writes JSON to stdout, as --json
        does.
    """
    to_stdout = output == STDOUT
    if to_stdout:
        output = None
    if output is not None:
        check_destination(output, FORMATS, "--output")
    given = values_given(None, settings)
    texts = pairs_given(vary, "--vary", "NAME=A:B:N")
    if not texts and friction is None:
        raise InputError("neither --friction nor --vary: allowed: one of the two, or both")
    for name in texts:
        refuse_given(given, name, "--vary")
    if friction is not None:
        refuse_given(given, FRICTION, "--friction")
        if FRICTION in texts:
            raise InputError(f"--vary {FRICTION}: --friction gives it, too; allowed: one of the two")
        if texts and ":" not in friction:
            given = {**given, FRICTION: ("--friction", friction)}
            friction = None
        else:
            texts = {FRICTION: friction, **texts}
    if len(texts) > 2:
        raise InputError(f"--vary: {', '.join(texts)} are varied; allowed: one of them, or two for a grid")
    runner = Asked(parameters, given, model).runner()
    values = {}
    for name, text in texts.items():
        check_varied(name, "--vary")
        where = "--friction" if name == FRICTION and friction is not None else f"--vary {name} ="
        values[name] = values_of(text, spacing, VARIABLES[name], where)
    if len(values) == 2:
        return _grid(runner, values, output, workers)
    if workers.are_given:
        raise InputError(
            "--workers, --scheduler: along one range each gait is found from the one before, nor are they "
            "of use for a single friction; allowed: with two ranges, of --vary or --friction"
        )
    if output is not None and output.suffix.lower() == NETCDF:
        from ..files.resume import refuse_resumable  # xarray is slow to load

        refuse_resumable(output)
    ((name, along),) = values.items()
    check_values(runner, name, along)
    found = sweep_row(runner, name, along, progress=True)
    if output is not None:
        _write(output, runner, found)
    display, plain = DisplayUnits(texts, runner), found.as_json()
    failure = None
    if found.problem is not None:
        failure = RunError(f"{found.problem}; {len(found.gaits)} of {len(along)} gaits were found")
    text = json_text(plain) if to_stdout else _text(found, display)
    look = {"display": display}
    return Answer(plain, text, lambda: sweep_of_row(runner, found), look, failure=failure)


def _write(path: Path, runner: Runner, found: Row) -> None:
    """Into a file whose suffix is one of `FORMATS`."""
    suffix = path.suffix.lower()
    if suffix == NETCDF:
        from ..files.netcdf import write_dataset  # xarray is slow to load

        gaits, borders = sweep_of_row(runner, found)
        write_dataset(path, gaits, {"borders": borders})
        return
    with whole(path) as beside:
        if suffix == CSV:
            gaits = sweep_of_row(runner, found).gaits.drop_dims("mode")
            gaits.to_dataframe().to_csv(beside)
        else:
            beside.write_text(json_text(found.as_json()) + "\n", encoding="utf-8")


def _grid(
    runner: Runner, vary: Mapping[str, NDArray[np.float64]], output: Path | None, workers: Workers
) -> Answer:
    if click.get_current_context().params.get("picture") is not None:
        raise InputError("--plot: a grid of gaits has no picture; allowed: with one range")
    if output is None or output.suffix.lower() != NETCDF:
        raise InputError("--vary: a grid of gaits goes to a file; allowed: with --output FILE.nc")
    with workers.executor() as executor:
        found = sweep(runner, vary, path=output, executor=executor, progress=True).gaits
    words = found["word"].values.ravel()
    points, gaits = words.size, int(np.count_nonzero(words != ""))
    different = sorted({word for word in words if word})
    plain = {"file": str(output), "points": points, "gaits": gaits, "words": different}
    text = f"{output}: {gaits} gaits at {points} points, words {', '.join(different)}"
    problems = [problem for problem in found["problem"].values if problem]
    failure = RunError(f"{problems[0]}; {gaits} of {points} gaits were found") if problems else None
    return Answer(runner.record(*vary) | plain, text, failure=failure)


def _text(found: Row, display: DisplayUnits) -> str:
    rows = [
        (
            f"{display.value(found.name, value):.6g}",
            gait.word,
            *(f"{gait.stride[name]:.8g}" for name in ("period", "speed", "cost_of_transport")),
            f"{gait.lambda_max:.8f}",
            "yes" if gait.stable else "no",
        )
        for value, gait in zip(found.values, found.by_value, strict=True)
        if gait is not None
    ]
    unit = display.unit(found.name)
    varied = short(found.name) if unit in ("", "1") else f"{found.name} ({unit})"
    period, speed = (
        f"{name} ({display.label(VARIABLES[f'stride.{name}'].unit)})" for name in ("period", "speed")
    )
    header = (varied, "word", period, speed, "cost of transport", "lambda_max", "stable")
    borders = [
        f"{border.before} to {border.after} at {display.value(found.name, border.value):.10g}"
        for border in found.borders
    ]
    return "\n".join([table(header, rows), *borders])
