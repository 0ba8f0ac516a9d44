"""Gaits along a parameter as tables, for figures and statements."""

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
import pandas

from ..analysis.sweeps import Sweep
from ..library.gait import Gait, gaits_dataset
from ..record import runner_in
from ..variables.table import FRICTION

if TYPE_CHECKING:
    import xarray


def gait_table(gaits: "xarray.Dataset | Sequence[Gait]", *names: str) -> pandas.DataFrame:
    """A row for each gait of a dataset, with all that the dataset has over its gaits.

    Besides, a row has the values of the parameters in `names`, also of those that do not vary, `stable`, and
    the real parts of the two leading eigenvalues, which keep their signs along a branch. Columns of
    parameters are named without the part before the dot.
    """
    if isinstance(gaits, Sequence):
        gaits = gaits_dataset("gaits", gaits, {"gait": np.arange(len(gaits), dtype=float)}, varied=names)
    over, values = gaits["word"].dims, runner_in(gaits)
    columns = [name for name, of in gaits.variables.items() if of.dims == over]
    other, greater = np.sort(gaits["eigenvalue_real"].values[:, :2]).T
    data = gaits[columns].to_dataframe().reset_index()
    data = data.assign(
        **{name: values[name] for name in names if name not in data},
        stable=data["lambda_max"] < 1.0,
        greater_eigenvalue=greater,
        other_eigenvalue=other,
    )
    found = data[data["word"] != ""].reset_index(drop=True)
    return found.rename(columns=lambda name: name.rpartition(".")[2])


def up_to_turn(branch: "xarray.Dataset") -> "xarray.Dataset":
    """A branch up to the greatest value of its parameter, where it first turns back."""
    turns = np.flatnonzero(np.diff(branch[branch.over].values) < 0.0)
    return branch.isel(point=slice(turns[0] + 1)) if len(turns) else branch


def words_over(found: Sweep) -> list[tuple[str, float, float]]:
    """Words of a sweep over friction, and the frictions from which and to which each lasts."""
    gaits = found.gaits.isel({FRICTION: found.gaits["word"].values != ""})
    first, *_, last = gaits[FRICTION].values.tolist()
    edges = [first, *found.borders[FRICTION].values.tolist(), last]
    words = [gaits["word"].values[0], *found.borders["after"].values]
    return [(word, *edge) for word, edge in zip(words, pairwise(edges), strict=True)]
