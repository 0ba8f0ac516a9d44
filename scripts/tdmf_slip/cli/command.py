"""Parts that all commands share: options from signatures and docstrings, and the output of an answer."""

import functools
import inspect
import json
import math
import re
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeAlias

import click

from ..checks import shown
from .options import NUMERIC, NewPicture
from .runner import RunnerOptions, runner_options, values_given
from .workers import WORKERS_OPTIONS, Workers

Option: TypeAlias = Callable[[Any], Any]
"""Result of `click.option`, which adds the option to a command."""
PARAMETERS = "\n\nParameters\n-----"
"""Heading of the description of parameters in a docstring."""
JSON_OPTION = click.option("--json", "as_json", is_flag=True, help="Print one JSON object and nothing else.")


@dataclass(frozen=True)
class Answer:
    """Result of a command, as JSON, as text and as a picture."""

    plain: Mapping[str, Any] | Callable[[], Mapping[str, Any]]
    """Object that --json prints, or a function that makes it if that takes time."""
    text: str
    """Text that is printed without --json."""
    drawn: Callable[[], Any] | None = None
    """Gives the result that --plot draws."""
    look: Mapping[str, Any] = field(default_factory=dict)
    """Options of the picture."""
    then: Callable[[], str] | None = None
    """Work after the answer is printed; its text is printed too, without --json."""
    failure: BaseException | None = None
    """Raised once everything is printed and drawn."""

    def show(self, as_json: bool, picture: Path | None) -> None:
        """Print the answer, draw it, and raise its failure if it has one."""
        if as_json or self.text:
            plain = self.plain() if as_json and callable(self.plain) else self.plain
            print(json_text(plain) if as_json else self.text)
        if picture is not None and self.drawn is not None:
            from ..pictures.plot import write_picture  # matplotlib is slow to load

            write_picture(picture, self.drawn(), **self.look)
        further = self.then() if self.then is not None else ""
        if further and not as_json:
            print(further)
        if self.failure is not None:
            sys.stdout.flush()  # the answer is printed before the message
            raise self.failure


def json_text(value: object) -> str:
    """One line of JSON, in which a number that is not finite is null."""
    return json.dumps(_finite(value), allow_nan=False)


def _finite(value: object) -> object:
    if isinstance(value, dict):
        return {key: _finite(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def option(
    flag: str, *name: str, of: Callable[..., Any] | None = None, kind: Any = None, **look: Any
) -> Option:
    """An option whose help is the description of a parameter, in the command's docstring or in that of `of`.

    The parameter has the name that is given, or else the option's own. A Python function `of`, which has this
    parameter too, also says what the default is.
    """
    parameter = name[0] if name else flag.partition("/")[0].removeprefix("--").replace("-", "_")
    if of is not None:
        default = inspect.signature(of).parameters[parameter].default
        if default is not inspect.Parameter.empty:
            look = ({"is_flag": True} if default is False else {"default": default}) | look

    def decorate(function: Any) -> Any:
        text = described(function, parameter) or described(of, parameter)
        return click.option(flag, *name, type=kind, **({"help": text} | look))(function)

    return decorate


def described(function: Callable[..., Any] | None, parameter: str) -> str:
    """Description of a parameter in the docstring of a function; empty where there is none."""
    pattern = rf"^(?:\w+, )*{parameter}(?:, \w+)*(?: :.*)?\n((?: {{4}}.*\n)+)"
    found = re.search(pattern, f"{inspect.getdoc(function)}\n", re.MULTILINE)
    return " ".join(found[1].split()) if found else ""


def command(
    name: str,
    *options: Option,
    runner: bool = True,
    friction: bool = True,
    model: bool = True,
    workers: bool = False,
    plot: str = "",
    as_json: bool = True,
) -> Callable[[Callable[..., Answer]], click.Command]:
    """Make a command of a function that returns an `Answer`; the function's docstring is its help.

    With `runner` the function is passed `options`, a `RunnerOptions`, with `workers` also `workers`, a
    `Workers`. Without `friction` or `model`, `options` has none: the command has an option of its own for it.
    `plot` says in the help of --plot what is drawn.
    """
    shared = [JSON_OPTION] if as_json else []
    if plot:
        text = f"Draw {plot}: .png, .svg or .pdf."
        shared.append(click.option("--plot", "picture", type=NewPicture(), metavar="FILE", help=text))
    shared += [*(WORKERS_OPTIONS if workers else ()), *(runner_options(friction, model) if runner else ())]

    def decorate(function: Callable[..., Answer]) -> click.Command:
        @functools.wraps(function)
        def run(as_json: bool = False, picture: Path | None = None, **given: Any) -> None:
            if workers:
                given["workers"] = Workers(given["workers"], given.pop("scheduler"))
            if runner:
                values = values_given(given.pop("friction") if friction else None, given.pop("settings"))
                named = given.pop("model") if model else None
                given["options"] = RunnerOptions(given.pop("parameters"), values, named)
            function(**given).show(as_json, picture)

        made: Any = run
        for each in reversed([*options, *shared]):
            made = each(made)
        text = inspect.cleandoc(function.__doc__ or "").partition(PARAMETERS)[0]
        return click.command(name, cls=Command, help=text)(made)

    return decorate


class Command(click.Command):
    """A command that refuses an option given twice, and 1_0 for 10, which click accepts in silence."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Read the command line."""
        try:
            values, _, given = self.make_parser(ctx).parse_args(args=list(args))
        except click.UsageError as problem:
            problem.ctx = problem.ctx or ctx  # click leaves it out of some errors
            raise
        for option in (one for one in given if isinstance(one, click.Option)):
            is_single = not option.multiple and not option.is_flag
            if is_single and given.count(option) > 1:
                raise click.UsageError(f"{option.opts[0]} is given twice; allowed: once", ctx)
            value = values.get(option.name or "")
            texts = map(str, value if isinstance(value, list) else [value])
            wrong = next((text for text in texts if isinstance(option.type, NUMERIC) and "_" in text), None)
            if wrong is not None:
                raise click.UsageError(f"{option.opts[0]} {shown(wrong)}; allowed: a number without _", ctx)
        return super().parse_args(ctx, args)
