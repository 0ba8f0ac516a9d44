"""Gaits over a range of parameters, and the borders between gait words."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import partial
from itertools import pairwise, product
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..blocks import run_blocks
from ..checks import check_size, refusal
from ..errors import InputError, RunError, TdmfSlipError
from ..files.resume import Resumed
from ..files.whole import check_destination
from ..library.gait import Gait, gaits_dataset
from ..library.members import check_has_gaits, check_varied
from ..library.runner import Runner
from ..library.shared_steps import shares_steps
from ..library.strides import BETWEEN_WORDS, strides_from
from ..numerics.following import Limits, Point, follow
from ..record import dataset, runner_in
from ..terminal.progress import progress_bar
from ..variables.parameters import RunnerLike
from ..variables.table import FRICTION, Model, by_full_name, model_named
from ..variables.variable import Given, Values
from .branch_problem import BranchProblem, gaits_over
from .search import first_gait
from .special_points import FOLD, Border, borders_between, special_points

if TYPE_CHECKING:
    import xarray

MAX_GAITS, MAX_GAITS_OF_ROW = 1_000_000, 100_000
"""Largest numbers of gaits in a sweep and in one of its rows; each gait takes 400 bytes."""
LARGEST_STEP = 0.2
"""Longest step along a branch that is followed to learn why it ends, over the scales."""
MAX_POINTS = 200
"""Largest number of its gaits."""
HAVE_GAITS = ("sweep", "branch", "comparison", "front", "gait")
"""Kinds of datasets of which single gaits are given."""
NAMES = "values by the names of parameters or inputs"
"""Names that `vary` accepts."""


@dataclass(frozen=True)
class Segment:
    """Part of a range: values whose gaits are of one branch."""

    begin: int
    """Number of the first value."""
    end: int
    """Number after that of the last value."""
    began: str
    """Why the branch has no gait at the value before; empty at the beginning of the range."""
    ended: str
    """Why it has none at the next; empty at the end of the range."""

    def as_json(self, values: Sequence[float]) -> dict[str, object]:
        """The segment as a plain object; the values are those of the range."""
        ends = {"from": values[self.begin], "to": values[self.end - 1]}
        return {**ends, "began": self.began or None, "ended": self.ended or None}


@dataclass(frozen=True, eq=False)
class Row:
    """Gaits at the values of one parameter, where they were found."""

    name: str
    """Name of the parameter or input."""
    values: tuple[float, ...]
    """Values of the parameter."""
    by_value: tuple[Gait | None, ...]
    """Gaits by value; None where there is none, or it was not found."""
    borders: tuple[Border, ...]
    """Changes of the word along a branch, in the order of the range."""
    segments: tuple[Segment, ...]
    """Parts of the range in its order, each with gaits of one branch and why that branch ends."""
    problem: str | None
    """Why gaits are missing, and what kept a border from being located; or None."""

    @property
    def branches(self) -> list[float]:
        """Number of the segment of each value; NaN where there is no gait."""
        numbers = [np.nan] * len(self.values)
        for number, segment in enumerate(self.segments):
            numbers[segment.begin : segment.end] = [float(number)] * (segment.end - segment.begin)
        return numbers

    @property
    def gaits(self) -> tuple[Gait, ...]:
        """The gaits that were found, in the order of the range."""
        return tuple(gait for gait in self.by_value if gait is not None)

    def as_json(self) -> dict[str, object]:
        """The sweep as a plain object; `missing` are the values without a gait."""
        found = zip(self.values, self.by_value, strict=True)
        return {
            **self.gaits[0].runner.record(self.name),
            "over": self.name,
            "gaits": [gait.as_json() | {"value": value} for value, gait in found if gait is not None],
            "transitions": [border.as_json(short(self.name)) for border in self.borders],
            "branches": [segment.as_json(self.values) for segment in self.segments],
            "missing": [v for v, gait in zip(self.values, self.by_value, strict=True) if gait is None],
            "problem": self.problem,
        }


def short(name: str) -> str:
    """How results name a parameter: the friction by that word alone."""
    return "friction" if name == FRICTION else name


class Sweep(NamedTuple):
    """Gaits over a grid, and the borders between their words."""

    gaits: xarray.Dataset
    """Quantities, apex, eigenvalues and word of each gait, over the varied names in the order asked for."""
    borders: xarray.Dataset
    """Values of the varied names where the word changes, and the words `before` and `after` in the order of
    the range, over `border`."""

    def _repr_html_(self) -> str:
        """Both datasets as boxes for a notebook."""
        return f"gaits{self.gaits._repr_html_()}borders{self.borders._repr_html_()}"


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
        `branch` numbers the branches of each row, and `problem` says why gaits of a row are missing.

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
            made.write({}, _columns(sweep_row(block, along, values, progress)))
    else:
        with (
            progress_bar("sweep", len(rows), "rows", progress) as bar,
            run_blocks(partial(columns_of_row, along, values), blocks, executor) as results,
        ):
            bar.update(len(rows) - len(missing))
            for number, columns in results:
                made.write(places[missing[number]], columns)
                bar.update()
    found = Sweep(made.data.drop_vars("borders"), _borders_dataset(runner, made.data, along))
    made.finish(found.gaits, {"borders": found.borders})
    words = found.gaits["word"]
    if not (words != "").any():
        raise RunError(f"{found.gaits['problem'].values.flat[0]}; 0 of {words.size} gaits were found")
    return found


def sweep_of_row(runner: Runner, row: Row) -> Sweep:
    """A row as a sweep over its name."""
    made = Resumed(None, _blank(runner, {row.name: np.array(row.values)}, row.name), "sweep")
    made.write({}, _columns(row))
    return Sweep(made.data.drop_vars("borders"), _borders_dataset(runner, made.data, row.name))


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
    model = model_named(attributes.get("model", "full"))
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
    strides = point["word"].item().count(BETWEEN_WORDS) + 1
    values = {str(name): point[name].item() for name in point.coords if name in model.variables}
    apex = [point[f"apex_{name}"].item() for name in model.coordinates]
    return strides_from(Runner({**runner_in(gaits), **values}, model=model), apex, strides)


def checked_axes(vary: object, model: Model) -> dict[str, NDArray[np.float64]]:
    """Values by the names of what varies."""
    given = by_full_name(vary, "vary", NAMES, model.aliases)
    if not given:
        raise InputError(f"vary: nothing; allowed: {NAMES}")
    for name in given:
        if len(given) == 1 or name not in model.states:
            check_varied(name, "vary", model)
    axes = {name: model.variables[name].values_of(of, f"vary {name}") for name, of in given.items()}
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
        problem=(others, texts),
        borders=(others, texts.copy()),
    )


def columns_of_row(along: str, values: tuple[float, ...], runner: Runner) -> dict[str, Any]:
    """Arrays of a row of a sweep by the names of its variables: a block of work."""
    try:
        return _columns(sweep_row(runner, along, values))
    except TdmfSlipError as problem:  # also start values that go with other rows only
        return {"problem": str(problem)}


def _columns(row: Row) -> dict[str, Any]:
    data = gaits_dataset("sweep", row.by_value, {row.name: np.array(row.values)})
    borders = [[border.value, border.before, border.after] for border in row.borders]
    return {
        **{str(name): array.values for name, array in data.data_vars.items()},
        "branch": row.branches,
        "problem": row.problem or "",
        "borders": json.dumps(borders),
    }


def _borders_dataset(runner: Runner, data: xarray.Dataset, along: str) -> xarray.Dataset:
    """Borders of all rows, row by row."""
    rows = list(_borders_by_row(data["borders"]))
    names = [*map(str, data["word"].dims)]
    columns: dict[str, Any] = {
        name: ("border", np.array([where.get(name, value) for where, (value, _, _) in rows], float))
        for name in names
    }
    for number, name in ((1, "before"), (2, "after")):
        columns[name] = "border", np.array([border[number] for _, border in rows], dtype=object)
    return dataset("borders", runner.record(*names), columns, {}, along=along)


def _borders_by_row(texts: xarray.DataArray) -> Iterator[tuple[dict[str, float], Any]]:
    for place in np.ndindex(texts.shape):
        where = {str(name): float(texts[name][k]) for name, k in zip(texts.dims, place, strict=True)}
        yield from ((where, border) for border in json.loads(str(texts.values[place]) or "[]"))


@shares_steps
def sweep_row(runner: Runner, name: str, values: Values, progress: bool = False) -> Row:
    """Gaits along one name, at values that are checked already."""
    gaits: list[Gait | None] = [None] * len(values)
    borders: list[Border] = []
    problems: list[str] = []
    segments: list[Segment] = []
    end = 0
    with progress_bar("sweep", len(values), "gaits", progress) as bar:
        while end < len(values):
            # A branch that comes from outside of the range is met at its ends.
            thorough = {0, len(values) - 1} if end == 0 else ()
            skipped, first, why = first_gait(runner, name, values[end:], thorough)
            bar.update(skipped)
            begin = end + skipped
            if first is None:
                problems.append(why)
                break
            preceding, began = followed(runner, name, values[end:begin][::-1], first, bar.update)
            following, ended = followed(runner, name, values[begin:], first, bar.update)
            branch = [*preceding[::-1], *following]
            problems += [why, *began] if end < begin - len(preceding) else []
            problems += ended
            end = begin + len(following)
            gaits[end - len(branch) : end] = branch
            segments.append(Segment(end - len(branch), end, "; ".join(began), "; ".join(ended)))
            found, unknown = _borders(runner, name, branch)
            borders += found
            problems += unknown
    if not any(gaits):
        raise RunError("; ".join([*problems[:1], *["nor is there any further on"] * (len(values) > 1)]))
    return Row(
        name,
        tuple(float(value) for value in values),
        tuple(gaits),
        tuple(borders),
        tuple(segments),
        "; ".join(dict.fromkeys(problems)) or None,
    )


def _borders(runner: Runner, name: str, gaits: Sequence[Gait]) -> tuple[list[Border], list[str]]:
    """All changes of the word, and why some are missing."""
    borders: list[Border] = []
    problems: list[str] = []
    for before, after in pairwise(gaits):
        try:
            borders += borders_between(runner, name, before, after) if before.word != after.word else []
        except RunError as problem:
            problems.append(str(problem))
    return borders, problems


def followed(
    runner: Runner,
    name: str,
    values: Values,
    first: Gait,
    step_finished: Callable[[], object] = lambda: None,
) -> tuple[list[Gait], list[str]]:
    """Gaits at values in turn from one on, as far as the branch could be followed, and what stopped it."""
    found: list[Gait] = []
    while len(found) < len(values):
        last = found[-1] if found else first
        try:
            for gait in gaits_over(runner, name, values[len(found) :], last):
                found.append(gait)
                step_finished()
        except RunError as problem:
            last = found[-1] if found else first
            reached, why = _beyond(BranchProblem(runner, name), last, float(values[len(found)]))
            if reached is None:
                return found, [why or str(problem)]
            found.append(reached)
            step_finished()
    return found, []


def _beyond(problem: BranchProblem, last: Gait, value: float) -> tuple[Gait | None, str]:
    """The gait at a value where the branch leads there, by steps along it; else why it does not."""
    at = last.runner[problem.name]
    back = 2.0 * at - value
    ends = np.array([[value, back]])
    limits = Limits(ends.min(axis=1), ends.max(axis=1), LARGEST_STEP, MAX_POINTS, back)
    try:
        points, ended = follow(problem, problem.start(last, problem.towards(value - at)), 1.0, limits)
    except (InputError, RunError):
        return None, ""
    fold = _fold(problem, points)
    if fold is not None:
        return None, f"the branch ends in a fold at {problem.name} = {fold:.10g}"
    if problem.value(points[-1]) == value:
        return points[-1].gait, ""
    return None, f"the branch ends at {problem.name} = {problem.value(points[-1]):.10g}: {ended}"


def _fold(problem: BranchProblem, points: Sequence[Point]) -> float | None:
    """Value of the parameter at which the branch turns back first."""
    for before, after in pairwise(points):
        if before.rises != after.rises:
            folds = [
                special.value for special in special_points(problem, before, after) if special.kind == FOLD
            ]
            return folds[0] if folds else 0.5 * (problem.value(before) + problem.value(after))
    return None


def check_values(runner: Runner, name: str, values: Values) -> None:
    """Refuse, before any work, too many values and those at which there is no gait to follow."""
    check_size(f"vary {name}", len(values), "gaits", MAX_GAITS_OF_ROW)
    for value in values:
        check_has_gaits(runner.replace({name: value}))
