"""The commands `gait`, `sweep`, `basin` and `figures`: what rests on the return map."""

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import click
import numpy as np

from . import files
from .errors import InputError, RunError
from .gait import QUANTITIES
from .options import (
    FRICTION_OPTION,
    JSON_OPTION,
    PARAMETERS_OPTION,
    SCHEDULER_OPTION,
    SET_OPTION,
    WORKERS_OPTION,
    Command,
    file_values,
    json_text,
    refuse_given,
    start_values,
    values_given,
)
from .ranges import SPACINGS, ends_of, values_of
from .section import COORDINATES
from .text import columns, quantity, table
from .unit import Unit, load

if TYPE_CHECKING:
    from .orbit import Orbit, Runner
    from .sweep import Sweep

SPACING_OPTION = click.option(
    "--spacing",
    type=click.Choice(list(SPACINGS)),
    default="linear",
    show_default=True,
    help="Of the values in a range.",
)


@click.command("gait", cls=Command)
@FRICTION_OPTION
@SET_OPTION
@PARAMETERS_OPTION
@JSON_OPTION
def gait_command(
    friction: float | None, settings: tuple[str, ...], parameters: str | None, as_json_object: bool
) -> None:
    """The periodic gait, stable or not, with the eigenvalues of its return map."""
    from .sweep import first_orbit  # the C library is loaded when it is needed

    unit = load()
    orbit = first_orbit(_runner(unit, parameters, values_given(friction, settings)), unit)
    print(json_text(orbit.as_json()) if as_json_object else _orbit_text(orbit, unit))


@click.command("sweep", cls=Command)
@click.option("--friction", "frictions", required=True, metavar="A:B:N", help="N values from A to B.")
@click.option(
    "--over",
    metavar="NAME=A:B:N",
    help="A second parameter or input, as in leg.damping=0.1:0.3:20 or "
    "hip.touchdown_angle='35 deg:45 deg:11'; makes a grid of gaits, written to --output row by row; resumed "
    "where the file has rows already.",
)
@SPACING_OPTION
@click.option(
    "--output",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Write the gaits as NetCDF (.nc).",
)
@SCHEDULER_OPTION
@WORKERS_OPTION
@SET_OPTION
@PARAMETERS_OPTION
@JSON_OPTION
def sweep_command(
    frictions: str,
    over: str | None,
    spacing: str,
    output: Path | None,
    scheduler: str | None,
    workers: int | None,
    settings: tuple[str, ...],
    parameters: str | None,
    as_json_object: bool,
) -> None:
    """Gaits over a range of friction, and the borders between gait words.

    A range that begins where there is no gait is swept from the first friction that has one. Where gaits are
    missing, those that were found are printed and written, and the exit status is 1. The rows of a grid are
    computed side by side.
    """
    from . import sweep as sweeps  # the C library is loaded when it is needed
    from .resume import refuse_resumable

    if output is not None:
        files.check_place(output, (".nc",), "--output")
    unit = load()
    given = values_given(None, settings)
    refuse_given(given, sweeps.FRICTION, "--friction")
    values = values_of(frictions, spacing, unit.variables[sweeps.FRICTION], "--friction")
    runner = _runner(unit, parameters, given)
    if over is None and (scheduler is not None or workers is not None):
        raise InputError(
            "--scheduler, --workers: without --over each gait is found from the one before; "
            "allowed: with --over"
        )
    if over is not None:
        where = {"scheduler": scheduler, "workers": workers}
        refuse_given(given, over.partition("=")[0], "--over")
        _grid(runner, values, over, spacing, output, where, as_json_object)
        return
    if output is not None:
        refuse_resumable(output)
    found = sweeps.sweep(runner, values, show_progress=True)
    if output is not None:
        files.write_dataset(output, sweeps.as_dataset(found.gaits, {sweeps.FRICTION: values}, unit))
    print(json_text(found.as_json()) if as_json_object else _sweep_text(found, unit))
    if found.problem is not None:
        raise RunError(f"{found.problem}; {len(found.orbits)} of {len(values)} gaits were found")


