"""Whose gait is to be proved, as it is given: in doubles, and exactly."""

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from ..analysis.search import periodic_gait
from ..checks import check_kind
from ..errors import InputError
from ..library.gait import Gait
from ..library.members import VARIED
from ..library.runner import Runner
from ..unit.unit import load_fmu
from .exact import Exact, exact_values

MAX_DIGITS = 200
MIN_BOX = Fraction(1, 10**MAX_DIGITS)
KNOWN = frozenset(
    {
        *("body.mass", "foot.mass", "gravity", "body.external_fx", "body.external_fy"),
        *("leg.stiffness", "leg.damping", "leg.free_length", "leg.min_length", "leg.thrust", "leg.extension"),
        *("ground.friction", "ground.static_friction_ratio", "ground.stribeck_velocity"),
        *("ground.slope", "ground.height"),
        *("hip.stance_torque", "hip.touchdown_angle", "hip.kp", "hip.kd", "hip.liftoff_angle_factor"),
        *("hip.retraction_rate", "hip.external_torque"),
        *("control.touchdown_angle", "control.stance_torque", "control.thrust"),
    }
)
"""Parameters and inputs that the enclosures take account of."""
Given = Gait | Runner | Mapping[str, object] | None
Radius = float | str | Fraction


def gait_of(gait: Given) -> tuple[Gait, dict[str, Exact]]:
    """A gait, and its runner's parameters exactly."""
    fmu = load_fmu()
    given: dict[str, object] = {}
    if isinstance(gait, Gait):
        found = gait
    elif gait is None or isinstance(gait, Runner):
        found = periodic_gait(gait, fmu=fmu)
    else:
        check_kind(gait, Mapping, "gait", "a Gait, a Runner, or start values by name")
        given = dict(gait)
        exact = exact_values(fmu, {name: 0.0 for name in given if name in fmu.variables}, given)
        floats = {
            name: float(exact[name].ball()) if name in exact else value for name, value in given.items()
        }
        found = periodic_gait(floats, fmu=fmu)
    if found.runner.reduced:
        raise InputError("a gait of the reduced map is not proved; allowed: one of the full model")
    if found.following:
        raise InputError(
            f"a gait of {found.strides} strides is not proved; allowed: one that repeats each stride"
        )
    own = {name: found.runner.values[name] for name in VARIED}
    check_laws(own)
    return found, exact_values(fmu, own, {name: value for name, value in given.items() if name in own})


def check_laws(values: Mapping[str, float]) -> None:
    """Refuse a runner of laws that are not enclosed here, such as a patch of ground."""
    fmu = load_fmu()
    for name, value in values.items():
        start = fmu.start_of(name)
        if name not in KNOWN and value != start:
            raise InputError(
                f"{name} = {value:g}: gaits with it are not proved; allowed for proofs: {start:g}"
            )


def floats_of(given: Mapping[str, object]) -> dict[str, Any]:
    """Start values as floats, near those that are meant."""
    fmu = load_fmu()
    exact = exact_values(fmu, {name: 0.0 for name in given if name in fmu.variables}, given)
    return {name: float(exact[name].ball()) if name in exact else value for name, value in given.items()}


def radius_of(box: Radius) -> Fraction:
    """A radius that is asked for."""
    try:
        radius = Fraction(repr(box) if isinstance(box, float) else box)
    except (TypeError, ValueError, OverflowError, ZeroDivisionError):
        radius = Fraction(0)
    if not MIN_BOX <= radius <= 1:
        raise InputError(f"box = {box!r} is not allowed; allowed: from 1e-{MAX_DIGITS} to 1")
    return radius
