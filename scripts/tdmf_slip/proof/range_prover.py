"""Gaits over a range of a parameter, subinterval by subinterval, each as wide as its enclosures allow.

In a subinterval of the range the gait is sought at centre + tilt (q - middle) + xi with xi in a small box:
the tilt is the tangent of the branch, so that xi has only what the branch bends, which is of second order
in the width.
"""

import itertools
import json
import math
import os
import threading
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import replace
from fractions import Fraction
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from flint import arb, arb_mat, ctx
from numpy.typing import NDArray

from ..analysis.search import periodic_gait
from ..blocks import InTurn
from ..errors import InputError, RunError
from ..files.whole import not_written
from ..library.fixed_point import gait_near
from ..library.gait import Gait
from ..library.runner import Runner
from ..record import origin_of
from ..terminal.in_blocks import in_blocks
from .dual import UndecidedError
from .given import Exact, ball_of
from .krawczyk import ROOM, Inclusion, NotIncludedError, stability
from .parameters import Parameters
from .proof import texts_of
from .range_proof import BITS, RangeProof, Subinterval
from .starts import Starts

FIRST = Fraction(1, 4)
"""Share of a too wide subinterval that is tried next, until the first one is proved."""
NARROWEST = Fraction(1, 10**10)
"""Width below which an undecided subinterval is not divided further."""
GROWTH = 4.0
"""Largest growth of the width from one subinterval to the next."""
SHRINKAGE = Fraction(3, 4)
RECOVERY = Fraction(103, 100)
"""Growth of the width by each subinterval that is proved after one that was too wide."""
FULL = 0.6
"""Share of a box that the operator leaves in a box of the best width; 1 proves nothing."""
TRIES = 4
WIDEST_BOX = 1.5
"""Widest box of xi, over the subinterval's width: a wider one bends the stride more than the parameter."""
SPLITS = 3
"""Number of halvings of a subinterval whose gaits are proved, but not their stability."""


class RangeProver:
    """Proves ranges of one runner along one parameter."""

    def __init__(self, runner: Runner, values: Mapping[str, Exact], name: str) -> None:
        """Exact values of the runner, and the name of the varied parameter."""
        self.runner, self.name = runner, name
        self.parameters = Parameters(values, name)
        self.bend: list[float] = [1.0] * 6
        self.growth = 1.0

    def subintervals(self, begin: Fraction, end: Fraction) -> Iterator[Subinterval]:
        """Prove subintervals from one end to the other."""
        width, gait, shrinkage, splits = end - begin, None, FIRST, SPLITS
        maximum = width
        while begin < end:
            until = min(begin + short_decimal(min(width, maximum)), end)
            try:
                gait = self._gait((begin + until) / 2, gait)
                subinterval = self._subinterval(begin, until, gait)
                if subinterval.stable is None and splits:
                    width, splits = (until - begin) / 2, splits - 1
                    continue
            except (UndecidedError, RunError) as problem:
                if until - begin > NARROWEST:
                    width, maximum = (until - begin) * shrinkage, (until - begin) * SHRINKAGE
                    continue
                subinterval = Subinterval(begin, until, undecided=str(problem))
            yield subinterval
            width, maximum = (until - begin) * Fraction(self.growth), short_decimal(maximum * RECOVERY, 5)
            begin, shrinkage, splits = until, SHRINKAGE, SPLITS

    def _gait(self, value: Fraction, last: Gait | None) -> Gait:
        runner = self.runner.replace({self.name: float(value)})
        if last is None:
            return periodic_gait(runner, along=self.name)
        return gait_near(runner, last.apex, along=self.name)

    def _subinterval(self, begin: Fraction, end: Fraction, gait: Gait) -> Subinterval:
        """Prove a subinterval in one box."""
        tilt = np.linalg.solve(np.eye(6) - gait.jacobian, np.asarray(gait.by_parameter))
        square = float((end - begin) / 2) ** 2
        box: Sequence[float] = [bend * square + 1e-11 for bend in self.bend]
        tried = Subinterval(begin, end, centre=rounded(gait.apex, 12), tilt=rounded(tilt, 6))
        for _ in range(TRIES):
            try:
                subinterval, inside = proved_subinterval(
                    self.parameters, replace(tried, box=[at_least(r) for r in box])
                )
            except NotIncludedError as problem:
                if problem.box is None or max(problem.box) > WIDEST_BOX * float(end - begin):
                    raise
                box = problem.box
                continue
            self.bend = [ROOM * size / square for size in inside.image]
            self.growth = min(GROWTH, FULL / max(inside.contraction, 1e-3))
            return subinterval
        raise UndecidedError("the inclusion of the fixed point in the box")


def rounded(values: Sequence[float] | NDArray[np.float64], decimals: int) -> list[float]:
    """Short decimals near numbers that only have to be near something."""
    return [round(float(value), decimals) for value in values]


def at_least(size: float) -> float:
    """A short decimal that is not below a size, and a hundredth above it at the most."""
    return float(f"{1.0055 * size:.3g}")


