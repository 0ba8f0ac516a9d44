"""One stride with its quantities, and how they change with its apex and with parameters, exactly.

The derivatives of what is measured along a stride are the C library's.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..contents import ByContents
from ..errors import RunError
from ..variables.table import FRICTION
from .binding import c, ffi
from .maps import map_of, why_no_return
from .measures import APEX_QUANTITIES, MEASURES, all_measures, apex_quantities, measures_of, weight_of
from .members import check_comes_down, check_has_gaits
from .quantities import check_quantities, quantity_of
from .refusals import text_of
from .return_map import seed_of
from .runner import Runner
from .strides import longest_stride
from .structs import Return, StrideVariation

_PER_DISTANCE = {"cost_of_transport": "work", "positive_cost_of_transport": "positive_work"}
_MEASURED = tuple(name for name in MEASURES if name not in (*APEX_QUANTITIES, *_PER_DISTANCE))
_VARIED = (
    "period",
    "length",
    "work",
    "stance_time",
    "slip_distance",
    "peak_force",
    "peak_vertical_force",
)
"""Of these the library has derivatives, of either map."""
_READ = (*_VARIED, "speed", "duty_factor", "cost_of_transport")
"""Of the library's stride."""


@dataclass(frozen=True, eq=False)
class VariedStride(ByContents):
    """A stride, and how it changes with its apex and with parameters."""

    left_over: NDArray[np.float64]
    """Next apex minus this one, shape (n,)."""
    quantities: NDArray[np.float64]
    """In the order in which they were asked for, shape (q,)."""
    by_all: NDArray[np.float64]
    """Changes of `left_over` and `quantities` by the coordinates and the parameters, shape (n + q, n + p)."""


def varied_stride(
    runner: Runner, apex: NDArray[np.float64], names: Sequence[str], parameters: Sequence[str]
) -> VariedStride:
    """One stride from an apex, whether it leads back there or not, with all its derivatives."""
    check_quantities(runner, names)
    stride, variations = _variations(runner, apex, parameters)
    reported = _read(runner, apex, stride)
    varied = _varied(runner)
    d_apex, d_stride = variations[: len(apex)], dict(zip(varied, variations[len(apex) :], strict=True))
    d_stride |= _apex_variations(runner, variations.shape[1])
    d_weight = np.array([0.0] * len(apex) + [_weight_variation(runner, name) for name in parameters])
    rows = [_variation(runner, name, reported, d_stride, d_weight) for name in names]
    by_all = np.vstack([d_apex - np.eye(*d_apex.shape), *rows])
    if not np.isfinite(by_all).all():
        raise RunError("a stride is on the edge of an event or of a law, where it has no derivatives")
    values = np.array([quantity_of(name, reported) for name in names])
    return VariedStride(np.array(list(stride.apex)[: len(apex)]) - apex, values, by_all)


@dataclass(frozen=True, eq=False)
class PlainStride(ByContents):
    """A stride without derivatives."""

    left_over: NDArray[np.float64]
    """Next apex minus this one, shape (n,)."""
    quantities: NDArray[np.float64]
    """In the order in which they were asked for, shape (q,)."""
    word: str
    """Of its stance."""


def plain_stride(runner: Runner, apex: NDArray[np.float64], names: Sequence[str]) -> PlainStride:
    """One stride from an apex, whether it leads back there or not; with derivatives it takes much longer."""
    check_quantities(runner, names)
    stride = _stride(runner, apex, (), False)
    reported = _read(runner, apex, stride)
    return PlainStride(
        left_over=np.array(list(stride.apex)[: len(apex)]) - apex,
        quantities=np.array([quantity_of(name, reported) for name in names]),
        word=text_of(stride.stride.word),
    )


def _variations(
    runner: Runner, apex: NDArray[np.float64], parameters: Sequence[str]
) -> tuple[Return, NDArray[np.float64]]:
    """The stride; and variations of the next apex and `_varied`, in rows, by coordinates and parameters.

    The library differentiates by a few parameters at a time.
    """
    maximum = c.TDMF_RETURN_MAP_SEEDS
    parts = [parameters[begin : begin + maximum] for begin in range(0, len(parameters), maximum)] or [()]
    strides = [_stride(runner, apex, part, True) for part in parts]
    coordinates = len(apex)
    columns = [_column(runner, strides[0].variations[k]) for k in range(coordinates)]
    for stride, part in zip(strides, parts, strict=True):
        columns += [_column(runner, stride.variations[coordinates + k]) for k in range(len(part))]
    return strides[0], np.array(columns).T


def _varied(runner: Runner) -> tuple[str, ...]:
    """Of these the library has derivatives."""
    return _VARIED if runner.reduced else (*_VARIED, *_MEASURED)


def _column(runner: Runner, variation: StrideVariation) -> list[float]:
    measures = {} if runner.reduced else measures_of(variation)
    basic = {name: float(getattr(variation, name)) for name in _VARIED}
    apex = variation.apex[0 : len(runner.coordinates)]
    return [*apex, *({**basic, **measures}[name] for name in _varied(runner))]


def _apex_variations(runner: Runner, count: int) -> dict[str, NDArray[np.float64]]:
    """Of the same, by so many coordinates and parameters."""
    rows = dict(zip(runner.coordinates, np.eye(count), strict=False))
    return {name: rows[of] for name, of in APEX_QUANTITIES.items() if of in rows}


def _stride(
    runner: Runner, apex: NDArray[np.float64], parameters: Sequence[str], derivatives: bool
) -> Return:
    check_has_gaits(runner[FRICTION])
    check_comes_down(runner)
    map, seeds = map_of(runner), ffi.new("tdmf_seed[]", len(parameters) or 1)
    for k, name in enumerate(parameters):
        seeds[k] = seed_of(name)[0]
    stride = map.measured_stride(
        runner.solver(),
        runner.c_system,
        list(apex),
        longest_stride(runner),
        derivatives,
        seeds,
        len(parameters),
    )
    why_not = why_no_return(stride)
    if why_not is not None:
        raise RunError(why_not)
    return stride


def _read(runner: Runner, apex: NDArray[np.float64], stride: Return) -> dict[str, float]:
    basic = {name: float(getattr(stride.stride, name)) for name in _READ}
    measures = apex_quantities(runner, apex) if runner.reduced else all_measures(runner, apex, stride)
    return {**basic, **measures}


def _weight_variation(runner: Runner, name: str) -> float:
    if name in ("body.mass", "foot.mass"):
        return runner["gravity"]
    return runner["body.mass"] + runner["foot.mass"] if name == "gravity" else 0.0


def _variation(
    runner: Runner,
    name: str,
    stride: Mapping[str, float],
    d_stride: Mapping[str, NDArray[np.float64]],
    d_weight: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Of a quantity, by the rules of differentiation, from the seeds of `_varied`."""
    if name in d_stride:
        return d_stride[name]
    if name == "frequency":
        return -d_stride["period"] / stride["period"] ** 2
    if name == "speed":
        return (d_stride["length"] - stride["speed"] * d_stride["period"]) / stride["period"]
    if name == "duty_factor":
        return (d_stride["stance_time"] - stride["duty_factor"] * d_stride["period"]) / stride["period"]
    weight = weight_of(runner)
    d_product = d_weight * stride["length"] + weight * d_stride["length"]
    return (d_stride[_PER_DISTANCE[name]] - stride[name] * d_product) / (weight * stride["length"])
