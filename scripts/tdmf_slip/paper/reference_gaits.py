"""Reference values that were computed once, independently of this package, beside those computed now."""

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from ..library import classic_slip
from ..library.gait import REPORTED
from ..library.runner import Runner
from ..library.section import COORDINATES
from .along import words_over
from .claims import CLAMP, FREE
from .evidence import SLIP_ANGLE, Evidence
from .settling import SettledRun

PATH = Path(__file__).with_suffix(".json")
BORDER_TOLERANCE, EIGENVALUE_TOLERANCE = 5e-9, 1e-8
"""Largest deviations of a border's friction, and of an eigenvalue."""
QUANTITY_TOLERANCE = 1e-6
"""Largest relative deviation of a stride's quantities."""
APEX_TOLERANCE = 1e-5
"""Largest deviation of an apex, over the scales of its coordinates."""


@dataclass(frozen=True)
class Drift:
    """One value of a gait beside its reference."""

    friction: float
    """Friction of the gait; NaN for a value that belongs to no single gait."""
    what: str
    """Quantity that is compared."""
    computed: float | str
    """Computed value."""
    reference: float | str
    """Recorded value."""
    deviation: float
    """Relative deviation of quantities; over the scales for an apex; 0 or 1 for a word; else absolute."""
    allowed: float
    """Largest deviation that passes."""
    reading: str = ""
    """Reading of the swing law (12); empty if there is no swing."""

    @property
    def passed(self) -> bool:
        """True if the deviation is allowed; NaN never is."""
        return self.deviation <= self.allowed


@cache
def recorded() -> Mapping[str, Any]:
    """All recorded values, by table."""
    tables: Mapping[str, Any] = json.loads(PATH.read_text(encoding="utf-8"))
    return tables


@cache
def gaits() -> tuple[SimpleNamespace, ...]:
    """Gaits of Table 1's runner in both readings, as recorded.

    Each has `friction`, `swing_clamp`, `word`, the quantities of `REPORTED`, `liftoff_angle`, `apex` and
    `events`; those with the clamp have `clamp_release`, the time at which the clamp of (12) opens.
    """
    return tuple(SimpleNamespace(**gait) for gait in recorded()["gaits"])


def drifts(run: SettledRun, reference: SimpleNamespace) -> list[Drift]:
    """All recorded values of a gait beside their references."""
    mu, scales = run.friction, Runner(run.start_values).scales.tolist()
    reading = CLAMP if reference.swing_clamp else FREE
    found: list[tuple[Any, ...]] = [
        ("word", run.word, reference.word, float(run.word != reference.word), 0.0)
    ]
    for name in REPORTED:
        computed, wanted = run.stride[name], getattr(reference, name)
        found.append((name, computed, wanted, abs(computed / wanted - 1.0), QUANTITY_TOLERANCE))
    for name, computed, wanted, scale in zip(COORDINATES, run.apex, reference.apex, scales, strict=True):
        found.append((f"apex {name}", computed, wanted, abs(computed - wanted) / scale, APEX_TOLERANCE))
    return [Drift(mu, what, now, then, off, allowed, reading) for what, now, then, off, allowed in found]


def sweep_drifts(reading: str, evidence: Evidence) -> list[Drift]:
    """Borders between words, and the largest eigenvalue at friction 10, beside the recorded ones."""
    words = words_over(evidence.sweep)
    found = {(before, after): friction for (before, *_), (after, friction, _) in pairwise(words)}
    rows = [
        (f"border {before} to {after}", found.get((before, after), math.nan), friction, BORDER_TOLERANCE)
        for of, before, after, friction in (row.values() for row in recorded()["borders"])
        if of == reading
    ]
    largest = evidence.gaits["lambda_max"][0], recorded()["lambda_max_at_friction_10"][reading]
    rows.append(("lambda_max at mu = 10", *largest, EIGENVALUE_TOLERANCE))
    return [_drift(*row, reading) for row in rows]


def classic_drifts() -> list[Drift]:
    """Gaits of the classic SLIP beside the recorded ones."""
    known, fold = recorded()["classic_slip"], math.degrees(classic_slip.classic_fold().angle)
    stable, *_ = classic_slip.classic_gaits(math.radians(SLIP_ANGLE))
    return [
        _drift("SLIP apex at 40°", stable.height, known["apex_at_40_degrees"], 1e-5),
        _drift("SLIP slope at 40°", stable.slope, known["slope_at_40_degrees"], 1e-4),
        _drift("SLIP fold", fold, known["fold_degrees"], 5e-3),
    ]


def _drift(what: str, now: float, then: float, allowed: float, reading: str = "") -> Drift:
    return Drift(math.nan, what, now, then, abs(now - then), allowed, reading)
