"""Proof of a gait, and the sentence that states it."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from decimal import Decimal, localcontext
from fractions import Fraction

import flint
from flint import acb, arb

from ..library.section import COORDINATES
from ..record import origin_of
from ..variables.table import FRICTION, VARIABLES
from ..version import __version__
from .given import Exact, ball_of, default_value
from .starts import Starts

CLAMP = "hip.swing_clamp"
"""Parameter that chooses between the two readings of (12)."""
QUANTITIES = (
    "period",
    "length",
    "speed",
    "work",
    "hip_work",
    "leg_work",
    "cost_of_transport",
    "slip_distance",
    "stance_time",
    "duty_factor",
    "liftoff_angle",
)
"""Quantities of a stride that a proof encloses."""
FURTHER = 15
"""Digits that are printed beyond those asked for, as far as they are known."""


@dataclass(frozen=True)
class Box:
    """A box of apexes, exactly, in the order of the section's coordinates and in their units."""

    centre: Sequence[Fraction]
    """The apex in its middle, shape (6,)."""
    radii: Sequence[Fraction]
    """Half widths, shape (6,)."""

    @classmethod
    def around(cls, centre: Sequence[arb], radius: Fraction, scales: Sequence[float]) -> "Box":
        """A box of this radius, in units of the scales, around decimals near a point."""
        decimals = 3 - math.floor(math.log10(float(radius)))
        rounded = [Fraction(round(exactly(x) * 10**decimals), 10**decimals) for x in centre]
        return cls(rounded, [radius * Fraction(scale) for scale in scales])

    def starts(self) -> Starts:
        """A set of starts that the box lies in, to the working precision."""
        balls = [ball_of(x) for x in self.centre]
        radii = [(ball_of(r) + ball.rad()).upper().mid() for r, ball in zip(self.radii, balls, strict=True)]
        return Starts([ball.mid() for ball in balls], radii)

    def as_json(self, names: Sequence[str]) -> dict[str, list[str]]:
        """The box as a plain object, with the names of its directions; numbers are exact texts."""
        return {
            "coordinates": list(names),
            "centre": [decimal(x) for x in self.centre],
            "radii": [short(r) for r in self.radii],
        }

    def holds(self, apex: Sequence[arb]) -> bool:
        """True if an enclosed apex is proved to lie in the box."""
        intervals = zip(apex, self.centre, self.radii, strict=True)
        return all(abs(x - ball_of(centre)) < ball_of(radius) for x, centre, radius in intervals)


def exactly(point: arb) -> Fraction:
    """A ball without radius, as the binary number that it is."""
    mantissa, exponent = point.mid().man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def decimal(value: Fraction, digits: int = 60) -> str:
    """A decimal as it is, or a fraction."""
    with localcontext(prec=10 * digits):
        found = Decimal(value.numerator) / Decimal(value.denominator)
        is_decimal = Fraction(found) == value and value.denominator < 10**digits
        return f"{found.normalize():f}" if is_decimal else str(value)


@dataclass(frozen=True, repr=False)
class Proved:
    """Base of all proofs: a sentence that says what is proved or left open, and assumptions."""

    proved: bool
    """True if the sentence is proved; False means undecided, and says nothing against it."""
    values: Mapping[str, Exact] = field(repr=False)
    """The runner's parameters, exactly, by the unit's names."""
    version: str = field(default=__version__, repr=False, compare=False, kw_only=True)
    """The version of the package that proved it."""

    def __repr__(self) -> str:
        """The sentence, of as much as fits two lines."""
        return f"<{type(self).__name__}: {self.sentence[:160]}{'...' if len(self.sentence) > 160 else ''}>"

    @property
    def sentence(self) -> str:
        """One sentence: the claim that is proved, or the reason why it is undecided."""
        raise NotImplementedError

    @property
    def assumptions(self) -> Sequence[str]:
        """Assumptions of the proof."""
        return [
            f"in the ball arithmetic of FLINT {flint.__FLINT_VERSION__} (python-flint {flint.__version__}), "
            "each ball contains the exact result",
            "c_core/pages, tdmf_slip.proof.laws and tdmf_slip.proof.transitions state the model's laws",
            "Python executes the prover correctly",
        ]

    def statement(self, varied: str | None = None) -> dict[str, object]:
        """Entries that every proof has in JSON, without the value of a varied parameter."""
        return {
            **origin_of(version=self.version),
            "parameters": texts_of(self.values, varied),
            "proved": self.proved,
            "sentence": self.sentence,
            "assumptions": self.assumptions,
        }


