"""Branches of gaits along a parameter: followed from a gait both ways, with all that happens on them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from ..checks import checked, checked_flag, checked_whole
from ..errors import InputError, RunError
from ..library.gait import Gait, gaits_dataset
from ..library.members import ranges_varied
from ..library.runner import Runner
from ..library.shared_steps import shares_steps
from ..numerics.following import SHORTEST_STEP as SHORTEST_STEP
from ..numerics.following import Limits, Point, both_ways, follow
from ..record import in_dataset
from ..terminal.progress import progress_bar
from ..variables.parameters import RunnerLike
from ..variables.table import Model
from .branch_problem import BranchProblem, gaits_over
from .search import first_gait
from .special_points import PERIOD_DOUBLING, Special, special_points

if TYPE_CHECKING:
    import xarray

LARGEST_STEP = 1e9
MAX_POINTS = 1_000_000
"""Largest number of gaits that may be asked for."""
BEGINNING = "beginning of the range"
STARTS = 24
"""Values of the range at which a gait to begin with is looked for."""
MAX_STRIDES = 4
"""Strides of the gaits that are followed; of a period doubling of theirs no further branch is followed."""
DEPARTURES = (1e-2, 3e-3, 1e-3, 3e-2)
"""Distances from a period doubling, over the scales, of the first gait of twice the period."""
UNEVEN = 0.5
"""The halves of the first gait lie on both sides of the doubling, two departures apart up to this."""


@dataclass(frozen=True, eq=False, repr=False)
class Branch:
    """Gaits in the order in which they were met along a parameter."""

    name: str
    """Name of the parameter or input."""
    values: tuple[float, ...]
    """Value of the parameter at each gait, in its unit."""
    gaits: tuple[Gait, ...]
    """The gaits."""
    specials: tuple[Special, ...]
    """Bifurcations, word borders, and unclassified points, in the branch's order."""
    began: str
    """Why the branch has no earlier points, in the words of `ended`."""
    ended: str
    """Why the branch stops: at the end of the range, where it began, or in words what happened."""
    strides: int = 1
    """Number of strides after which its gaits repeat themselves."""
    branches: tuple[Branch, ...] = ()
    """Branches of gaits of twice as many strides, from the period doublings."""


def branch_dataset(branch: Branch) -> xarray.Dataset:
    """A branch and the branches of more strides that begin on it as a dataset, see `continue_branch`."""
    branches, name = list(_with_branches(branch)), branch.name
    rows = [(number, *row) for number, of in enumerate(branches) for row in _rows(of)]
    numbers, values, gaits, specials = zip(*rows, strict=True)
    runner, points = branch.gaits[0].runner, {"point": np.arange(len(rows), dtype=float)}
    data = gaits_dataset("branch", gaits, points, varied=[name], over=name)
    apexes = np.full((len(rows), max(of.strides for of in branches), len(runner.coordinates)), np.nan)
    for row, gait in zip(apexes, gaits, strict=True):
        row[: gait.strides] = gait.apexes
    words = [("", "") if of is None or of.words is None else of.words for of in specials]
    texts = {
        "special": ("point", ["" if of is None else of.kind for of in specials]),
        "why": ("point", ["" if of is None else of.why for of in specials]),
        "before": ("point", [before for before, _ in words]),
        "after": ("point", [after for _, after in words]),
        "branch_began": ("branch", [of.began for of in branches]),
        "branch_ended": ("branch", [of.ended for of in branches]),
    }
    variables: dict[str, Any] = {
        "unstable": ("point", [gait.unstable for gait in gaits]),
        "branch_number": ("point", list(numbers)),
        "branch_strides": ("branch", [of.strides for of in branches]),
        "apexes": (("point", "stride", "coordinate"), apexes),
        **{of: (over, np.array(row, dtype=object)) for of, (over, row) in texts.items()},
    }
    labels: dict[str, Any] = {
        name: ("point", np.array(values), runner.model.variables[name].attributes),
        "coordinate": list(runner.coordinates),
    }
    ends = {"began": branch.began, "ended": branch.ended}
    return data.assign(variables).assign_coords(labels).assign_attrs(ends)


