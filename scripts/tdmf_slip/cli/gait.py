"""The command `gait`: one periodic gait, as the runner has it or with a target."""

import os
import sys
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path

import click

from ..analysis.targeted import TargetNotMetError, find_gait
from ..errors import InputError
from ..library.gait import REPORTED, Gait
from ..library.quantities import MEASURES, quantities_of, unit_of
from ..terminal.text import columns, quantity
from ..variables.display_units import DisplayUnits
from ..variables.variable import Given
from .command import Answer, command, option
from .options import TARGET_OPTION, NewPicture, names_given, targets_given
from .runner import RunnerOptions

PICTURE = "gait.png"
"""File that --plot writes if none is given."""


@command(
    "gait",
    TARGET_OPTION,
    option("--vary", of=find_gait, default=None, metavar="NAME,NAME"),
    click.option(
        "--plot",
        type=NewPicture(),
        is_flag=False,
        flag_value=PICTURE,
        metavar="[FILE]",
        help="Draw the stance: .png, .svg or .pdf, and open the picture where there is a display.  "
        f"[without FILE: {PICTURE}]",
    ),
)
def gait_command(
    options: RunnerOptions, targets: tuple[str, ...], vary: str | None, plot: Path | None
) -> Answer:
    """Find the periodic gait, stable or not, and the eigenvalues of its return map.

    With --target, find the gait that meets the targets by changing the parameters in --vary. If none is
    found, the JSON holds the nearest gait and the parameters that would help, and the exit status is 1.
    """
    target = targets_given(targets)
    if vary is not None and not target:
        raise InputError(f"--vary {vary} needs --target QUANTITY=VALUE, as in --target speed=1")
    if vary is None and target:
        raise InputError("--target needs --vary NAME,NAME, with at least as many names as targets")
    runner, names = options.runner(), names_given(vary)
    given = {name: value for name, (_, value) in options.given.items()}
    if target:
        try:
            gait = find_gait(runner, target=target, vary=names, progress=True)
        except TargetNotMetError as problem:
            nearest = _target_json(problem.nearest, target, names)
            return Answer({"nearest": nearest, "helps": list(problem.helps)}, "", failure=problem)
        plain = _target_json(gait, target, names)
    else:
        gait = find_gait(runner)
        plain = gait.as_json()
    then = None if plot is None else partial(_draw, gait, plot)
    return Answer(plain, _text(gait, given, list(target), names), then=then)


def _draw(gait: Gait, path: Path) -> str:
    """Draw the stance into a file, print its path, and open it if there is a display."""
    from ..pictures.plot import write_picture  # matplotlib is slow to load

    write_picture(path, gait)
    print(f"picture: {path.resolve()}", file=sys.stderr)
    has_display = os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")
    if sys.stderr.isatty() and (has_display or sys.platform in ("darwin", "win32")):
        click.launch(str(path))
    return ""


def _target_json(gait: Gait, target: Mapping[str, float], vary: list[str]) -> dict[str, object]:
    """JSON of a gait, with the values of varied parameters and of prescribed quantities."""
    free = {name: gait.runner[name] for name in vary}
    return {**gait.as_json(), "free": free, "ordered": quantities_of(gait, list(target))}


def _text(gait: Gait, given: Mapping[str, Given], target: Sequence[str], vary: Sequence[str]) -> str:
    units = DisplayUnits(given, gait.runner)

    def of(name: str, value: float) -> str:
        return quantity(units.value(name, value), units.unit(name), 12)

    basic = [name for name in target if name in gait.stride and name not in MEASURES]
    measured = {
        name: quantity(gait.reported[name], units.label(unit_of(name)), 12)
        for name in (*MEASURES, "frequency")
        if name in target
    }
    apex = dict(zip(gait.runner.coordinates, gait.apex, strict=True))
    rows = {
        "word": gait.word,
        "friction": of("ground.friction", gait.friction),
        **{name: of(f"stride.{name}", gait.stride[name]) for name in dict.fromkeys([*REPORTED, *basic])},
        **measured,
        **{name: of(name, gait.runner[name]) for name in vary},
        "liftoff_angle": of("hip.liftoff_angle", gait.liftoff_angle),
        **{f"apex.{n}": of(f"apex.{n}", v) for n, v in apex.items()},
        "eigenvalues": ", ".join(_complex(complex(value)) for value in gait.eigenvalues),
        "stable": "yes" if gait.stable else "no",
    }
    return columns(rows)


def _complex(value: complex) -> str:
    return f"{value.real:.9g}" if value.imag == 0.0 else f"{value.real:.9g}{value.imag:+.9g}i"
