"""Runners fitted to measured gaits, by least squares over the errors with exact Jacobians."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..analysis.search import find_orbit, runner_by
from ..errors import InputError, RunError
from ..given import row_of
from ..library.members import check_varied
from ..library.orbit import Orbit, orbit_near
from ..library.runner import Runner
from ..library.section import Apex
from ..terminal import progress
from ..unit.unit import Unit, load
from ..unit.variable import Given
from .across import cross
from .identifiability import identified
from .measurements import Measurements, measurements_of
from .problem import FIRST_STEP, MOST_STRIDES, Problem, bounds_of
from .result import QUANTILE, UNLIKELY, Estimate, Fit, Residual

MOST_STEPS = 200
"""Tries of the search."""
CHANGE = 1e-9
"""Of the sum of squares, of the unknowns, and of the slope: where the search ends."""


def fit(
    data: Measurements | str | Path,
    free: Sequence[str],
    *,
    free_each: Sequence[str] = (),
    runner: Runner | Mapping[str, Given] | None = None,
    guess: Apex | None = None,
    model: str | None = None,
    show_progress: bool = False,
    unit: Unit | None = None,
) -> Fit:
    """The runner whose gaits are nearest to measured ones, with the confidence of its parameters.

    The sum of the squared residuals over their errors is made least by SciPy's `least_squares`, with the
    exact derivatives of the gaits. Intervals are of 95 % confidence, linear in the parameters, and of the
    normal distribution: the errors of the data are taken as known standard errors, and are not scaled to the
    residuals. A search that has made `problem.MOST_STRIDES` strides ends where it is, and a note says so.

    Parameters
    ----------
    data : Measurements, str or Path
        What was measured, a CSV file, see `read_measurements`, or the name of one that comes with the
        package, as `human_running`. Each row is a condition with a gait of its own.
    free : sequence of str
        Names of parameters and inputs to be found, of which all rows share one value. They begin with the
        values that the runner has.
    free_each : sequence of str, optional
        Names of those of which each row has its own value, as what a runner changes to run faster.
    runner : Runner or mapping of str to float, optional
        What is not free: a runner, or start values by the unit's names and in its units, over the unit's own.
    guess : sequence of float, optional
        An apex near that of the gait that all rows begin with; see `find_orbit`. By default the gait that
        the runner settles on, else that near its start values.
    model : str, optional
        `full` or `reduced`, as in `find_orbit`.
    show_progress : bool, default False
        A count of strides on stderr.
    unit : Unit, optional
        Whose start values and ranges hold; by default that of `fmu_path`.

    Returns
    -------
    Fit
        Parameters with their intervals, combinations that the data do not tell, residuals, and notes: of
        words that changed and gaits that were lost on the way, and of residuals too large for their errors.

    Raises
    ------
    InputError
        The data are no such table, a name is unknown or given twice, or more is free than was measured.
    RunError
        There is no gait to begin with, or a gait has no derivatives.

    Examples
    --------
    >>> import tdmf_slip
    >>> from tdmf_slip.fitting.measurements import Measured, Measurements
    >>> row = {"speed": Measured(1.0, 0.01)}
    >>> found = tdmf_slip.fit(Measurements((row,), "one gait"), ["hip.stance_torque"])
    >>> round(found.residuals[0].fitted, 6)
    1.0
    """
    measurements = measurements_of(data)
    shared, each = _checked_names(free, "free"), _checked_names(free_each, "free_each")
    _check_names(shared, each, measurements)
    first = _first(runner_by(Runner.of(runner, unit), model), guess, unit)
    variables = load(unit).variables
    ranges = {name: (variables[name].minimum, variables[name].maximum) for name in (*shared, *each)}
    with progress.bar("fit", None, "strides", show_progress) as bar:
        problem = Problem(first, measurements, shared, each, bar.update)
        bounds = bounds_of(problem, ranges)
        found = _searched(problem, np.zeros(len(problem.parameters)), bounds)
        if problem.happenings.lost and not problem.is_spent and not _is_met(found, measurements.count):
            found = _crossed(problem, found, bounds)
        return _fit_of(problem, measurements, found)


def _first(runner: Runner, guess: Apex | None, unit: Unit | None) -> Orbit:
    """The gait that all rows begin with; where nothing settles on it, the one near the start values.

    Raises
    ------
    RunError
        There is neither.
    """
    try:
        return find_orbit(runner, guess, unit=unit)
    except RunError as problem:
        if guess is not None:
            raise
        try:
            return orbit_near(runner, runner.start_apex())
        except RunError:
            raise problem from None


def _searched(
    problem: Problem,
    begin: NDArray[np.float64],
    bounds: tuple[NDArray[np.float64], NDArray[np.float64]],
) -> Any:
    """What SciPy finds."""
    from scipy.optimize import least_squares  # slow to load

    return least_squares(
        problem.residuals,
        begin,
        problem.jacobian,
        bounds=bounds,
        method="trf",
        x_scale=1.0,
        ftol=CHANGE,
        xtol=CHANGE,
        gtol=CHANGE,
        max_nfev=MOST_STEPS,
    )


def _is_met(found: Any, count: int) -> bool:
    """Whether the residuals are such as come by chance."""
    probability = _probability(2.0 * found.cost, count - len(found.x))
    return bool(2.0 * found.cost < 1.0 if np.isnan(probability) else probability >= UNLIKELY)


def _crossed(problem: Problem, ended: Any, bounds: tuple[NDArray[np.float64], NDArray[np.float64]]) -> Any:
    """The better of a search that has ended and of one that goes on across the folds near it."""
    apexes = problem.apexes()
    begin = cross(problem, ended.x, bounds)
    if begin is not None:
        found = _searched(problem, begin, bounds)
        if found.cost < ended.cost:
            problem.happenings.crossed = True
            return found
        problem.restart(ended.x, apexes)
    return ended


def _checked_names(given: object, what: str) -> tuple[str, ...]:
    """Names of parameters, each once."""
    names = tuple(row_of(given, what, "a list of names of parameters and inputs"))
    for name in names:
        check_varied(name, what)
        if names.count(name) > 1:
            raise InputError(f"{what}: {name} is given twice; allowed: once")
    return names


def _check_names(shared: Sequence[str], each: Sequence[str], measurements: Measurements) -> None:
    """Refuse names that are shared and not, and more of them than data."""
    both = next((name for name in shared if name in each), None)
    if both is not None:
        raise InputError(f"free and free_each: {both} is in both; allowed: in one of them")
    rows = len(measurements.rows)
    wanted = len(shared) + rows * len(each)
    if not wanted:
        raise InputError("free: nothing is free; allowed: one parameter or more, shared or for each row")
    if wanted > measurements.count:
        many = f" and {len(each)} for each of {rows} rows" if each else ""
        raise InputError(
            f"free: {wanted} parameters ({len(shared)} shared{many}), but {measurements.where} has "
            f"{measurements.count} measured; allowed: no more than are measured"
        )


def _fit_of(problem: Problem, measurements: Measurements, found: Any) -> Fit:
    """The result at the unknowns that were found."""
    values = problem.values(found.x)
    jacobian = found.jac if problem.is_linear_at(found.x) else problem.jacobian(found.x)
    labels = [parameter.label for parameter in problem.parameters]
    known = identified(jacobian / FIRST_STEP, labels, problem.scales, QUANTILE)
    covariance = known.covariance * np.outer(problem.scales, problem.scales)
    spreads = np.where(known.told, np.sqrt(np.diag(covariance)), np.inf)
    residuals = _residuals(measurements, found.fun)
    probability = _probability(float(found.fun @ found.fun), len(residuals) - len(labels))
    return Fit(
        measurements=measurements,
        runners=tuple(problem.runner_of(values, row) for row in range(len(measurements.rows))),
        apexes=tuple(problem.apexes()),
        words=tuple(problem.words()),
        estimates=tuple(
            Estimate(parameter.label, parameter.name, float(value), float(spread))
            for parameter, value, spread in zip(problem.parameters, values, spreads, strict=True)
        ),
        covariance=covariance,
        unidentified=known.unidentified,
        residuals=residuals,
        probability=probability,
        converged=bool(found.status > 0 and not problem.is_spent),
        steps=int(found.nfev),
        notes=tuple(_notes(problem, found, probability)),
    )


def _residuals(measurements: Measurements, over_errors: NDArray[np.float64]) -> tuple[Residual, ...]:
    measured = [
        (number, name, of)
        for number, row in enumerate(measurements.rows, start=1)
        for name, of in row.items()
    ]
    return tuple(
        Residual(number, name, of.value, of.error, of.value + float(off) * of.error)
        for (number, name, of), off in zip(measured, over_errors, strict=True)
    )


def _probability(chi_square: float, degrees_of_freedom: int) -> float:
    """That the chi square distribution exceeds it."""
    from scipy.special import gammaincc  # slow to load

    if degrees_of_freedom == 0:
        return float("nan")
    return float(gammaincc(0.5 * degrees_of_freedom, 0.5 * chi_square))


def _notes(problem: Problem, found: Any, probability: float) -> list[str]:
    """What happened, and what the fit should be read with."""
    notes = []
    if problem.is_spent:
        notes.append(
            f"the search was ended after {problem.happenings.strides:,} strides ({MOST_STRIDES:,} are "
            "allowed): its values are not the best ones; are the data in the units that their titles say?"
        )
    if found.status <= 0:
        notes.append(f"the search has not ended after {found.nfev} tries: its values are not the best ones")
    if np.isnan(probability) and 2.0 * found.cost > 1.0:
        notes.append("the data are not met, though as many numbers are fitted as were measured")
    if probability < UNLIKELY:
        notes.append(
            f"residuals as large as these come by chance with a probability of {probability:.1g}: the model "
            "is farther from the data than their errors, and the intervals are too narrow"
        )
    notes += [
        f"{parameter.label} is at the {'lower' if side < 0 else 'upper'} end of its range: its interval "
        "does not hold"
        for parameter, side in zip(problem.parameters, found.active_mask, strict=True)
        if side
    ]
    notes += [
        f"the word of row {row} changed on the way: {', '.join(words)}"
        for row, words in enumerate(problem.happenings.words, start=1)
        if len(words) > 1
    ]
    if problem.happenings.lost:
        tries = f"{problem.happenings.lost} of the tries"
        notes.append(f"{tries} led where a row has no gait, and were made shorter")
    if problem.happenings.crossed:
        notes.append("the search went on across a fold, where gaits turn back")
    return notes
