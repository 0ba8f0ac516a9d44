"""Quantities of a stride: names and units, values in the library's strides, and exact derivatives."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..checks import check_names, choice_of, shown
from ..errors import InputError
from ..variables import units
from ..variables.table import MODELS, Model
from .section import REDUCED

if TYPE_CHECKING:
    from .gait import Gait
    from .runner import Runner


STRIDE_QUANTITIES = (
    "period",
    "length",
    "rise",
    "speed",
    "work",
    "hip_work",
    "leg_work",
    "positive_work",
    "cost_of_transport",
    "touchdowns",
    "stance_time",
    "duty_factor",
    "slip_distance",
    "peak_force",
    "peak_vertical_force",
)
"""Quantities in the record of any stride."""
LEDGER = ("external_work", "damper_loss", "friction_loss", "impact_loss")
"""Terms that, with the work of hip and leg, close the balance of energy of a stride, J."""
MEASURES = (
    "apex_height",
    "apex_speed",
    "apex_leg_angle",
    "foot_clearance",
    "greatest_foot_height",
    "positive_hip_work",
    "positive_leg_work",
    "positive_work",
    "positive_cost_of_transport",
    "squared_torque",
    "greatest_slip_velocity",
    "friction_loss",
)
"""Quantities that are measured along a stride of the full model besides."""
APEX_QUANTITIES = {q.name: q.coordinate for q in MODELS["full"].quantities.values() if q.coordinate}
"""Quantities that are coordinates of the apex at which a stride begins."""
ORDERED_OF_BOTH = (
    "speed",
    "frequency",
    "length",
    "stance_time",
    "duty_factor",
    "slip_distance",
    "peak_force",
    "peak_vertical_force",
    "cost_of_transport",
)
"""Quantities of both maps that a gait can be ordered by; the frequency is that of strides."""
QUANTITIES = (*ORDERED_OF_BOTH, *MEASURES)
"""All that a gait can be ordered by."""
REDUCED_QUANTITIES = (*ORDERED_OF_BOTH, *(name for name, of in APEX_QUANTITIES.items() if of in REDUCED))
"""Quantities of the reduced map, whose leg is placed in flight as if by itself."""
SIGNED = ("apex_leg_angle",)
"""Quantities that may be 0 or less."""
PER_DISTANCE = {"cost_of_transport": "work", "positive_cost_of_transport": "positive_work"}
"""Works that are divided by weight and length of the stride."""
RATES = {"speed": "length", "duty_factor": "stance_time"}
"""Quantities that are divided by the period."""
OF_WEIGHT = ("body.mass", "foot.mass", "gravity")
MEASURED = tuple(name for name in MEASURES if name not in (*APEX_QUANTITIES, "foot_clearance"))
"""Quantities that the full model has to measure along the stride."""
_VARIED = ("period", "length", "work", "stance_time", "slip_distance", "peak_force", "peak_vertical_force")
"""Recorded quantities whose derivatives the library has."""


@cache
def differentiable(reduced: bool) -> tuple[str, ...]:
    """Quantities with exact derivatives."""
    known = REDUCED_QUANTITIES if reduced else QUANTITIES
    return (*_VARIED, *(name for name in known if name not in _VARIED))


@cache
def reported_quantities(reduced: bool) -> tuple[str, ...]:
    """Quantities of a stride by the return map or the reduced one, with its lift-off angle."""
    more = tuple(APEX_QUANTITIES)[:2] if reduced else MEASURES
    names = (*STRIDE_QUANTITIES, "frequency", *LEDGER, "liftoff_angle", *more)
    return tuple(dict.fromkeys(names))


def weight_of(values: Mapping[str, Any]) -> Any:
    """Weight of body and foot, N, for parameters by name."""
    return (values["body.mass"] + values["foot.mass"]) * values["gravity"]


def weight_by(values: Mapping[str, Any], name: str) -> Any:
    """Derivative of the weight by a parameter."""
    if name in ("body.mass", "foot.mass"):
        return values["gravity"]
    return values["body.mass"] + values["foot.mass"] if name == "gravity" else 0.0


def unit_of(quantity: str, model: Model = MODELS["full"]) -> str:
    """The unit of a quantity; `1` for one that is not in the table."""
    known = model.full.quantities.get(quantity)
    return "1" if known is None else known.unit


def quantity_given(name: str, given: object, where: str, model: Model = MODELS["full"]) -> object:
    """The prescribed value of a quantity; a text is converted to the quantity's unit."""
    if not isinstance(given, str):
        return given
    own = unit_of(name, model)
    number, unit = units.split(given)
    factor = units.factor(unit, own, {})
    try:
        value = float(number)
    except ValueError:
        value = None
    if factor is None or value is None:
        in_unit = "" if own == "1" else f" in {own}"
        raise InputError(f"{where} {name} = {shown(given)} is not allowed; allowed: a number{in_unit}")
    return value / factor


def quantities_of(gait: Gait, names: Sequence[str]) -> dict[str, float]:
    """Values of a gait's quantities, by names of possible targets."""
    check_quantities(gait.runner, names)
    return {name: gait.reported[name] for name in names}


def known_quantities(runner: Runner) -> tuple[str, ...]:
    """The quantities that a runner's map has."""
    return REDUCED_QUANTITIES if runner.reduced else allowed_quantities(runner.model)


def allowed_quantities(model: Model) -> tuple[str, ...]:
    """The quantities that may be prescribed, minimized or maximized; the reduced map has some of them."""
    own = tuple(name for name in model.quantities if name != "liftoff_angle")
    return own if model.is_page else QUANTITIES


def choice_of_quantities(model: Model) -> str:
    """The quantities that may be prescribed, minimized or maximized, in a message."""
    return choice_of(allowed_quantities(model), _listed_by(model))


def _listed_by(model: Model) -> str:
    return "" if model.is_page else "tdmf-slip gait --help"


def checked_quantity(name: object, what: str, model: Model) -> str:
    """The name of a quantity."""
    check_names([name], allowed_quantities(model), what, listed_by=_listed_by(model))
    return str(name)


def check_quantities(runner: Runner, names: Sequence[str]) -> None:
    """Refuse quantities that the runner's map does not have."""
    known = known_quantities(runner)
    for name in names:
        if name not in known:
            whose = f"model {runner.model.name}" if runner.model.is_page else "reduced map"
            raise InputError(
                f"the {whose} has no quantity {name}; allowed: {choice_of(known, _listed_by(runner.model))}"
            )


def scales_of(runner: Runner, parameters: Sequence[str]) -> NDArray[np.float64]:
    """Scales of the coordinates and of parameters: of these the value that each has, or 1 where it is 0."""
    return np.array([*runner.scales, *(abs(runner[name]) or 1.0 for name in parameters)])
