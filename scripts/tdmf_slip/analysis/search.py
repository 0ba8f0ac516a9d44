"""The gait of a runner, wherever it begins: near a guess, by settling, or along the friction."""

from collections.abc import Mapping

from ..errors import RunError
from ..library.orbit import Orbit, orbit_near, settled_orbit
from ..library.runner import Runner
from ..library.section import Apex
from ..unit.unit import FRICTION, Unit, load
from ..unit.variable import Given
from .continuation import gaits_over


def find_orbit(
    runner: Runner | Mapping[str, Given] | None = None,
    guess: Apex | None = None,
    *,
    along: str | None = None,
    unit: Unit | None = None,
) -> Orbit:
    """The periodic gait of a runner, stable or not, with its eigenvalues.

    With a guess, the gait near it, by Newton's method on the return map. Without one, the gait that the
    runner settles on from its start values; where it falls or does not settle, the gait that is reached
    along the friction from the unit's own.

    Parameters
    ----------
    runner : Runner or mapping of str to float, optional
        Whose gait: a runner, or start values by the unit's names and in its units, over the unit's own.
    guess : sequence of float, shape (6,), optional
        An apex near the gait's, in the order of `library.section.COORDINATES`: m, m/s, m, rad, m/s, rad/s.
    along : str, optional
        A parameter or input by which the next apex is differentiated, too.
    unit : Unit, optional
        Whose start values hold; by default that of `fmu_path`.

    Returns
    -------
    Orbit
        Apex, word, quantities of the stride, Jacobian and eigenvalues of the return map.

    Raises
    ------
    InputError
        The guess is no apex, the start values are refused or not in flight, `along` is unknown, or the
        friction is 0.
    RunError
        No gait was found; the message says what happened on the way.

    Examples
    --------
    >>> import tdmf_slip
    >>> gait = tdmf_slip.find_orbit({"ground.friction": 0.2})
    >>> gait.word, gait.stable
    ('+-', True)
    """
    runner = Runner.of(runner, unit)
    if guess is not None:
        return orbit_near(runner, guess, along=along)
    try:
        return settled_orbit(runner, along=along)
    except RunError as problem:
        found = _along_friction(runner, load(unit))
        if found is None:
            raise problem from None
        return found if along in (None, found.along) else orbit_near(runner, found.apex, along=along)


def _along_friction(runner: Runner, unit: Unit) -> Orbit | None:
    """The gait that is reached from the one at the unit's own friction; None where there is none."""
    home = unit.start_of(FRICTION)
    if runner.values[FRICTION] == home:
        return None
    try:
        start = settled_orbit(runner.but(FRICTION, home), along=FRICTION)
        return next(gaits_over(runner, FRICTION, [runner.values[FRICTION]], start))
    except RunError:
        return None
