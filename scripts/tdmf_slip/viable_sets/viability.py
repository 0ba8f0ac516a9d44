"""Viable set of a runner on a grid, enclosed by an inner and an outer set."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..analysis.search import periodic_gait
from ..checks import check_names, checked, refusal
from ..errors import InputError
from ..files.resume import Resumed
from ..files.whole import check_destination
from ..given import numbers_of
from ..library.gait import Gait
from ..library.return_map import refuse_patch
from ..library.runner import Runner
from ..library.section import REDUCED, Apex, checked_apex
from ..record import runner_in
from ..variables.parameters import RunnerLike
from ..variables.table import by_full_name, model_of, model_recorded
from ..variables.variable import Given
from .grid import (
    STRIDES_IN_A_BLOCK,
    Grid,
    boxes_of,
    grid_of,
    largest_kept,
    no_transitions,
    strides_of,
    strides_to,
)

if TYPE_CHECKING:
    import xarray

GRADES = ("not viable", "open", "viable")
"""Grades of a choice: no action of the cell is viable, one of the outer set is, one of the inner set is."""


class ViableController:
    """Law that sets, at each apex, the viable action nearest to a wish, over the ranges of the settings.

    Actions are those of the inner set if the cell of the apex has any, else those of the outer set. If
    neither has any, or outside of the grid, no action is known to help, and the wish itself is set.
    `grade_at` reports which case holds.

    Parameters
    ----------
    viable : xarray.Dataset
        Viable set, as `viability` gives it.
    wish : mapping of str to float, optional
        Wished value of each setting, in its unit; by default the runner's own.

    Raises
    ------
    InputError
        The dataset is no viable set, the wish has an unknown name, or a value is out of its setting's range.

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
        pairs, (first, second, *names) = viable["viable_pair"].values, viable["viable_pair"].dims
        self.grid = Grid(
            {str(axis): viable[f"{axis}_edge"].values for axis in (first, second)},
            {str(name): viable[name].values for name in names},
        )
        runner = Runner(runner_in(viable), model=model_recorded(viable.attrs))
        self.columns = self.grid.columns(runner)
        given = by_full_name(wish, "wish", "a mapping of settings to numbers", runner.model.aliases)
        check_names(given, (*self.grid.actions,), "wish")
        self.wish = tuple(
            float(runner.model.variables[name].value_of(given.get(name, runner[name]), "wish"))
            for name in self.grid.actions
        )
        distances = sum(
            ((values - wished) / (np.ptp(values) or 1.0)) ** 2
            for values, wished in zip(self.grid.all_actions().values(), self.wish, strict=True)
        )
        levels = pairs.reshape(-1, self.grid.action_count)
        self.levels = levels.max(axis=1)
        nearest_first = np.argsort(distances, kind="stable")
        self._choices = nearest_first[(levels == self.levels[:, None])[:, nearest_first].argmax(axis=1)]

    def inputs_at(self, apex: ArrayLike) -> dict[str, float]:
        """Settings at one apex.

        Parameters
        ----------
        apex : sequence of float
            Coordinates in the order of the section. Those that are no axes of the viable set are ignored.

        Returns
        -------
        dict of str to float
            Value by setting, in its unit.
        """
        return {name: float(values[0]) for name, values in self._settings(self._cell(apex)).items()}

    def grade_at(self, apex: ArrayLike) -> str:
        """Grade of the choice at an apex: one of `GRADES`.

        Parameters
        ----------
        apex : sequence of float
            As in `inputs_at`.

        Returns
        -------
        str
            `viable`, `open` or `not viable`.
        """
        cell = int(self._cell(apex)[0])
        return GRADES[self.levels[cell] if cell >= 0 else 0]

    def _cell(self, apex: ArrayLike) -> NDArray[np.intp]:
        """Number of the cell that holds an apex, -1 outside of the grid, shape (1,)."""
        allowed = f"the coordinates of an apex, among them {' and '.join(self.grid.edges)}"
        values = numbers_of("apex", apex, allowed)
        if values.ndim != 1 or len(values) <= max(self.columns):
            raise refusal("apex", apex, allowed)
        return self.grid.cell_of(values[None, self.columns])

    def __call__(self, apices: NDArray[np.float64], stride_number: int = 0) -> dict[str, NDArray[np.float64]]:
        """Actions at the apices of many runners, by name: the controller is a law for a `Batch`."""
        return self._settings(self.grid.cell_of(apices[:, self.columns]))

    def _settings(self, cells: NDArray[np.intp]) -> dict[str, NDArray[np.float64]]:
        """Values of the settings in cells, by name; cell -1 is outside of the grid."""
        is_known, actions = (cells >= 0) & (self.levels[cells] > 0), self.grid.all_actions()
        return {
            name: np.where(is_known, actions[name][self._choices[cells]], wished)
            for name, wished in zip(self.grid.actions, self.wish, strict=True)
        }

    def as_table(self) -> list[tuple[str | float, ...]]:
        """Choices of all cells, as rows of a table.

        Returns
        -------
        list of tuple
            Names first, then a row for each cell: its middle, its grade and its settings, in SI units.
        """
        rows, columns = (self.grid.centers(axis) for axis in self.grid.edges)
        middles = np.stack(np.meshgrid(rows, columns, indexing="ij"), axis=-1).reshape(-1, 2)
        chosen = np.stack([*self._settings(np.arange(len(middles))).values()], axis=-1)
        table: list[tuple[str | float, ...]] = [(*self.grid.edges, "grade", *self.grid.actions)]
        for middle, level, values in zip(middles, self.levels, chosen, strict=True):
            table.append((*middle.tolist(), GRADES[level], *values.tolist()))
        return table


