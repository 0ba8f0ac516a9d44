"""The command `rough`: how long a runner stays up on rough ground."""

import math

import click

from ..analysis.attraction import CONFIDENCE
from ..analysis.first_passage import MAX_RUNNERS, MAX_STRIDES, FirstPassage, strides_to_fall
from ..analysis.rare_falls import RareFalls, rare_falls
from ..errors import InputError
from ..library.ground import (
    LARGEST,
    LARGEST_SPREAD,
    LAST_SEED,
    RoughGround,
    correlated_weights,
    read_heights,
)
from ..library.runner import Runner
from ..record import without_record
from ..terminal.text import columns, quantity
from .options import JSON_OPTION, Command, Number, json_text
from .runner import Asked, runner_options
from .workers import executor_of, workers_options


@click.command("rough", cls=Command)
@click.option(
    "--roughness",
    type=Number(0.0, LARGEST),
    metavar="S",
    help="Standard deviation, in m, of the ground's step at each apex; with --segment-length, of the "
    "segments' heights.",
)
@click.option(
    "--runners",
    type=Number(1, MAX_RUNNERS, whole=True),
    default=1000,
    metavar="N",
    help="Number of runners, each on its own random ground.",
)
@click.option(
    "--seed",
    type=Number(0, LAST_SEED, whole=True),
    default=0,
    metavar="K",
    help="Seed of the random ground.",
)
@click.option(
    "--max-strides",
    type=Number(1, MAX_STRIDES, whole=True),
    default=10_000,
    metavar="M",
    help="Number of strides after which a runner is censored.",
)
@click.option(
    "--correlation",
    type=Number(-0.99, 0.99),
    default=0.0,
    metavar="C",
    help="Correlation of each step with the one before.",
)
@click.option(
    "--trips",
    is_flag=True,
    help="Count a foot that hits the face of a step as a fall. By default it passes through on its way up.",
)
@click.option(
    "--friction-spread",
    type=Number(0.0, LARGEST_SPREAD),
    default=0.0,
    metavar="S",
    help="Standard deviation of the logarithm of the friction, drawn for each stride or segment.",
)
@click.option(
    "--segment-length",
    type=Number(0.0, LARGEST),
    default=0.0,
    metavar="L",
    help="Length, in m, of level segments at fixed places, each with its own height and friction.",
)
@click.option(
    "--heights",
    metavar="FILE",
    help="File with the heights of the segments, in m, in place of --roughness. They repeat after the last"
    " one.",
)
@click.option(
    "--rare",
    is_flag=True,
    help="Use multilevel splitting, for rare falls. Not with --runners or --max-strides.",
)
@workers_options
@JSON_OPTION
@runner_options(model=False)
def rough_command(
    asked: Asked,
    roughness: float | None,
    runners: int,
    seed: int,
    max_strides: int,
    correlation: float,
    trips: bool,
    friction_spread: float,
    segment_length: float,
    heights: str | None,
    rare: bool,
    workers: int | None,
    scheduler: str | None,
    as_json_object: bool,
) -> None:
    """Estimate the mean number of strides until a runner falls on rough ground, with its confidence interval.

    Runners start from the gait on level ground. Runners that are still up at the end are censored: their
    strides count, but they add no fall.
    """
    runner = asked.runner()
    if (roughness is None) == (heights is None):
        given = "neither is given" if heights is None else "both are given"
        raise InputError(f"--roughness, --heights: {given}; allowed: one of them")
    ground = RoughGround(
        0.0 if roughness is None else roughness,
        seed,
        step_weights=correlated_weights(correlation),
        trips=trips,
        friction_spread=friction_spread,
        segment_length=segment_length,
        heights=() if heights is None else read_heights(heights),
    )
    found: FirstPassage | RareFalls
    if rare:
        _check_alone("runners", "max_strides", "workers", "scheduler")
        found = rare_falls(runner, ground, seed=seed, progress=True)
    else:
        with executor_of(workers, scheduler) as executor:
            found = strides_to_fall(
                runner, ground, runners, seed, max_strides, executor=executor, progress=True
            )
    print(json_text(found.as_json()) if as_json_object else _text(found, runner))


def _check_alone(*names: str) -> None:
    """Refuse options that --rare has no use for."""
    context = click.get_current_context()
    for name in names:
        if context.get_parameter_source(name) is click.core.ParameterSource.COMMANDLINE:
            raise InputError(f"--{name.replace('_', '-')} with --rare; allowed: one of the two")


def _text(found: FirstPassage | RareFalls, runner: Runner) -> str:
    (low, high), plain = found.interval, without_record(found.as_json())
    ends = f"{low:.6g} to {high:.6g}" if math.isfinite(high) else f"above {low:.6g}"
    rows = {name: str(value) for name, value in plain.items() if name not in ("interval", "confidence")}
    rows["roughness"] = quantity(found.roughness, runner.label("m"), 12)
    rows["mean_strides"] = f"{found.mean_strides:.6g} ({100 * CONFIDENCE:.0f} % confidence: {ends})"
    return columns(rows)
