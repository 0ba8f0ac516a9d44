"""The statements of Or and Moravia (2016) about the classic SLIP, with their comparisons."""

import math

from .claims import Claim, alike
from .evidence import SLIP_ANGLE, ClassicEvidence

STABLE_ANGLES = (40.0, 44.0)
"""Touchdown angles with stable gaits, about, degrees."""
STANCE_FRICTION, IMPACT_FRICTION = 0.84, 4.5
"""Friction that the gait at 40 degrees needs in stance and at the impact."""
NEAR_ANGLE = 1.0
"""Degrees within which two angles agree."""


def classic_claims(evidence: ClassicEvidence) -> list[Claim]:
    """The statements about stable gaits, and about the friction that one of them needs."""
    stable, lowest, fold = evidence.stable, math.degrees(evidence.lowest), math.degrees(evidence.fold.angle)
    low, high = STABLE_ANGLES
    return [
        Claim(
            "SLIP: touchdown angles with a stable gait",
            f"small range around {low:g}° to {high:g}°",
            alike(
                f"{lowest:.1f}° to {fold:.2f}°",
                abs(lowest - low) < NEAR_ANGLE and abs(fold - high) < NEAR_ANGLE,
            ),
            "2",
        ),
        Claim(
            f"SLIP at {SLIP_ANGLE:g}°: friction needed in stance",
            f"mu > {STANCE_FRICTION:g}",
            alike(
                f"mu > {stable.stance_friction:.3f}", abs(stable.stance_friction - STANCE_FRICTION) < 0.005
            ),
            "3.2",
        ),
        Claim(
            f"SLIP at {SLIP_ANGLE:g}°: friction needed at impact",
            f"mu > {IMPACT_FRICTION:g}",
            alike(f"mu > {stable.impact_friction:.2f}", abs(stable.impact_friction - IMPACT_FRICTION) < 0.05),
            "3.2",
        ),
    ]
