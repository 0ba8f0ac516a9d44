"""The grid of a viable set: cells of a plane of apices, and actions to choose from at each."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..checks import check_kind, check_size, checked_whole
from ..errors import InputError
from ..given import counts_given, ends_given, mapping_of, row_of
from ..library.runner import Runner
from ..library.section import REDUCED, check_axes
from ..library.settings import check_acts, checked_values, setting_number
from ..variables.table import VARIABLES, by_full_name

MAX_CELLS = 2048
"""Largest number of cells along an axis."""
MAX_ACTIONS = 4096
"""Largest number of values of one setting."""
MAX_STRIDES = 50_000_000
"""In all: those of that many take 1.5 GB, and are made in two to four minutes by two processors."""
VALUES = 16
"""Number of values of a setting, by default."""


@dataclass(frozen=True, eq=False)
class Grid:
    """Cells over the two coordinates of the reduced map, and what may be set at each apex."""

    edges: Mapping[str, NDArray[np.float64]]
    """By coordinate: borders of the cells, rising, shape (cells + 1,)."""
    actions: Mapping[str, NDArray[np.float64]]
    """By setting: values to choose from, shape (values,). An action has one of each."""

    @property
    def cells(self) -> tuple[int, int]:
        """How many along each coordinate."""
        rows, columns = (len(edges) - 1 for edges in self.edges.values())
        return rows, columns

    @property
    def nodes(self) -> tuple[int, int]:
        """How many corners of cells along each coordinate."""
        return self.cells[0] + 1, self.cells[1] + 1

    @property
    def action_shape(self) -> tuple[int, ...]:
        """How many values of each setting."""
        return tuple(len(values) for values in self.actions.values())

    @property
    def action_count(self) -> int:
        """Number of all combinations of settings."""
        return math.prod(self.action_shape)

    @property
    def sizes(self) -> NDArray[np.float64]:
        """Sizes of a cell along each coordinate, shape (2,)."""
        return np.array([edges[1] - edges[0] for edges in self.edges.values()])

    @property
    def origin(self) -> NDArray[np.float64]:
        """The lowest corner, shape (2,)."""
        return np.array([edges[0] for edges in self.edges.values()])

    def all_actions(self) -> dict[str, NDArray[np.float64]]:
        """Each action's value of each setting, shape (actions,), the last setting running fastest."""
        mesh = np.meshgrid(*self.actions.values(), indexing="ij")
        return {name: values.ravel() for name, values in zip(self.actions, mesh, strict=True)}

    def centers(self, axis: str) -> NDArray[np.float64]:
        """Middles of the cells along a coordinate, shape (cells,)."""
        edges = self.edges[axis]
        middles: NDArray[np.float64] = 0.5 * (edges[1:] + edges[:-1])
        return middles

    def cell_of(self, apices: NDArray[np.float64]) -> NDArray[np.intp]:
        """The cells that hold apices."""
        indices = np.floor((apices - self.origin) / self.sizes)
        inside: NDArray[np.bool_] = np.logical_and.reduce((indices >= 0) & (indices < self.cells), axis=1)
        rows, columns = np.where(inside[:, np.newaxis], indices, 0).astype(np.intp).T
        return np.where(inside, rows * self.cells[1] + columns, -1)


def grid_of(runner: Runner, axes: Any, vary: Any, n: Any) -> Grid:
    """The grid that is asked for."""
    ranges = mapping_of(axes, "axes", "a mapping of both coordinates to ranges (low, high)")
    check_axes(tuple(ranges), REDUCED)
    missing = next((axis for axis in REDUCED if axis not in ranges), None)
    if missing is not None:
        raise InputError(f"axes: without {missing}; allowed: ranges of {' and '.join(REDUCED)}")
    counts = counts_given(n, MAX_CELLS)
    edges = {
        axis: np.linspace(*ends_given(f"axes: {axis}", ranges[axis]), count + 1)
        for axis, count in zip(REDUCED, counts, strict=True)
    }
    for axis, along in edges.items():
        VARIABLES[f"apex.{axis}"].values_of(along, f"axes: {axis}")
    grid = Grid(edges, _actions(runner, vary))
    check_size("grid", math.prod(grid.nodes) * grid.action_count, "strides", MAX_STRIDES)
    return grid


def _actions(runner: Runner, vary: Any) -> dict[str, NDArray[np.float64]]:
    ranges = by_full_name(vary, "vary", "a mapping of settings to ranges (low, high) or (low, high, values)")
    if not ranges:
        raise InputError("vary: nothing; allowed: one or more settings with their ranges")
    actions: dict[str, NDArray[np.float64]] = {}
    for name, span in ranges.items():
        setting_number(name, "vary")
        check_acts(name, runner, tuple(ranges), "vary")
        what = f"vary: {name}"
        row = row_of(span, what, "(low, high) or (low, high, values)")
        count = checked_whole(f"{what}: values", row[2], 1, MAX_ACTIONS) if len(row) == 3 else VALUES
        low, high = ends_given(what, row[:2] if len(row) == 3 else row, may_be_one=count == 1)
        actions[name] = checked_values(name, np.linspace(low, high, count), "vary", {"value": 0})
    return actions


def starts_at(runner: Runner, apices: NDArray[np.float64]) -> NDArray[np.float64]:
    """Apices of the runner's own map at heights and speeds.

    Of the full model the leg is at rest where the runner's own settings have placed it, as long as it is
    unloaded: what the last placement leaves.
    """
    check_kind(runner, Runner, "runner", "a Runner")
    if runner.reduced:
        return apices
    state = Runner(runner, model="reduced").state_at([1.0, 0.0])
    leg = [state[f"leg.{name}"] for name in ("length", "angle", "length_rate", "angle_rate")]
    return np.column_stack([apices, np.tile(leg, (len(apices), 1))])
