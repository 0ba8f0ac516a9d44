"""One run of the unit through FMPy.

The unit knows one line of ground. A run over a profile gives it, at each communication point, the line of the
profile that is below the foot. The unit puts a new line in force as soon as the foot is in flight and not
below it. So a foot that stands keeps its ground, and one that hangs below a step passes it on its way up.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import replace
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from ..checks import check_kind, checked, checked_flag, checked_whole, reading
from ..errors import InputError, RunError, counted
from ..record import in_dataset
from ..terminal.progress import progress_bar
from ..variables import paper_units
from ..variables.paper_units import SCALES
from ..variables.parameters import RunnerLike, start_values_of
from ..variables.table import Model, model_of
from ..variables.variable import Value
from .fmu import Fmu, load_fmu
from .inputs import InputTables, signals
from .instance import Experiment, Instance, Recorder, opened
from .profile import Profile
from .run import MODE, PHASE, Run, dataset_of, events_of

STEPS_PER_TIME_UNIT = 20
"""Communication steps in each sqrt(m/k), unless an output interval is given."""
HEIGHT, SLOPE = "ground.height", "ground.slope"


def interface_over(profile: object, interface: str | None, inputs: InputTables | None, fmu: Fmu) -> str:
    """The interface of a run: Model Exchange unless another is given, over a profile Co-Simulation."""
    if profile is None:
        return "me" if interface is None else interface
    check_kind(profile, Profile, "profile", "a Profile")
    assert isinstance(profile, Profile)
    if interface not in (None, "cs"):
        raise InputError(f"interface = {interface!r}: a profile needs Co-Simulation; allowed: 'cs'")
    if inputs:
        raise InputError("profile and inputs: allowed: one of them")
    fmu.variables[SLOPE].value_of(profile.steepest, "profile, its steepest line")
    return "cs"


def _line_below(profile: Profile, position: float) -> dict[str, float]:
    """The unit's inputs for the line of ground at a position."""
    line = profile.line(position)
    return {HEIGHT: line.height, SLOPE: line.slope}


DEFAULT_STRIDES = 10
DEFAULT_TOLERANCE = 1e-9
TOLERANCES = 1e-14, 0.1
"""Smallest and largest tolerance; `TIMES` and `INTERVALS` are pairs, too, in s."""
TIMES = 1e-9, 1e9
INTERVALS = 1e-12, 1e9
MAX_STRIDES = 10**9
NAMES = "names of variables in a list"
MAX_NAMES = 10_000
"""Largest number of names, more than any unit has."""
POINTS_PER_TIME_UNIT = 10
"""Recorded points in each sqrt(m/k), unless an output interval is given. Also bounds what FMPy lets CVODE do
between two points: 500 steps."""
LONGEST_STRIDE = 20.0
"""A stride that takes longer than this many sqrt(l0/g) + sqrt(m/k) is taken for none."""
DEFAULT_TIME = 10.0
"""Stop time, s, of a unit that does not count strides."""
ROWS = 1000
"""Rows of a run of such a unit, unless an output interval is given."""
FALLEN, STRIDES = "status.fallen", "stride.count"
ONLY_IN: Mapping[str, str] = {
    "status.terminate_on_fall": "me",
    "solver.method": "cs",
    "solver.relative_tolerance": "cs",
}
"""Settings that have a meaning in one interface only, and in which."""


