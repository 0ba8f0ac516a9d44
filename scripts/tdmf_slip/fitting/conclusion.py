"""Results of a search: estimates with their intervals, and notes.

Intervals are by the profile likelihood. A parameter is held, the others are fitted again, and the loss
rises. The interval ends where the loss has risen by the quantile of chi square with one degree of freedom
(Venzon and Moolgavkar 1988, Applied Statistics 37, 87-94). If the data identify the parameter well, this is
the linear interval. If they identify it poorly, the interval is not symmetric, and may have no end.
"""

import contextlib
from collections.abc import Iterator
from typing import TypeAlias

import numpy as np

from ..errors import RunError, counted
from ..numerics.newton import Vector
from .measurements import Measured
from .problem import FIRST_STEP, MAX_STRIDES, Problem
from .result import (
    CONFIDENCE,
    QUANTILE,
    UNLIKELY,
    Estimate,
    Fit,
    Identified,
    Residual,
    identified,
    probability_of,
)
from .search import Ended, across_folds, best_from, is_stationary, searched, weights_of

AGAIN = 3
"""Largest number of fits that restart because a profile has led to a better one."""
FAR_OFF = 1e4
"""Chi square over the number of data above which no fit counts as converged: residuals of 100 errors each."""


def concluded(problem: Problem, found: Ended, starts: int = 1) -> Fit:
    """Fit at the end of a search, which restarts if a profile has led to a better fit."""
    for _ in range(AGAIN):
        try:
            return _fit(problem, found, starts, is_profiled=True)
        except BetterFitError as better:
            found = best_from(problem, better.at)
    return _fit(problem, found, starts, is_profiled=False)


def _fit(problem: Problem, found: Ended, starts: int, *, is_profiled: bool) -> Fit:
    request, spent_strides = problem.request, problem.strides if problem.is_spent else 0
    problem.grant()
    jacobian, residuals = problem.jacobian(found.at), problem.residuals(found.at)
    apexes, words = tuple(problem.apexes), tuple(problem.words)
    chi_square = float(residuals @ residuals)
    converged = bool(
        found.ended
        and not spent_strides
        and chi_square <= FAR_OFF * len(residuals)
        and (found.on_border or is_stationary(found, jacobian, request.robust))
    )
    scale, quantile = 1.0, QUANTILE
    if request.scale_errors:
        from scipy.special import stdtrit  # slow to load

        scale = float(np.sqrt(chi_square / request.degrees_of_freedom))
        quantile = scale * float(stdtrit(request.degrees_of_freedom, 0.5 + 0.5 * CONFIDENCE))
    values, parameters = problem.values(found.at), problem.parameters
    weighted = weights_of(residuals, request.robust)[:, None] * jacobian
    known = identified(weighted / FIRST_STEP, [of.label for of in parameters], problem.scales, QUANTILE)
    covariance = scale**2 * known.covariance * np.outer(problem.scales, problem.scales)
    spreads = np.where(known.reported, np.sqrt(np.diag(covariance)), np.inf)
    notes = [*_notes(problem, found, spent_strides, converged, chi_square, scale)]
    intervals: Intervals = {}
    if is_profiled and converged:
        intervals, further = _profile(problem, found, known, quantile)
        notes += further
    half, estimates = quantile / scale, []
    for k, (of, value, spread) in enumerate(zip(parameters, values.tolist(), spreads.tolist(), strict=True)):
        linear = value - half * spread, value + half * spread, ""
        low, high, ends_at = intervals.get(k, linear)
        estimates.append(Estimate(of.label, of.name, value, spread, low, high, k in intervals, ends_at))
    measured: list[tuple[int, str, Measured]] = [
        (n, *item) for n, row in enumerate(problem.rows, start=1) for item in row.items()
    ]
    measured += [(0, prior.name, prior) for prior in request.priors]
    beside = tuple(
        Residual(row, name, of.value, of.error, of.value + off * of.error)
        for (row, name, of), off in zip(measured, residuals.tolist(), strict=True)
    )
    count = request.measurements.count
    return Fit(
        request=request,
        runners=tuple(problem.runner_of(values, row) for row in range(len(problem.rows))),
        apexes=apexes,
        words=words,
        estimates=tuple(estimates),
        covariance=covariance,
        unidentified=known.unidentified,
        residuals=beside[:count],
        priors=beside[count:],
        converged=converged,
        steps=found.tries,
        starts=starts,
        notes=tuple(notes),
    )