def _with_branches(branch: Branch) -> Iterator[Branch]:
    yield branch
    for other in branch.branches:
        yield from _with_branches(other)


def _rows(branch: Branch) -> Iterator[tuple[float, Gait, Special | None]]:
    """Gaits and special points in the branch's order."""
    specials = list(branch.specials)
    for index, (value, gait) in enumerate(zip(branch.values, branch.gaits, strict=True)):
        yield value, gait, None
        while specials and specials[0].index == index:
            special = specials.pop(0)
            yield special.value, special.gait, special


@in_dataset(branch_dataset)
@shares_steps
def continue_branch(
    runner: RunnerLike,
    vary: Mapping[str, tuple[float, float]],
    *,
    model: str | Model | None = None,
    max_step: float = 0.2,
    max_points: int = 1000,
    switch: bool = True,
    progress: bool = False,
) -> Branch:
    """Follow the branch of gaits over a range of a parameter, through folds, and classify its special points.

    The branch begins at the first end of the range with the gait that `find_gait` gives. Where there is
    none, it begins at the first value that has one, and is followed both ways. From a gait whose
    parameter is in the range, the branch is followed both ways, or one way if the gait is at the first end.

    Parameters
    ----------
    runner : as in `find_gait`
    vary : mapping of str to pair of float
        The parameter or input that is varied, and both ends of its range, in its unit.
    model : as in `find_gait`
    max_step : float, default 0.2
        Longest step along the branch, relative to the scales of the apex and of the parameter.
    max_points : int, default 1000
        Largest number of gaits in each direction.
    switch : bool, default True
        Also follow the gaits of two strides from each period doubling, and those of four from theirs.
    progress : bool, default False
        Show a count of gaits on stderr.

    Returns
    -------
    xarray.Dataset
        Over `point`, in the branch's order: the parameter, all quantities of a gait as in a sweep,
        `unstable`, the number of eigenvalues outside the unit circle, and `special`, empty at most points,
        else `fold`, `period doubling`, `Neimark-Sacker`, `word border` or `unclassified`. `why` says why a
        point is unclassified, and `before` and `after` are the words where they change. At a word border or
        an unclassified point the gait is the one just beyond.

        Branches of more strides follow in the same table; `branch_number` is the branch of a point. Over
        `branch`: `branch_strides`, after which its gaits repeat themselves, and why it has no earlier and no
        further points, `branch_began` and `branch_ended`. `apexes` are those of all strides.
        `gait_at(branch.isel(point=...))` is the gait of a point.

    Raises
    ------
    InputError
        No such parameter, a value that is not allowed, or a range without length.
    RunError
        There is no gait in the range.

    Examples
    --------
    >>> import tdmf_slip
    >>> branch = tdmf_slip.continue_branch({}, {"ground.friction": (0.6, 0.2)})
    >>> branch.ended, [str(special) for special in branch["special"].values if special]
    ('end of the range', ['word border', 'word border', 'word border'])
    """
    given, runner = runner, Runner(runner, model=model)
    # A gait of another model than the one that is asked for is not on the branch.
    known = given if isinstance(given, Gait) and given.runner == runner else None
    allowed = "both ends of a range, by the name of one parameter or input"
    ((name, (begin, end)),) = ranges_varied(vary, {1}, allowed, runner.model).items()
    switch = checked_flag("switch", switch)
    max_step = checked("max_step", max_step, SHORTEST_STEP, LARGEST_STEP)
    max_points = checked_whole("max_points", max_points, 1, MAX_POINTS)
    if begin == end:
        raise InputError(f"vary {name}: {begin:g} to {end:g}; allowed: ends that differ")
    with progress_bar("branch", None, "gaits", progress) as bar:
        is_inside = min(begin, end) <= runner[name] <= max(begin, end)
        first = known if known is not None and is_inside else _first_gait(runner, name, begin, end)
        problem = BranchProblem(first.runner, name, first.strides)
        limits = Limits(np.array([min(begin, end)]), np.array([max(begin, end)]), max_step, max_points, begin)
        point = problem.correct(problem.at(first), problem.towards(end - begin))
        branch = whole_branch(problem, point, limits, bar.update)
        if not switch:
            return branch
        return with_doubled_branches(
            branch, lambda n: BranchProblem(first.runner, name, n), limits, bar.update
        )


