"""Work in blocks that do not depend on each other: here, on all processors, or on any Dask cluster."""

import contextlib
import functools
import itertools
import os
from collections.abc import Callable, Iterator, Sequence
from queue import Empty, SimpleQueue
from typing import TYPE_CHECKING, Any, TypeVar

from ..errors import InputError, RunError
from ..terminal import interrupts
from .cluster import client_of, has_workers, kill_workers

if TYPE_CHECKING:
    from distributed import Future, LocalCluster

Block = TypeVar("Block")
Result = TypeVar("Result")

IN_HAND = 8
"""Blocks that a local cluster has for each of its workers, so that none waits while a result is written."""
LOOKING_UP = 0.1
"""Seconds after which a wait for results looks whether an interrupt came."""


@contextlib.contextmanager
def run_blocks(
    work: Callable[[Block], Result],
    blocks: Sequence[Block],
    *,
    scheduler: str | None = None,
    workers: int | None = None,
) -> Iterator[Iterator[tuple[int, Result]]]:
    """Do work on each block, wherever there is room; a context that gives numbers and results as they come.

    What is not done at its end is given up. A block that a dying worker leaves behind is done again by
    another; nothing else is. As with all processes that Python starts, a script has to keep what it runs
    under `if __name__ == "__main__":`.

    Parameters
    ----------
    work : callable
        A function that can be pickled, of one block.
    blocks : sequence
        What it is called with; has to be picklable, as the results have.
    scheduler : str, optional
        Address of a Dask scheduler; this package has to be installed where it and its workers run. Without
        one, a cluster of processes on this machine.
    workers : int, optional
        Processes of that cluster, by default one for each processor. One needs no cluster.

    Yields
    ------
    iterator of (int, result)
        The number of a block and what the work on it gave, as they come.

    Raises
    ------
    InputError
        No scheduler answers, there are less than one worker, or both of them are given.
    RunError
        A block killed every worker that tried it, no worker can read the work, the cluster cannot run it, the
        scheduler is gone, or no process can be started.
    """
    if workers is not None and (not isinstance(workers, int) or workers < 1):
        raise InputError(f"workers {workers!r}: allowed: a whole number, 1 or more")
    if workers is not None and scheduler is not None:
        raise InputError("workers and scheduler: allowed: one of them, a scheduler has workers of its own")
    here = min(workers or os.cpu_count() or 1, max(1, len(blocks)))
    if scheduler is None and here == 1:
        yield ((number, work(block)) for number, block in enumerate(blocks))
        return
    at_once = len(blocks) if scheduler is not None else IN_HAND * here
    pending: dict[Future[Any], int] = {}
    with interrupts.held() as interrupt, client_of(scheduler, here) as client:
        try:
            submit = functools.partial(client.submit, work)
            yield _as_they_come(submit, blocks, at_once, pending, interrupt, client.cluster)
        finally:
            if pending and client.cluster is not None:
                client.cluster.sync(kill_workers, client.cluster)


def _as_they_come(
    submit: "Callable[..., Future[Any]]",
    blocks: Sequence[Any],
    at_once: int,
    pending: "dict[Future[Any], int]",
    interrupt: interrupts.Interrupt,
    cluster: "LocalCluster | None" = None,
) -> Iterator[tuple[int, Any]]:
    """Results with the numbers of their blocks, of which so many are pending, as futures, at a time."""
    waiting = enumerate(blocks)
    done: SimpleQueue[Future[Any]] = SimpleQueue()
    while True:
        for number, block in itertools.islice(waiting, at_once - len(pending)):
            interrupt.deliver()
            future = submit(block, pure=False, retries=0)
            pending[future] = number
            future.add_done_callback(done.put)
        if not pending:
            return
        future = _next_done(done, interrupt, cluster)
        result = _result(future)
        future.release()
        yield pending.pop(future), result


def _next_done(
    done: "SimpleQueue[Future[Any]]", interrupt: interrupts.Interrupt, cluster: "LocalCluster | None"
) -> "Future[Any]":
    """The wait is where an interrupt does no harm."""
    while True:
        interrupt.deliver()
        with contextlib.suppress(Empty):
            return done.get(timeout=LOOKING_UP)
        if not has_workers(cluster):
            raise RunError(
                "every process that was started for the work has ended, and blocks are left: it could not "
                "import what they are made of, as it says above, or was ended from outside"
            )


def _result(future: "Future[Any]") -> Any:
    from distributed.client import FutureCancelledError  # slow to load, and not always needed
    from distributed.comm.core import CommClosedError
    from distributed.scheduler import KilledWorker

    try:
        return future.result()
    except (FutureCancelledError, CommClosedError) as problem:
        raise RunError("the scheduler is gone, and what it had not done yet with it") from problem
    except KilledWorker as problem:
        raise RunError(f"a block killed every worker that tried it: {problem}") from problem
    except RuntimeError as problem:
        raise RunError(f"the cluster cannot run this: {problem}") from problem
