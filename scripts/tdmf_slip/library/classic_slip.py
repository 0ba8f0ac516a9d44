"""The classic SLIP: a point mass on a massless spring leg, the sections 2 and 3 of the paper.

The ground may have a slope, and the leg may retract: it turns back at a constant rate from the apex on.

An apex has a height above the ground vertically below it, and an energy m (v^2/2 + g times this height).
The energy of the motion is conserved. On a slope the ground below the next apex is higher or lower, and the
energy above it is less by m g L tan(slope), L being the length of the step, which is positive. So on a slope
no gait repeats both height and energy: uphill the runner loses energy above the ground with every step,
downhill it gains. There `classic_gaits` finds gaits that repeat their height at one energy: at each apex a
change of speed gives back the energy that the climb has cost, or takes what the descent has gained. `step`
makes no such change.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import check_size
from ..errors import InputError, RunError
from ..variables.variable import Given
from .binding import c, ffi
from .page_model import package_model
from .page_runner import PageRunner
from .page_strides import PageStrides, seeds_of, strides_of

TOLERANCE = 1e-14
"""Relative tolerance of the solver."""
LONGEST = 1e6
"""Time to the next apex at the most, s."""
ENERGY = 6000.0
"""E0 of the paper, J."""
NO_SLIP = 1e9
"""Friction at which the foot never slips."""
SPACING = 0.02
"""Distance of the apex heights between which fixed points are searched, m."""
MAX_HEIGHTS = 1_000_000
"""Largest number of these heights."""
FOLD_STEPS = 11
"""Steps in which a fold is followed to a slope and a rate of retraction."""
Outcome = Literal["flies", "turns back", "slides", "falls", "no start"]
"""End of a step: at the next apex, forward or backward; with a foot that slides out; or with the mass on
the ground. A step has no start if the foot at the apex is below the ground or the energy is too small."""
FLIES: Outcome = "flies"
TURNS_BACK: Outcome = "turns back"
_ENDS: dict[str, Outcome] = {"no_start": "no start", "slides": "slides", "fallen": "falls"}


@dataclass(frozen=True)
class Step:
    """One step from apex to apex. Values at the next apex are NaN if there is none."""

    outcome: Outcome
    """End of the step: at a next apex, or the reason why there is none."""
    touchdown_time: float
    """Time from the apex to touchdown, s."""
    stance_time: float
    """Duration of the stance, s."""
    time: float
    """Duration of the step, s."""
    early_take_off: bool
    """The leg left the friction cone: the energy left in the spring is lost."""
    stance_friction: float
    """Friction needed in the stance: the largest tan of the leg's angle from the ground's normal  (3)"""
    impact_friction: float
    """Friction needed at the impact of an infinitesimal foot mass  (5)"""
    length: float
    """Horizontal distance from apex to apex, m."""
    next_height: float
    """Height of the next apex above the ground below it, m."""
    next_speed: float
    """Speed at the next apex, m/s, negative backward."""
    next_energy: float
    """Energy at the next apex, above the ground below it, J."""
    foot: tuple[float, float]
    """Place of the foot in stance, m, relative to the ground below the apex."""
    slope: float
    """Derivative of the next height by the height, at one energy."""


@dataclass(frozen=True)
class FixedPoint:
    """A fixed point of the return map from apex height to apex height, at one energy.

    On level ground it is a periodic gait. On a slope it is one if the energy above the ground, of which the
    step takes `energy_loss`, is restored at each apex by a change of speed.
    """

    angle: float
    """Touchdown angle, rad, at the apex where the leg retracts."""
    height: float
    """Height of the apex above the ground below it, m."""
    slope: float
    """Slope of the map at one energy, which is its eigenvalue."""
    stance_friction: float
    """Friction needed in the stance."""
    impact_friction: float
    """Friction needed at the impact of an infinitesimal foot mass."""
    length: float
    """Length of the step from apex to apex, m."""
    energy_loss: float
    """Loss of energy above the ground in the step, J; negative downhill, 0 on level ground."""

    @property
    def stable(self) -> bool:
        """The map's slope is below 1 in size."""
        return abs(self.slope) < 1.0


def slip(
    angle: float,
    friction: float = NO_SLIP,
    *,
    ground_slope: float = 0.0,
    retraction_rate: float = 0.0,
    **parameters: float,
) -> PageRunner:
    """The paper's SLIP; further `parameters` have the names of the page."""
    given = {"touchdown_angle": angle, "slope": ground_slope, "retraction_rate": retraction_rate}
    given["friction"] = NO_SLIP if math.isinf(friction) else friction
    return _runner("at_apex", given | parameters)


