"""Gaits over a range of parameters, and the borders between gait words."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import Executor
from functools import partial
from itertools import pairwise, product
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..blocks import check_executor
from ..checks import check_size, refusal
from ..errors import InputError, RunError, TdmfSlipError, counted
from ..files.resume import Resumed
from ..files.whole import check_destination
from ..library.gait import Gait, first_runner_in, gaits_dataset
from ..library.members import check_has_gaits, check_varied
from ..library.runner import Runner
from ..library.shared_steps import shares_steps
from ..library.strides import BETWEEN_WORDS, strides_from
from ..numerics.following import Point
from ..record import dataset
from ..terminal.in_blocks import in_blocks
from ..terminal.progress import progress_bar
from ..variables.parameters import RunnerLike
from ..variables.table import FRICTION, Model, by_full_name, model_recorded
from ..variables.variable import Given, Values
from .along import points_over
from .gait_problem import BranchProblem
from .search import first_gait
from .special_points import border_between, crossings

if TYPE_CHECKING:
    import xarray

MAX_GAITS, MAX_GAITS_OF_ROW = 1_000_000, 100_000
"""Largest numbers of gaits in a sweep and in one of its rows; each gait takes 400 bytes."""
HAVE_GAITS = ("sweep", "branch", "comparison", "front", "gait")
"""Kinds of datasets of which single gaits are given."""
NAMES = "values by the names of parameters or inputs"
"""Names that `vary` accepts."""


class Sweep(NamedTuple):
    """Gaits over a grid, and the borders between their words."""

    gaits: xarray.Dataset
    """Quantities, apex, eigenvalues and word of each gait, over the varied names in the order asked for."""
    borders: xarray.Dataset
    """Values of the varied names where the word changes, and the words `before` and `after` in the order of
    the range, over `border`."""

    def __repr__(self) -> str:
        """The varied names, and the numbers of gaits and borders, in one line."""
        words = self.gaits["word"]
        found, gaits = int((words != "").sum()), counted(words.size, "gait")
        names, borders = ", ".join(map(str, words.dims)), counted(self.borders.sizes["border"], "border")
        missed = "" if found == words.size else f"{found:,} of "
        return f"<Sweep over {names}: {missed}{gaits}, {borders}>"

    def _repr_html_(self) -> str:
        """Both datasets as boxes for a notebook, with their attributes folded."""
        import xarray

        with xarray.set_options(display_expand_attrs=False):
            boxes = {"gaits": self.gaits._repr_html_(), "borders": self.borders._repr_html_()}
        return "".join(f"<p><b>{name}</b></p>{box}" for name, box in boxes.items())


def sweep(
    runner: RunnerLike,
    vary: Mapping[str, Values],
    *,
    model: str | Model | None = None,
    path: Path | str | None = None,
    executor: Executor | None = None,
    progress: bool = False,
) -> Sweep:
    """Find the gait at each point of a grid over any number of names, and every change of the gait word.

    Gaits are followed along one of the names, each from the one before: along the friction if it varies, else
    along the last name. Where the first values have no gait, a row begins at the first that has one, and
    follows its branch back as far as it goes. Where a branch cannot be followed on, because of a fold or
    because the gait is lost, the row goes on with the next gait that is found, on another branch.

    Parameters
    ----------
    runner : as in `find_gait`
    vary : mapping of str to sequence of float
        Parameters or inputs that are varied, and their values in order; friction has to be above 0.
    model : as in `find_gait`
    path : Path or str, optional
        NetCDF file for the gaits, with the borders in its group `borders`. Rows that are done are kept in a
        folder beside it, so that a job that stopped is resumed by the same call.
    executor : concurrent.futures.Executor, optional
        Runs the rows, such as a `ProcessPoolExecutor()` or `client.get_executor()` of Dask; by default
        threads of this process. The result does not depend on the executor.
    progress : bool, default False
        A bar on stderr.

    Returns
    -------
    Sweep
        The gaits as a dataset over the names, NaN where there is no gait, and the borders as a second one.
        `branch` numbers the branches of each row. `began` and `ended` say at the first and the last gait of
        a branch why it has none before and after, and `problem` why gaits of a row are missing.

    Raises
    ------
    InputError
        A value is refused, there is no such parameter, or the file holds another result.
    RunError
        There is no gait anywhere; the message is about the first point. A file says why at each point.

    Examples
    --------
    >>> import tdmf_slip
    >>> gaits, borders = tdmf_slip.sweep(None, {"friction": [0.7, 0.6, 0.45, 0.43]})
    >>> print(gaits["word"].values)
    ['+0-0+' '+0-0+' '+0-' '+0-']
    >>> print(borders["ground.friction"].values.round(6), borders["after"].values)
    [0.496682 0.496679] ['+0-+' '+0-']
    >>> tdmf_slip.gait_at(gaits, friction=0.6).stable
    True
    """
    check_executor(executor)
    runner = Runner(runner, model=model)
    axes = checked_axes(vary, runner.model)
    along = FRICTION if FRICTION in axes else list(axes)[-1]
    others = {name: values for name, values in axes.items() if name != along}
    rows = [dict(zip(others, map(float, values), strict=True)) for values in product(*others.values())]
    for row in rows:
        check_values(runner.replace(row), along, axes[along][: None if row is rows[0] else 1])
    path = None if path is None else check_destination(path, (".nc",), "path")
    made = Resumed(path, _blank(runner, axes, along), "sweep", working=("borders",))
    if made.is_whole:
        return Sweep(made.data, made.group("borders"))
    places = [
        dict(zip(others, place, strict=True)) for place in product(*(range(len(v)) for v in others.values()))
    ]
    missing = [number for number, place in enumerate(places) if place not in made.done]
    blocks = [runner.replace(rows[number]) for number in missing]
    values = tuple(axes[along])
    if len(places) == 1:
        for block in blocks:
            with progress_bar("sweep", len(values), "gaits", progress) as bar:
                made.write({}, _row(block, along, values, bar.update))
    else:
        work, done = partial(columns_of_row, along, values), len(rows) - len(missing)
        with in_blocks(work, blocks, "sweep", "rows", executor, progress, done=done) as results:
            for number, columns in results:
                made.write(places[missing[number]], columns)
    found = Sweep(made.data.drop_vars("borders"), _borders_dataset(runner, made.data, along))
    made.finish(found.gaits, {"borders": found.borders})
    words = found.gaits["word"]
    if not (words != "").any():
        raise RunError(f"{found.gaits['problem'].values.flat[0]}; gaits found: 0 of {words.size}")
    return found


def gait_at(gaits: xarray.Dataset, **where: Given) -> Gait:
    """A gait of a sweep, a branch, a comparison or a front, with its Jacobian, events and quantities.

    Parameters
    ----------
    gaits : xarray.Dataset
        Gaits of such a result, or one point of it, as `gaits.isel(...)` gives it.
    **where : float or str
        Values of the varied names, as in `friction=0.6`; names with a point go in a mapping, as in
        `**{"leg.damping": 0.2}`.

    Returns
    -------
    Gait
        One stride from the gait's apex.

    Raises
    ------
    InputError
        The values do not name one point, there is no gait, or the dataset has no gaits.

    Examples
    --------
    >>> import tdmf_slip
    >>> gaits = tdmf_slip.sweep(None, {"friction": [0.7, 0.6]}).gaits
    >>> tdmf_slip.gait_at(gaits, friction=0.6).word
    '+0-0+'
    """
    attributes = getattr(gaits, "attrs", {})
    model = model_recorded(attributes)
    needed = ["word", *(f"apex_{name}" for name in model.coordinates)]
    kind = attributes.get("result")
    if kind not in HAVE_GAITS or any(name not in gaits for name in needed):
        allowed = f"a dataset of gaits ({', '.join(HAVE_GAITS)}), with all its variables and attributes"
        raise refusal("gaits", gaits, allowed)
    wanted = by_full_name(where, "gait_at", "values by the names of the sweep", model.aliases)
    point = gaits
    for name, given in wanted.items():
        if name not in gaits.dims:
            raise InputError(f"gait_at: {name} does not vary; give {', '.join(map(str, gaits['word'].dims))}")
        value = model.variables[name].value_of(given, "gait_at")
        (index,) = np.nonzero(np.isclose(gaits[name], value, rtol=1e-9, atol=0.0))
        if not len(index):
            raise InputError(f"gait_at: {name} = {value:g} is not in the {kind}; give one of its values")
        point = point.isel({name: int(index[0])})
    if point["word"].ndim:
        raise InputError(f"gait_at: give a value of {', '.join(map(str, point['word'].dims))}, too")
    if not point["word"].item():
        raise InputError(f"gait_at: the {kind} has no gait there")
    (found,) = gaits_in(point)
    return found


def gaits_in(gaits: xarray.Dataset) -> list[Gait]:
    """All gaits of a dataset, in its order."""
    model = model_recorded(gaits.attrs)
    words, over = gaits["word"], gaits["word"].dims
    varied = [str(name) for name in gaits.coords if name in model.variables]
    columns = {name: gaits[name].broadcast_like(words).transpose(*over).values.ravel() for name in varied}
    apices = np.array([gaits[f"apex_{name}"].values.ravel() for name in model.coordinates]).T
    runner = first_runner_in(gaits)
    return [
        strides_from(
            runner.replace({name: float(column[number]) for name, column in columns.items()}),
            apices[number],
            word.count(BETWEEN_WORDS) + 1,
        )
        for number, word in enumerate(map(str, words.values.ravel()))
        if word
    ]


def checked_axes(vary: object, model: Model) -> dict[str, NDArray[np.float64]]:
    """Values by the names of what varies."""
    given = by_full_name(vary, "vary", NAMES, model.aliases)
    if not given:
        raise InputError(f"vary: nothing; allowed: {NAMES}")
    for name in given:
        if len(given) == 1 or name not in model.states:
            check_varied(name, "vary", model)
    axes = {name: model.variables[name].values_of(row, f"vary {name}") for name, row in given.items()}
    shape = [len(values) for values in axes.values()]
    check_size("vary", max(shape), "gaits in a row", MAX_GAITS_OF_ROW)
    check_size(f"vary: {' by '.join(map(str, shape))}", math.prod(shape), "gaits", MAX_GAITS)
    return axes


def _blank(runner: Runner, axes: Mapping[str, NDArray[np.float64]], along: str) -> xarray.Dataset:
    """A sweep before any row is done; `borders` of a row are JSON until all rows are done."""
    shape, over = [len(values) for values in axes.values()], tuple(axes)
    others = [name for name in over if name != along]
    texts = np.full([len(axes[name]) for name in others], "", dtype=object)
    nothing = [None] * math.prod(shape)
    data = gaits_dataset("sweep", nothing, axes, runner, along=along)
    if runner.reduced:
        data = data.isel(mode=slice(len(runner.coordinates)))
    return data.assign(
        branch=(over, np.full(shape, np.nan), {"long_name": "number of the branch in its row"}),
        began=(over, np.full(shape, "", dtype=object)),
        ended=(over, np.full(shape, "", dtype=object)),
        problem=(others, texts),
        borders=(others, texts.copy()),
    )


def _borders_dataset(runner: Runner, data: xarray.Dataset, along: str) -> xarray.Dataset:
    """Borders of all rows, row by row."""
    names, texts = [*map(str, data["word"].dims)], data["borders"]
    rows: list[dict[str, Any]] = []
    for place in np.ndindex(texts.shape):
        where = {str(name): float(texts[name][k]) for name, k in zip(texts.dims, place, strict=True)}
        for value, before, after in json.loads(str(texts.values[place]) or "[]"):
            rows.append({**where, along: value, "before": before, "after": after})
    columns: dict[str, Any] = {
        name: ("border", np.array([row[name] for row in rows], float if name in names else object))
        for name in (*names, "before", "after")
    }
    return dataset("borders", runner.record(*names), columns, {}, along=along)


def columns_of_row(along: str, values: Values, runner: Runner) -> dict[str, Any]:
    """Arrays of a row of a sweep by the names of its variables: a block of work."""
    try:
        return _row(runner, along, values)
    except TdmfSlipError as problem:  # also start values that go with other rows only
        return {"problem": str(problem)}


@shares_steps
def _row(
    runner: Runner, name: str, values: Values, step_finished: Callable[[int], object] = lambda _: None
) -> dict[str, Any]:
    """Arrays of a row: its branches one after the other, each with its gaits and borders."""
    problem = BranchProblem(runner, name)
    gaits: list[Gait | None] = [None] * len(values)
    branches, problems, borders = np.full(len(values), np.nan), [], list[tuple[float, str, str]]()
    began, ended = (np.full(len(values), "", dtype=object) for _ in range(2))
    end = number = 0
    while end < len(values):
        # A branch that comes from outside of the range is met at its ends.
        thorough = {0, len(values) - 1} if end == 0 else ()
        skipped, first, why = first_gait(runner, name, values[end:], thorough)
        step_finished(skipped)
        start = end + skipped
        if first is None:
            problems.append(why)
            break
        point = problem.start(first, problem.towards(1.0))
        back, why_not_before = _followed(problem, point, values[end:start][::-1], step_finished)
        forth, why_not_after = _followed(problem, point, values[start:], step_finished)
        branch = [*back[::-1], *forth]
        problems += [why, why_not_before] if len(back) < skipped else []
        problems += [why_not_after]
        end = start + len(forth)
        here = slice(end - len(branch), end)
        gaits[here], branches[here] = [one.gait for one in branch], number
        number += 1
        began[here.start], ended[end - 1] = why_not_before, why_not_after
        for pair in pairwise(branch):
            try:
                borders += [*_borders(problem, *pair)]
            except TdmfSlipError as met:
                problems.append(str(met))
    if not any(gaits):
        raise RunError("; ".join([*problems[:1], *["nor is there any further on"] * (len(values) > 1)]))
    data = gaits_dataset("sweep", gaits, {name: np.asarray(values)})
    return {
        **{str(name): array.values for name, array in data.data_vars.items()},
        **{"branch": branches, "began": began, "ended": ended},
        "problem": "; ".join(dict.fromkeys(filter(None, problems))),
        "borders": json.dumps(borders),
    }


def _followed(
    problem: BranchProblem, point: Point, values: Values, step_finished: Callable[[int], object]
) -> tuple[list[Point], str]:
    """Points at values in turn, as far as the branch leads, and the reason why it leads no farther."""
    found: list[Point] = []
    try:
        for following in points_over(problem, point, values):
            found.append(following)
            step_finished(1)
    except TdmfSlipError as why:
        return found, str(why)
    return found, ""


def _borders(problem: BranchProblem, first: Point, last: Point) -> Iterator[tuple[float, str, str]]:
    """Changes of the word between two points of a branch: value, word before, word after."""
    way = last.x - first.x
    for short, beyond in crossings(problem, first.along(way), last.along(way)):
        yield border_between(problem, short, beyond), short.gait.word, beyond.gait.word


def check_values(runner: Runner, name: str, values: Values) -> None:
    """Refuse too many values, and values at which there can be no gait, before any work."""
    check_size(f"vary {name}", len(values), "gaits", MAX_GAITS_OF_ROW)
    for value in values:
        check_has_gaits(runner.replace({name: value}))
