"""Viable sets: states, pairs, and how much room each state leaves."""

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..library.gait import Gait
from ..library.runner import Runner
from ..library.section import REDUCED, Apex
from .boxes import Boxes, boxes_of, strides_to
from .controller import ViableController
from .disturbances import FrictionLoss, friction_loss, largest_drop
from .grid import Grid, Transitions, transitions_file
from .reached import Reached, target_of

if TYPE_CHECKING:
    import xarray

STATES = ("not_viable", "open", "viable")
"""Values of the dataset's `viable`: not in the outer set, in the outer one alone, in both."""


@dataclass(frozen=True, eq=False, repr=False)
class Viability:
    """Viable states and pairs of state and action, from inside and from outside.

    States are cells of the plane of apices, row by row of rising height; actions are combinations of
    settings, the last setting running fastest.
    """

    runner: Runner
    """Whose they are."""
    transitions: Transitions
    """The strides that they rest on."""
    factor: float
    """Factor of the derivatives at corners, by which a cell's image is estimated."""
    inner: NDArray[np.bool_]
    """Pairs of the inner set, shape (rows, columns, actions)."""
    outer: NDArray[np.bool_]
    """Pairs of the outer set, of the same shape: all of the inner one, and what the grid leaves open."""
    inner_passes: int
    """In which the inner set was found."""
    outer_passes: int
    """Likewise the outer one."""

    @property
    def grid(self) -> Grid:
        """Cells and actions."""
        return self.transitions.grid

    @property
    def inner_states(self) -> NDArray[np.bool_]:
        """Cells from all of which some action leads into such cells, by estimate; shape (rows, columns)."""
        states: NDArray[np.bool_] = np.any(self.inner, axis=2)
        return states

    @property
    def outer_states(self) -> NDArray[np.bool_]:
        """Cells from some of which an action may lead into such cells; shape (rows, columns)."""
        states: NDArray[np.bool_] = np.any(self.outer, axis=2)
        return states

    @property
    def inner_share(self) -> float:
        """Share of the cells that are in the inner set."""
        return float(self.inner_states.mean())

    @property
    def outer_share(self) -> float:
        """Share of the cells that are in the outer set."""
        return float(self.outer_states.mean())

    @property
    def inner_robustness(self) -> NDArray[np.float64]:
        """Share of a cell's actions that are viable, from inside: Heim's measure; shape (rows, columns)."""
        shares: NDArray[np.float64] = self.inner.mean(axis=2)
        return shares

    @property
    def outer_robustness(self) -> NDArray[np.float64]:
        """The same from outside."""
        shares: NDArray[np.float64] = self.outer.mean(axis=2)
        return shares

    def controller(self, wish: Mapping[str, float] | None = None) -> ViableController:
        """A law that sets at each apex the viable action nearest to a wish.

        Parameters
        ----------
        wish : mapping of str to float, optional
            By setting, in its unit; by default what the runner has.

        Returns
        -------
        ViableController
            As `stride_map` takes a law.

        Raises
        ------
        InputError
            The wish names something else than the settings, or is out of their ranges.
        """
        return ViableController.of(self.grid, self.inner, self.outer, self.runner, wish)

    def reached(self, gait: Gait | Apex, *, within: float = 3.0) -> Reached:
        """From which states some choice of actions leads to a gait, and in how many strides at the least.

        Parameters
        ----------
        gait : Gait or sequence of float
            Its apex, or a gait that has one.
        within : float, default 3
            Distance from the apex, in sides of a cell along each axis, at which it counts as reached: a cell
            does of which every point is as near.

        Returns
        -------
        Reached
            Strides for sure by whole cells, and perhaps; both by the estimates of the sets.

        Raises
        ------
        InputError
            No cell is as near to the apex.
        """
        target = target_of(self.grid, gait, within)
        strides = {
            name: strides_to(self._boxes(name == "inner"), target, inner=name == "inner")
            for name in ("inner", "outer")
        }
        return Reached(target, **strides)

    def largest_drop(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The largest drop of the ground at the apex, after which the runner is still in a viable state.

        A drop adds to the height above the ground, so that this is how far the viable cells above a cell
        go without a gap; a drop that leaves the range is not counted.

        Returns
        -------
        inner, outer : ndarray of float, shape (rows, columns)
            m; from the inner set what any point of the cell stands, from the outer one what none does more
            than. NaN where the cell itself is in neither.
        """
        return largest_drop(self.inner_states, self.grid, inner=True), largest_drop(
            self.outer_states, self.grid, inner=False
        )

    def friction_loss(
        self, frictions: Sequence[float], *, executor: Executor | None = None, progress: bool = False
    ) -> FrictionLoss:
        """The least friction of the next stride from which some action leads back into the viable set.

        After that stride the friction is the runner's own again. All strides are made anew at each friction.

        Parameters
        ----------
        frictions : sequence of float
            Those that are tried, falling, below the runner's own.
        executor : concurrent.futures.Executor, optional
            Runs blocks of the work, such as a `ProcessPoolExecutor()` or `client.get_executor()` of Dask;
            by default threads of this process. The result does not depend on the executor.
        progress : bool, default False
            A bar on stderr.

        Returns
        -------
        FrictionLoss
            Of each cell.

        Raises
        ------
        InputError
            They are not falling, or out of range.
        """
        return friction_loss(
            self.runner,
            self.transitions,
            self.factor,
            (self.inner_states, self.outer_states),
            frictions,
            executor=executor,
            progress=progress,
        )

    def to_dataset(self) -> "xarray.Dataset":
        """Sets, robustness and the strides that they rest on, as a dataset.

        Returns
        -------
        xarray.Dataset
            Over the middles of the cells `viable`, by its flags, `inner_robustness` and `outer_robustness`;
            over these and the settings `viable_pair`, by the same flags; over corners and settings `fate`
            and the next height and speed.
        """
        grid = self.grid
        made, shape = self.transitions, (*grid.nodes, *grid.action_shape)
        data = transitions_file(self.runner, grid).data
        data["fate"].values[...] = made.fate.reshape(shape)
        for number, axis in enumerate(REDUCED):
            data[f"next_{axis}"].values[...] = made.next_apex[number].reshape(shape)
        over = tuple(grid.edges)
        shape = (*grid.cells, *grid.action_shape)
        levels = {
            "viable": (over, self.inner_states + self.outer_states.astype(np.int8)),
            "viable_pair": ((*over, *grid.actions), (self.inner + self.outer.astype(np.int8)).reshape(shape)),
            "inner_robustness": (over, self.inner_robustness),
            "outer_robustness": (over, self.outer_robustness),
        }
        data = data.assign(levels).assign_coords({axis: grid.centers(axis) for axis in grid.edges})
        for name in ("viable", "viable_pair"):
            data[name].attrs = {
                "flag_values": np.arange(len(STATES), dtype=np.int8),
                "flag_meanings": " ".join(STATES),
            }
        for name in ("inner_robustness", "outer_robustness"):
            data[name].attrs = {"units": "1", "long_name": "share of actions that are viable"}
        data.attrs |= {
            "inner_share": self.inner_share,
            "outer_share": self.outer_share,
            "factor": self.factor,
        }
        return data

    def as_json(self) -> dict[str, object]:
        """Summary in a few numbers."""
        grid = self.grid
        return {
            **self.runner.record(),
            "axes": {axis: [float(edges[0]), float(edges[-1])] for axis, edges in grid.edges.items()},
            "vary": {name: [float(row[0]), float(row[-1]), len(row)] for name, row in grid.actions.items()},
            "cells": list(grid.cells),
            "actions": grid.action_count,
            "strides": self.transitions.fate.size,
            "closed": self.transitions.closed,
            "factor": self.factor,
            "inner_share": self.inner_share,
            "outer_share": self.outer_share,
            "inner_robustness": float(self.inner_robustness.mean()),
            "outer_robustness": float(self.outer_robustness.mean()),
            "inner_passes": self.inner_passes,
            "outer_passes": self.outer_passes,
        }

    def __repr__(self) -> str:
        """On one line."""
        rows, columns = self.grid.cells
        return (
            f"<Viability of {rows} by {columns} cells, {self.grid.action_count} actions of "
            f"{', '.join(self.grid.actions)}: {self.inner_share:.1%} to {self.outer_share:.1%} viable>"
        )

    def _boxes(self, inner: bool) -> Boxes:
        return boxes_of(self.transitions, self.runner.scales[: len(REDUCED)], self.factor, inner=inner)
