"""C structs of runners and strides as NumPy types, and strides by the native solver on arrays of them.

Only this module and `engine` know the structs. Whoever holds an array keeps its memory alive.
"""

from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .binding import c, check_accepted, ffi
from .members import Along, names_of, seed_of

_NUMBERS = {"double": "f8", "_Bool": "?"}


@cache
def dtype_of(name: str) -> np.dtype[Any]:
    """The NumPy type with the layout of a C type; pointers become addresses, texts bytes."""
    return _dtype_of(ffi.typeof(name))


def _dtype_of(kind: Any) -> np.dtype[Any]:
    if kind.kind == "struct":
        return np.dtype(
            {
                "names": [name for name, _ in kind.fields],
                "formats": [_dtype_of(member.type) for _, member in kind.fields],
                "offsets": [member.offset for _, member in kind.fields],
                "itemsize": ffi.sizeof(kind),
            }
        )
    if kind.kind == "array":
        is_text = kind.item.cname == "char"
        return np.dtype(f"S{kind.length}" if is_text else (_dtype_of(kind.item), (kind.length,)))
    if kind.kind in ("pointer", "function"):
        return np.dtype(np.uintp)
    is_unsigned = kind.kind == "enum" or kind.cname.startswith(("u", "size_t"))
    return np.dtype(_NUMBERS.get(kind.cname) or f"{'u' if is_unsigned else 'i'}{ffi.sizeof(kind)}")


END = dtype_of("tdmf_ensemble_end")
"""End of a run."""
STRIDE = dtype_of("tdmf_ensemble_stride")
"""A recorded stride."""
RETURN = dtype_of("tdmf_return")
"""A stride with its derivatives."""
MODEL = dtype_of("tdmf_model")
"""Accepted parameters."""
LONGEST_STRIDE = 1e4
"""Longest stride, in sqrt(m/k)."""
STATE = np.dtype([("end", END), ("checkpoint", dtype_of("tdmf_ensemble_checkpoint"))])
"""A runner at an apex, to go on from."""
WIDTH: int = c.TDMF_POINT_LIMIT
"""Coordinates in the library's rows of points, whatever the model."""


def viewed(struct: Any, kind: np.dtype[Any]) -> NDArray[Any]:
    """A C struct as an array of length 1 over the same memory."""
    return np.frombuffer(ffi.buffer(struct), kind)


def copied(models: Sequence[Any]) -> NDArray[Any]:
    """Models in a row. NumPy's `concatenate` would leave out the padding that C has."""
    return np.frombuffer(b"".join(ffi.buffer(model)[:] for model in models), MODEL)


def address(array: NDArray[Any]) -> int:
    """Address of an array; whoever writes the address into a struct keeps the array alive."""
    return int(ffi.cast("uintptr_t", ffi.from_buffer(array)))


def written(structs: NDArray[Any], values: Mapping[str, NDArray[np.float64]]) -> NDArray[Any]:
    """Copies of parameters or inputs, one for each runner, with those of the values that are among them."""
    copies = np.repeat(structs, len(next(iter(values.values()))))
    for name in names_of(structs.dtype):
        if name in values:
            copies[name] = values[name]
    return copies


def models_of(parameters: NDArray[Any]) -> NDArray[Any]:
    """The model of each of many runners."""
    models = np.empty(len(parameters), MODEL)
    out, given = ffi.from_buffer("tdmf_model[]", models), ffi.from_buffer("tdmf_parameters[]", parameters)
    for number in range(len(models)):
        accepted = c.tdmf_model_create(out + number, given + number)
        check_accepted(accepted, f"runner: runner {number}: ")
    return models


def exact_strides(
    solver: Any,
    models: NDArray[Any],
    inputs: NDArray[Any],
    apices: NDArray[np.float64],
    *,
    reduced: bool,
    derivatives: bool,
    along: Sequence[Along],
    measured: bool,
    threads: int = 1,
) -> NDArray[Any]:
    """One stride of each runner, in lanes, shape (runners,), with up to `SEEDS` derivatives."""
    returns = np.empty(len(apices), RETURN)
    out, sections = ffi.from_buffer("tdmf_return[]", returns), ffi.from_buffer("double[]", apices)
    seeds = ffi.NULL
    if along:
        seeds = ffi.new("tdmf_seed[]", len(along))
        for k, direction in enumerate(along):
            seeds[k] = seed_of(direction)[0]
    systems = np.empty((len(apices), 2), np.uintp)
    systems[:, 0] = address(models) + models.itemsize * (np.arange(len(apices)) if len(models) > 1 else 0)
    systems[:, 1] = address(inputs) + inputs.itemsize * (np.arange(len(apices)) if len(inputs) > 1 else 0)
    until = np.zeros(len(apices))
    batch = ffi.new("tdmf_stride_batch *")
    batch.systems, batch.count = ffi.from_buffer("tdmf_system[]", systems), len(apices)
    batch.until = ffi.from_buffer("double[]", until)
    batch.map = c.TDMF_REDUCED_MAP if reduced else c.TDMF_RETURN_MAP
    batch.sections = ffi.cast(f"double(*)[{WIDTH}]", sections)
    batch.derivatives, batch.measures = derivatives, measured
    batch.seeds, batch.seed_count, batch.threads = seeds, len(along), threads
    check_accepted(c.tdmf_run_strides(solver, batch, out))
    return returns


SEEDS: int = c.TDMF_RETURN_MAP_SEEDS
"""Parameters by which one call differentiates."""
