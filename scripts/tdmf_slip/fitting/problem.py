"""Problem of a fit: parameters at which the gaits of all conditions are those measured.

Unknowns are parameters that all rows share, and parameters with a value for each row. Each unknown is the
change from the first value, in tenths of the parameter's scale. A residual is a quantity less the measured
one, over its standard error.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple, TypeAlias

import numpy as np

from ..checks import number_of, refusal, shown
from ..errors import InputError, RunError
from ..given import row_of
from ..library.fixed_point import Closing
from ..library.gait import Gait
from ..library.members import check_varied
from ..library.page_strides import Strides
from ..library.quantities import scales_of
from ..library.runner import Runner
from ..library.strides import MadeStride, VariedGait, plain_stride, varied_gait
from ..numerics.newton import Vector, solve
from ..variables.table import Model, by_full_name
from ..variables.variable import Given
from .measurements import Measured, Measurements


@dataclass(frozen=True)
class Parameter:
    """Parameter of a fit."""

    name: str
    """Name of the runner's parameter."""
    row: int | None
    """Number of the row to which the parameter belongs; None if all rows share it."""

    @property
    def label(self) -> str:
        """Name, with the number of the row, from 1, if each row has its own value."""
        return self.name if self.row is None else f"{self.name}[{self.row + 1}]"


@dataclass(frozen=True)
class Prior(Measured):
    """Prior knowledge of a parameter that all rows share: its value and standard error."""

    name: str
    """Name of the parameter."""


@dataclass(frozen=True, eq=False)
class Request:
    """Data, parameters and options of a fit."""

    measurements: Measurements
    """Measured rows."""
    shared: tuple[str, ...]
    """Fitted parameters that all rows share."""
    each: tuple[str, ...]
    """Fitted parameters with a value for each row."""
    priors: tuple[Prior, ...]
    """Priors of shared parameters."""
    robust: bool
    """True for Huber's loss instead of squares."""
    scale_errors: bool
    """True if the errors are known except for a common factor."""
    profiled: tuple[str, ...]
    """Names of parameters whose intervals are by the profile likelihood."""
    starts: int
    """Largest number of fits; the one with the least loss is kept."""

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """Fitted parameters; those that all rows share come first."""
        rows = range(len(self.measurements.rows))
        return (
            *(Parameter(name, None) for name in self.shared),
            *(Parameter(name, row) for row in rows for name in self.each),
        )

    @property
    def degrees_of_freedom(self) -> int:
        """Measured numbers and priors less fitted numbers."""
        return self.measurements.count + len(self.priors) - len(self.parameters)


PriorGiven: TypeAlias = "tuple[Given, float] | Sequence[float]"
"""Value, also as a text with its unit, and its standard error in the unit's unit."""


def checked_priors(given: object, each: Sequence[str], model: Model) -> tuple[Prior, ...]:
    """Priors of a fit from its argument, which is checked here."""
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
        priors.append(Prior(value, error, name))
    return tuple(priors)


FIRST_STEP = 0.1
"""Unit of the unknowns, over a parameter's scale: the longest first step of the search."""
FAR = 1e3
"""Distance, over a parameter's scale, beyond which an end of its range is not passed on as a bound.

SciPy's search scales the parameters by the distances of their bounds."""
MAX_STRIDES = 20_000
"""Largest number of strides of all rows in a fit: nearly thirty times the number for the package's data."""


class _Base(NamedTuple):
    """Gait of a row from which other gaits are predicted."""

    values: Vector
    """Values of the row's parameters."""
    apex: Vector
    varied: VariedGait


