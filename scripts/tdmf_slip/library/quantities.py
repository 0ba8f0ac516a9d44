"""Quantities of a stride: names and units, values in the library's strides, and exact derivatives."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..checks import is_one_of, near_matches, shown
from ..errors import InputError
from ..variables import units
from ..variables.table import MODELS, Model
from .runner import Runner
from .section import COORDINATES, REDUCED, Apex

if TYPE_CHECKING:
    from .gait import Gait


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
_PER_DISTANCE = {"cost_of_transport": "work", "positive_cost_of_transport": "positive_work"}
_MEASURED = ("positive_hip_work", "positive_leg_work", "squared_torque", "friction_loss")
_GREATEST = ("greatest_slip_velocity", "greatest_foot_height")
MEASURED = (*_MEASURED, *_GREATEST, "positive_work", "positive_cost_of_transport")
"""Quantities that the full model has to measure along the stride."""
_VARIED = ("period", "length", "work", "stance_time", "slip_distance", "peak_force", "peak_vertical_force")
"""Recorded quantities whose derivatives the library has."""


class Quantities:
    """Quantities of strides by name, from the library's structs of strides.

    Parameters
    ----------
    strides : structured ndarray
        `tdmf_return` or `tdmf_ensemble_stride` structs of any shape.
    apices : ndarray of float, shape (..., n)
        Where the strides begin.
    weight : float or ndarray
        Weight of each runner, N.
    is_measured : bool
        The structs hold what is measured along a stride of the full model.
    """

    def __init__(
        self,
        strides: NDArray[Any],
        apices: NDArray[np.float64],
        weight: float | NDArray[np.float64],
        is_measured: bool,
    ) -> None:
        self.strides, self.apices, self.weight, self.is_measured = strides, apices, weight, is_measured

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        """The values, in the shape of the strides."""
        if name in APEX_QUANTITIES:
            values: NDArray[np.float64] = self.apices[..., COORDINATES.index(APEX_QUANTITIES[name])]
            return values
        if name == "frequency":
            return _ratio(1.0, self["period"])
        if self.is_measured:
            if name == "positive_work":
                return self["positive_hip_work"] + self["positive_leg_work"]
            if name in (*_MEASURED, *_GREATEST):
                return np.asarray(self.strides["measures"][name])
            if name == "positive_cost_of_transport":
                return _ratio(self["positive_work"], self.weight * self["length"])
        struct = self.strides["stride"] if name in STRIDE_QUANTITIES else self.strides
        return np.asarray(struct[name])

    def derivative(
        self, name: str, variations: NDArray[Any], weight_by: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Derivatives by the rules of differentiation, along the last axis of the library's `variations`."""

        def by(other: str) -> NDArray[np.float64]:
            return self.derivative(other, variations, weight_by)

        def at(other: str) -> NDArray[np.float64]:
            return self[other][..., None]

        if name in APEX_QUANTITIES:
            row = np.eye(weight_by.shape[-1])[COORDINATES.index(APEX_QUANTITIES[name])]
            return np.broadcast_to(row, variations.shape)
        if name == "frequency":
            return -by("period") / at("period") ** 2
        if name == "speed":
            return (by("length") - at("speed") * by("period")) / at("period")
        if name == "duty_factor":
            return (by("stance_time") - at("duty_factor") * by("period")) / at("period")
        if name in _PER_DISTANCE:
            weight = np.asarray(self.weight)[..., None]
            product_by = weight_by * at("length") + weight * by("length")
            return (by(_PER_DISTANCE[name]) - at(name) * product_by) / (weight * at("length"))
        if name == "positive_work":
            return by("positive_hip_work") + by("positive_leg_work")
        of_measures = name in (*_MEASURED, *_GREATEST)
        return np.asarray(variations["measures"][name] if of_measures else variations[name])


def _ratio(numerator: Any, denominator: NDArray[np.float64]) -> NDArray[np.float64]:
    """The ratio, 0 where the denominator is."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(denominator != 0.0, numerator / denominator, 0.0)


def differentiable(reduced: bool) -> tuple[str, ...]:
    """Quantities with exact derivatives."""
    known = REDUCED_QUANTITIES if reduced else QUANTITIES
    return (*_VARIED, *(name for name in known if name not in _VARIED))


@cache
def reported_quantities(reduced: bool) -> tuple[str, ...]:
    """Quantities of a stride by the return map or the reduced one, with its lift-off angle."""
    more = tuple(APEX_QUANTITIES)[:2] if reduced else MEASURES
    names = (*STRIDE_QUANTITIES, "frequency", *LEDGER, "liftoff_angle")
    return (*names, *(name for name in more if name not in names))


def apex_quantities(runner: Runner, apex: Apex) -> dict[str, float]:
    """Height and speed at the apex where a stride begins, by the names of quantities."""
    at = dict(zip(runner.coordinates, map(float, apex), strict=True))
    return {name: at[of] for name, of in APEX_QUANTITIES.items() if of in at}


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
    apex = apex_quantities(gait.runner, gait.apex)
    return {name: quantity_of(name, {**gait.stride, **apex}) for name in names}


def known_quantities(runner: Runner) -> tuple[str, ...]:
    """The quantities that a runner's map has."""
    return REDUCED_QUANTITIES if runner.reduced else allowed_quantities(runner.model)


def allowed_quantities(model: Model) -> tuple[str, ...]:
    """The quantities that may be prescribed, minimized or maximized; the reduced map has some of them."""
    own = tuple(name for name in model.quantities if name != "liftoff_angle")
    return own if model.map_class else QUANTITIES


def checked_quantity(name: object, what: str, model: Model) -> str:
    """The name of a quantity."""
    known = allowed_quantities(model)
    if not is_one_of(name, known):
        raise InputError(
            f"{what} {shown(name)} is not allowed{near_matches(name, known)}; allowed: {', '.join(known)}"
        )
    return str(name)


def check_quantities(runner: Runner, names: Sequence[str]) -> None:
    """Refuse quantities that the runner's map does not have."""
    known = known_quantities(runner)
    for name in names:
        if name not in known:
            whose = (
                f"model {runner.model.name}"
                if runner.model.map_class
                else "reduced map, where the leg in flight is placed as if by itself"
            )
            raise InputError(f"quantity {name} of the {whose}; allowed: {', '.join(known)}")


def quantity_of(name: str, reported: Mapping[str, float]) -> float:
    """A quantity of a stride."""
    return float(1.0 / reported["period"] if name == "frequency" else reported[name])


def scales_of(runner: Runner, parameters: Sequence[str]) -> NDArray[np.float64]:
    """Scales of the coordinates and of parameters: of these the value that each has, or 1 where it is 0."""
    return np.array([*runner.scales, *(abs(runner[name]) or 1.0 for name in parameters)])
