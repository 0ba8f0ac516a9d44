"""A patch of slippery ground: where a foot lands decides, and strides until a fall on it."""

import numpy as np
import tdmf_slip
from conftest import CLAMPED

PATCH = {**CLAMPED, "ground.friction": 0.6, "ground.patch_begin": 12.45, "ground.patch_end": 12.52}


# ---- strides until the fall -----------------------------------------------------------------------------

# Downhill the foot is sped up on ice, and falls where grip returns.
DOWNHILL = {
    "ground.friction": 10.0,
    "ground.slope": np.radians(-4.0),
    "ground.patch_begin": 100.0,
    "ground.patch_end": 500.0,
    "ground.patch_friction": 0.02,
}


def test_strides_to_fall_begins_on_the_gait_without_the_patch_at_any_phase():
    """Falls are those of the same strides by the stride map, runner by runner."""
    gait = tdmf_slip.find_gait(DOWNHILL | {"ground.patch_end": 100.0})
    found = tdmf_slip.strides_to_fall(DOWNHILL, 0.0, runners=40, max_strides=120, seed=3, foot_x="random")
    assert found.word == gait.word and found.falls > 0
    positions = 100.0 - np.random.default_rng(3).uniform(1.0, 2.0, 40) * gait.stride["length"]
    run = tdmf_slip.stride_map(DOWNHILL, gait.apex, strides=120, foot_x=positions)
    fell = (run["fate"].values == 1).any(axis=1)
    assert found.falls == np.count_nonzero(fell)
    given = tdmf_slip.strides_to_fall(DOWNHILL, 0.0, runners=40, max_strides=120, foot_x=positions)
    assert (given.falls, given.strides) == (found.falls, found.strides)
    behind = tdmf_slip.strides_to_fall(DOWNHILL, 0.0, runners=4, max_strides=120, foot_x=600.0)
    assert behind.falls == 0
