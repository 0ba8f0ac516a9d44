"""A law from apex to settings that keeps a runner viable: the viable action nearest to a wish."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import number_of, refusal, shown
from ..errors import InputError
from ..library.runner import Runner
from ..library.section import REDUCED
from ..library.settings import checked_values
from ..variables.table import by_full_name
from .grid import Grid

GRADES = ("not viable", "open", "viable")
"""Grades of a choice: no action of the cell is viable, one of the outer set is, one of the inner set is."""


@dataclass(frozen=True, eq=False)
class ViableController:
    """At each apex the viable action nearest to a wish, over the ranges of the settings.

    Of the inner set where the apex's cell has some, else of the outer one. Where neither has any, or outside
    of the grid, nothing is known to help, and the wish itself is set; `grade_at` tells.

    Examples
    --------
    >>> import tdmf_slip
    >>> runner = {"ground.friction": 0.6}
    >>> found = tdmf_slip.viability(
    ...     runner,
    ...     axes={"com_height": (1.0, 2.0), "com_speed": (0.6, 1.6)},
    ...     vary={"hip.touchdown_angle": (0.3, 1.1, 12), "hip.stance_torque": (0.05, 0.4, 6)},
    ...     n=24,
    ... )
    >>> law = found.controller()
    >>> apices = [1.2, 1.0, 1.0, 0.7, 0, 0]
    >>> run = tdmf_slip.stride_map(runner, apices, strides=20, law=law)
    >>> bool((run["fate"] == 0).all())
    True
    """

    grid: Grid
    """Cells and actions."""
    inner: NDArray[np.bool_]
    """Pairs of the inner set, shape (rows, columns, actions)."""
    outer: NDArray[np.bool_]
    """Pairs of the outer set."""
    wish: tuple[float, ...]
    """A value of each setting, in its unit."""

    @classmethod
    def of(
        cls,
        grid: Grid,
        inner: NDArray[np.bool_],
        outer: NDArray[np.bool_],
        runner: Runner,
        wish: Mapping[str, float] | None,
    ) -> ViableController:
        """A controller with a wish that is checked.

        Parameters
        ----------
        grid : Grid
            Cells and actions.
        inner, outer : ndarray of bool, shape (rows, columns, actions)
            Pairs of both sets.
        runner : Runner
            What it has is wished where nothing else is.
        wish : mapping of str to float or None
            By setting.

        Returns
        -------
        ViableController
            Of these pairs.

        Raises
        ------
        InputError
            The wish names something else, or is out of a setting's range.
        """
        given = by_full_name(wish, "wish", "a mapping of settings to numbers")
        unknown = next((name for name in given if name not in grid.actions), None)
        if unknown is not None:
            raise InputError(f"wish: {shown(unknown)} is not allowed; allowed: {', '.join(grid.actions)}")
        values = {}
        for name in grid.actions:
            number = number_of(given.get(name, runner[name]))
            if number is None:
                raise refusal(f"wish: {name}", given[name], "a number")
            values[name] = number
            checked_values(name, np.array(number), "wish", {})
        return cls(grid, inner, outer, tuple(values.values()))

    def inputs_at(self, apex: ArrayLike) -> dict[str, float]:
        """Settings at one apex.

        Parameters
        ----------
        apex : sequence of float
            Height and speed first; further coordinates, as of the full model, are not looked at.

        Returns
        -------
        dict of str to float
            By setting, in its unit.
        """
        return {name: float(values[0]) for name, values in self(np.asarray(apex, float)[None]).items()}

    def grade_at(self, apex: ArrayLike) -> str:
        """How good the choice at an apex is: one of `GRADES`.

        Parameters
        ----------
        apex : sequence of float
            As in `inputs_at`.

        Returns
        -------
        str
            `viable`, `open` or `not viable`.
        """
        cell = self.grid.cell_of(np.asarray(apex, float)[None, : len(REDUCED)])[0]
        if cell < 0:
            return GRADES[0]
        row, column = divmod(int(cell), self.grid.cells[1])
        return GRADES[int(self.inner[row, column].any()) + int(self.outer[row, column].any())]

    def __call__(self, apices: NDArray[np.float64], stride_number: int = 0) -> dict[str, NDArray[np.float64]]:
        """Actions at the apices of many runners, by name: the controller is a law for a `Batch`."""
        cells = self.grid.cell_of(apices[:, : len(REDUCED)])
        best = np.full(len(apices), -1)
        for number in np.unique(cells[cells >= 0]):
            best[cells == number] = self._choice(int(number))
        actions = self.grid.all_actions()
        return {
            name: np.where(best >= 0, actions[name][best], wished)
            for name, wished in zip(self.grid.actions, self.wish, strict=True)
        }

    def as_table(self) -> list[tuple[str | float, ...]]:
        """The choice of each cell, as rows of a table.

        Returns
        -------
        list of tuple
            Names first; then of each cell its middle, its grade and what is set, in SI units.
        """
        rows, columns = (self.grid.centers(axis) for axis in self.grid.edges)
        middles = np.stack(np.meshgrid(rows, columns, indexing="ij"), axis=-1).reshape(-1, len(REDUCED))
        chosen = np.stack([values.tolist() for values in self(middles).values()], axis=-1)
        table: list[tuple[str | float, ...]] = [(*self.grid.edges, "grade", *self.grid.actions)]
        for middle, values in zip(middles, chosen, strict=True):
            table.append((*middle.tolist(), self.grade_at(middle), *values.tolist()))
        return table

    def _choice(self, cell: int) -> int:
        """The number of the action for a cell, -1 for none."""
        row, column = divmod(cell, self.grid.cells[1])
        viable = next((of[row, column] for of in (self.inner, self.outer) if of[row, column].any()), None)
        if viable is None:
            return -1
        return int(np.argmin(np.where(viable, self._distances(), np.inf)))

    def _distances(self) -> NDArray[np.float64]:
        """Squared distance of each action from the wish, over the ranges."""
        distances = np.zeros(self.grid.action_count)
        for (name, values), wished in zip(self.grid.all_actions().items(), self.wish, strict=True):
            width = np.ptp(self.grid.actions[name]) or 1.0
            distances += ((values - wished) / width) ** 2
        return distances
