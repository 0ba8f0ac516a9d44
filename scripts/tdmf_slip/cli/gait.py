"""The command `gait`: one periodic gait, as the runner has it or with a target."""

from collections.abc import Mapping, Sequence

import click

from ..analysis.targeted import TargetNotMetError, find_gait
from ..errors import InputError
from ..fmu.display_units import DisplayUnits
from ..fmu.fmu import Fmu, load_fmu
from ..fmu.variable import Given
from ..library.gait import REPORTED, Gait
from ..library.measures import MEASURES
from ..library.quantities import quantities_of, quantity_of, unit_of
from ..terminal.text import columns, quantity
from .options import (
    FRICTION_OPTION,
    JSON_OPTION,
    MODEL_OPTION,
    PARAMETERS_OPTION,
    SET_OPTION,
    TARGET_OPTION,
    Command,
    names_given,
    targets_given,
    texts_of,
    values_given,
)
from .output import json_text
from .runner import runner_of

VARY_OPTION = click.option(
    "--vary",
    metavar="NAMES",
    help="Parameters that may change for a target, at least as many as it prescribes, as in "
    "hip.stance_torque,leg.stiffness; they begin with the values given.",
)


@click.command("gait", cls=Command)
@TARGET_OPTION
@VARY_OPTION
@FRICTION_OPTION
@SET_OPTION
@PARAMETERS_OPTION
@MODEL_OPTION
@JSON_OPTION
def gait_command(
    targets: tuple[str, ...],
    vary: str | None,
    friction: float | None,
    settings: tuple[str, ...],
    parameters: str | None,
    model: str,
    as_json_object: bool,
) -> None:
    """The periodic gait, stable or not, with the eigenvalues of its return map.

    With --target, the gait that has what is prescribed, by the parameters that --vary names.
    Where there is none, JSON has the nearest one and the parameters that would help, and the status is 1.
    """
    fmu = load_fmu()
    target = targets_given(targets)
    names = _names(vary, target)
    given = values_given(friction, settings)
    runner = runner_of(fmu, parameters, given, model)
    if not target:
        gait = find_gait(runner, fmu=fmu)
        print(json_text(gait.as_json()) if as_json_object else _gait_text(gait, fmu, texts_of(given)))
        return
    try:
        gait = find_gait(runner, target=target, vary=names, progress=True, fmu=fmu)
    except TargetNotMetError as problem:
        if as_json_object:
            nearest = _target_json(problem.nearest, target, names)
            print(json_text({"nearest": nearest, "helps": list(problem.helps)}))
        raise
    if as_json_object:
        print(json_text(_target_json(gait, target, names)))
    else:
        print(_gait_text(gait, fmu, texts_of(given), list(target), names))


def _names(vary: str | None, target: Mapping[str, float]) -> list[str]:
    """Of --vary, which has a meaning with a target only."""
    if vary is not None and not target:
        raise InputError(f"--vary {vary}: nothing is prescribed; allowed: with --target QUANTITY=VALUE")
    if vary is None and target:
        raise InputError("--vary is missing; allowed: with --target, at least as many names as prescribed")
    return names_given(vary)


def _target_json(gait: Gait, target: Mapping[str, float], vary: list[str]) -> dict[str, object]:
    """As any gait, with the varied parameters' values and what it has of what is prescribed."""
    return {
        **gait.as_json(),
        "free": {name: gait.runner.values[name] for name in vary},
        "ordered": quantities_of(gait, list(target)),
    }


def _gait_text(
    gait: Gait,
    fmu: Fmu,
    given: Mapping[str, Given],
    target: Sequence[str] = (),
    vary: Sequence[str] = (),
) -> str:
    units = DisplayUnits(fmu, given, gait.runner.values)

    def of(name: str, value: float) -> str:
        return quantity(units.value(name, value), units.unit(name), 12)

    basic = [name for name in target if name in gait.stride and name not in MEASURES]
    reported = dict.fromkeys([*REPORTED, *basic])
    measured = {
        name: quantity(quantity_of(name, gait.stride), units.label(unit_of(name, fmu)), 12)
        for name in (*MEASURES, "frequency")
        if name in target
    }
    apex = dict(zip(gait.runner.coordinates, gait.apex, strict=True))
    rows = {
        "word": gait.word,
        "friction": of("ground.friction", gait.friction),
        **{name: of(f"stride.{name}", gait.stride[name]) for name in reported},
        **measured,
        **{name: of(name, gait.runner.values[name]) for name in vary},
        "liftoff_angle": of("hip.liftoff_angle", gait.liftoff_angle),
        **{f"apex.{n}": of(f"apex.{n}", v) for n, v in apex.items()},
        "eigenvalues": ", ".join(_complex(value) for value in gait.eigenvalues),
        "stable": "yes" if gait.stable else "no",
    }
    return columns(rows)


def _complex(value: complex) -> str:
    value = complex(value)
    return f"{value.real:.9g}" if value.imag == 0.0 else f"{value.real:.9g}{value.imag:+.9g}i"
