"""Work in blocks that do not depend on each other: here, by threads, or on any Dask cluster."""

import contextlib
import functools
import itertools
from collections.abc import Callable, Iterator, Sequence
from queue import Empty, SimpleQueue
from types import NoneType
from typing import TYPE_CHECKING, Any, TypeVar

from ..checks import check_kind, checked_threads
from ..errors import InputError, RunError
from ..uninterrupted import LOOKING_UP
from .cluster import client_of
from .threads import Threads

if TYPE_CHECKING:
    from concurrent.futures import Future

Block = TypeVar("Block")
Result = TypeVar("Result")

IN_HAND = 2
"""Blocks that are given to each thread at a time, so that none waits while a result is written."""


@contextlib.contextmanager
def run_blocks(
    work: Callable[[Block], Result],
    blocks: Sequence[Block],
    *,
    scheduler: str | None = None,
    threads: int | None = None,
) -> Iterator[Iterator[tuple[int, Result]]]:
    """Do work on each block, wherever there is room; a context that gives numbers and results as they come.

    What is not begun at its end is given up, and what is begun is not waited for. Here the work is done by
    threads of this process, for the C library and the unit leave Python's lock while they compute. On a
    cluster, a block that a dying worker leaves behind is done again by another; nothing else is.
    """
    if threads is not None and scheduler is not None:
        raise InputError("threads and scheduler: allowed: one of them, a scheduler has workers of its own")
    check_kind(scheduler, (str, NoneType), "scheduler", "the address of a Dask scheduler")
    here = min(checked_threads(threads), max(1, len(blocks)))
    if scheduler is None and here == 1:
        yield ((number, work(block)) for number, block in enumerate(blocks))
        return
    pending: dict[Future[Any], int] = {}
    if scheduler is None:
        with Threads(here) as pool:
            yield _as_they_come(functools.partial(pool.submit, work), blocks, IN_HAND * here, pending)
        return
    with client_of(scheduler) as client:
        submit = functools.partial(client.submit, work, pure=False, retries=0)
        yield _of_cluster(_as_they_come(submit, blocks, len(blocks), pending))


def _as_they_come(
    submit: Callable[..., Any],
    blocks: Sequence[Any],
    at_once: int,
    pending: "dict[Future[Any], int]",
) -> Iterator[tuple[int, Any]]:
    """Results with the numbers of their blocks, of which so many are pending, as futures, at a time."""
    waiting = enumerate(blocks)
    done: SimpleQueue[Future[Any]] = SimpleQueue()
    while True:
        for number, block in itertools.islice(waiting, at_once - len(pending)):
            future = submit(block)
            pending[future] = number
            future.add_done_callback(done.put)
        if not pending:
            return
        future = _next_done(done)
        number = pending.pop(future)
        result = future.result()
        if hasattr(future, "release"):
            future.release()
        yield number, result


def _next_done(done: "SimpleQueue[Future[Any]]") -> "Future[Any]":
    """Wait in short pieces: on Windows an interrupt does not end a wait."""
    while True:
        with contextlib.suppress(Empty):
            return done.get(timeout=LOOKING_UP)


def _of_cluster(results: Iterator[tuple[int, Any]]) -> Iterator[tuple[int, Any]]:
    """The same results, where what is wrong with the cluster is told in a sentence."""
    from distributed.client import FutureCancelledError  # slow to load, and not always needed
    from distributed.comm.core import CommClosedError
    from distributed.scheduler import KilledWorker

    try:
        yield from results
    except (FutureCancelledError, CommClosedError) as problem:
        raise RunError("the scheduler is gone, and what it had not done yet with it") from problem
    except KilledWorker as problem:
        raise RunError(f"a block killed every worker that tried it: {problem}") from problem
    except RuntimeError as problem:
        raise RunError(f"the cluster cannot run this: {problem}") from problem
