"""The viable set of a runner on a grid: found from inside and from outside."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..checks import checked, refusal
from ..errors import InputError
from ..files.whole import check_destination
from ..given import numbers_of
from ..library.gait import Gait
from ..library.return_map import refuse_patch
from ..library.runner import Runner
from ..library.section import REDUCED, Apex, checked_apex
from ..variables.parameters import RunnerLike
from .boxes import boxes_of, largest_kept, strides_to
from .grid import Grid, Transitions, grid_of, make_transitions, transitions_file

if TYPE_CHECKING:
    import xarray

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
    """From which apices some choice of actions avoids a fall for ever, and how much room the choice has.

    At each apex settings may be chosen anew from a finite number. A state, which is a cell of the plane of
    apices, is viable while some action leads from there to a viable state; leaving the ranges counts as a
    failure. The set of Heim and Badri-Sproewitz (2019) is enclosed: by an inner set, in which an action
    counts only where it leads the whole cell into cells that count, and by an outer one, in which it counts
    where it may lead some of the cell into one. Where a whole cell leads is estimated from derivatives at its
    corners, see `factor`; so both sets are estimates, not proofs. What is in the one and not in the other is
    left open by the grid.

    Parameters
    ----------
    runner : Runner, Gait, mapping of str to float, Series, str or Path, optional
        Parameters and inputs, or start values by name, over the unit's own.
    axes : mapping of str to (float, float)
        Ranges of `com_height`, m, and `com_speed`, m/s, at the apex.
    vary : mapping of str to (low, high) or (low, high, values)
        What may be chosen at each apex: names of `library.settings.SETTINGS`, as `hip.touchdown_angle`, with
        their ranges and, by default 16, the number of values in them.
    n : int or pair of int, default 64
        Cells along each axis.
    model : str, default 'reduced'
        Map from apex to apex: `reduced`, whose states are these planes; or `full`, whose other coordinates
        are at each apex taken to be those that the last placement leaves: a leg at rest, unloaded, where the
        runner's own settings place it.
    factor : float, default 1.5
        1 or above. Derivatives within a cell are taken to be no larger than this times the largest at its
        corners, which are differences to the neighbouring corners.
    gait : Gait or sequence of float, optional
        A gait, or its apex. The result then also has the fewest strides from each cell to the gait: to a
        cell all of whose points are within three sides of a cell of the apex.
    path : Path or str, optional
        NetCDF file for the sets and the strides that they rest on. Strides that are made are kept in a folder
        beside it, so that a job that stopped is resumed by the same call.
    executor : concurrent.futures.Executor, optional
        Runs blocks of the work, such as a `ProcessPoolExecutor()` or `client.get_executor()` of Dask; by
        default threads of this process. The result does not depend on the executor.
    progress : bool, default False
        A bar on stderr.

    Returns
    -------
    xarray.Dataset
        Over the middles of the cells:

        - `viable`, by its flags, and over the settings, too, `viable_pair`;
        - `inner_robustness` and `outer_robustness`, the share of actions that are viable: Heim's measure;
        - `inner_drop` and `outer_drop`, m: the largest drop of the ground at the apex that leaves a viable
          state, for all points of the cell, and for some; NaN outside of the set;
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
    runner = Runner(runner, model=model)
    refuse_patch(runner)
    factor = checked("factor", factor, 1.0, LARGEST_FACTOR)
    path = None if path is None else check_destination(path, (".nc",), "path")
    grid = grid_of(runner, axes, vary, n)
    target = None if gait is None else _cells_about(grid, gait)
    file = transitions_file(runner, grid, path)
    made = make_transitions(runner, grid, file, executor=executor, progress=progress)
    found = _sets(runner, made, factor, target, transitions_file(runner, grid).data)
    if path is not None:
        file.finish(found)
    return found


def _sets(
    runner: Runner,
    made: Transitions,
    factor: float,
    target: NDArray[np.bool_] | None,
    data: xarray.Dataset,
) -> xarray.Dataset:
    """Both sets from transitions that are made, with the transitions in a blank file's dataset."""
    grid = made.grid
    over, shape = tuple(grid.edges), (*grid.nodes, *grid.action_shape)
    data["fate"].values[...] = made.fate.reshape(shape)
    for number, axis in enumerate(REDUCED):
        data[f"next_{axis}"].values[...] = made.next_apex[number].reshape(shape)
    attributes: dict[str, Any] = {"factor": factor}
    levels = np.zeros((*grid.cells, grid.action_count), np.int8)
    arrays: dict[str, Any] = {}
    for name in ("inner", "outer"):
        boxes = boxes_of(made, runner.scales[: len(REDUCED)], factor, inner=name == "inner")
        kept = largest_kept(boxes, grid.cells, inner=name == "inner")
        pairs = np.zeros((*grid.cells, grid.action_count), bool)
        pairs.reshape(-1, grid.action_count)[boxes.cells[kept.pairs], boxes.actions[kept.pairs]] = True
        states: NDArray[np.bool_] = np.any(pairs, axis=2)
        levels += pairs
        about = {"units": "1", "long_name": "share of actions that are viable"}
        arrays[f"{name}_robustness"] = over, pairs.mean(axis=2), about
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
    """How far cells of a set go on above each cell: a drop adds to the height above the ground."""
    above = np.zeros(states.shape)
    for row in range(len(states) - 2, -1, -1):
        above[row] = np.where(states[row + 1], above[row + 1] + 1.0, 0.0)
    return np.where(states, (above if inner else above + 1.0) * grid.sizes[0], np.nan)


def _cells_about(grid: Grid, gait: Gait | Apex) -> NDArray[np.bool_]:
    """The cells about a gait's apex."""
    allowed = "a Gait, or the coordinates of an apex"
    apex = gait.apex if isinstance(gait, Gait) else np.atleast_1d(numbers_of("gait", gait, allowed))
    if apex.ndim != 1 or not np.isfinite(apex).all():
        raise refusal("gait", gait, allowed)
    point = checked_apex(apex[: len(REDUCED)], REDUCED)
    near = [
        (edges[:-1] >= at - NEAR * size) & (edges[1:] <= at + NEAR * size)
        for edges, at, size in zip(grid.edges.values(), point, grid.sizes, strict=True)
    ]
    target: NDArray[np.bool_] = near[0][:, None] & near[1]
    if not target.any():
        raise InputError(
            f"gait: at {', '.join(f'{at:g}' for at in point)}: no cell is as near; allowed: one in range"
        )
    return target
