"""Strides of independent programs, as the tests of the engine, the unit and the proofs use them.

They are the published gaits by both readings of (12), gaits on slopes, with retraction, thrust, friction
that falls and pushes, strides of random runners, and runs over a patch of other friction.
"""

import json
from pathlib import Path

import numpy as np
from conftest import CLAMPED, reference_gaits, runner_of_gait


def read(name):
    """Content of a JSON file in the folder of the tests."""
    return json.loads(Path(__file__).with_name(name).read_text(encoding="utf-8"))


def in_radians(value):
    return np.radians(float(value.removesuffix(" deg"))) if isinstance(value, str) else value


FREE, FURTHER, PATCHES = read("free_swing.json"), read("further_gaits.json"), read("patch_runs.json")
GAITS = [gait | {"start_values": runner_of_gait(gait)} for gait in [*reference_gaits(), *FREE["gaits"]]]
GAITS += [
    gait | {"start_values": CLAMPED | {n: in_radians(v) for n, v in gait["start_values"].items()}}
    for gait in FURTHER["gaits"]
]
RUNS = [run | {"start_values": CLAMPED | run["start_values"]} for run in PATCHES["runs"]]
STRIDES = [
    {"start_values": {**stride["given"], "hip.swing_clamp": False}, "words": [stride["word"]], **stride}
    for stride in FREE["strides"][::4]
]

NAMES = {
    "period": "stride.period", "length": "stride.length", "speed": "stride.speed", "rise": "stride.rise",
    "hip_work": "stride.hip_work", "leg_work": "stride.leg_work", "work": "stride.work",
    "cost_of_transport": "stride.cost_of_transport", "slip_distance": "stride.slip_distance",
    "stance_time": "stride.stance_time", "liftoff_angle": "hip.liftoff_angle",
}  # fmt: skip
"""Names in the unit of what the references have."""


def name_of(gait):
    return " ".join(map(str, gait["start_values"].values()))
