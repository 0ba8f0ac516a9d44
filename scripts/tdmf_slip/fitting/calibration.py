"""The rise of chi square at an interval's end, told by data that the fitted runner makes.

Where residuals bend, or have a kink between words, and data are weak, the likelihood ratio of a true value is
not chi square with one degree of freedom: it exceeds 3.84 more often than in 5 of 100. Its mean, which would
be one, is taken over data sets made by the fitted runner and normal errors, and the quantile is multiplied by
it (Bartlett 1937, Proceedings of the Royal Society A 160, 268-282; by simulation: Rocke 1989, Communications
in Statistics 18, 1345-1361).
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from .problem import Problem
from .search import Bounds, Ended, searched

MOST_DATA_SETS = 10_000
CHANGE = 1e-4
"""Of the loss, where a search ends: of a mean of one, that is little."""


class _Remeasured:
    """A problem whose data are those of its fit, with other errors."""

    def __init__(self, problem: Problem, moved: NDArray[np.float64]) -> None:
        self._problem, self._moved = problem, moved

    def residuals(self, unknowns: NDArray[np.float64]) -> NDArray[np.float64]:
        """Of the other data."""
        return self._problem.residuals(unknowns) - self._moved

    def jacobian(self, unknowns: NDArray[np.float64]) -> NDArray[np.float64]:
        """The same: data are no part of it."""
        return self._problem.jacobian(unknowns)


class Calibration:
    """Data sets made by a fitted runner, each fitted with and without a parameter held at its value."""

    def __init__(self, problem: Problem, best: Ended, bounds: Bounds, robust: bool) -> None:
        """Of which fit.

        Parameters
        ----------
        problem : Problem
            Whose gaits are those of the fit.
        best : Ended
            The fit.
        bounds : pair of ndarray of float
            Of its unknowns.
        robust : bool
            As in `search.searched`.
        """
        self.problem, self.best, self.bounds, self.robust = problem, best, bounds, robust
        self._apexes = problem.apexes()

    def factors(self, numbers: Sequence[int], data_sets: int, seed: int) -> NDArray[np.float64]:
        """Mean likelihood ratio of each parameter's own value.

        Parameters
        ----------
        numbers : sequence of int
            Of the parameters.
        data_sets : int
            How many are made.
        seed : int
            Of their errors.

        Returns
        -------
        ndarray of float
            One or more; one where no data set could be fitted.
        """
        random = np.random.default_rng(seed)
        ratios = []
        for _ in range(data_sets):
            errors = random.normal(size=len(self.best.residuals))
            try:
                ratios.append(self._ratios(numbers, errors))
            except RunError:
                continue
        self._back()
        mean = np.mean(ratios, axis=0) if ratios else np.ones(len(numbers))
        factors: NDArray[np.float64] = np.maximum(mean, 1.0)
        return factors

    def _ratios(self, numbers: Sequence[int], errors: NDArray[np.float64]) -> NDArray[np.float64]:
        data = _Remeasured(self.problem, self.best.residuals + errors)
        held = []
        for number in numbers:
            self._back()
            held.append(searched(data, self.best.at, self.bounds, self.robust, number, CHANGE))
        begin = min(held, key=lambda ended: ended.loss)
        self._back()
        least = searched(data, begin.at, self.bounds, self.robust, change=CHANGE).loss
        return np.array([ended.loss - min(least, begin.loss) for ended in held])

    def _back(self) -> None:
        """To the gaits of the fit, with strides for another data set."""
        self.problem.grant()
        self.problem.restart(self.best.at, self._apexes)
