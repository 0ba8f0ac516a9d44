"""What is proved of gaits over a range of a parameter, piece by piece."""

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from flint import arb, ctx

from .exact import Exact, ball_of
from .proof import decimal, statement, told

BITS = 56
"""Of the arithmetic in which pieces are proved."""
COMPARING_BITS = 2 * BITS


@dataclass(frozen=True)
class Piece:
    """A part of the range: what is proved of it, or that it is left."""

    begin: Fraction
    """The parameter's least value in it."""
    end: Fraction
    """The parameter's greatest value in it."""
    word: str = ""
    """The gait word; empty where it is left undecided."""
    stable: bool | None = None
    """All gaits are stable, or none; None where neither is proved."""
    centre: Sequence[float] = ()
    """The apex that xi is counted from, at the middle of the piece, shape (6,)."""
    tilt: Sequence[float] = ()
    """Its change by the parameter, shape (6,)."""
    box: Sequence[float] = ()
    """Radii of xi in which there is exactly one gait for each value."""
    enclosure: Sequence[float] = ()
    """Radii of xi that hold it."""
    undecided: str = ""
    """What could not be decided."""

    @property
    def proved(self) -> bool:
        """There is exactly one gait, with this word, for each value."""
        return bool(self.word)

    def middle(self) -> arb:
        """The point, in its middle or very near it, that its tilt is counted from."""
        with ctx.workprec(BITS):
            return ball_of((self.begin + self.end) / 2).mid()

    def as_row(self) -> dict[str, object]:
        """As a plain object."""
        return {**vars(self), "begin": decimal(self.begin), "end": decimal(self.end)}

    @classmethod
    def of_row(cls, row: Mapping[str, object]) -> "Piece":
        """Of a plain object."""
        ends = {name: Fraction(str(row[name])) for name in ("begin", "end")}
        return cls(**{**row, **ends})  # type: ignore[arg-type] # as it was written

    def meets(self, other: "Piece") -> bool:
        """Whether its gait at its end is proved to be that of the next piece at its beginning."""
        if not (self.proved and other.proved and self.end == other.begin):
            return False
        return self._has_in_box(other, self.end) or other._has_in_box(self, self.end)

    def _has_in_box(self, other: "Piece", value: Fraction) -> bool:
        """Whether another's gait is in the box in which its own is the only one, at a value of both."""
        with ctx.workprec(COMPARING_BITS):
            places = [_place(piece, value) for piece in (self, other)]
            rows = zip(*places, other.enclosure, self.box, strict=True)
            return all(abs(a - b) + arb(radius) < arb(room) for a, b, radius, room in rows)


def _place(piece: Piece, value: Fraction) -> list[arb]:
    away = ball_of(value) - piece.middle()
    return [arb(x) + arb(slope) * away for x, slope in zip(piece.centre, piece.tilt, strict=True)]


@dataclass(frozen=True)
class RangeProof:
    """Gaits over a range of a parameter."""

    name: str
    """Of the parameter."""
    begin: Fraction
    """The parameter's least value."""
    end: Fraction
    """The parameter's greatest value."""
    values: Mapping[str, Exact] = field(repr=False)
    """The runner's other parameters, exactly."""
    pieces: Sequence[Piece] = field(repr=False)
    """In order, without gaps."""

    @property
    def proved(self) -> bool:
        """Nothing of the range is left."""
        return all(piece.proved for piece in self.pieces)

    @property
    def left(self) -> list[tuple[Fraction, Fraction]]:
        """What is undecided."""
        return [(piece.begin, piece.end) for piece in self.pieces if not piece.proved]

    @property
    def words(self) -> tuple[str, ...]:
        """That are proved, each once, in order."""
        return tuple(dict.fromkeys(piece.word for piece in self.pieces if piece.proved))

    @property
    def stable(self) -> bool | None:
        """Every gait of the range is proved to be stable, or every one to be unstable; None otherwise."""
        found = {piece.stable for piece in self.pieces}
        return found.pop() if self.proved and len(found) == 1 else None

    @property
    def is_one_branch(self) -> bool:
        """The gaits of neighbouring pieces are proved to be one where they meet."""
        return self.proved and all(one.meets(other) for one, other in itertools.pairwise(self.pieces))

    @property
    def sentence(self) -> str:
        """What is proved, or left."""
        span = f"{self.name} from {decimal(self.begin)} to {decimal(self.end)}"
        of = told(self.values, self.name)
        if not self.proved:
            share = float(sum(b - a for a, b in self.left) / (self.end - self.begin))
            return f"Undecided for {of}: {share:.3g} of {span} is left, in {len(self.left)} pieces."
        words = f"the word {self.words[0]}" if len(self.words) == 1 else f"the words {', '.join(self.words)}"
        kind = {True: "; all are stable", False: "; all are unstable", None: self._judgement()}[self.stable]
        joined = ", all of one branch" if self.is_one_branch else ""
        return (
            f"Of {of}, for each {span}, there is exactly one gait in one of {len(self.pieces)} boxes, with "
            f"{words}{joined}{kind}."
        )

    def _judgement(self) -> str:
        """How much of the range has stable gaits, unstable ones, and what is left."""
        kinds = {"stable": True, "unstable": False, "left open": None}
        shares = {kind: self._share(stable) for kind, stable in kinds.items()}
        return "; of the range " + ", ".join(
            f"{share:.3g} is {kind}" for kind, share in shares.items() if share
        )

    def _share(self, stable: bool | None) -> float:
        widths = [piece.end - piece.begin for piece in self.pieces if piece.stable is stable]
        return float(sum(widths, Fraction(0)) / (self.end - self.begin))

    def as_json(self) -> dict[str, object]:
        """As a plain object."""
        return {
            **statement(self),
            "vary": self.name,
            "range": [decimal(self.begin), decimal(self.end)],
            "words": list(self.words),
            "stable": self.stable,
            "one_branch": self.is_one_branch,
            "pieces": len(self.pieces),
            "left": [[decimal(a), decimal(b)] for a, b in self.left],
        }