def _grid(
    runner: "Runner",
    frictions: np.ndarray,
    over: str,
    spacing: str,
    output: Path | None,
    where: dict,
    as_json_object: bool,
) -> None:
    from . import sweep as sweeps
    from .orbit import check_varied

    name, equals, span = (part.strip() for part in over.partition("="))
    if not equals:
        raise InputError(f"--over {over}: allowed: NAME=A:B:N")
    if output is None:
        raise InputError("--over: a grid of gaits goes to a file; allowed: with --output FILE.nc")
    unit = load()
    check_varied(name, "--over")
    rows = values_of(span, spacing, unit.variables[name], f"--over {name} =")
    data = sweeps.grid(runner, frictions, name, rows, output, show_progress=True, unit=unit, **where)
    gaits = int(data["period"].notnull().sum())
    words = sorted({word for word in data["word"].values.ravel() if word})
    result = {"file": str(output), "points": data["period"].size, "gaits": gaits, "words": words}
    text = f"{output}: {gaits} gaits at {data['period'].size} points, words {', '.join(words)}"
    print(json_text(result) if as_json_object else text)
    problems = [problem for problem in data["problem"].values if problem]
    if problems:
        raise RunError(f"{problems[0]}; {gaits} of {data['period'].size} gaits were found")


@click.command("basin", cls=Command)
@FRICTION_OPTION
@click.option(
    "--axes",
    nargs=2,
    default=("com_height", "com_speed"),
    show_default=True,
    metavar="NAME NAME",
    help="Coordinates of the apex section that are varied.",
)
@click.option(
    "--range",
    "spans",
    nargs=2,
    metavar="A:B C:D",
    help="Their ranges, as in 1:4 or '60 deg:80 deg'.  [default: around the gait]",
)
@click.option(
    "--n",
    "count",
    type=click.IntRange(2, 16384),
    default=128,
    show_default=True,
    help="Starts along each axis.",
)
@click.option(
    "--output",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Write the map as NetCDF (.nc), block by block; gone on with where the file has blocks already.",
)
@click.option(
    "--plot", type=click.Path(path_type=Path), metavar="FILE", help="Draw the map: .png, .svg or .pdf."
)
@click.option(
    "--samples",
    type=click.IntRange(0, 100_000_000),
    default=20000,
    show_default=True,
    help="Random starts in all six coordinates, for the region's volume; 0 for none.",
)
@SCHEDULER_OPTION
@WORKERS_OPTION
@SET_OPTION
@PARAMETERS_OPTION
@JSON_OPTION
def basin_command(
    friction: float | None,
    axes: tuple[str, str],
    spans: tuple[str, str] | None,
    count: int,
    output: Path | None,
    plot: Path | None,
    samples: int,
    scheduler: str | None,
    workers: int | None,
    settings: tuple[str, ...],
    parameters: str | None,
    as_json_object: bool,
) -> None:
    """The region of attraction of a gait: a map over a slice of the apex section, its volume, its robustness.

    Robustness is the largest push (a change of speed) and step (of the ground, at an apex) that the runner
    recovers from.
    """
    from . import attraction  # the C library is loaded when it is needed
    from .basin import basin, check_axes, range_around, stable_gait

    check_axes(axes)
    if output is not None:
        files.check_place(output, (".nc",), "--output")
    if plot is not None:
        from .pictures import basin_map, overview  # matplotlib is slow to load

        files.check_place(plot, overview.FORMATS, "--plot")
    unit = load()
    runner = _runner(unit, parameters, values_given(friction, settings))
    variables = [unit.variables[f"apex.{axis}"] for axis in axes]
    ends = [ends_of(*pair, "--range") for pair in zip(spans, variables, strict=True)] if spans else None
    gait = stable_gait(runner, unit)
    ends = ends or [range_around(gait, axis) for axis in axes]
    ranges = tuple(np.linspace(*pair, count) for pair in ends)
    where = {"scheduler": scheduler, "workers": workers, "show_progress": True}
    data = basin(runner, axes, ranges, path=output, unit=unit, **where)
    if plot is not None:
        basin_map.draw(plot, data)
    fates = {
        name: int((data["fate"] == flag).sum())
        for flag, name in enumerate(data["fate"].attrs["flag_meanings"].split())
    }
    result = {
        "word": gait.word,
        "starts": data["fate"].size,
        **fates,
        "strides": int(data["strides"].sum()),
        "settled_share": data.attrs["settled_share"],
        "settled_area": data.attrs["settled_area"],
        "robustness": attraction.robustness(gait).as_json(),
    }
    if samples:
        result["volume"] = attraction.volume(gait, samples, **where).as_json()
    print(json_text(result) if as_json_object else _basin_text(result, axes, unit))


