"""Rough ground: the height of the ground gains a random step at each apex, the same for a seed everywhere."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..checks import checked, checked_whole
from .binding import c

LARGEST = 1e9
"""Roughness, m."""
LAST_SEED = 2**64 - 1
LAST_RUNNER = 2**63 - 1
MOST_STEPS = 2**31 - 1


@dataclass(frozen=True)
class RoughGround:
    """Steps by which the ground's height changes at a runner's apices, the one that it starts from too.

    They are drawn by a counter from the seed, the runner's number and the stride's: results do not depend on
    lanes, threads or workers.
    """

    roughness: float = 0.0
    """Standard deviation of a step, m; their mean is 0."""
    seed: int = 0
    """Of all steps."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        object.__setattr__(self, "roughness", checked("roughness", self.roughness, 0.0, LARGEST))
        object.__setattr__(self, "seed", checked_whole("seed", self.seed, 0, LAST_SEED))

    def steps(self, runner: int, count: int) -> NDArray[np.float64]:
        """The first steps of one runner.

        Parameters
        ----------
        runner : int
            Its number, from 0 on.
        count : int
            How many steps.

        Returns
        -------
        ndarray of float, shape (count,)
            In m, positive upwards: what `ground.height` gains at the start, at the first apex, and so on.

        Raises
        ------
        InputError
            A number is out of range.
        """
        runner = checked_whole("runner", runner, 0, LAST_RUNNER)
        strides = range(checked_whole("count", count, 0, MOST_STEPS))
        return self.roughness * np.array([c.tdmf_ground_step(self.seed, runner, n) for n in strides], float)
