"""Strides of many runners: each with its apices and quantities."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..labelled import Labelled, LabelledArrays
from ..library.batch import Batch
from ..library.batch_tables import CLOSED, STRIDE_FATES
from ..library.laws import text_of_law
from ..library.quantities import LEDGER
from ..record import attributes_of
from ..variables.table import STATES, VARIABLES


@dataclass(frozen=True, eq=False, repr=False)
class Strides(LabelledArrays):
    """Strides of many runners, each in a row.

    `strides["speed"]` is an array over runners and strides, `strides["next_apex"]` one over coordinates, too.
    """

    @classmethod
    def of(cls, batch: Batch, arrays: Mapping[str, NDArray[Any]], by: Sequence[str]) -> "Strides":
        """Arrays of strides by name, over runners and strides; `by` labels the last axis of derivatives."""
        runner, over = batch.runner, ("runner", "stride", "coordinate")
        found = {}
        for name, values in {**arrays, **batch.varied}.items():
            is_derivative = by and name.endswith("_by")
            axes = (*over[: values.ndim - 1], "by") if is_derivative else over[: values.ndim]
            found[name] = Labelled(axes, values, _attributes(name, values))
        attributes = {**attributes_of(runner.record(*found, *STATES)), "tolerance": batch.tolerance}
        if batch.law is not None:
            attributes["law"] = text_of_law(batch.law)
        if batch.ground.roughness:
            attributes |= {"roughness": batch.ground.roughness, "seed": str(batch.ground.seed)}
        coordinates = {
            "runner": batch.first_number + np.arange(len(batch)),
            "stride": np.arange(arrays["fate"].shape[1]),
            "coordinate": np.array(runner.coordinates),
            **({"by": np.array(by)} if by else {}),
        }
        return cls(
            found, {name: Labelled((name,), values) for name, values in coordinates.items()}, attributes
        )

    @property
    def closed(self) -> int:
        """How many strides closed."""
        return int((self["fate"] == CLOSED).sum())

    def __repr__(self) -> str:
        """In a line: whose, how many, and how many of them closed."""
        runners, strides = self["fate"].shape
        return f"<Strides of {runners:,} runners, {strides:,} each: {self.closed:,} closed>"


def _attributes(name: str, values: NDArray[Any]) -> dict[str, Any]:
    """What an array is, by the names that CF gives it."""
    if name in ABOUT:
        return dict(ABOUT[name])
    reported = VARIABLES.get(f"stride.{name}") or VARIABLES.get(name)
    if reported is None or values.dtype.kind != "f":
        return {}
    return reported.attributes


ABOUT: Mapping[str, Mapping[str, Any]] = {
    **{name: {"units": "J", "long_name": f"{name.replace('_', ' ')} of the stride"} for name in LEDGER},
    "liftoff_angle": {"units": "rad", "long_name": "leg angle at lift-off"},
    "apex": {"long_name": "apex at which the stride begins"},
    "next_apex": {"long_name": "apex at which it closes"},
    "next_apex_by": {"long_name": "derivatives of the next apex by this apex and by parameters"},
    "fate": {
        "flag_values": np.arange(len(STRIDE_FATES), dtype=np.int8),
        "flag_meanings": " ".join(STRIDE_FATES),
        "comment": "fell: the body or the leg is down, or the foot was below a new ground for a whole stride",
    },
}
"""Of arrays that the unit does not report under their names."""