def _runner(section: str, given: Mapping[str, Given]) -> PageRunner:
    return PageRunner(given, model=package_model("classic_slip", section), tolerance=TOLERANCE)


def _strides(runner: PageRunner, heights: ArrayLike, energy: float, until: float = LONGEST) -> PageStrides:
    """Runs from apices to the next, or until a time, s, after the start."""
    of_height = np.atleast_1d(np.asarray(heights, float))
    return strides_of(
        runner.model,
        runner.parameters,
        runner.states,
        np.column_stack([of_height, np.full(len(of_height), energy)]),
        tolerance=runner.tolerance,
        longest=until,
        seeds=seeds_of(runner.model, []),
    )


def step(slip: PageRunner, height: float, energy: float = ENERGY) -> Step:
    """One step of the return map."""
    return steps(slip, height, energy)[0]


def steps(slip: PageRunner, heights: ArrayLike, energy: float = ENERGY) -> list[Step]:
    """Steps of the return map from apices of one energy."""
    made = _strides(slip, heights, energy)
    refused = made.points[made.ends["outcome"] == c.TDMF_PAGE_REFUSED].tolist()
    if refused:
        raise InputError(f"height and energy of an apex: {refused[0]}; allowed: finite numbers")
    slopes = made.next_points_by[:, 0, 0].tolist()
    rows = zip(made.ends, made.states.tolist(), slopes, strict=True)
    return [_step(slip, end, states, slope) for end, states, slope in rows]


def _step(slip: PageRunner, end: np.void, states: list[float], slope: float) -> Step:
    at, modes = dict(zip(slip.model.state_numbers, states, strict=True)), slip.model.table["modes"]
    crossed = end["outcome"] == c.TDMF_PAGE_CROSSED
    outcome = (FLIES if at["vx"] > 0.0 else TURNS_BACK) if crossed else _ENDS[modes[end["mode"]][0]]
    if outcome == "slides" and slip["friction"] == NO_SLIP:
        outcome = "falls"
    ahead = at if crossed else dict.fromkeys(at, math.nan)
    return Step(
        outcome,
        touchdown_time=at["touchdown_time"],
        stance_time=at["stance_time"],
        time=float(end["time"]),
        early_take_off=bool(at["left_early"]),
        stance_friction=at["stance_friction"],
        impact_friction=at["impact_friction"],
        length=ahead["step_length"],
        next_height=ahead["apex_height"],
        next_speed=ahead["vx"],
        next_energy=ahead["apex_energy"],
        foot=(at["foot_x"], at["foot_y"]),
        slope=slope,
    )


def path(slip: PageRunner, height: float, times: ArrayLike, energy: float = ENERGY) -> NDArray[np.float64]:
    """Position of the mass relative to the foot, and velocity, at times after an apex: a row for each."""
    x, y = step(slip, height, energy).foot
    states = [_strides(slip, height, energy, time).states[0] for time in np.atleast_1d(times)]
    columns = [slip.model.state_numbers[name] for name in ("x", "y", "vx", "vy")]
    return np.array(states)[:, columns].T - [[x], [y], [0.0], [0.0]]


def highest(slip: PageRunner, energy: float = ENERGY) -> float:
    """Apex height, m, at which all energy, J, is potential."""
    return energy / (slip["mass"] * slip["gravity"])


def heights(slip: PageRunner, count: int, energy: float = ENERGY) -> NDArray[np.float64]:
    """`count` apex heights, m, between that with the foot on the ground and the highest, both left out."""
    angle, slope = slip["touchdown_angle"], slip["slope"]
    low = slip["free_length"] * (math.cos(angle) + math.sin(angle) * math.tan(slope))
    return np.linspace(low, highest(slip, energy), count + 2)[1:-1]


