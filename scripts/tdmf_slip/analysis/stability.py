"""Gaits over a grid of parameters, each from a neighbour's: a sweep without borders, and much faster."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from ..errors import RunError
from ..library.fixed_point import gait_near
from ..library.gait import gaits_dataset
from ..library.runner import Runner
from ..variables.parameters import RunnerLike
from ..variables.variable import Values
from .search import periodic_gait
from .sweeps import checked_axes

if TYPE_CHECKING:
    import xarray


def stability(runner: RunnerLike, vary: Mapping[str, Values]) -> xarray.Dataset:
    """Find the gait at each point of a grid, from the point nearest to the runner on to its neighbours.

    A point has no gait where Newton's method finds none from any of its neighbours. Where there are several
    gaits, it is the one that the neighbours lead to.

    Parameters
    ----------
    runner : runner
        The runner whose values all points share.
    vary : mapping of str to array
        The grid: values of each parameter or input.

    Returns
    -------
    xarray.Dataset
        The gaits, as those of `sweep`: word, eigenvalues and quantities of a stride at each point.

    Raises
    ------
    InputError
        A name or value is not allowed.
    GaitNotFoundError
        The point nearest to the runner has no gait.

    Examples
    --------
    >>> import tdmf_slip
    >>> runner = tdmf_slip.Runner(model="reduced")
    >>> plane = tdmf_slip.stability(runner, {"leg.damping": [0.1, 0.2], "friction": [0.4, 0.6]})
    >>> dict(plane["lambda_max"].sizes)
    {'leg.damping': 2, 'ground.friction': 2}
    """
    runner = Runner(runner)
    axes = checked_axes(vary, runner.model)
    shape = tuple(map(len, axes.values()))

    def at(cell: tuple[int, ...]) -> Runner:
        values = zip(axes.values(), cell, strict=True)
        return runner.replace({name: float(row[k]) for name, (row, k) in zip(axes, values, strict=True)})

    first = tuple(int(np.argmin(np.abs(row - runner[name]))) for name, row in axes.items())
    found, edge = {first: periodic_gait(at(first))}, deque([first])
    steps = [tuple(int(k) for k in way * row) for row in np.eye(len(shape), dtype=int) for way in (1, -1)]
    while edge:
        known = edge.popleft()
        for cell in (tuple(map(sum, zip(known, step, strict=True))) for step in steps):
            if cell in found or not all(0 <= k < count for k, count in zip(cell, shape, strict=True)):
                continue
            try:
                found[cell] = gait_near(at(cell), found[known].apex)
            except RunError:
                continue
            edge.append(cell)
    return gaits_dataset("sweep", [found.get(cell) for cell in np.ndindex(*shape)], axes, runner)
