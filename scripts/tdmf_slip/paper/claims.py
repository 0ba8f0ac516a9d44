"""What the paper says in numbers, beside what is computed: of its five gaits, of all gaits, and of the SLIP.

Sections 2, 3 and 5 of Or and Moravia (2016).
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..analysis.sweep import Sweep, sweep
from ..contents import ByContents
from ..library import classic_slip
from ..library.gait import Gait
from ..library.runner import Runner

WORDS: Mapping[float, str] = {10.0: "0+", 1.2: "+0+", 0.6: "+0-0+", 0.43: "+0-", 0.2: "+-"}
"""Friction and gait word of the periodic solutions in the paper's figures 5 to 8."""

AGREES, DIFFERS = "agrees", "differs"
ROUGHLY = 2.0
"""Per cent: how far from a figure the paper gives as rough a value may be and agree."""
PAPER = "Or and Moravia 2016"
"""Whose gaits are remade."""
SWEPT = np.geomspace(10.0, 0.05, 200)
"""Frictions at which gaits are sought."""
ROUNDING = 1e-9
"""By which eigenvalues that are the same may differ."""
BEST_FRICTION, SPEED_GAIN, COST_GAIN = 0.5, 12.0, -25.0
"""Where the paper's runner is fastest and cheapest, about, and its gains there over friction 10, per cent."""
SLIP_ANGLE, STANCE_FRICTION, IMPACT_FRICTION = 40.0, 0.84, 4.5
"""Degrees; and the friction that the paper's gait of that angle needs, in the stance and at the impact."""


@dataclass(frozen=True)
class Claim:
    """One published statement beside the computed one."""

    what: str
    """Is claimed of."""
    published: str
    """The paper's words or number."""
    computed: str
    """Ours."""
    agrees: bool
    """Whether they say the same."""
    source: str = PAPER
    """Who says it."""

    @property
    def verdict(self) -> str:
        """In one word."""
        return AGREES if self.agrees else DIFFERS


@dataclass(frozen=True, eq=False)
class Evidence(ByContents):
    """What the claims are judged by."""

    sweep: Sweep
    """Gaits over the friction."""
    slip: classic_slip.FixedPoint
    """The stable gait of the classic SLIP at 40 degrees."""
    fold: classic_slip.FixedPoint
    """Where the gaits of the classic SLIP meet."""


def gather(runner: Runner, progress: bool = False) -> Evidence:
    """Compute everything that the claims are judged by."""
    found = sweep(runner, {"ground.friction": SWEPT}, progress=progress)
    stable = classic_slip.fixed_points(math.radians(SLIP_ANGLE))[0]
    return Evidence(found, stable, classic_slip.fold())


def claims(evidence: Evidence) -> list[Claim]:
    """All quantitative claims of the paper but the words of its five gaits."""
    gaits = evidence.sweep.gaits
    return [
        *_stability(gaits),
        *_speed(gaits),
        *_cost(gaits),
        _words(evidence.sweep),
        *_slip(evidence),
    ]


def _stability(gaits: Sequence[Gait]) -> list[Claim]:
    values = [gait.lambda_max for gait in gaits]
    lowest = min(gait.friction for gait in gaits)
    small = max(int(np.sum(np.abs(gait.eigenvalues) < 1e-2)) for gait in gaits)
    falls = sum(after < before - ROUNDING for before, after in pairwise(values))
    return [
        Claim(
            "gaits are stable", "lambda_max < 1", f"{min(values):.4f} to {max(values):.4f}", max(values) < 1.0
        ),
        Claim(
            "lambda_max as mu falls",
            "rises",
            f"{values[0]:.4f} to {values[-1]:.4f}, falls at {falls} of {len(values) - 1} steps",
            falls <= 0.02 * len(values),
        ),
        Claim("eigenvalues below mu = 0.3", "not computable", f"down to mu = {lowest:g}", False),
        Claim("gaits below mu = 0.1", "none found", f"down to mu = {lowest:g}", False),
        Claim(
            "tiny eigenvalues of the return map, x included",
            "4 of 7, 1e-3 to 1e-5",
            f"{small} of 6 below 1e-2 without x, {_zeros(gaits[0])} of them 0",
            small == 4,
        ),
    ]


def _zeros(gait: Gait) -> int:
    return int(np.sum(np.abs(gait.eigenvalues) < 1e-9))


def _per_cent(gaits: Sequence[Gait], name: str) -> list[float]:
    return [100.0 * (gait.stride[name] / gaits[0].stride[name] - 1.0) for gait in gaits]


