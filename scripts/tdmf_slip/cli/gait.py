"""The command `gait`: one periodic gait, as the runner has it or to order."""

from collections.abc import Mapping, Sequence

import click

from ..analysis.search import periodic_gait
from ..analysis.targeted import TargetNotMetError, find_gait
from ..errors import InputError
from ..library.gait import TOLD, Gait
from ..library.measures import MEASURE_UNITS
from ..library.quantities import QUANTITIES, quantities_of
from ..terminal.text import columns, quantity
from ..unit.told import Told
from ..unit.unit import Fmu, load_fmu
from .options import (
    FRICTION_OPTION,
    JSON_OPTION,
    MODEL_OPTION,
    PARAMETERS_OPTION,
    SET_OPTION,
    Command,
    ordering,
    texts_of,
    values_given,
)
from .output import json_text
from .runner import runner_of


@click.command("gait", cls=Command)
@ordering
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
    free: str | None,
    **ordered: float | None,
) -> None:
    """The periodic gait, stable or not, with the eigenvalues of its return map.

    With --speed and the like, the gait that has what is ordered, by freeing as many parameters or more with
    --free.
    Where there is none, JSON has the nearest one and the parameters that would help, and the status is 1.
    """
    fmu = load_fmu()
    order = {name: value for name, value in ordered.items() if value is not None}
    names = _names(free, order)
    given = values_given(friction, settings)
    runner = runner_of(fmu, parameters, given, model)
    if not order:
        gait = periodic_gait(runner, fmu=fmu)
        print(json_text(gait.as_json()) if as_json_object else _gait_text(gait, fmu))
        return
    try:
        gait = find_gait(runner, target=order, vary=names, progress=True, fmu=fmu)
    except TargetNotMetError as problem:
        if as_json_object:
            nearest = _ordered_json(problem.nearest, order, names)
            print(json_text({"nearest": nearest, "helps": list(problem.helps)}))
        raise
    if as_json_object:
        print(json_text(_ordered_json(gait, order, names)))
    else:
        print(_gait_text(gait, fmu, list(order), names, Told(fmu, texts_of(given))))


def _names(free: str | None, order: Mapping[str, float]) -> list[str]:
    """Of --free, which has a meaning with an order only.

    Raises
    ------
    InputError
        One is given without the other.
    """
    options = ", ".join(f"--{name.replace('_', '-')}" for name in QUANTITIES)
    if free is not None and not order:
        raise InputError(f"--free {free}: nothing is ordered; allowed: with {options}")
    if free is None and order:
        raise InputError("--free is missing; allowed: with an order, at least as many parameters as ordered")
    return [] if free is None else [name.strip() for name in free.split(",")]


def _ordered_json(gait: Gait, order: Mapping[str, float], free: list[str]) -> dict[str, object]:
    """As any gait, with the freed parameters' values and what it has of what is ordered."""
    return {
        **gait.as_json(),
        "free": {name: gait.runner.values[name] for name in free},
        "ordered": quantities_of(gait, list(order)),
    }


def _gait_text(
    gait: Gait, fmu: Fmu, order: Sequence[str] = (), free: Sequence[str] = (), told_in: Told | None = None
) -> str:
    units = told_in or Told(fmu)

    def of(name: str, value: float) -> str:
        return quantity(units.value(name, value), units.unit(name), 12)

    basic = [name for name in order if name in gait.stride and name not in MEASURE_UNITS]
    told = dict.fromkeys([*TOLD, *basic])
    measured = {
        name: quantity(gait.stride[name], of, 12) for name, of in MEASURE_UNITS.items() if name in order
    }
    apex = dict(zip(gait.runner.coordinates, gait.apex, strict=True))
    rows = {
        "word": gait.word,
        "friction": of("ground.friction", gait.friction),
        **{name: of(f"stride.{name}", gait.stride[name]) for name in told},
        **measured,
        **({"frequency": quantity(1.0 / gait.period, "Hz", 12)} if "frequency" in order else {}),
        **{name: of(name, gait.runner.values[name]) for name in free},
        "liftoff_angle": of("hip.liftoff_angle", gait.liftoff_angle),
        **{f"apex.{n}": of(f"apex.{n}", v) for n, v in apex.items()},
        "eigenvalues": ", ".join(_complex(value) for value in gait.eigenvalues),
        "stable": "yes" if gait.stable else "no",
    }
    return columns(rows)


def _complex(value: complex) -> str:
    value = complex(value)
    return f"{value.real:.9g}" if value.imag == 0.0 else f"{value.real:.9g}{value.imag:+.9g}i"
