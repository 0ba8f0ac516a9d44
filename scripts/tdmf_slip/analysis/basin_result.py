"""A region of attraction: the fate of each start, over two coordinates of the apex section."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..labelled import Labelled, LabelledArrays
from ..library.engine import FATES, SETTLED
from ..library.gait import Gait
from ..record import attributes_of
from ..variables.table import VARIABLES

NOT_YET = -1
STRIDES = "strides_until_known"
"""Name of the variable."""
FOLLOWED = "is_followed"
"""Of a preview."""


@dataclass(frozen=True, eq=False, repr=False)
class Basin(LabelledArrays):
    """The fate of a runner from each start of a slice through a gait's apex.

    `basin["fate"]` is an array over the two coordinates, `basin["com_height"]` the values of one of them.
    """

    @classmethod
    def blank(cls, gait: Gait, along: Mapping[str, NDArray[np.float64]]) -> "Basin":
        """One of which no fate is known yet."""
        axes, shape = tuple(along), tuple(len(values) for values in along.values())
        return cls(
            {
                "fate": Labelled(axes, np.full(shape, NOT_YET, dtype="i4"), FATES_TOLD),
                STRIDES: Labelled(
                    axes,
                    np.zeros(shape, dtype="i4"),
                    {"units": "1", "long_name": "strides closed until the fate was known"},
                ),
            },
            {
                axis: Labelled((axis,), values, VARIABLES[f"apex.{axis}"].attributes)
                for axis, values in along.items()
            },
            {
                **{
                    f"gait_{axis}": float(value)
                    for axis, value in zip(gait.runner.coordinates, gait.apex, strict=True)
                },
                "word": gait.word,
                **attributes_of(gait.runner.record()),
            },
        )

    @property
    def axes(self) -> tuple[str, str]:
        """Names of the two coordinates."""
        first, second = self.variables["fate"].dimensions
        return first, second

    @property
    def settled_share(self) -> float:
        """Which part of the starts settles on the gait."""
        return float(np.mean(self["fate"] == SETTLED))

    @property
    def settled_area(self) -> float:
        """The same part of the slice, in the units of its coordinates."""
        return self.settled_share * float(np.prod([np.ptp(self[axis]) for axis in self.axes]))

    @property
    def counts(self) -> dict[str, int]:
        """Number of starts with each fate, by the names of `library.engine.FATES`."""
        return {name: int((self["fate"] == number).sum()) for number, name in enumerate(FATES)}

    def __repr__(self) -> str:
        """In a line: whose, over what, and how much settles."""
        rows, columns = self["fate"].shape
        return (
            f"<Basin of the gait {self.attributes['word']} at ground.friction = "
            f"{self.attributes['ground.friction']:.6g}: {rows} by {columns} starts over "
            f"{' and '.join(self.axes)}, {self.settled_share:.1%} settle>"
        )


FATES_TOLD: Mapping[str, Any] = {
    "flag_values": np.arange(len(FATES)),
    "flag_meanings": " ".join(FATES),
}
"""What the numbers of `fate` mean, as CF has it."""
