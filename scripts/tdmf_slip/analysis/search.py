"""The gait of a runner: near a guess, by settling, along the friction, or from starts everywhere."""

from ..errors import GaitNotFoundError, RunError
from ..library.fixed_point import gait_near, settled_gait
from ..library.gait import Gait
from ..library.members import check_comes_down
from ..library.return_map import Along
from ..library.runner import Runner
from ..library.section import Apex
from ..library.shared_steps import shares_steps
from ..variables.parameters import RunnerLike
from ..variables.table import FRICTION, VARIABLES
from .branch_problem import gaits_over
from .spread import search_from_spread


@shares_steps
def periodic_gait(
    runner: RunnerLike = None,
    guess: Apex | None = None,
    *,
    along: Along | None = None,
    model: str | None = None,
) -> Gait:
    """The gait of `find_gait` without a target, differentiated along a parameter too where that is wanted."""
    runner = Runner(runner, model=model)
    if guess is not None:
        return gait_near(runner, guess, along=along)
    check_comes_down(runner)
    try:
        return settled_gait(runner, along=along)
    except RunError as problem:
        found, tried = _beyond_settling(runner, along)
        if found is None:
            raise GaitNotFoundError(
                f"{problem}; {tried}: a guess near its apex helps where there is one"
            ) from None
        return found if along in (None, found.along) else gait_near(runner, found.apex, along=along)


def _beyond_settling(runner: Runner, along: Along | None) -> tuple[Gait | None, str]:
    """A gait by the longer searches, or what was tried, in words."""
    found = _along_friction(runner)
    if found is not None:
        return found, ""
    spread = search_from_spread(runner, along=along)
    if spread.gaits:
        return spread.gaits[0], ""
    home = VARIABLES.start_of(FRICTION)
    way = f"along the friction from {home:g}, nor " if runner[FRICTION] != home else ""
    return None, f"none was found {way}from {spread}"


def _along_friction(runner: Runner) -> Gait | None:
    """The gait that is reached from the one at the unit's own friction; None where there is none."""
    home = VARIABLES.start_of(FRICTION)
    if runner[FRICTION] == home:
        return None
    try:
        start = settled_gait(runner.replace({FRICTION: home}), along=FRICTION)
        return next(gaits_over(runner, FRICTION, [runner[FRICTION]], start))
    except RunError:
        return None
