"""Threads that do work side by side and that nobody has to wait for."""

import threading
from collections.abc import Callable
from concurrent.futures import Future
from queue import SimpleQueue
from types import TracebackType
from typing import Any

from ..uninterrupted import stop_flag, stops_by

Task = tuple[Future[Any], Callable[..., Any], tuple[Any, ...]]


class Threads:
    """So many threads; at the end of the context what is not begun is given up.

    Those of `concurrent.futures` are waited for when Python ends, also after an interrupt; these are not.
    """

    def __init__(self, count: int) -> None:
        """They begin with the context."""
        self._tasks: SimpleQueue[Task | None] = SimpleQueue()
        self._count = count
        self._given_up = stop_flag()

    def __enter__(self) -> "Threads":
        """Have the threads begin, all or none."""
        try:
            for _ in range(self._count):
                threading.Thread(target=self._work, daemon=True).start()
        except BaseException:
            self._give_up()
            raise
        return self

    def __exit__(
        self,
        _kind: type[BaseException] | None,
        _problem: BaseException | None,
        _traceback: TracebackType | None,
    ) -> None:
        """Have the threads end after what they are at, which stops, too, where it looks at its flag."""
        self._give_up()

    def _give_up(self) -> None:
        self._given_up[0] = 1
        for _ in range(self._count):
            self._tasks.put(None)

    def submit(self, work: Callable[..., Any], *arguments: Any) -> Future[Any]:
        """Have work done by the next thread that has nothing to do."""
        future: Future[Any] = Future()
        self._tasks.put((future, work, arguments))
        return future

    def _work(self) -> None:
        stops_by(self._given_up)
        while (task := self._tasks.get()) is not None:
            if self._given_up[0]:
                continue
            future, work, arguments = task
            try:
                future.set_result(work(*arguments))
            except BaseException as problem:  # raised again where the result is asked for
                future.set_exception(problem)