@in_dataset(dataset_of)
def simulate(
    runner: RunnerLike = None,
    *,
    stop_time: float | None = None,
    strides: int | None = None,
    tolerance: float = DEFAULT_TOLERANCE,
    output_interval: float | None = None,
    inputs: InputTables | None = None,
    profile: Profile | None = None,
    variables: Iterable[str] | None = None,
    record_events: bool = True,
    interface: str | None = None,
    progress: bool = False,
    fmu: Fmu | None = None,
) -> Run:
    """Run the unit once through FMPy; a fall ends the run and is a result, not an error.

    A runner of a model of one's own, as `load_model` gives, is run by the unit of its build. A unit that does
    not count strides runs for 10 s by default, in a thousand rows. `trajectory` runs the engine instead.

    Parameters
    ----------
    runner : as in `find_gait`
        A gait begins at its apex.
    stop_time : float, optional
        End of the run, s; it begins at 0.
    strides : int, optional
        Strides after which the run ends, in Co-Simulation at the next recorded row. If an end time is given
        too, the run ends at whichever comes first; if neither is given, after ten strides.
    tolerance : float, default 1e-9
        Relative tolerance of CVODE. Absolute tolerances follow from the unit's nominal values. In
        Co-Simulation the tighter of it and `solver.relative_tolerance` holds.
    output_interval : float, optional
        Time between recorded rows, s. By default a tenth of sqrt(m/k), or half of that over a profile.
    inputs : InputTables, optional
        Tables by input name, see `inputs.InputTables`.
    profile : Profile, optional
        Uneven ground. At each recorded row the unit is given the line that is below the foot.
    variables : iterable of str, optional
        Names to record; by default every numeric input and output.
    record_events : bool, default True
        Keep the rows before and after each event (Model Exchange), not the regular ones only.
    interface : str, optional
        `me` (Model Exchange), the default, or `cs` (Co-Simulation), which a profile needs.
    progress : as in `sweep`
    fmu : Fmu, optional
        The unit to run; by default that of `fmu_path`.

    Returns
    -------
    xarray.Dataset
        Over `time` the recorded variables by their names, with units; at an event there are two rows of the
        same time. Over `event` their `event_time` and what happened, `event`. As attributes `fallen`, 1 if
        the run ended in a fall, and `fall_time`; the quantities of the last stride, such as `stride.word`,
        and of the last apex, such as `apex.com_height`; and the unit's `messages`.

    Raises
    ------
    InputError
        Something given is not allowed, by this package or by the unit; nothing was run.
    RunError
        The unit or FMPy failed, or the strides did not come about.

    Examples
    --------
    >>> import tdmf_slip
    >>> run = tdmf_slip.simulate({"ground.friction": 0.43}, strides=3)
    >>> print(run.attrs["stride.word"], run.attrs["stride.count"], run.fallen)
    +0- 3 0

    Over steps of random height:

    >>> steps = tdmf_slip.Profile.random_steps(count=10, tread=7.0, roughness=0.02, seed=1, begin=20.0)
    >>> run = tdmf_slip.simulate(strides=2, profile=steps)
    >>> print(run.attrs["stride.count"], run.fallen)
    2 0
    """
    own = model_of(runner, None)
    fmu = load_fmu(own.unit if own.is_page and fmu is None else fmu)  # type: ignore[attr-defined]
    interface = interface_over(profile, interface, inputs, fmu)
    given = own_start_values(runner, own, fmu) if own.is_page else start_values_of(runner)
    starts = fmu.variables.start_values(given, "start values")
    if isinstance(runner, Mapping) and not hasattr(runner, "start_values") and not own.is_page:
        paper_units.warn_of_mixture({n: fmu.variables.start_of(n, starts) for n in paper_units.COMPARED})
    counts = STRIDES in fmu.variables and set(SCALES) <= set(fmu.variables)
    if strides is not None and not counts:
        raise InputError(f"strides: the unit {fmu.path.name} does not count strides; give stop_time instead")
    if stop_time is not None or not counts:
        stop_time = checked("stop_time", DEFAULT_TIME if stop_time is None else stop_time, *TIMES, "s")
    elif strides is None:
        strides = DEFAULT_STRIDES
    if strides is not None:
        strides = checked_whole("strides", strides, 1, MAX_STRIDES)
    record_events = checked_flag("record_events", record_events)
    recorded = _recorded(fmu, variables)
    experiment = Experiment(
        stop_time=longest_time(fmu, starts, strides or 0) if stop_time is None else stop_time,
        tolerance=checked("tolerance", tolerance, *TOLERANCES),
        output_interval=_interval(fmu, starts, output_interval, profile is not None, stop_time),
        start_values=starts,
        inputs=signals(fmu, inputs, starts),
        variables=tuple(
            dict.fromkeys([*recorded, *(n for n in (MODE, PHASE, FALLEN) if n in fmu.variables)])
        ),
    )
    # No stride is shorter than sqrt(m/k), as the leg's spring has to swing back.
    least = math.inf if strides is None else strides * time_unit(fmu, starts)
    _check_rows(experiment, least if stop_time is None else min(least, stop_time))
    with opened(fmu, interface) as instance:
        table = _run(instance, experiment, profile, stop_time, strides, progress)
        run = _result(instance, experiment, table, recorded, not record_events, own.name)
    if strides is not None and stop_time is None and not run.fallen and run.strides < strides:
        raise RunError(
            f"only {run.strides} of {counted(strides, 'stride')} closed within {experiment.stop_time:g} s, "
            "and the runner did not fall; give a stop time to see what it does"
        )
    return run


def own_start_values(runner: RunnerLike, model: Model, fmu: Fmu) -> dict[str, Value]:
    """Start values of the unit for a runner of a model of one's own, or for its gait."""
    given = getattr(runner, "start_values", None)  # of a gait
    assert model.runner_class is not None
    values = given if isinstance(given, Mapping) else model.runner_class(runner)
    return {name if name in fmu.variables else f"start.{name}": value for name, value in values.items()}


run_unit = simulate.plain
"""Runs the unit once as `simulate` does, and returns the run itself."""


def time_unit(fmu: Fmu, starts: Mapping[str, Value]) -> float:
    """The paper's unit of time, sqrt(m/k), in s."""
    return paper_units.scale("s", {name: fmu.variables.start_of(name, starts) for name in SCALES})


