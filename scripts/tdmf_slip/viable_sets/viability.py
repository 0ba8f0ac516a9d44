"""The viable set of a runner on a grid: found from inside and from outside."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..checks import checked
from ..files.whole import check_destination
from ..library.return_map import refuse_patch
from ..library.runner import Runner
from ..variables.parameters import RunnerLike
from .boxes import Boxes, boxes_of, largest_kept
from .grid import Grid, Transitions, grid_of, make_transitions, transitions_file
from .result import Viability

FACTOR = 1.5
"""Factor of the derivatives at corners, by default."""
LARGEST_FACTOR = 100.0


def viability(
    runner: RunnerLike = None,
    *,
    axes: Mapping[str, tuple[float, float]],
    vary: Mapping[str, Sequence[float]],
    n: int | tuple[int, int] = 64,
    model: str = "reduced",
    factor: float = FACTOR,
    path: Path | str | None = None,
    executor: Executor | None = None,
    progress: bool = False,
) -> Viability:
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
    Viability
        Both sets of states and of pairs of state and action.

    Raises
    ------
    InputError
        A range, a name or a number is not allowed, the ground has a patch, or the file holds something else.

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
    >>> chosen = found.controller().inputs_at([1.4, 1.05])
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
    file = transitions_file(runner, grid, path)
    found = viable_sets(
        runner, make_transitions(runner, grid, file, executor=executor, progress=progress), factor
    )
    if path is not None:
        file.finish(found.to_dataset())
    return found


def viable_sets(runner: Runner, transitions: Transitions, factor: float) -> Viability:
    """Both sets from transitions that are made."""
    grid = transitions.grid
    kept: dict[str, Any] = {}
    for name in ("inner", "outer"):
        boxes = boxes_of(transitions, runner.scales[:2], factor, inner=name == "inner")
        found = largest_kept(boxes, grid.cells, inner=name == "inner")
        kept[name] = _pairs(grid, boxes, found.pairs)
        kept[f"{name}_passes"] = found.passes
    return Viability(runner, transitions, factor, **kept)


def _pairs(grid: Grid, boxes: Boxes, numbers: NDArray[np.intp]) -> NDArray[np.bool_]:
    """Pairs as a table of cells and actions."""
    pairs = np.zeros((*grid.cells, grid.action_count), bool)
    pairs.reshape(-1, grid.action_count)[boxes.cells[numbers], boxes.actions[numbers]] = True
    return pairs
