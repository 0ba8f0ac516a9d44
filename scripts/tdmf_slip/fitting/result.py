"""A fit: parameters with confidence intervals, combinations that cannot be identified, and residuals.

Singular values of the weighted Jacobian show which combinations of parameters the data do not identify. Rows
of this matrix are changes of the measured quantities over their errors. Columns are by the parameters over
their scales. A direction of the parameters cannot be identified if its singular value is zero up to rounding.
It is poorly identified if a change as large as the parameters themselves stays within the errors of the data.
"""

import contextlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from statistics import NormalDist

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, counted
from ..library.gait import Gait
from ..library.quantities import unit_of
from ..library.runner import Runner
from ..library.strides import strides_from
from ..record import entries, origin_of
from ..terminal.text import quantity, table
from .measurements import Measurements
from .problem import Problem, Request

ROUNDING = 1e-9
"""Share of the largest singular value below which a singular value counts as zero."""
SMALL = 1e-5
"""Share of a combination's largest member below which a parameter does not belong to it."""
MINOR = 0.1
"""Smallest share that is named in a poorly identified combination, because all parameters have some."""


@dataclass(frozen=True, eq=False)
class Combination:
    """Combined change of parameters that the data do not determine."""

    members: Mapping[str, float]
    """Change of each parameter over its scale, which is its value, or 1 if that is 0; the largest is 1."""
    changes: Mapping[str, float]
    """Change of each parameter in its unit."""
    standard_error: float
    """Standard error in multiples of the change; infinite where the change has no effect on the data."""

    @property
    def name(self) -> str:
        """Changes in words, as in `hip.stance_torque +0.2, control.stance_torque -0.2`."""
        return ", ".join(f"{label} {change:+.4g}" for label, change in self.changes.items())

    def as_json(self) -> dict[str, object]:
        """Combination as a plain object."""
        return {
            "combination": self.name,
            "changes": dict(self.changes),
            "relative": dict(self.members),
            "standard_error": self.standard_error,
        }


@dataclass(frozen=True, eq=False)
class Identified:
    """Identifiability of the parameters by a weighted Jacobian."""

    covariance: NDArray[np.float64]
    """Covariance of the identified parts of the parameters over their scales, shape (p, p)."""
    reported: NDArray[np.bool_]
    """True for parameters outside of all combinations without effect on the data, shape (p,)."""
    unidentified: tuple[Combination, ...]
    """Combinations that are poorly identified; those without effect on the data come first."""


def identified(
    jacobian: NDArray[np.float64], labels: Sequence[str], scales: NDArray[np.float64], quantile: float
) -> Identified:
    """Identifiability of the parameters by a weighted Jacobian."""
    _, sizes, directions = np.linalg.svd(jacobian, full_matrices=False)
    none = sizes <= ROUNDING * max(sizes[0], np.finfo(float).tiny)
    unseen = _simplest(directions[none])
    inverse = directions[~none] / sizes[~none, None]
    spreads = np.max(np.abs(directions), axis=1) / np.where(none, 1.0, sizes)
    badly = ~none & (quantile * spreads > 1.0)
    return Identified(
        covariance=inverse.T @ inverse,
        reported=np.all(np.abs(directions[none]) < SMALL, axis=0),
        unidentified=(
            *(_combination(direction, labels, scales, np.inf, SMALL) for direction in unseen),
            *(
                _combination(direction, labels, scales, float(spread), MINOR)
                for direction, spread in zip(directions[badly][::-1], spreads[badly][::-1], strict=True)
            ),
        ),
    )


def _simplest(directions: NDArray[np.float64]) -> NDArray[np.float64]:
    """Reduced row echelon form: directions with the same span, each with a parameter of its own."""
    rows, taken = directions.copy(), 0
    while taken < len(rows):
        pivot = np.unravel_index(int(np.argmax(np.abs(rows[taken:]))), rows[taken:].shape)
        row, column = taken + int(pivot[0]), int(pivot[1])
        rows[[taken, row]] = rows[[row, taken]]
        rows[taken] /= rows[taken, column]
        for other in range(len(rows)):
            if other != taken:
                rows[other] -= rows[other, column] * rows[taken]
        taken += 1
    return rows


def _combination(
    direction: NDArray[np.float64],
    labels: Sequence[str],
    scales: NDArray[np.float64],
    standard_error: float,
    minimum: float,
) -> Combination:
    """Combination of a direction; the largest member comes first, and its change is 1."""
    shares = np.round(direction / direction[np.argmax(np.abs(direction))], 9)
    order = [int(k) for k in np.argsort(-np.abs(shares), kind="stable") if abs(shares[k]) >= minimum]
    return Combination(
        members={labels[k]: float(shares[k]) for k in order},
        changes={labels[k]: float(shares[k] * scales[k]) for k in order},
        standard_error=standard_error,
    )


CONFIDENCE = 0.95
QUANTILE = NormalDist().inv_cdf(0.5 + 0.5 * CONFIDENCE)
"""Half the width of an interval over the standard error, by the normal distribution of known errors."""
UNLIKELY = 0.01
"""Probability of the residuals below which a note says that data and model differ."""


