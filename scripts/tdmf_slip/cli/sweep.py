"""The command `sweep`: gaits over a range of a parameter, or over two."""

from collections.abc import Mapping
from concurrent.futures import Executor
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
from .options import JSON_OPTION, SPACINGS, Command, json_text, pairs_given, plot_option, values_of
from .runner import MODEL_OPTION, PARAMETERS_OPTION, SET_OPTION, Asked, refuse_given, values_given
from .workers import executor_of, workers_options

NETCDF, CSV = ".nc", ".csv"
FORMATS = (NETCDF, ".json", CSV)
"""Formats of --output."""
STDOUT = Path("-")
SPACING_OPTION = click.option(
    "--spacing",
    type=click.Choice(list(SPACINGS)),
    default="linear",
    help="Spacing of the values in a range.",
)


@click.command("sweep", cls=Command)
@click.option(
    "--friction",
    metavar="A:B:N",
    help="N values from A to B. With --vary, one value MU for all gaits is allowed too.",
)
@click.option(
    "--vary",
    multiple=True,
    metavar="NAME=A:B:N",
    help="Parameter or input to vary, as in leg.damping=0.1:0.3:20 or hip.touchdown_angle='35 deg:45 "
    "deg:11'. Given twice, or with a range of friction, it gives a grid of gaits, written to --output"
    " row by row. An existing file is resumed.",
)
@SPACING_OPTION
@click.option(
    "--output",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Write the gaits as NetCDF (.nc), JSON (.json) or CSV (.csv); - writes JSON to stdout, as "
    "--json does.",
)
@plot_option("the gaits")
@workers_options
@SET_OPTION
@PARAMETERS_OPTION
@MODEL_OPTION
@JSON_OPTION
def sweep_command(
    friction: str | None,
    vary: tuple[str, ...],
    spacing: str,
    output: Path | None,
    plot: Path | None,
    workers: int | None,
    scheduler: str | None,
    settings: tuple[str, ...],
    parameters: str | None,
    model: str,
    as_json_object: bool,
) -> None:
    """Find gaits over a range of one or two parameters, and the borders between gait words.

    If there is no gait at the first value, the sweep begins at the first value that has one, and goes both
    ways. Where a fold ends a branch, the sweep continues on another one and says so. If gaits are missing,
    those that were found are printed and written, and the exit status is 1. The rows of a grid are computed
    in parallel.
    """
    if output == STDOUT:
        output, as_json_object = None, True
    if output is not None:
        check_destination(output, FORMATS, "--output")
    given = values_given(None, settings)
    texts = pairs_given(vary, "--vary", "NAME=A:B:N")
    if not texts and friction is None:
        raise InputError("neither --friction nor --vary: allowed: one of the two, or both")
    for name in texts:
        refuse_given(given, name, "--vary")
    options = dict.fromkeys(texts, "--vary")
    if friction is not None:
        refuse_given(given, FRICTION, "--friction")
        if FRICTION in texts:
            raise InputError(f"--vary {FRICTION}: --friction gives it, too; allowed: one of the two")
        if texts and ":" not in friction:
            given = {**given, FRICTION: ("--friction", friction)}
        else:
            texts, options = {FRICTION: friction, **texts}, {FRICTION: "--friction", **options}
    if len(texts) > 2:
        raise InputError(f"--vary: {', '.join(texts)} are varied; allowed: one of them, or two for a grid")
    runner = Asked(parameters, given, model).runner()
    values = {name: _values(name, text, spacing, options[name]) for name, text in texts.items()}
    if len(values) == 2:
        if plot is not None:
            raise InputError("--plot: a grid of gaits has no picture; allowed: with one range")
        with executor_of(workers, scheduler) as executor:
            _grid(runner, values, output, executor, as_json_object)
        return
    if scheduler is not None or workers is not None:
        raise InputError(
            "--workers, --scheduler: along one range each gait is found from the one before, nor are they "
            "of use for a single friction; allowed: with two ranges, of --vary or --friction"
        )
    _row(
        runner,
        *next(iter(values.items())),
        output,
        plot,
        as_json_object,
        DisplayUnits(texts, runner),
    )


def _values(name: str, span: str, spacing: str, option: str) -> NDArray[np.float64]:
    """The values of a parameter that A:B:N stands for."""
    check_varied(name, "--vary")
    where = option if option == "--friction" else f"--vary {name} ="
    return values_of(span, spacing, VARIABLES[name], where)


def _row(
    runner: Runner,
    name: str,
    values: NDArray[np.float64],
    output: Path | None,
    plot: Path | None,
    as_json_object: bool,
    display: DisplayUnits,
) -> None:
    if output is not None and output.suffix.lower() == NETCDF:
        from ..files.resume import refuse_resumable

        refuse_resumable(output)
    check_values(runner, name, values)
    found = sweep_row(runner, name, values, progress=True)
    if output is not None:
        _write(output, runner, found)
    if plot is not None:
        from ..pictures.plot import write_picture  # matplotlib is slow to load

        write_picture(plot, sweep_of_row(runner, found), display=display)
    print(json_text(found.as_json()) if as_json_object else _sweep_text(found, display))
    if found.problem is not None:
        raise RunError(f"{found.problem}; {len(found.gaits)} of {len(values)} gaits were found")


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
    runner: Runner,
    vary: Mapping[str, NDArray[np.float64]],
    output: Path | None,
    executor: Executor | None,
    as_json_object: bool,
) -> None:
    if output is None or output.suffix.lower() != NETCDF:
        raise InputError("--vary: a grid of gaits goes to a file; allowed: with --output FILE.nc")
    found = sweep(runner, vary, path=output, executor=executor, progress=True).gaits
    words = found["word"].values.ravel()
    points, gaits = words.size, int(np.count_nonzero(words != ""))
    different = sorted({word for word in words if word})
    result = {
        **runner.record(*vary),
        "file": str(output),
        "points": points,
        "gaits": gaits,
        "words": different,
    }
    text = f"{output}: {gaits} gaits at {points} points, words {', '.join(different)}"
    print(json_text(result) if as_json_object else text)
    problems = [problem for problem in found["problem"].values if problem]
    if problems:
        raise RunError(f"{problems[0]}; {gaits} of {points} gaits were found")


def _headed(name: str, measure: str) -> str:
    return short(name) if measure in ("", "1") else f"{name} ({measure})"


def _sweep_text(found: Row, display: DisplayUnits) -> str:
    rows = [
        (
            f"{display.value(found.name, value):.6g}",
            gait.word,
            f"{gait.stride['period']:.8g}",
            f"{gait.stride['speed']:.8g}",
            f"{gait.stride['cost_of_transport']:.8g}",
            f"{gait.lambda_max:.8f}",
            "yes" if gait.stable else "no",
        )
        for value, gait in zip(found.values, found.by_value, strict=True)
        if gait is not None
    ]
    with_units = [
        f"{name} ({display.label(VARIABLES[f'stride.{name}'].unit)})" for name in ("period", "speed")
    ]
    header = (
        _headed(found.name, display.unit(found.name)),
        "word",
        *with_units,
        "cost of transport",
        "lambda_max",
        "stable",
    )
    borders = [
        f"{border.before} to {border.after} at {display.value(found.name, border.value):.10g}"
        for border in found.borders
    ]
    return "\n".join([table(header, rows), *borders])
