"""Many runs of the unit, by FMPy, over a table of parameters: here or on a Dask cluster."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..blocks.running import run_blocks
from ..checks import checked, checked_whole
from ..contents import ByContents
from ..errors import InputError, TdmfSlipError
from ..files.datasets import xarray
from ..given import mapping_of, row_of, rows_of
from ..terminal.progress import progress_bar
from .simulation import DEFAULT_TOLERANCE, MOST_STRIDES, TOLERANCES, simulate
from .unit import Fmu, load_fmu
from .variable import Given, Value


@dataclass(frozen=True, eq=False)
class Job(ByContents):
    """A run: a block of work."""

    values: Mapping[str, Value]
    """Start values by name."""
    strides: int
    """How many."""
    tolerance: float
    """Of the solver."""
    interface: str
    """`me` or `cs`."""


@dataclass(frozen=True, eq=False)
class Result(ByContents):
    """How a run ended."""

    stride: Mapping[str, float | int | str]
    """The last completed stride, by the unit's names in the group `stride`."""
    fallen: bool
    """The run ended in a fall."""
    problem: str
    """Why there is no result, or nothing."""


NOT_RUN = Result({}, False, "")


def run_one(job: Job) -> Result:
    """One run of the unit. A run that fails is a result, too: the others go on."""
    try:
        run = simulate(
            job.values,
            strides=job.strides,
            tolerance=job.tolerance,
            interface=job.interface,
        )
    except TdmfSlipError as problem:  # the unit may refuse how several values go together
        return Result({}, False, str(problem))
    return Result(run.stride, run.fallen, "")


def run_batch(
    table: Sequence[Mapping[str, Given]],
    *,
    strides: int,
    tolerance: float = DEFAULT_TOLERANCE,
    interface: str = "cs",
    scheduler: str | None = None,
    threads: int | None = None,
    progress: bool = False,
    fmu: Fmu | None = None,
) -> xarray.Dataset:
    """Run the unit once for each row of a table.

    Parameters
    ----------
    table : sequence of mappings of str to float
        Start values by the unit's names, one mapping for each run; all with the same names.
    strides : int
        How many each run makes.
    tolerance : float, default 1e-9
        As in `simulate`.
    interface : str, default 'cs'
        `me` or `cs`.
    scheduler : str, optional
        Of a Dask cluster, see `run_blocks`. The result does not depend on who computes it.
    threads : int, optional
        Threads on this machine, by default one for each processor.
    progress : bool, default False
        A bar on stderr.
    fmu : Fmu, optional
        Checks the table before anything is run.

    Returns
    -------
    xarray.Dataset
        Over the dimension `run`: the table's columns as coordinates, the last stride's quantities with their
        units, `fallen`, and `problem`, empty where there was none.

    Raises
    ------
    InputError
        An empty table, rows with different names, or a value that is not allowed.

    Examples
    --------
    >>> import tdmf_slip
    >>> runs = tdmf_slip.run_batch([{"ground.friction": 0.6}, {"ground.friction": 1.2}], strides=2, threads=1)
    >>> print(runs["speed"].values.round(3), runs["fallen"].values)
    [1.062 1.051] [False False]
    """
    fmu = load_fmu(fmu)
    fmu.require_interface(interface)
    checked_whole("strides", strides, 1, MOST_STRIDES)
    checked("tolerance", tolerance, *TOLERANCES)
    allowed = "one or more rows, all with the same names in the same order"
    rows = [mapping_of(row, "table", allowed) for row in row_of(rows_of(table), "table", allowed)]
    names = list(rows[0]) if rows else []
    if not names or any(list(row) != names for row in rows):
        raise InputError(f"table: allowed: {allowed}")
    jobs = [
        Job(fmu.start_values(row, f"row {number}"), strides, tolerance, interface)
        for number, row in enumerate(rows)
    ]
    results = [NOT_RUN] * len(jobs)
    with (
        progress_bar("batch", len(jobs), "runs", progress) as bar,
        run_blocks(run_one, jobs, scheduler=scheduler, threads=threads) as finished,
    ):
        for number, result in finished:
            results[number] = result
            bar.update()
    return _dataset(jobs, results, names, fmu)


def _dataset(
    jobs: Sequence[Job], results: Sequence[Result], names: Sequence[str], fmu: Fmu
) -> xarray.Dataset:
    data = xarray.Dataset(
        {
            "fallen": ("run", [result.fallen for result in results]),
            "problem": ("run", np.array([result.problem for result in results], dtype=object)),
        },
        coords={name: ("run", [job.values[name] for job in jobs]) for name in names},
    )
    for variable in fmu.group("stride"):
        name, is_text = variable.member, variable.type == "String"
        values = [result.stride.get(name, "" if is_text else np.nan) for result in results]
        data[name] = "run", np.array(values, dtype=object if is_text else float)
        data[name].attrs = {"units": variable.unit or "1", "long_name": variable.description}
    return data
