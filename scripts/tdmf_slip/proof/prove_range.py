"""Proofs of gaits over a whole range of a parameter, by subdivision.

In a piece of the range the gait is sought at  centre + tilt (q - middle) + xi  with xi in a small box: the
tilt is the tangent of the branch, so that xi has only what the branch bends, which is of second order in the
width.
"""

import itertools
import json
import math
import os
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from fractions import Fraction
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np
from flint import arb, arb_mat, ctx
from numpy.typing import NDArray

from ..analysis.search import find_orbit
from ..errors import InputError, RunError
from ..library.orbit import Orbit, orbit_near
from ..library.runner import Runner
from ..terminal import progress
from .eigenvalues import is_contracting
from .exact import Exact, ball_of
from .krawczyk import Inclusion, NotIncludedError, proved_stride
from .parameters import Parameters
from .range_proof import Piece, RangeProof
from .starts import Fineness, Starts
from .undecided import UndecidedError

BITS = 56
FIRST_WIDTH = Fraction(1, 10**6)
"""Of the boxes that are tried first, over the range's scale."""
NARROWEST = Fraction(1, 10**10)
"""A box that is undecided and no wider is left."""
GROWTH, SHRINKAGE = Fraction(5, 4), Fraction(1, 2)
ROOM = 1.6
"""By how much the box of xi is wider than what the operator makes of it."""
TRIES = 4
PARTS = 64
"""Into which a range is cut, to be proved side by side; each is written to a file as it is done."""


class RangeProver:
    """Of one runner, along one parameter."""

    def __init__(self, runner: Runner, values: Mapping[str, Exact], name: str) -> None:
        """Whose gaits, with exact values, and what is varied."""
        self.runner, self.name = runner, name
        self.parameters = Parameters(values, name)
        self.fine = Fineness(BITS)
        self.bend: list[float] | None = None

    def pieces(self, begin: Fraction, end: Fraction) -> Iterator[Piece]:
        """Pieces from one end to the other.

        Parameters
        ----------
        begin, end : Fraction
            Of a range.

        Yields
        ------
        Piece
            In order, without gaps.
        """
        width, orbit = min(FIRST_WIDTH, end - begin), None
        while begin < end:
            until = min(begin + width, end)
            try:
                orbit = self._orbit((begin + until) / 2, orbit)
                yield self._piece(begin, until, orbit)
                begin, width = until, _short((until - begin) * GROWTH)
            except (UndecidedError, RunError) as problem:
                if until - begin <= NARROWEST:
                    yield Piece(begin, until, undecided=str(problem))
                    begin = until
                else:
                    width = _short((until - begin) * SHRINKAGE)

    def _orbit(self, value: Fraction, last: Orbit | None) -> Orbit:
        runner = self.runner.but(self.name, float(value))
        if last is None:
            return find_orbit(runner, along=self.name)
        return orbit_near(runner, last.apex, along=self.name)

    def _piece(self, begin: Fraction, end: Fraction, orbit: Orbit) -> Piece:
        """One box, or no decision."""
        middle, half = (begin + end) / 2, (end - begin) / 2
        tilt = np.linalg.solve(np.eye(6) - orbit.jacobian, np.asarray(orbit.by_parameter))
        square = float(half) ** 2
        box = [bend * square for bend in self.bend] if self.bend else [1e3 * square + 1e-11] * 6
        for _ in range(TRIES):
            try:
                return self._proved(begin, end, middle, half, orbit, tilt, box)
            except NotIncludedError as problem:
                box = [ROOM * max(size, 1e-12) for size in problem.image]
                if max(box) > 100.0 * float(half):
                    break
                self.bend = [size / square for size in box]
        raise UndecidedError("the inclusion of the fixed point in the box")

    def _proved(
        self,
        begin: Fraction,
        end: Fraction,
        middle: Fraction,
        half: Fraction,
        orbit: Orbit,
        tilt: NDArray[np.float64],
        box: Sequence[float],
    ) -> Piece:
        with ctx.workprec(BITS):
            value = ball_of(middle)
            radius = (ball_of(half) + value.rad()).upper().mid()
            centre = [*(arb(float(x)) for x in orbit.apex), value.mid()]
            starts = Starts(centre, [*(arb(r) for r in box), radius], [arb(float(t)) for t in tilt])
        stride = proved_stride(self.parameters, starts, self.fine, self.fine)
        inside = Inclusion(starts, stride, self.fine)
        assert stride.derivative is not None
        with ctx.workprec(BITS):
            square = arb_mat(6, 6, [stride.derivative[i, j] for i in range(6) for j in range(6)])
            stable = is_contracting(square)
        return Piece(
            begin,
            end,
            stride.word,
            stable,
            [float(x) for x in orbit.apex],
            [float(t) for t in tilt],
            list(box),
            [math.nextafter(size, math.inf) for size in inside.image],
        )


