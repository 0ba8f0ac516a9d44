"""The apex section: its six coordinates, and the motion in flight that they stand for."""

from collections.abc import Mapping, Sequence
from typing import Any

from flint import arb

from ..equations import ground_line
from .dual import Dual, Number
from .modes import PARAMETER

COORDINATES = ("com_height", "com_speed", "leg_length", "leg_angle", "leg_length_rate", "leg_angle_rate")


def motion_at(runner: Any, apex: Sequence[Number], parameter: Number | None = None) -> dict[str, Number]:
    """The numbers of the motion in flight at an apex."""
    height, speed, length, angle, length_rate, angle_rate = apex
    values: dict[str, Number] = {
        "length": length,
        "angle": angle,
        "length_rate": length_rate,
        "angle_rate": angle_rate,
        "height": height * runner.line.cosine,
        "along": ground_line.along(runner.line, speed, 0),
        "off": ground_line.off(runner.line, speed, 0),
    }
    if runner.retracts:
        values["clock"] = arb(0)
    if parameter is not None:
        values[PARAMETER] = parameter
    return values


def apex_of(runner: Any, values: Mapping[str, Number]) -> list[Number]:
    """The coordinates of the section at an apex, where the centre of mass has no vertical velocity."""
    return [
        values["height"] / runner.line.cosine,
        ground_line.vector_on(runner.line, values["along"], values["off"]).x,
        *(values[name] for name in ("length", "angle", "length_rate", "angle_rate")),
    ]


def seeds(values: Sequence[arb], names: Sequence[str]) -> list[Dual]:
    """Numbers as duals, each by itself."""
    return [Dual(value, {name: arb(1)}) for value, name in zip(values, names, strict=True)]
