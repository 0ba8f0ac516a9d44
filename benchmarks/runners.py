"""Runners that start about a gait's apex: what all solvers are given, and by what their errors are judged."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from tdmf_slip.library.batch import Batch
from tdmf_slip.library.fixed_point import settled_gait
from tdmf_slip.library.gait import Gait
from tdmf_slip.library.runner import Runner
from tdmf_slip.library.tables import Table

from .accuracy import fastest

FRICTION = 0.6
CLAMP = "hip.swing_clamp"
"""Name of the parameter that selects the reading of (12)."""
RUNNERS, STRIDES_EACH = 4096, 4
SPREAD = 0.05
"""Largest offset of a start from the gait's apex; all starts make the gait's word."""
JUDGED = 64
"""Starts by which each solver's error is judged, besides the gait's apex."""
TIGHT = 1e-13
"""Tolerance of the native solver that the others are held against."""


@dataclass(frozen=True, eq=False)
class Runners:
    """Runners that start about a gait's apex."""

    gait: Gait
    """Gait that the runners start about."""
    runner: Runner
    """Parameters of all runners."""
    starts: NDArray[np.float64]
    """Apices, shape (runners, n)."""

    @property
    def swing_clamp(self) -> bool:
        """`hip.swing_clamp` of the runners."""
        return bool(self.runner[CLAMP])

    @cached_property
    def judged(self) -> NDArray[np.float64]:
        """The starts by which errors are judged: the gait's apex, and some about it."""
        return np.vstack([self.gait.apex, self.starts[:JUDGED]])

    @cached_property
    def exact(self) -> Table:
        """Ends of one stride from each of `judged`, by the native solver at `TIGHT`."""
        return self.ends("one by one", TIGHT)

    def ends(self, instructions: str, tolerance: float) -> Table:
        """Ends of one stride from each of `judged`, by the ensemble engine: see `Batch.run`."""
        batch = Batch(self.runner, self.judged, tolerance=tolerance, threads=1, instructions=instructions)
        return batch.run(1)

    def error(self, apices: NDArray[np.float64]) -> float:
        """The largest difference from the exact apices, over the scales; infinite where one is no number."""
        known = len(self.runner.coordinates)
        differences = np.abs(apices[:, :known] - self.exact.apex) / self.runner.scales
        return float(np.max(np.where(np.isnan(differences), np.inf, differences)))

    def run(
        self, instructions: str | None, tolerance: float, threads: int, effort: float
    ) -> tuple[float, dict[str, int]]:
        """Seconds for all, making some strides, and the work that was done."""
        count = max(JUDGED, round(effort * len(self.starts))) * threads
        runners = np.resize(self.starts, (count, self.starts.shape[1]))
        work: list[dict[str, int]] = []
        batch = Batch(self.runner, runners, tolerance=tolerance, threads=threads, instructions=instructions)

        def once() -> None:
            work.append(batch.run(STRIDES_EACH).attributes["work_done"])

        return fastest(once), work[0]


def runners_about_the_gait(*, swing_clamp: bool | None = None, reduced: bool = False) -> Runners:
    """Starts drawn about the gait's apex; `swing_clamp` replaces the unit's own value."""
    source = np.random.default_rng(0)
    runner = Runner({"ground.friction": FRICTION}, model="reduced" if reduced else "full")
    if swing_clamp is not None:
        runner = runner.replace({CLAMP: swing_clamp})
    spread = source.uniform(-SPREAD, SPREAD, (RUNNERS, len(runner.coordinates)))
    gait = settled_gait(runner)
    return Runners(gait, runner, gait.apex + spread)
