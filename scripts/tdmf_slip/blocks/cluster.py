"""Dask clusters: one that listens at an address, or processes on this machine."""

import asyncio
import contextlib
import logging
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING

from ..errors import InputError, RunError
from ..terminal import interrupts

if TYPE_CHECKING:
    from distributed import Client, LocalCluster

CONNECTING = 10.0
"""Seconds within which a scheduler has to answer."""
SILENCE = logging.CRITICAL + 1
"""Level of Dask's log: what is wrong comes as an exception, the rest is its closing down."""
MERCY = 0.1
"""Seconds that a worker has for its end before it is killed."""


async def kill_workers(cluster: "LocalCluster") -> None:
    """End the processes of a local cluster now: asked to close, they would finish their blocks first."""
    closing = (nanny.close(timeout=MERCY) for nanny in cluster.workers.values())
    await asyncio.gather(*closing, return_exceptions=True)


def has_workers(cluster: "LocalCluster | None") -> bool:
    """Whether anybody is left to work: a worker that cannot read a block ends for good, without a word.

    Of a cluster that is not ours, None, this is not known: its workers come and go.
    """
    from distributed import Status

    ended = (Status.closing_gracefully, Status.closing, Status.closed, Status.failed)
    return cluster is None or any(nanny.status not in ended for nanny in list(cluster.workers.values()))


@contextlib.contextmanager
def client_of(scheduler: str | None, workers: int) -> "Iterator[Client]":
    """A client whose end makes the scheduler forget what it has not done yet.

    Parameters
    ----------
    scheduler : str or None
        Address of a Dask scheduler; None for a cluster of processes on this machine.
    workers : int
        How many processes that has.

    Yields
    ------
    distributed.Client
        Connected.
    """
    try:
        from distributed import Client
        from distributed.utils import silence_logging_cmgr
    except ImportError:
        raise InputError(
            "work on a cluster needs Dask (the extra cluster), which is missing; "
            "install it by: pip install distributed"
        ) from None
    with silence_logging_cmgr(SILENCE), contextlib.ExitStack() as parts:
        if scheduler is not None:
            yield parts.enter_context(_client_at(scheduler))
        else:
            with interrupts.kept_from_children():
                cluster = parts.enter_context(_local_cluster(workers))
                client = parts.enter_context(Client(cluster, set_as_default=False))
            yield client


def _client_at(scheduler: str) -> "Client":
    from distributed import Client

    try:
        _require_handshake(scheduler)
        return Client(scheduler, timeout=CONNECTING, set_as_default=False)
    except (OSError, ValueError, TypeError) as problem:
        raise InputError(
            f"scheduler {scheduler}: no Dask scheduler answers ({problem}); "
            "allowed: an address such as tcp://host:8786"
        ) from problem


def _require_handshake(scheduler: str) -> None:
    """Raise OSError where something else than Dask listens, whose answer a client would await for ever."""
    from distributed.comm.core import connect

    async def shake_hands() -> None:
        comm = await asyncio.wait_for(connect(scheduler, timeout=CONNECTING), CONNECTING)
        await comm.close()

    with ThreadPoolExecutor(1) as thread:  # asyncio may be running in this one, as in a notebook
        try:
            thread.submit(asyncio.run, shake_hands()).result()
        except TimeoutError:
            raise OSError(f"no answer within {CONNECTING:g} s") from None


def _local_cluster(workers: int) -> "LocalCluster":
    import dask
    from distributed import LocalCluster

    try:
        with dask.config.set({"distributed.nanny.pre-spawn-environ.DASK_LOGGING__DISTRIBUTED": "critical"}):
            return LocalCluster(
                n_workers=workers,
                threads_per_worker=1,
                processes=True,
                dashboard_address=None,
                scheduler_kwargs={"dashboard_address": "127.0.0.1:0"},  # any port: another cluster may run
                silence_logs=SILENCE,
            )
    except RuntimeError as problem:
        raise RunError(
            f"no processes could be started for the work ({problem}); a script has to keep what it runs "
            'under if __name__ == "__main__":, or ask for one worker'
        ) from problem
