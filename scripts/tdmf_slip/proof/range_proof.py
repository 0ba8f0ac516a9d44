"""Proof of gaits over a range of a parameter, subinterval by subinterval."""

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from flint import arb, ctx

from ..errors import counted
from .given import ball_of
from .proof import Proved, decimal, reported

BITS = 56
"""Precision of the arithmetic in which subintervals are proved."""
COMPARING_BITS = 2 * BITS


@dataclass(frozen=True)
class Subinterval:
    """A part of the range: what is proved of it, or that it is left."""

    begin: Fraction
    """The parameter's least value in it."""
    end: Fraction
    """The parameter's greatest value in it."""
    word: str = ""
    """The gait word; empty where it is left undecided."""
    stable: bool | None = None
    """True if all gaits are stable, False if none is, None if neither is proved."""
    centre: Sequence[float] = ()
    """The apex that xi is counted from, at the middle of the subinterval, shape (6,)."""
    tilt: Sequence[float] = ()
    """Change of that apex by the parameter, shape (6,)."""
    box: Sequence[float] = ()
    """Radii of xi in which there is exactly one gait for each value."""
    enclosure: Sequence[float] = ()
    """Radii of xi that hold the gait."""
    undecided: str = ""
    """Statement that could not be decided."""

    @property
    def proved(self) -> bool:
        """True if each value is proved to have exactly one gait with this word."""
        return bool(self.word)

    def middle(self) -> arb:
        """The point, in its middle or very near it, that its tilt is counted from."""
        with ctx.workprec(BITS):
            return ball_of((self.begin + self.end) / 2).mid()

    def as_row(self) -> dict[str, object]:
        """A plain object for JSON."""
        return {**vars(self), "begin": decimal(self.begin), "end": decimal(self.end)}

    @classmethod
    def of_row(cls, row: Mapping[str, object]) -> "Subinterval":
        """Subinterval from its plain object."""
        ends = {name: Fraction(str(row[name])) for name in ("begin", "end")}
        return cls(**{**row, **ends})  # type: ignore[arg-type] # as it was written

    def meets(self, other: "Subinterval") -> bool:
        """True if this subinterval's gait at its end is proved to be the next one's at its beginning."""
        if not (self.proved and other.proved and self.end == other.begin):
            return False
        return self._has_in_box(other, self.end) or other._has_in_box(self, self.end)

    def _has_in_box(self, other: "Subinterval", value: Fraction) -> bool:
        """True if another subinterval's gait is in the box of this one's only gait, at a shared value."""
        with ctx.workprec(COMPARING_BITS):
            centres = [_centre_at(subinterval, value) for subinterval in (self, other)]
            rows = zip(*centres, other.enclosure, self.box, strict=True)
            return all(abs(a - b) + arb(radius) < arb(room) for a, b, radius, room in rows)


def _centre_at(subinterval: Subinterval, value: Fraction) -> list[arb]:
    away = ball_of(value) - subinterval.middle()
    return [arb(x) + arb(slope) * away for x, slope in zip(subinterval.centre, subinterval.tilt, strict=True)]


@dataclass(frozen=True, repr=False)
class RangeProof(Proved):
    """Gaits over a range of a parameter."""

    name: str
    """Name of the varied parameter; its entry in `values` has no meaning."""
    begin: Fraction
    """The parameter's least value."""
    end: Fraction
    """The parameter's greatest value."""
    subintervals: Sequence[Subinterval] = field(repr=False)
    """Subintervals in order, without gaps."""

    @property
    def left(self) -> list[tuple[Fraction, Fraction]]:
        """Undecided subintervals."""
        return [
            (subinterval.begin, subinterval.end)
            for subinterval in self.subintervals
            if not subinterval.proved
        ]

    @property
    def words(self) -> tuple[str, ...]:
        """Proved gait words, each once, in order."""
        return tuple(
            dict.fromkeys(subinterval.word for subinterval in self.subintervals if subinterval.proved)
        )

    @property
    def stable(self) -> bool | None:
        """Every gait of the range is proved to be stable, or every one to be unstable; None otherwise."""
        found = {subinterval.stable for subinterval in self.subintervals}
        return found.pop() if self.proved and len(found) == 1 else None

    @property
    def is_one_branch(self) -> bool:
        """The gaits of neighbouring subintervals are proved to be one where they meet."""
        return self.proved and all(one.meets(other) for one, other in itertools.pairwise(self.subintervals))

    @property
    def sentence(self) -> str:
        """Statement that is proved, or left open."""
        span = f"{self.name} from {decimal(self.begin)} to {decimal(self.end)}"
        of = reported(self.values, self.name)
        if not self.proved:
            share = float(sum(b - a for a, b in self.left) / (self.end - self.begin))
            left = counted(len(self.left), "subinterval")
            return f"Undecided for the {of}: {share:.3g} of {span} is left, in {left}."
        words = f"the word {self.words[0]}" if len(self.words) == 1 else f"the words {', '.join(self.words)}"
        kind = {True: "; all are stable", False: "; all are unstable", None: self._judgement()}[self.stable]
        joined = " and form one branch" if self.is_one_branch else ""
        return (
            f"The range is divided into {counted(len(self.subintervals), 'subinterval')}, each with "
            f"a box of apices. For each {span}, the {of} has exactly one gait in the box. "
            f"These gaits have {words}{joined}{kind}."
        )

    def _judgement(self) -> str:
        """Shares of the range with stable gaits, with unstable gaits, and without a proof of either."""
        kinds = {"stable": True, "unstable": False, "left open": None}
        shares = {kind: self._share(stable) for kind, stable in kinds.items()}
        return "; of the range " + ", ".join(
            f"{share:.3g} is {kind}" for kind, share in shares.items() if share
        )

    def _share(self, stable: bool | None) -> float:
        widths = [
            subinterval.end - subinterval.begin
            for subinterval in self.subintervals
            if subinterval.stable is stable
        ]
        return float(sum(widths, Fraction(0)) / (self.end - self.begin))

    def as_json(self) -> dict[str, object]:
        """A plain object for JSON."""
        return {
            **self.statement(self.name),
            "vary": self.name,
            "range": [decimal(self.begin), decimal(self.end)],
            "words": list(self.words),
            "stable": self.stable,
            "one_branch": self.is_one_branch,
            "pieces": len(self.subintervals),
            "left": [[decimal(a), decimal(b)] for a, b in self.left],
        }
