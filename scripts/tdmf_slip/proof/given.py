"""Whose gait is to be proved, as it is given: in doubles, and exactly."""

from collections.abc import Mapping
from fractions import Fraction
from numbers import Rational
from typing import TypeAlias

from ..analysis.search import periodic_gait
from ..checks import number_of, refusal
from ..errors import InputError
from ..library.gait import Gait
from ..library.members import MOVING
from ..library.runner import Runner
from ..variables import parameters
from ..variables.table import VARIABLES
from .exact import Exact, exact_values, fraction_in

MAX_DIGITS = 200
MIN_BOX = Fraction(1, 10**MAX_DIGITS)
KNOWN = frozenset(
    {
        *("body.mass", "foot.mass", "gravity", "body.external_fx", "body.external_fy"),
        *("leg.stiffness", "leg.damping", "leg.free_length", "leg.min_length", "leg.thrust", "leg.extension"),
        *("ground.friction", "ground.static_friction_ratio", "ground.stribeck_velocity"),
        *("ground.slope", "ground.height"),
        *("hip.stance_torque", "hip.touchdown_angle", "hip.kp", "hip.kd", "hip.liftoff_angle_factor"),
        *("hip.retraction_rate", "hip.swing_clamp", "hip.external_torque"),
        *("control.touchdown_angle", "control.stance_torque", "control.thrust"),
    }
)
"""Parameters and inputs that the enclosures take account of."""
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
    own = {name: found.runner[name] for name in MOVING}
    check_laws(own)
    return found, exact_values(own, {name: value for name, value in given.items() if name in own})


def check_laws(values: Mapping[str, float]) -> None:
    """Refuse a runner of laws that are not enclosed here, such as a patch of ground."""
    for name, value in values.items():
        start = VARIABLES.start_of(name)
        if name not in KNOWN and value != start:
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
    """A radius that is asked for."""
    try:
        number = None if isinstance(box, str) else number_of(box)
        exact = box if isinstance(box, Rational) and number is not None else repr(number)
        radius = fraction_in(box) if isinstance(box, str) else Fraction(exact)
        if MIN_BOX <= radius <= 1:
            return radius
    except (ValueError, ArithmeticError):
        pass
    raise refusal("box", box, f"from 1e-{MAX_DIGITS} to 1")
