"""Arrays by name over named dimensions, as light as a dictionary: a Dataset costs more than many strides."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from ..errors import InputError
from ..record import dataset

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
    about : function of str
        Unit and description of an array by its name, by the names that CF gives them.
    record : function
        Version, model and runner, see `record`.
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
        about: Callable[[str], Mapping[str, Any]],
        record: Callable[[], Mapping[str, Any]],
        attributes: Mapping[str, Any] | None = None,
        recorded: Table | None = None,
    ) -> None:
        self._dimensions, self._make, self._made = dimensions, make, dict[str, Any]()
        self._labels, self._about, self._record = labels, about, record
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
        """True if the table has an array of this name."""
        return name in self._dimensions

    def __iter__(self) -> Iterator[str]:
        """Iterate over the names."""
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

    def to_dataset(self, kind: str = "batch") -> xarray.Dataset:
        """The table as a dataset with units.

        Parameters
        ----------
        kind : str, default "batch"
            The dataset's attribute `result`.

        Returns
        -------
        xarray.Dataset
            With the same names and dimensions; attributes of the table that are numbers or texts.
        """
        variables = {name: (over, self[name], self._about(name)) for name, over in self._dimensions.items()}
        used = {dimension for dimensions in self._dimensions.values() for dimension in dimensions}
        labels = {name: label for name, label in self._labels().items() if name in used}
        plain = {name: of for name, of in self.attributes.items() if isinstance(of, str | float | int)}
        return dataset(kind, self._record(), variables, labels, **plain)
