"""Numbers of a gait as variables of a dataset, with units."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from ..fmu.fmu import Fmu
from ..library.gait import LEDGER, Gait
from ..library.measures import MEASURE_UNITS, STRIDE_QUANTITIES
from ..library.section import COORDINATES


@dataclass(frozen=True)
class Column:
    """A number of a gait, as a variable of a dataset."""

    value_of: Callable[[Gait], float]
    """Reads it off a gait."""
    variable: str | None
    """The unit's variable that has its unit and description, if there is one."""
    unit: str = ""
    """Where there is none."""

    def attributes(self, fmu: Fmu) -> dict[str, str]:
        """Unit and description, by the names that CF gives them."""
        return {"units": self.unit} if self.variable is None else fmu.variables[self.variable].attributes


def _of_stride(name: str) -> Callable[[Gait], float]:
    return lambda gait: gait.stride.get(name, np.nan)  # the reduced map measures less


def _of_apex(index: int) -> Callable[[Gait], float]:
    return lambda gait: float(gait.section[index])


COLUMNS: Mapping[str, Column] = {
    **{name: Column(_of_stride(name), f"stride.{name}") for name in STRIDE_QUANTITIES},
    **{name: Column(_of_stride(name), None, "J") for name in LEDGER},
    **{name: Column(_of_stride(name), None, unit) for name, unit in MEASURE_UNITS.items()},
    **{f"apex_{name}": Column(_of_apex(i), f"apex.{name}") for i, name in enumerate(COORDINATES)},
    "lambda_max": Column(lambda gait: gait.lambda_max, None, "1"),
}
"""All numbers of a gait, by the names that they have in a dataset."""
