"""The command `prove`: a gait, proved by interval arithmetic."""

import hashlib
import sys
from concurrent.futures import Executor
from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..errors import InputError, RunError
from ..library.runner import Runner
from ..terminal.text import columns, table
from ..variables.parameters import read_parameters
from ..variables.table import FRICTION, VARIABLES
from .options import JSON_OPTION, Command, ends_of, json_text
from .runner import PARAMETERS_OPTION, SET_OPTION, Asked, refuse_given, values_given
from .workers import executor_of, workers_options

if TYPE_CHECKING:
    from ..proof.proof import Proof

SHOWN = ("period", "length", "speed", "cost_of_transport", "slip_distance", "liftoff_angle")


@click.command("prove", cls=Command)
@click.option("--friction", metavar="MU", help=f"Friction coefficient of the ground; short for {FRICTION}.")
@SET_OPTION
@PARAMETERS_OPTION
@click.option(
    "--box",
    metavar="RADIUS",
    help="Radius of the box of apices in which exactly one gait is proved, in units of the coordinates' "
    "scales, as in 1e-10.  [default: the largest of several that can be proved]",
)
@click.option("--digits", type=int, default=20, metavar="N", help="Digits of the enclosures.")
@click.option(
    "--border",
    metavar="A:B",
    help="Prove the borders between gait words in a range of friction, and a gait on each side of each "
    "border.",
)
@click.option(
    "--vary",
    metavar="NAME=A:B",
    help="Prove all gaits over a range of a parameter, by subdivision, as in ground.friction=0.5999:0.6001.",
)
@click.option(
    "--output",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="With --vary: write JSON lines, one per subinterval. An existing file is resumed.",
)
@workers_options
@click.option(
    "--compare",
    is_flag=True,
    help="Also bound how far the stride of each solver is from the proved gait.",
)
@JSON_OPTION
def prove_command(
    friction: str | None,
    settings: tuple[str, ...],
    parameters: str | None,
    box: str | None,
    digits: int,
    border: str | None,
    vary: str | None,
    output: Path | None,
    workers: int | None,
    scheduler: str | None,
    compare: bool,
    as_json_object: bool,
) -> None:
    """Prove that exactly one gait lies in a box, with its word, stability and enclosures.

    All numbers are exact: 0.6 is 3/5, '40 deg' is 2 pi/9, also in files. If the enclosures are too wide, the
    answer is "undecided", with the guard and the time, and the exit status is 1. The answer is never "no
    gait". Requires python-flint, the extra `proof`.
    """
    given = values_given(None, settings)
    if friction is not None:
        given[FRICTION] = "--friction", friction
    if border is not None:
        refuse_given(given, FRICTION, "--border")
        if box is not None:
            raise InputError(f"--box {box}: a border's is chosen by itself; allowed: without --border")
        if vary is not None:
            raise InputError("--border, --vary: are two ways of asking; allowed: one of them")
    runner = Asked(parameters, given).runner()
    reported = (
        {} if parameters is None else {n: _as_written(v) for n, v in read_parameters(parameters).items()}
    )
    reported |= {name: value for name, (_, value) in given.items()}
    if compare and (border is not None or vary is not None):
        raise InputError("--compare: is of one gait; allowed: without --border and --vary")
    if vary is None and any(option is not None for option in (output, workers, scheduler)):
        raise InputError("--output, --workers and --scheduler are for a range only; allowed: with --vary")
    if border is not None:
        _prove_borders(runner, reported, border, digits, as_json_object)
        return
    if vary is not None:
        if box is not None:
            raise InputError(f"--box {box}: with --vary it is chosen by itself; allowed: without --vary")
        with executor_of(workers, scheduler, processes=True) as executor:
            _prove_range(reported, vary, output, executor, as_json_object)
        return
    from ..proof.prove import prove  # FLINT is slow to load

    proof = prove(reported, box=box, digits=digits)
    errors = _errors(proof) if compare and proof.proved else {}
    if as_json_object:
        print(json_text({**proof.as_json(), **({"solvers": errors} if errors else {})}))
    else:
        print(_text(proof) + (f"\n\n{_error_text(errors)}" if errors else ""))
    _end(proof.proved)


def _errors(proof: "Proof") -> dict[str, dict[str, float]]:
    from ..proof.accuracy import solver_errors

    return solver_errors(proof)


def _error_text(errors: dict[str, dict[str, float]]) -> str:
    names = next(iter(errors.values()))
    rows = [[solver, *(f"{of[name]:.1e}" for name in names)] for solver, of in errors.items()]
    return f"Errors of the solvers at the most:\n{table(['solver', *names], rows)}"


def _prove_borders(
    runner: Runner, reported: dict[str, object], border: str, digits: int, as_json_object: bool
) -> None:
    from ..analysis.sweeps import sweep_row
    from ..proof.prove_border import prove_border

    ends = ends_of(border, VARIABLES[FRICTION], "--border")
    borders = sweep_row(runner, FRICTION, list(ends)).borders
    if not borders:
        raise RunError(f"--border {border}: the gaits at both ends have the same word")
    proofs = [prove_border(one, reported, digits=digits) for one in borders]
    if as_json_object:
        print(json_text({"borders": [proof.as_json() for proof in proofs]}))
    else:
        print("\n\n".join(proof.sentence for proof in proofs))
    _end(all(proof.proved for proof in proofs))


def _prove_range(
    reported: dict[str, object],
    vary: str,
    output: Path | None,
    executor: Executor | None,
    as_json_object: bool,
) -> None:
    from ..proof.prove import prove

    name, equals, span = (part.strip() for part in vary.partition("="))
    begin, colon, end = (part.strip() for part in span.partition(":"))
    if not (equals and colon):
        raise InputError(f"--vary {vary}: allowed: NAME=A:B")
    proof = prove(reported, vary={name: (begin, end)}, output=output, executor=executor, progress=True)
    digest = None if output is None else hashlib.sha256(output.read_bytes()).hexdigest()
    if as_json_object:
        print(json_text({**proof.as_json(), "sha256": digest}))
    else:
        print(proof.sentence if digest is None else f"{proof.sentence}\nSHA-256 of {output}: {digest}")
    _end(proof.proved)


def _end(proved: bool) -> None:
    if not proved:
        sys.stdout.flush()
        raise RunError("undecided")


def _as_written(value: object) -> object:
    """A number of a file as the decimal that it reads as."""
    return repr(value) if isinstance(value, float) else value


def _text(proof: "Proof") -> str:
    if not proof.proved:
        return proof.sentence
    reported = proof.as_json()
    apex = zip(proof.coordinates, reported["apex"], strict=True)  # type: ignore[call-overload] # texts
    rows = {
        "word": proof.word or "empty",
        "stable": {True: "yes", False: "no", None: "undecided"}[proof.stable],
        **{name: str(reported[name]) for name in SHOWN if reported[name] is not None},
        **{f"apex.{name}": value for name, value in apex},
        "eigenvalues": ", ".join(_complex(value) for value in reported["eigenvalues"]),  # type: ignore[attr-defined]
    }
    assumed = "\n".join(f"- {sentence}" for sentence in proof.assumptions)
    return f"{proof.sentence}\n\n{columns(rows)}\n\nAssumed:\n{assumed}"


def _complex(value: str | list[str]) -> str:
    return value if isinstance(value, str) else f"{value[0]} + {value[1]} i"
