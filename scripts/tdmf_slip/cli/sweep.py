"""The command `sweep`: gaits over a range of a parameter, or over two."""

from collections.abc import Callable, Mapping
from functools import cache, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np
from numpy.typing import NDArray

from ..analysis.sweeps import Sweep, gaits_in, sweep
from ..errors import InputError, RunError, counted
from ..files.whole import check_destination, whole
from ..library.members import check_varied
from ..library.runner import Runner
from ..terminal.text import table
from ..variables.display_units import DisplayUnits
from ..variables.table import FRICTION, VARIABLES
from .command import Answer, command, json_text, option
from .options import SPACINGS, pairs_given, values_of
from .runner import RunnerOptions, refuse_given
from .workers import Workers

if TYPE_CHECKING:
    import xarray

NETCDF, CSV = ".nc", ".csv"
FORMATS = (NETCDF, ".json", CSV)
"""Formats of --output."""
STDOUT = Path("-")
QUANTITIES = ("period", "speed", "cost_of_transport")
"""Quantities in the printed table."""


@command(
    "sweep",
    option("--friction", metavar="A:B:N"),
    option("--vary", multiple=True, metavar="NAME=A:B:N"),
    option("--spacing", kind=click.Choice(list(SPACINGS)), default="linear"),
    option("--output", kind=click.Path(path_type=Path), metavar="FILE"),
    friction=False,
    workers=True,
    plot="the gaits",
)
def sweep_command(
    options: RunnerOptions,
    workers: Workers,
    friction: str | None,
    vary: tuple[str, ...],
    spacing: str,
    output: Path | None,
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
    texts = pairs_given(vary, "--vary", "NAME=A:B:N")
    if not texts and friction is None:
        raise InputError("neither --friction nor --vary is given; allowed: one of the two, or both")
    if friction is not None:
        refuse_given({**options.given, **dict.fromkeys(texts, ("--vary", ""))}, FRICTION, "--friction")
        if texts and ":" not in friction:
            options, friction = options.at_friction(friction), None
        else:
            texts = {FRICTION: friction, **texts}
    if len(texts) > 2:
        raise InputError(f"--vary: {', '.join(texts)} are varied; allowed: one of them, or two for a grid")
    runner = options.runner(texts)
    values = {}
    for name, text in texts.items():
        check_varied(name, "--vary")
        where = "--friction" if name == FRICTION and friction is not None else f"--vary {name} ="
        values[name] = values_of(text, spacing, VARIABLES[name], where)
    if len(values) == 2:
        return _grid(runner, values, output, workers)
    if workers.are_given:
        raise InputError(
            "--workers, --scheduler: one range is swept in sequence, each gait from the one before; allowed: "
            "with two ranges, of --vary or --friction"
        )
    if output is not None and output.suffix.lower() == NETCDF:
        from ..files.resume import refuse_resumable  # xarray is slow to load

        refuse_resumable(output)
    found = sweep(runner, values, progress=True)
    plain, problem = cache(partial(_object, runner, found)), found.gaits["problem"].item()
    if output is not None:
        _write(output, found, plain)
    display = DisplayUnits(texts, runner)
    failure = None
    if problem:
        words = found.gaits["word"].values
        failure = RunError(f"{problem}; gaits found: {np.count_nonzero(words != '')} of {words.size}")
    text = json_text(plain()) if to_stdout else _text(found, display)
    return Answer(plain, text, lambda: found, {"display": display}, failure=failure)


def _object(runner: Runner, found: Sweep) -> dict[str, Any]:
    """A sweep over one name as a plain object; `missing` are the values without a gait."""
    gaits, borders = found
    name = str(gaits.along)
    values, there = gaits[name].values, gaits["word"].values != ""
    return {
        **runner.record(name),
        "over": name,
        "gaits": [
            gait.as_json() | {"value": value}
            for gait, value in zip(gaits_in(gaits), values[there].tolist(), strict=True)
        ],
        "transitions": [
            {_reported_name(name): value, "from": before, "to": after}
            for value, before, after in zip(
                *(borders[of].values.tolist() for of in (name, "before", "after")), strict=True
            )
        ],
        "branches": [_segment(gaits.isel({name: gaits["branch"] == number})) for number in _branches(gaits)],
        "missing": values[~there].tolist(),
        "problem": gaits["problem"].item() or None,
    }


def _branches(gaits: "xarray.Dataset") -> NDArray[np.float64]:
    numbers: NDArray[np.float64] = np.unique(gaits["branch"].values)
    return numbers[np.isfinite(numbers)]


def _segment(branch: "xarray.Dataset") -> dict[str, object]:
    """The values of a branch, and why it has no gaits before and after them."""
    values = branch[branch.along].values.tolist()
    began, ended = branch["began"].values[0], branch["ended"].values[-1]
    return {"from": values[0], "to": values[-1], "began": began or None, "ended": ended or None}


def _reported_name(name: str) -> str:
    """Name of a parameter in the results, where the friction is called just that."""
    return "friction" if name == FRICTION else name


def _write(path: Path, found: Sweep, plain: Callable[[], dict[str, Any]]) -> None:
    """Write a sweep, or its plain object, into a file whose suffix is one of `FORMATS`."""
    suffix = path.suffix.lower()
    if suffix == NETCDF:
        from ..files.netcdf import write_dataset  # xarray is slow to load

        write_dataset(path, found.gaits, {"borders": found.borders})
        return
    with whole(path) as beside:
        if suffix == CSV:
            found.gaits.drop_dims("mode").to_dataframe().to_csv(beside)
        else:
            beside.write_text(json_text(plain()) + "\n", encoding="utf-8")


def _grid(
    runner: Runner, vary: Mapping[str, NDArray[np.float64]], output: Path | None, workers: Workers
) -> Answer:
    if click.get_current_context().params.get("picture") is not None:
        raise InputError("--plot: a grid of gaits has no picture; allowed: with one range")
    if output is None or output.suffix.lower() != NETCDF:
        raise InputError("--vary: a grid of gaits needs --output FILE.nc")
    with workers.executor() as executor:
        found = sweep(runner, vary, path=output, executor=executor, progress=True).gaits
    words = found["word"].values.ravel()
    points, gaits = words.size, int(np.count_nonzero(words != ""))
    different = sorted({word for word in words if word})
    plain = {"file": str(output), "points": points, "gaits": gaits, "words": different}
    text = f"{output}: {counted(gaits, 'gait')} at {counted(points, 'point')}, words {', '.join(different)}"
    problems = [problem for problem in found["problem"].values if problem]
    failure = RunError(f"{problems[0]}; gaits found: {gaits} of {points}") if problems else None
    return Answer(runner.record(*vary) | plain, text, failure=failure)


def _text(found: Sweep, display: DisplayUnits) -> str:
    gaits, borders = found
    name = str(gaits.along)
    shown = gaits.isel({name: gaits["word"] != ""})
    columns = (shown[of].values for of in (name, "word", *QUANTITIES, "lambda_max"))
    rows = [
        (
            f"{display.value(name, value):.6g}",
            word,
            *(f"{number:.8g}" for number in quantities),
            f"{largest:.8f}",
            "yes" if largest < 1.0 else "no",
        )
        for value, word, *quantities, largest in zip(*columns, strict=True)
    ]
    unit = display.unit(name)
    varied = _reported_name(name) if unit in ("", "1") else f"{name} ({unit})"
    period, speed = (
        f"{name} ({display.label(VARIABLES[f'stride.{name}'].unit)})" for name in ("period", "speed")
    )
    header = (varied, "word", period, speed, "cost of transport", "lambda_max", "stable")
    changes = zip(*(borders[of].values for of in (name, "before", "after")), strict=True)
    lines = [f"{before} to {after} at {display.value(name, value):.10g}" for value, before, after in changes]
    return "\n".join([table(header, rows), *lines])