def probability_of(chi_square: float, degrees_of_freedom: int) -> float:
    """Probability that the chi square distribution exceeds a value; NaN without degrees of freedom."""
    from scipy.special import gammaincc  # slow to load

    return float(gammaincc(0.5 * degrees_of_freedom, 0.5 * chi_square)) if degrees_of_freedom else np.nan


def is_likely(chi_square: float, degrees_of_freedom: int) -> bool:
    """True if residuals as large come by chance; without degrees of freedom, if they are small."""
    probability = probability_of(chi_square, degrees_of_freedom)
    return chi_square < 1.0 if np.isnan(probability) else probability >= UNLIKELY


@dataclass(frozen=True)
class Estimate:
    """Fitted parameter."""

    label: str
    """Name of the parameter, with the number of its row, from 1, where each row has its own."""
    name: str
    """Name of the parameter without a row."""
    value: float
    """Estimate in the unit's unit, like all values below."""
    standard_error: float
    """Standard error by the linearized fit; infinite if the data do not determine it."""
    low: float
    """Lower end of the confidence interval."""
    high: float
    """Upper end of the confidence interval."""
    is_profiled: bool
    """True if the interval is by the profile likelihood; else it is linear."""
    ends_at: str
    """Reason why the interval ends before the likelihood does: `range`, `gaits`, or both; else empty."""


@dataclass(frozen=True)
class Residual:
    """Measured quantity beside the fitted one."""

    row: int
    """Number of the condition, from 1."""
    name: str
    """Name of the quantity."""
    measured: float
    """Value that was measured."""
    error: float
    """Standard error of the measured value."""
    fitted: float
    """Value of the fitted gait."""

    @property
    def residual(self) -> float:
        """Difference between fitted and measured value, over the error."""
        return (self.fitted - self.measured) / self.error


