"""A gait's return map with settings that are chosen at each apex, to first order.

With the deviations x of an apex from the gait's and u of the settings from theirs, the next apex deviates by

    x' = A x + B u,

both matrices exact, by the variational equations of the C library. The horizontal position and the time are
no coordinates of the section: the map does not depend on them.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..checks import is_one_of, near_matches, shown
from ..errors import InputError
from ..library.gait import Gait, check_is_gait
from ..library.return_map import stride_from
from ..library.runner import Runner
from ..library.scales import scale_of
from ..library.settings import SETTINGS
from ..variables.table import ALIASES, VARIABLES, full_names

CHOSEN = tuple(name for name in SETTINGS if not name.startswith("ground."))
"""Settings that a controller may choose anew at each apex: all but the ground's."""
THRUSTS = ("leg.thrust", "control.thrust")
"""Their sum is held at 0 and above."""
CLOSED = 1e-9
"""Largest difference of an apex and the next over the scales, of what counts as a gait."""
IDLE = 1e-12
"""A setting has no effect if it changes no scaled coordinate of the apex by more than this."""


@dataclass(frozen=True, eq=False)
class Linearization:
    """The return map of a gait and its settings, to first order."""

    gait: Gait
    """The gait."""
    inputs: tuple[str, ...]
    """Those that are chosen at each apex, of `CHOSEN`."""
    nominal: NDArray[np.float64]
    """The settings of the gait, shape (k,), in their units."""
    state_matrix: NDArray[np.float64]
    """A, shape (n, n): the change of the next apex by this one, in the units of the section."""
    input_matrix: NDArray[np.float64]
    """B, shape (n, k): its change by the settings."""
    setting_scales: NDArray[np.float64]
    """Of the settings, shape (k,): 1 rad, sqrt(k/m), l0, k l0, k l0^2, and for gains of the hip k l0^2
    and l0^2 sqrt(k m), each per rad."""

    @cached_property
    def scales(self) -> NDArray[np.float64]:
        """Scales of the section's coordinates, shape (n,)."""
        return self.gait.runner.scales

    @cached_property
    def scaled_state_matrix(self) -> NDArray[np.float64]:
        """A of deviations over their scales, shape (n, n)."""
        scaled: NDArray[np.float64] = self.state_matrix * self.scales / self.scales[:, None]
        return scaled

    @cached_property
    def scaled_input_matrix(self) -> NDArray[np.float64]:
        """B of deviations and settings over their scales, shape (n, k)."""
        scaled: NDArray[np.float64] = self.input_matrix * self.setting_scales / self.scales[:, None]
        return scaled

    def closed_loop(self, gain: NDArray[np.float64]) -> NDArray[np.float64]:
        """The state matrix of the loop that a feedback closes, of deviations over their scales."""
        closed = self.state_matrix + self.input_matrix @ gain
        scaled: NDArray[np.float64] = closed * self.scales / self.scales[:, None]
        return scaled


def linearize(gait: Gait, inputs: Sequence[str]) -> Linearization:
    """The return map of a gait to first order, by the apex and by settings."""
    _check_gait(gait)
    runner = gait.runner
    names = _checked_names(inputs)
    for name in names:
        _check_inside(runner, name)
    by_setting = []
    jacobian = gait.jacobian
    for name in names:
        _, jacobian, column = stride_from(runner, gait.apex, name)
        by_setting.append(column)
    model = Linearization(
        gait=gait,
        inputs=names,
        nominal=np.array([runner[name] for name in names]),
        state_matrix=jacobian,
        input_matrix=np.array(by_setting).T,
        setting_scales=np.array([scale_of(runner, VARIABLES[name].unit) for name in names]),
    )
    moved = np.max(np.abs(model.scaled_input_matrix), axis=0)
    for name, maximum in zip(names, moved, strict=True):
        if maximum <= IDLE:
            raise InputError(
                f"inputs: {name} has no effect on the next apex of this gait; allowed: inputs that have one"
            )
    return model


def _check_gait(gait: Gait) -> None:
    check_is_gait(gait, "gait")
    if gait.following:
        raise InputError(f"gait of {gait.strides} strides is not allowed; allowed: a gait of one stride")
    if not gait.error <= CLOSED:
        raise InputError(
            f"gait whose next apex is {gait.error:.2g} of the scales away is not allowed; allowed: a gait, "
            f"which leads back to within {CLOSED:g}, as find_gait gives"
        )


def _checked_names(given: object) -> tuple[str, ...]:
    allowed = f"allowed: {', '.join(CHOSEN)}"
    names = full_names(given, "inputs", f"one or more in a list: {', '.join(CHOSEN)}")
    if not names:
        raise InputError(f"inputs = {shown(given)} is not allowed; one or more in a list; {allowed}")
    for name in names:
        if not is_one_of(name, CHOSEN):
            raise InputError(
                f"inputs: {shown(name)} is not allowed; {allowed}{near_matches(name, (*CHOSEN, *ALIASES))}"
            )
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise InputError(f"inputs: {twice} is named twice; allowed: each once")
    return names


def _check_inside(runner: Runner, name: str) -> None:
    """Refuse a setting that has a derivative to one side only."""
    value, variable = runner[name], VARIABLES[name]
    if name in THRUSTS:
        total = sum(runner[thrust] for thrust in THRUSTS)
        if total <= 0.0:
            raise InputError(
                f"inputs: {name} belongs to a thrust of {total:g} m at this gait, which is held at 0 and "
                "above, so that it acts to one side only and its derivative is one-sided; allowed: a gait "
                "with a thrust above 0"
            )
    elif not variable.minimum < value < variable.maximum:
        raise InputError(
            f"inputs: {name} = {value:g} at this gait is at the end of its range, so that it can be moved "
            f"to one side only and its derivative is one-sided; allowed: inside {variable.allowed}"
        )
