"""What feedback from stride to stride is worth, beside a runner that carries its foot higher without any."""

from collections.abc import Callable
from dataclasses import replace
from functools import cache

from ...analysis.first_passage import FirstPassage, strides_to_fall
from ...feedback.gains import lqr
from ...library.rough_ground import RoughGround
from .claim import ANGLE, SLIPS, TORQUE, OwnClaim, gait, matched
from .rough import MATCH

FRICTION, ROUGHNESS = 0.6, 0.3
REACH, NOISE = 0.1, 0.01
"""How far a setting may go from the gait's, and the sensors' noise, over the scales."""
RUNNERS, MAX_STRIDES = 256, 400
"""A hundred thousand strides where none falls."""
HUNDRED_THOUSAND = 1e5
ROUGH = f"tdmf-slip rough --friction {FRICTION} --roughness {ROUGHNESS} --runners {RUNNERS} --seed {{seed}}"


@cache
def _passage(name: str, seed: int) -> FirstPassage:
    one, law = (matched(SLIPS, FRICTION) if name == "matched" else gait(FRICTION)), None
    if name == "feedback":
        limits = {
            of: (one.runner.values[of] - REACH, one.runner.values[of] + REACH) for of in (ANGLE, TORQUE)
        }
        noise = (NOISE * one.runner.scales).tolist()
        law = replace(lqr(one, (ANGLE, TORQUE), limits=limits), noise=noise, seed=seed)
    ground = RoughGround(ROUGHNESS, seed)
    return strides_to_fall(one.runner, ground, RUNNERS, max_strides=MAX_STRIDES, gait=one, law=law, threads=1)


def _falls(name: str) -> Callable[[int], float]:
    """In 100,000 strides."""

    def falls(seed: int) -> float:
        passage = _passage(name, seed)
        return HUNDRED_THOUSAND * passage.falls / passage.strides

    return falls


CLAIMS = (
    OwnClaim(
        "falls in 100,000 strides on steps of 0.3 l0 at friction 0.6, without feedback",
        ROUGH,
        225.0,
        345.0,
        _falls("none"),
    ),
    OwnClaim("  with that of a quadratic regulator", ROUGH, 1.0, 26.0, _falls("feedback")),
    OwnClaim(
        "  its control: without, at speed, apex height and leg angle of the runner on friction 0.2",
        MATCH.format(SLIPS, FRICTION),
        0.0,
        4.0,
        _falls("matched"),
    ),
)
