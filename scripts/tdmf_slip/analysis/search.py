"""The gait of a runner: near a guess, by settling, along the friction, or from starts everywhere."""

from collections.abc import Mapping
from dataclasses import replace

from ..checks import is_one_of, shown
from ..errors import InputError, RunError
from ..library.orbit import Orbit, orbit_near, settled_orbit
from ..library.return_map import Along
from ..library.runner import Runner
from ..library.section import MODELS, Apex
from ..unit.unit import FRICTION, Unit, load
from ..unit.variable import Given
from .continuation import gaits_over
from .spread import search_from_spread


def runner_by(runner: Runner, model: str | None) -> Runner:
    """The same runner by one of the models.

    Parameters
    ----------
    runner : Runner
        Which runner.
    model : str, optional
        One of `MODELS`; by default the runner stays as it is.

    Returns
    -------
    Runner
        By that model.

    Raises
    ------
    InputError
        There is no such model.
    """
    if model is not None and not is_one_of(model, MODELS):
        raise InputError(f"model {shown(model)} is not allowed; allowed: {', '.join(MODELS)}")
    return runner if model is None else replace(runner, reduced=model == "reduced")


def model_of(runner: Runner) -> dict[str, str]:
    """What the attributes of a file say of a runner's map from apex to apex.

    Parameters
    ----------
    runner : Runner
        Whose results are on file.

    Returns
    -------
    dict of str to str
        Nothing for the full model.
    """
    return {"model": "reduced"} if runner.reduced else {}


def find_orbit(
    runner: Runner | Mapping[str, Given] | None = None,
    guess: Apex | None = None,
    *,
    along: Along | None = None,
    model: str | None = None,
    unit: Unit | None = None,
) -> Orbit:
    """The periodic gait of a runner, stable or not, with its eigenvalues.

    With a guess, the gait near it, by Newton's method on the return map. Without one, the gait that the
    runner settles on from its start values; where it falls or does not settle, the gait that is reached
    along the friction from the unit's own; and where none is, one from starts all over the section that run
    side by side, a stable one if there is, see `spread.search_from_spread`. These are always the same starts,
    so that the same gait is found each time; the search takes a second or two.

    Parameters
    ----------
    runner : Runner or mapping of str to float, optional
        Whose gait: a runner, or start values by the unit's names and in its units, over the unit's own.
    guess : sequence of float, shape (6,), optional
        An apex near the gait's, in the order of `library.section.COORDINATES`: m, m/s, m, rad, m/s, rad/s;
        for the reduced map the first two.
    along : str or mapping of str to float, optional
        A parameter or input by which the next apex is differentiated, too; or a direction of several.
    model : str, optional
        One of `MODELS`: `full`, or `reduced` for the map of an apex's height and speed, with the leg placed
        in flight as if by itself. By default that of the runner.
    unit : Unit, optional
        Whose start values hold; by default that of `fmu_path`.

    Returns
    -------
    Orbit
        Apex, word, quantities of the stride, Jacobian and eigenvalues of the map.

    Raises
    ------
    InputError
        The guess is no apex, the start values are refused or not in flight, `along` or `model` is unknown, or
        the friction is 0.
    RunError
        No gait was found; the message says what happened on the way.

    Examples
    --------
    >>> import tdmf_slip
    >>> gait = tdmf_slip.find_orbit({"ground.friction": 0.2})
    >>> gait.word, gait.stable
    ('+-', True)
    """
    runner = runner_by(Runner.of(runner, unit), model)
    if guess is not None:
        return orbit_near(runner, guess, along=along)
    try:
        return settled_orbit(runner, along=along)
    except RunError as problem:
        found, tried = _beyond_settling(runner, along, load(unit))
        if found is None:
            raise RunError(f"{problem}; {tried}: a guess near its apex helps where there is one") from None
        return found if along in (None, found.along) else orbit_near(runner, found.apex, along=along)


def _beyond_settling(runner: Runner, along: Along | None, unit: Unit) -> tuple[Orbit | None, str]:
    """A gait by the longer searches, or what was tried, in words."""
    found = _along_friction(runner, unit)
    if found is not None:
        return found, ""
    spread = search_from_spread(runner, along=along)
    if spread.gaits:
        return spread.gaits[0], ""
    home = unit.start_of(FRICTION)
    way = f"along the friction from {home:g}, nor " if runner.values[FRICTION] != home else ""
    return None, f"none was found {way}from {spread}"


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
