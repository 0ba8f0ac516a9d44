"""The command `continue`: a branch of gaits along a parameter, with all that happens on it."""

from collections.abc import Iterable, Mapping
from pathlib import Path

import click

from ..analysis.branches import (
    LARGEST_STEP,
    MAX_POINTS,
    SHORTEST_STEP,
    Branch,
    branch_dataset,
    continue_branch,
)
from ..analysis.curves import Curve, continue_curves, curves_in
from ..analysis.special_points import Special
from ..errors import InputError
from ..library.members import check_varied
from ..library.runner import Runner
from ..terminal.text import headed, table
from ..variables.display_units import DisplayUnits
from ..variables.table import VARIABLES
from .options import JSON_OPTION, Command, NewFile, Number, ends_of, json_text, pairs_given, plot_option
from .runner import Asked, runner_options


@click.command("continue", cls=Command)
@click.option(
    "--vary",
    "ranges",
    required=True,
    multiple=True,
    metavar="NAME=A:B",
    help="Parameter or input to vary, as in ground.friction=0.6:0.2 or hip.touchdown_angle='40 deg:60 "
    "deg'. Given twice: curves of special points over two parameters.",
)
@click.option(
    "--step",
    type=Number(SHORTEST_STEP, LARGEST_STEP),
    default=0.2,
    help="Longest step along the branch, relative to the scales of the apex and of the parameter.",
)
@click.option(
    "--points",
    type=Number(1, MAX_POINTS, whole=True),
    default=1000,
    help="Maximum number of gaits in each direction.",
)
@click.option(
    "--no-switch", is_flag=True, help="Do not follow gaits of two and four strides from period doublings."
)
@plot_option("the branch")
@click.option(
    "--quantity",
    default="com_speed",
    metavar="NAME",
    help="Quantity to draw: a coordinate of the apex, a quantity of the stride, or lambda_max.",
)
@click.option("--output", type=NewFile([".nc"]), metavar="FILE", help="Write the gaits as NetCDF (.nc).")
@JSON_OPTION
@runner_options()
def continue_command(
    asked: Asked,
    ranges: tuple[str, ...],
    step: float,
    points: int,
    no_switch: bool,
    plot: Path | None,
    quantity: str,
    output: Path | None,
    as_json_object: bool,
) -> None:
    """Follow a branch of gaits along a parameter, past folds, and locate its bifurcations.

    Folds, period doublings, Neimark-Sacker points and word borders are located. A point that cannot be
    classified is listed as unclassified. At a period doubling, the gaits of two strides are followed too, and
    from theirs the gaits of four. If there is no gait at A, the branch begins at the first value that has one
    and is followed both ways. With two parameters, the special points of the branch over the first one are
    followed as curves.
    """
    texts = pairs_given(ranges, "--vary", "NAME=A:B")
    spans = {name: span_of(name, text) for name, text in texts.items()}
    if len(spans) > 2:
        raise InputError(f"--vary is given {len(ranges)} times; allowed: once, or twice for two parameters")
    runner = asked.runner(spans)
    display = DisplayUnits(texts, runner)
    if len(spans) == 2:
        if output is not None:
            raise InputError("--output: curves over two parameters have no file; allowed: with one --vary")
        _curves(runner, spans, points, plot, as_json_object, display)
        return
    if output is not None:
        from ..files.resume import refuse_resumable  # xarray is slow to load

        refuse_resumable(output)
    ((name, (begin, end)),) = spans.items()
    branch = continue_branch.plain(
        runner,
        {name: (begin, end)},
        max_step=step,
        max_points=points,
        switch=not no_switch,
        progress=True,
    )
    if output is not None:
        from ..files.netcdf import write_dataset  # xarray is slow to load

        write_dataset(output, branch_dataset(branch))
    if plot is not None:
        from ..pictures.plot import write_picture  # matplotlib is slow to load

        write_picture(plot, branch_dataset(branch), quantity=quantity, display=display)
    print(json_text(_branch_object(branch)) if as_json_object else _branch_text(branch, display))


def _curves(
    runner: Runner,
    spans: Mapping[str, tuple[float, float]],
    points: int,
    plot: Path | None,
    as_json_object: bool,
    display: DisplayUnits,
) -> None:
    found = continue_curves(runner, spans, max_points=points, progress=True)
    if plot is not None:
        from ..pictures.plot import write_picture  # matplotlib is slow to load

        write_picture(plot, found, display=display)
    if as_json_object:
        print(
            json_text(
                {
                    **runner.record(*spans),
                    "over": list(spans),
                    "curves": [_curve_object(curve, spans) for curve in curves_in(found)],
                }
            )
        )
        return
    for curve in curves_in(found):
        words = f" {' to '.join(curve.words)}" if curve.words else ""
        print(f"{curve.kind}{words}: {len(curve.points)} points ({curve.began}; {curve.ended})")
        header = tuple(headed(name, display.unit(name)) for name in spans)
        scales = [display.factor(name) for name in spans]
        print(table(header, [tuple(f"{v:.10g}" for v in pair) for pair in curve.points * scales]))


def _curve_object(curve: Curve, over: Iterable[str]) -> dict[str, object]:
    """A curve as a plain object; a point is a pair in the order of `over`."""
    words = {"from": curve.words[0], "to": curve.words[1]} if curve.words else {}
    ends = {"began": curve.began, "ended": curve.ended}
    return {"over": list(over), "kind": curve.kind, **words, "points": curve.points.tolist(), **ends}


def _branch_object(branch: Branch) -> dict[str, object]:
    """A branch as a plain object; a point is a gait's `as_json` with its `value`."""
    found = zip(branch.values, branch.gaits, strict=True)
    return {
        **branch.gaits[0].runner.record(branch.name),
        "over": branch.name,
        "strides": branch.strides,
        "points": [{"value": value, "unstable": gait.unstable, **gait.as_json()} for value, gait in found],
        "specials": [special.as_json() for special in branch.specials],
        "began": branch.began,
        "ended": branch.ended,
        "branches": [_branch_object(other) for other in branch.branches],
    }


def span_of(name: str, span: str) -> tuple[float, float]:
    """The range of a parameter or input that A:B stands for."""
    check_varied(name, "--vary")
    return ends_of(span, VARIABLES[name], f"--vary {name} =")


def _branch_text(branch: Branch, display: DisplayUnits) -> str:
    """Special points as a table, and where the branch begins and ends; then the branches of more strides."""
    header = ("special point", headed(branch.name, display.unit(branch.name)), "word", "unstable beyond")
    rows = [_row(branch, special, display) for special in branch.specials]
    stable = sum(gait.stable for gait in branch.gaits)
    strides = f"{branch.strides} stride{'s' if branch.strides > 1 else ''}"
    first, last = (display.value(branch.name, value) for value in (branch.values[0], branch.values[-1]))
    ends = f"from {first:.8g} ({branch.began}) to {last:.8g} ({branch.ended})"
    lines = [f"{len(branch.gaits)} gaits of {strides}, {stable} of them stable, {ends}"]
    return "\n".join(
        [*lines, table(header, rows), *(_branch_text(other, display) for other in branch.branches)]
    )


def _row(branch: Branch, special: Special, display: DisplayUnits) -> tuple[str, str, str, str]:
    words = " to ".join(special.words) if special.words else special.gait.word
    after = branch.gaits[special.index + 1]
    kind = f"{special.kind} ({special.why})" if special.why else special.kind
    return kind, f"{display.value(branch.name, special.value):.10g}", words, str(after.unstable)
