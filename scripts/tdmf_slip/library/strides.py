"""Strides in a row from an apex with their exact Jacobian, whether they lead back to it or not."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from .batch import Batch
from .c_structs import LONGEST_STRIDE
from .events import Event
from .gait import Gait
from .members import check_comes_down, check_has_gaits
from .quantities import PER_DISTANCE, RATES, check_quantities, weight_of
from .return_map import Along, derivatives, refuse_patch
from .runner import Runner
from .section import Apex, checked_apex
from .tables import Table


@dataclass(frozen=True, eq=False)
class MadeStride:
    """A stride, and how it changes with its apex and with parameters."""

    residual: NDArray[np.float64]
    """Next apex minus this one, shape (n,)."""
    quantities: NDArray[np.float64]
    """Quantities in the order in which they were asked for, shape (q,)."""
    word: str
    """Word of the stride's stance."""
    by_all: NDArray[np.float64]
    """Changes of `residual` and `quantities` by the coordinates and the parameters, shape (n + q, n + p);
    empty without derivatives."""


def varied_stride(
    runner: Runner, apex: NDArray[np.float64], names: Sequence[str], parameters: Sequence[str]
) -> MadeStride:
    """One stride from an apex, whether it leads back there or not, with all its derivatives."""
    stride = _varied_stride(runner, apex, names, True, parameters)
    by_apex = stride.next_apex_by - np.eye(*stride.next_apex_by.shape)
    by_all = np.vstack([by_apex, *(stride[f"{name}_by"] for name in names)])
    if not np.isfinite(by_all).all():
        raise RunError("a stride is on the edge of an event or of a law, where it has no derivatives")
    return _made(stride, names, by_all)


def plain_stride(runner: Runner, apex: NDArray[np.float64], names: Sequence[str]) -> MadeStride:
    """One stride from an apex, whether it leads back there or not; with derivatives it takes much longer."""
    return _made(_varied_stride(runner, apex, names, False), names, np.empty((0, 0)))


def _made(stride: Table, names: Sequence[str], by_all: NDArray[np.float64]) -> MadeStride:
    quantities = np.array([float(stride[name]) for name in names])
    return MadeStride(stride.next_apex - stride.apex, quantities, str(stride.word), by_all)


def _varied_stride(
    runner: Runner,
    apex: NDArray[np.float64],
    names: Sequence[str],
    derivatives: bool,
    parameters: Sequence[str] = (),
) -> Table:
    check_quantities(runner, names)
    check_has_gaits(runner)
    check_comes_down(runner)
    stride = Batch(runner, apex).stride(derivatives, parameters)
    if stride.outcome:
        raise RunError(str(stride.why_not))
    return stride


@dataclass(frozen=True, eq=False)
class VariedGait:
    """Quantities of a gait, and how they and its apex change with parameters while it stays a gait."""

    quantities: NDArray[np.float64]
    """Quantities in the order in which they were asked for, shape (q,)."""
    by_parameters: NDArray[np.float64]
    """Derivatives of the quantities by the parameters, shape (q, p)."""
    apex_by_parameters: NDArray[np.float64]
    """Derivatives of the apex by the parameters, shape (n, p)."""
    apex_by_residual: NDArray[np.float64]
    """Derivative of the apex by the residual of its stride: the inverse of the map less one, shape (n, n)."""


def varied_gait(
    runner: Runner, apex: NDArray[np.float64], names: Sequence[str], parameters: Sequence[str]
) -> VariedGait:
    """A gait, with the derivatives of its quantities and of its apex by parameters.

    By the implicit function theorem: with the return map P, dP/dz dz + dP/dp dp = dz along the gaits.
    """
    stride, count = varied_stride(runner, apex, names, parameters), len(apex)
    try:
        inverse: NDArray[Any] = np.linalg.inv(stride.by_all[:count, :count])
    except np.linalg.LinAlgError:
        inverse = np.full((count, count), np.inf)
    if not np.isfinite(inverse).all():
        raise RunError("the gait is where two meet, and has no derivatives")
    d_apex = -inverse @ stride.by_all[:count, count:]
    of_quantities = stride.by_all[count:]
    return VariedGait(
        quantities=stride.quantities,
        by_parameters=of_quantities[:, count:] + of_quantities[:, :count] @ d_apex,
        apex_by_parameters=d_apex,
        apex_by_residual=inverse,
    )


