"""Many runners: the ensemble engine by its instruction sets, over threads, and heyoka's batches."""

import functools
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from tdmf_slip.library.batch import TOLERANCE
from tdmf_slip.library.section import COORDINATES

from .accuracy import REPEATS, fastest, loosest
from .one_runner import STRIDES
from .results import ALONE, MANY, Measurement
from .runners import Runners

if TYPE_CHECKING:
    from .peers.heyoka_peer import BatchPeer


def measure_lanes(
    many: Runners, instructions: str, effort: float, group: str = MANY, name: str | None = None
) -> Iterator[Measurement]:
    """Time the engine by one instruction set, in one thread; the table's name of it, if another."""
    for accuracy, tolerance, error in loosest(
        instructions, functools.partial(lane_error, many, instructions)
    ):
        seconds, work = many.run(instructions, tolerance, 1, effort)
        yield Measurement(
            group,
            name or instructions,
            accuracy,
            tolerance,
            error,
            work["evaluations"] / work["strides"],
            1e6 * seconds / work["strides"],
        )


def lane_error(many: Runners, instructions: str, tolerance: float) -> float:
    """Error of the apex after one stride by one instruction set, from the worst start."""
    return many.error(many.ends(instructions, tolerance).apex)


def batch_error(many: Runners, tolerance: float) -> float:
    """Error of the apex after one stride by heyoka's batches, from the worst start."""
    from .peers.heyoka_peer import BatchPeer

    full = -(-len(many.judged) // BatchPeer.lanes) * BatchPeer.lanes  # the last batch is filled up
    judged = np.resize(many.judged, (full, len(COORDINATES))).reshape(-1, BatchPeer.lanes, len(COORDINATES))
    peer = BatchPeer(tolerance, many.swing_clamp)
    found = np.concatenate([peer.strides(batch) for batch in judged])
    return many.error(found[: len(many.judged)])


def measure_batches(many: Runners, effort: float) -> Iterator[Measurement]:
    """Time heyoka's batch integrators over the same starts: as a whole, and the integrators alone."""
    from .peers.heyoka_peer import BatchPeer

    batches = many.starts[: len(many.judged) - 1].reshape(-1, BatchPeer.lanes, len(COORDINATES))

    for accuracy, tolerance, error in loosest(BatchPeer.name, functools.partial(batch_error, many)):
        peer = BatchPeer(tolerance, many.swing_clamp)
        rounds = [*batches] * max(1, round(effort * STRIDES["heyoka"] / len(batches)))
        strides = len(rounds) * BatchPeer.lanes
        whole, alone = [], []
        for _ in range(REPEATS):
            peer.seconds = 0.0
            whole.append(fastest(functools.partial(_strides, peer, rounds), 1))
            alone.append(peer.seconds)
        for name, seconds in ((BatchPeer.name, min(whole)), (BatchPeer.name + ALONE, min(alone))):
            yield Measurement(MANY, name, accuracy, tolerance, error, None, 1e6 * seconds / strides)


def _strides(peer: "BatchPeer", rounds: Sequence[NDArray[np.float64]]) -> None:
    for batch in rounds:
        peer.strides(batch)


def measure_scaling(many: Runners, threads: int, effort: float) -> float:
    """Strides a second of each of many threads, over those of one alone."""
    alone, _ = many.run(None, TOLERANCE, 1, effort)
    together, _ = many.run(None, TOLERANCE, threads, effort)
    return alone / together
