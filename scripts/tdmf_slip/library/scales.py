"""A runner's own units: what numbers are measured by that have units."""

from ..variables.table import scale
from .runner import Runner


def scale_of(runner: Runner, unit: str) -> float:
    """The scale of a runner's quantities in a unit."""
    scales = runner.c_model.scales
    return scale(unit, scales.length, scales.time, scales.energy / scales.speed**2)
