"""How stable gaits are: by the largest eigenvalue, by what they attract, and by what is recovered from."""

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass

from ..blocks import run_blocks
from ..checks import check_kind
from ..library.gait import Gait, check_is_gait
from .robustness import Robustness, robustness
from .volume import Volume, volume

SAMPLES = 4000
"""Starts drawn for each of many gaits."""


@dataclass(frozen=True)
class Attraction:
    """How stable a gait is, by the largest eigenvalue and by what it attracts."""

    friction: float
    """Of the ground."""
    word: str
    """The gait's."""
    lambda_max: float
    """Size of the largest eigenvalue."""
    volume: Volume
    """How much of the box settles on the gait."""
    robustness: Robustness
    """The largest disturbances that the runner recovers from."""


def measure(gait: Gait) -> Attraction:
    """All of it for one gait."""
    check_is_gait(gait, "gait")
    return Attraction(
        gait.friction,
        gait.word,
        gait.lambda_max,
        volume(gait, SAMPLES),
        robustness(gait),
    )


def measure_all(gaits: Sequence[Gait], *, executor: Executor | None = None) -> list[Attraction]:
    """`measure` for many gaits, side by side; see `run_blocks`."""
    check_kind(gaits, Sequence, "gaits", "Gaits in a list, as find_gait gives")
    for gait in gaits:
        check_is_gait(gait, "gaits")
    with run_blocks(measure, gaits, executor) as results:
        return [found for _, found in sorted(results, key=lambda numbered: numbered[0])]
