"""Results as datasets, and the record of a saved result: its version, its model and its runner's values.

JSON has the record as `version`, `model` and `runner`; a result from which a run can begin has `start_values`
instead of `runner`, and a proof has its exact `parameters`. A dataset has `version`, `model` and `runner` as
attributes, and `result`, the kind of the result. The runner is one JSON text, because attributes of NetCDF
files are numbers and texts. A model of one's own is recorded by its `build`, too.
"""

import functools
import inspect
import json
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, ParamSpec, Protocol, TypeVar

from .version import __version__

if TYPE_CHECKING:
    import xarray

Given = ParamSpec("Given")
Found = TypeVar("Found")
Found_co = TypeVar("Found_co", covariant=True)
RUNNERS = ("runner", "start_values")
"""Entries that hold a runner's values, by the unit's names."""
SPECTRA = ("eigenvalues", "uncontrollable")
"""Attributes of results that are complex numbers, even if none of them has an imaginary part."""
NAMES = ("version", "model", "build", *RUNNERS)
"""Entries of a record."""


def origin_of(runner: Any = None, *, version: str = __version__) -> dict[str, str]:
    """The version and the runner's model, for a result that records its runners in other entries."""
    origin = {"version": version, "model": "full" if runner is None else runner.model.name}
    return origin | ({"build": runner.model.build} if runner is not None and runner.model.build else {})


def record_of(runner: Any, *varied: str) -> dict[str, Any]:
    """Record of a runner: `version`, `model` and `runner`, without the values that vary in the result."""
    kept = {name: value for name, value in runner.items() if name not in varied}
    return {**origin_of(runner), "runner": kept}


def entries(result: Any, *names: str) -> dict[str, Any]:
    """Attributes of a result for JSON: arrays as lists, `eigenvalues` and other spectra as [re, im]."""
    return {name: _plain(getattr(result, name), name in SPECTRA) for name in names}


def _plain(value: Any, is_complex: bool) -> Any:
    if is_complex:
        return [[float(number.real), float(number.imag)] for number in value]
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, Mapping):
        return dict(value)
    return list(value) if isinstance(value, tuple) else value


def without_record(plain: Mapping[str, Any]) -> dict[str, Any]:
    """A plain object without its record."""
    return {name: value for name, value in plain.items() if name not in NAMES}


def dataset(
    kind: str,
    record: Mapping[str, Any],
    variables: Mapping[str, Any],
    coordinates: Mapping[str, Any],
    **attributes: str | float,
) -> "xarray.Dataset":
    """A result as a dataset, with its kind and its record as attributes."""
    import xarray  # slow to load

    runner: dict[str, Any] = {}
    for name in RUNNERS:
        runner |= record.get(name, {})
    texts = {name: record[name] for name in ("version", "model", "build") if name in record}
    about = {"result": kind, **texts, "runner": json.dumps(runner), **attributes}
    return xarray.Dataset(variables, coordinates, about)


class Search(Protocol[Given, Found_co]):
    """A function that returns a dataset."""

    @property
    def plain(self) -> Callable[Given, Found_co]:
        """The same function, which returns the object that the dataset is made of."""

    def __call__(self, *given: Given.args, **named: Given.kwargs) -> "xarray.Dataset":
        """Call the function."""


def in_dataset(
    convert: Callable[[Found], "xarray.Dataset"],
) -> Callable[[Callable[Given, Found]], Search[Given, Found]]:
    """Make a function return its result as a dataset; its attribute `plain` is the function as written."""

    def decorate(search: Callable[Given, Found]) -> Search[Given, Found]:
        @functools.wraps(search)
        def found(*given: Given.args, **named: Given.kwargs) -> "xarray.Dataset":
            return convert(search(*given, **named))

        signature = inspect.signature(search).replace(return_annotation="xarray.Dataset")
        made: Any = found
        made.plain, made.__signature__ = search, signature
        return made  # type: ignore[no-any-return] # a function with an attribute

    return decorate


def runner_in(data: "xarray.Dataset") -> dict[str, Any]:
    """Values of the runner of a dataset, without those that vary in it, by the unit's names."""
    values: dict[str, Any] = json.loads(data.attrs.get("runner", "{}"))
    return values


def parts_of(data: "xarray.Dataset", part: str) -> "list[xarray.Dataset]":
    """Each `branch` or `curve` of a dataset of points by itself, with what it has only once as scalars."""
    numbers = data[f"{part}_number"].values
    return [data.isel({"point": numbers == k, part: k}) for k in range(data.sizes[part])]
