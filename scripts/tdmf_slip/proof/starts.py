"""Starts of strides, and the precision with which strides are followed."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from flint import arb

from ..hybrid import cos
from .dual import Dual, Number
from .parameters import PARAMETER


def motion_at(runner: Any, apex: Sequence[Number], parameter: Number | None = None) -> dict[str, Number]:
    """The numbers of the motion in flight at an apex."""
    height, speed, length, angle, length_rate, angle_rate = apex
    moves = runner.on_line(speed, 0)
    values: dict[str, Number] = {
        "length": length,
        "angle": angle,
        "length_rate": length_rate,
        "angle_rate": angle_rate,
        "clearance": height * cos(runner.slope),
        "along": moves.along,
        "off": moves.off,
    }
    if runner.retracts:
        values["placing"] = arb(0)
    if parameter is not None:
        values[PARAMETER] = parameter
    return values


def apex_of(runner: Any, values: Mapping[str, Number]) -> list[Number]:
    """The coordinates of the section at an apex, where the centre of mass has no vertical velocity."""
    return [
        values["clearance"] / cos(runner.slope),
        runner.in_world(values["along"], values["off"], 0, 0).x,
        *(values[name] for name in ("length", "angle", "length_rate", "angle_rate")),
    ]


def seeded(values: Mapping[str, Number]) -> dict[str, Dual]:
    """Numbers as duals, each by itself."""
    return {name: Dual(value, {name: arb(1)}) for name, value in values.items()}


DEGREE_PER_BIT = 0.36
"""The best degree grows with the precision: N^2 10^(d/N) is least at N = 1.15 d for d digits."""


def degree_for(bits: int) -> int:
    """Degree of a step's polynomials at which the work of a stride is least."""
    return max(12, round(DEGREE_PER_BIT * bits))


@dataclass(frozen=True)
class Starts:
    """A set of apexes, and of values of what is varied."""

    centre: Sequence[arb]
    """Points, shape (6,) or with what is varied (7,)."""
    radii: Sequence[arb]
    """Radii around the points of the centre."""
    tilt: Sequence[arb] = ()
    """Points: by how much the centre moves for each unit of what is varied, shape (6,) or none."""

    @classmethod
    def around(cls, centre: Sequence[arb], radius: arb, scales: Sequence[float]) -> "Starts":
        """Starts within a radius, in units of the scales, or just above."""
        return cls(centre, [(radius * scale).upper().mid() for scale in scales])

    def balls(self) -> list[arb]:
        """Balls that hold all starts."""
        found = [c + arb(0, r) for c, r in zip(self.centre, self.radii, strict=True)]
        for i, slope in enumerate(self.tilt):
            found[i] += slope * arb(0, self.radii[6])
        return found
