"""Runners compared with what could confound them held equal to what the first of them has.

Two runners that differ in friction differ in speed, in how high they hop and in how high they carry the foot.
A difference between them says what friction does only where these are the same.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ..checks import is_one_of, near_matches, shown
from ..errors import InputError
from ..given import row_of
from ..library.gait import Gait
from ..library.members import MOVING, check_varied
from ..library.quantities import check_quantities, known_quantities, quantities_of, unit_of
from ..library.runner import Runner
from ..library.shared_steps import shares_steps
from ..record import origin_of
from ..terminal.progress import progress_bar
from ..terminal.text import headed, table
from ..variables.parameters import RunnerLike
from ..variables.table import VARIABLES, full_names
from ..variables.variable import Given
from .search import periodic_gait
from .targeted import TargetNotMetError, find_gait

MATCHED = 1e-8
"""Over its size: a quantity as near to the reference's is held."""


@dataclass(frozen=True)
class NotHeld:
    """A quantity that a runner could not be given."""

    runner: int
    """Its number; the reference is 0."""
    quantity: str
    """Name of the quantity."""
    wanted: float
    """Value of the reference."""
    has: float
    """Value of the runner that came nearest."""


@dataclass(frozen=True, eq=False)
class MatchedRunner:
    """A runner as it was given, and as it was matched to the reference."""

    parameters: Mapping[str, float]
    """Values of the matched runner, in the unit's units, that were varied or tell the runners apart."""
    before: Gait
    """The gait that it had."""
    after: Gait
    """The gait that it has with what is held as the reference has it, or as near to it as was found."""


@dataclass(frozen=True, eq=False, repr=False)
class Comparison:
    """Runners with the same speed, clearance or the like, whose differences have fewer causes."""

    hold: tuple[str, ...]
    """Quantities that are to be equal."""
    vary: tuple[str, ...]
    """Names of the parameters that may change for it."""
    runners: tuple[MatchedRunner, ...]
    """In the order in which they were given; the first is as it was."""
    not_held: tuple[NotHeld, ...]
    """Quantities that could not be made equal: empty where all runners are matched."""

    @property
    def gaits(self) -> tuple[Gait, ...]:
        """Values of the matched runners."""
        return tuple(matched.after for matched in self.runners)

    def __repr__(self) -> str:
        """In a line: how many runners, what is held equal by what, and what could not be."""
        missed = f", {len(self.not_held)} not held" if self.not_held else ""
        hold, vary = ", ".join(self.hold), ", ".join(self.vary)
        return f"<Comparison of {len(self.runners)} runners, {hold} held by {vary}{missed}>"

    def as_json(self) -> dict[str, object]:
        """The comparison as a plain object."""
        return {
            **origin_of(self.gaits[0].runner),
            "hold": list(self.hold),
            "vary": list(self.vary),
            "runners": [
                {
                    "parameters": dict(matched.parameters),
                    "runner": dict(matched.after.runner),
                    "before": _reported(matched.before),
                    "after": _reported(matched.after),
                }
                for matched in self.runners
            ],
            "not_held": [
                {"runner": of.runner, "quantity": of.quantity, "wanted": of.wanted, "has": of.has}
                for of in self.not_held
            ],
        }

    def table(self) -> str:
        """Every quantity of every runner, before and after, and what could not be held.

        Returns
        -------
        str
            Lines; a star marks what is held.
        """
        variables, label = VARIABLES, self.runners[0].after.runner.label
        columns = [
            (f"runner {number}{'' if step == 'after' else ' as given'}", getattr(matched, step))
            for number, matched in enumerate(self.runners)
            for step in (("after",) if number == 0 else ("before", "after"))
        ]
        rows = [
            (
                headed(name, label(variables[name].unit)),
                *(f"{gait.runner[name]:.6g}" for _, gait in columns),
            )
            for name in self.runners[0].parameters
        ]
        rows.append(("word", *(gait.word for _, gait in columns)))
        rows.append(("stable", *("yes" if gait.stable else "no" for _, gait in columns)))
        for name in known_quantities(self.runners[0].after.runner):
            mark = " *" if name in self.hold else ""
            values = (quantities_of(gait, [name])[name] for _, gait in columns)
            rows.append((headed(name, label(unit_of(name))) + mark, *(f"{value:.6g}" for value in values)))
        rows.append(("lambda_max", *(f"{gait.lambda_max:.6g}" for _, gait in columns)))
        lines = [table(("", *(title for title, _ in columns)), rows), "", "* held"]
        lines += [
            f"not held: {of.quantity} of runner {of.runner} is {of.has:.6g}, not {of.wanted:.6g}"
            for of in self.not_held
        ]
        return "\n".join(lines)


def _reported(gait: Gait) -> dict[str, object]:
    """A gait by its quantities."""
    return {
        "word": gait.word,
        "stable": gait.stable,
        "lambda_max": gait.lambda_max,
        **quantities_of(gait, known_quantities(gait.runner)),
    }


