"""Proofs of gaits."""

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from flint import arb, ctx

from ..analysis.search import find_orbit
from ..checks import check_kind, checked_whole
from ..errors import InputError
from ..library.members import VARIED
from ..library.orbit import Orbit
from ..library.runner import Runner
from ..unit.unit import load
from .eigenvalues import eigenvalues
from .exact import Exact, exact_values
from .krawczyk import Inclusion, proved_stride, refined
from .parameters import Parameters
from .proof import Box, Proof
from .starts import Fineness, Starts
from .undecided import UndecidedError

DEFAULT_DIGITS = 20
MOST_DIGITS = 200
LEAST_BOX = Fraction(1, 10**MOST_DIGITS)
BOXES = tuple(Fraction(1, 10**places) for places in (10, 13, 16))
"""Radii that are tried where none is asked for, in units of the coordinates' scales."""
BEYOND = 8
"""Decimal places by which the box of the enclosures is smaller than what is asked for."""
GUARD_BITS = 32
COARSE_BITS = 64

Given = Orbit | Runner | Mapping[str, object] | None


def prove(
    gait: Given = None,
    *,
    box: float | str | Fraction | None = None,
    digits: int = DEFAULT_DIGITS,
    exact: Mapping[str, Exact] | None = None,
) -> Proof:
    """A periodic gait, proved: that there is one, and no other near it, its word, and enclosures of the rest.

    Parameters
    ----------
    gait : Orbit, Runner or mapping of str to value, optional
        The gait, or whose. A float is the binary number that it is, a text or a `Fraction` the exact number
        that it reads as: "0.6" is 3/5, "40 deg" is 2 pi/9. What is not given is Table 1, exactly, and so is a
        float of a runner that is the unit's own start value.
    box : float, str or Fraction, optional
        Within how much of the apex, in units of the coordinates' scales, exactly one gait is to lie: around
        the apex of a gait that is given, else around the one that is found. By default, as large a box as is
        proved of some that are tried.
    digits : int, default 20
        That the enclosures are to have, from 5 to 200.
    exact : mapping of str to Exact, optional
        The parameters of a gait's runner, where they are known exactly.

    Returns
    -------
    Proof
        Where `proved` is false, it is undecided, and `undecided` tells the guard and the time.

    Raises
    ------
    InputError
        A value or a name is refused, or it is a gait of the reduced map or of several strides.
    RunError
        No gait was found.

    Examples
    --------
    >>> import tdmf_slip
    >>> proof = tdmf_slip.prove({"ground.friction": "0.6"}, digits=10)
    >>> proof.proved, proof.word, proof.stable
    (True, '+0-0+', True)
    """
    orbit, values = gait_of(gait)
    values |= exact or {}
    digits = checked_whole("digits", digits, 5, MOST_DIGITS)
    asked = None if box is None else radius_of(box)
    return _Prover(orbit, values, digits, isinstance(gait, Orbit)).proof(asked)


def gait_of(gait: Given) -> tuple[Orbit, dict[str, Exact]]:
    """A gait, and its runner's parameters exactly.

    Parameters
    ----------
    gait : Orbit, Runner or mapping of str to value, optional
        As in `prove`.

    Returns
    -------
    Orbit
        In doubles.
    dict of str to Exact
        By the unit's names.

    Raises
    ------
    InputError
        It is something else, or has no proofs.
    """
    unit = load()
    given: dict[str, object] = {}
    if isinstance(gait, Orbit):
        orbit = gait
    elif gait is None or isinstance(gait, Runner):
        orbit = find_orbit(gait, unit=unit)
    else:
        check_kind(gait, Mapping, "gait", "an Orbit, a Runner, or start values by name")
        given = dict(gait)
        exact = exact_values(unit, {name: 0.0 for name in given if name in unit.variables}, given)
        floats = {
            name: float(exact[name].ball()) if name in exact else value for name, value in given.items()
        }
        orbit = find_orbit(floats, unit=unit)  # type: ignore[arg-type] # what is no variable is refused there
    if orbit.runner.reduced:
        raise InputError("a gait of the reduced map is not proved; allowed: one of the full model")
    if orbit.following:
        raise InputError(
            f"a gait of {orbit.strides} strides is not proved; allowed: one that repeats each stride"
        )
    own = {name: orbit.runner.values[name] for name in VARIED}
    return orbit, exact_values(unit, own, {name: value for name, value in given.items() if name in own})


