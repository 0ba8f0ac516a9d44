"""Results of a search: estimates with their intervals, unidentified combinations, and notes.

Intervals by the profile likelihood: a parameter is held, the others are fitted anew, and the loss rises.

The interval ends where it has risen by the quantile of chi square with one degree of freedom (Venzon and
Moolgavkar 1988, Applied Statistics 37, 87-94). Where the data identify the parameter well this is the
linear interval; where they identify it poorly it is not symmetric, and may have no end.
"""

from collections.abc import Iterator
from dataclasses import replace
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from .measurements import Measurements
from .problem import FIRST_STEP, MAX_STRIDES, Problem, Request, bounds_of
from .result import CONFIDENCE, QUANTILE, UNLIKELY, Estimate, Fit, Identified, Residual, identified
from .search import Bounds, Ended, is_stationary, searched, weights_of

MET = 0.02
"""Relative error of the root of the rise at which the interval's end is interpolated."""
TRIES = 14
"""Largest number of tries to find an end."""
LONGEST, FARTHEST = 5.0, 40.0
"""First step of an unknown, and largest distance of an end, in tenths of the unknown's scale."""
CHANGE = 1e-4
"""Change of the loss at which a search with a held parameter ends."""
BETTER = 1e-3
"""Fall of the loss below the least one that says that this was none."""


End: TypeAlias = tuple[float, str]
"""One end of an interval: the unknown, infinite where there is no end; and why it ends before the loss has
risen, `range` or `gaits`, else an empty text."""


class BetterFitError(Exception):
    """The loss with a parameter held is less than the least one."""

    def __init__(self, at: NDArray[np.float64]) -> None:
        """Keep the unknowns at which the loss is less."""
        super().__init__("the loss is less elsewhere")
        self.at = at


class Profile:
    """The profile of a fit."""

    def __init__(
        self,
        problem: Problem,
        best: Ended,
        bounds: Bounds,
        robust: bool,
        covariance: NDArray[np.float64],
        rise: float,
    ) -> None:
        """Begin at the fit `best`, with its linear covariance and the loss's rise at an interval's end."""
        self.problem, self.best, self.bounds, self.robust = problem, best, bounds, robust
        self.covariance, self.root = covariance, float(np.sqrt(rise))
        self._apexes = problem.apexes()

    def interval(self, number: int) -> tuple[End, End]:
        """Both ends of the interval of a parameter; `BetterFitError` where the fit was none."""
        low, high = (self._end(number, sign) for sign in (-1.0, 1.0))
        self.problem.restart(self.best.at, self._apexes)
        return low, high

    def _end(self, number: int, sign: float) -> End:
        """One end, by the secant method on the root of the rise, which is nearly linear."""
        self.problem.restart(self.best.at, self._apexes)
        begin, bound = float(self.best.at[number]), float(self.bounds[sign > 0.0][number])
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

    def _constrained(self, number: int, value: float, seen: NDArray[np.float64]) -> Ended | None:
        """The others fitted while one is held, from where they are predicted; None where no gaits are."""
        moved = value - seen[number]
        along = self.covariance[:, number] / (self.covariance[number, number] or 1.0)
        for share in (1.0, 0.0):
            begin = seen + share * moved * along
            begin[number] = value
            begin = np.clip(begin, *self.bounds)
            try:
                found = searched(self.problem, begin, self.bounds, self.robust, number, CHANGE)
            except RunError:
                continue
            if np.isfinite(found.residuals).all():
                return found
        return None


FAR_OFF = 1e4
"""Chi square over the number of data: residuals of a hundred errors each are no fit that has converged."""