def _notes(
    problem: Problem, found: Ended, spent_strides: int, converged: bool, chi_square: float, scale: float
) -> Iterator[str]:
    """Notes on the search and on how to read the fit."""
    request = problem.request
    probability = probability_of(chi_square, request.degrees_of_freedom)
    if spent_strides:
        yield (
            f"the search was ended after {counted(spent_strides, 'stride')} ({MAX_STRIDES:,} are "
            "allowed): its values are not the best ones; are the data in the units that their titles say?"
        )
    if not found.ended:
        yield f"the search has not ended after {found.tries} tries: its values are not the best ones"
    elif not spent_strides and not converged:
        yield (
            "the search ended where the sum of squares is not least, or is far too large: its values and "
            "intervals mean nothing; begin elsewhere, with other values or more starts"
        )
    if np.isnan(probability) and chi_square > 1.0:
        yield "the data are not met, though as many numbers are fitted as were measured"
    if probability < UNLIKELY and not request.scale_errors:
        yield (
            f"residuals as large as these come by chance with a probability of {probability:.1g}: "
            "the model is farther from the data than their errors, and the intervals are too narrow"
        )
    if request.scale_errors:
        yield f"the errors are taken {scale:.3g} times as large as the data say"
    for parameter, bound in zip(problem.parameters, found.at_bound, strict=True):
        if bound:
            yield f"{parameter.label} is at the {'lower' if bound < 0 else 'upper'} end of its range"
    for row, words in enumerate(problem.seen_words, start=1):
        if len(words) > 1:
            yield f"the word of row {row} changed on the way: {', '.join(words)}"
    if found.on_border:
        yield "the sum of squares is least on a border between words, where it has a kink"
    if problem.lost:
        yield f"{problem.lost} of the tries led where a row has no gait, and were made shorter"
    if problem.crossed:
        yield "the search went on across a fold, where gaits turn back"


Intervals: TypeAlias = dict[int, tuple[float, float, str]]
"""Both ends of the intervals in the parameters' units, and why they end there, by the parameters' numbers."""


def _profile(
    problem: Problem, best: Ended, known: Identified, quantile: float
) -> tuple[Intervals, list[str]]:
    """Intervals by the profile likelihood, and notes on them."""
    problem.grant()
    profile, intervals, notes, linear = Profile(problem, best, known.covariance, quantile), {}, [], []
    for k, of in enumerate(problem.parameters):
        if of.name not in problem.request.profiled or not known.reported[k]:
            continue
        try:
            ends = None if problem.is_spent else profile.interval(k)
        except RunError:
            ends = None
        if ends is None or problem.is_spent:
            linear.append(of.label)
            continue
        low, high = (float(problem.begin[k] + problem.steps[k] * at) for at, _ in ends)
        intervals[k] = low, high, ", ".join(dict.fromkeys(why for _, why in ends if why))
        if any(why == "gaits" for _, why in ends):
            notes.append(f"the interval of {of.label} ends where no gaits are found")
    if linear:
        notes.append(f"the profile likelihood was not followed: linear intervals of {', '.join(linear)}")
    return intervals, notes


MET = 0.02
"""Relative error of the root of the rise at which the interval's end is interpolated."""
TRIES = 14
"""Largest number of tries to find an end."""
LONGEST, FARTHEST = 5.0, 40.0
"""First step of an unknown, and largest distance of an end, in tenths of the unknown's scale."""
CHANGE = 1e-4
"""Change of the loss at which a search with a held parameter ends."""
BETTER = 1e-3
"""Fall of the loss below that of the best fit, relative to it, at which a better fit is reported."""

End: TypeAlias = tuple[float, str]
"""One end of an interval: the unknown, infinite if there is no end, and why it ends early.

The reason is `range` or `gaits`, or an empty text if the loss has risen enough."""


class BetterFitError(Exception):
    """The loss with a parameter held is less than that of the best fit."""

    def __init__(self, at: Vector) -> None:
        """Keep the unknowns at which the loss is less."""
        super().__init__("the loss is less elsewhere")
        self.at = at


