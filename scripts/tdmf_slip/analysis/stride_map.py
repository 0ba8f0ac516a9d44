"""The stride map of many runners: from apex to apex, with settings that may change from stride to stride."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..blocks import in_order
from ..checks import check_once, check_size, checked_whole
from ..errors import InputError
from ..library.batch import TOLERANCE, Batch
from ..library.batch_tables import CLOSED, about_of
from ..library.ground import RoughGround
from ..library.laws import AffineLaw, Law, text_of_law
from ..library.members import check_varied
from ..library.quantities import differentiable
from ..library.tables import Table
from ..terminal.in_blocks import in_blocks, largest_block, sizes_of
from ..terminal.progress import progress_bar
from ..variables.parameters import RunnerLike
from ..variables.table import STATES, Model, full_names

if TYPE_CHECKING:
    import xarray

MAX_STRIDES = 1_000_000
MAX_IN_ALL = 10_000_000
"""Strides of all runners: each is kept, in 700 bytes."""
STRIDES_IN_A_BLOCK = 100_000
"""Largest number of strides in a block with many runners: the library sees an interrupt between blocks."""


def stride_map(
    runner: RunnerLike,
    apices: ArrayLike,
    *,
    strides: int = 1,
    model: str | Model | None = None,
    inputs: Mapping[str, ArrayLike] | None = None,
    law: Law | None = None,
    roughness: float = 0.0,
    seed: int = 0,
    foot_x: ArrayLike | None = None,
    derivatives: Sequence[str] = (),
    first_number: int = 0,
    tolerance: float = TOLERANCE,
    instructions: str | None = None,
    executor: Executor | None = None,
    progress: bool = False,
) -> xarray.Dataset:
    """Make strides of many runners in a row, and keep the apices and quantities of each.

    Settings hold from the apex at which a stride begins; `inputs` or a law says what they are. The height of
    an apex is that above the ground that the runner comes from, also for a law. A ground that is set by
    `ground.height` or `ground.slope` is in force once the foot flies above it. A runner whose foot stays
    below its ground for a whole stride has fallen, and its next stride has the fate `fell`. From a stride
    that does not close on, all quantities are NaN.

    Parameters
    ----------
    runner : Runner, Gait, mapping of str to float or array_like, Series, str or Path
        A runner as in `find_gait`; in a mapping, an array has a value for each runner.
    apices : array_like of float, shape (n,) or (runners, n)
        First apices, in the order of `library.section.COORDINATES`: m, m/s, m, rad, m/s, rad/s; for the
        reduced map the first two.
    strides : int, default 1
        Number of strides of each runner.
    model : as in `find_gait`
    inputs : mapping of str to array_like of float, optional
        Settings by their names in `library.settings.SETTINGS`: a number, a value for each stride, shape
        (strides,), or one for each runner and stride, shape (runners, strides).
    law : callable or AffineLaw, optional
        Law that sets values at each apex, see `Batch`. A function is called once for each stride, with the
        apices of all runners, shape (runners, n), and the number of the stride. It returns arrays by name,
        always the same names. Rows of runners whose run is over are NaN.
    roughness, seed : float and int, default 0
        Standard deviation of the ground's steps, m, and their seed, as in `strides_to_fall`.
    foot_x : float or array_like of float, shape (runners,), optional
        Positions of the feet at the first apices, m, by default 0. They matter where the ground has a patch.
    derivatives : sequence of str, optional
        Parameters and inputs by which each stride is differentiated, exactly and by the native solver. A
        stride with derivatives takes as long as some 15 without.
    first_number : int, default 0
        Number of the first runner; ground and noise are drawn by these numbers.
    tolerance : float, default 2e-10
        Relative tolerance of a step.
    instructions : str, optional
        One of `library.engine.instruction_sets()`; by default the fastest. Results differ by rounding.
    executor, progress : as in `sweep`

    Returns
    -------
    xarray.Dataset
        Over `runner` and `stride`: `fate`, a number of `library.batch_tables.STRIDE_FATES`; `apex` and
        `next_apex`, also over `coordinate`; the quantities `STRIDE_QUANTITIES` and `LEDGER` of
        `library.quantities`; `liftoff_angle` and `word`; for the full model `foot.x` at the next apex, m; the
        settings; `ground.height` on rough ground. Over `runner`: the parameters that vary; other values are
        attributes. With `derivatives` also `next_apex_by` over `coordinate` and `by`, and `speed_by` and the
        like over `by`: derivatives of each stride by its own apex and by the names.

    Raises
    ------
    InputError
        A value is not allowed; the message names its runner and stride.
    RunError
        See `run_blocks`.

    Examples
    --------
    >>> import tdmf_slip
    >>> gait = tdmf_slip.find_gait({"ground.friction": 0.6})
    >>> low = gait.apex - [0.01, 0, 0, 0, 0, 0]
    >>> run = tdmf_slip.stride_map(gait.runner, [gait.apex, low], strides=3)
    >>> run["word"].shape, bool((run["fate"] == 0).all())
    ((2, 3), True)

    A law that places the leg by the height of the apex:

    >>> def by_height(apices, stride_number):
    ...     return {"hip.touchdown_angle": 0.64 + 0.1 * (apices[:, 0] - gait.apex[0])}
    >>> run = tdmf_slip.stride_map(gait.runner, low, strides=3, law=by_height)
    >>> run["hip.touchdown_angle"].shape
    (1, 3)
    """
    strides = checked_whole("strides", strides, 1, MAX_STRIDES)
    batch = Batch(
        runner,
        apices,
        RoughGround(roughness, seed),
        law,
        inputs=inputs,
        model=model,
        foot_x=foot_x,
        first_number=first_number,
        tolerance=tolerance,
        instructions=instructions,
    )
    batch.is_single = False
    check_size("runners", len(batch) * strides, "strides in all", MAX_IN_ALL)
    for name, values in batch.inputs.items():
        if values.shape[1] not in (1, strides):
            raise InputError(
                f"inputs: {name} of shape {values.shape[len(values) == 1 :]}; "
                f"allowed: a number, ({strides},) or (runners, {strides}), for each stride one"
            )
    allowed = "names of parameters and inputs in a list"
    names = full_names(derivatives, "derivatives", allowed, batch.model.aliases)
    _check_derivatives(names, batch)
    if law is None or isinstance(law, AffineLaw):
        arrays = _in_blocks(batch, strides, executor, progress)
    elif executor is not None:
        raise InputError(
            "executor: the law is a function, which is called for all runners at once; allowed: without one"
        )
    else:
        with progress_bar("strides", strides, "strides", progress) as bar:
            batch.law = _reporting(law, bar.update)
            arrays = _strides_of(strides, batch)
            batch.law = law
    if names:
        arrays |= _derivatives_of(batch, arrays, names)
    return _dataset(batch, arrays, [*batch.runner.coordinates, *names] if names else [])


def _dataset(batch: Batch, arrays: Mapping[str, NDArray[Any]], by: Sequence[str]) -> xarray.Dataset:
    """Arrays of strides by name, over runners and strides; `by` labels the last axis of derivatives."""
    found, over = {**arrays, **batch.varied}, ("runner", "stride", "coordinate")
    dimensions = {
        name: (*over[: values.ndim - 1], "by") if by and name.endswith("_by") else over[: values.ndim]
        for name, values in found.items()
    }
    labels = {
        "runner": batch.first_number + np.arange(len(batch)),
        "stride": np.arange(arrays["fate"].shape[1]),
        "coordinate": np.array(batch.runner.coordinates),
        "by": np.array(by),
    }
    attributes: dict[str, float | str] = {"tolerance": batch.tolerance}
    if batch.law is not None:
        attributes["law"] = text_of_law(batch.law)
    if batch.ground.roughness:
        attributes |= {"roughness": batch.ground.roughness, "seed": str(batch.ground.seed)}
    record = batch.runner.record(*found, *(() if batch.model.is_page else STATES))
    table = Table(
        dimensions, found.__getitem__, lambda: labels, about_of(batch.model), lambda: record, attributes
    )
    return table.to_dataset("strides")


def _reporting(law: Law, report: Callable[[], object]) -> Law:
    """The law, with a report of each stride."""

    def reporting(apices: NDArray[np.float64], stride_number: int) -> Mapping[str, ArrayLike]:
        report()
        return law(apices, stride_number)

    return reporting


def _strides_of(strides: int, batch: Batch) -> dict[str, NDArray[Any]]:
    """All strides of a batch, by name."""
    recorded = batch.run(strides, record=True).recorded
    assert recorded is not None
    return dict(recorded)


def _in_blocks(
    batch: Batch, strides: int, executor: Executor | None, progress: bool
) -> dict[str, NDArray[Any]]:
    """Strides of all runners, computed block by block."""
    largest = largest_block(strides, STRIDES_IN_A_BLOCK)
    sizes = sizes_of(len(batch), largest) or [0]
    blocks = [batch.part(number * largest, size) for number, size in enumerate(sizes)]
    work = partial(_strides_of, strides)
    with in_blocks(work, blocks, "strides", "runners", executor, progress, sizes=sizes) as results:
        parts = in_order(results)
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


def _check_derivatives(names: Sequence[str], batch: Batch) -> None:
    """Refuse what is no parameter, and strides that are more than a map from apex to apex."""
    for name in names:
        check_varied(name, "derivatives", batch.model)
    check_once(names, "derivatives")
    if names:
        batch.refuse_patches()
    law = batch.law
    if names and (batch.ground.roughness or "ground.height" in (*batch.inputs, *getattr(law, "inputs", ()))):
        raise InputError("derivatives: the ground steps at the apices; allowed: ground of one height")


def _derivatives_of(
    batch: Batch, arrays: Mapping[str, NDArray[Any]], names: Sequence[str]
) -> dict[str, NDArray[np.float64]]:
    """Derivatives of all strides that closed, each from its own apex and with its own settings."""
    runners, strides = np.nonzero(arrays["fate"] == CLOSED)
    shape, by = arrays["fate"].shape, len(batch.runner.coordinates) + len(names)
    varied = {name: values[runners] for name, values in batch.varied.items()}
    varied |= {name: arrays[name][runners, strides] for name in batch.model.settings if name in arrays}
    one = batch.runner if len(batch.runners) == 1 else [batch.runners[k] for k in runners]
    if not len(runners):
        one, varied, runners, strides = batch.runner, {}, runners[:0], strides[:0]
    made = Batch(one, arrays["apex"][runners, strides], vary=varied).stride(along=names)
    found: dict[str, NDArray[np.float64]] = {}
    of_model = tuple(batch.model.quantities)
    known = of_model if batch.model.is_page else differentiable(batch.runner.reduced)
    for name in ("next_apex", *known):
        values = made[f"{name}_by"]
        found[f"{name}_by"] = np.full((*shape, *values.shape[1:]), np.nan)
        found[f"{name}_by"][runners, strides] = values
    assert by == found["next_apex_by"].shape[-1]
    return found