class Problem:
    """Residuals of all rows and of the priors, with their exact Jacobian, for SciPy.

    A search goes on from the gaits at which the Jacobian was last evaluated.
    """

    def __init__(
        self, request: Request, first: Gait, strides_made: Callable[[int], object] = lambda count: None
    ) -> None:
        """Begin all rows with the first gait."""
        self.request, self.runner, self.rows = request, first.runner, request.measurements.rows
        self.robust, self.parameters = request.robust, request.parameters
        self.vary, shared, count = (*request.shared, *request.each), len(request.shared), len(self.rows)
        own = len(request.each)
        self.columns = [
            [*range(shared), *range(shared + r * own, shared + (r + 1) * own)] for r in range(count)
        ]
        ends_of_rows = np.cumsum([len(row) for row in self.rows]).tolist()
        self.places = [slice(end - len(row), end) for end, row in zip(ends_of_rows, self.rows, strict=True)]
        self._of_priors = [request.shared.index(prior.name) for prior in request.priors]
        known: list[Measured] = [*(of for row in self.rows for of in row.values()), *request.priors]
        self.measured = np.array([of.value for of in known])
        self.errors = np.array([of.error for of in known])
        names = [parameter.name for parameter in self.parameters]
        self.scales = scales_of(self.runner, names)[len(first.apex) :]
        self.steps = FIRST_STEP * self.scales
        self.begin = np.array([self.runner[name] for name in names])
        variables = (self.runner.model.variables[name] for name in names)
        ends = np.array([(of.minimum, of.maximum) for of in variables]).T
        scaled = (ends - self.begin) / self.scales
        self.bounds = np.where(np.abs(scaled) > FAR, [[-np.inf], [np.inf]], scaled) / FIRST_STEP
        self._strides_made, self.strides, self._granted = strides_made, 0, 0
        self.lost, self.crossed = 0, False
        self.seen_words = [[first.word] for _ in self.rows]
        start = varied_gait(self.runner, first.apex, (), self.vary)
        self._bases = [_Base(self.begin[columns], first.apex, start) for columns in self.columns]
        self.words = [first.word] * count
        self._tried: tuple[Vector, list[tuple[Vector, MadeStride]]] | None = None
        self._last: Vector | None = None

    @property
    def is_spent(self) -> bool:
        """True if all allowed strides are made: the search then ends at its last point."""
        return self.strides >= self._granted + MAX_STRIDES

    def grant(self) -> None:
        """Allow `MAX_STRIDES` further strides."""
        self._granted = self.strides

    def count_strides(self, count: int) -> None:
        """Count strides that were made for this fit."""
        self.strides += count
        self._strides_made(count)

    @property
    def apexes(self) -> list[Vector]:
        """Apexes of the gaits from which others are predicted."""
        return [base.apex for base in self._bases]

    def values(self, unknowns: Vector) -> Vector:
        """Values of the parameters, in the order of `parameters` and in their units."""
        values: Vector = self.begin + self.steps * unknowns
        return values

    def runner_of(self, values: Vector, row: int) -> Runner:
        """Runner of a row."""
        own = map(float, values[self.columns[row]])
        return self.runner.replace(dict(zip(self.vary, own, strict=True)))

    def residuals(self, unknowns: Vector) -> Vector:
        """Residuals of all rows in turn; infinite if a row has no gait, so that a shorter step is tried.

        Once all allowed strides are made, the last residuals are returned. No step is then better, and the
        search ends.
        """
        if self.is_spent and self._last is not None:
            return self._last.copy()
        found = self._residuals(unknowns)
        if np.isfinite(found).all():
            self._last = found
        return found

    def _residuals(self, unknowns: Vector) -> Vector:
        values = self.values(unknowns)
        try:
            gaits = [self._gait(values, row) for row in range(len(self.rows))]
        except (InputError, RunError):
            self.lost += 1
            return np.full(len(self.errors), np.inf)
        self._tried = np.array(unknowns), gaits
        return self.over_errors([stride for _, stride in gaits], values)

    def over_errors(self, strides: Sequence[MadeStride], values: Vector) -> Vector:
        """Quantities of all strides and parameters with priors, less the given values, over the errors."""
        has = np.concatenate([*(stride.quantities for stride in strides), values[self._of_priors]])
        over: Vector = (has - self.measured) / self.errors
        return over

    def jacobian(self, unknowns: Vector) -> Vector:
        """Jacobian of the residuals; the search goes on from these unknowns."""
        if self._tried is None or not np.array_equal(self._tried[0], unknowns):
            self._tried = None
            self._residuals(unknowns)
        if self._tried is None:
            raise RunError("the fit stops where a row has no gait; other first values lead past it")
        tried = self._tried
        self.restart(unknowns, [apex for apex, _ in tried[1]])
        self._tried, self.words = tried, [stride.word for _, stride in tried[1]]
        for word, seen in zip(self.words, self.seen_words, strict=True):
            if word not in seen:
                seen.append(word)
        return self.by_unknowns([base.varied.by_parameters for base in self._bases])

    def by_unknowns(self, by_parameters: Sequence[Vector]) -> Vector:
        """Jacobian of the residuals from derivatives of each row's quantities by its parameters."""
        slopes = np.zeros((len(self.errors), len(self.parameters)))
        for rows, columns, by in zip(self.places, self.columns, by_parameters, strict=True):
            slopes[rows, columns] = by
        first_prior = len(self.errors) - len(self._of_priors)
        slopes[range(first_prior, len(self.errors)), self._of_priors] = 1.0
        over: Vector = slopes * self.steps / self.errors[:, None]
        return over

    def restart(self, unknowns: Vector, apexes: Sequence[Vector]) -> None:
        """Predict from other gaits from now on."""
        values = self.values(unknowns)
        self._bases = [
            _Base(values[self.columns[row]], apex, self._varied(values, row, apex))
            for row, apex in enumerate(apexes)
        ]
        self._tried = None

    def _varied(self, values: Vector, row: int, apex: Vector) -> VariedGait:
        self.count_strides(1)
        try:
            return varied_gait(self.runner_of(values, row), apex, tuple(self.rows[row]), self.vary)
        except RunError as problem:
            raise RunError(
                f"the fit stops at row {row + 1}: {problem}; other first values lead past it"
            ) from None

    def _gait(self, values: Vector, row: int) -> tuple[Vector, MadeStride]:
        """Gait of a row, predicted from the gait at which the Jacobian was last evaluated."""
        runner, base = self.runner_of(values, row), self._bases[row]
        scales = runner.scales
        predicted = base.apex + base.varied.apex_by_parameters @ (values[self.columns[row]] - base.values)
        less_one = np.linalg.inv(base.varied.apex_by_residual) * scales / scales[:, None]
        found = solve(_Counted(runner, self.count_strides), predicted / scales, jacobian=less_one)
        self.count_strides(1)
        return found.x * scales, plain_stride(runner, found.x * scales, tuple(self.rows[row]))


class _Counted(Closing):
    """Equations of a gait, with a count of their strides."""

    def __init__(self, runner: Runner, count_strides: Callable[[int], object]) -> None:
        super().__init__(runner)
        self._count_strides = count_strides

    def stride(self, apex: Vector, varied: bool) -> Strides:
        self._count_strides(1)
        return super().stride(apex, varied)
