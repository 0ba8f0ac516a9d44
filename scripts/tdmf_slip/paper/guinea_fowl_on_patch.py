"""Guinea fowl by all laws that cross a slippery patch, whose borders the foot feels.

`guinea_fowl` changes the friction for a stride, by the reduced map, which no patch can have. Here the patch
is in the ground: it may end below a foot that slips, and the foot may land before, on or behind it.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..analysis.stride_map import stride_map
from ..analysis.targeted import find_gait
from ..library.fixed_point import gait_near
from ..library.gait import Gait
from ..library.runner import Runner
from ..variables.table import FRICTION
from .guinea_fowl import GRAVITY, published

PHASES = 64
"""Places of the foot at the start, over the length of a stride."""
BEFORE, AFTER = 3, 40
"""Strides on the ground before the patch, and behind it: a runner that has made them is up."""
TORQUE = "hip.stance_torque"


@dataclass(frozen=True, eq=False)
class Crossing:
    """Outcome of one gait on one patch, from `PHASES` places."""

    falls: int
    """Number of falls among `PHASES`."""
    slips: NDArray[np.float64]
    """The largest slip of one stride, m, by the place of the foot."""


def runner_of() -> Runner:
    """The bird by all laws: Table 1 in its units, with what `guinea_fowl.toml` has of its own."""
    birds, its, ours = published()["runner"], published()["full_runner"], Runner()
    length = birds["leg_length"]
    mass = birds["mass"] / (1.0 + ours["foot.mass"])
    stiffness = its["stiffness"] * mass * GRAVITY / length
    time = math.sqrt(mass / stiffness)
    moment = stiffness * length**2
    values = {
        "body.mass": mass,
        "foot.mass": mass * ours["foot.mass"],
        "leg.stiffness": stiffness,
        "leg.damping": ours["leg.damping"] * stiffness * time,
        "leg.free_length": length,
        "leg.min_length": ours["leg.min_length"] * length,
        "gravity": GRAVITY,
        TORQUE: its["stance_torque"] * moment,
        "hip.kp": ours["hip.kp"] * moment,
        "hip.kd": ours["hip.kd"] * moment * time,
        FRICTION: birds["high_friction"],
    }
    return Runner(values)


def gaits(speeds: Sequence[float]) -> list[Gait]:
    """Gaits at speeds, m/s, on ground of high friction; the hip's torque is that which makes each."""
    runner, its = runner_of(), published()["full_runner"]
    length = runner["leg.free_length"]
    rate = math.sqrt(runner["leg.stiffness"] / runner["body.mass"])
    first = gait_near(
        runner, np.array(its["apex"]) * [length, length * rate, length, 1.0, length * rate, rate]
    )
    return [find_gait(runner, target={"speed": v}, vary=[TORQUE], guess=first.apex) for v in speeds]


def cross(gait: Gait, friction: float, length: float) -> Crossing:
    """Let runners on a gait, their feet at places spread over one stride, cross a patch."""
    stride = float(gait.stride["length"])
    begin = BEFORE * stride
    runner = gait.runner.replace({"ground.patch_begin": begin, "ground.patch_end": begin + length})
    made = stride_map(
        runner.replace({"ground.patch_friction": friction}),
        np.tile(gait.apex, (PHASES, 1)),
        strides=BEFORE + math.ceil(length / stride) + AFTER,
        foot_x=stride * np.arange(PHASES) / PHASES,
    )
    return Crossing(
        int((made["fate"].values[:, -1] != 0).sum()), np.nanmax(made["slip_distance"].values, axis=1)
    )
