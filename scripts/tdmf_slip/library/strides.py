"""Strides in a row from an apex with their exact Jacobian, whether they lead back to it or not."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from ..variables.table import FRICTION
from .binding import ffi
from .c_structs import LONGEST_STRIDE
from .gait import Gait, gait_of_stride
from .maps import map_of, why_no_return
from .members import check_comes_down, check_has_gaits
from .quantities import APEX_QUANTITIES, weight_of
from .return_map import Along, seed_of
from .runner import Runner
from .section import Apex, checked_apex
from .word import Event

BETWEEN_WORDS = " "


def strides_from(runner: Runner, apex: Apex, strides: int = 1, *, along: Along | None = None) -> Gait:
    """Strides in a row from an apex, whether they lead back to it or not."""
    check_has_gaits(runner[FRICTION])
    check_comes_down(runner)
    made = [_stride(runner, checked_apex(apex, runner.coordinates), along)]
    while len(made) < strides:
        made.append(_stride(runner, made[-1][0], along))
    return _joined([gait for _, gait in made], made[-1][0])


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
    residual = last_apex - first.apex
    return replace(
        first,
        word=BETWEEN_WORDS.join(gait.word for gait in gaits),
        liftoff_angle=gaits[-1].liftoff_angle,
        stride=_together(first.runner, [gait.stride for gait in gaits]),
        jacobian=jacobian,
        by_parameter=by_parameter,
        error=float(np.max(np.abs(residual) / first.runner.scales)),
        events=_events(gaits),
        following=tuple(gait.apex for gait in gaits[1:]),
        residual=residual,
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
    """Events of all strides, timed from the first apex."""
    begins = np.cumsum([0.0, *(gait.period for gait in gaits[:-1])])
    return tuple(
        replace(event, time=event.time + float(begin))
        for begin, gait in zip(begins, gaits, strict=True)
        for event in gait.events
    )
