"""Trajectories: states and outputs along a run of the engine at given times, with exact derivatives."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import check_names, check_size, refusal
from ..errors import InputError
from ..given import numbers_of
from ..library.gait import Gait
from ..library.page_model import package_model, text_of_code
from ..library.page_runner import PageRunner
from ..library.page_strides import SEEDS
from ..library.runner import Runner
from ..library.section import Apex, checked_apex
from ..record import dataset
from ..variables.parameters import RunnerLike
from ..variables.table import VARIABLES, Model, full_names, model_of
from ..variables.variable import attributes_of

if TYPE_CHECKING:
    import xarray

MAX_ROWS = 1_000_000
"""Rows of times and derivatives."""
LONGEST = 1e6
"""Largest time that may be asked for, in sqrt(m/k)."""


def trajectory(
    runner: RunnerLike = None,
    apex: Apex | None = None,
    *,
    times: ArrayLike,
    derivatives: Sequence[str] = (),
) -> xarray.Dataset:
    """Compute states and outputs along a run of the engine, at given times.

    The run begins at an apex and goes through all of the unit's events. It agrees with `simulate`, which runs
    the unit through FMPy, and takes a fraction of its time.

    Parameters
    ----------
    runner : Runner, Gait, mapping of str to float, Series, str or Path, optional
        Parameters and inputs, which are held; by default the paper's runner.
    apex : sequence of float, optional
        The six coordinates of the apex at time 0; by default that of the gait or of the start values.
    times : array_like of float
        Times, s, in rising order, from 0 on. At the time of an event, the values are those after it.
    derivatives : sequence of str, optional
        Names by which states and outputs are differentiated: coordinates of the apex, such as `com_speed`,
        parameters and inputs.

    Returns
    -------
    xarray.Dataset
        Over `time`: the states and outputs by the unit's names, with their units. For each that has them, its
        derivatives at a fixed time over `time` and `by`, such as `d_com.y`. After a fall, or another end of
        the run, the motion is frozen, and `fallen` is 1. `mode` is the mode of the page.

    Raises
    ------
    InputError
        The start is refused, the times are not finite, negative or do not rise, or a name is unknown.
    RunError
        The solver could not follow the runner.

    Examples
    --------
    >>> import numpy as np
    >>> import tdmf_slip
    >>> gait = tdmf_slip.find_gait(friction=0.6)
    >>> run = tdmf_slip.trajectory(gait, times=np.linspace(0, gait.period, 5), derivatives=["com_speed"])
    >>> print(run["com.y"].values.round(4), run["d_com.vx"].sel(by="com_speed").values.round(3))
    [1.4185 1.2232 0.6651 1.2232 1.4185] [1.    1.    0.908 0.853 0.853]
    """
    runner, page, point = _begun(runner, apex)
    at, names = _checked_times(times, page), _checked_names(derivatives, page.model)
    if point is None and any(name in page.coordinates for name in names):
        raise InputError(
            "derivatives: a run from the start values has no apex; allowed: by coordinates with apex"
        )
    check_size("times", len(at) * max(1, len(names)), "rows", MAX_ROWS)
    along = [name for name in names if name not in page.coordinates]
    blocks = [along[first : first + SEEDS] for first in range(0, max(1, len(along)), SEEDS)]
    rows, varied, modes, has_ended = page.sampled(at, point, blocks[0], bool(names))
    shown = list(_shown(page.model.table))
    variables: dict[str, Any] = {
        of["public"]: ("time", _values(rows[kind][:, number], of), attributes_of(of["unit"], of["meaning"]))
        for of, kind, number in shown
    }
    for of, kind, number in shown:
        if of.get("is_enumeration"):  # as in the unit, whose importers may drop enumerations
            about = attributes_of("1", f"{of['public']} as an Integer")
            variables[f"{of['public']}_index"] = "time", rows[kind][:, number].astype(int), about
    coordinates: dict[str, Any] = {"time": ("time", at, VARIABLES["time"].attributes)}
    if names:
        first = 0 if point is None else len(page.coordinates)
        more = [page.sampled(at, point, block, True)[1] for block in blocks[1:]]
        known = [*(page.coordinates if first else ()), *along]
        chosen = [known.index(name) for name in names]
        for of, kind, number in shown:
            if not of.get("letters"):
                parts = [varied[kind], *(block[kind][:, first:] for block in more)]
                by = np.concatenate(parts, axis=1)[:, chosen, number]
                variables[f"d_{of['public']}"] = ("time", "by"), by
        coordinates["by"] = list(names)
    titles = np.array([" ".join(mode) for mode in page.model.table["modes"]])
    variables["mode"] = "time", titles[modes], {"long_name": "mode"}
    return dataset("trajectory", runner.record(), variables, coordinates, fallen=int(has_ended))


def _begun(runner: RunnerLike, apex: Apex | None) -> tuple[Runner, PageRunner, NDArray[np.float64] | None]:
    """The runner, the runner of its page, and the point where the run begins; None for the start values."""
    if model_of(runner, None).is_page:
        page = PageRunner(runner)
        start = runner.apex if apex is None and isinstance(runner, Gait) else apex
        return page, page, None if start is None else checked_apex(start, page.coordinates)
    start = runner.section if apex is None and isinstance(runner, Gait) else apex
    whole = Runner(runner, model="full")
    section = whole.start_apex() if start is None else checked_apex(start)
    whole.started(section)
    model = package_model("runner", "at_apex")
    values = {name: value for name, value in whole.items() if name in model.variables}
    return whole, PageRunner(values, model=model, tolerance=whole.tolerance), section


def _shown(table: Mapping[str, Any]) -> Iterator[tuple[Mapping[str, Any], str, int]]:
    """Outputs and states that a unit shows, with their numbers."""
    for number, of in enumerate(table["outputs"]):
        yield of, "outputs", number
    for number, of in enumerate(table["states"]):
        if of["role"] in ("start", "input") or of["is_named"]:
            yield of, "states", number


def _values(row: NDArray[np.float64], of: Mapping[str, Any]) -> NDArray[Any]:
    """A row of values; numbers whose digits are letters as texts."""
    if not of.get("letters"):
        return row
    return np.array([text_of_code(code, of["letters"]) for code in row])


def _checked_times(given: ArrayLike, runner: Runner) -> NDArray[np.float64]:
    longest = LONGEST * runner.scale_of("s")
    allowed = f"numbers in rising order from 0 to {longest:g} s"
    times = np.atleast_1d(numbers_of("times", given, allowed, "s"))
    rises = times.ndim == 1 and bool(np.all(np.diff(times, prepend=0.0) >= 0.0))
    if not rises or not times.size or times[-1] > longest:
        raise refusal("times", given, allowed)
    return times


def _checked_names(given: object, model: Model) -> tuple[str, ...]:
    allowed = "names of coordinates, parameters and inputs in a list"
    names = full_names(given, "derivatives", allowed, model.aliases)
    known, which = (*model.coordinates, *model.varied), "a coordinate of the apex, a parameter or an input"
    check_names(names, known, "derivatives", model.aliases, which)
    return tuple(dict.fromkeys(names))
