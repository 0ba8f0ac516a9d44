"""All claims by section of the page of results, in the order of the page."""

from collections.abc import Mapping

from . import (
    attraction,
    falling,
    feedback,
    optima,
    over_friction,
    patches,
    reduced,
    retraction,
    rough,
    slopes,
    thrust,
    viable,
)
from .claim import OwnClaim

SECTIONS: Mapping[str, tuple[OwnClaim, ...]] = {
    "over_friction": over_friction.CLAIMS,
    "falling": falling.CLAIMS,
    "attraction": attraction.CLAIMS,
    "viable": viable.CLAIMS,
    "reduced": reduced.CLAIMS,
    "rough": rough.CLAIMS,
    "patches": patches.CLAIMS,
    "retraction": retraction.CLAIMS,
    "slopes": slopes.CLAIMS,
    "thrust": thrust.CLAIMS,
    "feedback": feedback.CLAIMS,
    "optima": optima.CLAIMS,
}
