"""Branches of gaits along a parameter: followed from a gait both ways, with all that happens on them."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from ..checks import checked, checked_flag, checked_whole, number_of, refusal
from ..errors import InputError, RunError
from ..given import row_of
from ..library.fixed_point import settled_gait
from ..library.gait import Gait, check_is_gait
from ..library.members import varied_alone
from ..library.runner import Runner
from ..library.shared_steps import shares_steps
from ..terminal.progress import progress_bar
from ..variables.parameters import RunnerLike
from ..variables.table import VARIABLES
from ..variables.variable import Given
from .branch import Branch
from .continuation import gaits_over
from .family import Family, Point
from .next_point import SHORTEST_STEP, reverse
from .search import periodic_gait
from .steps import Limits, follow
from .switching import reported_branch, with_doubled_branches

LARGEST_STEP = 1e9
MAX_POINTS = 1_000_000
"""Of a branch."""
BEGINNING = "beginning of the range"
STARTS = 24
"""Values of the range at which a gait to begin with is looked for."""


@shares_steps
def continue_branch(
    runner: RunnerLike,
    vary: Mapping[str, tuple[float, float]],
    *,
    model: str | None = None,
    max_step: float = 0.2,
    max_points: int = 1000,
    switch: bool = True,
    progress: bool = False,
) -> Branch:
    """The branch of gaits over a range of a parameter, through folds, with every special point judged.

    The branch begins at the first end of the range with the gait that `find_gait` gives. Where there is
    none, it begins at the first value that has one, and is followed both ways.

    Parameters
    ----------
    runner : Runner, Gait, mapping of str to float, Series, str or Path, optional
        Whose gaits: a runner, or start values by the unit's names, over the unit's own.
    vary : mapping of str to pair of float
        The parameter or input that is varied, and both ends of its range, in its unit.
    model : str, optional
        `full` or `reduced`, as in `find_gait`.
    max_step : float, default 0.2
        Along the branch, over the coordinates' scales and the parameter's value.
    max_points : int, default 1000
        Stop after so many gaits, in each direction.
    switch : bool, default True
        Follow the gaits of two strides from each period doubling, and those of four from theirs, too.
    progress : bool, default False
        A count of gaits on stderr.

    Returns
    -------
    Branch
        The gaits in their order, with borders and bifurcations, and the branches of more strides.

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
    >>> branch.ended, [special.kind for special in branch.specials]
    ('end of the range', ['word border', 'word border', 'word border'])
    """
    runner = Runner(runner, model=model)
    allowed = "both ends of a range, by the name of one parameter or input"
    name, ends = varied_alone(vary, allowed)
    family, where = Family(runner, name), f"vary {name}"
    row = row_of(ends, where, allowed)
    if len(row) != 2:
        raise refusal(where, ends, allowed)
    begin, end = (float(VARIABLES.find(name, "vary").value_of(value, where)) for value in row)
    switch = checked_flag("switch", switch)
    max_step = checked("max_step", max_step, SHORTEST_STEP, LARGEST_STEP)
    max_points = checked_whole("max_points", max_points, 1, MAX_POINTS)
    if begin == end:
        raise InputError(f"{where}: {begin:g} to {end:g}; allowed: ends that differ")
    with progress_bar("branch", None, "gaits", progress) as bar:

        def tell() -> None:
            bar.update()

        first = first_gait(family.runner, name, begin, end)
        branch = trace(
            runner,
            name,
            first,
            end,
            begin=begin,
            max_step=max_step,
            max_points=max_points,
            step_finished=tell,
        )
        if not switch:
            return branch
        limits = _limits(begin, end, max_step, max_points)
        return with_doubled_branches(branch, lambda n: Family(first.runner, name, n), limits, tell)


def first_gait(runner: Runner, name: str, begin: float, end: float) -> Gait:
    """A gait in a range of a parameter: at its first end, or as near to it as one is found."""
    why: RunError | None = None
    home = runner[name]
    inside = [home] if min(begin, end) <= home <= max(begin, end) else []
    for number, value in enumerate([begin, *inside, *np.linspace(begin, end, STARTS)[1:]]):
        at = runner.replace({name: float(value)})
        try:
            found = periodic_gait(at) if number <= len(inside) else settled_gait(at)
        except RunError as problem:
            why = why or problem
            continue
        return _nearer(found, name, begin) if number == 1 and inside else found
    assert why is not None
    raise RunError(f"no gait of {name} from {begin:g} to {end:g} was found: {why}")


def _nearer(found: Gait, name: str, begin: float) -> Gait:
    """The gait of the same branch at the first end of the range, if the parameter alone leads there."""
    try:
        return next(gaits_over(found.runner, name, [begin], found))
    except RunError:
        return found


def _limits(begin: float, end: float, max_step: float, max_points: int) -> Limits:
    return Limits(min(begin, end), max(begin, end), begin, max_step, max_points)


def trace(
    runner: Runner | Mapping[str, Given],
    name: str,
    first: Gait,
    end: float,
    *,
    begin: float | None = None,
    max_step: float = 0.2,
    max_points: int = 1000,
    step_finished: Callable[[], None] = lambda: None,
) -> Branch:
    """Follow the branch of a gait, through folds, until the parameter leaves the range.

    Pseudo-arclength continuation: each gait is sought on the plane across the branch's tangent. Lengths along
    the branch are measured over the coordinates' scales, and over the first value of the parameter.
    """
    runner = Family(runner, name).runner
    check_is_gait(first, "first")
    max_step = checked("max_step", max_step, SHORTEST_STEP, LARGEST_STEP)
    max_points = checked_whole("max_points", max_points, 1, MAX_POINTS)
    start = first.runner[name]
    begin = start if begin is None else begin
    for what, value in (("begin", begin), ("end", end)):
        if number_of(value) is None:
            raise refusal(f"{what} of {name}", value, "a number")
    if not abs(end - begin) > 0.0 or not min(begin, end) <= start <= max(begin, end):
        raise InputError(
            f"end {end:g} of {name}: allowed: a number other than {begin:g}, and the first gait's "
            f"{start:g} between the two"
        )
    family = Family(runner.replace({name: start}), name, first.strides)
    towards_end = np.append(np.zeros(len(first.apex)), end - begin)
    point = family.point(family.gait(start, first.apex), towards_end)
    return whole_branch(family, point, _limits(begin, end, max_step, max_points), step_finished)


def whole_branch(
    family: Family, first: Point, limits: Limits, step_finished: Callable[[], None] = lambda: None
) -> Branch:
    """The branch through a point, in its direction, and back from it unless at the range's beginning."""
    points, ended = follow(family, first, limits, step_finished)
    began = ended if ended.startswith("closed") and points[-1] is first else BEGINNING
    if began == BEGINNING and first.value != limits.begins_at:
        back, began = follow(family, reverse(first), limits, step_finished, known=points[1:])
        began = BEGINNING if began.startswith("back at") else began
        points = [*map(reverse, back[:0:-1]), *points]
    return reported_branch(family, points, began, ended)
