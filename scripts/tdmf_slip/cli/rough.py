"""The command `rough`: mean number of strides until a runner falls on rough ground."""

import math
from typing import Any

import click

from ..analysis.attraction import CONFIDENCE
from ..analysis.first_passage import MAX_RUNNERS, MAX_STRIDES, FirstPassage, strides_to_fall
from ..analysis.rare_falls import RareFalls, rare_falls
from ..errors import InputError
from ..library.ground import LARGEST, LARGEST_SPREAD, LAST_SEED, RoughGround, correlated_weights, read_heights
from ..library.runner import Runner
from ..record import without_record
from ..terminal.text import columns, quantity
from .command import Answer, command, option
from .options import Number
from .runner import RunnerOptions
from .workers import Workers


@command(
    "rough",
    option("--roughness", kind=Number(0.0, LARGEST), metavar="S"),
    option("--runners", of=strides_to_fall, kind=Number(1, MAX_RUNNERS, whole=True), metavar="N"),
    option("--seed", of=strides_to_fall, kind=Number(0, LAST_SEED, whole=True), metavar="K"),
    option("--max-strides", of=strides_to_fall, kind=Number(1, MAX_STRIDES, whole=True), metavar="M"),
    option("--correlation", kind=Number(-0.99, 0.99), default=0.0, metavar="C"),
    option("--trips", is_flag=True),
    option("--friction-spread", kind=Number(0.0, LARGEST_SPREAD), default=0.0, metavar="S"),
    option("--segment-length", kind=Number(0.0, LARGEST), default=0.0, metavar="L"),
    option("--heights", metavar="FILE"),
    option("--rare", is_flag=True),
    model=False,
    workers=True,
    plot="the probability of still being up after so many strides",
)
def rough_command(
    options: RunnerOptions,
    workers: Workers,
    roughness: float | None,
    runners: int,
    seed: int,
    max_strides: int,
    correlation: float,
    heights: str | None,
    rare: bool,
    **given: Any,
) -> Answer:
    """Estimate the mean number of strides until a runner falls on rough ground, with its confidence interval.

    Runners start from the gait on level ground. Runners that are still up at the end are censored: their
    strides count, but they add no fall.

    Parameters
    ----------
    roughness
        Standard deviation, in m, of the ground's step at each apex; with --segment-length, of the
        segments' heights.
    correlation
        Correlation of each step with the one before.
    trips
        Count a foot that hits the face of a step as a fall. By default it passes through on its way up.
    friction_spread
        Standard deviation of the logarithm of the friction, drawn for each stride or segment.
    segment_length
        Length, in m, of level segments at fixed places, each with its own height and friction.
    heights
        File with the heights of the segments, in m, instead of --roughness. They repeat after the last
        one.
    rare
        Use multilevel splitting, for rare falls. Not with --runners or --max-strides.
    """
    runner = options.runner()
    if (roughness is None) == (heights is None):
        which = "neither is given" if heights is None else "both are given"
        raise InputError(f"--roughness, --heights: {which}; allowed: one of them")
    given |= {"step_weights": correlated_weights(correlation)}
    given |= {"heights": () if heights is None else read_heights(heights)}
    ground = RoughGround(roughness or 0.0, seed, **given)
    found: FirstPassage | RareFalls
    if rare:
        context, source = click.get_current_context(), click.core.ParameterSource.COMMANDLINE
        for name in ("runners", "max_strides", "workers", "scheduler"):
            if context.get_parameter_source(name) is source:
                raise InputError(f"--{name.replace('_', '-')} with --rare; allowed: one of the two")
        found = rare_falls(runner, ground, seed=seed, progress=True)
    else:
        with workers.executor() as executor:
            counts = runners, seed, max_strides
            found = strides_to_fall(runner, ground, *counts, executor=executor, progress=True)
    return Answer(found.as_json(), _text(found, runner), lambda: found)


def _text(found: FirstPassage | RareFalls, runner: Runner) -> str:
    (low, high), plain = found.interval, without_record(found.as_json())
    ends = f"{low:.6g} to {high:.6g}" if math.isfinite(high) else f"above {low:.6g}"
    rows = {name: str(value) for name, value in plain.items() if name not in ("interval", "confidence")}
    rows["roughness"] = quantity(found.roughness, runner.label("m"), 12)
    rows["mean_strides"] = f"{found.mean_strides:.6g} ({100 * CONFIDENCE:.0f} % confidence: {ends})"
    return columns(rows)
