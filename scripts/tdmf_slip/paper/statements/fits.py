"""The stiffness that fits a human at eight speeds, and what the constants that are assumed make of it."""

from collections.abc import Callable, Mapping
from functools import cache

from ...fitting.fitted import fit
from ...fitting.measurements import shipped
from ...fitting.result import Fit
from ...fmu.parameters import read_parameters
from .claim import ANGLE, TORQUE, OwnClaim

STIFFNESS = "leg.stiffness"
ASSUMED: Mapping[str, tuple[float, float]] = {
    "leg.free_length": (0.9, 1.03),
    "foot.mass": (3.0, 5.0),
    "leg.damping": (40.0, 100.0),
    "ground.friction": (0.4, 1.0),
}
"""Ends of what else they might be: m, kg, N s/m."""
COMMAND = (
    f"tdmf-slip fit human_running --parameters human_running.toml --vary {STIFFNESS} "
    f"--vary-each {TORQUE},{ANGLE} --model reduced"
)


@cache
def _fitted(name: str = "", value: float = 0.0) -> Fit:
    """With one constant as given."""
    values = read_parameters(str(shipped("human_running.toml")))
    changed = {name: value} if name else {}
    if name == "leg.free_length":  # the start is an apex, with a leg of this length above the ground
        changed |= {"leg.length": value, "foot.y": float(values["foot.y"]) * value + 0.02}
    return fit(
        {**values, **changed},
        "human_running",
        [STIFFNESS],
        vary_each=[TORQUE, ANGLE],
        model="reduced",
        profile=False,
    )


def _change(choose: Callable[[list[float]], float]) -> Callable[[int], float]:
    """Least or greatest change by one constant at a time, per cent."""

    def change(seed: int) -> float:
        as_it_is = _fitted().parameters[STIFFNESS].value
        others = [
            _fitted(name, value).parameters[STIFFNESS].value
            for name, ends in ASSUMED.items()
            for value in ends
        ]
        return 100.0 * (choose(others) / as_it_is - 1.0)

    return change


def _slip(choose: Callable[[list[float]], float]) -> Callable[[int], float]:
    return lambda seed: choose([one.stride["slip_distance"] for one in _fitted().gaits])


CLAIMS = (
    OwnClaim(
        "one stiffness that fits a human at eight speeds, N/m",
        COMMAND,
        15_200.0,
        15_280.0,
        lambda seed: _fitted().parameters[STIFFNESS].value,
    ),
    OwnClaim(
        "  its standard error by the data's scatter, per cent",
        COMMAND,
        1.0,
        1.15,
        lambda seed: (
            100.0 * _fitted().parameters[STIFFNESS].standard_error / _fitted().parameters[STIFFNESS].value
        ),
    ),
    OwnClaim(
        "  its control: by other leg lengths, foot masses, dampings and frictions, lowest, per cent",
        f"{COMMAND} --set leg.free_length=0.9",
        -6.2,
        -5.7,
        _change(min),
    ),
    OwnClaim("  highest, per cent", f"{COMMAND} --set foot.mass=3", 1.9, 2.1, _change(max)),
    OwnClaim("  what the fitted runner slips in a step: least, m", COMMAND, 0.039, 0.041, _slip(min)),
    OwnClaim("  and most, m", COMMAND, 0.075, 0.078, _slip(max)),
)
