"""Problem of a fit: parameters at which the gaits of all conditions are those measured.

Unknowns are parameters that all rows share, and parameters of which each row has its own; each is counted
from its first value in tenths of its scale. A residual is a quantity less the measured one, over its error.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..checks import number_of, refusal, shown
from ..errors import InputError, RunError
from ..given import row_of
from ..library.fixed_point import gait_near
from ..library.gait import Gait
from ..library.members import check_varied
from ..library.quantities import scales_of
from ..library.runner import Runner
from ..library.strides import MadeStride, VariedGait, plain_stride, varied_gait
from ..variables.table import Model, by_full_name
from ..variables.variable import Given
from .measurements import Measurements


@dataclass(frozen=True)
class Parameter:
    """A parameter that is looked for."""

    name: str
    """Name of the runner's parameter."""
    row: int | None
    """Number of the row whose own it is; None where all rows share it."""

    @property
    def label(self) -> str:
        """The name, with the number of its row, from 1, where each has its own."""
        return self.name if self.row is None else f"{self.name}[{self.row + 1}]"


@dataclass(frozen=True)
class Prior:
    """Prior of a parameter."""

    name: str
    """Name of the parameter, which all rows share."""
    value: float
    """Expected value, in the unit's unit."""
    error: float
    """Standard error of the value, in the same unit."""


@dataclass(frozen=True, eq=False)
class Request:
    """Data and parameters of a fit, and how to fit."""

    measurements: Measurements
    """The data."""
    shared: tuple[str, ...]
    """Parameters to be found that all rows share."""
    each: tuple[str, ...]
    """Parameters to be found that have a value for each row."""
    priors: tuple[Prior, ...]
    """Priors of shared parameters."""
    robust: bool
    """Huber's loss instead of squares."""
    scale_errors: bool
    """The errors are known but for a common factor."""
    profiled: tuple[str, ...]
    """Names of parameters whose intervals are by the profile likelihood."""
    starts: int
    """Fits, at the most, of which the best counts."""
    ranges: Mapping[str, tuple[float, float]]
    """Ranges of the parameters, by name."""

    @property
    def degrees_of_freedom(self) -> int:
        """Measured numbers and priors less fitted numbers."""
        rows = len(self.measurements.rows)
        fitted = len(self.shared) + rows * len(self.each)
        return self.measurements.count + len(self.priors) - fitted


@dataclass
class SearchLog:
    """Obstacles of the search."""

    strides: int = 0
    """Strides made by all rows."""
    lost: int = 0
    """Tries at which a row had no gait."""
    crossed: bool = False
    """The search went on across a fold."""
    words: list[list[str]] = field(default_factory=list)
    """Words of each row's gait, in their order."""


PriorGiven: TypeAlias = "tuple[Given, float] | Sequence[float]"
"""A value, also a text with its unit, and its standard error in the unit's unit."""


def checked_priors(given: object, each: Sequence[str], model: Model) -> tuple[Prior, ...]:
    """The priors of a fit."""
    priors, allowed = [], "pairs of value and standard error by name"
    for name, pair in by_full_name(given, "priors", allowed, model.aliases).items():
        check_varied(name, "priors", model)
        where = f"priors {name}"
        if name in each:
            raise InputError(f"{where}: each row has its own; allowed: a parameter that all rows share")
        reported = row_of(pair, where, "a value and its standard error")
        if len(reported) != 2:
            raise InputError(
                f"{where} = {shown(pair)} is not allowed; allowed: a value and its standard error"
            )
        value = float(model.variables[name].value_of(reported[0], where))
        error = number_of(reported[1])
        if error is None or not 0.0 < error < math.inf:
            raise refusal(f"{where}: error", reported[1], "a standard error above 0")
        priors.append(Prior(name, value, error))
    return tuple(priors)


FIRST_STEP = 0.1
"""Longest first step of the search, over a parameter's scale."""
CLOSED = 1e-11
"""Largest difference of apex and next apex over the scales."""
FAR = 1e3
"""Distance, over a parameter's scale, from which on an end of its range is no bound, because SciPy's search
scales the parameters by how far their bounds are."""
MAX_STRIDES = 20_000
"""Largest number of strides of all rows in a fit: nearly thirty times what the package's data take."""
STRIDES_OF_SEARCH = 50
"""Strides that a search for a gait by Newton's method is counted for; it does not report their number."""
CHORDS = 16
"""Steps of Newton's method with the Jacobian of a gait nearby, before its own is asked for."""


