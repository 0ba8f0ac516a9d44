"""The command `gait`: one periodic gait."""

import click

from ..analysis.search import find_orbit
from ..library.orbit import TOLD, Orbit
from ..terminal.text import columns, quantity
from ..unit.unit import Unit, load
from .options import (
    FRICTION_OPTION,
    JSON_OPTION,
    MODEL_OPTION,
    PARAMETERS_OPTION,
    SET_OPTION,
    Command,
    values_given,
)
from .output import json_text
from .runner import runner_of


@click.command("gait", cls=Command)
@FRICTION_OPTION
@SET_OPTION
@PARAMETERS_OPTION
@MODEL_OPTION
@JSON_OPTION
def gait_command(
    friction: float | None,
    settings: tuple[str, ...],
    parameters: str | None,
    model: str,
    as_json_object: bool,
) -> None:
    """The periodic gait, stable or not, with the eigenvalues of its return map."""
    unit = load()
    orbit = find_orbit(runner_of(unit, parameters, values_given(friction, settings)), model=model, unit=unit)
    print(json_text(orbit.as_json()) if as_json_object else _orbit_text(orbit, unit))


def _orbit_text(orbit: Orbit, unit: Unit) -> str:
    def of(name: str, value: float) -> str:
        return quantity(value, unit.variables[name].unit, 12)

    apex = dict(zip(orbit.runner.coordinates, orbit.apex, strict=True))
    rows = {
        "word": orbit.word,
        "friction": of("ground.friction", orbit.friction),
        **{name: of(f"stride.{name}", orbit.stride[name]) for name in TOLD},
        "liftoff_angle": of("hip.liftoff_angle", orbit.liftoff_angle),
        **{f"apex.{n}": of(f"apex.{n}", v) for n, v in apex.items()},
        "eigenvalues": ", ".join(_complex(value) for value in orbit.eigenvalues),
        "stable": "yes" if orbit.stable else "no",
    }
    return columns(rows)


def _complex(value: complex) -> str:
    value = complex(value)
    return f"{value.real:.9g}" if value.imag == 0.0 else f"{value.real:.9g}{value.imag:+.9g}i"
