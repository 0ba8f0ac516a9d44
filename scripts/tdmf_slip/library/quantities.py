"""What a gait can be ordered by and fitted to: quantities of a stride.

Their exact derivatives are in `varied_stride`.
"""

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from ..checks import shown
from ..errors import InputError
from ..variables import units
from ..variables.table import MODELS
from .gait import Gait
from .measures import APEX_QUANTITIES, MEASURES, apex_quantities
from .runner import Runner
from .section import REDUCED

OF_STRIDE: Mapping[str, Callable[[Mapping[str, float]], float]] = {
    "speed": lambda stride: stride["speed"],
    "frequency": lambda stride: 1.0 / stride["period"],
    "length": lambda stride: stride["length"],
    "stance_time": lambda stride: stride["stance_time"],
    "duty_factor": lambda stride: stride["duty_factor"],
    "slip_distance": lambda stride: stride["slip_distance"],
    "peak_force": lambda stride: stride["peak_force"],
    "peak_vertical_force": lambda stride: stride["peak_vertical_force"],
    "cost_of_transport": lambda stride: stride["cost_of_transport"],
}
"""Those of both maps, of a stride as it is told."""
QUANTITIES = (*OF_STRIDE, *MEASURES)
"""What a gait can be ordered by; the frequency is that of strides, one over the period."""
REDUCED_QUANTITIES = (*OF_STRIDE, *(name for name, of in APEX_QUANTITIES.items() if of in REDUCED))
"""Those that the reduced map has: its leg is placed in flight as if by itself."""
SIGNED = ("apex_leg_angle",)
"""Those that may be 0 or less."""


def unit_of(quantity: str) -> str:
    """The unit of a quantity; `1` for one that is not in the table."""
    known = MODELS["full"].quantities.get(quantity)
    return "1" if known is None else known.unit


def quantity_given(name: str, given: object, where: str) -> object:
    """The prescribed value of a quantity; a text is converted to the quantity's unit."""
    if not isinstance(given, str):
        return given
    own = unit_of(name)
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
    """What a gait has of the quantities that one can be ordered by."""
    check_quantities(gait.runner, names)
    apex = apex_quantities(gait.runner, gait.apex)
    return {name: quantity_of(name, {**gait.stride, **apex}) for name in names}


def known_quantities(runner: Runner) -> tuple[str, ...]:
    """The quantities that a runner's map has."""
    return REDUCED_QUANTITIES if runner.reduced else QUANTITIES


def check_quantities(runner: Runner, names: Sequence[str]) -> None:
    """Refuse quantities that the runner's map does not have."""
    for name in names:
        if name not in known_quantities(runner):
            raise InputError(
                f"quantity {name} of the reduced map, where the leg in flight is placed as if by itself; "
                f"allowed: {', '.join(REDUCED_QUANTITIES)}"
            )


def quantity_of(name: str, reported: Mapping[str, float]) -> float:
    """A quantity of a stride."""
    return float(OF_STRIDE[name](reported) if name in OF_STRIDE else reported[name])


def scales_of(runner: Runner, parameters: Sequence[str]) -> NDArray[np.float64]:
    """Scales of the coordinates and of parameters: of these the value that each has, or 1 where it is 0."""
    return np.array([*runner.scales, *(abs(runner[name]) or 1.0 for name in parameters)])