@dataclass(frozen=True, eq=False)
class _Iterate:
    """A gait of a row and how it changes."""

    apex: NDArray[np.float64]
    varied: VariedGait
    values: NDArray[np.float64]
    """Values of the row's parameters."""


class Problem:
    """Residuals of all rows and their exact Jacobian, for SciPy."""

    def __init__(
        self,
        first: Gait,
        measurements: Measurements,
        shared: Sequence[str],
        each: Sequence[str],
        strides_made: Callable[[int], object] = lambda count: None,
        priors: Sequence[Prior] = (),
    ) -> None:
        """All are taken as they are; `fitted.fit` checks them."""
        self._strides_made = strides_made
        self.runner, self.rows = first.runner, measurements.rows
        count = len(self.rows)
        self.parameters = (
            *(Parameter(name, None) for name in shared),
            *(Parameter(name, row) for row in range(count) for name in each),
        )
        self.vary = (*shared, *each)
        self.columns = [
            [*range(len(shared)), *(len(shared) + row * len(each) + k for k in range(len(each)))]
            for row in range(count)
        ]
        names = [parameter.name for parameter in self.parameters]
        self.scales = scales_of(self.runner, names)[len(first.apex) :]
        self.steps = FIRST_STEP * self.scales
        self.begin = np.array([self.runner[name] for name in names])
        self.priors = tuple(priors)
        self._of_priors = [shared.index(prior.name) for prior in priors]
        self.count = measurements.count + len(self.priors)
        self._granted = 0
        self.log = SearchLog(words=[[first.word] for _ in self.rows])
        start = varied_gait(self.runner, first.apex, (), self.vary)
        own = np.array([self.runner[name] for name in self.vary])
        self._bases = [_Iterate(first.apex, start, own)] * count
        self._words = [first.word] * count
        self._tried: tuple[NDArray[np.float64], list[tuple[NDArray[np.float64], MadeStride]]] | None = None
        self._linear_at: NDArray[np.float64] | None = None
        self._last: NDArray[np.float64] | None = None

    @property
    def is_spent(self) -> bool:
        """Whether no further stride is to be made: the search then ends where it is."""
        return self.log.strides >= self._granted + MAX_STRIDES

    def grant(self) -> None:
        """Allow as many strides once more, for what follows the search."""
        self._granted = self.log.strides

    def count_strides(self, count: int) -> None:
        """Note strides that were made for this fit."""
        self.log.strides += count
        self._strides_made(count)

    def values(self, unknowns: NDArray[np.float64]) -> NDArray[np.float64]:
        """The parameters, in the order of `parameters` and in their units."""
        values: NDArray[np.float64] = self.begin + self.steps * unknowns
        return values

    def runner_of(self, values: NDArray[np.float64], row: int) -> Runner:
        """The runner of a row."""
        own = map(float, values[self.columns[row]])
        return self.runner.replace(dict(zip(self.vary, own, strict=True)))

    def residuals(self, unknowns: NDArray[np.float64]) -> NDArray[np.float64]:
        """Residuals of all rows in turn; infinite where one has no gait, so that a shorter step is tried.

        Where no further stride is to be made, those of before: no step is then better, and the search ends.
        """
        if self.is_spent and self._last is not None:
            return self._last.copy()
        found = self._residuals(unknowns)
        if np.isfinite(found).all():
            self._last = found
        return found

    def _residuals(self, unknowns: NDArray[np.float64]) -> NDArray[np.float64]:
        values = self.values(unknowns)
        try:
            gaits = [self._gait(values, row) for row in range(len(self.rows))]
        except (InputError, RunError):
            self.log.lost += 1
            return np.full(self.count, np.inf)
        self._tried = np.array(unknowns), gaits
        return np.concatenate(
            [
                *(self.over_errors(stride.quantities, row) for row, (_, stride) in enumerate(gaits)),
                self.off_priors(values),
            ]
        )

    def off_priors(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Parameters less what is known of them, over the errors."""
        known = np.array([prior.value for prior in self.priors])
        errors = np.array([prior.error for prior in self.priors])
        off: NDArray[np.float64] = (values[self._of_priors] - known) / errors
        return off

    def slopes_of_priors(self) -> NDArray[np.float64]:
        """Changes of these by the unknowns, in rows."""
        slopes = np.zeros((len(self.priors), len(self.parameters)))
        for row, (column, prior) in enumerate(zip(self._of_priors, self.priors, strict=True)):
            slopes[row, column] = self.steps[column] / prior.error
        return slopes

    def over_errors(self, quantities: NDArray[np.float64], row: int) -> NDArray[np.float64]:
        """Quantities of a row less those measured, over the errors."""
        measured = np.array([of.value for of in self.rows[row].values()])
        errors = np.array([of.error for of in self.rows[row].values()])
        over: NDArray[np.float64] = (quantities - measured) / errors
        return over

    def restart(self, unknowns: NDArray[np.float64], apexes: Sequence[NDArray[np.float64]]) -> None:
        """Go on from other gaits."""
        values = self.values(unknowns)
        iterates = [
            _Iterate(apex, self._varied(values, row, apex), values[self.columns[row]])
            for row, apex in enumerate(apexes)
        ]
        self._bases, self._tried, self._linear_at = iterates, None, None

    def jacobian(self, unknowns: NDArray[np.float64]) -> NDArray[np.float64]:
        """Jacobian of the residuals; the search goes on from there."""
        if self._tried is None or not np.array_equal(self._tried[0], unknowns):
            self._residuals(unknowns)
        assert self._tried is not None
        values = self.values(unknowns)
        self._linear_at = np.array(unknowns)
        rows = []
        for number, ((apex, stride), row) in enumerate(zip(self._tried[1], self.rows, strict=True)):
            varied = self._varied(values, number, apex)
            self._bases[number] = _Iterate(apex, varied, values[self.columns[number]])
            self._words[number] = stride.word
            if stride.word not in self.log.words[number]:
                self.log.words[number].append(stride.word)
            block = np.zeros((len(row), len(self.parameters)))
            block[:, self.columns[number]] = varied.by_parameters
            rows.append(block / np.array([measured.error for measured in row.values()])[:, None])
        return np.vstack([np.vstack(rows) * self.steps, self.slopes_of_priors()])

    def is_linear_at(self, unknowns: NDArray[np.float64]) -> bool:
        """Whether the Jacobian was asked for there last."""
        return self._linear_at is not None and np.array_equal(self._linear_at, unknowns)

    def apexes(self) -> list[NDArray[np.float64]]:
        """Apexes of the gaits at the last evaluation of the Jacobian."""
        return [base.apex for base in self._bases]

    def words(self) -> list[str]:
        """Words of the gaits at the last evaluation of the Jacobian."""
        return list(self._words)

    def _varied(self, values: NDArray[np.float64], row: int, apex: NDArray[np.float64]) -> VariedGait:
        self.count_strides(1)
        try:
            return varied_gait(self.runner_of(values, row), apex, tuple(self.rows[row]), self.vary)
        except RunError as problem:
            raise RunError(
                f"the fit stops at row {row + 1}: {problem}; other first values lead past it"
            ) from None

    def _gait(self, values: NDArray[np.float64], row: int) -> tuple[NDArray[np.float64], MadeStride]:
        """The gait of a row, from the one at which the Jacobian was asked for last."""
        runner, base, names = self.runner_of(values, row), self._bases[row], tuple(self.rows[row])
        moved = values[self.columns[row]] - base.values
        apex = predicted = base.apex + base.varied.apex_by_parameters @ moved
        last = np.inf
        for _ in range(CHORDS):
            self.count_strides(1)
            try:
                stride = plain_stride(runner, apex, names)
            except RunError:
                break
            error = float(np.max(np.abs(stride.residual / runner.scales)))
            if error <= CLOSED:
                return apex, stride
            if error > 0.5 * last:
                break
            last, apex = error, apex - base.varied.apex_by_residual @ stride.residual
        self.count_strides(STRIDES_OF_SEARCH)
        apex = gait_near(runner, predicted).apex
        return apex, plain_stride(runner, apex, names)


def bounds_of(
    problem: Problem, ranges: Mapping[str, tuple[float, float]]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The unknowns' least and greatest values."""
    ends = np.array([ranges[parameter.name] for parameter in problem.parameters]).T
    scaled = (ends - problem.begin) / problem.scales
    bounded: NDArray[np.float64] = np.where(np.abs(scaled) > FAR, [[-np.inf], [np.inf]], scaled) / FIRST_STEP
    return bounded[0], bounded[1]