def _first_gait(runner: Runner, name: str, begin: float, end: float) -> Gait:
    """A gait in a range of a parameter: at its first end, or as near to it as one is found."""
    home = runner[name]
    inside = [home] if min(begin, end) <= home <= max(begin, end) else []
    values = [begin, *inside, *np.linspace(begin, end, STARTS)[1:]]
    number, found, why = first_gait(runner, name, values, range(1 + len(inside)))
    if found is None:
        raise RunError(f"no gait of {name} from {begin:g} to {end:g} was found: {why}")
    return _nearer(found, name, begin) if number == 1 and inside else found


def _nearer(found: Gait, name: str, begin: float) -> Gait:
    """The gait of the same branch at the first end of the range, if the parameter alone leads there."""
    try:
        return next(gaits_over(found.runner, name, [begin], found))
    except RunError:
        return found


def whole_branch(
    problem: BranchProblem, first: Point, limits: Limits, step_finished: Callable[[], object] = lambda: None
) -> Branch:
    """The branch through a point, in its direction, and back from it unless at the range's beginning."""
    points, began, ended = both_ways(problem, first, limits, step_finished)
    began = BEGINNING if not began or began.startswith("back at") else began
    return reported_branch(problem, points, began, ended)


def reported_branch(problem: BranchProblem, points: Sequence[Point], began: str, ended: str) -> Branch:
    """Points as a branch, with all that happens between them."""
    specials = [
        replace(special, index=index)
        for index, (before, after) in enumerate(pairwise(points))
        for special in special_points(problem, before, after)
    ]
    values, gaits = (problem.value(point) for point in points), (point.gait for point in points)
    return Branch(problem.name, tuple(values), tuple(gaits), tuple(specials), began, ended, problem.strides)


def with_doubled_branches(
    branch: Branch,
    problem_of: Callable[[int], BranchProblem],
    limits: Limits,
    step_finished: Callable[[], object] = lambda: None,
) -> Branch:
    """A branch with those of twice the period from its period doublings, each once, and with theirs.

    On such a branch the period may double again: its gaits of four strides are followed likewise. A doubling
    whose gaits are not followed says why.
    """
    strides = 2 * branch.strides
    met: list[float] = []
    found: list[Branch] = []
    specials = list(branch.specials)
    for number, special in enumerate(branch.specials):
        if special.kind != PERIOD_DOUBLING or any(abs(special.value - v) <= 1e-8 * abs(v) for v in met):
            continue
        if strides > MAX_STRIDES:
            specials[number] = replace(special, why=f"gaits of {strides} strides are not followed")
            continue
        problem = problem_of(strides)
        problem.doublings = [other.value for other in branch.specials if other.kind == PERIOD_DOUBLING]
        first = departure(problem, special)
        if first is None:
            specials[number] = replace(special, why=f"no gait of {strides} strides was found beside it")
            continue
        points, ended = follow(problem, first, 1.0, limits, step_finished=step_finished)
        other = reported_branch(problem, points, problem.at_doubling(special.value), ended)
        met += [value for value in problem.doublings if ended == problem.at_doubling(value)]
        found.append(with_doubled_branches(other, problem_of, limits, step_finished))
    return replace(branch, specials=tuple(specials), branches=tuple(found))


def departure(problem: BranchProblem, doubling: Special) -> Point | None:
    """The first gait of twice the period beside a period doubling, in the direction away from it."""
    gait, scales = doubling.gait, problem.scales[:-1]
    eigenvalues, vectors = np.linalg.eig(gait.jacobian)
    vector = vectors[:, np.argmin(np.abs(eigenvalues + 1.0))].real / scales
    way = np.append(vector / np.linalg.norm(vector), 0.0)
    begin = np.append(gait.apex / scales, doubling.value / problem.scales[-1])
    for distance in DEPARTURES:
        try:
            found = problem.correct(begin + distance * way, way)
        except (InputError, RunError):
            continue
        halfway = found.gait.following[problem.strides // 2 - 1]
        apart = float(np.linalg.norm((halfway - found.gait.apex) / scales)) / distance
        if abs(apart - 2.0) < UNEVEN:
            return found
    return None
