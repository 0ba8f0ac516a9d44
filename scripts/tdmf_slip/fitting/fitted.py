"""Runners fitted to measured gaits, by least squares over the errors with exact Jacobians."""

from __future__ import annotations

import contextlib
from collections.abc import Mapping, Sequence
from itertools import islice

import numpy as np

from ..analysis.search import periodic_gait
from ..checks import check_names, checked_flag, checked_whole
from ..errors import InputError, RunError, counted
from ..library.fixed_point import gait_near
from ..library.gait import Gait
from ..library.members import checked_names
from ..library.runner import Runner
from ..library.section import Apex
from ..library.shared_steps import shares_steps
from ..terminal.progress import progress_bar
from ..variables.parameters import RunnerLike
from ..variables.table import Model, full_names, model_of
from .conclusion import concluded
from .measurements import Data, Errors, Units, measurements_of
from .problem import PriorGiven, Problem, Request, checked_priors
from .result import Fit
from .search import Ended, best_from
from .search import starts as starts_of


def profiled_names(profile: object, names: Sequence[str], model: Model) -> tuple[str, ...]:
    """Names of parameters whose intervals are by the profile likelihood."""
    if isinstance(profile, bool | np.bool_):
        return tuple(names) if profile else ()
    allowed = "True, False, or a list of names of varied parameters"
    chosen = full_names(profile, "profile", allowed, model.aliases)
    check_names(chosen, names, "profile")
    return chosen


def check_counts(request: Request) -> None:
    """Refuse names that are both shared and not shared, and more parameters than data."""
    both = next((name for name in request.shared if name in request.each), None)
    if both is not None:
        raise InputError(f"vary and vary_each: {both} is in both; allowed: in one of them")
    if not request.parameters:
        raise InputError("vary: nothing varies; allowed: one parameter or more, shared or for each row")
    if request.degrees_of_freedom < 0:
        measurements, each = request.measurements, len(request.each)
        many = f" and {each} for each of {counted(len(measurements.rows), 'row')}" if each else ""
        raise InputError(
            f"vary: {counted(len(request.parameters), 'parameter')} ({len(request.shared)} shared{many}), "
            f"but {measurements.where} has {measurements.count} measured; allowed: no more than are measured"
        )
    if request.scale_errors and not request.degrees_of_freedom:
        raise InputError(
            "scale_errors: as many numbers are fitted as were measured, so the residuals do not determine "
            "the errors' factor; allowed: more data, or errors that are known"
        )


STARTS, MAX_STARTS = 1, 100


