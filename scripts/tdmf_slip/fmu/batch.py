"""Many runs of the unit, by FMPy, one for each of many runners: here or on a Dask cluster."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from functools import partial
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from ..blocks import in_order
from ..checks import checked, checked_whole
from ..errors import InputError, TdmfSlipError
from ..given import row_of, rows_of
from ..record import dataset, origin_of
from ..terminal.in_blocks import in_blocks
from ..variables.parameters import RunnerLike, start_values_of
from ..variables.variable import Value
from .fmu import Fmu, load_fmu
from .simulation import DEFAULT_STRIDES, DEFAULT_TOLERANCE, MAX_STRIDES, TOLERANCES, run_unit

if TYPE_CHECKING:
    import xarray


Result: TypeAlias = tuple[Mapping[str, float | int | str], bool, str]
"""End of a run: its last stride, whether it fell, and the reason if there is no result."""
OVER = ("run",)
"""The dimension of all arrays."""


def run_one(strides: int, tolerance: float, interface: str, starts: Mapping[str, Value]) -> Result:
    """One run of the unit. A run that fails is a result, too: the others go on."""
    try:
        run = run_unit(starts, strides=strides, tolerance=tolerance, interface=interface)
    except TdmfSlipError as problem:  # the unit may refuse how several values go together
        return {}, False, str(problem)
    return run.stride, run.fallen, ""


def simulate_many(
    runners: Sequence[RunnerLike],
    *,
    strides: int = DEFAULT_STRIDES,
    tolerance: float = DEFAULT_TOLERANCE,
    interface: str = "cs",
    executor: Executor | None = None,
    progress: bool = False,
    fmu: Fmu | None = None,
) -> xarray.Dataset:
    """Run the unit once for each of many runners.

    Parameters
    ----------
    runners : sequence of runners, or a table with a row for each
        Each as in `simulate`. A value that one of them names and another does not is the unit's own there.
    strides : int, default 10
        Number of strides of each run.
    tolerance : as in `simulate`
    interface : str, default 'cs'
        `me` or `cs`.
    executor, progress : as in `sweep`
    fmu : Fmu, optional
        Unit that checks the runners before anything is run.

    Returns
    -------
    xarray.Dataset
        Over the dimension `run`: what the runners name as coordinates, the last stride's quantities with
        their units, `fallen`, and `problem`, empty where there was none.

    Raises
    ------
    InputError
        There is no runner, or a value is not allowed.

    Examples
    --------
    >>> import tdmf_slip
    >>> runners = [{"ground.friction": 0.6}, {"ground.friction": 1.2}]
    >>> runs = tdmf_slip.simulate_many(runners, strides=2)
    >>> print(runs["speed"].values.round(3), runs["fallen"].values)
    [1.061 1.05 ] [False False]
    """
    fmu = load_fmu(fmu)
    fmu.require_interface(interface)
    checked_whole("strides", strides, 1, MAX_STRIDES)
    checked("tolerance", tolerance, *TOLERANCES)
    allowed = "one or more runners in a list, or a table with a row for each"
    given = row_of(rows_of(runners, "runners"), "runners", allowed)
    if not len(given):
        raise InputError(f"runners: none; allowed: {allowed}")
    starts = [
        fmu.variables.start_values(start_values_of(row), f"runner {number}")
        for number, row in enumerate(given)
    ]
    work = partial(run_one, strides, tolerance, interface)
    with in_blocks(work, starts, "batch", "runs", executor, progress) as finished:
        results = in_order(finished)
    return _runs(starts, results, fmu)


def _runs(starts: Sequence[Mapping[str, Value]], results: Sequence[Result], fmu: Fmu) -> xarray.Dataset:
    names = list(dict.fromkeys(name for its in starts for name in its))
    alike = {name: value for name, value in fmu.variables.all_start_values({}).items() if name not in names}
    arrays: dict[str, tuple[Any, ...]] = {
        "fallen": (OVER, [fallen for _, fallen, _ in results]),
        "problem": (OVER, np.array([problem for *_, problem in results], dtype=object)),
    }
    for variable in fmu.variables.group("stride"):
        is_text = variable.type == "String"
        values = [stride.get(variable.member, "" if is_text else np.nan) for stride, *_ in results]
        arrays[variable.member] = (
            OVER,
            np.array(values, dtype=object if is_text else float),
            variable.attributes,
        )
    given = {name: (OVER, [fmu.variables.start_of(name, its) for its in starts]) for name in names}
    return dataset("runs", {**origin_of(version=fmu.version), "start_values": alike}, arrays, given)