@shares_steps
def compare(
    runners: Sequence[RunnerLike],
    *,
    hold: Sequence[str],
    vary: Sequence[str],
    model: str | None = None,
    progress: bool = False,
) -> Comparison:
    """Runners made equal in what could confound a comparison.

    The first runner is the reference and stays as it is. Of each other one, what `vary` names is changed
    until its gait has what `hold` names as the reference has it, as `find_gait` does it; where no such gait
    is found, the nearest is taken and `not_held` says what differs.

    Parameters
    ----------
    runners : sequence of Runner, mapping of str to float, Gait or None
        Two or more: runners, or start values by the unit's names and in its units, over the unit's own; None
        is the unit's own runner. A gait is where the search for the runner's gait begins.
    hold : sequence of str
        Quantities of a gait that are to be equal, by names of `library.quantities.QUANTITIES`, as `speed`,
        `apex_height` and `foot_clearance`.
    vary : sequence of str
        Parameters and inputs that may change for it: as many as are held, or more. Of more, each step is the
        shortest one, over their values.
    model : str, optional
        `full` or `reduced`, as in `find_gait`.
    progress : bool, default False
        A bar on stderr.

    Returns
    -------
    Comparison
        Each runner before and after, and what could not be held.

    Raises
    ------
    InputError
        There are fewer than two runners, a name is unknown, nothing is held, or `find_gait` refuses what is
        varied.
    RunError
        A runner has no gait.

    Examples
    --------
    >>> import tdmf_slip
    >>> matched = tdmf_slip.compare(
    ...     [{"ground.friction": 0.2}, {"ground.friction": 10.0}],
    ...     hold=["speed", "apex_height", "apex_leg_angle"],
    ...     vary=["hip.stance_torque", "hip.touchdown_angle", "hip.liftoff_angle_factor"],
    ... )
    >>> matched.not_held, round(matched.gaits[1].stride["speed"], 6)
    ((), 0.83453)
    """
    given = row_of(runners, "runners", "a list of two runners or more")
    if len(given) < 2:
        raise InputError(f"runners: {len(given)} given; allowed: two or more, the first is the reference")
    names = _checked_hold(hold)
    before = [_gait_of(runner, model) for runner in given]
    own = before[0].runner.model
    varied = full_names(vary, "vary", "a list of names of parameters and inputs", own.aliases)
    for name in varied:
        check_varied(name, "vary", own)
    for gait in before:
        check_quantities(gait.runner, names)
    goal = quantities_of(before[0], names)
    matched, not_held = [before[0]], []
    with progress_bar("compare", len(before) - 1, "runners", progress) as bar:
        for number, gait in enumerate(before[1:], start=1):
            after, missing = _matched(gait, goal, varied, number, model)
            matched.append(after)
            not_held += missing
            bar.update()
    reported = _telling([*before, *matched], varied)
    return Comparison(
        names,
        varied,
        tuple(
            MatchedRunner({name: after.runner[name] for name in reported}, one, after)
            for one, after in zip(before, matched, strict=True)
        ),
        tuple(not_held),
    )


def _checked_hold(hold: object) -> tuple[str, ...]:
    names = tuple(row_of(hold, "hold", "a list of names of quantities"))
    known = known_quantities(Runner(None))
    if not names:
        raise InputError(f"hold: nothing is held; allowed: {', '.join(known)}")
    for name in names:
        if not is_one_of(name, known):
            raise InputError(
                f"hold {shown(name)} is not allowed{near_matches(name, known)}; allowed: {', '.join(known)}"
            )
        if names.count(name) > 1:
            raise InputError(f"hold: {name} is given twice; allowed: once")
    return names


def _gait_of(given: Runner | Mapping[str, Given] | Gait | None, model: str | None) -> Gait:
    if isinstance(given, Gait) and Runner(given, model=model) == given.runner:
        return given
    return periodic_gait(Runner(given, model=model))


def _matched(
    gait: Gait,
    goal: Mapping[str, float],
    vary: Sequence[str],
    number: int,
    model: str | None,
) -> tuple[Gait, list[NotHeld]]:
    """The gait with what is held, or the nearest one with what it lacks."""
    if _lacking(gait, goal, number) == []:
        return gait, []
    try:
        found = find_gait(gait.runner, target=goal, vary=vary, guess=gait.apex, model=model)
    except TargetNotMetError as problem:
        found = problem.nearest
    return found, _lacking(found, goal, number)


def _lacking(gait: Gait, goal: Mapping[str, float], number: int) -> list[NotHeld]:
    has = quantities_of(gait, list(goal))
    return [
        NotHeld(number, name, wanted, has[name])
        for name, wanted in goal.items()
        if abs(has[name] - wanted) > MATCHED * max(abs(wanted), abs(has[name]))
    ]


def _telling(gaits: Sequence[Gait], vary: Sequence[str]) -> tuple[str, ...]:
    """Parameters and inputs that are varied, or of which the runners have different values."""
    return tuple(name for name in MOVING if name in vary or len({gait.runner[name] for gait in gaits}) > 1)
