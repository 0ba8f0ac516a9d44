"""Strides of many runners: each with its apices and quantities."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..labelled import Labelled, LabelledArrays
from ..library.gait import LEDGER
from ..library.recorded_strides import CLOSED, STRIDE_FATES, Columns, Request
from ..record import attributes_of, without_record
from ..variables.table import STATES, VARIABLES


@dataclass(frozen=True, eq=False, repr=False)
class Strides(LabelledArrays):
    """Strides of many runners, each in a row.

    `strides["speed"]` is an array over runners and strides, `strides["next_apex"]` one over coordinates, too.
    """

    @classmethod
    def of(cls, request: Request, columns: Columns) -> "Strides":
        """What was asked for, and the columns that were made of it."""
        runner, over = request.population.runner, ("runner", "stride", "coordinate")
        arrays = {
            name: Labelled(over[: values.ndim], values, _attributes(name, values))
            for name, values in columns.items()
        }
        arrays |= {
            name: Labelled(over[:1], values, _attributes(name, values))
            for name, values in request.population.varied.items()
        }
        attributes = {**attributes_of(runner.record(*arrays, *STATES)), "tolerance": request.tolerance}
        if request.law is not None:
            attributes["law"] = json.dumps(without_record(request.law.as_json()))
        if request.ground.roughness:
            attributes |= {"roughness": request.ground.roughness, "seed": str(request.ground.seed)}
        coordinates = {
            "runner": request.first_number + np.arange(len(request.apices)),
            "stride": np.arange(request.strides),
            "coordinate": np.array(runner.coordinates),
        }
        return cls(
            arrays, {name: Labelled((name,), values) for name, values in coordinates.items()}, attributes
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
    "fate": {
        "flag_values": np.arange(len(STRIDE_FATES), dtype=np.int8),
        "flag_meanings": " ".join(STRIDE_FATES),
        "comment": "fell: the body or the leg is down, or the foot was below a new ground for a whole stride",
    },
}
"""Of arrays that the unit does not report under their names."""
