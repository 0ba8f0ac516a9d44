"""Independent blocks of work on any executor, with a bar that counts what is done."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Executor
from contextlib import contextmanager
from typing import TypeVar

from ..blocks import run_blocks
from .progress import Bar, progress_bar

Block = TypeVar("Block")
Result = TypeVar("Result")


MIN_RUNNERS, MAX_RUNNERS = 64, 4096
"""Least and largest number of runners in a block; fewer would leave lanes empty."""


def sizes_of(total: int, largest: int) -> list[int]:
    """Sizes of the blocks into which a total is split."""
    return [min(largest, total - first) for first in range(0, total, largest)]


def largest_block(strides: int, at_once: int) -> int:
    """Number of runners in a block if each makes so many strides, and a block may make `at_once` of them."""
    return min(MAX_RUNNERS, max(MIN_RUNNERS, at_once // strides))


@contextmanager
def in_blocks(
    work: Callable[[Block], Result],
    blocks: Sequence[Block],
    title: str,
    unit: str,
    executor: Executor | None = None,
    progress: bool = False,
    *,
    sizes: Sequence[int] | None = None,
    done: int = 0,
) -> Iterator[Iterator[tuple[int, Result]]]:
    """Context that yields the number and the result of each block, in the order in which they are done.

    `sizes` are the numbers of units in the blocks, by default one in each, and `done` is the number of units
    done before. See `run_blocks` for the executor.
    """
    sizes = [1] * len(blocks) if sizes is None else sizes
    with (
        progress_bar(title, done + sum(sizes), unit, progress) as bar,
        run_blocks(work, blocks, executor) as results,
    ):
        bar.update(done)
        yield _counted(results, sizes, bar)


def _counted(
    results: Iterable[tuple[int, Result]], sizes: Sequence[int], bar: Bar
) -> Iterator[tuple[int, Result]]:
    for number, result in results:
        yield number, result
        bar.update(sizes[number])
