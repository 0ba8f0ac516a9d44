"""The stride map of many runners: from apex to apex, with settings that may change from stride to stride."""

from __future__ import annotations

import math
from collections.abc import Mapping
from concurrent.futures import Executor

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..blocks import run_blocks
from ..checks import check_size, checked_whole, refusal
from ..errors import InputError
from ..given import numbers_by
from ..library.affine_law import AffineLaw, check_law
from ..library.ensemble import TOLERANCE
from ..library.population import Population, numbers
from ..library.recorded_strides import Columns, Request, recorded_strides
from ..library.rough_ground import LAST_RUNNER, RoughGround
from ..library.runner import Runner
from ..library.settings import check_acts, checked_values, setting_number
from ..terminal.progress import progress_bar
from ..variables.parameters import RunnerLike
from ..variables.table import by_full_name
from .function_law import FunctionLaw, Law, check_set
from .strides_result import Strides

MAX_STRIDES = 1_000_000
MAX_IN_ALL = 10_000_000
"""Strides of all runners: each is kept, in 700 bytes."""
STRIDES_IN_A_BLOCK = 100_000
"""At the most, unless runners are few: the library hears of no interrupt until it returns."""
MIN_IN_A_BLOCK, MAX_IN_A_BLOCK = 64, 4096
"""Runners; fewer would leave lanes empty."""


def stride_map(
    runner: RunnerLike,
    apices: ArrayLike,
    *,
    strides: int = 1,
    model: str | None = None,
    inputs: Mapping[str, ArrayLike] | None = None,
    law: Law | AffineLaw | None = None,
    roughness: float = 0.0,
    seed: int = 0,
    foot_x: ArrayLike | None = None,
    first_number: int = 0,
    tolerance: float = TOLERANCE,
    instructions: str | None = None,
    executor: Executor | None = None,
    progress: bool = False,
) -> Strides:
    """Strides of many runners in a row, each kept with its apices and quantities.

    Settings are in force from the apex on at which a stride begins, and what they are is up to `inputs` or
    to a law. A stride that does not close leaves NaN in all its quantities and those of the strides to come,
    and `fate` says why: a ground that is set by `ground.height` or `ground.slope` is in force once the foot
    flies above it, and a runner whose foot stays below it for a whole stride has fallen, at the apex after
    that stride: the stride is the last to have quantities, and the next one has the fate `fell`. The height
    of the first apex is above the ground of the first stride, wherever that is. On rough ground the ground
    steps at each apex, the start's too, as in `strides_to_fall`; the height of an apex is that above the
    ground that the runner came from, before the ground steps, and this is what a law sees of it.

    Parameters
    ----------
    runner : Runner, Gait, mapping of str to float, Series, str or Path
        A runner, or start values by the unit's names and in its units, over the unit's own; an array has one
        for each runner.
    apices : array_like of float, shape (n,) or (runners, n)
        Where they begin, in the order of `library.section.COORDINATES`: m, m/s, m, rad, m/s, rad/s; of
        runners by the reduced map the first two.
    strides : int, default 1
        How many each runner makes.
    model : str, optional
        `full` or `reduced`, as in `find_gait`.
    inputs : mapping of str to array_like of float, optional
        By name, one of `library.settings.SETTINGS`: tunable settings of the control law, as
        `hip.touchdown_angle`, and inputs, as `ground.friction`. A number, or of each stride, shape
        (strides,), or of each runner and stride, shape (runners, strides).
    law : callable or AffineLaw, optional
        What is set at each apex. A function is called with the apices, shape (runners, n), once for each
        stride and for all runners at once, and gives arrays by name, the same names each time; rows of
        runners whose run is over are NaN, and what it gives for them does not matter. An `AffineLaw` is
        followed by the engine itself.
    roughness : float, default 0
        Standard deviation of a step of the ground, m.
    seed : int, default 0
        Of the ground.
    foot_x : float or array_like of float, shape (runners,), optional
        Where the feet are at the first apices, m, by default at 0. What a stride does depends on it where the
        ground has a patch, `ground.patch_begin` and `ground.patch_end`.
    first_number : int, default 0
        Of the first runner; by their numbers ground and noise are drawn.
    tolerance : float, default 2e-10
        Relative tolerance of a step.
    instructions : str, optional
        One of `library.ensemble.instruction_sets()`; by default the fastest. Results differ by rounding.
    executor : concurrent.futures.Executor, optional
        Runs blocks of the work, such as a `ProcessPoolExecutor()` or `client.get_executor()` of Dask; by
        default threads of this process. The result does not depend on the executor.
    progress : bool, default False
        A bar on stderr.

    Returns
    -------
    Strides
        Over `runner` and `stride`: `fate`, a number of `library.recorded_strides.STRIDE_FATES`; `apex` and
        `next_apex`, over `coordinate` too; quantities of the stride by the names of
        `library.measures.STRIDE_QUANTITIES` and `LEDGER`, `liftoff_angle` and `word`; by the full model
        `foot.x`, where the foot is at the next apex, in m; what was set, by the names of the settings;
        `ground.height` on rough ground. Over `runner` the
        parameters that vary. A runner's other values are attributes.

    Raises
    ------
    InputError
        A value that is not allowed, which is told with its runner and stride.
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

    >>> def by_height(apices):
    ...     return {"hip.touchdown_angle": 0.64 + 0.1 * (apices[:, 0] - gait.apex[0])}
    >>> run = tdmf_slip.stride_map(gait.runner, low, strides=3, law=by_height)
    >>> run["hip.touchdown_angle"].shape
    (1, 3)
    """
    population = Population.of(runner, model)
    strides = checked_whole("strides", strides, 1, MAX_STRIDES)
    feet = _feet(foot_x, population.runner)
    starts, given = _broadcast(apices, population, inputs, strides, 1 if feet is None else len(feet))
    ground = RoughGround(roughness, seed)
    _check_all(population, given, law, ground)
    affine = law if isinstance(law, AffineLaw) else None
    request = Request(
        population,
        starts,
        strides,
        given,
        affine,
        ground,
        checked_whole("first_number", first_number, 0, LAST_RUNNER),
        tolerance,
        instructions,
        foot_x=None if feet is None else np.broadcast_to(feet, (len(starts),)),
    )
    if law is None or affine is not None:
        columns = _in_blocks(request, executor, progress)
    elif executor is not None:
        raise InputError(
            "executor is not allowed with a law that is a function, which is called here for all runners"
        )
    else:
        assert callable(law)
        with progress_bar("strides", strides, "strides", progress) as bar:
            columns = recorded_strides(request, FunctionLaw(law, request, bar.update))
    return Strides.of(request, columns)


