"""Runs of the unit until its strides repeat: what the gaits of the return map are held against."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass

import numpy as np
from numpy.typing import NDArray

from ..checks import checked, checked_whole
from ..errors import RunError
from ..fmu.fmu import Fmu, load_fmu
from ..fmu.instance import Experiment, Instance, Recorder, opened
from ..fmu.simulation import MAX_STRIDES as MAX_OF_ALL
from ..fmu.simulation import TOLERANCES, longest_time, time_unit
from ..given import mapping_of
from ..library.gait import REPORTED
from ..library.runner import Runner
from ..library.section import COORDINATES
from ..record import origin_of
from ..variables.table import FRICTION
from ..variables.variable import Given, Value

DEFAULT_TOLERANCE = 1e-10
WINDOW = 20
"""Strides averaged over: CVODE's own noise, some thousand tolerances, hides what single strides differ by."""
MAX_SPREAD = 20.0
"""How far strides may be from their mean, over what the mean itself may move; noise takes a tenth of that."""
MAX_STRIDES = 2000


@dataclass(frozen=True, eq=False)
class SettledRun:
    """A run of the unit that settled on a gait, by its last stride. Units as in the model description."""

    friction: float
    """Friction coefficient of the ground."""
    word: str
    """Word of the last stride."""
    period: float
    """Period of the last stride."""
    length: float
    """Length of the last stride."""
    speed: float
    """Speed of the last stride."""
    work: float
    """Work of the hip in the last stride."""
    cost_of_transport: float
    """Cost of transport of the last stride."""
    liftoff_angle: float
    """Angle of the leg at the last lift-off, rad."""
    apex: tuple[float, ...]
    """Section at the apex, in the order of `COORDINATES`."""
    start_values: Mapping[str, Value]
    """Everything a run needs to begin at this gait's apex: parameters, friction and state."""
    strides: int
    """How many were run."""
    change: float
    """How far the mean apex moved from the last window of strides but one to the last, over its scales."""

    def as_json(self) -> dict[str, object]:
        """The run as a plain object."""
        return {
            **origin_of(),
            **asdict(self),
            "apex": list(self.apex),
            "start_values": dict(self.start_values),
        }


def settle_fmu(
    given: Mapping[str, Given] | None = None,
    *,
    tolerance: float = DEFAULT_TOLERANCE,
    max_strides: int = MAX_STRIDES,
    fmu: Fmu | None = None,
) -> SettledRun:
    """Run the unit until its strides repeat: on a stable periodic gait, or never.

    Settled means: over the last twenty strides the word is one and the same, and the mean apex agrees with
    that of the twenty before within 1000 `tolerance`, each coordinate over its scale, and no stride
    is farther from the mean than 20 times that, as in a gait that repeats after two strides only.

    The gaits of the library, by `find_gait`, are found faster and to rounding, unstable ones too: this is
    how the unit is held against them.
    """
    fmu = load_fmu(fmu)
    starts = fmu.variables.start_values(mapping_of(given, "given", "start values by name"), "start values")
    runner = Runner(starts)
    max_strides = checked_whole("max_strides", max_strides, 2 * WINDOW, MAX_OF_ALL)
    tolerance = checked("tolerance", tolerance, *TOLERANCES)
    strides = _Strides(runner.scales, 1000.0 * tolerance)
    experiment = Experiment(
        stop_time=longest_time(fmu, starts, max_strides),
        tolerance=tolerance,
        output_interval=time_unit(fmu, starts),
        start_values=starts,
    )
    with opened(fmu) as instance:

        def step_finished(_time: float, _recorder: Recorder) -> bool:
            return strides.goes_on(instance) and len(strides.apexes) < max_strides

        instance.simulate(experiment, step_finished)
        return _settled_run(starts, runner, strides, instance)


class _Strides:
    """The apexes so far, and whether they have settled."""

    def __init__(self, scales: NDArray[np.float64], tolerance: float) -> None:
        self.scales = scales
        self.tolerance = tolerance
        self.apexes: list[list[float]] = []
        self.words: list[str] = []
        self.change = self.spread = float("inf")

    @property
    def settled(self) -> bool:
        steady = self.change <= self.tolerance and self.spread <= MAX_SPREAD * self.tolerance
        return steady and len(set(self.words[-WINDOW:])) == 1

    @property
    def obstacle(self) -> str:
        """Why the gait has not settled, in words."""
        words = list(dict.fromkeys(self.words[-WINDOW:]))
        if len(words) > 1:
            return f"the word goes on changing: {', '.join(words[:5])}"
        if self.change > self.tolerance:
            return f"the mean apex moved by {self.change:.2g} of its scales, allowed: {self.tolerance:.2g}"
        return (
            f"strides differ from their mean by {self.spread:.2g} of the apex's scales, "
            f"allowed: {MAX_SPREAD * self.tolerance:.2g}"
        )

    def goes_on(self, instance: Instance) -> bool:
        """Take the apex, if one more stride has closed; False once the gait has settled."""
        if instance.value("stride.count") > len(self.apexes):
            self.apexes.append([instance.value(f"apex.{name}") for name in COORDINATES])
            self.words.append(instance.value("stride.word"))
            self._measure()
        return not self.settled

    def _measure(self) -> None:
        if len(self.apexes) >= 2 * WINDOW:
            windows = np.array(self.apexes[-2 * WINDOW :]).reshape(2, WINDOW, -1) / self.scales
            before, last = windows.mean(axis=1)
            self.change = float(np.max(np.abs(last - before)))
            self.spread = float(np.max(np.abs(windows[1] - last)))


def _settled_run(
    starts: Mapping[str, Value], runner: Runner, strides: _Strides, instance: Instance
) -> SettledRun:
    count, friction = len(strides.apexes), runner[FRICTION]
    if instance.value("status.fallen"):
        raise RunError(f"no gait at friction {friction:g}: the runner fell after {count} strides")
    if not strides.settled:
        raise RunError(
            f"no gait at friction {friction:g}: not settled after {count} strides; over the last {WINDOW} "
            f"{strides.obstacle}"
        )
    apex = strides.apexes[-1]
    return SettledRun(
        friction=friction,
        word=strides.words[-1],
        **{name: instance.value(f"stride.{name}") for name in REPORTED},
        liftoff_angle=instance.value("hip.liftoff_angle"),
        apex=tuple(apex),
        start_values={**starts, FRICTION: friction, **runner.state_at(apex)},
        strides=count,
        change=strides.change,
    )
