"""Options that several commands have, and how their texts are read."""

import importlib
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any, TypeVar

import click

from ..checks import checked, checked_whole, shown
from ..errors import InputError
from ..files.whole import check_destination
from ..library.quantities import QUANTITIES, quantity_given
from ..variables.table import full_name

Function = TypeVar("Function", bound=Callable[..., Any])


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


class NewFile(click.ParamType[Path]):
    """A file that can be written, of one of some formats."""

    name = "file"

    def __init__(self, formats: Iterable[str]) -> None:
        """Take the suffixes of the formats, as `.nc`."""
        self.formats = tuple(formats)

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Path:
        """The path of the file."""
        return check_destination(Path(value), self.formats, param.opts[0] if param is not None else self.name)


class NewPicture(click.ParamType[Path]):
    """A picture that can be drawn and written."""

    name = "file"

    def __init__(self, module: str = "style") -> None:
        """Allow the formats of a module of `pictures`."""
        self.module = module

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Path:
        """The path of the picture."""
        from ..pictures import style  # matplotlib is slow to load

        formats = importlib.import_module(f"..pictures.{self.module}", __package__).FORMATS
        return style.check_picture(Path(value), param.opts[0] if param is not None else self.name, formats)


NUMERIC = (click.types.FloatParamType, click.types.IntParamType, Number)
"""Types of options that are numbers."""
JSON_OPTION = click.option(
    "--json", "as_json_object", is_flag=True, help="Print one JSON object and nothing else."
)


def plot_option(drawn: str) -> Callable[[Function], Function]:
    """The option --plot; `drawn` completes its help."""
    text = f"Draw {drawn}: .png, .svg or .pdf."
    return click.option("--plot", type=NewPicture(), metavar="FILE", help=text)


TARGET_OPTION = click.option(
    "--target",
    "targets",
    multiple=True,
    metavar="QUANTITY=VALUE",
    help=f"Target value of a quantity, as in speed=1. Repeatable. Quantities: {', '.join(QUANTITIES)}.",
)


def pairs_given(texts: Sequence[str], option: str, allowed: str) -> dict[str, str]:
    """Texts of an option NAME=TEXT, by name."""
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
    """Values of --target, by quantity."""
    given = pairs_given(targets, "--target", "QUANTITY=VALUE, as in speed=1 or speed='3.6 km/h'")
    return {name: quantity_given(name, value, "--target") for name, value in given.items()}


def names_given(names: str | None) -> list[str]:
    """Names of an option that takes them with commas between them."""
    return [] if names is None else [full_name(name.strip()) for name in names.split(",")]
