"""The paper's units, which are labels only: lengths in l0, times in sqrt(m/k), masses in m.

A runner is in the paper's units where body mass, stiffness and free length are exactly 1.
"""

import inspect
import math
import warnings
from collections.abc import Mapping
from typing import Any

from ..errors import Note
from .table import DIMENSIONS, MODELS, VARIABLES, paper_unit

SCALES = MODELS["full"].scales
"""Names of the mass, the stiffness and the length that measure all other quantities of a runner."""


class MixedUnitsWarning(Note):
    """Some of a runner's values seem to be in SI units, others are still the paper's."""


def are_in_use(values: Mapping[str, Any]) -> bool:
    """Whether a runner with these values is in the paper's units."""
    return all(values.get(name) == 1.0 for name in SCALES)


def label(unit: str, values: Mapping[str, Any]) -> str:
    """The unit of a quantity of a runner with these values: the paper's, or the one that is given."""
    return paper_unit(unit) if unit in DIMENSIONS and are_in_use(values) else unit


MEASURED = ("foot.mass", "leg.damping", "gravity", "hip.stance_torque", "hip.kp", "hip.kd")
"""Parameters with a dimension that are nonzero in the paper's runner; compared with the runner's scales."""
COMPARED = (*SCALES, *MEASURED)
FACTOR = 50.0
"""Ratio of a scaled parameter to the paper's beyond which it is suspicious; a person's are at most 13."""


def mixture(values: Mapping[str, Any]) -> str:
    """A sentence about values in different systems of units; empty if none are suspected."""
    if any(name not in values for name in COMPARED):
        return ""
    own = {name: float(values[name]) for name in COMPARED}
    paper = {name: VARIABLES.start_of(name) for name in own}
    ratios = {
        name: own[name] / scale(VARIABLES[name].unit, own) / paper[name]
        for name in MEASURED
        if own[name] > 0.0
    }
    changed = [name for name in own if own[name] != paper[name]]
    rescaled = any(name in changed for name in SCALES)
    off = [
        name
        for name, ratio in ratios.items()
        if ratio > FACTOR or (ratio < 1.0 / FACTOR and rescaled and name not in changed)
    ]
    still = [name for name in own if name not in changed and name != "leg.free_length"]
    if not off or not changed or not still:
        return ""
    given = ", ".join(f"{name} = {own[name]:g}" for name in changed)
    left = ", ".join(f"{name} = {own[name]:g}" for name in still)
    return (
        f"this runner may mix units: {given} beside values that are still the paper's, {left}. "
        'For a person in SI units begin with the preset "human"'
    )


def scale(unit: str, values: Mapping[str, float]) -> float:
    """Scale of a runner's quantities in a unit, by its own units of length, time and mass."""
    mass, stiffness, length = (values[name] for name in SCALES)
    of_length, of_time, of_mass = DIMENSIONS[unit]
    return float(length**of_length * math.sqrt(mass / stiffness) ** of_time * mass**of_mass)


def warn_of_mixture(values: Mapping[str, Any]) -> None:
    """Warn of values in different systems of units."""
    sentence = mixture(values)
    if sentence:
        warnings.warn(sentence, MixedUnitsWarning, stacklevel=_depth())


def _depth() -> int:
    """Stack level of the nearest caller outside this package."""
    package = __name__.partition(".")[0]
    frame, depth = inspect.currentframe(), 0
    while frame is not None and frame.f_globals.get("__name__", "").partition(".")[0] == package:
        frame, depth = frame.f_back, depth + 1
    return depth
