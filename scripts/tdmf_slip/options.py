"""What several commands share: options, and how start values and results are read and written."""

import json
import math

import click

from .errors import InputError
from .parameters import preset_names, read_parameters
from .unit import Unit

JSON_OPTION = click.option(
    "--json", "as_json_object", is_flag=True, help="Print one JSON object and nothing else."
)
SET_OPTION = click.option(
    "--set",
    "settings",
    multiple=True,
    metavar="NAME=VALUE",
    help="Start value of a variable, as in leg.stiffness=20000 or leg.angle='40 deg'. Repeatable.",
)
PARAMETERS_OPTION = click.option(
    "--parameters",
    metavar="FILE",
    help=f"Start values from a TOML or JSON file, or from a preset: {', '.join(preset_names())}.",
)
SCHEDULER_OPTION = click.option(
    "--scheduler",
    metavar="ADDRESS",
    help="Dask scheduler whose workers do the work, tcp://host:8786; without one, processes of this machine.",
)
WORKERS_OPTION = click.option(
    "--workers",
    type=click.IntRange(min=1),
    metavar="N",
    help="Processes on this machine.  [default: one for each processor]",
)


def start_values(
    unit: Unit, parameters: str | None, friction: float | None, settings: tuple[str, ...]
) -> dict[str, object]:
    """Start values from all options, later ones first in rank: file, --friction, --set."""
    values: dict[str, object] = {}
    if parameters is not None:
        values |= unit.start_values(read_parameters(parameters), f"--parameters {parameters}")
    if friction is not None:
        values |= unit.start_values({"ground.friction": friction}, "--friction")
    for setting in settings:
        name, equals, value = setting.partition("=")
        if not equals:
            raise InputError(f"--set {setting}: allowed: NAME=VALUE")
        values |= unit.start_values({name.strip(): value.strip()}, "--set")
    return values


def refuse_set(settings: tuple[str, ...], name: str, by: str) -> None:
    """Refuse a start value for what another option varies.

    Raises:
        InputError: there is one.
    """
    if any(setting.partition("=")[0].strip() == name.strip() for setting in settings):
        raise InputError(f"--set {name}: {by} says what it is; allowed: one of the two")


def json_text(value: object) -> str:
    """One line of JSON, in which a number that is not finite is null."""
    return json.dumps(_finite(value), allow_nan=False)


def _finite(value: object) -> object:
    if isinstance(value, dict):
        return {key: _finite(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
