"""The recorded reference gaits of both readings of (12), and how far a computed gait is from them."""

import json
from collections.abc import Sequence
from dataclasses import dataclass, fields
from functools import cache
from pathlib import Path

from ..library.gait import REPORTED
from ..library.runner import Runner
from ..library.section import COORDINATES
from .claims import CLAMP, FREE
from .settling import SettledRun

PATH = Path(__file__).with_suffix(".json")
QUANTITY_TOLERANCE = 1e-6
"""Largest relative deviation of a stride's quantities."""
APEX_TOLERANCE = 1e-5
"""Largest deviation of an apex, over the scales of its coordinates."""


@dataclass(frozen=True)
class ReferenceGait:
    """A recorded gait of the paper's runner."""

    friction: float
    """Friction coefficient of the ground."""
    swing_clamp: bool
    """Value of `hip.swing_clamp`; the other parameters are Table 1's."""
    word: str
    """Gait word."""
    period: float
    """Period of a stride."""
    length: float
    """Length of a stride."""
    speed: float
    """Average speed over a stride."""
    work: float
    """Work of the hip in a stride."""
    cost_of_transport: float
    """Cost of transport of a stride."""
    liftoff_angle: float
    """Leg angle at lift-off, rad."""
    apex: Sequence[float]
    """Coordinates of the apex, in the order of `COORDINATES`."""
    events: Sequence[object]
    """Recorded events of the stride."""
    clamp_release: float | None = None
    """Time at which the clamp of (12), which holds the hip torque at 0, opens; None without the clamp."""


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
    """Relative for a gait's quantities, over its scale for its apex; 0 or 1 for its word; else absolute."""
    allowed: float
    """Largest deviation that passes."""
    reading: str = ""
    """Reading of the swing law (12); empty for what has no swing."""

    @property
    def passed(self) -> bool:
        """Within what is allowed; nothing that is not a number is."""
        return self.deviation <= self.allowed


@cache
def gaits() -> tuple[ReferenceGait, ...]:
    """All reference gaits, of both readings."""
    names = {field.name for field in fields(ReferenceGait)}
    stored = json.loads(PATH.read_text(encoding="utf-8"))["gaits"]
    return tuple(
        ReferenceGait(**{name: gait[name] for name in names & gait.keys()})
        for gait in stored  # those without the clamp have more: eigenvalues, Jacobian, slip distance
    )


def drifts(run: SettledRun, reference: ReferenceGait) -> list[Drift]:
    """All recorded values of a gait beside their references."""
    mu, scales = run.friction, Runner(run.start_values).scales
    reading = CLAMP if reference.swing_clamp else FREE
    found = [Drift(mu, "word", run.word, reference.word, float(run.word != reference.word), 0.0, reading)]
    for name in REPORTED:
        computed, wanted = getattr(run, name), getattr(reference, name)
        found.append(
            Drift(mu, name, computed, wanted, abs(computed / wanted - 1.0), QUANTITY_TOLERANCE, reading)
        )
    for name, computed, wanted, scale in zip(COORDINATES, run.apex, reference.apex, scales, strict=True):
        deviation = float(abs(computed - wanted) / scale)
        found.append(Drift(mu, f"apex {name}", computed, wanted, deviation, APEX_TOLERANCE, reading))
    return found
