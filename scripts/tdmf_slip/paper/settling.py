"""Runs of the unit until its strides repeat, to check the gaits of the return map."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..checks import checked
from ..errors import RunError, counted
from ..fmu.fmu import Fmu, load_fmu
from ..fmu.run import Run
from ..fmu.simulation import TOLERANCES, run_unit, time_unit
from ..given import mapping_of
from ..library.gait import REPORTED
from ..library.runner import Runner
from ..library.section import COORDINATES
from ..record import entries, origin_of
from ..variables.table import FRICTION
from ..variables.variable import Given, Value

DEFAULT_TOLERANCE = 1e-10
WINDOW = 20
"""Strides averaged over: CVODE's own noise, some thousand tolerances, hides what single strides differ by."""
STRIDES = 2 * WINDOW, 6 * WINDOW, 50 * WINDOW
"""Strides of a run, and of longer ones where the runner has not settled by then."""
MAX_SPREAD = 20.0
"""Largest deviation of a stride from the mean, over that of the mean itself; noise takes a tenth of it."""
QUANTITIES = {name: f"stride.{name}" for name in REPORTED} | {"liftoff_angle": "hip.liftoff_angle"}
"""Reported quantities, and their names in the unit."""
APEX = tuple(f"apex.{name}" for name in COORDINATES)


@dataclass(frozen=True, eq=False)
class SettledRun:
    """A run of the unit that settled on a gait, by its last stride. Units as in the model description."""

    friction: float
    """Friction coefficient of the ground."""
    word: str
    """Word of the last stride."""
    stride: Mapping[str, float]
    """Quantities of the last stride, by the names in `QUANTITIES`."""
    apex: tuple[float, ...]
    """Section at the apex, in the order of `COORDINATES`."""
    start_values: Mapping[str, Value]
    """Start values of a run from this gait's apex: parameters, friction and state."""
    strides: int
    """Number of strides in the run."""
    change: float
    """Change of the mean apex from the last window of strides but one to the last, over its scales."""

    def as_json(self) -> dict[str, object]:
        """The run as a plain object."""
        return {
            **origin_of(),
            **entries(self, "friction", "word"),
            **self.stride,
            **entries(self, "apex", "start_values", "strides", "change"),
        }


def settle_fmu(
    given: Mapping[str, Given] | None = None, *, tolerance: float = DEFAULT_TOLERANCE, fmu: Fmu | None = None
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
    runner, tolerance = Runner(starts), checked("tolerance", tolerance, *TOLERANCES)
    recorded = ["stride.count", "stride.word_code", *APEX]
    change, obstacle = np.inf, ""
    how: dict[str, Any] = {"tolerance": tolerance, "output_interval": time_unit(fmu, starts)}
    for strides in STRIDES:
        run = run_unit(starts, strides=strides, variables=recorded, fmu=fmu, **how)
        if run.fallen:
            count = run.stride["count"]
            raise RunError(
                f"no gait at friction {runner[FRICTION]:g}: the runner fell after {counted(count, 'stride')}"
            )
        change, obstacle = _obstacle(run, runner, 1000.0 * tolerance)
        if not obstacle:
            apex = tuple(run.apex[name] for name in COORDINATES)
            return SettledRun(
                friction=runner[FRICTION],
                word=str(run.stride["word"]),
                stride={name: float(run.final[of]) for name, of in QUANTITIES.items()},
                apex=apex,
                start_values={**starts, FRICTION: runner[FRICTION], **runner.state_at(apex)},
                strides=int(run.stride["count"]),
                change=change,
            )
    raise RunError(
        f"no gait at friction {runner[FRICTION]:g}: not settled after {STRIDES[-1]} strides; over the last "
        f"{WINDOW} {obstacle}"
    )


def _obstacle(run: Run, runner: Runner, allowed: float) -> tuple[float, str]:
    """Change of the mean apex from window to window, and in words why the gait has not settled."""
    rows = np.flatnonzero(np.diff(run.table["stride.count"]) > 0)[-2 * WINDOW :] + 1
    apexes = np.stack([run.table[name][rows] for name in APEX], axis=1)
    windows = apexes.reshape(2, WINDOW, -1) / runner.scales
    before, last = windows.mean(axis=1)
    change, spread = float(np.max(np.abs(last - before))), float(np.max(np.abs(windows[1] - last)))
    if len(set(run.table["stride.word_code"][rows[WINDOW:]])) > 1:
        return change, "the word goes on changing"
    if change > allowed:
        return change, f"the mean apex moved by {change:.2g} of its scales, allowed: {allowed:.2g}"
    if spread > MAX_SPREAD * allowed:
        limit = MAX_SPREAD * allowed
        return change, f"strides differ from their mean by {spread:.2g} of the scales, allowed: {limit:.2g}"
    return change, ""
