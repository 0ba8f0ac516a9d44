"""Options for the executor of a command: threads or processes of this machine, or a Dask cluster."""

import asyncio
import contextlib
import logging
import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import click

from ..checks import shown
from ..errors import InputError, RunError

if TYPE_CHECKING:
    from distributed import Client

CONNECTING = 10.0
"""Seconds within which a scheduler has to answer."""
CANCELLING = 0.2
"""Seconds for a pool's thread to drop the waiting blocks. It fails on them if its processes end before."""
SILENCE = logging.CRITICAL + 1
"""Level of Dask's log: errors are raised as exceptions, and the rest is about closing the connection."""


WORKERS_OPTIONS = (
    click.option(
        "--workers",
        type=click.IntRange(min=1),
        metavar="N",
        help="Blocks of the work that this machine runs at a time.  [default: one for each processor]",
    ),
    click.option(
        "--scheduler",
        metavar="ADDRESS",
        help="Run the work on the Dask cluster of this scheduler, tcp://host:8786, instead of this machine.",
    ),
)


@dataclass(frozen=True)
class Workers:
    """The options --workers and --scheduler."""

    count: int | None
    """Blocks that this machine runs at a time."""
    scheduler: str | None
    """Address of a Dask scheduler."""

    @property
    def are_given(self) -> bool:
        """True if one of the options is given."""
        return self.count is not None or self.scheduler is not None

    @contextlib.contextmanager
    def executor(self, *, processes: bool = False) -> Iterator[Executor | None]:
        """Executor for the options; None for threads of this machine, one for each processor."""
        if self.scheduler is not None:
            if self.count is not None:
                raise InputError("--workers and --scheduler are both given; allowed: one of them")
            with _cluster(self.scheduler) as executor:
                yield executor
        elif processes:
            with _processes(self.count or os.cpu_count() or 1) as executor:
                yield executor
        elif self.count is not None:
            with ThreadPoolExecutor(self.count) as executor:
                yield executor
        else:
            yield None


class _DeafProcesses(ProcessPoolExecutor):
    """Processes that ignore interrupts even while they start: they inherit the signals blocked here."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> "Future[Any]":
        """Future of a call, for which a process may start."""
        if not hasattr(signal, "pthread_sigmask"):  # on Windows the initializer has to be enough
            return super().submit(fn, *args, **kwargs)
        before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        try:
            return super().submit(fn, *args, **kwargs)
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)


@contextlib.contextmanager
def _processes(count: int) -> Iterator[Executor]:
    """Pool of processes that ignore an interrupt; this process handles it, and ends them."""
    spawn = multiprocessing.get_context("spawn")
    executor = _DeafProcesses(count, spawn, signal.signal, (signal.SIGINT, signal.SIG_IGN))
    try:
        yield executor
    except BaseException:
        threading.Timer(CANCELLING, _terminate_children).start()
        executor.shutdown(cancel_futures=True)
        raise
    executor.shutdown()


def _terminate_children() -> None:
    for process in multiprocessing.active_children():
        process.terminate()


@contextlib.contextmanager
def _cluster(scheduler: str) -> Iterator[Executor]:
    """Executor of a cluster; at the end its scheduler drops the work that it has not done yet."""
    try:
        from distributed.utils import silence_logging_cmgr
    except ImportError:
        raise InputError(
            "work on a cluster needs Dask (the extra cluster), which is missing; "
            "install it by: pip install distributed"
        ) from None
    from distributed.scheduler import KilledWorker

    with silence_logging_cmgr(SILENCE), _client_at(scheduler) as client:
        try:
            yield client.get_executor()
        except KilledWorker as problem:
            raise RunError(f"a block killed every worker that tried it: {problem}") from problem


def _client_at(scheduler: str) -> "Client":
    from distributed import Client

    try:
        _require_handshake(scheduler)
        return Client(scheduler, timeout=CONNECTING, set_as_default=False)
    except (OSError, ValueError, TypeError) as problem:
        raise InputError(
            f"--scheduler {shown(scheduler)}: no Dask scheduler answers ({shown(str(problem))}); "
            "allowed: an address such as tcp://host:8786"
        ) from problem


def _require_handshake(scheduler: str) -> None:
    """Raise OSError if something else than Dask listens: a client would wait for its answer for ever."""
    from distributed.comm.core import connect

    async def shake_hands() -> None:
        comm = await asyncio.wait_for(connect(scheduler, timeout=CONNECTING), CONNECTING)
        await comm.close()

    try:
        asyncio.run(shake_hands())
    except TimeoutError:
        raise OSError(f"no answer within {CONNECTING:g} s") from None
