"""The command `basin`: what a gait attracts."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..analysis.attraction import DISTURBED, robustness, volume
from ..analysis.ball import CHOICES, MAX_ALONG, Ball
from ..analysis.basin import AXES, basin, fate_counts, stable_gait
from ..analysis.preview import REFINEMENTS
from ..errors import InputError
from ..library.section import COORDINATES, check_axes
from ..record import without_record
from ..terminal.text import columns, quantity
from ..variables.display_units import DisplayUnits
from ..variables.table import MODELS, VARIABLES
from .options import JSON_OPTION, Command, NewFile, ends_of, json_text, plot_option
from .runner import Asked, runner_options
from .workers import executor_of, workers_options

if TYPE_CHECKING:
    import xarray


@click.command("basin", cls=Command)
@click.option(
    "--axes",
    "spans",
    multiple=True,
    metavar="NAME[=A:B]",
    help="Coordinate of the apex section and its range, as in com_height=1:4 or leg_angle='60 deg:80 deg'."
    " Given twice.  [default: com_height and com_speed, around the gait]",
)
@click.option(
    "--n",
    "count",
    type=click.IntRange(2, MAX_ALONG),
    default=128,
    help="Starts along each axis.",
)
@click.option(
    "--output",
    type=NewFile([".nc"]),
    metavar="FILE",
    help="Write the map as NetCDF (.nc), block by block. An existing file is resumed.",
)
@plot_option("the map")
@click.option(
    "--samples",
    type=click.IntRange(0, 100_000_000),
    default=20000,
    help="Random starts in all six coordinates, from which the volume is estimated; 0 for none.",
)
@click.option(
    "--ball",
    type=click.Choice((*CHOICES, "proved")),
    default="tested",
    help="Ball around the gait in which a start counts as settled. tested: its surface is tested by "
    "simulation, if that saves time; proved: small and slow to compute; none: every start is "
    "simulated until it is on the gait.",
)
@click.option(
    "--refine",
    type=click.Choice(REFINEMENTS),
    default="exact",
    help="exact simulates every start. preview simulates those near a border and fills in the rest: "
    "faster, but it can miss islands of fewer than 16 starts.",
)
@workers_options
@JSON_OPTION
@runner_options()
def basin_command(
    asked: Asked,
    spans: tuple[str, ...],
    count: int,
    output: Path | None,
    plot: Path | None,
    samples: int,
    ball: str,
    refine: str,
    workers: int | None,
    scheduler: str | None,
    as_json_object: bool,
) -> None:
    """Compute the region of attraction of a gait: a map of a slice, its volume and its robustness.

    Robustness is the largest push (a change of speed) and the largest step in the ground, both at an apex,
    from which the runner recovers.
    """
    named = _axes(spans, MODELS[asked.model or "full"].coordinates)
    runner = asked.runner()
    axes = {
        axis: ends_of(span, VARIABLES[f"apex.{axis}"], f"--axes {axis} =") if span else None
        for axis, span in named.items()
    }
    gait = stable_gait(runner)
    around: Ball | str = ball
    if ball == "proved":
        from ..proof.prove_attraction import proved_ball  # FLINT is slow to load, and an extra

        around = proved_ball(gait)
    with executor_of(workers, scheduler) as executor:
        data = basin(
            runner,
            axes,
            count,
            ball=around,
            refine=refine,
            path=output,
            executor=executor,
            progress=True,
        )
        found = volume(gait, samples, ball=around, executor=executor, progress=True) if samples else None
    if plot is not None:
        from ..pictures.plot import write_picture  # matplotlib is slow to load

        write_picture(plot, data)
    result: dict[str, Any] = {
        **gait.runner.record(),
        "word": gait.word,
        "starts": data["fate"].size,
        **fate_counts(data),
        **_made(data),
        "settled_share": data.settled_share,
        "settled_area": data.settled_area,
        **{name: value for name, value in data.attrs.items() if name.startswith("ball")},
        "robustness": robustness(gait).as_json(),
    }
    if found is not None:
        result["volume"] = found.as_json()
    print(
        json_text(result) if as_json_object else _basin_text(result, tuple(axes), DisplayUnits(values=runner))
    )


def _made(data: "xarray.Dataset") -> dict[str, int]:
    """How many strides were made, and of a preview how many starts were followed."""
    strides = data["strides_until_known"].values
    if "is_followed" not in data:
        return {"strides": int(strides.sum())}
    is_followed = data["is_followed"].values == 1
    return {"strides": int(strides[is_followed].sum()), "followed": int(is_followed.sum())}


def _axes(spans: tuple[str, ...], coordinates: Sequence[str]) -> dict[str, str]:
    """Ranges of --axes by name, each empty where it is to be around the gait."""
    if len(spans) not in (0, 2):
        raise InputError(f"--axes is given {len(spans)} times; allowed: twice, or not at all")
    parts = [tuple(part.strip() for part in text.partition("=")) for text in spans or AXES]
    (first, _, rows), (second, _, columns) = parts
    check_axes((first, second), coordinates)
    if first == second:
        raise InputError(f"--axes {spans[1]}: {first} is given twice; allowed: once")
    return {first: rows, second: columns}


def _basin_text(result: Mapping[str, Any], axes: tuple[str, ...], display: DisplayUnits) -> str:
    units = {axis: display.unit(f"apex.{axis}") for axis in COORDINATES}
    rows = {n: str(v) for n, v in without_record(result).items() if n not in ("robustness", "volume")}
    rows["settled_area"] = quantity(result["settled_area"], "·".join(units[axis] for axis in axes), 6)
    for name, value in result["robustness"].items():
        rows[name] = (
            "beyond the largest tried" if value is None else quantity(value, units[DISTURBED[name]], 4)
        )
    if "volume" in result:
        found = result["volume"]
        low, high = found["share_interval"]
        rows["volume"] = (
            f"{found['volume']:.5g} in the section's scales, {100 * found['share']:.2f} % of the box "
            f"({100 * found['confidence']:.0f} % confidence: {100 * low:.2f} to {100 * high:.2f} %)"
        )
    return columns(rows)
