"""Branches of gaits along a parameter, followed both ways from a gait, with their special points."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..checks import checked, checked_flag, checked_whole
from ..errors import InputError, RunError
from ..library.gait import Gait, gaits_dataset
from ..library.members import ranges_varied
from ..library.runner import Runner
from ..library.shared_steps import shares_steps
from ..numerics.following import SHORTEST_STEP as SHORTEST_STEP
from ..numerics.following import Limits, Point, both_ways, follow
from ..terminal.progress import progress_bar
from ..variables.parameters import RunnerLike
from ..variables.table import Model
from .along import gaits_over
from .gait_problem import BranchProblem
from .search import first_gait
from .special_points import PERIOD_DOUBLING, Special, special_points

if TYPE_CHECKING:
    import xarray

LARGEST_STEP = 1e9
MAX_POINTS = 1_000_000
"""Largest number of gaits that may be asked for."""
BEGINNING = "beginning of the range"
STARTS = 24
"""Number of values of the range at which a first gait is searched for."""
MAX_STRIDES = 4
"""Largest number of strides of a gait that is followed."""
DEPARTURES = (1e-2, 3e-3, 1e-3, 3e-2)
"""Distances from a period doubling, over the scales, of the first gait of twice the period."""
SAME_DOUBLING = 1e-8
"""Relative distance of period doublings that count as one."""
UNEVEN = 0.5
"""Largest deviation of the distance between the two halves of the first gait from two departures."""


class Row(NamedTuple):
    """A point of a branch: a gait, or a special point between two gaits."""

    value: float
    """Value of the parameter, in its unit."""
    gait: Gait
    """Gait at the value."""
    special: Special | None
    """Special point at the value; None at a gait of the curve followed."""


class Branch(NamedTuple):
    """Gaits along a parameter, with the special points between them."""

    rows: list[Row]
    """Gaits and special points in the branch's order."""
    began: str
    """Reason why there are no earlier gaits, in the words of `ended`."""
    ended: str
    """Reason why the branch stops, such as the end of the range or the loss of the gait."""
    strides: int
    """Number of strides after which the gaits repeat themselves."""


def _dataset(name: str, branches: Sequence[Branch]) -> xarray.Dataset:
    """A branch and those of more strides that begin on it, see `continue_branch`."""
    rows = [row for branch in branches for row in branch.rows]
    _, gaits, specials = zip(*rows, strict=True)
    runner, points = gaits[0].runner, {"point": np.arange(len(rows), dtype=float)}
    data = gaits_dataset("branch", gaits, points, varied=[name], over=name)
    apexes = np.full((len(rows), max(branch.strides for branch in branches), len(runner.coordinates)), np.nan)
    for apex, gait in zip(apexes, gaits, strict=True):
        apex[: gait.strides] = gait.apexes
    nothing = Special("", np.nan, gaits[0], (np.nan, np.nan))
    found = [special or nothing for special in specials]
    texts = {
        "special": ("point", [special.kind for special in found]),
        "why": ("point", [special.why for special in found]),
        "before": ("point", [special.words[0] for special in found]),
        "after": ("point", [special.words[1] for special in found]),
        "branch_began": ("branch", [branch.began for branch in branches]),
        "branch_ended": ("branch", [branch.ended for branch in branches]),
    }
    lengths = [len(branch.rows) for branch in branches]
    variables: dict[str, Any] = {
        "unstable": ("point", [gait.unstable for gait in gaits]),
        "between": (("point", "end"), [special.between for special in found]),
        "branch_number": ("point", np.repeat(np.arange(len(branches)), lengths)),
        "branch_strides": ("branch", [branch.strides for branch in branches]),
        "apexes": (("point", "stride", "coordinate"), apexes),
        **{text: (over, np.array(row, dtype=object)) for text, (over, row) in texts.items()},
    }
    labels = {"coordinate": list(runner.coordinates)}
    ends = {"began": branches[0].began, "ended": branches[0].ended}
    return data.assign(variables).assign_coords(labels).assign_attrs(ends)


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
) -> xarray.Dataset:
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
        point is unclassified, and `between` has the values of the gaits on both sides. `before` and `after`
        are the words where they change. At a word border or an unclassified point, the parameter and the
        quantities are those of the gait just beyond.

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
    # A gait of another model is not on the branch.
    known = given if isinstance(given, Gait) and given.runner == runner else None
    allowed = "both ends of a range, by the name of one parameter or input"
    ((name, (begin, end)),) = ranges_varied(vary, {1}, allowed, runner.model).items()
    switch = checked_flag("switch", switch)
    max_step = checked("max_step", max_step, SHORTEST_STEP, LARGEST_STEP)
    max_points = checked_whole("max_points", max_points, 1, MAX_POINTS)
    if begin == end:
        raise InputError(f"vary {name}: {begin:g} to {end:g}; allowed: ends that differ")
    limits = Limits(np.array([min(begin, end)]), np.array([max(begin, end)]), max_step, max_points, begin)
    with progress_bar("branch", None, "gaits", progress) as bar:
        first = known if known is not None and limits.low <= runner[name] <= limits.high else None
        first = first or first_in_range(runner, name, begin, end)
        branch = branch_through(first, name, begin, end, limits, bar.update)
        branches = [branch]
        if switch:
            branches = with_doubled_branches(
                branch, lambda n: BranchProblem(first.runner, name, n), limits, bar.update
            )
    return _dataset(name, branches)


