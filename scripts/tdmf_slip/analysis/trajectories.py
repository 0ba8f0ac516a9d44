"""Trajectories: states and outputs along a run of the engine at given times, with exact derivatives."""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import check_names, check_size, refusal
from ..errors import InputError, RunError
from ..given import numbers_of
from ..library.binding import c, check_accepted, ffi, text_of
from ..library.c_structs import dtype_of
from ..library.gait import Gait
from ..library.members import seed_of
from ..library.runner import Runner
from ..library.section import COORDINATES, Apex, checked_apex
from ..library.shared_steps import shares_steps
from ..record import dataset
from ..variables.parameters import RunnerLike
from ..variables.table import VARIABLES, Model, full_names, model_of

if TYPE_CHECKING:
    import xarray

MAX_TIMES = 10_000_000
LONGEST = 1e6
"""Largest time that may be asked for, in sqrt(m/k)."""
STATES = tuple(name[4:-1] for name in VARIABLES if name.startswith("der("))
"""The unit's continuous states, in the order of the library's array."""
MOTION, OUTPUTS, VARIATION = map(dtype_of, ("tdmf_motion", "tdmf_outputs", "tdmf_variation"))
OUTPUT_NAMES = tuple(
    f"{group}.{member}"
    for group in OUTPUTS.names or ()
    if group not in ("stride", "apex")
    for member in OUTPUTS[group].names or ()
)
"""The unit's outputs that are no states and not the last stride's."""
COMPLEX_STEP = 1e-30
DIFFERENTIABLE = STATES[: c.TDMF_VARIED_COUNT]
"""States with a derivative: the mechanical ones, and the works of hip and leg."""
VARIED_OUTPUTS = (
    "contact.fx",
    "contact.fy",
    "hip.torque",
    "leg.force",
    "energy.kinetic",
    "energy.potential",
    "energy.elastic",
    "energy.total",
)
"""Outputs with a derivative, beside those of body and com."""


@shares_steps
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
        derivatives at a fixed time over `time` and `by`, such as `d_com.y`. After a fall the motion is
        frozen, and `fallen` is 1.

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
    own = model_of(runner, None).runner_class
    if own is not None:
        return _of_own(
            own(runner), getattr(runner, "apex", None) if apex is None else apex, times, derivatives
        )
    start = runner.section if apex is None and isinstance(runner, Gait) else apex
    runner = Runner(runner, model="full")
    section = runner.start_apex() if start is None else checked_apex(start)
    at = _checked_times(times, runner)
    names = _checked_names(derivatives, runner.model)
    size = c.TDMF_VARIATION_LIMIT
    blocks = [names[first : first + size] for first in range(0, max(1, len(names)), size)]
    made = [_run(runner, section, at, block) for block in blocks]
    motions, outputs = made[0][:2]
    arrays = {name: motions["state"][:, number] for number, name in enumerate(STATES)}
    arrays |= {name: _member(outputs, name) for name in OUTPUT_NAMES}
    variables: dict[str, Any] = {
        name: ("time", array.copy(), VARIABLES[name].attributes) for name, array in arrays.items()
    }
    if names:
        varied = np.concatenate([block[2] for block in made], axis=1)
        of_outputs = np.concatenate([block[3] for block in made], axis=1)
        rates = {name: varied["state"][..., STATES.index(name)] for name in DIFFERENTIABLE}
        rates |= {
            name: _member(of_outputs, name)
            for name in OUTPUT_NAMES
            if name in VARIED_OUTPUTS or name.partition(".")[0] in ("body", "com")
        }
        variables |= {f"d_{name}": (("time", "by"), array.copy()) for name, array in rates.items()}
    coordinates: dict[str, Any] = {"time": ("time", at, VARIABLES["time"].attributes)}
    if names:
        coordinates["by"] = list(names)
    fallen = bool(motions["mode"]["fallen"][-1])
    return dataset("trajectory", runner.record(), variables, coordinates, fallen=int(fallen))


def _of_own(runner: Runner, apex: object, times: ArrayLike, derivatives: Sequence[str]) -> xarray.Dataset:
    """A run of a user's model, from a point of its section or from its start values."""
    point = None if apex is None or callable(apex) else checked_apex(np.asarray(apex), runner.coordinates)
    names = _checked_names(derivatives, runner.model)
    if point is None and any(name in runner.coordinates for name in names):
        raise InputError(
            "derivatives: a run from the start values has no apex; allowed: by coordinates with apex"
        )
    found: xarray.Dataset = runner.trajectory(  # type: ignore[attr-defined]
        _checked_times(times, runner), point, names
    )
    return found


