"""On rough ground: what slip does, and what the height of the foot does."""

from collections.abc import Callable

from ...analysis.first_passage import strides_to_fall
from ...library.gait import Gait
from ...library.rough_ground import RoughGround, correlated_weights
from .claim import SLIPS, STICKS, OwnClaim, gait, matched

ROUGHNESS, RUNNERS, MAX_STRIDES = 0.5, 600, 20_000
"""Steps in l0; 600 falls tell a mean to 8 %, with a confidence of 95 %."""
CORRELATION = 0.7
"""Of each step with the one before: ground that goes on to rise or fall."""
MATCH = (
    "tdmf-slip compare --friction {} --friction {} --hold speed,apex_height,apex_leg_angle "
    "--vary hip.stance_torque,hip.touchdown_angle,hip.liftoff_angle_factor"
)
ROUGH = f"tdmf-slip rough --friction {SLIPS} --roughness {ROUGHNESS} --runners {RUNNERS} --seed {{seed}}"


SEGMENT, HEIGHT = 5.0, 0.4
"""Of the terrain: length of a segment, and standard deviation of heights, l0."""


def _strides_on_segments(one: Gait, seed: int) -> float:
    ground = RoughGround(HEIGHT, seed, segment_length=SEGMENT)
    found = strides_to_fall(one.runner, ground, RUNNERS, max_strides=MAX_STRIDES, gait=one, threads=1)
    return found.mean_strides


def strides(one: Gait, seed: int, correlation: float = 0.0) -> float:
    """Mean number until the fall."""
    ground = RoughGround(ROUGHNESS, seed, correlated_weights(correlation))
    found = strides_to_fall(one.runner, ground, RUNNERS, max_strides=MAX_STRIDES, gait=one, threads=1)
    return found.mean_strides


def _as_they_come(seed: int) -> float:
    return strides(gait(SLIPS), seed) / strides(gait(STICKS), seed + 1)


def _at_slips_kinematics(seed: int) -> float:
    return strides(gait(SLIPS), seed) / strides(matched(SLIPS, STICKS), seed + 1)


def _on_hills(seed: int) -> float:
    control = matched(SLIPS, STICKS)
    return strides(gait(SLIPS), seed, CORRELATION) / strides(control, seed + 1, CORRELATION)


def _on_segments(seed: int) -> float:
    return _strides_on_segments(gait(SLIPS), seed) / _strides_on_segments(matched(SLIPS, STICKS), seed + 1)


def _at_sticks_kinematics(seed: int) -> float:
    return strides(matched(STICKS, SLIPS), seed) / strides(gait(STICKS), seed + 1)


def _clearance(friction: float) -> Callable[[int], float]:
    return lambda seed: gait(friction).stride["foot_clearance"]


CLAIMS = (
    OwnClaim(
        "strides on steps of 0.5 l0, friction 0.2 over friction 10, as they come",
        ROUGH,
        18.0,
        32.0,
        _as_they_come,
    ),
    OwnClaim(
        "  the foot's clearance at the apex is not equal then: at friction 0.2, l0",
        "tdmf-slip gait --friction 0.2 --target foot_clearance=1.8828 --vary hip.stance_torque --json",
        1.88,
        1.89,
        _clearance(SLIPS),
    ),
    OwnClaim(
        "  and at friction 10, l0",
        "tdmf-slip gait --friction 10 --target foot_clearance=0.7877 --vary hip.stance_torque --json",
        0.78,
        0.79,
        _clearance(STICKS),
    ),
    OwnClaim(
        "  its control: friction 0.2 over friction 10 with speed, apex height and leg angle of the former",
        MATCH.format(SLIPS, STICKS),
        0.85,
        1.23,
        _at_slips_kinematics,
    ),
    OwnClaim(
        "  the same on steps correlated by 0.7, where slip harms",
        f"{ROUGH} --correlation {CORRELATION}",
        0.66,
        0.98,
        _on_hills,
    ),
    OwnClaim(
        "  the same on level segments of 5 l0, heights 0.4 l0, where how the foot comes down is not held",
        f"tdmf-slip rough --friction {SLIPS} --roughness {HEIGHT} --segment-length {SEGMENT:g} "
        f"--runners {RUNNERS} --seed {{seed}}",
        1.65,
        2.35,
        _on_segments,
    ),
    OwnClaim(
        "  and with those of the latter, on independent steps",
        MATCH.format(STICKS, SLIPS),
        0.85,
        1.28,
        _at_sticks_kinematics,
    ),
)
