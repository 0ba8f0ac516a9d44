"""Types of options, and functions that read texts of options."""

import importlib
import os
import shutil
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import click
import numpy as np
from numpy.typing import NDArray

from ..checks import checked, checked_whole
from ..errors import InputError, reason
from ..files.whole import check_destination
from ..library.members import check_varied
from ..library.quantities import QUANTITIES, quantity_given
from ..variables import units
from ..variables.parameters import loads_json, parsed
from ..variables.table import VARIABLES, full_name
from ..variables.variable import MAX_VALUES, Variable

SPACINGS: Mapping[str, Callable[[float, float, int], NDArray[np.float64]]] = {
    "linear": np.linspace,
    "log": np.geomspace,
}
BYTE_ORDER_MARK = "\ufeff"
"""Byte-order mark with which Windows editors and shells begin a text."""
GAIT = "the output of `tdmf-slip gait --json`"


def program() -> str:
    """The command as it can be typed: its name if the shell finds it, else the path of this call."""
    name, called = "tdmf-slip", sys.argv[0]
    found = shutil.which(name)
    by_path = os.path.basename(called) == name and os.path.isfile(called)
    return called if by_path and not (found and os.path.samefile(found, called)) else name


def ends_of(text: str, variable: Variable, where: str) -> tuple[float, float]:
    """Both ends of a range A:B of a variable, in its unit."""
    first, last, _ = range_of(text, variable, where, "A:B")
    if first == last:
        raise InputError(f"{where} {text}: both ends are equal; allowed: two different ends")
    return first, last


def values_of(text: str, spacing: str, variable: Variable, where: str) -> NDArray[np.float64]:
    """The values of a variable that A:B:N stands for, in its unit."""
    first, last, count = range_of(text, variable, where, "A:B:N")
    if count == 1 and first != last:
        raise InputError(f"{where} {text}: one value cannot be both A and B; allowed: N of 2 or more")
    if spacing == "log" and min(first, last) <= 0.0:
        raise InputError(f"{where} {text}: logarithmic spacing needs A and B above 0")
    return SPACINGS[spacing](first, last, count or 0)


def range_of(text: str, variable: Variable, where: str, *forms: str) -> tuple[float, float, int | None]:
    """Both ends of a range of a variable, in its unit, and N; None if the text has no N."""
    first, *further = parts = text.split(":")
    if len(parts) not in {len(form.split(":")) for form in forms}:
        degrees = "deg" in variable.display_units
        example = ("'35 deg:45 deg'" if degrees else "0.1:1") + (":5" if forms == ("A:B:N",) else "")
        raise InputError(f"{where} {text} is not a range; allowed: {' or '.join(forms)}, as in {example}")
    ends = first, further[0]
    if bool(units.split(ends[0])[1]) != bool(units.split(ends[1])[1]):
        raise InputError(f"{where} {text}: a unit at one end only; allowed: at both or at none")
    low, high = (variable.value_of(end, f"{where} {text}") for end in ends)
    if len(parts) == 2:
        return low, high, None
    count = parts[2].strip()
    if not count.isdecimal() or not 1 <= float(count) <= MAX_VALUES:
        raise InputError(f"{where} {text}: N = {count}; allowed: a whole number from 1 to {MAX_VALUES}")
    return low, high, int(count)


def span_of(name: str, span: str) -> tuple[float, float]:
    """The range A:B of a parameter or input in --vary."""
    check_varied(name, "--vary")
    return ends_of(span, VARIABLES[name], f"--vary {name} =")


def read_gait(name: str) -> dict[str, Any]:
    """Start values of a run on a gait, from the output of `tdmf-slip gait --json`."""
    where = "standard input" if name == "-" else name
    try:
        if name == "-" and sys.stdin is None:
            raise ValueError("is closed")
        text = sys.stdin.read() if name == "-" else Path(name).read_text(encoding="utf-8")
        content = parsed(text.removeprefix(BYTE_ORDER_MARK), loads_json, GAIT)
    except (OSError, ValueError) as problem:
        raise InputError(f"gait of {where}: {reason(problem)}") from None
    starts = content.get("start_values")
    if not isinstance(starts, Mapping):
        raise InputError(f"gait of {where}: has no start_values; allowed: {GAIT}")
    return dict(starts)


class Number(click.ParamType[float]):
    """A number within a range; the message names the option."""

    name = "number"

    def __init__(self, low: float, high: float, *, whole: bool = False) -> None:
        """Allow numbers from `low` to `high`, or only whole ones."""
        self.low, self.high, self.whole = low, high, whole

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float | int:
        """The number that a text stands for."""
        name = param.opts[0] if param is not None else self.name
        if self.whole:
            return checked_whole(name, click.INT.convert(value, param, ctx), int(self.low), int(self.high))
        return checked(name, click.FLOAT.convert(value, param, ctx), self.low, self.high)


NUMERIC = (click.types.FloatParamType, click.types.IntParamType, Number)
"""Types of options that are numbers."""


class NewFile(click.ParamType[Path]):
    """A file that can be written, of one of some formats."""

    name = "file"

    def __init__(self, *formats: str) -> None:
        """Take the suffixes of the formats, as `.nc`."""
        self.formats: Iterable[str] = formats

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Path:
        """The path of the file."""
        return check_destination(Path(value), self.formats, param.opts[0] if param is not None else self.name)


class NewPicture(NewFile):
    """A picture that can be drawn and written."""

    def __init__(self, module: str = "style") -> None:
        """Allow the formats of a module of `pictures`."""
        self.module = module

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Path:
        """The path of the picture."""
        from ..pictures import style  # matplotlib is slow to load

        self.formats = importlib.import_module(f"..pictures.{self.module}", __package__).FORMATS
        path = super().convert(value, param, ctx)
        style.check_drawing(f"{param.opts[0] if param is not None else self.name}: {path}")
        return path


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
            raise InputError(f"{option} {text} is not allowed; allowed: {allowed}")
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
