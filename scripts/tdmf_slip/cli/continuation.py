"""The command `continue`: a branch of gaits along a parameter, with all that happens on it."""

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

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
from ..checks import near_matches, shown
from ..errors import InputError
from ..library.quantities import reported_quantities
from ..library.runner import Runner
from ..terminal.text import headed, table
from ..variables.display_units import DisplayUnits
from .command import Answer, command, option
from .options import NewFile, Number, pairs_given, span_of
from .runner import Asked


@command(
    "continue",
    option("--vary", required=True, multiple=True, metavar="NAME=A:B"),
    option("--step", "max_step", of=continue_branch, kind=Number(SHORTEST_STEP, LARGEST_STEP)),
    option("--points", "max_points", of=continue_branch, kind=Number(1, MAX_POINTS, whole=True)),
    option("--no-switch", is_flag=True),
    option("--quantity", default="com_speed", metavar="NAME"),
    option("--output", kind=NewFile(".nc"), metavar="FILE"),
    plot="the branch",
)
def continue_command(
    asked: Asked,
    vary: tuple[str, ...],
    max_step: float,
    max_points: int,
    no_switch: bool,
    quantity: str,
    output: Path | None,
) -> Answer:
    """Follow a branch of gaits along a parameter, past folds, and locate its bifurcations.

    Folds, period doublings, Neimark-Sacker points and word borders are located. A point that cannot be
    classified is listed as unclassified. At a period doubling, the gaits of two strides are followed too, and
    from theirs the gaits of four. If there is no gait at A, the branch begins at the first value that has one
    and is followed both ways. With two parameters, the special points of the branch over the first one are
    followed as curves.

    Parameters
    ----------
    vary
        Parameter or input to vary, as in ground.friction=0.6:0.2 or hip.touchdown_angle='40 deg:60 deg'.
        Given twice: curves of special points over two parameters.
    no_switch
        Do not follow gaits of two and four strides from period doublings.
    quantity
        Quantity to draw: a coordinate of the apex, a quantity of the stride, or lambda_max.
    output
        Write the gaits as NetCDF (.nc).
    """
    texts = pairs_given(vary, "--vary", "NAME=A:B")
    spans = {name: span_of(name, text) for name, text in texts.items()}
    if len(spans) > 2:
        raise InputError(f"--vary is given {len(vary)} times; allowed: once, or twice for two parameters")
    runner = asked.runner(spans)
    display = DisplayUnits(texts, runner)
    if len(spans) == 2:
        if output is not None:
            raise InputError("--output: curves over two parameters have no file; allowed: with one --vary")
        return _curves(runner, spans, max_points, display)
    names = (*runner.coordinates, *reported_quantities(runner.reduced), "lambda_max")
    if quantity not in names:
        raise InputError(
            f"--quantity {shown(quantity)} is not allowed{near_matches(quantity, names)}; "
            f"allowed: {', '.join(names)}"
        )
    if output is not None:
        from ..files.resume import refuse_resumable  # xarray is slow to load

        refuse_resumable(output)
    limits: dict[str, Any] = {"max_step": max_step, "max_points": max_points}
    branch = continue_branch.plain(runner, spans, **limits, switch=not no_switch, progress=True)
    if output is not None:
        from ..files.netcdf import write_dataset

        write_dataset(output, branch_dataset(branch))
    look = {"quantity": quantity, "display": display}
    return Answer(_branch_object(branch), _branch_text(branch, display), lambda: branch_dataset(branch), look)


def _curves(
    runner: Runner, spans: Mapping[str, tuple[float, float]], max_points: int, display: DisplayUnits
) -> Answer:
    """Curves of special points over two parameters."""
    found = continue_curves(runner, spans, max_points=max_points, progress=True)
    curves = curves_in(found)
    plain = {
        **runner.record(*spans),
        "over": list(spans),
        "curves": [_curve_object(curve, spans) for curve in curves],
    }
    header, lines = [headed(name, display.unit(name)) for name in spans], []
    for curve in curves:
        words = f" {' to '.join(curve.words)}" if curve.words else ""
        lines.append(f"{curve.kind}{words}: {len(curve.points)} points ({curve.began}; {curve.ended})")
        points = curve.points * [display.factor(name) for name in spans]
        lines.append(table(header, [[f"{value:.10g}" for value in point] for point in points]))
    return Answer(plain, "\n".join(lines), lambda: found, {"display": display})


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


def _branch_text(branch: Branch, display: DisplayUnits) -> str:
    """Special points as a table, and where the branch begins and ends; then the branches of more strides."""
    header = ("special point", headed(branch.name, display.unit(branch.name)), "word", "unstable beyond")
    rows = [_row(branch, special, display) for special in branch.specials]
    stable = sum(gait.stable for gait in branch.gaits)
    strides = f"{branch.strides} stride{'s' if branch.strides > 1 else ''}"
    first, last = (display.value(branch.name, value) for value in (branch.values[0], branch.values[-1]))
    ends = f"from {first:.8g} ({branch.began}) to {last:.8g} ({branch.ended})"
    line = f"{len(branch.gaits)} gaits of {strides}, {stable} of them stable, {ends}"
    return "\n".join([line, table(header, rows), *(_branch_text(one, display) for one in branch.branches)])


def _row(branch: Branch, special: Special, display: DisplayUnits) -> tuple[str, str, str, str]:
    words = " to ".join(special.words) if special.words else special.gait.word
    after = branch.gaits[special.index + 1]
    kind = f"{special.kind} ({special.why})" if special.why else special.kind
    return kind, f"{display.value(branch.name, special.value):.10g}", words, str(after.unstable)
