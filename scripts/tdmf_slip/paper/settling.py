"""Periodic gaits, found by running until the strides repeat."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass

import numpy as np

from ..checks import check_kind, checked, checked_whole
from ..errors import RunError
from ..terminal import progress
from ..unit.instance import Experiment, Instance, opened
from ..unit.section import COORDINATES, scales, start_values
from ..unit.simulation import MOST_STRIDES as MOST_OF_ALL
from ..unit.simulation import TOLERANCES, longest_time, time_unit
from ..unit.unit import Unit, load

DEFAULT_TOLERANCE = 1e-10
WINDOW = 20
"""Strides averaged over: CVODE's own noise, some thousand tolerances, hides what single strides differ by."""
MOST_SPREAD = 20.0
"""How far strides may be from their mean, over what the mean itself may move; noise takes a tenth of that."""
MOST_STRIDES = 2000
QUANTITIES = ("period", "length", "speed", "work", "cost_of_transport")
"""Of the unit's group `stride`."""


@dataclass(frozen=True)
class Gait:
    """A periodic gait, by its last stride. Units as in the model description."""

    friction: float
    word: str
    period: float
    length: float
    speed: float
    work: float
    cost_of_transport: float
    liftoff_angle: float
    apex: tuple[float, ...]
    """Section at the apex, in the order of `section.COORDINATES`."""
    start_values: Mapping[str, float | bool]
    """Everything a run needs to begin at this gait's apex: parameters, friction and state."""
    strides: int
    """How many were run."""
    change: float
    """How far the mean apex moved from the last window of strides but one to the last, over its scales."""

    def as_json(self) -> dict[str, object]:
        """The gait as a plain object."""
        return {**asdict(self), "apex": list(self.apex), "start_values": dict(self.start_values)}


def periodic_gait(
    friction: float | None = None,
    given: Mapping[str, object] | None = None,
    *,
    relative_tolerance: float = DEFAULT_TOLERANCE,
    most_strides: int = MOST_STRIDES,
    show_progress: bool = False,
    unit: Unit | None = None,
) -> Gait:
    """Run the unit until its strides repeat: a stable periodic gait, or none.

    Settled means: over the last twenty strides the word is one and the same, and the mean apex agrees with
    that of the twenty before within 1000 `relative_tolerance`, each coordinate over its scale, and no stride
    is farther from the mean than 20 times that, as in a gait that repeats after two strides only.

    Parameters
    ----------
    friction : float, optional
        Start value of `ground.friction`; None for the unit's own or that in `given`.
    given : mapping of str to object, optional
        Further start values by name, numbers or texts like `40 deg`: parameters, and where to begin.
    relative_tolerance : float, default DEFAULT_TOLERANCE
        Of CVODE.
    most_strides : int, default MOST_STRIDES
        Give up after so many.
    show_progress : bool, default False
        A bar on stderr.
    unit : Unit, optional
        The unit to run; by default that of `fmu_path`.

    Raises
    ------
    InputError
        Something given is not allowed; nothing was run.
    RunError
        The runner fell, or did not settle.
    """
    unit = load(unit)
    check_kind(given or {}, Mapping, "given", "start values by name")
    wanted = {**(given or {}), **({} if friction is None else {"ground.friction": friction})}
    starts = unit.start_values(wanted, "start values")
    most_strides = checked_whole("most_strides", most_strides, 2 * WINDOW, MOST_OF_ALL)
    relative_tolerance = checked("relative_tolerance", relative_tolerance, *TOLERANCES)
    search = _Search(unit, starts, 1000.0 * relative_tolerance)
    experiment = Experiment(
        stop_time=longest_time(unit, starts, most_strides),
        relative_tolerance=relative_tolerance,
        output_interval=time_unit(unit, starts),
        start_values=starts,
    )
    mu = starts.get("ground.friction", unit.start_of("ground.friction"))
    with (
        opened(unit) as instance,
        progress.bar(f"gait at mu = {mu:g}", None, "strides", show_progress) as bar,
    ):

        def step_finished(_time: float, _recorder: object) -> bool:
            bar.update(instance.value("stride.count") - bar.n)
            return search.goes_on(instance) and len(search.apexes) < most_strides

        instance.simulate(experiment, step_finished)
        return _gait(unit, starts, search, instance, mu)


class _Search:
    """The apexes so far, and whether they have settled."""

    def __init__(self, unit: Unit, starts: Mapping[str, float | bool], tolerance: float) -> None:
        self.scales = np.array(scales(unit, starts))
        self.tolerance = tolerance
        self.apexes: list[list[float]] = []
        self.words: list[str] = []
        self.change = self.spread = float("inf")

    @property
    def settled(self) -> bool:
        steady = self.change <= self.tolerance and self.spread <= MOST_SPREAD * self.tolerance
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
            f"allowed: {MOST_SPREAD * self.tolerance:.2g}"
        )

    def goes_on(self, instance: Instance) -> bool:
        """Take the apex, if one more stride has closed; False once the gait has settled."""
        if instance.value("stride.count") > len(self.apexes):
            self.apexes.append(list(instance.read(f"apex.{name}" for name in COORDINATES).values()))
            self.words.append(instance.value("stride.word"))
            self._measure()
        return not self.settled

    def _measure(self) -> None:
        if len(self.apexes) >= 2 * WINDOW:
            windows = np.array(self.apexes[-2 * WINDOW :]).reshape(2, WINDOW, -1) / self.scales
            before, last = windows.mean(axis=1)
            self.change = float(np.max(np.abs(last - before)))
            self.spread = float(np.max(np.abs(windows[1] - last)))


def _gait(unit: Unit, starts: Mapping, search: _Search, instance: Instance, friction: float) -> Gait:
    count = len(search.apexes)
    if instance.value("status.fallen"):
        raise RunError(f"no gait at friction {friction:g}: the runner fell after {count} strides")
    if not search.settled:
        raise RunError(
            f"no gait at friction {friction:g}: not settled after {count} strides; over the last {WINDOW} "
            f"{search.obstacle}"
        )
    apex = tuple(search.apexes[-1])
    quantities = {name: instance.value(f"stride.{name}") for name in QUANTITIES}
    return Gait(
        friction=friction,
        word=search.words[-1],
        **quantities,
        liftoff_angle=instance.value("hip.liftoff_angle"),
        apex=apex,
        start_values={**starts, "ground.friction": friction, **start_values(unit, apex, starts)},
        strides=count,
        change=search.change,
    )
