"""The gait of a runner, wherever it begins: by settling, else along the friction from one that is known."""

from collections.abc import Mapping

from ..errors import RunError
from ..library.orbit import Orbit, find_orbit
from ..library.runner import Runner
from ..unit.unit import FRICTION, Unit, load
from .continuation import gaits_over


def first_orbit(runner: Runner | Mapping[str, object], unit: Unit | None = None) -> Orbit:
    """A gait of a runner: by settling from its start values, else along the friction from the unit's own.

    Raises
    ------
    RunError
        Neither finds one.
    """
    runner = Runner.of(runner)
    try:
        return find_orbit(runner, along=FRICTION)
    except RunError as problem:
        unit = load(unit)
        home = unit.start_of(FRICTION)
        if runner.values[FRICTION] == home:
            raise
        try:
            start = find_orbit(runner.but(FRICTION, home), along=FRICTION)
            return next(gaits_over(runner, FRICTION, [runner.values[FRICTION]], start))
        except RunError:
            raise problem from None
