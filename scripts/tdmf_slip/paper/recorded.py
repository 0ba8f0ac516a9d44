"""Borders, eigenvalues and SLIP gaits that were computed once, independently of this package."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

from .claims import CLAMP, FREE
from .evidence import ClassicEvidence, Evidence
from .reference_gaits import Drift


@dataclass(frozen=True)
class Recorded:
    """Values of one reading."""

    borders: Mapping[tuple[str, str], float]
    """Friction at which a word ends, by this word and the next."""
    lambda_max: float
    """Largest eigenvalue at friction 10."""


VALUES: Mapping[str, Recorded] = {
    FREE: Recorded(
        {
            ("0+", "+0+"): 8.2252397885,
            ("+0+", "+0-0+"): 1.1369892702,
            ("+0-0+", "+0-+"): 0.49668242268,
            ("+0-+", "+0-"): 0.4966791981,
            ("+0-", "+-"): 0.26567509303,
        },
        0.810057725,
    ),
    CLAMP: Recorded(
        {
            ("0+", "+0+"): 8.454847622,
            ("+0+", "+0-0+"): 1.144140497,
            ("+0-0+", "+0-+"): 0.499109883,
            ("+0-+", "+0-"): 0.499106647,
            ("+0-", "+-"): 0.265851556,
        },
        0.811488219,
    ),
}
BORDER_TOLERANCE, EIGENVALUE_TOLERANCE = 5e-9, 1e-8


def drifts(reading: str, evidence: Evidence) -> list[Drift]:
    """Borders and the largest eigenvalue of one reading beside what is recorded."""
    borders = {(border.before, border.after): border.value for border in evidence.sweep.borders}
    recorded = VALUES[reading]
    rows = [
        _drift(
            f"border {before} to {after}",
            borders.get((before, after), math.nan),
            value,
            BORDER_TOLERANCE,
            reading,
        )
        for (before, after), value in recorded.borders.items()
    ]
    found = evidence.sweep.gaits[0].lambda_max
    return [*rows, _drift("lambda_max at mu = 10", found, recorded.lambda_max, EIGENVALUE_TOLERANCE, reading)]


def classic_drifts(evidence: ClassicEvidence) -> list[Drift]:
    """Gaits of the classic SLIP beside what is recorded."""
    return [
        _drift("SLIP apex at 40°", evidence.stable.height, 1.03696, 1e-5),
        _drift("SLIP slope at 40°", evidence.stable.slope, -0.0603, 1e-4),
        _drift("SLIP fold", math.degrees(evidence.fold.angle), 44.59, 5e-3),
    ]


def _drift(what: str, now: float, then: float, allowed: float, reading: str = "") -> Drift:
    return Drift(math.nan, what, now, then, abs(now - then), allowed, reading)
