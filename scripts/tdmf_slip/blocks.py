"""Independent blocks of work on any `concurrent.futures.Executor`: threads, processes, Dask, loky, MPI.

Without an executor the blocks run in threads of this process, because the C library releases Python's lock.
A flag that the C library looks at ends the blocks that run in this process. Other processes do not see the
flag, so a block takes seconds at most.
"""

import contextlib
import os
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import BrokenExecutor, CancelledError, Executor, Future, ThreadPoolExecutor
from queue import Empty, SimpleQueue
from types import NoneType
from typing import Any, TypeVar

from .checks import check_kind
from .errors import RunError
from .uninterrupted import LOOKING_UP, Flag, in_block, new_flag, stopped_by

Block = TypeVar("Block")
Result = TypeVar("Result")


class InTurn(Executor):
    """Runs each call in this thread when it is submitted."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> "Future[Any]":
        """Future of a call that is over; an interrupt is raised here."""
        future: Future[Any] = Future()
        try:
            future.set_result(fn(*args, **kwargs))
        except Exception as problem:
            future.set_exception(problem)
        return future


def check_executor(executor: object) -> None:
    """Refuse an object that is not an executor."""
    check_kind(
        executor,
        (Executor, NoneType),
        "executor",
        "a concurrent.futures.Executor, as ThreadPoolExecutor(4) or client.get_executor() of Dask",
    )


@contextlib.contextmanager
def run_blocks(
    work: Callable[[Block], Result], blocks: Iterable[Block], executor: Executor | None = None
) -> Iterator[Iterator[tuple[int, Result]]]:
    """Context that yields the number and the result of each block, in the order in which they are done.

    By default the blocks run in as many threads as there are processors, or, within a block of another call,
    in its thread. For executors of other processes, function and blocks have to be picklable.

    A block that fails and an interrupt are raised after the results that were ready before. At the end of
    the context, waiting blocks are cancelled, and the flag ends blocks that run in this process.
    """
    check_executor(executor)
    flag = new_flag()
    pending: dict[Future[Result], int] = {}
    with contextlib.ExitStack() as stack:
        if executor is None:
            executor = InTurn() if in_block() else stack.enter_context(ThreadPoolExecutor(os.cpu_count()))
        stack.callback(_cancel, flag, pending)
        yield _as_they_come(work, blocks, executor, flag, pending)


def in_order(
    results: Iterable[tuple[int, Result]], block_done: Callable[[int], object] = lambda _: None
) -> list[Result]:
    """Results in the order of the blocks; `block_done` is called with each number."""
    found: dict[int, Result] = {}
    for number, result in results:
        found[number] = result
        block_done(number)
    return [found[number] for number in range(len(found))]


def _cancel(flag: Flag, pending: "dict[Future[Any], int]") -> None:
    flag[0] = 1
    for future in list(pending):
        future.cancel()


def _as_they_come(
    work: Callable[[Block], Result],
    blocks: Iterable[Block],
    executor: Executor,
    flag: Flag,
    pending: "dict[Future[Result], int]",
) -> Iterator[tuple[int, Result]]:
    done: SimpleQueue[Future[Result]] = SimpleQueue()
    try:
        for number, block in enumerate(blocks):
            future = executor.submit(_run, flag, work, block)
            pending[future] = number
            future.add_done_callback(done.put)
            yield from _ready(done, pending)
        while pending:
            future = _next_done(done)
            yield pending.pop(future), _result_of(future)
            yield from _ready(done, pending)
    except GeneratorExit:
        raise
    except BaseException:
        _cancel(flag, pending)
        yield from _ready(done, pending, is_failing=True)
        raise


def _run(flag: Flag, work: Callable[[Block], Result], block: Block) -> Result:
    with stopped_by(flag):
        return work(block)


def _ready(
    done: "SimpleQueue[Future[Result]]", pending: "dict[Future[Result], int]", *, is_failing: bool = False
) -> Iterator[tuple[int, Result]]:
    """Results that need not be waited for; after a failure, without blocks that failed or were cancelled."""
    with contextlib.suppress(Empty):
        while True:
            future = done.get_nowait()
            number = pending.pop(future)
            if not (is_failing and (future.cancelled() or future.exception() is not None)):
                yield number, _result_of(future)


def _next_done(done: "SimpleQueue[Future[Result]]") -> "Future[Result]":
    """Wait in short pieces: on Windows an interrupt does not end a wait."""
    while True:
        with contextlib.suppress(Empty):
            return done.get(timeout=LOOKING_UP)


def _result_of(future: "Future[Result]") -> Result:
    try:
        return future.result()
    except CancelledError as problem:
        raise RunError(
            "the executor cancelled a block: it was shut down, or its scheduler is gone"
        ) from problem
    except BrokenExecutor as problem:
        raise RunError(f"the executor lost a block with its worker: {problem}") from problem
