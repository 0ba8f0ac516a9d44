"""A branch of gaits: its points in their order, what happens on it, and why it ends."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..drawable import Drawable
from ..library.gait import Gait
from ..record import attributes_of
from ..variables.table import VARIABLES
from .bifurcations import Special
from .borders import Border

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True, eq=False, repr=False)
class Branch(Drawable):
    """Gaits in the order in which they were met along a parameter."""

    name: str
    """Of the parameter or input."""
    values: tuple[float, ...]
    """Of the parameter, at each gait."""
    gaits: tuple[Gait, ...]
    """The gaits."""
    borders: tuple[Border, ...]
    """Where the word changes, in the branch's order."""
    specials: tuple[Special, ...]
    """Bifurcations, word borders, and what could not be judged, in the branch's order."""
    began: str
    """Why the branch has no earlier points, in the words of `ended`."""
    ended: str
    """Why the branch stops: at the end of the range, where it began, or in words what happened."""
    strides: int = 1
    """After how many strides its gaits repeat themselves."""
    branches: tuple[Branch, ...] = ()
    """Of gaits of twice as many strides, from the period doublings."""

    def __repr__(self) -> str:
        """In a line: what the branch is of, how long it is, what is on it, and why it stops."""
        kinds = [special.kind for special in self.specials]
        counts = (
            ", ".join(f"{kinds.count(kind)} {kind}" for kind in dict.fromkeys(kinds)) or "nothing special"
        )
        return (
            f"<Branch over {self.name} {self.values[0]:.6g} to {self.values[-1]:.6g}: "
            f"{len(self.gaits)} gaits of {self.strides} strides; {counts}; {self.ended}>"
        )

    def as_json(self) -> dict[str, object]:
        """The branch as a plain object; a point is a gait as `Gait.as_json` tells it, with its `value`."""
        found = zip(self.values, self.gaits, strict=True)
        return {
            **self.gaits[0].runner.record(self.name),
            "over": self.name,
            "strides": self.strides,
            "points": [
                {"value": value, "unstable": gait.unstable, **gait.as_json()} for value, gait in found
            ],
            "specials": [special.as_json() for special in self.specials],
            "began": self.began,
            "ended": self.ended,
            "branches": [branch.as_json() for branch in self.branches],
        }

    def to_xarray(self) -> xarray.Dataset:
        """The branch as a dataset with units, over `point` and, for what happens on it, over `special`.

        Returns
        -------
        xarray.Dataset
            By point the parameter under its name, all numbers of a gait as in a sweep's dataset, the `word`,
            and `unstable`, how many eigenvalues are outside the unit circle; by special point `special_kind`,
            `special_value` and `special_why`.
        """
        from .grid import as_dataset  # xarray is slow to load

        data = as_dataset(self.gaits, {"point": np.arange(len(self.gaits), dtype=float)})
        data[self.name] = ("point",), np.array(self.values)
        data[self.name].attrs = VARIABLES[self.name].attributes
        data["unstable"] = ("point",), np.array([gait.unstable for gait in self.gaits])
        data["unstable"].attrs = {"units": "1", "long_name": "eigenvalues outside the unit circle"}
        data["special_kind"] = ("special",), np.array([s.kind for s in self.specials], dtype=object)
        data["special_value"] = ("special",), np.array([s.value for s in self.specials], dtype=float)
        data["special_why"] = ("special",), np.array([s.why for s in self.specials], dtype=object)
        data["special_value"].attrs = VARIABLES[self.name].attributes
        data.attrs = {
            **attributes_of(self.gaits[0].runner.record(self.name)),
            "over": self.name,
            "strides": self.strides,
            "began": self.began,
            "ended": self.ended,
        }
        return data