@click.command("figures", cls=Command)
@click.option(
    "--output",
    "folder",
    type=click.Path(path_type=Path),
    default=Path("figures"),
    show_default=True,
    metavar="FOLDER",
    help="Where the figures go.",
)
@click.option("--only", metavar="NAME", help="Only the figures whose name begins like this, as in figure_9.")
def figures_command(folder: Path, only: str | None) -> None:
    """The paper's figures, remade: PNG and SVG, with the data of each beside it as CSV."""
    from .pictures import figures  # matplotlib is slow to load

    files.check_folder(folder, "--output")
    for path in figures.draw(folder, load(), only=only, show_progress=True):
        print(path)


def _runner(unit: Unit, parameters: str | None, given: Mapping[str, tuple[str, object]]) -> "Runner":
    """The runner of the options.

    Raises:
        InputError: a value is refused, or has no part in a gait.
    """
    from .orbit import STATES, VARIED, Runner

    starts = start_values(unit, file_values(unit, parameters), given)
    for name, (option, _) in given.items():
        if name not in (*VARIED, *STATES):
            raise InputError(
                f"{option} {name}: has no meaning for gaits, which the library finds without the unit; "
                f"allowed: parameters and inputs of the model, and its state"
            )
    return Runner.of(starts, unit)


def _orbit_text(orbit: "Orbit", unit: Unit) -> str:
    def of(name: str, value: float) -> str:
        return quantity(value, unit.variables[name].unit, 12)

    rows = {
        "word": orbit.word,
        "friction": of("ground.friction", orbit.friction),
        **{name: of(f"stride.{name}", orbit.stride[name]) for name in QUANTITIES},
        "liftoff_angle": of("hip.liftoff_angle", orbit.liftoff_angle),
        **{f"apex.{n}": of(f"apex.{n}", v) for n, v in zip(COORDINATES, orbit.apex, strict=True)},
        "eigenvalues": ", ".join(_complex(value) for value in orbit.eigenvalues),
        "stable": "yes" if orbit.stable else "no",
    }
    return columns(rows)


def _basin_text(result: dict, axes: tuple[str, str], unit: Unit) -> str:
    units = {axis: unit.variables[f"apex.{axis}"].unit for axis in COORDINATES}
    rows = {n: str(v) for n, v in result.items() if n not in ("robustness", "volume")}
    rows["settled_area"] = quantity(result["settled_area"], "·".join(units[axis] for axis in axes), 6)
    for name, value in result["robustness"].items():
        axis = "com_speed" if name.startswith("push") else "com_height"
        rows[name] = "beyond the largest tried" if value is None else quantity(value, units[axis], 4)
    if "volume" in result:
        found = result["volume"]
        low, high = found["share_interval"]
        rows["volume"] = (
            f"{found['volume']:.5g} in the section's scales, {100 * found['share']:.2f} % of the box "
            f"({100 * found['confidence']:.0f} % confidence: {100 * low:.2f} to {100 * high:.2f} %)"
        )
    return columns(rows)


def _complex(value: complex) -> str:
    value = complex(value)
    return f"{value.real:.9g}" if value.imag == 0.0 else f"{value.real:.9g}{value.imag:+.9g}i"


def _sweep_text(found: "Sweep", unit: Unit) -> str:
    rows = [
        (
            f"{orbit.friction:.6g}",
            orbit.word,
            f"{orbit.stride['period']:.8g}",
            f"{orbit.stride['speed']:.8g}",
            f"{orbit.stride['cost_of_transport']:.8g}",
            f"{abs(orbit.eigenvalues[0]):.8f}",
            "yes" if orbit.stable else "no",
        )
        for orbit in found.orbits
    ]
    with_units = [f"{name} ({unit.variables[f'stride.{name}'].unit})" for name in ("period", "speed")]
    header = ("friction", "word", *with_units, "cost of transport", "lambda_max", "stable")
    borders = [f"{border.before} to {border.after} at {border.value:.10g}" for border in found.borders]
    return "\n".join([table(header, rows), *borders])
