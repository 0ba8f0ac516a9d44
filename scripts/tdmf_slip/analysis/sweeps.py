"""Gaits over a range of a parameter, and the borders between gait words."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..drawable import Drawable
from ..errors import InputError, RunError
from ..given import mapping_of
from ..library.fixed_point import settled_gait
from ..library.gait import Gait
from ..library.members import check_has_gaits, varied_alone
from ..library.runner import Runner
from ..library.shared_steps import shares_steps
from ..numerics.following import Limits, Point, follow
from ..record import attributes_of
from ..terminal.progress import Bar, progress_bar
from ..variables.parameters import RunnerLike
from ..variables.table import FRICTION, VARIABLES
from ..variables.variable import Values
from .branch_problem import BranchProblem, gaits_over
from .grid_result import GaitGrid
from .search import periodic_gait
from .special_points import FOLD, Border, borders_between, special_points

if TYPE_CHECKING:
    import xarray

MAX_GAITS = 100_000
"""Of a sweep that is on no file: each takes 10 kB."""
LARGEST_STEP = 0.2
"""Longest step along a branch that is followed to learn why it ends, over the scales."""
MAX_POINTS = 200
"""Largest number of its gaits."""
NAMES = "values by the name of one parameter or input, or of two"
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
        """As a plain object; the values are those of the range."""
        ends = {"from": values[self.begin], "to": values[self.end - 1]}
        return {**ends, "began": self.began or None, "ended": self.ended or None}


@dataclass(frozen=True, eq=False, repr=False)
class Sweep(Drawable):
    """Gaits at the values of a range, where they were found."""

    name: str
    """Of the parameter or input."""
    values: tuple[float, ...]
    """The range."""
    by_value: tuple[Gait | None, ...]
    """At each value; None where there is none, or it was not found."""
    borders: tuple[Border, ...]
    """Where the word changes along a branch, in the order of the range."""
    segments: tuple[Segment, ...]
    """Of the range, in its order, the gaits of each on one branch; and why it ends."""
    problem: str | None
    """Why gaits are missing, and what kept a border from being located; or None."""

    def __repr__(self) -> str:
        """In a line: how many gaits, from where to where, and their words."""
        words = ", ".join(dict.fromkeys(gait.word for gait in self.gaits))
        ends = f"{self.values[0]:.6g} to {self.values[-1]:.6g}"
        return f"<Sweep {len(self.gaits)} of {len(self.values)} gaits, {self.name} {ends}: {words}>"

    def to_xarray(self) -> xarray.Dataset:
        """Quantities of the gaits over the parameter, with units.

        Returns
        -------
        xarray.Dataset
            As `grid.as_dataset` gives it, and `branch`, the number of the stretch.
        """
        from .grid import as_dataset  # xarray is slow to load

        data = as_dataset(self.by_value, {self.name: np.array(self.values)})
        data["branch"] = (self.name,), self.branches
        data.attrs = attributes_of(self.gaits[0].runner.record(self.name))
        return data

    @property
    def branches(self) -> list[float]:
        """By value of the range, the number of its stretch; NaN where there is no gait."""
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


def sweep(
    runner: RunnerLike,
    vary: Mapping[str, Values],
    *,
    model: str | None = None,
    path: Path | str | None = None,
    executor: Executor | None = None,
    progress: bool = False,
) -> Any:
    """The gait at each value of a parameter, each from the one before, and every change of the gait word.

    Where the first values have no gait, the sweep begins at the first that has one, and follows its branch
    back as far as it goes; where a branch cannot be followed on, because of a fold or as the gait is lost,
    the sweep goes on with the next gait that is found, which is of another branch. `segments` and `problem`
    say what happened. Changes of the word from one branch to another are no borders.

    Parameters
    ----------
    runner : Runner, Gait, mapping of str to float, Series, str or Path, optional
        Parameters and start, or start values by name; the value of what is varied does not matter.
    vary : mapping of str to sequence of float
        The parameter or input that is varied, and its values in order; of the friction, above 0. With two of
        them a grid, whose rows go along the friction or else along the second.
    model : str, optional
        `full` or `reduced`, as in `find_gait`.
    path : Path or str, optional
        Of a grid: the NetCDF file that it is written to row by row, and gone on with where it has some.
    executor : concurrent.futures.Executor, optional
        Runs the rows of a grid, such as a `ProcessPoolExecutor()` or `client.get_executor()` of Dask; by
        default threads of this process. The result does not depend on the executor.
    progress : bool, default False
        A bar on stderr.

    Returns
    -------
    Sweep or GaitGrid
        The gaits, and the borders between their words; of a grid, arrays over both names, and of each row
        `problem`, empty where all its gaits were found. It needs the extra `data`.

    Raises
    ------
    InputError
        A value is refused, or there is no such parameter.
    RunError
        There is no gait at any of them; the message tells of the first.

    Examples
    --------
    >>> import tdmf_slip
    >>> gaits = tdmf_slip.sweep({}, {"ground.friction": [0.7, 0.6, 0.45, 0.43]})
    >>> print([gait.word for gait in gaits.gaits])
    ['+0-0+', '+0-0+', '+0-', '+0-']
    """
    runner = Runner(runner, model=model)
    vary = mapping_of(vary, "vary", NAMES)
    if len(vary) == 2:
        from .grid import grid_over  # xarray is slow to load

        where = {"executor": executor, "progress": progress}
        return GaitGrid.of_dataset(grid_over(runner, vary, path, **where))
    if path is not None or executor is not None:
        raise InputError("path and executor are for a grid over two names; this sweep varies one")
    name, values = varied_alone(vary, NAMES)
    row = VARIABLES.find(name, "vary").values_of(values, f"vary {name}")
    if len(row) > MAX_GAITS:
        raise InputError(f"vary {name}: {len(row):,} values; allowed: {MAX_GAITS:,}, or a grid, on file")
    check_values(runner, name, row)
    return sweep_row(runner, name, row, progress)


@shares_steps
def sweep_row(runner: Runner, name: str, values: Values, progress: bool = False) -> Sweep:
    """`sweep` over values that are checked already."""
    gaits: list[Gait | None] = [None] * len(values)
    borders: list[Border] = []
    problems: list[str] = []
    segments: list[Segment] = []
    end = 0
    with progress_bar("sweep", len(values), "gaits", progress) as bar:

        def tell() -> None:
            bar.update()

        while end < len(values):
            begin, first, why = _begin(runner, name, values, end, bar)
            if first is None:
                problems += why
                break
            preceding, began = followed(runner, name, values[end:begin][::-1], first, tell)
            following, ended = followed(runner, name, values[begin:], first, tell)
            branch = [*preceding[::-1], *following]
            problems += [*why, *began] if end < begin - len(preceding) else []
            problems += ended
            end = begin + len(following)
            gaits[end - len(branch) : end] = branch
            segments.append(Segment(end - len(branch), end, "; ".join(began), "; ".join(ended)))
            found, unknown = _borders(runner, name, branch)
            borders += found
            problems += unknown
    if not any(gaits):
        raise RunError("; ".join([*problems[:1], *["nor is there any further on"] * (len(values) > 1)]))
    return Sweep(
        name,
        tuple(float(value) for value in values),
        tuple(gaits),
        tuple(borders),
        tuple(segments),
        "; ".join(dict.fromkeys(problems)) or None,
    )


def _begin(
    runner: Runner, name: str, values: Values, start: int, bar: Bar
) -> tuple[int, Gait | None, list[str]]:
    """Number of a value with a gait, the first from `start` on; that gait; why the one at `start` is none.

    While there is none yet, the longer search is made at both ends of the range: a branch that comes from
    outside is met there.
    """
    why: list[str] = []
    for number in range(start, len(values)):
        search = periodic_gait if start == 0 and number in (0, len(values) - 1) else settled_gait
        try:
            return number, search(runner.replace({name: values[number]})), why
        except RunError as problem:
            why = why or [str(problem)]
            bar.update()
    return len(values), None, why


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
    step_finished: Callable[[], None] = lambda: None,
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
    """Refuse, before any work, values at which there is no gait to follow."""
    for value in values:
        check_has_gaits(runner.replace({name: value})[FRICTION])
