"""The command `continue`: a branch of gaits along a parameter, with its bifurcations."""

from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..analysis.branches import LARGEST_STEP, MAX_POINTS, SHORTEST_STEP, continue_branch
from ..analysis.curves import continue_curves
from ..analysis.sweeps import gaits_in
from ..checks import check_names
from ..errors import InputError, counted
from ..library.quantities import reported_quantities
from ..library.runner import Runner
from ..record import parts_of
from ..terminal.text import headed, table
from ..variables.display_units import DisplayUnits
from .command import Answer, command, option
from .options import NewFile, Number, pairs_given, span_of
from .runner import RunnerOptions

if TYPE_CHECKING:
    import xarray


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
    options: RunnerOptions,
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
    runner = options.runner(spans)
    display = DisplayUnits(texts, runner)
    if len(spans) == 2:
        if output is not None:
            raise InputError("--output cannot hold curves over two parameters; allowed: with one --vary")
        return _curves(runner, spans, max_points, display)
    names = (*runner.coordinates, *reported_quantities(runner.reduced), "lambda_max")
    check_names([quantity], names, "--quantity")
    if output is not None:
        from ..files.resume import refuse_resumable  # xarray is slow to load

        refuse_resumable(output)
    limits: dict[str, Any] = {"max_step": max_step, "max_points": max_points}
    branch = continue_branch(runner, spans, **limits, switch=not no_switch, progress=True)
    if output is not None:
        from ..files.netcdf import write_dataset

        write_dataset(output, branch)
    look = {"quantity": quantity, "display": display}
    parts = parts_of(branch, "branch")
    text = "\n".join(_branch_text(part, display) for part in parts)
    return Answer(partial(_branch_object, runner, parts), text, lambda: branch, look)


def _curves(
    runner: Runner, spans: Mapping[str, tuple[float, float]], max_points: int, display: DisplayUnits
) -> Answer:
    """Curves of special points over two parameters."""
    found = continue_curves(runner, spans, max_points=max_points, progress=True)
    header, lines, curves = [headed(name, display.unit(name)) for name in spans], [], []
    for part in parts_of(found, "curve"):
        kind, began, ended, before, after = (
            part[name].item() for name in ("kind", "began", "ended", "before", "after")
        )
        points = np.column_stack([part[name].values for name in spans])
        words = {"from": before, "to": after} if before else {}
        ends = {"began": began, "ended": ended}
        curves.append({"over": list(spans), "kind": kind, **words, "points": points.tolist(), **ends})
        named = " ".join(filter(None, (kind, " to ".join(words.values()))))
        lines.append(f"{named}: {counted(len(points), 'point')} ({began}; {ended})")
        points *= [display.factor(name) for name in spans]
        lines.append(table(header, [[f"{value:.10g}" for value in point] for point in points]))
    plain = {**runner.record(*spans), "over": list(spans), "curves": curves}
    first, second = spans
    none = f"no curves: gaits over {first} have no special points at this {second}; try a wider range"
    return Answer(plain, "\n".join(lines) or none, lambda: found, {"display": display})


def _branch_object(runner: Runner, parts: "list[xarray.Dataset]") -> dict[str, Any]:
    """A branch as a plain object, with the branches of more strides that begin on it.

    A point is a gait's `as_json` with its `value`.
    """
    branch, name = parts[0], parts[0].over
    gaits, specials = (branch.isel(point=(branch["special"] == "") == is_gait) for is_gait in (True, False))
    strides = int(branch["branch_strides"])
    return {
        **runner.record(name),
        "over": name,
        "strides": strides,
        "points": [
            {"value": gait.runner[name], "unstable": gait.unstable, **gait.as_json()}
            for gait in gaits_in(gaits)
        ],
        "specials": [
            _special_object(specials.isel(point=number)) for number in range(specials.sizes["point"])
        ],
        "began": branch["branch_began"].item(),
        "ended": branch["branch_ended"].item(),
        "branches": [
            _branch_object(runner, parts[number:])
            for number in range(1, len(parts))
            if _begins_on(parts, number)
        ],
    }


def _begins_on(parts: "list[xarray.Dataset]", number: int) -> bool:
    """True if a branch begins on the first one: it has twice the strides, and none between is as short."""
    first, *others = (int(part["branch_strides"]) for part in parts[: number + 1])
    return others[-1] == 2 * first and min(others) > first


def _special_object(special: "xarray.Dataset") -> dict[str, object]:
    """A special point as a plain object; `from` and `to` are the words where they change."""
    before, after, why = (special[name].item() for name in ("before", "after", "why"))
    known: dict[str, object] = {"kind": special["special"].item(), "value": special[special.over].item()}
    words = {"from": before, "to": after} if before or after else {}
    return known | words | ({"between": special["between"].values.tolist(), "why": why} if why else {})


def _branch_text(branch: "xarray.Dataset", display: DisplayUnits) -> str:
    """Special points as a table, and where the branch begins and ends."""
    name, specials = branch.over, branch["special"].values
    header = ("special point", headed(name, display.unit(name)), "word", "unstable beyond")
    gaits = np.flatnonzero(specials == "")
    rows = []
    for row in np.flatnonzero(specials != ""):
        before, after, why = (branch[of].values[row] for of in ("before", "after", "why"))
        words = f"{before} to {after}" if before or after else branch["word"].values[row]
        kind = f"{specials[row]} ({why})" if why else specials[row]
        beyond = branch["unstable"].values[gaits[gaits > row][0]]
        rows.append((kind, f"{display.value(name, branch[name].values[row]):.10g}", words, str(beyond)))
    stable = int(np.count_nonzero(branch["unstable"].values[gaits] == 0))
    strides = int(branch["branch_strides"])
    first, last = (display.value(name, value) for value in branch[name].values[gaits[[0, -1]]])
    began, ended = branch["branch_began"].item(), branch["branch_ended"].item()
    line = (
        f"{counted(len(gaits), 'gait')} of {counted(strides, 'stride')}, {stable} of them stable, "
        f"over {headed(name, display.unit(name))} from {first:.8g} ({began}) to {last:.8g} ({ended})"
    )
    return "\n".join([line, table(header, rows) if rows else "no special points"])
