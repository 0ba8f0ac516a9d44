"""The command `prove`: a gait, proved by interval arithmetic."""

import hashlib
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..errors import InputError, RunError
from ..library.runner import Runner
from ..terminal.text import columns, table
from ..variables.parameters import read_parameters
from ..variables.table import FRICTION, VARIABLES
from .command import Answer, command, option
from .options import ends_of, pairs_given
from .runner import RunnerOptions, refuse_given
from .workers import Workers

if TYPE_CHECKING:
    from ..proof.proof import Proof

EXCLUSIVE = (
    *(("--border", "--vary"), ("--border", "--box"), ("--border", "--compare")),
    *(("--vary", "--box"), ("--vary", "--compare")),
)
"""Pairs of options that exclude each other: the boxes of borders and ranges are chosen automatically."""
SHOWN = ("period", "length", "speed", "cost_of_transport", "slip_distance", "liftoff_angle")


@command(
    "prove",
    option("--box", metavar="RADIUS"),
    option("--digits", kind=int, default=20, metavar="N"),
    option("--border", metavar="A:B"),
    option("--vary", metavar="NAME=A:B"),
    option("--output", kind=click.Path(path_type=Path), metavar="FILE"),
    option("--compare", is_flag=True),
    model=False,
    workers=True,
)
def prove_command(
    options: RunnerOptions,
    workers: Workers,
    box: str | None,
    digits: int,
    border: str | None,
    vary: str | None,
    output: Path | None,
    compare: bool,
) -> Answer:
    """Prove that exactly one gait lies in a box, with its word, stability and enclosures.

    All numbers are exact: 0.6 is 3/5, '40 deg' is 2 pi/9, also in files. If the enclosures are too wide, the
    answer is "undecided", with the guard and the time, and the exit status is 1. The answer is never "no
    gait". Requires python-flint, the extra `proof`.

    Parameters
    ----------
    box
        Radius of the box of apices in which exactly one gait is proved, in units of the coordinates'
        scales, as in 1e-10.  [default: the largest of several that can be proved]
    digits
        Digits of the enclosures.
    border
        Prove the borders between gait words in a range of friction, and a gait on each side of each
        border.
    vary
        Prove all gaits over a range of a parameter, by subdivision, as in ground.friction=0.5999:0.6001.
    output
        With --vary: write JSON lines, one per subinterval. An existing file is resumed.
    compare
        Also bound how far the stride of each solver is from the proved gait.
    """
    exclusive = {"--border": border, "--vary": vary, "--box": box, "--compare": compare or None}
    for pair in EXCLUSIVE:
        if all(exclusive[name] is not None for name in pair):
            raise InputError(f"{' and '.join(pair)} are both given; allowed: one of them")
    if vary is None and (output is not None or workers.are_given):
        raise InputError("--output, --workers and --scheduler are for a range only; allowed: with --vary")
    if border is not None:
        refuse_given(options.given, FRICTION, "--border")
    ranges = {} if vary is None else pairs_given([vary], "--vary", "NAME=A:B")
    runner = options.runner(ranges)
    written = {} if options.parameters is None else read_parameters(options.parameters)
    values = {name: _as_written(value) for name, value in written.items()}
    values |= {name: value for name, (_, value) in options.given.items()}
    if border is not None:
        return _borders(runner, values, border, digits)
    from ..proof.prove import prove  # FLINT is slow to load

    if vary is None:
        proof = prove(values, box=box, digits=digits)
        plain, text = proof.as_json(), _text(proof)
        if compare and proof.proved:
            from ..proof.accuracy import error_table, solver_errors

            errors = solver_errors(proof)
            heading, *rows = error_table([errors])
            text += f"\n\nErrors of the solvers at the most:\n{table(heading, rows)}"
            plain = {**plain, "solvers": errors}
        return _answer(plain, text, proof.proved)
    ((name, span),) = ranges.items()
    begin, colon, end = (part.strip() for part in span.partition(":"))
    if not colon:
        raise InputError(f"--vary {vary}: allowed: NAME=A:B")
    with workers.executor(processes=True) as executor:
        over = prove(values, vary={name: (begin, end)}, output=output, executor=executor, progress=True)
    digest = None if output is None else hashlib.sha256(output.read_bytes()).hexdigest()
    text = over.sentence if digest is None else f"{over.sentence}\nSHA-256 of {output}: {digest}"
    return _answer({**over.as_json(), "sha256": digest}, text, over.proved)


def _answer(plain: dict[str, Any], text: str, proved: bool) -> Answer:
    """The answer; exit status 1 if something is undecided."""
    return Answer(plain, text, failure=None if proved else RunError("undecided"))


def _borders(runner: Runner, values: dict[str, object], border: str, digits: int) -> Answer:
    """Proofs of all borders in a range of friction."""
    from ..analysis.sweeps import sweep
    from ..proof.prove_border import prove_border

    ends = ends_of(border, VARIABLES[FRICTION], "--border")
    borders = sweep(runner, {FRICTION: list(ends)}).borders[FRICTION].values.tolist()
    if not borders:
        raise RunError(f"--border {border}: the gaits at both ends have the same word")
    proofs = [prove_border(one, values, digits=digits) for one in borders]
    text = "\n\n".join(proof.sentence for proof in proofs)
    plain = {"borders": [proof.as_json() for proof in proofs]}
    return _answer(plain, text, all(proof.proved for proof in proofs))


def _as_written(value: object) -> object:
    """A number of a file as the decimal that it reads as."""
    return repr(value) if isinstance(value, float) else value


def _text(proof: "Proof") -> str:
    if not proof.proved:
        return proof.sentence
    reported: dict[str, Any] = proof.as_json()
    rows = {
        "word": proof.word or "empty",
        "stable": {True: "yes", False: "no", None: "undecided"}[proof.stable],
        **{name: str(reported[name]) for name in SHOWN if reported[name] is not None},
        **{f"apex.{name}": of for name, of in zip(proof.coordinates, reported["apex"], strict=True)},
        "eigenvalues": ", ".join(
            value if isinstance(value, str) else f"{value[0]} + {value[1]} i"
            for value in reported["eigenvalues"]
        ),
    }
    assumed = "\n".join(f"- {sentence}" for sentence in proof.assumptions)
    return f"{proof.sentence}\n\n{columns(rows)}\n\nAssumed:\n{assumed}"
