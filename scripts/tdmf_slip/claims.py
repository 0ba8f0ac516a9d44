"""What the paper says of its five gaits, beside what was computed.

Section 5 of Or and Moravia (2016), as far as five gaits can decide it: it takes a sweep over the friction to
find an optimum, or the eigenvalues.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from .gait import Gait

WORDS: Mapping[float, str] = {10.0: "0+", 1.2: "+0+", 0.6: "+0-0+", 0.43: "+0-", 0.2: "+-"}
"""Friction and gait word of the periodic solutions in the paper's figures 5 to 8."""

AGREES, DIFFERS = "agrees", "differs"
ROUGHLY = 2.0
"""Per cent: how far from a figure the paper gives as rough a value may be and agree."""


@dataclass(frozen=True)
class Claim:
    """One published statement beside the computed one."""

    what: str
    published: str
    computed: str
    agrees: bool

    @property
    def verdict(self) -> str:
        """In one word."""
        return AGREES if self.agrees else DIFFERS


def claims(gaits: Sequence[Gait]) -> list[Claim]:
    """All claims that the five gaits can decide, but for their words.

    Args:
        gaits: one for each friction in `WORDS`.
    """
    by_friction = {gait.friction: gait for gait in gaits}
    return [_stability(gaits), *_speed(by_friction), *_cost(by_friction)]


def _stability(gaits: Sequence[Gait]) -> Claim:
    # A gait is found by running until it repeats: an unstable one would not have been.
    return Claim(
        "all five are stable", "lambda_max < 1", f"{len(gaits)} of {len(WORDS)} settled by running", True
    )


def _per_cent(gait: Gait, base: Gait, name: str) -> float:
    return 100.0 * (getattr(gait, name) / getattr(base, name) - 1.0)


def _speed(gaits: Mapping[float, Gait]) -> list[Claim]:
    changes = {mu: _per_cent(gait, gaits[10.0], "speed") for mu, gait in gaits.items()}
    fastest = max(changes, key=changes.get)
    return [
        Claim(
            "speed over mu = 10, largest",
            "≈ +12 % at mu ≈ 0.5",
            f"{changes[fastest]:+.1f} % at mu = {fastest:g}",
            fastest in (0.6, 0.43) and abs(changes[fastest] - 12.0) < ROUGHLY,
        ),
        Claim(
            "speed below mu ≈ 0.5",
            "drops again",
            f"{changes[0.43]:+.1f} % at 0.43, {changes[0.2]:+.1f} % at 0.2",
            changes[0.2] < changes[0.43] < changes[0.6],
        ),
    ]


def _cost(gaits: Mapping[float, Gait]) -> list[Claim]:
    changes = {mu: _per_cent(gait, gaits[10.0], "cost_of_transport") for mu, gait in gaits.items()}
    least = min(changes, key=changes.get)
    slipping = [changes[mu] for mu in WORDS if mu != 10.0]
    return [
        Claim(
            "cost of transport over mu = 10, least",
            "≈ -25 % at mu ≈ 0.5",
            f"{changes[least]:+.1f} % at mu = {least:g}",
            least in (0.6, 0.43) and abs(changes[least] + 25.0) < ROUGHLY,
        ),
        Claim(
            "cost of transport with slip",
            "less than without, at every mu",
            f"{min(slipping):+.1f} to {max(slipping):+.1f} %",
            max(slipping) < 0.0,
        ),
        Claim(
            "cost of transport below mu ≈ 0.5",
            "rises again",
            f"{changes[0.43]:+.1f} % at 0.43, {changes[0.2]:+.1f} % at 0.2",
            changes[0.2] > changes[0.43],
        ),
    ]
