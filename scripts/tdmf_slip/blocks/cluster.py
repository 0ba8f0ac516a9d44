"""Dask clusters that listen at an address."""

import asyncio
import contextlib
import logging
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING

from ..checks import shown
from ..errors import InputError

if TYPE_CHECKING:
    from distributed import Client

CONNECTING = 10.0
"""Seconds within which a scheduler has to answer."""
SILENCE = logging.CRITICAL + 1
"""Level of Dask's log: what is wrong comes as an exception, the rest is its closing down."""


@contextlib.contextmanager
def client_of(scheduler: str) -> "Iterator[Client]":
    """A client whose end makes the scheduler forget what it has not done yet."""
    try:
        from distributed.utils import silence_logging_cmgr
    except ImportError:
        raise InputError(
            "work on a cluster needs Dask (the extra cluster), which is missing; "
            "install it by: pip install distributed"
        ) from None
    with silence_logging_cmgr(SILENCE), _client_at(scheduler) as client:
        yield client


def _client_at(scheduler: str) -> "Client":
    from distributed import Client

    try:
        _require_handshake(scheduler)
        return Client(scheduler, timeout=CONNECTING, set_as_default=False)
    except (OSError, ValueError, TypeError) as problem:
        raise InputError(
            f"scheduler {shown(scheduler)}: no Dask scheduler answers ({shown(str(problem))}); "
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