class Profile:
    """Profile likelihood of a fit."""

    def __init__(self, problem: Problem, best: Ended, covariance: Vector, root: float) -> None:
        """Begin at the best fit, with its linear covariance and the root of the rise at an interval's end."""
        self.problem, self.best, self.root = problem, best, root
        self.covariance = covariance / FIRST_STEP**2
        self._apexes = problem.apexes

    def interval(self, number: int) -> tuple[End, End]:
        """Both ends of a parameter's interval; raises `BetterFitError` if the loss is less elsewhere."""
        low, high = (self._end(number, sign) for sign in (-1.0, 1.0))
        self.problem.restart(self.best.at, self._apexes)
        return low, high

    def _end(self, number: int, sign: float) -> End:
        """One end, by the secant method on the root of the rise, which is nearly linear."""
        self.problem.restart(self.best.at, self._apexes)
        begin, bound = float(self.best.at[number]), float(self.problem.bounds[int(sign > 0.0)][number])
        spread = float(np.sqrt(self.covariance[number, number]))
        inside, outside, seen = (0.0, 0.0), None, self.best.at
        step = min(self.root * spread, LONGEST) if spread > 0.0 else LONGEST
        why = ""
        for _ in range(TRIES):
            far = min(step, sign * (bound - begin))
            if far <= inside[0]:
                return bound, "range"
            found = self._constrained(number, begin + sign * far, seen)
            if found is None:
                step, why = 0.5 * (inside[0] + far), "gaits"
                if far - inside[0] < MET * far:
                    return begin + sign * inside[0], why
                continue
            root = self._root(found)
            if root < self.root:
                inside, seen = (far, root), found.at
                if far == sign * (bound - begin):
                    return bound, "range"
            else:
                outside = (far, root)
            if abs(root - self.root) <= MET * self.root:
                break
            if outside is None and far >= FARTHEST:
                return sign * np.inf, ""
            step = self._next(inside, outside, why)
        if outside is None and not abs(inside[1] - self.root) <= MET * self.root:
            return (begin + sign * inside[0], why) if why else (sign * np.inf, "")
        far = self._interpolated(inside, outside or inside)
        return begin + sign * far, ""

    def _next(self, inside: tuple[float, float], outside: tuple[float, float] | None, why: str) -> float:
        """Distance of the next point from the best fit."""
        if outside is not None:
            span = outside[0] - inside[0]
            return float(np.clip(self._interpolated(inside, outside), inside[0] + 0.1 * span, outside[0]))
        longer = inside[0] * self.root / max(inside[1], 1e-3 * self.root)
        return float(np.clip(1.02 * longer, 1.1 * inside[0], (1.3 if why else 3.0) * inside[0]))

    def _interpolated(self, inside: tuple[float, float], outside: tuple[float, float]) -> float:
        rise = outside[1] - inside[1]
        if rise <= 0.0:
            return inside[0] * self.root / max(inside[1], 1e-3 * self.root)
        return inside[0] + (outside[0] - inside[0]) * (self.root - inside[1]) / rise

    def _root(self, found: Ended) -> float:
        rise = found.loss - self.best.loss
        if rise < -BETTER * max(1.0, self.best.loss):
            raise BetterFitError(found.at)
        return float(np.sqrt(max(rise, 0.0)))

    def _constrained(self, number: int, value: float, seen: Vector) -> Ended | None:
        """Fit with one parameter held, from predicted values of the others; None if no gaits are found."""
        for begin in self._begins(number, value, seen):
            with contextlib.suppress(RunError):
                found = searched(self.problem, begin, number, CHANGE)
                if np.isfinite(found.residuals).all():
                    return found
        return None

    def _begins(self, number: int, value: float, seen: Vector) -> Iterator[Vector]:
        """Unknowns to begin at: along the linear prediction, beside it, and across the folds nearby."""
        along = self.covariance[:, number] / (self.covariance[number, number] or 1.0)
        for share in (1.0, 0.0):
            begin = seen + share * (value - seen[number]) * along
            begin[number] = value
            begin = np.clip(begin, *self.problem.bounds)
            yield begin
        beyond = across_folds(self.problem, begin, number)
        if beyond is not None:
            yield beyond