def proved_subinterval(parameters: Parameters, subinterval: Subinterval) -> tuple[Subinterval, Inclusion]:
    """Subinterval in its box, as far as it is proved."""
    with ctx.workprec(BITS):
        value = subinterval.middle()
        radius = max(abs(ball_of(end) - value).upper() for end in (subinterval.begin, subinterval.end))
        centre = [*(arb(x) for x in subinterval.centre), value]
        starts = Starts(
            centre, [*(arb(r) for r in subinterval.box), radius], [arb(t) for t in subinterval.tilt]
        )
    inside = Inclusion(parameters, starts, BITS)
    with ctx.workprec(BITS):
        entries = inside.stride.derivative
        square = arb_mat(6, 6, [entries[i, j] for i in range(6) for j in range(6)])
        stable = stability(square)
    enclosure = [at_least(size) for size in inside.image]
    return replace(subinterval, word=inside.stride.word, stable=stable, enclosure=enclosure), inside


def short_decimal(width: Fraction, digits: int = 2) -> Fraction:
    """A decimal near a width and not above, so that the ends of subintervals stay short."""
    decimals = digits - 1 - math.floor(math.log10(width))
    return Fraction(math.floor(width * 10**decimals), 10**decimals)


PARTS = 256
"""Number of parts of a wide range. They are proved side by side; each is written to a file as it is done."""
NARROWEST_PART = Fraction(1, 500)
"""Smallest width of a part, over the greater end of the range."""


PRECISION_IN_USE = threading.Lock()
"""Held by the thread that proves: FLINT has one working precision for all threads of a process."""


def prove_part(
    runner: Runner, values: Mapping[str, Exact], name: str, ends: tuple[Fraction, Fraction]
) -> list[Subinterval]:
    """All subintervals of a part of a range: a block of work."""
    with PRECISION_IN_USE:
        return list(RangeProver(runner, values, name).subintervals(*ends))


def parts_of(begin: Fraction, end: Fraction) -> int:
    """Number of parts that a range is cut into."""
    minimum = NARROWEST_PART * max(abs(begin), abs(end))
    return max(1, min(PARTS, math.floor((end - begin) / minimum)))


def cut(begin: Fraction, end: Fraction, number: int) -> list[tuple[Fraction, Fraction]]:
    """A range in so many parts of one width."""
    ends = [begin + (end - begin) * k / number for k in range(number + 1)]
    return list(itertools.pairwise(ends))


def prove_range(
    gait: Gait,
    values: Mapping[str, Exact],
    name: str,
    ends: tuple[Fraction, Fraction],
    *,
    output: Path | None = None,
    executor: Executor | None = None,
    progress: bool = False,
) -> RangeProof:
    """Gaits over a range of a parameter, by subdivision."""
    parts = cut(*ends, parts_of(*ends))
    head = {
        **origin_of(),
        "vary": name,
        "range": [str(end) for end in ends],
        "parameters": texts_of(values, name),
    }
    done = _done(output, head)
    open_ones = [part for part in parts if part not in done]
    work = partial(prove_part, gait.runner, values, name)
    executor = InTurn() if executor is None else executor
    done_before = len(parts) - len(open_ones)
    with in_blocks(work, open_ones, "prove", "parts", executor, progress, done=done_before) as found:
        for number, subintervals in found:
            done[open_ones[number]] = subintervals
            _write(output, head, open_ones[number], subintervals)
    in_order = [subinterval for part in parts for subinterval in done[part]]
    return RangeProof(all(of.proved for of in in_order), values, name, *ends, in_order)


def _done(output: Path | None, head: Mapping[str, Any]) -> dict[tuple[Fraction, Fraction], list[Subinterval]]:
    """Parts that a file already has; a truncated last line does not count."""
    if output is None or not output.exists():
        return {}
    lines = output.read_text(encoding="utf-8-sig").splitlines()
    rows = [row for line in lines if (row := _row(line)) is not None]
    if not rows or not _is_of(head, rows[0]):
        raise InputError(
            f"{output}: is not of this range and runner; allowed: a new file, or one of the same"
        )
    return {
        (Fraction(row["part"][0]), Fraction(row["part"][1])): [
            Subinterval.of_row(subinterval) for subinterval in row["pieces"]
        ]
        for row in rows[1:]
    }


def _is_of(head: Mapping[str, Any], read: Any) -> bool:
    """True if a file holds this range and this runner, proved by any version."""
    return isinstance(read, dict) and {**read, "version": head["version"]} == head


def _row(line: str) -> Any:
    try:
        return json.loads(line)
    except ValueError:
        return None


def _write(
    output: Path | None,
    head: Mapping[str, Any],
    part: tuple[Fraction, Fraction],
    subintervals: list[Subinterval],
) -> None:
    if output is None:
        return
    size = output.stat().st_size if output.exists() else 0
    lines: list[object] = [] if size else [head]
    lines.append(
        {
            "version": head["version"],
            "part": [str(end) for end in part],
            "pieces": [subinterval.as_row() for subinterval in subintervals],
        }
    )
    try:
        with output.open("a", encoding="utf-8") as file:
            file.write("".join(f"{json.dumps(line)}\n" for line in lines))
    except OSError as problem:  # as on a full disk
        os.truncate(output, size)
        if not size:
            output.unlink()
        raise not_written(output, problem) from problem
