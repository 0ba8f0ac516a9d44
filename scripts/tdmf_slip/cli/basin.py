"""The command `basin`: the region of attraction of a gait."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import click

from ..analysis.attraction import DISTURBED, attraction_volume, robustness
from ..analysis.ball import CHOICES, MAX_ALONG, Ball
from ..analysis.basin import AXES, basin, fate_counts, stable_gait
from ..analysis.preview import REFINEMENTS
from ..errors import InputError
from ..library.section import COORDINATES, check_axes
from ..record import without_record
from ..terminal.text import columns, quantity
from ..variables.display_units import DisplayUnits
from ..variables.table import MODELS, VARIABLES
from .command import Answer, command, option
from .options import NewFile, Number, ends_of
from .runner import RunnerOptions
from .workers import Workers

if TYPE_CHECKING:
    import xarray


@command(
    "basin",
    option("--axes", "spans", multiple=True, metavar="NAME[=A:B]"),
    option("--n", of=basin, kind=Number(2, MAX_ALONG, whole=True), metavar="N"),
    option("--output", "path", of=basin, kind=NewFile(".nc"), metavar="FILE"),
    option("--samples", kind=Number(0, 100_000_000, whole=True), default=20000, metavar="N"),
    option("--ball", of=basin, kind=click.Choice((*CHOICES, "proved"))),
    option("--refine", of=basin, kind=click.Choice(REFINEMENTS)),
    workers=True,
    plot="the map",
)
def basin_command(
    options: RunnerOptions, workers: Workers, spans: tuple[str, ...], samples: int, **given: Any
) -> Answer:
    """Compute the region of attraction of a gait: a map of a slice, its volume and its robustness.

    Robustness is the largest push (a change of speed) and the largest step in the ground, both at an apex,
    from which the runner recovers.

    Parameters
    ----------
    spans
        Coordinate of the apex section and its range, as in com_height=1:4 or leg_angle='60 deg:80 deg'.
        Given twice.  [default: com_height and com_speed, around the gait]
    samples
        Random starts in all six coordinates, from which the volume is estimated; 0 for none.
    """
    named = _axes(spans, MODELS[options.model or "full"].coordinates)
    runner = options.runner()
    axes = {
        axis: ends_of(span, VARIABLES[f"apex.{axis}"], f"--axes {axis} =") if span else None
        for axis, span in named.items()
    }
    gait = stable_gait(runner)
    ball: Ball | str = given["ball"]
    if ball == "proved":
        from ..proof.prove_attraction import proved_ball  # FLINT is slow to load, and an extra

        given["ball"] = ball = proved_ball(gait)
    with workers.executor() as executor:
        data = basin(runner, axes, executor=executor, progress=True, **given)
        found = (
            attraction_volume(gait, samples, ball=ball, executor=executor, progress=True) if samples else None
        )
    result: dict[str, Any] = {
        **gait.runner.record(),
        "word": gait.word,
        "starts": data["fate"].size,
        **fate_counts(data),
        **_stride_counts(data),
        "settled_share": data.settled_share,
        "settled_area": data.settled_area,
        **{name: value for name, value in data.attrs.items() if name.startswith("ball")},
        "robustness": robustness(gait).as_json(),
        **({} if found is None else {"volume": found.as_json()}),
    }
    return Answer(result, _text(result, tuple(axes), DisplayUnits(values=runner)), lambda: data)


def _stride_counts(data: "xarray.Dataset") -> dict[str, int]:
    """Number of strides that were computed, and in a preview the number of starts that were followed."""
    strides = data["strides_until_known"].values
    if "is_followed" not in data:
        return {"strides": int(strides.sum())}
    is_followed = data["is_followed"].values == 1
    return {"strides": int(strides[is_followed].sum()), "followed": int(is_followed.sum())}


def _axes(spans: tuple[str, ...], coordinates: Sequence[str]) -> dict[str, str]:
    """Ranges of --axes by name; an empty text stands for a range around the gait."""
    parts = [tuple(part.strip() for part in text.partition("=")) for text in spans or AXES]
    check_axes([name for name, *_ in parts], coordinates)
    if len(parts) != 2:
        count = "once" if len(parts) == 1 else f"{len(parts)} times"
        raise InputError(f"--axes is given {count}; allowed: twice, or not at all")
    (first, _, rows), (second, _, columns) = parts
    if first == second:
        raise InputError(f"--axes {spans[1]}: {first} is given twice; allowed: once")
    return {first: rows, second: columns}


def _text(result: Mapping[str, Any], axes: tuple[str, ...], display: DisplayUnits) -> str:
    units = {axis: display.unit(f"apex.{axis}") for axis in COORDINATES}
    rows = {n: str(v) for n, v in without_record(result).items() if n not in ("robustness", "volume")}
    rows["settled_area"] = quantity(result["settled_area"], "·".join(units[axis] for axis in axes), 6)
    for name, value in result["robustness"].items():
        beyond = value is None
        rows[name] = "beyond the largest tried" if beyond else quantity(value, units[DISTURBED[name]], 4)
    if "volume" in result:
        found = result["volume"]
        low, high = found["share_interval"]
        rows["volume"] = (
            f"{found['volume']:.5g} in the section's scales, {100 * found['share']:.2f} % of the box "
            f"({100 * found['confidence']:.0f} % confidence: {100 * low:.2f} to {100 * high:.2f} %)"
        )
    return columns(rows)
