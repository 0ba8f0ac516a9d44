"""A fit without one of its data, which tells whether all hangs on a single one."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError
from .fitted import summarize
from .measurements import Measurements
from .problem import Problem
from .request import Request
from .result import Fit


@dataclass(frozen=True, eq=False)
class LeftOut:
    """A datum, and the fit without it."""

    row: int
    """Row of the datum, from 1."""
    name: str
    """Name of the datum's quantity."""
    fit: Fit
    """Fit of all other data, with linear intervals."""

    def shifts(self, of: Fit) -> Mapping[str, float]:
        """By label: how far shared estimates move, over their standard errors in the whole fit."""
        shared = [estimate for estimate in of.estimates if estimate.label == estimate.name]
        return {
            one.label: (self.fit.parameters[one.label].value - one.value) / one.standard_error
            for one in shared
        }


def without(found: Fit, row: int, name: str, profile: bool = True) -> Fit:
    """The fit to all data but one, from the gaits of the fit to all."""
    request = found.request
    measured = request.measurements.rows
    if not 1 <= row <= len(measured) or name not in measured[row - 1]:
        raise InputError(f"row {row}, {name}: is not among the data; allowed: what was measured")
    rows = [
        {of: value for of, value in given.items() if (k, of) != (row, name)}
        for k, given in enumerate(measured, 1)
    ]
    kept = [k for k, given in enumerate(rows) if given]
    where = f"{request.measurements.where} without {name} of row {row}"
    data = Measurements(tuple(rows[k] for k in kept), where)
    fewer = replace(request, measurements=data, starts=1, profiled=request.profiled if profile else ())
    if fewer.degrees_of_freedom < fewer.scale_errors or not kept:
        raise InputError(f"{where}: less is left than is fitted; allowed: a datum that can be spared")
    return summarize(fewer, *_begun(fewer, found, kept))


def without_each(found: Fit) -> tuple[LeftOut, ...]:
    """The fits without one datum each, of all data that can be spared."""
    left = []
    for residual in found.residuals:
        try:
            left.append(
                LeftOut(residual.row, residual.name, without(found, residual.row, residual.name, False))
            )
        except InputError:
            continue
    return tuple(left)


def _begun(request: Request, found: Fit, kept: list[int]) -> tuple[Problem, NDArray[np.float64]]:
    """A problem that begins with gaits of a fit, and its unknowns there."""
    problem = Problem(
        found.gaits[kept[0]],
        request.measurements,
        request.shared,
        request.each,
        priors=request.priors,
    )
    values = [found.runners[kept[parameter.row or 0]][parameter.name] for parameter in problem.parameters]
    at = (np.array(values) - problem.begin) / problem.steps
    problem.restart(at, [found.apexes[k] for k in kept])
    return problem, at
