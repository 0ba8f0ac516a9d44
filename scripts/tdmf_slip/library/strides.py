"""Strides in a row from an apex with their exact Jacobian, and gaits that repeat themselves after several.

With the map P^n of n strides and its Jacobian J, a step of Newton's method solves (I - J) dz = P^n(z) - z.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from ..numerics.newton import last_iterate
from ..variables.table import FRICTION
from .binding import ffi
from .c_structs import LONGEST_STRIDE
from .gait import Gait, gait_near, gait_of_stride
from .maps import map_of, why_no_return
from .members import check_comes_down, check_has_gaits
from .quantities import APEX_QUANTITIES, weight_of
from .return_map import Along, seed_of
from .runner import Runner
from .section import Apex, checked_apex
from .word import Event

NEWTON_ITERATIONS = 40
SHORTENINGS = 12
CONVERGED, GOOD_ENOUGH = 1e-13, 1e-11
"""Largest difference of the apex and the last one, over the coordinates' scales."""
BETWEEN_WORDS = " "


def strides_from(runner: Runner, apex: Apex, strides: int = 1, *, along: Along | None = None) -> Gait:
    """Strides in a row from an apex, whether they lead back to it or not."""
    check_has_gaits(runner[FRICTION])
    check_comes_down(runner)
    made = [_stride(runner, checked_apex(apex, runner.coordinates), along)]
    while len(made) < strides:
        made.append(_stride(runner, made[-1][0], along))
    return _joined([gait for _, gait in made], made[-1][0])


def repeated_gait_near(runner: Runner, guess: Apex, strides: int = 1, *, along: Along | None = None) -> Gait:
    """The gait near a guess that repeats itself after some strides, by Newton's method."""
    if strides == 1:
        return gait_near(runner, guess, along=along)
    gait, iterations = last_iterate(
        _Repetition(strides, along),
        strides_from(runner, guess, strides, along=along),
        iterations=NEWTON_ITERATIONS,
        shortenings=SHORTENINGS,
    )
    gait = replace(gait, iterations=iterations)
    if gait.error > GOOD_ENOUGH:
        raise RunError(
            f"no gait of {strides} strides at friction {gait.friction:g}: Newton's method stopped after "
            f"{gait.iterations} iterations with the last apex {gait.error:.2g} of its scales away"
        )
    return gait


@dataclass(frozen=True)
class _Repetition:
    """That an apex comes back after some strides."""

    strides: int
    along: Along | None

    def error(self, gait: Gait) -> float:
        return gait.error

    def is_solved(self, gait: Gait) -> bool:
        return gait.error <= CONVERGED

    def step(self, gait: Gait) -> NDArray[Any]:
        return newton_step(gait)

    def moved(self, gait: Gait, step: NDArray[Any]) -> Gait:
        return strides_from(gait.runner, gait.apex + step, self.strides, along=self.along)


def newton_step(gait: Gait) -> NDArray[Any]:
    """From the apex of strides to where, by their Jacobian, they come back to it."""
    step: NDArray[Any] = np.linalg.solve(np.eye(len(gait.apex)) - gait.jacobian, gait.left_over)
    return step


def longest_stride(runner: Runner) -> float:
    """The time, s, after which a stride counts as none."""
    return float(LONGEST_STRIDE * (runner["body.mass"] / runner["leg.stiffness"]) ** 0.5)


def _stride(
    runner: Runner, apex: NDArray[np.float64], along: Along | None
) -> tuple[NDArray[np.float64], Gait]:
    """The next apex, and the stride as a gait that need not close."""
    log: Any = ffi.new("tdmf_event_log *")
    seed, map = seed_of(along), map_of(runner)
    stride = map.measured_stride(
        runner.solver(log),
        runner.c_system,
        list(apex),
        longest_stride(runner),
        True,
        seed,
        along is not None,
    )
    why_not = why_no_return(stride)
    if why_not is not None:
        raise RunError(why_not)
    next_apex = np.array(list(stride.apex)[: len(apex)])
    return next_apex, gait_of_stride(runner, apex, stride, log, along)


def _joined(gaits: Sequence[Gait], last_apex: NDArray[np.float64]) -> Gait:
    """Strides in a row as one gait."""
    first = gaits[0]
    jacobian, by_parameter = first.jacobian, first.by_parameter
    for gait in gaits[1:]:
        jacobian = gait.jacobian @ jacobian
        if by_parameter is not None and gait.by_parameter is not None:
            by_parameter = gait.jacobian @ by_parameter + gait.by_parameter
    left_over = last_apex - first.apex
    return replace(
        first,
        word=BETWEEN_WORDS.join(gait.word for gait in gaits),
        liftoff_angle=gaits[-1].liftoff_angle,
        stride=_together(first.runner, [gait.stride for gait in gaits]),
        jacobian=jacobian,
        by_parameter=by_parameter,
        error=float(np.max(np.abs(left_over) / first.runner.scales)),
        events=_events(gaits),
        following=tuple(gait.apex for gait in gaits[1:]),
        left_over=left_over,
    )


def _together(runner: Runner, strides: Sequence[Mapping[str, float]]) -> dict[str, float]:
    """Quantities of strides in a row: sums, but for the largest, ratios, and those of the first apex."""
    if len(strides) == 1:
        return dict(strides[0])
    found = {name: sum(stride[name] for stride in strides) for name in strides[0]}
    distance = weight_of(runner) * found["length"]
    greatest = ("peak_force", "peak_vertical_force", "greatest_foot_height", "greatest_slip_velocity")
    ratios = {"cost_of_transport": "work", "positive_cost_of_transport": "positive_work"}
    return found | {
        "speed": found["length"] / found["period"],
        "duty_factor": found["stance_time"] / found["period"],
        **{name: found[of] / distance if distance else 0.0 for name, of in ratios.items() if name in found},
        **{name: max(stride[name] for stride in strides) for name in greatest if name in found},
        **{name: strides[0][name] for name in (*APEX_QUANTITIES, "foot_clearance") if name in found},
    }


def _events(gaits: Sequence[Gait]) -> tuple[Event, ...]:
    """Of all strides, timed from the first apex."""
    begins = np.cumsum([0.0, *(gait.period for gait in gaits[:-1])])
    return tuple(
        replace(event, time=event.time + float(begin))
        for begin, gait in zip(begins, gaits, strict=True)
        for event in gait.events
    )
