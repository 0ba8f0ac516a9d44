"""Gaits, simulations and perturbed strides of one reading, to compare with the paper's statements."""

import math
from functools import cache, cached_property

import numpy as np
import pandas
from numpy.typing import NDArray
from scipy.optimize import brentq

from ..analysis.search import Spread, periodic_gait, search_from_spread
from ..analysis.stride_map import stride_map
from ..analysis.sweeps import Sweep, sweep
from ..library import classic_slip
from ..library.binding import c
from ..library.gait import Gait
from ..library.runner import Runner
from ..library.section import COORDINATES
from ..variables.table import FRICTION, STATES
from ..variables.variable import Given
from .along import gait_table
from .claims import WORDS

SWEPT = np.geomspace(10.0, 0.05, 200)
"""Frictions at which gaits are sought."""
LEAST_FRICTION = float(SWEPT[-1])
SIMULATED, SETTLED = 700, 1e-6
"""Strides of a simulation on the least friction, and the distance from the gait at which it has settled."""
PERTURBED = np.geomspace(0.3, 0.05, 8)
"""Frictions of perturbed gaits, where the paper could not differentiate its return map."""
PERTURBATIONS = np.concatenate([np.linspace(-0.2, -0.01, 20), np.linspace(0.01, 0.2, 20)])
"""Change of one coordinate of the apex, in units of l0, sqrt(m/k) and rad."""
LEG_ANGLE = COORDINATES.index("leg_angle")
SLIP_ANGLE = 40.0
"""Touchdown angle of the classic SLIP for which the paper gives numbers, degrees."""
BRACKET = (math.radians(30.0), math.radians(33.0))
"""Touchdown angles between which the lower gait of the classic SLIP becomes stable."""


class Evidence:
    """Results about the paper's runner for one reading, each computed when it is first asked for."""

    perturbed = len(PERTURBED) * len(PERTURBATIONS) * len(COORDINATES)
    """Number of strides that begin off a gait on low friction, by one coordinate."""

    def __init__(self, runner: Runner, progress: bool = False) -> None:
        """Results about a runner; `progress` shows a bar for the sweep."""
        self.runner, self._progress = runner, progress

    @cached_property
    def sweep(self) -> Sweep:
        """Gaits at many values of friction, and the borders between their words."""
        return sweep(self.runner, {FRICTION: SWEPT}, progress=self._progress)

    @cached_property
    def gaits(self) -> pandas.DataFrame:
        """Friction, word, largest eigenvalue and quantities of the stride of each gait of the sweep."""
        return gait_table(self.sweep.gaits)

    @property
    def moduli(self) -> NDArray[np.float64]:
        """Moduli of the eigenvalues of each gait of the sweep, the largest first."""
        gaits = self.sweep.gaits
        moduli = np.hypot(gaits["eigenvalue_real"].values, gaits["eigenvalue_imag"].values)
        found: NDArray[np.float64] = moduli[gaits["word"].values != ""]
        return found

    def gait(self, friction: float, **values: Given) -> Gait:
        """The gait at a friction, with other values of the runner."""
        return periodic_gait(self.runner.replace(values | {FRICTION: friction}))

    @cached_property
    def five(self) -> list[Gait]:
        """Gaits at the frictions of the paper's figures 5 to 8."""
        return [self.gait(friction) for friction in WORDS]

    @cached_property
    def settling(self) -> int | None:
        """Strides in which a run from the unit's start settles on the least friction; None if never."""
        gait = self.gait(LEAST_FRICTION)
        run = stride_map(gait.runner, [gait.runner.start_apex()], strides=SIMULATED)
        off = np.abs(run["apex"].values[0] - gait.apex) / gait.runner.scales
        settled = np.flatnonzero(np.max(off, axis=1) < SETTLED)
        return int(settled[0]) if len(settled) else None

    @cached_property
    def further_touchdowns(self) -> int:
        """Number of perturbed strides with more than one touchdown, or without a next apex."""
        directions = np.eye(len(COORDINATES)) * self.runner.scales
        offsets = np.concatenate([size * directions for size in PERTURBATIONS])
        gaits = [self.gait(friction) for friction in PERTURBED]
        runs = [stride_map(gait.runner, gait.apex + offsets) for gait in gaits]
        return sum(int(np.sum(run["touchdowns"] != 1.0)) for run in runs)

    @cached_property
    def printed_torque(self) -> Spread:
        """Search for a gait with the stance torque (11) as it is printed, all over the section."""
        name = "hip.stance_torque"
        return search_from_spread(self.runner.replace({name: -self.runner[name]}))


def touchdown_angle(gait: Gait) -> float:
    """Leg angle at touchdown, rad."""
    touchdown = next(event for event in gait.events if event.contact_after != c.TDMF_CONTACT_FLIGHT)
    return touchdown.state[STATES.index("leg.angle")]


@cache
def lowest_stable_angle() -> float:
    """Least touchdown angle at which the classic SLIP has a stable gait, rad: the map's slope is -1 there."""
    angle: float = brentq(lambda angle: classic_slip.classic_gaits(angle)[0].slope + 1.0, *BRACKET, xtol=1e-6)
    return angle
