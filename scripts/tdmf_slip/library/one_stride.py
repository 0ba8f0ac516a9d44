"""One stride of many runners by the ensemble engine, of which the next apex alone is kept."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from .engine import run
from .ensemble import END, TOLERANCE, ensemble_of
from .population import Population
from .recorded_strides import given_settings
from .rough_ground import RoughGround
from .runner import Runner
from .section import COORDINATES


def next_apices(
    runner: Runner,
    apices: NDArray[np.float64],
    settings: Mapping[str, NDArray[np.float64]],
    *,
    tolerance: float = TOLERANCE,
) -> tuple[NDArray[np.int8], NDArray[np.float64]]:
    """Where one stride leads from each of many apices, each with settings of its own."""
    sections = np.zeros((len(apices), len(COORDINATES)))
    sections[:, : apices.shape[1]] = apices
    ensemble = ensemble_of(runner, sections, 0, tolerance, None, None)
    cases, kept = Population(runner).c_cases(RoughGround(), None)
    cases[0].rules.max_strides = 1
    ensemble.cases, ensemble.case_count = cases, 1
    given, values = given_settings({name: row[:, None] for name, row in settings.items()}, 0)
    ensemble.given = given
    ends = np.zeros(len(apices), END)
    run(ensemble, ends, 1)
    del kept, values
    closed = ends["strides"] == 1
    fates = np.where(closed, 0, ends["fate"]).astype(np.int8)
    return fates, np.where(closed[:, None], ends["apex"][:, : apices.shape[1]], np.nan)
