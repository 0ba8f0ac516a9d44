"""Runs of the unit over a profile.

The unit knows one line of ground. A co-simulation gives it, at each communication point, the line of the
profile that is below the foot; the unit puts a new line in force as soon as the foot is in flight and not
below it. So a foot that stands keeps its ground, and one that hangs below a step passes it on its way up.
"""

import numpy as np
from numpy.typing import NDArray

from ..checks import check_kind
from ..errors import InputError
from ..terminal.progress import progress_bar
from .fmu import Fmu
from .inputs import InputTables
from .instance import Experiment, Instance
from .profile import Profile

STEPS_PER_TIME_UNIT = 20
"""Communication steps in each sqrt(m/k), unless an output interval is given."""
HEIGHT, SLOPE = "ground.height", "ground.slope"
TYPES = {"Real": float, "Boolean": bool}
"""Types of columns; others are whole numbers."""


def interface_over(profile: object, interface: str | None, inputs: InputTables | None, fmu: Fmu) -> str:
    """The interface of a run: Model Exchange unless another is given, over a profile Co-Simulation."""
    if profile is None:
        return "me" if interface is None else interface
    check_kind(profile, Profile, "profile", "a Profile")
    assert isinstance(profile, Profile)
    if interface not in (None, "cs"):
        raise InputError(f"interface = {interface!r}: a profile is run over in Co-Simulation; allowed: 'cs'")
    if inputs:
        raise InputError("profile and inputs: allowed: one of them")
    fmu.variables[SLOPE].value_of(profile.steepest, "profile, its steepest line")
    return "cs"


def run_over(
    instance: Instance, profile: Profile, experiment: Experiment, strides: int | None, progress: bool
) -> NDArray[np.void]:
    """A row at the start and after each output interval, up to a fall, the strides or the stop time."""
    fmu, step = instance.fmu, experiment.output_interval
    names = experiment.variables
    position = float(experiment.start_values.get("foot.x", fmu.variables.start_of("foot.x")))
    instance.start({**experiment.start_values, **_line_below(profile, position)}, experiment.tolerance)
    rows = [(0.0, *instance.read(names).values())]
    total, unit = (experiment.stop_time, "s") if strides is None else (strides, "strides")
    with progress_bar("simulate", total, unit, progress) as bar:
        while not instance.boolean("status.fallen"):
            time, closed = float(rows[-1][0]), instance.integer("stride.count")
            bar.update((time if strides is None else closed) - bar.n)
            if time >= experiment.stop_time or (strides is not None and closed >= strides):
                break
            if len(rows) > experiment.max_rows:
                raise experiment.too_many_rows(time)
            instance.set(_line_below(profile, instance.real("foot.x")))
            instance.advance(time, step)
            rows.append((len(rows) * step, *instance.read(names).values()))
    kinds = [("time", float), *((name, TYPES.get(fmu.variables[name].type, int)) for name in names)]
    return np.array(rows, dtype=kinds)


def _line_below(profile: Profile, position: float) -> dict[str, float]:
    """The unit's inputs for the line of ground at a position."""
    line = profile.line(position)
    return {HEIGHT: line.height, SLOPE: line.slope}
