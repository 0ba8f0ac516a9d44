"""Progress of long work, on stderr."""

import sys
import threading
from typing import TYPE_CHECKING, NoReturn, TypeAlias

from ..checks import checked_flag

if TYPE_CHECKING:
    from tqdm import tqdm

Bar: TypeAlias = "tqdm[NoReturn]"
"""A progress bar; it is moved on by its `update`."""
LOCK = threading.RLock()
"""Held while a bar is drawn. By default tqdm makes a semaphore of the system, which a process that is killed
would leave behind; each bar is drawn by one process."""
DELAY = 1.0
"""Seconds of work before a bar is drawn."""


def progress_bar(what: str, total: float | None, unit: str, show: bool = True) -> Bar:
    """A progress bar on a terminal, for what takes longer than a second; elsewhere none."""
    show = checked_flag("progress", show)
    from tqdm import tqdm  # slow to load, and not needed for short work

    class OwnBar(tqdm):  # type: ignore[type-arg]
        """tqdm with a lock of its own, and without the thread that watches over bars drawn too seldom."""

        monitor_interval = 0

    OwnBar.set_lock(LOCK)
    on_screen = sys.stderr is not None and sys.stderr.isatty()
    return OwnBar(
        desc=what,
        total=total,
        unit=f" {unit}",
        disable=not (show and on_screen),
        leave=total is None,  # a count without a known total stays on the screen
        file=sys.stderr,
        mininterval=0.2,
        miniters=1,
        delay=DELAY,
        bar_format="{l_bar}{bar}| {n:.0f}/{total:.0f}{unit} [{elapsed}]" if total is not None else None,
    )
