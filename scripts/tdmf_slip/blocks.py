"""Work in blocks that do not depend on each other: here, on all processors, or on any Dask cluster."""

import asyncio
import contextlib
import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any

from . import interrupts
from .errors import InputError, RunError

CONNECTING = 10.0
"""Seconds within which a scheduler has to answer."""


@contextlib.contextmanager
def run(
    work: Callable[[Any], Any],
    blocks: Sequence[Any],
    *,
    scheduler: str | None = None,
    workers: int | None = None,
) -> Iterator[Iterator[tuple[int, Any]]]:
    """Do work on each block, wherever there is room; a context that gives numbers and results as they come.

    What is not done at its end is given up. A block that a dying worker leaves behind is done again by
    another; nothing else is. As with all processes that Python starts, a script has to keep what it runs
    under `if __name__ == "__main__":`.

    Args:
        work: a function that can be pickled, of one block.
        blocks: what it is called with; has to be picklable, as the results have.
        scheduler: address of a Dask scheduler; this package has to be installed where it and its workers run.
            Without one, a cluster of processes on this machine.
        workers: processes of that cluster, by default one for each processor. One needs no cluster.

    Raises:
        InputError: no scheduler answers, or there are less than one worker.
        RunError: a block killed every worker that tried it, the cluster cannot run the work, or no process
            can be started.
    """
    if workers is not None and workers < 1:
        raise InputError(f"workers {workers}: allowed: 1 or more")
    here = min(workers or os.cpu_count() or 1, max(1, len(blocks)))
    if scheduler is None and here == 1:
        yield ((number, work(block)) for number, block in enumerate(blocks))
        return
    with _client(scheduler, here) as client:
        futures = {
            client.submit(work, block, pure=False, retries=0): number for number, block in enumerate(blocks)
        }
        try:
            yield _as_they_come(futures)
        finally:
            with interrupts.held(), contextlib.suppress(OSError, RuntimeError):
                client.cancel(list(futures), force=True)


def _as_they_come(futures: dict[object, int]) -> Iterator[tuple[int, Any]]:
    """Results with their numbers; futures that have one are taken out."""
    from distributed import KilledWorker, as_completed  # slow to load, and not always needed

    try:
        for future in as_completed(list(futures)):
            result = future.result()
            number = futures.pop(future)
            future.release()
            yield number, result
    except KilledWorker as problem:
        raise RunError(f"a block killed every worker that tried it: {problem}") from problem
    except RuntimeError as problem:
        raise RunError(f"the cluster cannot run this: {problem}") from problem


@contextlib.contextmanager
def _client(scheduler: str | None, workers: int) -> Iterator[object]:
    from distributed import Client

    if scheduler is not None:
        try:
            _require_handshake(scheduler)
            client = Client(scheduler, timeout=CONNECTING)
        except (OSError, ValueError, TypeError) as problem:
            raise InputError(
                f"--scheduler {scheduler}: no Dask scheduler answers ({problem}); "
                "allowed: an address such as tcp://host:8786"
            ) from problem
        with client:
            yield client
        return
    with contextlib.ExitStack() as stack:
        with interrupts.held(), interrupts.kept_from_children():
            cluster = _local_cluster(workers)
            stack.callback(_close, cluster)
            client = Client(cluster)
            stack.callback(_close, client)
        yield client


def _require_handshake(scheduler: str) -> None:
    """Raise OSError where something else than Dask listens, whose answer a client would await for ever."""
    from distributed.core import connect

    async def shake_hands() -> None:
        comm = await asyncio.wait_for(connect(scheduler, timeout=CONNECTING), CONNECTING)
        await comm.close()

    with ThreadPoolExecutor(1) as thread:  # asyncio may be running in this one, as in a notebook
        try:
            thread.submit(asyncio.run, shake_hands()).result()
        except TimeoutError:
            raise OSError(f"no answer within {CONNECTING:g} s") from None


def _local_cluster(workers: int) -> object:
    from distributed import LocalCluster

    try:
        return LocalCluster(
            n_workers=workers,
            threads_per_worker=1,
            processes=True,
            dashboard_address=None,
            silence_logs="ERROR",
        )
    except RuntimeError as problem:
        raise RunError(
            f"no processes could be started for the work ({problem}); a script has to keep what it runs "
            'under if __name__ == "__main__":, or ask for one worker'
        ) from problem


def _close(part: object) -> None:
    """Without a second interrupt, which would leave the cluster's own threads to complain."""
    with interrupts.held():
        part.close()