def _speed(gaits: Sequence[Gait]) -> list[Claim]:
    changes = _per_cent(gaits, "speed")
    best = int(np.argmax(changes))
    fastest = gaits[best].friction
    return [
        Claim(
            "speed over mu = 10, largest",
            f"≈ {SPEED_GAIN:+g} % at mu ≈ {BEST_FRICTION:g}",
            f"{changes[best]:+.1f} % at mu = {fastest:.2f}",
            abs(fastest - BEST_FRICTION) < 0.02 and abs(changes[best] - SPEED_GAIN) < ROUGHLY,
        ),
        Claim(
            "speed below mu ≈ 0.5",
            "drops, sharply below 0.2",
            f"{changes[-1]:+.1f} % at mu = {gaits[-1].friction:g}",
            all(after < before for before, after in pairwise(changes[best:])),
        ),
    ]


def _cost(gaits: Sequence[Gait]) -> list[Claim]:
    changes = _per_cent(gaits, "cost_of_transport")
    best = int(np.argmin(changes))
    cheapest = gaits[best].friction
    slipping = [change for change, gait in zip(changes, gaits, strict=True) if gait.word != "0+"]
    return [
        Claim(
            "cost of transport over mu = 10, least",
            f"≈ {COST_GAIN:+g} % at mu ≈ {BEST_FRICTION:g}",
            f"{changes[best]:+.1f} % at mu = {cheapest:.2f}",
            abs(cheapest - BEST_FRICTION) < 0.02 and abs(changes[best] - COST_GAIN) < ROUGHLY,
        ),
        Claim(
            "cost of transport with slip at impact",
            "less than without, at every mu",
            f"{min(slipping):+.1f} to {max(slipping):+.1f} %",
            max(slipping) < 0.0,
        ),
        Claim(
            "cost of transport below mu ≈ 0.5",
            "rises again",
            f"{changes[-1]:+.1f} % at mu = {gaits[-1].friction:g}",
            all(after > before for before, after in pairwise(changes[best:])),
        ),
    ]


def _words(found: Sweep) -> Claim:
    words = [found.gaits[0].word, *(border.after for border in found.borders)]
    return Claim(
        "gait words from mu = 10 down",
        ", ".join(WORDS.values()),
        ", ".join(words),
        words == list(WORDS.values()),
    )


def _slip(evidence: Evidence) -> list[Claim]:
    slip, fold = evidence.slip, evidence.fold
    return [
        Claim(
            "SLIP: stable gaits",
            "at 40° to 44°",
            f"slope {slip.slope:+.4f} at {SLIP_ANGLE:g}°, fold at {math.degrees(fold.angle):.2f}°",
            slip.stable and abs(math.degrees(fold.angle) - 44.5) < 0.5,
        ),
        Claim(
            f"SLIP at {SLIP_ANGLE:g}°: friction needed in stance",
            f"mu > {STANCE_FRICTION:g}",
            f"mu > {slip.stance_friction:.3f}",
            abs(slip.stance_friction - STANCE_FRICTION) < 0.005,
        ),
        Claim(
            f"SLIP at {SLIP_ANGLE:g}°: friction needed at impact",
            f"mu > {IMPACT_FRICTION:g}",
            f"mu > {slip.impact_friction:.2f}",
            abs(slip.impact_friction - IMPACT_FRICTION) < 0.05,
        ),
    ]


def recorded(evidence: Evidence) -> list[tuple[str, float, float, float]]:
    """What was computed once, independently: name, value now, value then, and how far it may be off."""
    borders = {(border.before, border.after): border.value for border in evidence.sweep.borders}
    rows = [
        (f"border {before} to {after}", borders.get((before, after), math.nan), value, 5e-5)
        for (before, after), value in RECORDED_BORDERS.items()
    ]
    by_friction = {gait.friction: gait for gait in evidence.sweep.gaits}
    return [
        *rows,
        ("lambda_max at mu = 10", by_friction[SWEPT[0]].lambda_max, 0.811488219, 1e-8),
        ("SLIP apex at 40°", evidence.slip.height, 1.03696, 1e-5),
        ("SLIP slope at 40°", evidence.slip.slope, -0.0603, 1e-4),
        ("SLIP fold", math.degrees(evidence.fold.angle), 44.59, 5e-3),
    ]


RECORDED_BORDERS: Mapping[tuple[str, str], float] = {
    ("0+", "+0+"): 8.4548,
    ("+0+", "+0-0+"): 1.1441,
    ("+0-0+", "+0-+"): 0.4991,
    ("+0-+", "+0-"): 0.4991,
    ("+0-", "+-"): 0.2659,
}
"""By words, to four digits."""
