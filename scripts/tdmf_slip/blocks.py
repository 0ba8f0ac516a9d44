"""Work in blocks that do not depend on each other: here, on all processors, or on any Dask cluster."""

import contextlib
import os
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from typing import Any

from .errors import InputError, RunError

CONNECTING = 10.0
"""Seconds within which a scheduler has to answer."""


def run(
    work: Callable[[Any], Any],
    blocks: Sequence[Any],
    *,
    scheduler: str | None = None,
    workers: int | None = None,
) -> Iterator[tuple[int, Any]]:
    """Do work on each block, wherever there is room, and yield results with their numbers as they come.

    A block that a dying worker leaves behind is done again by another; nothing else is. As with all processes
    that Python starts, a script has to keep what it runs under `if __name__ == "__main__":`.

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
        yield from ((number, work(block)) for number, block in enumerate(blocks))
        return
    with _client(scheduler, here) as client:
        yield from _gathered(client, work, blocks)


def _gathered(client: object, work: Callable[[Any], Any], blocks: Sequence[Any]) -> Iterator[tuple[int, Any]]:
    from distributed import KilledWorker, as_completed  # slow to load, and not always needed

    futures = {
        client.submit(work, block, pure=False, retries=0): number for number, block in enumerate(blocks)
    }
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
    finally:
        with contextlib.suppress(OSError, RuntimeError):
            client.cancel(list(futures), force=True)


@contextlib.contextmanager
def _interrupts_ignored() -> Iterator[None]:
    """Processes that begin inside leave it to this one what an interrupt from the keyboard means."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


@contextlib.contextmanager
def _client(scheduler: str | None, workers: int) -> Iterator[object]:
    from distributed import Client, LocalCluster

    if scheduler is not None:
        try:
            client = Client(scheduler, timeout=CONNECTING)
        except (OSError, ValueError, TypeError) as problem:
            raise InputError(
                f"--scheduler {scheduler}: no Dask scheduler answers ({problem}); "
                "allowed: an address such as tcp://host:8786"
            ) from problem
        with client:
            yield client
        return
    try:
        with _interrupts_ignored():
            cluster = LocalCluster(
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
    with cluster, Client(cluster) as client:
        yield client
