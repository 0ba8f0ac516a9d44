"""Options that describe a runner, and the runner that they describe."""

import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import click

from ..errors import InputError, Note
from ..library.runner import Runner
from ..library.settings import OF_FLIGHT
from ..variables.parameters import preset_names, read_parameters
from ..variables.table import FRICTION, MODELS, NAMES, VARIABLES, Variables
from ..variables.variable import Given, Value
from .options import pairs_given

FRICTION_OPTION = click.option(
    "--friction", metavar="MU", help=f"Friction coefficient of the ground; short for {FRICTION}."
)
SET_OPTION = click.option(
    "--set",
    "settings",
    multiple=True,
    metavar="NAME=VALUE",
    help="Start value of a variable, as in stiffness=20000 or "
    "touchdown_angle='40 deg'; `tdmf-slip variables` lists the names. Repeatable.",
)
PARAMETERS_OPTION = click.option(
    "--parameters",
    metavar="FILE",
    help=f"Start values from a TOML or JSON file, or from a preset: {', '.join(preset_names())}.",
)
MODEL_OPTION = click.option(
    "--model",
    type=click.Choice(list(MODELS)),
    default="full",
    help="full: all six coordinates of an apex. reduced: the leg follows its reference without delay in "
    "flight, so height and speed describe an apex.",
)


@dataclass(frozen=True)
class RunnerOptions:
    """Options that describe a runner."""

    parameters: str | None
    """File or preset of --parameters."""
    given: Mapping[str, tuple[str, Given]]
    """Start values that options give, see `values_given`."""
    model: str | None = None
    """Model of gaits; None is the full one."""

    def runner(self, varied: Iterable[str] = ()) -> Runner:
        """The runner; refuses a start value of a variable that --vary varies."""
        for name in varied:
            refuse_given(self.given, name, "--vary")
        starts = start_values(file_values(self.parameters), self.given)
        for name, (option, _) in self.given.items():
            if name not in NAMES:
                raise InputError(
                    f"{option} {name}: has an effect only in runs of the FMI unit; "
                    f"allowed: parameters, inputs and states of the model"
                )
        runner = Runner(starts, model=self.model)
        for name, (option, _) in self.given.items():
            if runner.reduced and name in OF_FLIGHT:
                warnings.warn(f"{option} {name}: has no effect in the reduced map", Note, stacklevel=2)
        return runner

    def at_friction(self, friction: str) -> "RunnerOptions":
        """The options with a friction, which may not be given already."""
        refuse_given(self.given, FRICTION, "--friction")
        return replace(self, given={**self.given, FRICTION: ("--friction", friction)})


def runner_options(friction: bool, model: bool) -> list[Callable[[Any], Any]]:
    """Options that describe a runner: --set, --parameters and, on request, --friction and --model."""
    first, last = [FRICTION_OPTION] if friction else [], [MODEL_OPTION] if model else []
    return [*first, SET_OPTION, PARAMETERS_OPTION, *last]


def values_given(friction: Given | None, settings: Sequence[str]) -> dict[str, tuple[str, Given]]:
    """Option, --friction or --set, and its value, for each variable that is given."""
    given: dict[str, tuple[str, Given]] = {} if friction is None else {FRICTION: ("--friction", friction)}
    for name, value in pairs_given(settings, "--set", "NAME=VALUE").items():
        if name in given:
            raise InputError(f"--set {name}={value} and --friction both give {name}; allowed: one of the two")
        given[name] = "--set", value
    return given


def start_values(
    base: Mapping[str, Value], given: Mapping[str, tuple[str, Given]], variables: Variables = VARIABLES
) -> dict[str, Value]:
    """Start values of a file; single options replace them."""
    values = dict(base)
    for name, (option, value) in given.items():
        values |= variables.start_values({name: value}, option)
    return values


def file_values(parameters: str | None, variables: Variables = VARIABLES) -> dict[str, Value]:
    """Start values of --parameters."""
    if parameters is None:
        return {}
    return variables.start_values(read_parameters(parameters), f"--parameters {parameters}")


def refuse_given(given: Mapping[str, tuple[str, Given]], name: str, by: str) -> None:
    """Refuse a start value of a variable that another option gives."""
    if name in given:
        option = given[name][0]
        shown = option if option == "--friction" else f"{option} {name}"
        raise InputError(f"{shown} and {by} both give {name}; allowed: one of the two")
