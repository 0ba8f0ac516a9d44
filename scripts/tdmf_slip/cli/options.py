"""What several commands share: options, and how start values are read from them."""

from collections.abc import Mapping, Sequence
from typing import Any

import click

from ..checks import checked, checked_whole, shown
from ..errors import InputError
from ..library.quantities import QUANTITIES, quantity_given
from ..variables.parameters import preset_names, read_parameters
from ..variables.table import FRICTION, MODELS, VARIABLES, Variables, full_name
from ..variables.variable import Given, Value


def takes_one_value(option: click.Option) -> bool:
    """Whether an option has one value, unlike a flag and what may be repeated."""
    return not option.multiple and not option.is_flag


class Command(click.Command):
    """A command that refuses what click would take in silence: an option given twice, and 1_0 for 10."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Read the command line."""
        try:
            values, _, given = self.make_parser(ctx).parse_args(args=list(args))
        except click.UsageError as problem:
            problem.ctx = problem.ctx or ctx  # click forgets in some whose help is to be read
            raise
        once = [option for option in given if isinstance(option, click.Option) and takes_one_value(option)]
        twice = next((option for option in once if once.count(option) > 1), None)
        if twice is not None:
            raise click.UsageError(f"{twice.opts[0]} is given twice; allowed: once", ctx)
        for option in given:
            value = values.get(option.name or "")
            texts = value if isinstance(value, list) else [value]
            is_numeric = isinstance(option.type, NUMERIC)
            wrong = next((text for text in map(str, texts) if is_numeric and "_" in text), None)
            if wrong is not None:
                raise click.UsageError(f"{option.opts[0]} {shown(wrong)}; allowed: a number without _", ctx)
        return super().parse_args(ctx, args)


class Number(click.ParamType[float]):
    """A number within a range; the message names the option."""

    name = "number"

    def __init__(self, low: float, high: float, *, whole: bool = False) -> None:
        """From `low` to `high`, on request a whole one."""
        self.low, self.high, self.whole = low, high, whole

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float | int:
        """The number that a text stands for."""
        name = param.opts[0] if param is not None else self.name
        if self.whole:
            return checked_whole(name, click.INT.convert(value, param, ctx), int(self.low), int(self.high))
        return checked(name, click.FLOAT.convert(value, param, ctx), self.low, self.high)


NUMERIC = (click.types.FloatParamType, click.types.IntParamType, Number)
"""Types of options that are numbers."""
FRICTION_OPTION = click.option(
    "--friction", type=float, metavar="MU", help=f"Friction coefficient of the ground; short for {FRICTION}."
)
JSON_OPTION = click.option(
    "--json", "as_json_object", is_flag=True, help="Print one JSON object and nothing else."
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
    show_default=True,
    help="full: all six coordinates of an apex. reduced: the leg follows its reference without delay in "
    "flight, so height and speed describe an apex.",
)
TARGET_OPTION = click.option(
    "--target",
    "targets",
    multiple=True,
    metavar="QUANTITY=VALUE",
    help=f"Target value of a quantity, as in speed=1. Repeatable. Quantities: {', '.join(QUANTITIES)}.",
)


def pairs_given(texts: Sequence[str], option: str, allowed: str) -> dict[str, str]:
    """What NAME=TEXT gives, by name."""
    given: dict[str, str] = {}
    for text in texts:
        name, _, value = (part.strip() for part in text.partition("="))
        if not name or not value:
            raise InputError(f"{option} {text}: allowed: {allowed}")
        name = full_name(name)
        if name in given:
            raise InputError(f"{option} {text}: {name} is given twice; allowed: once")
        given[name] = value
    return given


def targets_given(targets: tuple[str, ...]) -> dict[str, Any]:
    """Of --target, by quantity."""
    given = pairs_given(targets, "--target", "QUANTITY=VALUE, as in speed=1 or speed='3.6 km/h'")
    return {name: quantity_given(name, value, "--target") for name, value in given.items()}


def names_given(names: str | None) -> list[str]:
    """Of an option that takes names with commas between them."""
    return [] if names is None else [full_name(name.strip()) for name in names.split(",")]


def values_given(friction: float | None, settings: tuple[str, ...]) -> dict[str, tuple[str, Given]]:
    """By name of a variable: the option, --friction or --set, and the value that it gives."""
    given: dict[str, tuple[str, Given]] = {} if friction is None else {FRICTION: ("--friction", friction)}
    for setting in settings:
        name, _, value = (part.strip() for part in setting.partition("="))
        if not name or not value:
            raise InputError(f"--set {setting}: allowed: NAME=VALUE")
        name = full_name(name)
        if name in given:
            option = given[name][0]
            twice = f"{name} is given twice; allowed: once"
            both = f"{option} gives {name}, too; allowed: one of the two"
            raise InputError(f"--set {setting}: {twice if option == '--set' else both}")
        given[name] = "--set", value
    return given


def texts_of(given: Mapping[str, tuple[str, Given]]) -> dict[str, Given]:
    """What single options give, by name alone, see `values_given`."""
    return {name: value for name, (_, value) in given.items()}


def start_values(
    base: Mapping[str, Value], given: Mapping[str, tuple[str, Given]], variables: Variables = VARIABLES
) -> dict[str, Value]:
    """Start values: those of a file, and over them what single options give."""
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
    """Refuse a start value for what another option says already."""
    if name.strip() in given:
        option = given[name.strip()][0]
        shown = option if option == "--friction" else f"{option} {name.strip()}"
        raise InputError(f"{shown}: {by} says what {name.strip()} is; allowed: one of the two")
