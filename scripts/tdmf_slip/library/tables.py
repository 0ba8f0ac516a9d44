"""Arrays by name over named dimensions, as light as a dictionary: a Dataset costs more than many strides."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from ..errors import InputError

if TYPE_CHECKING:
    import xarray


class Table(Mapping[str, Any]):
    """Arrays by name, each made when it is first read; `table.fate` is `table["fate"]`.

    Parameters
    ----------
    dimensions : mapping of str to tuple of str
        Names of the arrays, and of the dimensions of each.
    make : function of str
        Makes an array by its name.
    labels : function
        Labels of dimensions, by their names.
    units : function of str
        Unit of a column by its name, empty for none.
    attributes : mapping
        Properties of the whole table.
    recorded : Table, optional
        The single strides of these runs.
    """

    def __init__(
        self,
        dimensions: Mapping[str, tuple[str, ...]],
        make: Callable[[str], NDArray[Any]],
        labels: Callable[[], Mapping[str, Any]],
        units: Callable[[str], str],
        attributes: Mapping[str, Any] | None = None,
        recorded: Table | None = None,
    ) -> None:
        self._dimensions, self._make, self._made = dimensions, make, dict[str, Any]()
        self._labels, self._units = labels, units
        self.attributes, self.recorded = attributes or {}, recorded

    def __getitem__(self, name: str) -> Any:
        """An array by its name."""
        if name not in self._made:
            if name not in self._dimensions:
                raise InputError(f"{name!r} is no array of this table; allowed: {', '.join(self)}")
            self._made[name] = self._make(name)
        return self._made[name]

    def __getattr__(self, name: str) -> Any:
        """An array by its name, as an attribute."""
        if name.startswith("_") or name not in self._dimensions:
            raise AttributeError(f"no array {name!r}; arrays: {', '.join(self)}")
        return self[name]

    def __contains__(self, name: object) -> bool:
        """Whether there is such an array."""
        return name in self._dimensions

    def __iter__(self) -> Iterator[str]:
        """Over the names."""
        return iter(self._dimensions)

    def __len__(self) -> int:
        """The number of arrays."""
        return len(self._dimensions)

    def __dir__(self) -> list[str]:
        """Names of the arrays, too."""
        return [*super().__dir__(), *self]

    def __repr__(self) -> str:
        """The names of the arrays."""
        return f"<Table of {', '.join(self)}>"

    def to_dataset(self) -> xarray.Dataset:
        """The table as a dataset with units.

        Returns
        -------
        xarray.Dataset
            With the same names, dimensions and attributes.

        Raises
        ------
        InputError
            The library xarray is missing.
        """
        datasets = importlib.import_module("..files.datasets", __package__)  # xarray is slow to load
        variables = {}
        for name, dimensions in self._dimensions.items():
            unit = self._units(name)
            variables[name] = (dimensions, self[name], {"units": unit} if unit else {})
        used = {dimension for dimensions in self._dimensions.values() for dimension in dimensions}
        labels = {name: label for name, label in self._labels().items() if name in used}
        data: xarray.Dataset = datasets.xarray.Dataset(variables, labels, dict(self.attributes))
        return data