def first_in_range(runner: Runner, name: str, begin: float, end: float) -> Gait:
    """A gait in a range of a parameter: at its first end, or as near to it as one is found."""
    home = runner[name]
    inside = [home] if min(begin, end) <= home <= max(begin, end) else []
    values = [begin, *inside, *np.linspace(begin, end, STARTS)[1:]]
    number, found, why = first_gait(runner, name, values, range(1 + len(inside)))
    if found is None:
        raise RunError(f"no gait of {name} from {begin:g} to {end:g} was found: {why}")
    if number == 1 and inside:
        with contextlib.suppress(RunError):  # where the branch does not lead to the first end
            return next(gaits_over(found.runner, name, [begin], found))
    return found


def branch_through(
    first: Gait,
    name: str,
    begin: float,
    end: float,
    limits: Limits,
    step_finished: Callable[[], object] = lambda: None,
) -> Branch:
    """The branch through a gait, from one end of a range of a parameter to the other."""
    problem = BranchProblem(first.runner, name, first.strides)
    point = problem.correct(problem.at(first), problem.towards(end - begin))
    return whole_branch(problem, point, limits, step_finished)


def whole_branch(
    problem: BranchProblem, first: Point, limits: Limits, step_finished: Callable[[], object] = lambda: None
) -> Branch:
    """The branch through a point, in its direction, and back from it unless at the range's beginning."""
    points, began, ended = both_ways(problem, first, limits, step_finished)
    began = BEGINNING if not began or began.startswith("back at") else began
    return _reported(problem, points, began, ended)


def _reported(problem: BranchProblem, points: Sequence[Point], began: str, ended: str) -> Branch:
    """The branch of points, with the special points between them."""
    rows = [Row(problem.value(points[0]), points[0].gait, None)]
    for before, after in pairwise(points):
        found = special_points(problem, before, after)
        rows += [Row(special.value, special.gait, special) for special in found]
        rows.append(Row(problem.value(after), after.gait, None))
    return Branch(rows, began, ended, problem.strides)


def with_doubled_branches(
    branch: Branch,
    problem_of: Callable[[int], BranchProblem],
    limits: Limits,
    step_finished: Callable[[], object] = lambda: None,
) -> list[Branch]:
    """A branch, and the branches of twice the period from its period doublings, each followed once.

    A doubled branch stands before those from its own period doublings. A doubling whose gaits are not
    followed keeps the reason.
    """
    strides, found = 2 * branch.strides, list[Branch]()
    met: list[float] = []
    doublings = [row.value for row in branch.rows if row.special and row.special.kind == PERIOD_DOUBLING]
    for number, (value, gait, special) in enumerate(branch.rows):
        if special is None or special.kind != PERIOD_DOUBLING:
            continue
        if any(abs(value - other) <= SAME_DOUBLING * abs(other) for other in met):
            continue
        first, why = None, f"gaits of {strides} strides are not followed"
        if strides <= MAX_STRIDES:
            problem = problem_of(strides)
            problem.doublings = doublings
            first, why = departure(problem, special), f"no gait of {strides} strides was found beside it"
        if first is None:
            branch.rows[number] = Row(value, gait, special._replace(why=why))
            continue
        points, ended = follow(problem, first, 1.0, limits, step_finished=step_finished)
        met += [other for other in doublings if ended == problem.at_doubling(other)]
        doubled = _reported(problem, points, problem.at_doubling(value), ended)
        found += with_doubled_branches(doubled, problem_of, limits, step_finished)
    return [branch, *found]


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
