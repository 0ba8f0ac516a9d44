"""How stable gaits are over the plane of two parameters, found from neighbour to neighbour."""

from collections import deque
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError
from ..library.fixed_point import gait_near
from ..library.gait import Gait
from ..library.members import check_varied
from ..library.runner import Runner
from ..terminal.progress import Bar, progress_bar
from ..variables.table import Model, by_full_name
from ..variables.variable import Given, Values
from .search import periodic_gait
from .sweeps import MAX_GAITS


@dataclass(frozen=True, eq=False)
class StabilityMap:
    """The largest eigenvalue of gaits over a plane of two parameters."""

    names: tuple[str, str]
    """Names of the two parameters."""
    rows: NDArray[np.float64]
    """Values of the first, in its unit."""
    columns: NDArray[np.float64]
    """Values of the second, in its unit."""
    lambda_max: NDArray[np.float64]
    """Size of the largest eigenvalue, shape (rows, columns); not a number where no gait was found."""
    word: NDArray[np.object_]
    """The gait words, shape (rows, columns); empty where no gait was found."""

    @property
    def found(self) -> int:
        """How many gaits were found."""
        return int(np.count_nonzero(np.isfinite(self.lambda_max)))

    @property
    def stable_share(self) -> float:
        """Share of the points of the plane that have a stable gait."""
        return float(np.mean(self.lambda_max < 1.0))


def stability(
    runner: Runner | Mapping[str, Given],
    over: Mapping[str, Values],
    *,
    progress: bool = False,
) -> StabilityMap:
    """The gait at each point of a plane, each from a neighbour's, from where the runner's own is nearest.

    A point has no gait where Newton's method finds none from any of its four neighbours. Where there are
    several gaits, it is the one that the neighbours lead to.
    """
    runner = Runner(runner)
    names, values = _checked(over, runner.model)
    shape = len(values[0]), len(values[1])
    lambda_max = np.full(shape, np.nan)
    word = np.full(shape, "", dtype=object)
    with progress_bar("stability", lambda_max.size, "points", progress) as bar:
        for cell, gait in _spread(runner, names, values, bar):
            lambda_max[cell], word[cell] = gait.lambda_max, gait.word
    return StabilityMap(names, *values, lambda_max, word)


def _checked(
    over: Mapping[str, Values], model: Model
) -> tuple[tuple[str, str], tuple[NDArray[np.float64], NDArray[np.float64]]]:
    given = by_full_name(over, "over", "two parameters or inputs with their values", model.aliases)
    if len(given) != 2:
        raise InputError("over: allowed: two parameters or inputs with their values")
    for name in given:
        check_varied(name, "over", model)
    first, second = given
    rows, columns = (
        model.variables.find(name, "over").values_of(of, f"values of {name}") for name, of in given.items()
    )
    if len(rows) * len(columns) > MAX_GAITS:
        raise InputError(f"{len(rows)} by {len(columns)} gaits: allowed: {MAX_GAITS:,} at the most")
    return (first, second), (rows, columns)


def _spread(
    runner: Runner,
    names: tuple[str, str],
    values: tuple[NDArray[np.float64], NDArray[np.float64]],
    bar: Bar,
) -> Iterator[tuple[tuple[int, int], Gait]]:
    """Gaits with their cells, from the first on to neighbours, and from these on to theirs."""

    def at(cell: tuple[int, int]) -> Runner:
        return runner.replace({names[0]: values[0][cell[0]], names[1]: values[1][cell[1]]})

    row, column = (
        int(np.argmin(np.abs(along - runner[name]))) for along, name in zip(values, names, strict=True)
    )
    first = periodic_gait(at((row, column)))
    bar.update()
    yield (row, column), first
    found = {(row, column)}
    seen = {(row, column)}
    edge = deque([((row, column), first)])
    while edge:
        (row, column), gait = edge.popleft()
        for cell in ((row + 1, column), (row - 1, column), (row, column + 1), (row, column - 1)):
            if cell in found or not (0 <= cell[0] < len(values[0]) and 0 <= cell[1] < len(values[1])):
                continue
            if cell not in seen:
                seen.add(cell)
                bar.update()
            try:
                neighbour = gait_near(at(cell), gait.apex)
            except RunError:
                continue
            found.add(cell)
            edge.append((cell, neighbour))
            yield cell, neighbour
