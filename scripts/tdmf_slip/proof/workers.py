"""Work in other processes, side by side: each is a Python of its own that is told what to do by a pipe.

Unlike multiprocessing's, they do not run the caller's program anew, so that it needs no main guard.
"""

import os
import pickle
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from queue import SimpleQueue
from typing import IO, Any

PACKAGE = Path(__file__).resolve().parents[1]
PROGRAM = "from tdmf_slip.proof.workers import work; work()"


def work() -> None:
    """Do what comes by standard input until it ends, and answer by standard output: a worker's whole life."""
    answers, sys.stdout = sys.stdout.buffer, sys.stderr
    while True:
        try:
            function, arguments = pickle.load(sys.stdin.buffer)
        except EOFError:
            return
        _send(answers, _answer(function, arguments))


def _answer(function: Callable[..., Any], arguments: Sequence[Any]) -> tuple[bool, Any]:
    try:
        return True, function(*arguments)
    except Exception as problem:  # it is the asker's, who raises it
        return False, problem


def _send(pipe: IO[bytes], message: Any) -> None:
    pickle.dump(message, pipe)
    pipe.flush()


class _Worker:
    """One process."""

    def __init__(self) -> None:
        paths = [str(PACKAGE.parent), *filter(None, [os.environ.get("PYTHONPATH")])]
        self.process = subprocess.Popen(
            [sys.executable, "-c", PROGRAM],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)},
        )

    def ask(self, function: Callable[..., Any], arguments: Sequence[Any]) -> Any:
        """The function's value there, or its exception here."""
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        _send(self.process.stdin, (function, arguments))
        done, answer = pickle.load(self.process.stdout)
        if not done:
            raise answer
        return answer

    def end(self) -> None:
        """At once."""
        self.process.kill()
        for pipe in (self.process.stdin, self.process.stdout):
            assert pipe is not None
            pipe.close()
        self.process.wait()


def side_by_side(
    function: Callable[..., Any], tasks: Sequence[Sequence[Any]], processes: int
) -> Iterator[Any]:
    """Values of a function, by so many processes."""
    if processes == 1 or len(tasks) < 2:
        for arguments in tasks:
            yield function(*arguments)
        return
    started = [_Worker() for _ in range(min(processes, len(tasks)))]
    idle: SimpleQueue[_Worker] = SimpleQueue()
    for worker in started:
        idle.put(worker)

    def ask(arguments: Sequence[Any]) -> Any:
        worker = idle.get()
        try:
            return worker.ask(function, arguments)
        finally:
            idle.put(worker)

    threads = ThreadPoolExecutor(len(started))
    try:
        yield from threads.map(ask, tasks)
    finally:
        for worker in started:
            worker.end()
        threads.shutdown(cancel_futures=True)
