"""Proofs of borders between gait words."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction

from flint import arb, ctx

from ..analysis.search import periodic_gait
from ..checks import checked_flag, checked_whole, number_of, refusal
from ..library.gait import Gait
from ..library.members import check_varied
from ..library.runner import Runner
from ..library.section import COORDINATES
from ..library.shared_steps import shares_steps
from ..variables.table import FRICTION, full_name
from .dual import UndecidedError
from .given import MAX_DIGITS, Exact, RunnerLike, exact_runner, runner_of
from .krawczyk import COARSE_BITS, Inclusion, middle_of, refined, slopes_of, unique_box
from .parameters import Forced, Parameters
from .proof import Box, Proof, Proved, decimal, exactly, reported, short, text_of
from .prove import BEYOND, BOXES, DEFAULT_DIGITS, Prover, bits_for
from .starts import Starts
from .stride import Traveller
from .travelling_set import SetTraveller

BESIDE = 1e-7
"""Distance from a border of the gaits that decide its kind, over the parameter."""
ROUGH = 1e-12


@dataclass(frozen=True, repr=False)
class BorderProof(Proved):
    """A border between gait words, with enclosures, or what could not be decided."""

    name: str
    """Name of the varied parameter; its entry in `values` has no meaning."""
    digits: int
    """Number of digits that were asked for."""
    kind: str = ""
    """Events that coincide on the border."""
    word_continued: str = ""
    """The gait word of the side along which the stride was continued across it."""
    value: arb | None = None
    """Enclosure of the parameter."""
    apex: list[arb] = field(default_factory=list, repr=False)
    """Apex of the gait on the border, shape (6,)."""
    box: Box | None = field(default=None, repr=False)
    """Box of apexes and parameter that contains exactly one border."""
    sides: tuple[Proof, ...] = field(default=(), repr=False)
    """Proofs of a gait on each side."""
    undecided: Mapping[str, object] = field(default_factory=dict)
    """Place where an undecided proof ended: `guard` and `time`."""

    @property
    def words(self) -> tuple[str, ...]:
        """Gait words of the sides whose gait is proved, in the parameter's order."""
        return tuple(side.word for side in self.sides if side.proved)

    def as_json(self) -> dict[str, object]:
        """Plain object in which enclosures are texts `[mid +/- radius]`."""
        return {
            **self.statement(self.name),
            "vary": self.name,
            "value": text_of(self.value, self.digits),
            "kind": self.kind or None,
            "word_continued": self.word_continued or None,
            "apex": [text_of(x, self.digits) for x in self.apex] or None,
            "box": None if self.box is None else self.box.as_json([*COORDINATES, self.name]),
            "sides": [
                {
                    "value": decimal(side.values[self.name].rational),
                    "proved": side.proved,
                    "word": side.word or None,
                    "sentence": side.sentence,
                }
                for side in self.sides
            ],
            "undecided": dict(self.undecided) or None,
        }

    @property
    def sentence(self) -> str:
        """Statement that is proved, or left open."""
        of = reported(self.values, self.name)
        if not self.proved or self.value is None or self.box is None:
            return f"Undecided for the {of}: {self.undecided.get('guard')}."
        text = (
            f"The {of} has exactly one gait whose apex and {self.name} are within "
            f"{short(max(self.box.radii))} of ({', '.join(decimal(x) for x in self.box.centre)}), with a "
            f"{self.kind} after which the stride continues as {self.word_continued}. Its {self.name} lies in "
            f"{text_of(self.value, self.digits)}."
        )
        sides = ", ".join(self._reported_side(side) for side in self.sides)
        changes = "The word changes: " if len(set(self.words)) > 1 else ""
        return f"{text} {changes}{sides}." if sides else text

    def _reported_side(self, side: Proof) -> str:
        at = f"at {decimal(side.values[self.name].rational)}"
        return f"{side.word} {at} is proved" if side.proved else f"the gait {at} is undecided"


