"""Runner whose gait is to be proved, in doubles and exactly."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from numbers import Rational
from typing import TypeAlias

from flint import arb, fmpq

from ..analysis.search import periodic_gait
from ..checks import number_of, refusal, shown
from ..errors import InputError
from ..library.gait import Gait
from ..library.members import MOVING
from ..library.runner import Runner
from ..variables import parameters, units
from ..variables.table import VARIABLES
from ..variables.variable import Variable
from .laws import NAMES_ON_PAGE

LONGEST_TEXT = 1000
LONGEST_EXPONENT = 4
"""Characters of an exponent; a fraction has as many digits as it says."""
DEGREES = 180
"""Degrees in a half turn."""


@dataclass(frozen=True)
class Exact:
    """A rational number and a rational multiple of pi."""

    rational: Fraction
    """The rational part."""
    turns: Fraction = Fraction(0)
    """The multiple of pi."""

    def ball(self) -> arb:
        """Enclosure of the number to the working precision."""
        return ball_of(self.rational) + ball_of(self.turns) * arb.pi()

    def __str__(self) -> str:
        """The number as text, such as `2/5` or `2 pi/9`."""
        if not self.turns:
            return str(self.rational)
        numerator = "" if self.turns.numerator == 1 else f"{self.turns.numerator} "
        denominator = "" if self.turns.denominator == 1 else f"/{self.turns.denominator}"
        return f"{numerator}pi{denominator}"


class Flag(Exact):
    """A Boolean parameter: 1 or 0, written as `true` or `false`."""

    def __str__(self) -> str:
        """`true` or `false`."""
        return "true" if self.rational else "false"


def ball_of(value: Fraction) -> arb:
    """A rational number, enclosed to the working precision."""
    return arb(fmpq(value.numerator, value.denominator))


def fraction_in(text: str) -> Fraction:
    """The exact number of a text; a ValueError if it is not a number, or has too many digits."""
    exponent = text.lower().partition("e")[2]
    if "_" in text or len(text) > LONGEST_TEXT or len(exponent) > LONGEST_EXPONENT:
        raise ValueError(f"{shown(text)} is no number")
    return Fraction(text)


def exact_value(variable: Variable, given: object, where: str) -> Exact:
    """Exact number meant by a given value."""
    if variable.type == "Boolean":
        return Flag(Fraction(variable.value_of(given, where)))  # type: ignore[arg-type] # it checks the kind
    if not isinstance(given, str):
        number = variable.value_of(given, where)  # type: ignore[arg-type] # which refuses other kinds
        return Exact(Fraction(given) if isinstance(given, Rational) else Fraction(number))
    text, unit = _split(given)
    try:
        rational = fraction_in(text)
        variable.value_of(f"{float(rational)!r} {unit}", where)
    except (ValueError, ArithmeticError):
        raise refusal(f"{where}: {variable.name}", given, variable.allowed) from None
    if unit in ("", variable.unit):
        return Exact(rational)
    if unit.startswith("deg"):
        return Exact(Fraction(0), rational / DEGREES)
    return Exact(rational / Fraction(repr(variable.factor_of(unit))))


def _split(text: str) -> tuple[str, str]:
    """The number and the unit of a text; the number may be a fraction such as `3/5`."""
    number, _, unit = text.strip().partition(" ")
    return (number, units.spelled(unit)) if "/" in number else units.split(text)


def default_value(variable: Variable) -> Exact:
    """The unit's own start value as it is meant: the decimal, and an angle of whole degrees by pi."""
    assert variable.start is not None, variable.name
    if variable.type == "Boolean":
        return Flag(Fraction(variable.start))
    start = float(variable.start)
    degrees = round(math.degrees(start))
    if variable.unit == "rad" and degrees and math.isclose(math.radians(degrees), start, rel_tol=1e-15):
        return Exact(Fraction(0), Fraction(degrees, DEGREES))
    return Exact(Fraction(repr(start)))


def exact_values(values: Mapping[str, float], given: Mapping[str, object]) -> dict[str, Exact]:
    """All values of a runner, as exact numbers."""
    found = {}
    for name, value in values.items():
        variable = VARIABLES[name]
        if name in given or variable.type == "Boolean":
            found[name] = exact_value(variable, given.get(name, value), "start values")
        elif variable.start is not None and value == float(variable.start):
            found[name] = default_value(variable)
        else:
            found[name] = Exact(Fraction(value))
    return found


MAX_DIGITS = 200
MIN_BOX = Fraction(1, 10**MAX_DIGITS)
Radius: TypeAlias = float | str | Fraction
RunnerLike: TypeAlias = parameters.RunnerLike | Mapping[str, object]
"""A runner as any function takes it; start values may also be fractions."""


def gait_of(gait: RunnerLike) -> tuple[Gait, dict[str, Exact]]:
    """A gait, and its runner's parameters exactly."""
    given: dict[str, object] = {}
    if isinstance(gait, Gait):
        found = gait
    else:
        runner, given = runner_of(gait)
        found = periodic_gait(runner)
    if found.runner.reduced:
        raise InputError("a gait of the reduced map is not proved; allowed: one of the full model")
    if found.following:
        raise InputError(
            f"a gait of {found.strides} strides is not proved; allowed: one that repeats each stride"
        )
    return found, exact_runner(found.runner, given)


def exact_runner(runner: Runner, given: Mapping[str, object]) -> dict[str, Exact]:
    """The exact values of a runner; those in `given` are taken from there, not from its floats."""
    own = {name: runner[name] for name in MOVING}
    check_laws(own)
    return exact_values(own, {name: value for name, value in given.items() if name in own})


def check_laws(values: Mapping[str, float]) -> None:
    """Refuse a runner of laws that are not enclosed here, such as a patch of ground."""
    for name, value in values.items():
        start = VARIABLES.start_of(name)
        if name not in NAMES_ON_PAGE and value != start:
            raise InputError(
                f"{name} = {value:g}: gaits with it are not proved; allowed for proofs: {start:g}"
            )


def runner_of(given: RunnerLike) -> tuple[Runner, dict[str, object]]:
    """A runner in doubles, and the start values that were given for it, as they are meant."""
    if isinstance(given, Gait | Runner):
        return Runner(given), {}
    values = dict(parameters.start_values_of(given))
    exact = exact_values({name: 0.0 for name in values if name in VARIABLES}, values)
    floats = {name: float(exact[name].ball()) if name in exact else value for name, value in values.items()}
    return Runner(floats), values


def radius_of(box: Radius) -> Fraction:
    """Exact radius from an argument, which is checked here."""
    try:
        number = None if isinstance(box, str) else number_of(box)
        exact = box if isinstance(box, Rational) and number is not None else repr(number)
        radius = fraction_in(box) if isinstance(box, str) else Fraction(exact)
        if MIN_BOX <= radius <= 1:
            return radius
    except (ValueError, ArithmeticError):
        pass
    raise refusal("box", box, f"from 1e-{MAX_DIGITS} to 1")