BETWEEN_WORDS = " "


def strides_from(runner: Runner, apex: Apex, strides: int = 1, *, along: Along | None = None) -> Gait:
    """Strides in a row from an apex, whether they lead back to it or not."""
    refuse_patch(runner)
    check_has_gaits(runner)
    check_comes_down(runner)
    last, gait = _stride(runner, checked_apex(apex, runner.coordinates), along)
    gaits = [gait]
    while len(gaits) < strides:
        last, gait = _stride(runner, last, along)
        gaits.append(gait)
    return gaits[0] if strides == 1 else _joined(gaits, last)


def longest_stride(runner: Runner) -> float:
    """The time, s, after which a stride counts as none."""
    return LONGEST_STRIDE * runner.scale_of("s")


def _stride(
    runner: Runner, apex: NDArray[np.float64], along: Along | None
) -> tuple[NDArray[np.float64], Gait]:
    """The next apex, and the stride as a gait that need not close."""
    stride = runner.stride(apex, longest_stride(runner), varied=True, along=along, is_reported=True)
    if why_not := stride.why_not():
        raise RunError(why_not)
    jacobian, by_parameter = derivatives(runner, stride)
    values = {name: float(stride.quantity(name)[0]) for name in stride.names if name != "frequency"}
    following: NDArray[np.float64] = stride.next_points[0]
    gait = Gait(
        runner=runner,
        apex=apex,
        word=str(stride.words[0]),
        liftoff_angle=values.pop("liftoff_angle", math.nan),
        stride=values,
        jacobian=jacobian,
        along=along,
        by_parameter=None if along is None else by_parameter,
        error=_error(runner, following - apex),
        iterations=0,
        events=stride.events,
        residual=following - apex,
    )
    return following, gait


def _error(runner: Runner, residual: NDArray[np.float64]) -> float:
    """Largest entry of a residual, over the scales."""
    return float(np.max(np.abs(residual) / runner.scales))


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
        error=_error(first.runner, residual),
        events=_events(gaits),
        following=tuple(gait.apex for gait in gaits[1:]),
        residual=residual,
    )


def _together(runner: Runner, strides: Sequence[Mapping[str, float]]) -> dict[str, float]:
    """Quantities of strides in a row: sums, but for the largest, ratios, and those of the first apex."""
    found = {name: sum(stride[name] for stride in strides) for name in strides[0]}
    distance = weight_of(runner) * found["length"] if "cost_of_transport" in found else 0.0
    greatest = ("peak_force", "peak_vertical_force", "greatest_foot_height", "greatest_slip_velocity")
    of_first = (*(name for name, of in runner.model.quantities.items() if of.coordinate), "foot_clearance")
    return found | {
        **{name: found[of] / found["period"] for name, of in RATES.items() if name in found},
        **{
            name: found[of] / distance if distance else 0.0
            for name, of in PER_DISTANCE.items()
            if name in found
        },
        **{name: max(stride[name] for stride in strides) for name in greatest if name in found},
        **{name: strides[0][name] for name in of_first if name in found},
    }


def _events(gaits: Sequence[Gait]) -> tuple[Event, ...]:
    """Events of all strides, timed from the first apex."""
    begins = np.cumsum([0.0, *(gait.period for gait in gaits[:-1])])
    return tuple(
        replace(event, time=event.time + float(begin))
        for begin, gait in zip(begins, gaits, strict=True)
        for event in gait.events
    )