FACTOR = 1.5
"""Factor of the derivatives at corners, by default."""
LARGEST_FACTOR = 100.0
STATES = ("not_viable", "open", "viable")
"""Values of `viable`: not in the outer set, in the outer one alone, in both."""
NEAR = 3.0
"""Distance from a gait's apex, in sides of a cell along each axis, at which it counts as reached."""


def viability(
    runner: RunnerLike = None,
    *,
    axes: Mapping[str, tuple[float, float]],
    vary: Mapping[str, Sequence[float]],
    n: int | tuple[int, int] = 64,
    model: str = "reduced",
    factor: float = FACTOR,
    gait: Gait | Apex | None = None,
    path: Path | str | None = None,
    executor: Executor | None = None,
    progress: bool = False,
) -> xarray.Dataset:
    """Compute the viable set: the apices from which some choice of actions avoids a fall forever.

    At each apex one of a finite number of actions is chosen. A cell of the plane of apices is viable while
    some action leads from there to a viable cell; leaving the ranges counts as a failure. Two sets enclose
    the set of Heim and Badri-Sproewitz (2019). In the inner set, an action counts only if it leads the whole
    cell into cells of the set. In the outer set, it counts if it may lead a part of the cell into one. The
    image of a cell is estimated from derivatives at its corners, so both sets are estimates, not proofs.
    Cells in the outer set alone are open: the grid is too coarse to classify them.

    Parameters
    ----------
    runner : as in `find_gait`
    axes : mapping of str to (float, float)
        Ranges of `com_height`, m, and `com_speed`, m/s, at the apex; of a model of one's own ranges of any
        two coordinates of its section.
    vary : mapping of str to (low, high) or (low, high, values)
        Settings that are chosen at each apex, by names of `library.settings.SETTINGS`, with their ranges and
        the number of values, by default 16.
    n : int or pair of int, default 64
        Cells along each axis.
    model : str, default 'reduced'
        Map from apex to apex. In the `reduced` map, height and speed describe an apex. In the `full` map,
        each stride starts with the leg at rest, unloaded, where the runner's own settings place it.

        A model of one's own has its own map. Coordinates that are no axes are those of the given gait, or
        else of the gait that `find_gait` finds.
    factor : float, default 1.5
        Safety factor, at least 1: derivatives within a cell are assumed to be at most this many times the
        largest at its corners. Those are estimated by differences between neighbouring corners.
    gait : Gait or sequence of float, optional
        A gait, or its apex. The result then also has the fewest strides from each cell to the gait. A
        cell is at the gait if all of its points are within three sides of a cell of the apex.
    path : Path or str, optional
        NetCDF file (.nc) for the sets and the strides behind them. An existing file is resumed.
    executor, progress : as in `sweep`

    Returns
    -------
    xarray.Dataset
        Over the middles of the cells:

        - `viable`, as flags, and `viable_pair`, also over the settings;
        - `inner_robustness` and `outer_robustness`, the share of actions that are viable: Heim's measure;
        - `inner_drop` and `outer_drop`, m: the largest drop of the ground at the apex that leaves a viable
          state, for all points of the cell, and for some; NaN outside of the set; only over `com_height`;
        - with a gait `inner_strides` and `outer_strides`, -1 where no actions lead to it, and `at_gait`.

        Over the corners of the cells and the settings: `fate` and the next height and speed. The shares of
        cells in both sets are the attributes `inner_share` and `outer_share`.

    Raises
    ------
    InputError
        A range, a name or a number is not allowed, the ground has a patch, no cell is near the gait, or the
        file holds something else.

    Examples
    --------
    >>> import tdmf_slip
    >>> found = tdmf_slip.viability(
    ...     {"ground.friction": 0.6},
    ...     axes={"com_height": (1.0, 2.0), "com_speed": (0.6, 1.6)},
    ...     vary={"hip.touchdown_angle": (0.3, 1.1, 12), "hip.stance_torque": (0.05, 0.4, 6)},
    ...     n=24,
    ... )
    >>> bool(0.3 < found.inner_share <= found.outer_share <= 1)
    True
    >>> chosen = tdmf_slip.ViableController(found).inputs_at([1.4, 1.05])
    >>> list(chosen)
    ['hip.touchdown_angle', 'hip.stance_torque']

    References
    ----------
    S. Heim and A. Badri-Sproewitz, Beyond Basins of Attraction: Quantifying Robustness of Natural Dynamics,
    IEEE Transactions on Robotics 2019, doi 10.1109/TRO.2019.2910739.
    """
    runner = Runner(runner, model=None if model_of(runner, None).is_page else model)
    refuse_patch(runner)
    factor = checked("factor", factor, 1.0, LARGEST_FACTOR)
    path = None if path is None else check_destination(path, (".nc",), "path")
    grid = grid_of(runner, axes, vary, n)
    target = None if gait is None else _cells_about(runner, grid, gait)
    point = point_of(runner, tuple(grid.edges), gait)
    blank = no_transitions(runner, grid, point)
    file = Resumed(path, blank, "viable set")
    work, row_size = partial(strides_of, runner, grid, point), grid.nodes[1] * grid.action_count
    file.fill_rows(work, max(1, STRIDES_IN_A_BLOCK // row_size), "strides", "strides", executor, progress)
    found = _with_sets(file.data[[*blank.data_vars]], runner, grid, factor, target)
    file.finish(found)
    return found


def _with_sets(
    data: xarray.Dataset, runner: Runner, grid: Grid, factor: float, target: NDArray[np.bool_] | None
) -> xarray.Dataset:
    """Dataset of the transitions and both sets."""
    over, flat = tuple(grid.edges), (*grid.nodes, grid.action_count)
    images = [data[f"next_{axis}"].values.reshape(flat) for axis in grid.edges]
    scales = runner.scales[grid.columns(runner)]
    attributes: dict[str, Any] = {"factor": factor}
    levels = np.zeros((*grid.cells, grid.action_count), np.int8)
    arrays: dict[str, Any] = {}
    for name in ("inner", "outer"):
        boxes = boxes_of(grid, images, scales, factor, inner=name == "inner")
        kept = largest_kept(boxes, grid.cells, inner=name == "inner")
        pairs = np.zeros((*grid.cells, grid.action_count), bool)
        pairs.reshape(-1, grid.action_count)[boxes.cells[kept.pairs], boxes.actions[kept.pairs]] = True
        states: NDArray[np.bool_] = np.any(pairs, axis=2)
        levels += pairs
        about = {"units": "1", "long_name": "share of actions that are viable"}
        arrays[f"{name}_robustness"] = over, pairs.mean(axis=2), about
        if REDUCED[0] == over[0]:
            about = {"units": "m", "long_name": "largest drop of the ground that leaves a viable state"}
            arrays[f"{name}_drop"] = over, _largest_drop(states, grid, inner=name == "inner"), about
        attributes |= {f"{name}_share": float(states.mean()), f"{name}_passes": kept.passes}
        if target is not None:
            strides = strides_to(boxes, target, inner=name == "inner")
            about = {"units": "1", "long_name": "fewest strides to the gait, -1 for none"}
            arrays[f"{name}_strides"] = over, strides, about
    flags = {"flag_values": np.arange(len(STATES), dtype=np.int8), "flag_meanings": " ".join(STATES)}
    arrays["viable"] = over, levels.max(axis=2), flags
    arrays["viable_pair"] = (*over, *grid.actions), levels.reshape(*grid.cells, *grid.action_shape), flags
    if target is not None:
        arrays["at_gait"] = over, target.astype(np.int8), {"long_name": "1 where the gait is reached"}
    return (
        data.assign(arrays)
        .assign_coords({axis: grid.centers(axis) for axis in grid.edges})
        .assign_attrs(attributes)
    )


def _largest_drop(states: NDArray[np.bool_], grid: Grid, *, inner: bool) -> NDArray[np.float64]:
    """Height of the cells of a set above each cell; a drop of the ground adds to the height."""
    above = np.zeros(states.shape)
    for row in range(len(states) - 2, -1, -1):
        above[row] = np.where(states[row + 1], above[row + 1] + 1.0, 0.0)
    return np.where(states, (above if inner else above + 1.0) * grid.sizes[0], np.nan)


def point_of(runner: Runner, axes: Sequence[str], gait: Gait | Apex | None) -> NDArray[np.float64]:
    """Point of the section that gives all starts their coordinates other than the axes.

    In the full model, the unloaded leg is at rest where the runner's own settings place it. In a model of
    one's own, the point is the apex of the given gait, or else of the gait that `find_gait` finds.
    """
    if len(runner.coordinates) == len(axes):
        return np.zeros(len(axes))
    if runner.model.is_page:
        apex = periodic_gait(runner) if gait is None else gait
        return np.array(apex.apex if isinstance(apex, Gait) else checked_apex(apex, runner.coordinates))
    state = Runner(runner, model="reduced").state_at([1.0, 0.0])
    leg = [state[f"leg.{name}"] for name in ("length", "angle", "length_rate", "angle_rate")]
    return np.array([1.0, 0.0, *leg])


def _cells_about(runner: Runner, grid: Grid, gait: Gait | Apex) -> NDArray[np.bool_]:
    """Mask of the cells about the apex of a gait."""
    allowed = "a Gait, or the coordinates of an apex"
    apex = gait.apex if isinstance(gait, Gait) else np.atleast_1d(numbers_of("gait", gait, allowed))
    if apex.ndim != 1 or not np.isfinite(apex).all():
        raise refusal("gait", gait, allowed)
    if runner.model.is_page:
        point = checked_apex(apex, runner.coordinates)[grid.columns(runner)]
    else:
        point = checked_apex(apex[: len(REDUCED)], REDUCED)
    near = [
        (edges[:-1] >= at - NEAR * size) & (edges[1:] <= at + NEAR * size)
        for edges, at, size in zip(grid.edges.values(), point, grid.sizes, strict=True)
    ]
    target: NDArray[np.bool_] = near[0][:, None] & near[1]
    if not target.any():
        raise InputError(
            f"gait: at {', '.join(f'{at:g}' for at in point)}: no cell is near; "
            "allowed: a gait within the ranges"
        )
    return target