@shares_steps
def fit(
    runner: RunnerLike,
    data: Data,
    vary: Sequence[str] = (),
    *,
    vary_each: Sequence[str] = (),
    units: Units | None = None,
    errors: Errors | None = None,
    priors: Mapping[str, PriorGiven] | None = None,
    guess: Apex | None = None,
    model: str | Model | None = None,
    robust: bool = False,
    scale_errors: bool = False,
    profile: bool | Sequence[str] = True,
    starts: int = STARTS,
    progress: bool = False,
) -> Fit:
    """Fit a runner's parameters to measured gaits, with their confidence intervals.

    SciPy's `least_squares` minimizes the sum of the squared residuals over their errors, with the exact
    derivatives of the gaits. Intervals are of 95 % confidence, by the profile likelihood: a parameter is
    held, all others are fitted again, and the interval ends where the sum of squares has risen by 3.84.
    Errors are known standard errors, unless `scale_errors` is set. A search that has made
    `problem.MAX_STRIDES` strides ends where it is, and a note says so.

    Parameters
    ----------
    runner : as in `find_gait`
    data : DataFrame, mapping of str to sequence of float, str, Path or Measurements
        Measured conditions in rows, each with a gait of its own, and in columns by the names of quantities,
        such as `speed`, and of their standard errors, such as `speed_error`; a CSV file with these titles and
        units, such as `speed [m/s]`; or the name of a file in the package, as `human_running`.
    vary : sequence of str
        Parameters and inputs to fit that all rows share. The search begins at the runner's values.
    vary_each : sequence of str, optional
        Parameters and inputs to fit with a value of their own for each row, such as those that a runner
        changes to run faster.
    units : mapping of str to str, optional
        Units of columns whose title has none, by quantity, such as `{"speed": "km/h"}`. Columns of a
        DataFrame or a mapping are otherwise in the quantity's own unit.
    errors : mapping of str to float, str or sequence of float, optional
        Standard errors of quantities without a column of errors: a number in the unit of the column, one for
        each row, or a share of the value, such as `"2 %"`.
    priors : mapping of str to pair of float, optional
        Prior knowledge: value and standard error of parameters that all rows share, in the unit's units. One
        that is not in `vary` begins with this value and is fitted, too: its uncertainty is in all intervals.
    guess : sequence of float, optional
        An apex near that of the gait with which all rows begin; see `find_gait`. By default the gait that
        the runner settles on, else that near its start values.
    model : as in `find_gait`
    robust : bool, default False
        Use Huber's loss instead of squares, so that an outlier changes little: residuals beyond 1.345
        errors count linearly.
    scale_errors : bool, default False
        Treat the errors as known except for a common factor, and estimate the factor from the residuals.
        Intervals are then scaled by the root of chi square over the degrees of freedom, and use Student's
        quantile.
    profile : bool or sequence of str, default True
        Parameters whose intervals are by the profile likelihood: all, none, or these. Others are linearized.
    starts : int, default 1
        Largest number of fits, from gaits spread over the ranges of what varies; the best one is kept.
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
    >>> data = {"speed": [3.6], "stance_time": [1.4]}
    >>> units, errors = {"speed": "km/h"}, {"speed": "1 %", "stance_time": 0.1}
    >>> found = tdmf_slip.fit(None, data, ["torque", "damping"], units=units, errors=errors)
    >>> [round(residual.fitted, 6) for residual in found.residuals]
    [1.0, 1.4]
    """
    own = model_of(runner, model)
    measurements = measurements_of(data, units, errors, own)
    shared, each = checked_names(vary, "vary", own), checked_names(vary_each, "vary_each", own)
    known = checked_priors(priors, each, own)
    alone = [prior for prior in known if prior.name not in shared]
    begun = Runner(runner, model=model).replace({prior.name: prior.value for prior in alone})
    shared = (*shared, *(prior.name for prior in alone))
    request = Request(
        measurements=measurements,
        shared=shared,
        each=each,
        priors=known,
        robust=checked_flag("robust", robust),
        scale_errors=checked_flag("scale_errors", scale_errors),
        profiled=profiled_names(profile, (*shared, *each), own),
        starts=checked_whole("starts", starts, 1, MAX_STARTS),
    )
    check_counts(request)
    first = _first(begun, guess)
    with progress_bar("fit", None, "strides", progress) as bar:

        def begin(gait: Gait) -> tuple[Problem, Ended]:
            problem = Problem(request, gait, bar.update)
            return problem, best_from(problem, np.zeros(len(problem.parameters)))

        (problem, found), count = begin(first), 1
        others = starts_of(first, request) if request.starts > 1 else iter(())
        for other in islice(others, request.starts - 1):
            count += 1
            with contextlib.suppress(RunError):
                another, ended = begin(other)
                if ended.loss < found.loss:
                    problem, found = another, ended
        return concluded(problem, found, count)


def _first(runner: Runner, guess: Apex | None) -> Gait:
    """Gait with which all rows begin; if no run settles on one, the gait near the start values."""
    try:
        return periodic_gait(runner, guess=guess)
    except RunError as problem:
        if guess is not None:
            raise
        try:
            return gait_near(runner, runner.start_apex())
        except RunError:
            raise problem from None
