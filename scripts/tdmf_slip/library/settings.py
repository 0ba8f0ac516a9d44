"""Settings that may change at each apex: parameters of the control law, and inputs."""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from ..checks import choice_of, is_one_of, near_matches, shown
from ..errors import InputError
from ..variables.table import MODELS, Model
from .binding import c
from .ground import RoughGround
from .page_model import PageModel
from .runner import Runner

SETTINGS = MODELS["full"].settings
"""Settings by the unit's names."""
OF_FLIGHT = ("hip.kp", "hip.kd", "hip.liftoff_angle_factor", "hip.swing_clamp")
"""Parameters of the leg's motion in flight, which has no part in the reduced map."""
BY_GAINS = (
    "hip.touchdown_angle",
    "hip.retraction_rate",
    "hip.liftoff_angle_factor",
    "control.touchdown_angle",
)
"""Settings that act through the servo alone, in proportion to `hip.kp` and `hip.kd`."""
CONSTANT_ON_TERRAIN = ("ground.height", "ground.slope", "body.external_fx", "body.external_fy")
"""Settings that no law may change on a terrain."""


def setting_number(name: object, what: str, model: Model = MODELS["full"]) -> int:
    """A setting as the library knows it: of a model of one's own, a parameter or a state behind them."""
    known = model.settings
    if is_one_of(name, known):
        return (
            model.setting_number(name)
            if isinstance(model, PageModel)
            else int(c.tdmf_setting_of(name.encode()))
        )
    allowed = (
        choice_of(known, "tdmf-slip variables")
        or "none; a page declares settings, and parameters that are tunable"
    )
    if is_one_of(name, model.varied):
        raise InputError(f"{what}: {name} cannot change in a run; allowed: {allowed}")
    near = near_matches(name, (*known, *model.aliases))
    raise InputError(f"{what}: {shown(name)} is not a setting{near}; allowed: {allowed}")


def check_acts(name: str, runner: Runner, set_too: Sequence[str], what: str) -> None:
    """Refuse a setting that changes nothing in a runner's motion, whatever its value."""
    if runner.model.is_page:
        return
    if runner.reduced:
        if name in OF_FLIGHT:
            raise InputError(
                f"{what}: {name} has no effect in the reduced map, which places the leg without torque; "
                "allowed: with the full model"
            )
        return
    gains = ("hip.kp", "hip.kd")
    if name in BY_GAINS and not any(runner[gain] or gain in set_too for gain in gains):
        raise InputError(
            f"{what}: {name} has no effect if hip.kp and hip.kd are 0; allowed: one of them above 0"
        )


def checked_values(
    name: str,
    values: NDArray[np.float64],
    what: str,
    first: Mapping[str, int],
    model: Model = MODELS["full"],
) -> NDArray[np.float64]:
    """Values of a setting, all within its range."""
    variable = model.variables[name]
    within = (values >= variable.minimum) & (values <= variable.maximum)
    if not within.all():
        index = tuple(int(index) for index in np.argwhere(~within)[0])
        where = ", ".join(
            f"{axis} {at + begin}" for (axis, begin), at in zip(first.items(), index, strict=True)
        )
        value = f"{name} = {values[index]:.9g}"
        raise InputError(
            f"{what}: {where + ': ' if where else ''}{value} is not allowed; allowed: {variable.allowed}"
        )
    return values


def check_settings(
    names: Sequence[str],
    runner: Runner,
    ground: RoughGround,
    what: str,
    *,
    set_too: Sequence[str] = (),
    inputs: Sequence[str] = (),
) -> None:
    """Refuse settings that there are not, that do not act, or that something else sets.

    `set_too` are names of what is set or varies besides; of these, `inputs` are set from stride to stride.
    """
    for name in names:
        setting_number(name, what, runner.model)
        check_acts(name, runner, (*names, *set_too), what)
        if name in inputs:
            raise InputError(f"{what}: {name} is in the inputs, too; allowed: in one of them")
        if name == "ground.height" and ground.roughness:
            raise InputError(f"{what}: {name} on rough ground, whose steps set it; allowed: on level ground")
        if name == "ground.friction" and ground.friction_spread:
            raise InputError(
                f"{what}: {name} on ground whose friction is drawn (friction_spread); allowed: one of the two"
            )
        if name in CONSTANT_ON_TERRAIN and ground.segment_length:
            raise InputError(f"{what} sets {name} on a terrain (segment_length); allowed: it sets others")
