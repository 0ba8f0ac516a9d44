"""Arrays by name over named dimensions, with units: what many runners did, without a library of datasets."""

import importlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from .drawable import Drawable
from .errors import InputError

if TYPE_CHECKING:
    import xarray

Own = TypeVar("Own", bound="LabelledArrays")


@dataclass(frozen=True, eq=False)
class Labelled:
    """An array, and what its axes and its values are."""

    dimensions: tuple[str, ...]
    """Names of its axes."""
    values: NDArray[Any]
    """Numbers or texts."""
    attributes: Mapping[str, Any] = field(default_factory=dict)
    """Its unit and description, by the names that CF gives them: `units`, `long_name`."""


@dataclass(frozen=True, eq=False, repr=False)
class LabelledArrays(Drawable):
    """Arrays by name over named dimensions; `result["speed"]` is one of them."""

    variables: Mapping[str, Labelled]
    """What was found."""
    coordinates: Mapping[str, Labelled]
    """Over what it was looked for."""
    attributes: Mapping[str, Any]
    """What holds for all of it, such as the runner's parameters."""

    def __getitem__(self, name: str) -> NDArray[Any]:
        """An array by its name."""
        found = self.variables.get(name) or self.coordinates.get(name)
        if found is None:
            raise InputError(f"{name!r} is not an array of this result; allowed: {', '.join(self.keys())}")
        return found.values

    def __iter__(self) -> Iterator[str]:
        """Over the names of all arrays."""
        return iter(self.keys())

    def __contains__(self, name: object) -> bool:
        """Whether there is such an array."""
        return name in self.variables or name in self.coordinates

    def keys(self) -> tuple[str, ...]:
        """The names of all arrays.

        Returns
        -------
        tuple of str
            Those that were found, then those of the coordinates.
        """
        return (*self.variables, *self.coordinates)

    @property
    def sizes(self) -> dict[str, int]:
        """How long each dimension is, by its name."""
        arrays = (*self.variables.values(), *self.coordinates.values())
        return {
            name: size
            for array in arrays
            for name, size in zip(array.dimensions, array.values.shape, strict=True)
        }

    def with_arrays(self: Own, **arrays: Labelled) -> Own:
        """The same with further arrays."""
        return replace(self, variables={**self.variables, **arrays})

    def with_attributes(self: Own, attributes: Mapping[str, Any]) -> Own:
        """The same with further attributes."""
        return replace(self, attributes={**self.attributes, **attributes})

    def to_xarray(self) -> "xarray.Dataset":
        """All arrays as a dataset, which `to_netcdf` writes to a file.

        Returns
        -------
        xarray.Dataset
            With the same names, dimensions and attributes.

        Raises
        ------
        InputError
            The library xarray is missing.
        """
        datasets = importlib.import_module(f"{__package__}.files.datasets")
        data: xarray.Dataset = datasets.xarray.Dataset(
            {name: _entry(array) for name, array in self.variables.items()},
            {name: _entry(array) for name, array in self.coordinates.items()},
            dict(self.attributes),
        )
        return data

    @classmethod
    def of_dataset(cls: type[Own], data: "xarray.Dataset") -> Own:
        """The same of a dataset, such as a file holds."""
        return cls(
            {str(name): _labelled(array) for name, array in data.data_vars.items()},
            {str(name): _labelled(array) for name, array in data.coords.items()},
            {str(name): value for name, value in data.attrs.items()},
        )

    def _shown(self) -> dict[str, Any]:
        """Each array by its dimensions and range."""
        return {name: _summary(array) for name, array in {**self.coordinates, **self.variables}.items()}


def _entry(array: Labelled) -> tuple[tuple[str, ...], NDArray[Any], dict[str, Any]]:
    return array.dimensions, array.values, dict(array.attributes)


def _labelled(array: "xarray.DataArray") -> Labelled:
    return Labelled(tuple(map(str, array.dims)), array.values, dict(array.attrs))


def _summary(array: Labelled) -> str:
    values, over = array.values, ", ".join(array.dimensions)
    if values.dtype.kind not in "iuf":
        return f"({over}) {len(np.unique(values.astype(str)))} different"
    known = values[np.isfinite(values)]
    if not known.size:
        return f"({over}) nothing"
    return f"({over}) {known.min():.6g} to {known.max():.6g} {array.attributes.get('units', '')}".rstrip()
