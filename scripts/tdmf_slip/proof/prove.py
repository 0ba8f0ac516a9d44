"""Proofs of gaits."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from fractions import Fraction
from pathlib import Path
from typing import overload

import numpy as np
from flint import acb, arb, ctx

from ..checks import checked_whole
from ..errors import InputError
from ..files.whole import check_destination
from ..library.gait import Gait
from ..library.members import pairs_varied
from ..library.runner import Runner
from ..library.shared_steps import shares_steps
from ..variables.parameters import RUNNER
from ..variables.table import VARIABLES, by_full_name
from .dual import UndecidedError
from .given import MAX_DIGITS, Exact, Radius, RunnerLike, exact_value, gait_of, radius_of
from .krawczyk import Inclusion, eigenvalues, refined, stability, unique_box
from .parameters import Parameters
from .proof import Box, Proof
from .range_proof import RangeProof
from .range_prover import prove_range
from .starts import Starts

DEFAULT_DIGITS = 20
BOXES = tuple(Fraction(1, 10**decimals) for decimals in (6, 8, 10, 13, 16))
"""Radii that are tried where none is asked for, in units of the coordinates' scales."""
BEYOND = 8
"""Decimal places by which the box of the enclosures is smaller than what is asked for."""
MIN_DECIMALS = 16
"""Fewest decimal places of that box: a wider one costs as much, and eigenvalues get too few digits."""
REFINEMENTS = 3
"""Number of times that the box of the enclosures is made smaller where digits are missing."""
GUARD_BITS = 32


@overload
def prove(
    gait: RunnerLike = ...,
    *,
    box: Radius | None = ...,
    digits: int = ...,
    vary: None = ...,
    output: None = ...,
    executor: None = ...,
    progress: bool = ...,
) -> Proof: ...


@overload
def prove(
    gait: RunnerLike = ...,
    *,
    vary: Mapping[str, tuple[Radius, Radius]],
    output: str | Path | None = ...,
    executor: Executor | None = ...,
    progress: bool = ...,
) -> RangeProof: ...


