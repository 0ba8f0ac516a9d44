"""A runner's own units: what numbers are measured by that have units."""

from ..variables.table import scale
from .runner import Runner

ROUNDING = 5.0
"""Of a stride, over the solver's tolerance and the runner's scales."""


def scale_of(runner: Runner, unit: str) -> float:
    """The scale of a runner's quantities in a unit."""
    scales = runner.c_model.scales
    return scale(unit, scales.length, scales.time, scales.energy / scales.speed**2)


def rounding_of(runner: Runner, unit: str) -> float:
    """What a quantity of a stride may be off by that is zero but for rounding, as the rise on the level."""
    return ROUNDING * runner.tolerance * scale_of(runner, unit)
