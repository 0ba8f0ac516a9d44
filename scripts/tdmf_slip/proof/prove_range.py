"""Proofs of gaits over a whole range of a parameter, by subdivision, side by side and on file."""

import itertools
import json
import math
import threading
from collections.abc import Mapping
from concurrent.futures import Executor
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from ..blocks import InTurn, run_blocks
from ..errors import InputError
from ..library.gait import Gait
from ..library.runner import Runner
from ..record import origin_of
from ..terminal.progress import progress_bar
from .exact import Exact
from .proof import texts_of
from .range_proof import RangeProof, Subinterval
from .range_prover import RangeProver

PARTS = 256
"""Into which a wide range is cut, to be proved side by side; each is written to a file as it is done."""
NARROWEST_PART = Fraction(1, 500)
"""Smallest width of a part, over the greater end of the range."""


PRECISION_IN_USE = threading.Lock()
"""Held by the thread that proves: FLINT has one working precision for all threads of a process."""


@dataclass(frozen=True, eq=False)
class Part:
    """A part of a range: a block of work."""

    runner: Runner
    """The runner with a gait to start from."""
    values: Mapping[str, Exact]
    """Exact parameters."""
    name: str
    """Parameter that is varied."""
    ends: tuple[Fraction, Fraction]
    """Range of the parameter."""


def prove_part(part: Part) -> list[Subinterval]:
    """All subintervals of a part."""
    with PRECISION_IN_USE:
        return list(RangeProver(part.runner, part.values, part.name).subintervals(*part.ends))


def parts_of(begin: Fraction, end: Fraction) -> int:
    """Into how many parts a range is cut."""
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
    blocks = [Part(gait.runner, values, name, part) for part in open_ones]
    with (
        progress_bar("prove", len(parts), "parts", progress) as bar,
        run_blocks(prove_part, blocks, InTurn() if executor is None else executor) as found,
    ):
        bar.update(len(parts) - len(open_ones))
        for number, subintervals in found:
            done[open_ones[number]] = subintervals
            _write(output, head, open_ones[number], subintervals)
            bar.update()
    return RangeProof(name, *ends, values, [subinterval for part in parts for subinterval in done[part]])


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
    """Whether a file holds this range and this runner, proved by any version."""
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
    lines: list[object] = [] if output.exists() else [head]
    lines.append(
        {
            "version": head["version"],
            "part": [str(end) for end in part],
            "pieces": [subinterval.as_row() for subinterval in subintervals],
        }
    )
    with output.open("a", encoding="utf-8") as file:
        file.write("".join(f"{json.dumps(line)}\n" for line in lines))