class Conclusion:
    """Results of a search."""

    def __init__(self, request: Request, problem: Problem, found: Ended, starts: int) -> None:
        """Results from a request, its problem, the end of its search, and the number of searches."""
        self.request, self.problem, self.found, self.starts = request, problem, found, starts
        is_there = problem.is_linear_at(found.at)
        self.strides = problem.log.strides
        self.is_spent = problem.is_spent
        self.log = replace(problem.log, words=[[*words] for words in problem.log.words])
        problem.grant()
        self.jacobian = problem.jacobian(found.at)
        self.apexes, self.words = tuple(problem.apexes()), tuple(problem.words())
        self.residuals = found.residuals if is_there else problem.residuals(found.at)
        self.chi_square = float(self.residuals @ self.residuals)
        self.probability = probability_of(self.chi_square, request.degrees_of_freedom)

    @property
    def converged(self) -> bool:
        """Whether the search ended where the loss is least, and the data are not far off."""
        return bool(
            self.found.ended
            and not self.is_spent
            and self.chi_square <= FAR_OFF * len(self.residuals)
            and (self.found.on_border or is_stationary(self.found, self.jacobian, self.request.robust))
        )

    @property
    def scale(self) -> float:
        """Scale of the errors: 1 if known, else the root of chi square over the degrees of freedom."""
        if not self.request.scale_errors:
            return 1.0
        return float(np.sqrt(self.chi_square / self.request.degrees_of_freedom))

    @property
    def quantile(self) -> float:
        """Standard errors to each side of a linear interval."""
        if not self.request.scale_errors:
            return QUANTILE
        from scipy.special import stdtrit  # slow to load

        return self.scale * float(stdtrit(self.request.degrees_of_freedom, 0.5 + 0.5 * CONFIDENCE))

    def fit(self) -> Fit:
        """The fit with its estimates, intervals and notes."""
        problem, request = self.problem, self.request
        values = problem.values(self.found.at)
        labels = [parameter.label for parameter in problem.parameters]
        weighted = weights_of(self.residuals, request.robust)[:, None] * self.jacobian
        known = identified(weighted / FIRST_STEP, labels, problem.scales, QUANTILE)
        covariance = self.scale**2 * known.covariance * np.outer(problem.scales, problem.scales)
        spreads = np.where(known.reported, np.sqrt(np.diag(covariance)), np.inf)
        intervals, trouble = self._intervals(known)
        half, estimates = self.quantile / self.scale, []
        found = zip(problem.parameters, values.tolist(), spreads.tolist(), intervals, strict=True)
        for of, value, spread, interval in found:
            low, high, ends_at = interval or (value - half * spread, value + half * spread, "")
            is_profiled = interval is not None
            estimates.append(Estimate(of.label, of.name, value, spread, low, high, is_profiled, ends_at))
        count = request.measurements.count
        return Fit(
            measurements=request.measurements,
            runners=tuple(problem.runner_of(values, row) for row in range(len(request.measurements.rows))),
            apexes=self.apexes,
            words=self.words,
            estimates=tuple(estimates),
            covariance=covariance,
            unidentified=known.unidentified,
            residuals=_residuals(request.measurements, self.residuals[:count]),
            priors=tuple(
                Residual(0, prior.name, prior.value, prior.error, prior.value + float(off) * prior.error)
                for prior, off in zip(request.priors, self.residuals[count:], strict=True)
            ),
            probability=self.probability,
            converged=self.converged,
            steps=self.found.tries,
            starts=self.starts,
            request=request,
            notes=(*self._notes(), *trouble),
        )

    def _intervals(self, known: Identified) -> tuple[list[tuple[float, float, str] | None], list[str]]:
        """Ends of those that are by the profile likelihood, in the parameters' units; and what came of it."""
        problem, names = self.problem, self.request.profiled
        found: list[tuple[float, float, str] | None] = [None] * len(problem.parameters)
        wanted = [k for k, of in enumerate(problem.parameters) if of.name in names and known.reported[k]]
        if not wanted or not self.converged:
            return found, []
        problem.grant()
        profile = Profile(
            problem,
            self.found,
            bounds_of(problem, self.request.ranges),
            self.request.robust,
            known.covariance / FIRST_STEP**2,
            self.quantile**2,
        )
        linear, recorded = [], []
        for k in wanted:
            try:
                ends = profile.interval(k)
            except RunError:
                linear.append(problem.parameters[k].label)
                continue
            if problem.is_spent:
                linear += [problem.parameters[other].label for other in wanted if other >= k]
                break
            low, high = (float(problem.begin[k] + problem.steps[k] * at) for at, _ in ends)
            found[k] = low, high, ", ".join(dict.fromkeys(why for _, why in ends if why))
            if any(why == "gaits" for _, why in ends):
                recorded.append(
                    f"the interval of {problem.parameters[k].label} ends where no gaits are found"
                )
        if linear:
            recorded.append(
                f"the profile likelihood was not followed: linear intervals of {', '.join(linear)}"
            )
        return found, recorded

    def _notes(self) -> Iterator[str]:
        """Notes on the search and on how to read the fit."""
        log, found = self.log, self.found
        if self.is_spent:
            yield (
                f"the search was ended after {self.strides:,} strides ({MAX_STRIDES:,} are "
                "allowed): its values are not the best ones; are the data in the units that their titles say?"
            )
        if not found.ended:
            yield f"the search has not ended after {found.tries} tries: its values are not the best ones"
        elif not self.is_spent and not self.converged:
            yield (
                "the search ended where the sum of squares is not least, or is far too large: its values and "
                "intervals mean nothing; begin elsewhere, with other values or more starts"
            )
        if np.isnan(self.probability) and self.chi_square > 1.0:
            yield "the data are not met, though as many numbers are fitted as were measured"
        if self.probability < UNLIKELY and not self.request.scale_errors:
            yield (
                f"residuals as large as these come by chance with a probability of {self.probability:.1g}: "
                "the model is farther from the data than their errors, and the intervals are too narrow"
            )
        if self.request.scale_errors:
            yield f"the errors are taken {self.scale:.3g} times as large as the data say"
        for parameter, bound in zip(self.problem.parameters, found.at_bound, strict=True):
            if bound:
                yield f"{parameter.label} is at the {'lower' if bound < 0 else 'upper'} end of its range"
        for row, words in enumerate(log.words, start=1):
            if len(words) > 1:
                yield f"the word of row {row} changed on the way: {', '.join(words)}"
        if found.on_border:
            yield "the sum of squares is least on a border between words, where it has a kink"
        if log.lost:
            yield f"{log.lost} of the tries led where a row has no gait, and were made shorter"
        if log.crossed:
            yield "the search went on across a fold, where gaits turn back"


def is_met(loss: float, request: Request) -> bool:
    """Whether the residuals are such as come by chance."""
    probability = probability_of(loss, request.degrees_of_freedom)
    return bool(loss < 1.0 if np.isnan(probability) else probability >= UNLIKELY)


def probability_of(chi_square: float, degrees_of_freedom: int) -> float:
    """Probability that the chi square distribution exceeds a value."""
    from scipy.special import gammaincc  # slow to load

    if degrees_of_freedom == 0:
        return float("nan")
    return float(gammaincc(0.5 * degrees_of_freedom, 0.5 * chi_square))


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