def _broadcast(
    apices: ArrayLike, population: Population, inputs: Mapping[str, ArrayLike] | None, strides: int, feet: int
) -> tuple[NDArray[np.float64], dict[str, NDArray[np.float64]]]:
    """Apices, shape (runners, n), and settings, shape (runners, strides), of as many runners."""
    coordinates = population.runner.coordinates
    given_apices = numbers_by("apices", apices, coordinates)
    check_size("apices", math.prod(given_apices.shape[:-1]) * strides, "strides in all", MAX_IN_ALL)
    starts = np.atleast_2d(numbers("apices", given_apices, 2))
    if starts.shape[1] != len(coordinates):
        raise InputError(f"apices of shape {starts.shape}; allowed: rows of {', '.join(coordinates)}")
    given: dict[str, NDArray[np.float64]] = {}
    for name, asked in by_full_name(inputs, "inputs", "numbers or arrays by name").items():
        setting_number(name, "inputs")
        values = numbers(f"inputs: {name}", asked, 2)
        given[name] = np.atleast_2d(values)
        if given[name].shape[1] not in (1, strides):
            raise InputError(
                f"inputs: {name} of shape {values.shape}; allowed: a number, ({strides},) or "
                f"(runners, {strides}), for each stride one"
            )
    counts = {"apices": len(starts), "runner's values": population.size or 1, "foot_x": feet}
    counts |= {f"inputs: {name}": len(values) for name, values in given.items()}
    runners = max(counts.values())
    check_size("runners", runners * strides, "strides in all", MAX_IN_ALL)
    for what, count in counts.items():
        if count not in (1, runners):
            maximum = max(counts, key=lambda name: counts[name])
            raise InputError(
                f"{what} of {count} runners, {maximum} of {runners}; allowed: as many, or one for all"
            )
    for name, values in given.items():
        first = {"runner": 0, "stride": 0}
        given[name] = np.broadcast_to(checked_values(name, values, "inputs", first), (runners, strides))
    return np.broadcast_to(starts, (runners, len(coordinates))), given


def _feet(foot_x: ArrayLike | None, runner: Runner) -> NDArray[np.float64] | None:
    """Where the feet are, shape (1,) or (runners,)."""
    if foot_x is None:
        return None
    if runner.reduced:
        raise InputError("foot_x: by the reduced map, which has no foot; allowed: by the full model")
    return checked_values("foot.x", np.atleast_1d(numbers("foot_x", foot_x, 1)), "foot_x", {"runner": 0})


def _check_all(population: Population, given: Mapping[str, object], law: object, ground: RoughGround) -> None:
    """Refuse what does not go together."""
    runner = population.runner
    if runner.reduced and ground.roughness:
        raise InputError("roughness: by the reduced map; allowed: by the full model")
    set_by_law: tuple[str, ...] = ()
    if isinstance(law, AffineLaw):
        check_law(law, runner)
        set_by_law = tuple(law.inputs)
    elif law is not None and not callable(law):
        raise refusal("law", law, "a function of apices, or an AffineLaw")
    for name in given:
        check_acts(name, runner, (*given, *population.varied), "inputs")
    check_set(set_by_law, tuple(given), ground, "law")
    check_set(tuple(given), (), ground, "inputs")


def _in_blocks(request: Request, executor: Executor | None, progress: bool) -> Columns:
    """Block by block."""
    runners = len(request.apices)
    size = min(MAX_IN_A_BLOCK, max(MIN_IN_A_BLOCK, STRIDES_IN_A_BLOCK // request.strides))
    blocks = [request.part(first, min(size, runners - first)) for first in range(0, runners, size)]
    parts: dict[int, Columns] = {}
    with (
        progress_bar("strides", runners, "runners", progress) as bar,
        run_blocks(recorded_strides, blocks, executor) as results,
    ):
        for number, columns in results:
            parts[number] = columns
            bar.update(len(blocks[number].apices))
    return {name: np.concatenate([parts[n][name] for n in range(len(blocks))]) for name in parts[0]}