def texts_of(values: Mapping[str, Exact], varied: str | None = None) -> dict[str, str]:
    """Exact texts of a runner's parameters and inputs, without a varied one."""
    return {name: str(value) for name, value in values.items() if name != varied}


@dataclass(frozen=True, repr=False)
class Proof(Proved):
    """A gait with enclosures of all that is reported, or what could not be decided."""

    box: Box = field(repr=False)
    """Box that contains exactly one gait."""
    digits: int
    """Number of digits that were asked for."""
    word: str = ""
    """The gait word."""
    stable: bool | None = None
    """All eigenvalues are inside the unit circle, or one is outside; None where that is open."""
    apex: Sequence[arb] = field(default=(), repr=False)
    """Enclosure of the gait's apex, shape (6,)."""
    quantities: Mapping[str, arb] = field(default_factory=dict, repr=False)
    """Enclosures by the names in `QUANTITIES`."""
    eigenvalues: Sequence[acb] = field(default=(), repr=False)
    """Discs, the largest first."""
    events: Sequence[tuple[str, arb]] = field(default=(), repr=False)
    """Events of the stride, with their times since the apex, s."""
    undecided: Mapping[str, object] = field(default_factory=dict)
    """Place where an undecided proof ended: `guard` and `time`."""

    @property
    def coordinates(self) -> Sequence[str]:
        """Names of the section's coordinates."""
        return COORDINATES

    def as_json(self) -> dict[str, object]:
        """Plain object in which enclosures are texts `[mid +/- radius]`."""
        return {
            **self.statement(),
            "word": self.word or None,
            "stable": self.stable,
            "box": self.box.as_json(COORDINATES),
            "apex": [text_of(x, self.digits) for x in self.apex] or None,
            **{name: text_of(self.quantities.get(name), self.digits) for name in QUANTITIES},
            "eigenvalues": [self._eigenvalue(value) for value in self.eigenvalues] or None,
            "events": [[name, text_of(time, self.digits)] for name, time in self.events],
            "undecided": dict(self.undecided) or None,
        }

    def _eigenvalue(self, value: acb) -> object:
        parts = [text_of(part, self.digits) for part in (value.real, value.imag)]
        return parts[0] if value.imag.is_zero() else parts

    @property
    def sentence(self) -> str:
        """Statement that is proved, or left open, for a reader who wants to sign it."""
        of = reported(self.values)
        radius = short(max(self.box.radii))
        box = f"within {radius} of ({', '.join(decimal(x) for x in self.box.centre)})"
        if not self.proved:
            when = self.undecided.get("time")
            at = "" if when is None else f" at {when:.6g} s after the apex"
            return f"Undecided for the {of}: {self.undecided['guard']}{at}, {box}."
        kind = {True: "is stable", False: "is unstable", None: "may be stable or not"}[self.stable]
        return (
            f"The {of} has exactly one periodic gait of one stride whose apex ({', '.join(COORDINATES)}) is "
            f"{box} in each coordinate. Its word is {self.word or 'empty'}, its period lies in "
            f"{text_of(self.quantities['period'], self.digits)} s, and it {kind}."
        )


def text_of(ball: arb | None, digits: int) -> str | None:
    """A ball in decimals, which holds it."""
    return None if ball is None else ball.str(digits + FURTHER if digits > 3 else digits)


def short(value: Fraction) -> str:
    """A power of ten as such, else as it is."""
    exponent = round(math.log10(float(value)))
    return f"1e{exponent}" if value == Fraction(10) ** exponent else decimal(value)


def reported(values: Mapping[str, Exact], varied: str | None = None) -> str:
    """Name a runner: differences from Table 1, the reading of (12), and friction if it is not varied."""
    table = {name: default_value(VARIABLES[name]) for name in values}
    named = [name for name, v in values.items() if name != varied and (v != table[name] or name == CLAMP)]
    if FRICTION not in (*named, varied):
        named.append(FRICTION)
    given = ", ".join(f"{name} = {values[name]}" for name in named)
    return f"runner of Or and Moravia's Table 1 with {given}"
