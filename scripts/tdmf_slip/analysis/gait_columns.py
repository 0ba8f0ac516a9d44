"""Numbers of a gait as variables of a dataset, with units."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from ..library.gait import LEDGER, Gait
from ..library.quantities import MEASURES, STRIDE_QUANTITIES
from ..library.section import COORDINATES
from ..variables.table import MODELS, VARIABLES


@dataclass(frozen=True)
class Column:
    """A number of a gait, as a variable of a dataset."""

    value_of: Callable[[Gait], float]
    """Reads it off a gait."""
    attributes: Mapping[str, str]
    """Unit and description, by the names that CF gives them."""


def _of_stride(name: str) -> Column:
    """A quantity of the stride; the reduced map measures fewer."""
    return Column(lambda gait: gait.stride.get(name, np.nan), MODELS["full"].quantities[name].attributes)


def _of_apex(index: int) -> Column:
    attributes = VARIABLES[f"apex.{COORDINATES[index]}"].attributes
    return Column(lambda gait: float(gait.section[index]), attributes)


COLUMNS: Mapping[str, Column] = {
    **{name: _of_stride(name) for name in (*STRIDE_QUANTITIES, *LEDGER, *MEASURES)},
    **{f"apex_{name}": _of_apex(i) for i, name in enumerate(COORDINATES)},
    "lambda_max": Column(lambda gait: gait.lambda_max, {"units": "1"}),
}
"""All numbers of a gait, by the names that they have in a dataset."""