def classic_gaits(
    angle: float,
    energy: float = ENERGY,
    *,
    ground_slope: float = 0.0,
    retraction_rate: float = 0.0,
) -> list[FixedPoint]:
    """Find all gaits of the classic SLIP at a touchdown angle and an energy, stable or not.

    Parameters
    ----------
    angle : float
        Touchdown angle, rad.
    energy : float, default 6000
        Energy at the apex, J, by default that of the paper.
    ground_slope : float, default 0.0
        Slope of the ground, rad, positive uphill.
    retraction_rate : float, default 0.0
        Rate at which the leg turns back after the apex, rad/s.

    Returns
    -------
    list of FixedPoint
        The gaits by their height: `height`, m; `slope` of the map from apex height to apex height, which is
        between -1 and 1 if the gait is stable; `stance_friction` and `impact_friction`, which they need.

    Raises
    ------
    InputError
        A value is out of its range.

    Examples
    --------
    >>> import math, tdmf_slip
    >>> [round(gait.height, 3) for gait in tdmf_slip.classic_gaits(math.radians(40))]
    [1.037, 3.548]
    """
    given = {"touchdown_angle": angle, "slope": ground_slope, "retraction_rate": retraction_rate}
    at_energy = _runner("at_energy", given | {"energy": energy})
    runner, energy = _runner("at_apex", at_energy), at_energy["energy"]
    count = int(highest(runner, energy) / SPACING)
    check_size("energy", count, "heights to try", MAX_HEIGHTS)
    tried, found = heights(runner, count, energy), []
    for (low, before), (high, after) in pairwise(zip(tried, steps(runner, tried, energy), strict=True)):
        crosses = (before.next_height - low) * (after.next_height - high) <= 0.0
        if before.outcome == FLIES and after.outcome == FLIES and crosses:
            height = np.array([0.5 * (low + high)])
            if c.tdmf_page_fixed_point(at_energy.request.map, ffi.from_buffer("double[]", height)):
                found.append(_fixed_point(runner, float(height[0]), energy))
    return found


def classic_fold(
    energy: float = ENERGY, *, ground_slope: float = 0.0, retraction_rate: float = 0.0
) -> FixedPoint:
    """Find the touchdown angle at which the stable and the unstable gait of the classic SLIP meet and vanish.

    On a slope, or with a leg that retracts, the fold is followed from the one on level ground with a leg that
    keeps its angle.

    Parameters
    ----------
    energy : float, default 6000
        Energy at the apex, J, by default that of the paper.
    ground_slope : float, default 0.0
        Slope of the ground, rad, positive uphill.
    retraction_rate : float, default 0.0
        Rate at which the leg turns back after the apex, rad/s.

    Returns
    -------
    FixedPoint
        The gait at the fold; `angle` is its touchdown angle, rad.

    Raises
    ------
    InputError
        A value is out of its range.
    RunError
        No fold was found.

    Examples
    --------
    >>> import math, tdmf_slip
    >>> round(math.degrees(tdmf_slip.classic_fold().angle), 2)
    44.59
    """
    asked = {"energy": energy, "slope": ground_slope, "retraction_rate": retraction_rate}
    checked = _runner("at_energy", asked)
    energy = checked["energy"]
    given = {"ground_slope": checked["slope"], "retraction_rate": checked["retraction_rate"]}
    point = np.array([math.radians(44.0), 2.0])
    for share in np.linspace(0.0, 1.0, FOLD_STEPS) if any(given.values()) else (1.0,):
        point = _fold(point, energy, {name: share * value for name, value in given.items()})
    return _fixed_point(slip(point[0], **given), point[1], energy)


def _fold(guess: NDArray[np.float64], energy: float, given: dict[str, float]) -> NDArray[np.float64]:
    """Touchdown angle and height at which a step repeats its height and the map's slope is 1."""
    from scipy.optimize import root  # slow to load

    where = f"ground_slope = {given['ground_slope']:g}, retraction_rate = {given['retraction_rate']:g}"
    missing = RunError(f"no fold of the classic SLIP was found at energy = {energy:g} J, {where}")

    def residual(point: NDArray[np.float64]) -> list[float]:
        made = step(slip(point[0], **given), point[1], energy)
        if made.outcome != FLIES:
            raise missing
        return [made.next_height - point[1], made.slope - 1.0]

    found = root(residual, guess, tol=1e-11)
    if not np.max(np.abs(found.fun)) < 1e-8:
        raise missing
    point: NDArray[np.float64] = found.x
    return point


def _fixed_point(runner: PageRunner, height: float, energy: float) -> FixedPoint:
    made = step(runner, height, energy)
    return FixedPoint(
        runner["touchdown_angle"],
        height,
        made.slope,
        made.stance_friction,
        made.impact_friction,
        made.length,
        runner["mass"] * runner["gravity"] * made.length * math.tan(runner["slope"]),
    )
