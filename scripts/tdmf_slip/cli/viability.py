"""The command `viability`: the apices from which some choice of actions avoids a fall."""

import csv
import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..analysis.targeted import find_gait
from ..errors import InputError, counted
from ..files.whole import whole
from ..library.batch_tables import CLOSED
from ..library.runner import Runner
from ..library.section import REDUCED
from ..library.settings import setting_number
from ..record import runner_in
from ..terminal.text import columns
from ..variables.table import MODELS, VARIABLES, model_recorded
from ..viable_sets.grid import MAX_CELLS, VALUES
from ..viable_sets.viability import LARGEST_FACTOR, ViableController, viability
from .command import Answer, command, option
from .options import NewFile, Number, ends_of, pairs_given, range_of
from .runner import RunnerOptions
from .workers import Workers

if TYPE_CHECKING:
    import xarray


@command(
    "viability",
    option("--axes", multiple=True, required=True, metavar="NAME=A:B"),
    click.option(
        "--vary",
        multiple=True,
        required=True,
        metavar="NAME=A:B[:N]",
        help="Setting to choose at each apex, its range, and the number of values, as in "
        f"'hip.touchdown_angle=20 deg:60 deg:32'. Repeatable.  [default: N = {VALUES}]",
    ),
    option("--n", of=viability, kind=Number(2, MAX_CELLS, whole=True), metavar="N"),
    option("--factor", of=viability, kind=Number(1.0, LARGEST_FACTOR), metavar="F"),
    option("--model", of=viability, kind=click.Choice(list(MODELS))),
    option("--output", "path", of=viability, kind=NewFile(".nc"), metavar="FILE"),
    option("--gait", "of_gait", is_flag=True),
    option("--controller", kind=NewFile(".csv"), metavar="FILE"),
    model=False,
    workers=True,
    plot="the sets",
)
def viability_command(
    options: RunnerOptions,
    workers: Workers,
    axes: tuple[str, ...],
    vary: tuple[str, ...],
    model: str,
    of_gait: bool,
    controller: Path | None,
    **given: Any,
) -> Answer:
    """Compute the viable set: the apices from which some choice of actions avoids a fall forever.

    Two sets bracket it on a grid of heights and speeds, one from inside and one from outside. Both are
    estimates. A cell that is only in the outer set is undecided.

    Parameters
    ----------
    axes
        Range of com_height or com_speed at the apex, as in com_height=0.5:3. Given twice.
    of_gait
        Also find the cells from which some choice leads to the runner's gait, and the largest drop of the
        ground at the gait's apex that leaves a viable state.
    controller
        Write the viable action nearest to the runner's settings for each cell, as CSV.
    """
    runner = replace(options, model=model).runner()
    given |= {"model": model, "gait": find_gait(runner) if of_gait else None}
    given |= {"axes": _axes_given(axes), "vary": _vary_given(vary)}
    with workers.executor() as executor:
        found = viability(runner, executor=executor, progress=True, **given)
    if controller is not None:
        with whole(controller) as path, path.open("w", encoding="utf-8", newline="") as file:
            csv.writer(file).writerows(ViableController(found).as_table())
    plain = _plain(found)
    return Answer(plain, _text(plain), lambda: found)


def _plain(found: "xarray.Dataset") -> dict[str, Any]:
    """The viable set in a few numbers, as a plain object."""
    settings = found["viable_pair"].dims[len(REDUCED) :]
    edges = {axis: found[f"{axis}_edge"].values for axis in REDUCED}
    values = {str(name): found[name].values for name in settings}
    plain: dict[str, Any] = {
        **Runner(runner_in(found), model=model_recorded(found.attrs)).record(),
        "axes": {axis: [float(of[0]), float(of[-1])] for axis, of in edges.items()},
        "vary": {name: [float(of[0]), float(of[-1]), len(of)] for name, of in values.items()},
        "cells": list(found["viable"].shape),
        "actions": math.prod(map(len, values.values())),
        "strides": found["fate"].size,
        "closed": int((found["fate"] == CLOSED).sum()),
        "factor": found.factor,
    }
    for kind in ("share", "robustness", "passes"):
        for name in ("inner", "outer"):
            of = f"{name}_{kind}"
            plain[of] = float(found[of].mean()) if kind == "robustness" else found.attrs[of]
    if "at_gait" in found:
        at_gait, drops = found["at_gait"] == 1, [found[f"{name}_drop"] for name in ("inner", "outer")]
        strides = {name: found[f"{name}_strides"] for name in ("inner", "outer")}
        plain["reached"] = {
            "cells": int(at_gait.sum()),
            **{f"{name}_share": float((of >= 0).mean()) for name, of in strides.items()},
            **{f"{name}_strides": int(of.max()) for name, of in strides.items()},
        }
        least = [float(of.values[at_gait.values].min()) for of in drops]
        plain["largest_drop"] = {
            name: None if math.isnan(drop) else drop for name, drop in zip(strides, least, strict=True)
        }
    return plain


def _axes_given(texts: Sequence[str]) -> dict[str, tuple[float, float]]:
    given = pairs_given(texts, "--axes", "NAME=A:B")
    for name in given:
        if name not in REDUCED:
            raise InputError(
                f"--axes {name}={given[name]}: {name} is not allowed; allowed: {' and '.join(REDUCED)}"
            )
    return {name: ends_of(span, VARIABLES[f"apex.{name}"], f"--axes {name}") for name, span in given.items()}


def _vary_given(texts: Sequence[str]) -> dict[str, tuple[float, ...]]:
    ranges: dict[str, tuple[float, ...]] = {}
    for name, span in pairs_given(texts, "--vary", "NAME=A:B or NAME=A:B:N").items():
        setting_number(name, "--vary")
        first, last, count = range_of(span, VARIABLES[name], f"--vary {name} =", "A:B", "A:B:N")
        ranges[name] = (first, last, *([] if count is None else [count]))
    return ranges


def _text(result: Mapping[str, Any]) -> str:
    rows = {
        "cells": " by ".join(map(str, result["cells"])),
        "actions": str(result["actions"]),
        "strides": f"{result['strides']}, of which {result['closed']} reach another apex",
        "viable": f"{100 * result['inner_share']:.2f} to {100 * result['outer_share']:.2f} % of the cells",
        "viable actions": f"{100 * result['inner_robustness']:.2f} to "
        f"{100 * result['outer_robustness']:.2f} %, mean over all cells",
        "safety factor": f"{result['factor']:g} on the derivatives at the corners of cells",
    }
    if "reached" in result:
        reached, drop = result["reached"], result["largest_drop"]
        rows |= {
            "leads to the gait": f"{100 * reached['inner_share']:.2f} to {100 * reached['outer_share']:.2f} "
            f"% of the cells, in at most {counted(reached['inner_strides'], 'stride')} in the inner set",
            "largest drop": " to ".join("none" if m is None else f"{m:.3g} m" for m in drop.values()),
        }
    return columns(rows)