def _checked_times(given: ArrayLike, runner: Runner) -> NDArray[np.float64]:
    longest = LONGEST * runner.scale_of("s")
    allowed = f"numbers in rising order from 0 to {longest:g} s"
    times = np.atleast_1d(numbers_of("times", given, allowed, "s"))
    check_size("times", times.size, "times", MAX_TIMES)
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


def _member(structs: NDArray[Any], path: str) -> NDArray[Any]:
    """A member of an array of structs, by its path."""
    for part in path.split("."):
        structs = structs[part]
    return structs


def _run(
    runner: Runner, section: NDArray[np.float64], times: NDArray[np.float64], names: Sequence[str]
) -> tuple[NDArray[Any], ...]:
    """Motions and outputs at the times, and their variations along some names."""
    count, system, motion = len(names), runner.c_system, ffi.new("tdmf_motion *")
    c.tdmf_section_state(system, list(section), motion.state)
    given = list(motion.state)
    check_accepted(c.tdmf_start(system, motion))
    seeds, variations = ffi.new("tdmf_seed[]", count + 1), ffi.new("tdmf_variation[]", count + 1)
    for number, name in enumerate(names):
        if name not in COORDINATES:
            seeds[number] = seed_of(name)[0]
        by = _start_by(runner, section, name)
        c.tdmf_vary_start(system, given, seeds + number, by, variations + number)
    kinds = (MOTION, len(times)), (OUTPUTS, len(times)), (VARIATION, (len(times), count))
    arrays = [np.zeros(shape, kind) for kind, shape in (*kinds, (OUTPUTS, (len(times), count)))]
    motions, outputs, varied, of_outputs = (
        ffi.from_buffer(f"{name}[]", array)
        for name, array in zip(
            ("tdmf_motion", "tdmf_outputs", "tdmf_variation", "tdmf_outputs"), arrays, strict=True
        )
    )
    solver, rates = runner.solver(), ffi.new("double[]", c.TDMF_STATE_COUNT)
    for row, time in enumerate(times.tolist()):
        while motion.time < time and not motion.mode.fallen:
            if count:
                varying = c.tdmf_native_stride_varied(solver, system, time, motion, seeds, variations, count)
                end = varying.outcome
            else:
                end = c.tdmf_native_advance(solver, system, ffi.NULL, time, motion)
            if end not in (c.TDMF_ARRIVED, c.TDMF_FELL):
                raise RunError(f"at {motion.time:g} s: {text_of(c.tdmf_outcome_text(end))}")
        motions[row] = motion[0]
        c.tdmf_outputs_of(system, motion, outputs + row)
        for number in range(count):
            varied[row * count + number] = variations[number]
            c.tdmf_vary_outputs(
                system,
                ffi.addressof(motion, "mode"),
                motion.state,
                seeds + number,
                variations + number,
                rates,
                of_outputs + row * count + number,
            )
    return tuple(arrays)


def _start_by(runner: Runner, section: NDArray[np.float64], name: str) -> list[float]:
    """Derivative of the state at an apex, which has the foot at x = 0, by a coordinate or a parameter.

    A complex step gives the derivative, exact to rounding.
    """
    values: dict[str, complex] = dict(zip(COORDINATES, section.tolist(), strict=True))
    values |= {other: runner[other] for other in ("body.mass", "foot.mass", "ground.height", "ground.slope")}
    if name not in values:
        return [0.0] * len(STATES)
    values[name] += 1j * COMPLEX_STEP
    height, speed, length, angle, length_rate, angle_rate, body, foot, ground, slope = values.values()
    share = body / (body + foot)
    # The body from the foot, and its velocity, turn with the leg.
    x, y = -length * cmath.sin(angle), length * cmath.cos(angle)
    vx, vy = x / length * length_rate - y * angle_rate, y / length * length_rate + x * angle_rate
    state = {
        "foot.y": height + ground + share * (cmath.tan(slope) * x - y),
        "foot.vx": speed - share * vx,
        "foot.vy": -share * vy,
        "leg.length": length,
        "leg.angle": angle,
        "leg.length_rate": length_rate,
        "leg.angle_rate": angle_rate,
    }
    return [complex(state.get(name, 0.0)).imag / COMPLEX_STEP for name in STATES]
