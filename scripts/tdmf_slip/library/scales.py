"""A runner's own units: what numbers are measured by that have units."""

from .runner import Runner

ROUNDING = 5.0
"""Of a stride, over the solver's tolerance and the runner's scales."""


def scale_of(runner: Runner, unit: str) -> float:
    """The scale of a runner's quantities in a unit."""
    scales = runner.model.scales
    return {
        "m": scales.length,
        "s": scales.time,
        "m/s": scales.speed,
        "N": scales.force,
        "J": scales.energy,
        "N2.m2.s": scales.energy**2 * scales.time,
        "rad": 1.0,
        "rad/s": 1.0 / scales.time,
        "1": 1.0,
        "kg": scales.energy / scales.speed**2,
        "m/s2": scales.speed / scales.time,
        "N/m": scales.force / scales.length,
        "N.s/m": scales.force / scales.speed,
        "N.m": scales.energy,
        "N.m/rad": scales.energy,
        "N.m.s/rad": scales.energy * scales.time,
    }[unit]


def rounding_of(runner: Runner, unit: str) -> float:
    """What a quantity of a stride may be off by that is zero but for rounding, as the rise on the level."""
    return ROUNDING * runner.tolerance * scale_of(runner, unit)
