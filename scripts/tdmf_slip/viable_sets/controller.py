"""A law from apex to settings that keeps a runner viable: the viable action nearest to a wish."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import refusal, shown
from ..errors import InputError
from ..library.runner import Runner
from ..library.section import REDUCED
from ..record import runner_in
from ..variables.table import VARIABLES, by_full_name
from ..variables.variable import Given
from .grid import Grid

if TYPE_CHECKING:
    import xarray

GRADES = ("not viable", "open", "viable")
"""Grades of a choice: no action of the cell is viable, one of the outer set is, one of the inner set is."""


class ViableController:
    """At each apex the viable action nearest to a wish, over the ranges of the settings.

    Of the inner set where the apex's cell has some, else of the outer one. Where neither has any, or outside
    of the grid, nothing is known to help, and the wish itself is set; `grade_at` tells.

    Parameters
    ----------
    viable : xarray.Dataset
        Viable set, as `viability` gives it.
    wish : mapping of str to float, optional
        Wished value of each setting, in its unit; by default the runner's own.

    Raises
    ------
    InputError
        The dataset is no viable set, or the wish names something else, or is out of a setting's range.

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
    >>> law = tdmf_slip.ViableController(found)
    >>> apices = [1.2, 1.0, 1.0, 0.7, 0, 0]
    >>> run = tdmf_slip.stride_map(runner, apices, strides=20, law=law)
    >>> bool((run["fate"] == 0).all())
    True
    """

    def __init__(self, viable: xarray.Dataset, wish: Mapping[str, Given] | None = None) -> None:
        if getattr(viable, "attrs", {}).get("result") != "viability" or "viable_pair" not in viable:
            raise refusal("viable", viable, "a viable set, with all its variables and attributes")
        pairs, names = viable["viable_pair"].values, viable["viable_pair"].dims[len(REDUCED) :]
        self.grid = Grid(
            {axis: viable[f"{axis}_edge"].values for axis in REDUCED},
            {str(name): viable[name].values for name in names},
        )
        levels = pairs.reshape(*self.grid.cells, self.grid.action_count)
        self.inner, self.outer = levels == 2, levels > 0
        given = by_full_name(wish, "wish", "a mapping of settings to numbers")
        unknown = next((name for name in given if name not in self.grid.actions), None)
        if unknown is not None:
            raise InputError(
                f"wish: {shown(unknown)} is not allowed; allowed: {', '.join(self.grid.actions)}"
            )
        runner = Runner(runner_in(viable), model=viable.attrs["model"])
        self.wish = tuple(
            float(VARIABLES[name].value_of(given.get(name, runner[name]), "wish"))
            for name in self.grid.actions
        )

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
