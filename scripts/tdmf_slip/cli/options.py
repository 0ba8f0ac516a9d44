"""Options that several commands have, and how their texts are read."""

import importlib
import json
import math
import os
import shutil
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, TypeVar

import click
import numpy as np
from numpy.typing import NDArray

from ..checks import checked, checked_whole, number_in, shown
from ..errors import InputError, reason
from ..files.whole import check_destination
from ..library.quantities import QUANTITIES, quantity_given
from ..variables import units
from ..variables.parameters import loads_json, parsed
from ..variables.table import full_name
from ..variables.variable import MAX_VALUES, Variable


def json_text(value: object) -> str:
    """One line of JSON, in which a number that is not finite is null."""
    return json.dumps(_finite(value), allow_nan=False)


def program() -> str:
    """The command as it can be typed: its name if the shell finds it, else the path of this call."""
    name, called = "tdmf-slip", sys.argv[0]
    found = shutil.which(name)
    by_path = os.path.basename(called) == name and os.path.isfile(called)
    return called if by_path and not (found and os.path.samefile(found, called)) else name


def _finite(value: object) -> object:
    if isinstance(value, dict):
        return {key: _finite(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


SPACINGS: Mapping[str, Callable[[float, float, int], NDArray[np.float64]]] = {
    "linear": np.linspace,
    "log": np.geomspace,
}


def ends_of(text: str, variable: Variable, where: str) -> tuple[float, float]:
    """Both ends of a range A:B of a variable, in its unit."""
    parts = text.split(":")
    if len(parts) != 2:
        raise InputError(f"{where} {text}: allowed: A:B, as in {_example(variable)}")
    first, last = _ends(parts, variable, f"{where} {text}")
    if first == last:
        raise InputError(f"{where} {text}: allowed: two ends that differ")
    return first, last


def values_of(text: str, spacing: str, variable: Variable, where: str) -> NDArray[np.float64]:
    """The values of a variable that A:B:N stands for, in its unit."""
    parts = text.split(":")
    if len(parts) != 3:
        raise InputError(
            f"{where} {text}: allowed: A:B:N, two ends and how many values, as in {_example(variable)}:5"
        )
    try:
        count = number_in(parts[2])
        number = int(count) if count.is_integer() else 0
    except ValueError:
        number = 0
    if not 1 <= number <= MAX_VALUES:
        raise InputError(f"{where} {text}: N = {parts[2]}; allowed: a whole number from 1 to {MAX_VALUES}")
    ends = _ends(parts[:2], variable, f"{where} {text}")
    if number == 1 and ends[0] != ends[1]:
        raise InputError(
            f"{where} {text}: one value cannot be A and B; allowed: N from 2 on, or B equal to A"
        )
    if spacing == "log" and min(ends) <= 0.0:
        raise InputError(f"{where} {text}: allowed with logarithmic spacing: A and B above 0")
    first, last = ends
    return SPACINGS[spacing](first, last, number)


def _ends(parts: list[str], variable: Variable, where: str) -> list[float]:
    with_unit = [bool(units.split(part)[1]) for part in parts]
    if with_unit[0] != with_unit[1]:
        raise InputError(f"{where}: a unit at one end only; allowed: at both or at none")
    return [variable.value_of(part, where) for part in parts]


def _example(variable: Variable) -> str:
    return "'35 deg:45 deg'" if "deg" in variable.display_units else "0.1:1"


BYTE_ORDER_MARK = "\ufeff"
"""Byte-order mark with which Windows editors and shells begin a text."""
GAIT = "what `tdmf-slip gait --json` prints"


def read_gait(name: str) -> dict[str, Any]:
    """Start values of a run on a gait, from what `tdmf-slip gait --json` prints."""
    where = "standard input" if name == "-" else name
    try:
        if name == "-" and sys.stdin is None:
            raise ValueError("is closed")
        text = sys.stdin.read() if name == "-" else Path(name).read_text(encoding="utf-8")
        text = text.removeprefix(BYTE_ORDER_MARK)
        content = parsed(text, loads_json, GAIT)
    except (OSError, ValueError) as problem:
        raise InputError(f"gait of {where}: {reason(problem)}") from None
    starts = content.get("start_values")
    if not isinstance(starts, Mapping):
        raise InputError(f"gait of {where}: has no start_values; allowed: {GAIT}")
    return dict(starts)


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