def gait_near(given: Mapping[str, object]) -> dict[str, Any]:
    """Start values as floats, near those that are meant.

    Parameters
    ----------
    given : mapping of str to value
        Floats, fractions and texts, by the unit's names.

    Returns
    -------
    dict of str to float
        What is no variable's is left as it is.

    Raises
    ------
    InputError
        A value is none.
    """
    unit = load()
    exact = exact_values(unit, {name: 0.0 for name in given if name in unit.variables}, given)
    return {name: float(exact[name].ball()) if name in exact else value for name, value in given.items()}


def bits_for(places: int) -> int:
    """Of the working precision, for a box of so many decimal places."""
    return round(3.33 * places) + GUARD_BITS


def radius_of(box: float | str | Fraction) -> Fraction:
    """A radius that is asked for.

    Parameters
    ----------
    box : float, str or Fraction
        A float is the decimal that it is written as.

    Returns
    -------
    Fraction
        Above 0, up to 1.

    Raises
    ------
    InputError
        It is none.
    """
    try:
        radius = Fraction(repr(box) if isinstance(box, float) else box)
    except (TypeError, ValueError, OverflowError, ZeroDivisionError):
        radius = Fraction(0)
    if not LEAST_BOX <= radius <= 1:
        raise InputError(f"box = {box!r} is not allowed; allowed: from 1e-{MOST_DIGITS} to 1")
    return radius


class _Prover:
    """One gait."""

    def __init__(self, orbit: Orbit, values: dict[str, Exact], digits: int, given: bool) -> None:
        self.orbit, self.values, self.digits, self.given = orbit, values, digits, given
        self.parameters = Parameters(values)
        self.scales = [float(scale) for scale in orbit.runner.scales]
        self.start = [arb(float(x)) for x in orbit.apex]

    def proof(self, box: Fraction | None) -> Proof:
        """With a box, or the largest that is proved."""
        smallest = 0 if box is None else math.ceil(-math.log10(box))
        self.narrow = max(self.digits + BEYOND, smallest + 3)
        self.fine = Fineness(bits_for(self.narrow))
        tried = self._box(self.start, BOXES[0] if box is None else box)
        try:
            near = refined(
                self.parameters,
                self.start,
                self.orbit.jacobian - np.eye(6),
                self.fine,
                10.0 ** -(self.narrow + 1),
            )
            tried = self._unique(self.start if self.given else near, box)
            return self._enclosed(tried, near)
        except UndecidedError as problem:
            undecided = {"guard": problem.guard, "time": problem.time}
            return Proof(False, self.values, tried, self.digits, undecided=undecided)

    def _box(self, centre: Sequence[arb], radius: Fraction) -> Box:
        if self.given:
            decimals = [Fraction(repr(float(x))) for x in self.orbit.apex]
            return Box(decimals, [radius * Fraction(scale) for scale in self.scales])
        return Box.around(centre, radius, self.scales)

    def _unique(self, centre: Sequence[arb], asked: Fraction | None) -> Box:
        """A box in which exactly one gait is."""
        tried = BOXES if asked is None else [asked]
        for radius in tried:
            box = self._box(centre, radius)
            fine = Fineness(max(COARSE_BITS, round(-math.log2(radius)) + GUARD_BITS))
            with ctx.workprec(fine.bits):
                starts = box.starts()
            try:
                Inclusion(starts, proved_stride(self.parameters, starts, fine, fine), fine)
                return box
            except UndecidedError:
                if radius == tried[-1]:
                    raise
        raise AssertionError("one box is tried at least")

    def _enclosed(self, box: Box, near: Sequence[arb]) -> Proof:
        """All that is told of the gait, from a box that is as small as the digits ask for."""
        with ctx.workprec(self.fine.bits):
            small = Starts(near, [(arb(10) ** -self.narrow * scale).upper().mid() for scale in self.scales])
        stride = proved_stride(self.parameters, small, self.fine, self.fine)
        inside = Inclusion(small, stride, self.fine)
        with ctx.workprec(self.fine.bits):
            if not box.holds(inside.solution):
                raise UndecidedError("whether the gait lies in the box")
            assert stride.derivative is not None
            found = eigenvalues(stride.derivative, stride.rank)
        return Proof(
            proved=True,
            values=self.values,
            box=box,
            digits=self.digits,
            word=stride.word,
            stable=found.stable,
            apex=inside.solution,
            quantities=stride.quantities,
            eigenvalues=found.discs,
            events=[(event.name, event.time) for event in stride.events],
        )
