"""The commands `gait`, `sweep`, `basin` and `figures`: what rests on the return map."""

from pathlib import Path

import click

from . import files
from .errors import InputError, RunError
from .options import (
    JSON_OPTION,
    PARAMETERS_OPTION,
    SCHEDULER_OPTION,
    SET_OPTION,
    WORKERS_OPTION,
    json_text,
    refuse_set,
    start_values,
)
from .text import table
from .unit import load

SPACING_OPTION = click.option(
    "--spacing",
    type=click.Choice(["linear", "log"]),
    default="linear",
    show_default=True,
    help="Of the values in a range.",
)


@click.command("gait")
@click.option(
    "--friction", type=float, metavar="MU", help="Friction of the ground; short for ground.friction."
)
@SET_OPTION
@PARAMETERS_OPTION
@JSON_OPTION
def gait_command(
    friction: float | None, settings: tuple[str, ...], parameters: str | None, as_json_object: bool
) -> None:
    """The periodic gait, stable or not, with the eigenvalues of its return map."""
    from .orbit import Runner  # the C library is loaded when it is needed
    from .sweep import first_orbit

    unit = load()
    orbit = first_orbit(Runner.of(start_values(unit, parameters, friction, settings), unit), unit)
    print(json_text(orbit.as_json()) if as_json_object else _orbit_text(orbit))


@click.command("sweep")
@click.option("--friction", "frictions", required=True, metavar="A:B:N", help="N values from A to B.")
@click.option(
    "--over",
    metavar="NAME=A:B:N",
    help="A second parameter or input: a grid of gaits, written to --output row by row; resumed where the "
    "file has rows already.",
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

    Where the branch of gaits cannot be followed to the end, what was found is printed and written, and the
    exit status is 1. The rows of a grid are computed side by side.
    """
    from . import sweep as sweeps  # the C library is loaded when it is needed
    from .orbit import Runner
    from .resume import refuse_resumable

    if output is not None:
        files.check_place(output, (".nc",), "--output")
    unit = load()
    refuse_set(settings, sweeps.FRICTION, "--friction")
    values = sweeps.values_of(frictions, spacing, "--friction")
    runner = Runner.of(start_values(unit, parameters, None, settings), unit)
    if over is None and (scheduler is not None or workers is not None):
        raise InputError(
            "--scheduler, --workers: without --over each gait is found from the one before; "
            "allowed: with --over"
        )
    if over is not None:
        where = {"scheduler": scheduler, "workers": workers}
        refuse_set(settings, over.partition("=")[0], "--over")
        _grid(runner, values, over, spacing, output, where, as_json_object)
        return
    if output is not None:
        refuse_resumable(output)
    found = sweeps.sweep(runner, values, show_progress=True)
    if output is not None:
        coordinates = {sweeps.FRICTION: values[: len(found.orbits)]}
        files.write_dataset(output, sweeps.as_dataset(found.orbits, coordinates, unit))
    print(json_text(found.as_json()) if as_json_object else _sweep_text(found))
    if found.problem is not None:
        raise RunError(f"{found.problem}; {len(found.orbits)} of {len(values)} gaits were found")


def _grid(
    runner: object,
    frictions: object,
    over: str,
    spacing: str,
    output: Path | None,
    where: dict,
    as_json_object: bool,
) -> None:
    from . import sweep as sweeps

    name, equals, span = over.partition("=")
    if not equals:
        raise InputError(f"--over {over}: allowed: NAME=A:B:N")
    if output is None:
        raise InputError("--over: a grid of gaits goes to a file; allowed: with --output FILE.nc")
    unit = load()
    variable = unit.find(name, "--over")
    if name not in runner.values or variable.causality not in ("parameter", "input"):
        raise InputError(f"--over {name}: allowed: a parameter or input")
    rows = sweeps.values_of(span, spacing, "--over")
    data = sweeps.grid(runner, frictions, name, rows, output, show_progress=True, unit=unit, **where)
    gaits = int(data["period"].notnull().sum())
    words = sorted({word for word in data["word"].values.ravel() if word})
    result = {"file": str(output), "points": data["period"].size, "gaits": gaits, "words": words}
    text = f"{output}: {gaits} gaits at {data['period'].size} points, words {', '.join(words)}"
    print(json_text(result) if as_json_object else text)
    problems = [problem for problem in data["problem"].values if problem]
    if problems:
        raise RunError(f"{problems[0]}; {gaits} of {data['period'].size} gaits were found")


@click.command("basin")
@click.option(
    "--friction", type=float, metavar="MU", help="Friction of the ground; short for ground.friction."
)
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
    help="Their ranges.  [default: around the gait]",
)
@click.option(
    "--n",
    "count",
    type=click.IntRange(1, 16384),
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
    from .basin import basin, range_around, stable_gait
    from .orbit import Runner
    from .sweep import values_of

    if output is not None:
        files.check_place(output, (".nc",), "--output")
    if plot is not None:
        from .pictures import basin_map, overview  # matplotlib is slow to load

        files.check_place(plot, overview.FORMATS, "--plot")
    unit = load()
    runner = Runner.of(start_values(unit, parameters, friction, settings), unit)
    gait = stable_gait(runner, unit)
    spans = spans or tuple(range_around(gait, axis) for axis in axes)
    ranges = tuple(values_of(f"{span}:{count}", "linear", "--range") for span in spans)
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
    print(json_text(result) if as_json_object else _basin_text(result))


@click.command("figures")
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


def _orbit_text(orbit: object) -> str:
    values = orbit.as_json()
    eigenvalues = ", ".join(_complex(value) for value in orbit.eigenvalues)
    apex = ", ".join(f"{value:.12g}" for value in orbit.apex)
    lines = [f"{name:18}{value:.12g}" for name, value in values.items() if isinstance(value, float)]
    return "\n".join(
        [
            f"{'word':18}{orbit.word}",
            *lines,
            f"{'apex':18}{apex}",
            f"{'eigenvalues':18}{eigenvalues}",
            f"{'stable':18}{'yes' if orbit.stable else 'no'}",
        ]
    )


def _basin_text(result: dict) -> str:
    robustness = {
        name: "beyond the largest tried" if value is None else f"{value:.4g}"
        for name, value in result["robustness"].items()
    }
    rows = {n: v for n, v in result.items() if n not in ("robustness", "volume")} | robustness
    lines = [f"{name:18}{value}" for name, value in rows.items()]
    if "volume" in result:
        found = result["volume"]
        low, high = found["share_interval"]
        lines.append(
            f"{'volume':18}{found['volume']:.5g}, {100 * found['share']:.2f} % of the box "
            f"({100 * found['confidence']:.0f} % confidence: {100 * low:.2f} to {100 * high:.2f} %)"
        )
    return "\n".join(lines)


def _complex(value: complex) -> str:
    value = complex(value)
    return f"{value.real:.9g}" if value.imag == 0.0 else f"{value.real:.9g}{value.imag:+.9g}i"


def _sweep_text(found: object) -> str:
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
    header = ("friction", "word", "period", "speed", "cost of transport", "lambda_max", "stable")
    borders = [f"{border.before} to {border.after} at {border.value:.10g}" for border in found.borders]
    return "\n".join([table(header, rows), *borders])