@shares_steps
def prove(
    gait: RunnerLike = None,
    *,
    box: Radius | None = None,
    digits: int = DEFAULT_DIGITS,
    vary: Mapping[str, tuple[Radius, Radius]] | None = None,
    output: str | Path | None = None,
    executor: Executor | None = None,
    progress: bool = False,
) -> Proof | RangeProof:
    """Prove a periodic gait: that there is exactly one in a box, its word, and enclosures of the rest.

    With `vary`, prove gaits over a whole range of a parameter: for each value exactly one in a box, with its
    word, and whether all are stable.

    Parameters
    ----------
    gait : Gait, Runner, mapping of str to value, Series, str or Path, optional
        The gait, or its runner. A float is the binary number that it is, a text or a `Fraction` the exact
        number that it reads as: "0.6" is 3/5, "40 deg" is 2 pi/9. What is not given is Table 1, exactly, and
        so is a float of a runner that is the unit's own start value.
    box : float, str or Fraction, optional
        Radius of the box, in units of the coordinates' scales, around the apex of the gait that is given or
        found. By default the largest of several that can be proved.
    digits : int, default 20
        Digits of the enclosures, from 5 to 200.
    vary : mapping of str to pair, optional
        A parameter, and the ends of its range; exact like all values.
    output : str or path, optional
        With `vary`: a file of JSON lines to which each part of the range is added as it is done, and from
        which a proof is resumed.
    executor : concurrent.futures.Executor, optional
        With `vary`: proves parts of the range side by side, such as a `ProcessPoolExecutor()` or
        `client.get_executor()` of Dask. By default, and in threads, one is proved after the other.
    progress : bool, default False
        With `vary`: a bar on stderr.

    Returns
    -------
    Proof or RangeProof
        Where `proved` is false, the proof is undecided and says where.

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
    if vary is not None:
        if box is not None:
            raise InputError("box: a range chooses its own boxes; allowed: without vary")
        return _over(gait, vary, output, executor, progress)
    if output is not None or executor is not None:
        raise InputError("output and executor are for a range only; allowed: with vary")
    digits = checked_whole("digits", digits, 5, MAX_DIGITS)
    asked = None if box is None else radius_of(box)
    return Prover(*gait_of(gait), digits, given=isinstance(gait, Gait)).proof(asked)


def _over(
    gait: RunnerLike,
    vary: Mapping[str, tuple[Radius, Radius]],
    output: str | Path | None,
    executor: Executor | None,
    progress: bool,
) -> RangeProof:
    allowed = "a parameter with the two ends of its range"
    ((name, row),) = pairs_varied(vary, {1}, allowed).items()
    ends = [exact_value(VARIABLES[name], end, "vary") for end in row]
    if any(end.turns for end in ends):
        raise InputError(f"vary: {name} from {ends[0]} to {ends[1]}; allowed: rational ends")
    begin, end = (end.rational for end in ends)
    if not begin < end:
        raise InputError(f"vary: {name} from {begin} to {end}; allowed: a range from less to more")
    if gait is None or (isinstance(gait, Mapping) and not isinstance(gait, Runner)):
        gait = {name: begin, **by_full_name(gait, "gait", RUNNER)}
    path = None if output is None else check_destination(output, None, "output")
    found, values = gait_of(gait)
    return prove_range(found, values, name, (begin, end), output=path, executor=executor, progress=progress)


def bits_for(decimals: int) -> int:
    """Bits of the working precision, for a box of so many decimal places."""
    return round(3.33 * decimals) + GUARD_BITS


def known_digits(balls: Sequence[arb | acb]) -> int:
    """Digits after the point that are known of the least exact of some numbers."""
    worst = max(float(ball.rad()) for ball in balls)
    return math.floor(-math.log10(worst)) if 0.0 < worst < math.inf else (MAX_DIGITS if not worst else 0)


class Prover:
    """Prover of one gait, whose parameters are known exactly."""

    def __init__(self, gait: Gait, values: Mapping[str, Exact], digits: int, *, given: bool = False) -> None:
        """Keep the gait; if it is given, the box is exactly around its apex."""
        self.gait, self.values, self.digits, self.given = gait, values, digits, given
        self.parameters = Parameters(values)
        self.scales = [float(scale) for scale in gait.runner.scales]

    def proof(self, asked: Fraction | None = None) -> Proof:
        """Proof for the given box, or for the largest that is proved."""
        smallest = 0 if asked is None else math.ceil(-math.log10(asked))
        start = [arb(float(x)) for x in self.gait.apex]
        radii = BOXES if asked is None else (asked,)
        narrow = max(self.digits + BEYOND, MIN_DECIMALS, smallest + 3)
        tried = self._box(start, radii[0])
        try:
            near = self._near(start, narrow)
            tried = unique_box(self.parameters, radii, lambda radius: self._box(near, radius), GUARD_BITS)
            return self._reported(tried, near, narrow)
        except UndecidedError as problem:
            return Proof(False, self.values, tried, self.digits, undecided=problem.as_json())

    def _near(self, start: Sequence[arb], narrow: int) -> list[arb]:
        """A point near the gait, to more decimal places than those of a narrow box."""
        jacobian, bits = self.gait.jacobian - np.eye(6), bits_for(narrow)
        return refined(self.parameters, start, jacobian, bits, 10.0 ** -(narrow + 1))

    def _reported(self, box: Box, near: Sequence[arb], narrow: int) -> Proof:
        """Proof with the digits that are asked for, from a smaller box where the map loses too many."""
        found = self._enclosed(box, near, narrow)
        for _ in range(REFINEMENTS):
            missing = self.digits - known_digits([*found.apex, *found.eigenvalues])
            if missing <= 0:
                break
            narrow += missing + 2
            try:
                found = self._enclosed(box, self._near(near, narrow), narrow)
            except UndecidedError:
                break
        return found

    def _box(self, centre: Sequence[arb], radius: Fraction) -> Box:
        if self.given:
            decimals = [Fraction(repr(float(x))) for x in self.gait.apex]
            return Box(decimals, [radius * Fraction(scale) for scale in self.scales])
        return Box.around(centre, radius, self.scales)

    def _enclosed(self, box: Box, near: Sequence[arb], narrow: int) -> Proof:
        """All that is reported of the gait, from a box of so many decimal places."""
        bits = bits_for(narrow)
        with ctx.workprec(bits):
            inside = Inclusion(self.parameters, Starts.around(near, arb(10) ** -narrow, self.scales), bits)
            if not box.holds(inside.solution):
                raise UndecidedError("whether the gait lies in the box")
            stride = inside.stride
            discs, stable = eigenvalues(stride.derivative, stride.rank), stability(stride.derivative)
        return Proof(
            proved=True,
            values=self.values,
            box=box,
            digits=self.digits,
            word=stride.word,
            stable=stable,
            apex=inside.solution,
            quantities=stride.quantities,
            eigenvalues=discs,
            events=[(event.name, event.time) for event in stride.events],
        )