def _short(width: Fraction) -> Fraction:
    """A decimal near a width, so that the ends of pieces stay short."""
    places = 1 - math.floor(math.log10(width))
    return Fraction(math.floor(width * 10**places), 10**places)


def prove_pieces(
    runner: Runner, values: Mapping[str, Exact], name: str, ends: tuple[Fraction, Fraction]
) -> list[Piece]:
    """All pieces of a range, in this process."""
    return list(RangeProver(runner, values, name).pieces(*ends))


def cut(begin: Fraction, end: Fraction, number: int) -> list[tuple[Fraction, Fraction]]:
    """A range in so many parts of one width."""
    places = [begin + (end - begin) * k / number for k in range(number + 1)]
    return list(itertools.pairwise(places))


def side_by_side(
    runner: Runner,
    values: Mapping[str, Exact],
    name: str,
    parts: Sequence[tuple[Fraction, Fraction]],
    workers: int,
) -> Iterator[list[Piece]]:
    """Pieces of parts of a range, in processes side by side.

    Parameters
    ----------
    runner : Runner
        Whose gaits.
    values : mapping of str to Exact
        Its parameters.
    name : str
        What is varied.
    parts : sequence of pairs
        Of ends.
    workers : int
        How many processes.

    Yields
    ------
    list of Piece
        Of each part, in the order of the parts.
    """
    if workers == 1 or len(parts) < 2:
        for part in parts:
            yield prove_pieces(runner, values, name, part)
        return
    with ProcessPoolExecutor(workers, mp_context=get_context("spawn")) as pool:
        running = [pool.submit(prove_pieces, runner, values, name, part) for part in parts]
        try:
            for one in running:
                yield one.result()
        finally:
            for one in running:
                one.cancel()


def prove_range(
    orbit: Orbit,
    values: Mapping[str, Exact],
    name: str,
    ends: tuple[Fraction, Fraction],
    *,
    output: Path | None = None,
    workers: int | None = None,
    show_progress: bool = False,
) -> RangeProof:
    """Gaits over a range of a parameter, by subdivision.

    Parameters
    ----------
    orbit : Orbit
        A gait of the runner.
    values : mapping of str to Exact
        Its parameters.
    name : str
        What is varied.
    ends : pair of Fraction
        Of the range, the lower first.
    output : Path, optional
        A file of JSON lines, to which each part of the range is added as it is done; what it has already of
        the same range is not proved again.
    workers : int, optional
        Processes; by default one for each processor.
    show_progress : bool, default False
        A bar on stderr.

    Returns
    -------
    RangeProof
        With what is proved, and what is left.

    Raises
    ------
    InputError
        The file is of something else.
    """
    wide = ends[1] - ends[0]
    parts = cut(*ends, PARTS if wide > 50 * FIRST_WIDTH else 1)
    head = {"vary": name, "range": [str(end) for end in ends], "parameters": _told(values, name)}
    done = _done(output, head)
    open_ones = [part for part in parts if part not in done]
    workers = workers or os.cpu_count() or 1
    with progress.bar("prove", len(parts), "parts", show_progress) as bar:
        for _ in range(len(parts) - len(open_ones)):
            bar.update()
        found = side_by_side(orbit.runner, values, name, open_ones, workers)
        for part, pieces in zip(open_ones, found, strict=True):
            done[part] = pieces
            _write(output, head, part, pieces)
            bar.update()
    return RangeProof(name, *ends, values, [piece for part in parts for piece in done[part]])


def _told(values: Mapping[str, Exact], name: str) -> dict[str, str]:
    return {of: str(value) for of, value in values.items() if of != name}


def _done(output: Path | None, head: Mapping[str, object]) -> dict[tuple[Fraction, Fraction], list[Piece]]:
    """Parts that a file has already; a last line that was cut off is none."""
    if output is None or not output.exists():
        return {}
    lines = output.read_text(encoding="utf-8").splitlines()
    rows = [row for line in lines if (row := _row(line)) is not None]
    if not rows or rows[0] != head:
        raise InputError(
            f"{output}: is not of this range and runner; allowed: a new file, or one of the same"
        )
    return {
        (Fraction(row["part"][0]), Fraction(row["part"][1])): [Piece.of_row(piece) for piece in row["pieces"]]
        for row in rows[1:]
    }


def _row(line: str) -> Any:
    try:
        return json.loads(line)
    except ValueError:
        return None


def _write(
    output: Path | None, head: Mapping[str, object], part: tuple[Fraction, Fraction], pieces: list[Piece]
) -> None:
    if output is None:
        return
    lines = [] if output.exists() else [head]
    lines.append({"part": [str(end) for end in part], "pieces": [piece.as_row() for piece in pieces]})
    with output.open("a", encoding="utf-8") as file:
        file.write("".join(f"{json.dumps(line)}\n" for line in lines))
