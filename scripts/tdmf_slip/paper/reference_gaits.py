"""The recorded reference gaits, and how far a computed gait is from them."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from ..unit.section import COORDINATES, scales
from ..unit.unit import Unit
from .settling import QUANTITIES, Gait

PATH = Path(__file__).with_suffix(".json")
QUANTITY_TOLERANCE = 1e-6
"""Relative, for a stride's quantities."""
APEX_TOLERANCE = 1e-5
"""Over the coordinates' scales."""


@dataclass(frozen=True)
class Drift:
    """One value of a gait beside its reference."""

    friction: float
    """Not a number for what is not of one gait."""
    what: str
    computed: float | str
    reference: float | str
    deviation: float
    """Relative for a gait's quantities, over its scale for its apex; 0 or 1 for its word; else absolute."""
    allowed: float

    @property
    def passed(self) -> bool:
        """Within what is allowed; nothing that is not a number is."""
        return self.deviation <= self.allowed


@cache
def gaits() -> tuple[Mapping[str, object], ...]:
    """The reference gaits: friction, word, stride quantities, apex, events."""
    return tuple(json.loads(PATH.read_text(encoding="utf-8"))["gaits"])


def drifts(gait: Gait, reference: Mapping[str, object], unit: Unit) -> list[Drift]:
    """All recorded values of a gait beside their references."""
    mu = gait.friction
    found = [Drift(mu, "word", gait.word, reference["word"], float(gait.word != reference["word"]), 0.0)]
    for name in QUANTITIES:
        computed, wanted = getattr(gait, name), reference[name]
        found.append(Drift(mu, name, computed, wanted, abs(computed / wanted - 1.0), QUANTITY_TOLERANCE))
    for name, computed, wanted, scale in zip(
        COORDINATES, gait.apex, reference["apex"], scales(unit, gait.start_values), strict=True
    ):
        deviation = abs(computed - wanted) / scale
        found.append(Drift(mu, f"apex {name}", computed, wanted, deviation, APEX_TOLERANCE))
    return found