@shares_steps
def prove_border(
    border: float,
    runner: RunnerLike = None,
    *,
    vary: str = FRICTION,
    digits: int = DEFAULT_DIGITS,
    sides: bool = True,
) -> BorderProof:
    """Prove a border between gait words: where two events happen at once, and a gait on each side.

    Parameters
    ----------
    border : float
        Value of the parameter at the border, as the borders of a sweep have it.
    runner : Runner, Gait, mapping of str to float, Series, str or Path, optional
        Runner of the gaits; exact as in `prove`.
    vary : str, default "ground.friction"
        Name of the parameter.
    digits : as in `prove`
    sides : bool, default True
        Prove a gait on each side, too.

    Returns
    -------
    BorderProof
        Where `proved` is false, it is undecided.

    Raises
    ------
    InputError
        A value or a name is refused.
    RunError
        There is no gait beside it.

    Examples
    --------
    >>> import tdmf_slip
    >>> gaits, borders = tdmf_slip.sweep({}, {"ground.friction": [0.3, 0.25]})
    >>> tdmf_slip.prove_border(borders["ground.friction"][0], digits=5, sides=False).proved
    True
    """
    vary = full_name(vary)
    check_varied(vary, "vary")
    digits = checked_whole("digits", digits, 5, MAX_DIGITS)
    value = number_of(border)
    if value is None:
        raise refusal("border", border, "its value, as the borders of a sweep have it")
    with_sides = checked_flag("sides", sides)
    found, given = runner_of(runner)
    values = exact_runner(found, {name: number for name, number in given.items() if name != vary})
    try:
        proof = _proved(found, values, vary, value, digits)
    except UndecidedError as problem:
        return BorderProof(False, values, vary, digits, undecided=problem.as_json())
    return replace(proof, sides=_sides(proof, found, _step(value))) if with_sides else proof


def _step(value: float) -> float:
    """Distance from a border of the gaits that decide its kind."""
    return BESIDE * max(abs(value), BESIDE)


def _proved(runner: Runner, values: Mapping[str, Exact], name: str, value: float, digits: int) -> BorderProof:
    """A border without its sides."""
    parameters, narrow = Parameters(values, name), digits + BEYOND
    bits, seen = bits_for(narrow), []
    for by in (-_step(value), _step(value)):
        gait = periodic_gait(runner.replace({name: value + by}))
        apex = [arb(float(x)) for x in (*gait.apex, gait.runner[name])]
        seen.append((gait, Traveller(parameters, apex, COARSE_BITS).stride()))
    forced, gait = _distinguished(*seen)
    scales = [*(float(scale) for scale in gait.runner.scales), max(abs(value), 1.0)]
    start = [arb(float(x)) for x in (*gait.apex, value)]
    stride = SetTraveller(parameters, Starts.around(start, arb(ROUGH), scales), COARSE_BITS, forced).stride()
    jacobian = middle_of(slopes_of(stride))
    near = refined(parameters, start, jacobian, bits, 10.0 ** -(narrow + 1), forced)
    box = unique_box(parameters, BOXES, lambda radius: Box.around(near, radius, scales), COARSE_BITS, forced)
    with ctx.workprec(bits):
        inside = Inclusion(parameters, Starts.around(near, arb(10) ** -narrow, scales), bits, forced)
        if not box.holds(inside.solution):
            raise UndecidedError("whether the border lies in the box")
    return BorderProof(
        proved=True,
        name=name,
        values=values,
        digits=digits,
        kind=forced.kind,
        word_continued=inside.stride.word,
        value=inside.solution[6],
        apex=inside.solution[:6],
        box=box,
    )


def _sides(proof: BorderProof, runner: Runner, step: float) -> tuple[Proof, ...]:
    """Gaits at decimals below and above a border."""
    assert proof.value is not None
    decimals = 1 - math.floor(math.log10(step))
    middle = round(exactly(proof.value) * 10**decimals)
    found = []
    for value in (Fraction(middle + by, 10**decimals) for by in (-20, 20)):
        gait = periodic_gait(runner.replace({proof.name: float(value)}))
        found.append(Prover(gait, {**proof.values, proof.name: Exact(value)}, 6).proof())
    return tuple(found)


def _distinguished(one: tuple[Gait, Traveller], other: tuple[Gait, Traveller]) -> tuple[Forced, Gait]:
    """Kind of the events that happen at once between two gaits, and the gait whose side is smooth across."""
    pairs = zip(one[1].events, other[1].events, strict=False)
    for index, (first, second) in enumerate(pairs):
        if (first.name, first.mode) == (second.name, second.mode):
            continue
        sides = ((first, one[0]), (second, other[0]))
        names = {first.name, second.name}
        for event, gait in sides:
            slips = event.mode.contact == "slip"
            if names == {"end of slip", "lift-off"} and event.name == "lift-off":
                return Forced(index, event.name, "rest as it lifts off"), gait
            if names == {"touchdown"} and not slips:
                return Forced(index, event.name, "impact at the limit of the cone"), gait
            if len(names) == 1 and "touchdown" not in names and slips:
                return Forced(index, event.name, "rest at the limit of the cone", event.mode.sign), gait
    raise UndecidedError("which two events happen at once: gaits beside the border have the same")