def longest_time(fmu: Fmu, starts: Mapping[str, Value], strides: int) -> float:
    """A time, s, within which `strides` strides close if they close at all."""
    length, gravity = (fmu.variables.start_of(name, starts) for name in ("leg.free_length", "gravity"))
    return strides * LONGEST_STRIDE * (math.sqrt(length / gravity) + time_unit(fmu, starts))


def _recorded(fmu: Fmu, variables: Iterable[str] | None) -> list[str]:
    if variables is None:
        return fmu.variables.names("input") + fmu.variables.names("output")
    check_kind(variables, Iterable, "variables", NAMES)
    with reading("variables", variables, NAMES):
        names = [variables] if isinstance(variables, str) else list(islice(variables, MAX_NAMES))
    found = {
        variable.name: variable for variable in (fmu.variables.find(name, "variables") for name in names)
    }
    for variable in found.values():
        if variable.type == "String":
            raise InputError(
                f"variables: {variable.name} is a text and has no column; it is in the run's `final`"
            )
    return [name for name, variable in found.items() if variable.causality != "independent"]


def _interval(
    fmu: Fmu,
    starts: Mapping[str, Value],
    interval: float | None,
    over_profile: bool,
    stop_time: float | None,
) -> float:
    points = STEPS_PER_TIME_UNIT if over_profile else POINTS_PER_TIME_UNIT
    if interval is not None:
        return checked("output_interval", interval, *INTERVALS, "s")
    if stop_time is not None and not set(SCALES) <= set(fmu.variables):
        return stop_time / ROWS
    return time_unit(fmu, starts) / points


def _check_rows(experiment: Experiment, duration: float) -> None:
    """Refuse, before any work, more rows than there is room for; `duration` is the least that is run."""
    interval = experiment.output_interval
    if duration / interval > experiment.max_rows:
        raise InputError(
            f"output_interval = {interval:g}: {duration / interval:,.0f} rows up to {duration:g} s; "
            f"allowed: {experiment.max_rows:,} rows of "
            f"{counted(1 + len(experiment.variables), 'column')}; "
            f"raise the interval to about {duration / experiment.max_rows:.3g} s, or record fewer variables"
        )


def _run(
    instance: Instance,
    experiment: Experiment,
    profile: Profile | None,
    stop_time: float | None,
    strides: int | None,
    show: bool,
) -> NDArray[np.void]:
    total, unit = (strides, "strides") if stop_time is None else (stop_time, "s")
    if profile is not None:
        position = instance.fmu.variables.start_of("foot.x", experiment.start_values)
        line = _line_below(profile, float(position))
        experiment = replace(experiment, start_values={**experiment.start_values, **line})
    with progress_bar("simulate", total, unit, show) as bar:

        def step_finished(time: float, recorder: Recorder) -> bool:
            closed = instance.value(STRIDES) if strides is not None else 0
            bar.update((closed if stop_time is None else time) - bar.n)
            if len(recorder.rows) > experiment.max_rows:
                raise experiment.too_many_rows(time)
            if profile is not None:
                instance.set(_line_below(profile, instance.value("foot.x")))
                if instance.value(FALLEN):
                    return False
            if strides is None or closed < strides:
                return True
            recorder.sample(time)  # FMPy would stop before the row after the apex
            return False

        return instance.simulate(experiment, step_finished)


def _result(
    instance: Instance,
    experiment: Experiment,
    table: NDArray[np.void],
    recorded: list[str],
    regular: bool,
    model: str,
) -> Run:
    fmu = instance.fmu
    fallen = FALLEN in fmu.variables and instance.value(FALLEN)
    if fallen and not table[FALLEN][-1]:  # FMPy stops before it records the row in which the runner falls
        _, *names = table.dtype.names or ()
        last = (table["time"][-1], *instance.read(names).values())
        table = np.append(table, np.array([last], dtype=table.dtype))
    fall_time = float(table["time"][np.argmax(table[FALLEN])]) if fallen else None
    events = events_of(table, fmu.variables) if {MODE, PHASE} <= set(fmu.variables) else []
    if regular:
        table = _regular_rows(table, experiment.output_interval)
    names = ["time", *recorded]
    return Run(
        table=np.array(table[names], dtype=[(name, table.dtype[name]) for name in names]),
        variables=fmu.variables,
        fallen=fallen,
        fall_time=fall_time,
        version=fmu.version,
        model=model,
        start_values=fmu.variables.all_start_values(experiment.start_values),
        final=instance.read(fmu.variables),
        events=events,
        messages=list(instance.messages),
    )


def _regular_rows(table: NDArray[np.void], interval: float) -> NDArray[np.void]:
    """Rows on the grid of output points, the later one where an event fell on a point, and the last row."""
    steps = table["time"] / interval
    regular = np.abs(steps - np.round(steps)) < 1e-6
    later = np.append(np.diff(table["time"]) > 0, True)
    regular[-1] = True
    kept: NDArray[np.void] = table[regular & later]
    return kept