@dataclass(frozen=True, eq=False, repr=False)
class Fit:
    """Runner fitted to measured gaits; `plot` draws the data, the fit and the residuals."""

    request: Request = field(repr=False)
    """Data, parameters and options of the fit."""
    runners: tuple[Runner, ...]
    """Runners with the fitted parameters, one for each row."""
    apexes: tuple[NDArray[np.float64], ...]
    """Apexes of the fitted gaits, one for each row."""
    words: tuple[str, ...]
    """Words of the fitted gaits."""
    estimates: tuple[Estimate, ...]
    """Estimates of the parameters; those that all rows share come first."""
    covariance: NDArray[np.float64]
    """Covariance of the identified parts of the estimates, in their units."""
    unidentified: tuple[Combination, ...]
    """Combinations of parameters that the data determine badly or not at all."""
    residuals: tuple[Residual, ...]
    """Measured and fitted values, row by row."""
    priors: tuple[Residual, ...]
    """Priors beside the fitted values, by parameters' names; their rows are 0."""
    converged: bool
    """True if the search ended at a least sum of squares, with residuals of at most a hundred errors."""
    steps: int
    """Number of steps of the search."""
    starts: int
    """Number of searches of which this is the best."""
    notes: tuple[str, ...]
    """Notes on the search and on how to read the fit, a sentence each."""

    def __repr__(self) -> str:
        """One line with the estimates."""
        found = ", ".join(f"{e.label} = {e.value:.6g}" for e in self.estimates[:4])
        more = ", ..." if len(self.estimates) > 4 else ""
        return (
            f"<Fit {found}{more}: chi square {self.chi_square:.4g} with "
            f"{counted(self.degrees_of_freedom, 'degree')} of freedom>"
        )

    @property
    def measurements(self) -> Measurements:
        """Measurements that were fitted."""
        return self.request.measurements

    @property
    def probability(self) -> float:
        """Probability of residuals as large as these by chance; NaN where as many are fitted as measured."""
        return probability_of(self.chi_square, self.degrees_of_freedom)

    @property
    def chi_square(self) -> float:
        """Sum of the squared residuals of data and priors, each over its error."""
        return float(sum(of.residual**2 for of in (*self.residuals, *self.priors)))

    @property
    def degrees_of_freedom(self) -> int:
        """Measured numbers and priors less fitted numbers."""
        return self.request.degrees_of_freedom

    @cached_property
    def gaits(self) -> tuple[Gait, ...]:
        """Fitted gaits, one for each row."""
        return tuple(
            strides_from(runner, apex) for runner, apex in zip(self.runners, self.apexes, strict=True)
        )

    @property
    def parameters(self) -> Mapping[str, Estimate]:
        """Estimates by their labels."""
        return {estimate.label: estimate for estimate in self.estimates}

    def without(self, row: int, name: str, *, profile: bool = True) -> "Fit":
        """Fit to all data but one, from the gaits of this fit.

        Parameters
        ----------
        row : int
            Row of the datum that is left out, from 1.
        name : str
            Name of the datum's quantity.
        profile : bool, default True
            Intervals by the profile likelihood where this fit has them; else all are linear.
        """
        from .conclusion import concluded  # which needs this class
        from .search import best_from

        measured = self.measurements.rows
        if not 1 <= row <= len(measured) or name not in measured[row - 1]:
            raise InputError(f"row {row}, {name}: is not among the data; allowed: what was measured")
        rows = [
            {of: value for of, value in given.items() if (number, of) != (row, name)}
            for number, given in enumerate(measured, 1)
        ]
        kept = [number for number, given in enumerate(rows) if given]
        data = Measurements(
            tuple(rows[number] for number in kept), f"{self.measurements.where} without {name} of row {row}"
        )
        profiled = self.request.profiled if profile else ()
        fewer = replace(self.request, measurements=data, starts=1, profiled=profiled)
        if fewer.degrees_of_freedom < fewer.scale_errors or not kept:
            raise InputError(
                f"{data.where}: less is left than is fitted; allowed: a datum that can be spared"
            )
        problem = Problem(fewer, self.gaits[kept[0]])
        values = [self.runners[kept[of.row or 0]][of.name] for of in problem.parameters]
        at = (np.array(values) - problem.begin) / problem.steps
        problem.restart(at, [self.apexes[number] for number in kept])
        return concluded(problem, best_from(problem, at))

    def without_each(self) -> "dict[Residual, Fit]":
        """Fits without one datum each, for all data that can be spared, with linear intervals."""
        left = {}
        for of in self.residuals:
            with contextlib.suppress(InputError):
                left[of] = self.without(of.row, of.name, profile=False)
        return left

    def shifts(self, other: "Fit") -> Mapping[str, float]:
        """Changes of shared estimates in another fit by label, over their standard errors in this one."""
        return {
            one.label: (other.parameters[one.label].value - one.value) / one.standard_error
            for one in self.estimates
            if one.label == one.name
        }

    def as_json(self) -> dict[str, object]:
        """Fit as a plain object; an interval without an end has an infinite one."""
        return {
            **origin_of(self.runners[0]),
            "parameters": {
                e.label: {
                    **entries(e, "value", "low", "high", "standard_error"),
                    "profiled": e.is_profiled,
                    "ends_at": e.ends_at or None,
                }
                for e in self.estimates
            },
            "unidentified": [combination.as_json() for combination in self.unidentified],
            "residuals": [
                {"row": of.row, "quantity": of.name, **entries(of, "measured", "error", "fitted", "residual")}
                for of in self.residuals
            ],
            "priors": [
                {"parameter": of.name, "value": of.measured, "error": of.error, "fitted": of.fitted}
                for of in self.priors
            ],
            **entries(self, "chi_square", "degrees_of_freedom", "probability", "words", "converged"),
            **entries(self, "steps", "starts", "notes"),
            "runners": [dict(runner) for runner in self.runners],
        }

    def as_text(self) -> str:
        """Tables of parameters and residuals, then sentences."""
        parts = [
            table(PARAMETER_HEADER, self.parameter_rows()),
            table(RESIDUAL_HEADER, self.residual_rows()),
            "\n".join(self.sentences()),
        ]
        return "\n\n".join(parts)

    def parameter_rows(self) -> list[tuple[str, ...]]:
        """Cells of a table under `PARAMETER_HEADER`."""
        variables, label = self.runners[0].model.variables, self.runners[0].label
        return [
            (e.label, quantity(e.value, label(variables[e.name].unit), 6), f"{e.low:.6g}", f"{e.high:.6g}")
            for e in self.estimates
        ]

    def residual_rows(self) -> list[tuple[str, ...]]:
        """Cells of a table under `RESIDUAL_HEADER`."""
        runner = self.runners[0]
        return [
            (
                str(of.row),
                of.name,
                quantity(of.measured, runner.label(unit_of(of.name, runner.model)), 6),
                f"{of.error:.3g}",
                f"{of.fitted:.6g}",
                f"{of.residual:+.2f}",
            )
            for of in self.residuals
        ]

    def sentences(self) -> Sequence[str]:
        """Quality of the fit, combinations that are not identified, and the notes."""
        chance = "" if np.isnan(self.probability) else f", probability {self.probability:.2g}"
        return [
            f"chi square {self.chi_square:.6g} with {counted(self.degrees_of_freedom, 'degree')} of freedom"
            f"{chance}; words {', '.join(dict.fromkeys(self.words))}",
            *(reported_of(combination) for combination in self.unidentified),
            *self.notes,
        ]


PARAMETER_HEADER = ("parameter", "value", "low", "high")
"""Titles of the table of parameters; the interval has the probability `CONFIDENCE`."""
RESIDUAL_HEADER = ("row", "quantity", "measured", "error", "fitted", "residual / error")


def reported_of(combination: Combination) -> str:
    """Sentence about a combination of parameters that the data do not identify."""
    alone = len(combination.members) == 1
    if np.isinf(combination.standard_error):
        if alone:
            name = next(iter(combination.members))
            return f"{name} cannot be identified: the measured quantities do not depend on it"
        return f"cannot be identified: {combination.name}, together, change none of the measured quantities"
    what = "a change" if alone else "a joint change"
    return (
        f"poorly identified: {what} of {combination.name} has a standard error of "
        f"{combination.standard_error:.2g} times that change"
    )
