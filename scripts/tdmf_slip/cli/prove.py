"""The command `prove`: a gait, proved by interval arithmetic."""

import sys
from typing import TYPE_CHECKING

import click

from ..errors import RunError
from ..terminal.text import columns
from ..unit.parameters import read_parameters
from ..unit.unit import FRICTION, load
from .options import JSON_OPTION, PARAMETERS_OPTION, SET_OPTION, Command, values_given
from .output import json_text
from .runner import runner_of

if TYPE_CHECKING:
    from ..proof.proof import Proof

SHOWN = ("period", "length", "speed", "cost_of_transport", "slip_distance", "liftoff_angle")


@click.command("prove", cls=Command)
@click.option("--friction", metavar="MU", help=f"Friction of the ground; short for {FRICTION}.")
@SET_OPTION
@PARAMETERS_OPTION
@click.option(
    "--box",
    metavar="RADIUS",
    help="Within how much of the apex exactly one gait is to lie, in units of the coordinates' scales, as in "
    "1e-10.  [default: as much as is proved of some that are tried]",
)
@click.option(
    "--digits", type=int, default=20, show_default=True, metavar="N", help="That enclosures are to have."
)
@JSON_OPTION
def prove_command(
    friction: str | None,
    settings: tuple[str, ...],
    parameters: str | None,
    box: str | None,
    digits: int,
    as_json_object: bool,
) -> None:
    """A periodic gait, proved: there is exactly one in a box, with its word, stability and enclosures.

    All numbers are exact: 0.6 is 3/5, '40 deg' is 2 pi/9, and so are those of a file. Where the enclosures do
    not decide, the answer is "undecided", with the guard and the time, and the status is 1; it says nothing
    against the gait. Needs python-flint, the extra `proof`.
    """
    from ..proof.prove import prove  # FLINT is slow to load

    given = values_given(None, settings if friction is None else (f"{FRICTION}={friction}", *settings))
    if friction is not None:
        given[FRICTION] = "--friction", friction
    runner_of(load(), parameters, given)
    told = {} if parameters is None else {n: _as_written(v) for n, v in read_parameters(parameters).items()}
    proof = prove({**told, **{name: value for name, (_, value) in given.items()}}, box=box, digits=digits)
    print(json_text(proof.as_json()) if as_json_object else _text(proof))
    if not proof.proved:
        sys.stdout.flush()
        raise RunError("undecided")


def _as_written(value: object) -> object:
    """A number of a file as the decimal that it reads as."""
    return repr(value) if isinstance(value, float) else value


def _text(proof: "Proof") -> str:
    if not proof.proved:
        return proof.sentence
    told = proof.as_json()
    apex = zip(proof.coordinates, told["apex"], strict=True)  # type: ignore[call-overload] # texts
    rows = {
        "word": proof.word or "empty",
        "stable": {True: "yes", False: "no", None: "undecided"}[proof.stable],
        **{name: str(told[name]) for name in SHOWN if told[name] is not None},
        **{f"apex.{name}": value for name, value in apex},
        "eigenvalues": ", ".join(_complex(value) for value in told["eigenvalues"]),  # type: ignore[attr-defined]
    }
    assumed = "\n".join(f"- {sentence}" for sentence in proof.assumptions)
    return f"{proof.sentence}\n\n{columns(rows)}\n\nAssumed:\n{assumed}"


def _complex(value: str | list[str]) -> str:
    return value if isinstance(value, str) else f"{value[0]} + {value[1]} i"
