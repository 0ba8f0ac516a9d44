"""Which slice of the apex section a map goes over."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

from ..checks import refusal
from ..given import ends_given, is_series, is_table, mapping_of, row_of
from ..library.gait import Gait, check_is_gait
from ..library.section import COORDINATES, check_axes

AXES = ("com_height", "com_speed")
"""Where none are given."""
Axes = Mapping[str, tuple[float, float] | None] | Sequence[str]
"""Two coordinates with their ranges."""
LEG_LENGTH = COORDINATES.index("leg_length")
"""It and the coordinates before are positive, and measured by what they are."""


def axes_of(axes: Any, coordinates: Sequence[str]) -> dict[str, tuple[float, float] | None]:
    """The two coordinates with their ranges, None where it is to be around the gait."""
    allowed = "two coordinates of an apex with their ranges (low, high)"
    named = isinstance(axes, Mapping) or is_table(axes) or is_series(axes)
    names = mapping_of(axes, "axes", allowed) if named else row_of(axes, "axes", allowed)
    if len(names) != 2:
        raise refusal("axes", axes, allowed)
    check_axes(tuple(names), coordinates)
    spans = names if isinstance(names, dict) else dict.fromkeys(names)
    if len(spans) != 2:
        raise refusal("axes", axes, allowed)
    return {name: None if span is None else ends_given(f"axes: {name}", span) for name, span in spans.items()}


def range_around(gait: Gait, axis: str) -> tuple[float, float]:
    """Ends of a range of a coordinate that has the gait in it, and most of what it attracts."""
    check_axes((axis,))
    check_is_gait(gait, "gait")
    index = COORDINATES.index(axis)
    here, scale = gait.apex[index], gait.runner.scales[index]
    low, high = (here - 0.5 * scale, here + 0.5 * scale) if index > LEG_LENGTH else (0.7 * here, 1.5 * here)
    return _rounded(low), _rounded(high)


def _rounded(value: float) -> float:
    """A number to six significant digits."""
    return round(value, 5 - math.floor(math.log10(abs(value)))) if value else 0.0
