"""Runners fitted to measured gaits, by least squares over the errors with exact Jacobians."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import islice
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..analysis.search import periodic_gait
from ..checks import checked_flag, checked_whole
from ..errors import InputError, RunError
from ..library.fixed_point import gait_near
from ..library.gait import Gait
from ..library.runner import Runner
from ..library.section import Apex
from ..library.shared_steps import shares_steps
from ..terminal.progress import progress_bar
from ..variables.parameters import RunnerLike
from ..variables.table import VARIABLES
from .across import cross
from .conclusion import Conclusion, is_met
from .kinks import past_kinks
from .measurements import Measurements, measurements_of
from .priors import PriorGiven, checked_priors
from .problem import Problem, bounds_of
from .profile import BetterFitError
from .request import Request
from .result import Fit
from .search import Bounds, Ended, searched
from .starts import starts as starts_of
from .varied_names import check_names, checked_names, profiled_names

STARTS, MAX_STARTS = 1, 100
AGAIN = 3
"""Fits that are begun anew where a profile has led to a better one."""


@shares_steps
def fit(
    runner: RunnerLike,
    data: Measurements | str | Path,
    vary: Sequence[str] = (),
    *,
    vary_each: Sequence[str] = (),
    priors: Mapping[str, PriorGiven] | None = None,
    guess: Apex | None = None,
    model: str | None = None,
    robust: bool = False,
    scale_errors: bool = False,
    profile: bool | Sequence[str] = True,
    starts: int = STARTS,
    progress: bool = False,
) -> Fit:
    """The runner whose gaits are nearest to measured ones, with the confidence of its parameters.

    The sum of the squared residuals over their errors is made least by SciPy's `least_squares`, with the
    exact derivatives of the gaits. Intervals are of 95 % confidence, by the profile likelihood: a parameter
    is held, all others are fitted anew, and the interval ends where the sum of squares has risen by 3.84. The
    errors of the data are taken as known standard errors, unless `scale_errors` says that their ratios alone
    are known. A search that has made `problem.MAX_STRIDES` strides ends where it is, and a note says so.

    Parameters
    ----------
    runner : Runner, Gait, mapping of str to float, Series, str or Path, optional
        What does not vary: a runner, or start values by the unit's names and in its units, over the unit's
        own.
    data : Measurements, str or Path
        What was measured, a CSV file, see `read_measurements`, or the name of one that comes with the
        package, as `human_running`. Each row is a condition with a gait of its own.
    vary : sequence of str
        Names of parameters and inputs to be found, of which all rows share one value. They begin with the
        values that the runner has.
    vary_each : sequence of str, optional
        Names of those of which each row has its own value, as what a runner changes to run faster.
    priors : mapping of str to pair of float, optional
        What is known beside the data: value and standard error of parameters that all rows share, in the
        unit's units. One that is not among `vary` is an assumed constant: it begins with this value, is
        fitted, too, and so its uncertainty is in all intervals.
    guess : sequence of float, optional
        An apex near that of the gait that all rows begin with; see `find_gait`. By default the gait that
        the runner settles on, else that near its start values.
    model : str, optional
        `full` or `reduced`, as in `find_gait`.
    robust : bool, default False
        Huber's loss instead of squares: residuals beyond 1.345 errors count by their size alone, so that a
        datum that is far off changes little.
    scale_errors : bool, default False
        The errors are known but for a common factor, which is told by the residuals: intervals are wider by
        the root of chi square over the degrees of freedom, and by Student's quantile.
    profile : bool or sequence of str, default True
        Whether intervals are by the profile likelihood; or of which parameters, by name. Others have linear
        ones, which are those of the normal distribution.
    starts : int, default 1
        How many fits are made at the most, from gaits all over what varies, of which the best counts.
    progress : bool, default False
        A count of strides on stderr.

    Returns
    -------
    Fit
        Parameters with their intervals, combinations that cannot be identified, residuals, and notes: of
        words that changed and gaits that were lost on the way, and of residuals too large for their errors.

    Raises
    ------
    InputError
        The data are no such table, a name is unknown or given twice, or more varies than was measured.
    RunError
        There is no gait to begin with, or a gait has no derivatives.

    Examples
    --------
    >>> import tdmf_slip
    >>> from tdmf_slip.fitting.measurements import Measured, Measurements
    >>> row = {"speed": Measured(1.0, 0.01)}
    >>> found = tdmf_slip.fit(None, Measurements((row,), "one gait"), ["hip.stance_torque"])
    >>> round(found.residuals[0].fitted, 6)
    1.0
    """
    measurements = measurements_of(data)
    shared, each = checked_names(vary, "vary"), checked_names(vary_each, "vary_each")
    known = checked_priors(priors, each)
    alone = [prior for prior in known if prior.name not in shared]
    begun = Runner(runner, model=model).replace({prior.name: prior.value for prior in alone})
    shared = (*shared, *(prior.name for prior in alone))
    check_names(shared, each, measurements, len(known))
    profiled = profiled_names(profile, (*shared, *each))
    request = Request(
        measurements=measurements,
        shared=shared,
        each=each,
        priors=known,
        robust=checked_flag("robust", robust),
        scale_errors=checked_flag("scale_errors", scale_errors),
        profiled=profiled,
        starts=checked_whole("starts", starts, 1, MAX_STARTS),
        ranges={name: (VARIABLES[name].minimum, VARIABLES[name].maximum) for name in (*shared, *each)},
    )
    if request.scale_errors and request.degrees_of_freedom < 1:
        raise InputError(
            "scale_errors: as many numbers are fitted as were measured, and no residual tells the errors' "
            "factor; allowed: more data, or errors that are known"
        )
    first = _first(begun, guess)
    with progress_bar("fit", None, "strides", progress) as bar:
        others = starts_of(first, measurements, (*shared, *each)) if request.starts > 1 else iter(())
        return fitted_from(request, first, islice(others, request.starts - 1), bar.update)


def _first(runner: Runner, guess: Apex | None) -> Gait:
    """The gait that all rows begin with; where nothing settles on it, the one near the start values."""
    try:
        return periodic_gait(runner, guess=guess)
    except RunError as problem:
        if guess is not None:
            raise
        try:
            return gait_near(runner, runner.start_apex())
        except RunError:
            raise problem from None


def fitted_from(
    request: Request, first: Gait, others: Iterator[Gait], strides_made: Callable[[int], object]
) -> Fit:
    """The best fit from some gaits."""
    best, count = _begun(request, first, strides_made), 1
    for other in others:
        count += 1
        try:
            tried = _begun(request, other, strides_made)
        except RunError:
            continue
        best = tried if tried[1].loss < best[1].loss else best
    return _reported(request, *best, count)


def _begun(request: Request, first: Gait, strides_made: Callable[[int], object]) -> tuple[Problem, Ended]:
    """A search from one gait."""
    problem = Problem(first, request.measurements, request.shared, request.each, strides_made, request.priors)
    return problem, _found(request, problem, np.zeros(len(problem.parameters)))


def summarize(request: Request, problem: Problem, begin: NDArray[np.float64]) -> Fit:
    """The fit from gaits that a problem has."""
    return _reported(request, problem, _found(request, problem, begin), 1)


def _reported(request: Request, problem: Problem, found: Ended, starts: int) -> Fit:
    """With intervals; begun anew where a profile has led to a better fit."""
    for _ in range(AGAIN):
        try:
            return Conclusion(request, problem, found, starts).fit()
        except BetterFitError as better:
            found = _found(request, problem, better.at)
    return Conclusion(replace(request, profiled=()), problem, found, starts).fit()


def _found(request: Request, problem: Problem, begin: NDArray[np.float64]) -> Ended:
    """By a search and, where it is not met, across the folds near it."""
    bounds = bounds_of(problem, request.ranges)
    found = searched(problem, begin, bounds, request.robust)
    if problem.log.lost and not problem.is_spent and not is_met(found.loss, request):
        found = _crossed(request, problem, found, bounds)
    if not problem.is_spent and np.isfinite(found.loss):
        found = past_kinks(problem, found, bounds, request.robust)
    return found


def _crossed(request: Request, problem: Problem, ended: Ended, bounds: Bounds) -> Ended:
    """The better of a search that has ended and of one that goes on across the folds near it."""
    apexes = problem.apexes()
    begin = cross(problem, ended.at, bounds)
    if begin is not None:
        found = searched(problem, begin, bounds, request.robust)
        if found.loss < ended.loss:
            problem.log.crossed = True
            return found
        problem.restart(ended.at, apexes)
    return ended
