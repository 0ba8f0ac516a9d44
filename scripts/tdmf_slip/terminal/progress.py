"""Progress of long work, on stderr."""

import sys
import threading
from typing import NoReturn, TypeAlias

from tqdm import tqdm

Bar: TypeAlias = "tqdm[NoReturn]"
"""A progress bar; it is moved on by its `update`."""

# By default tqdm makes a semaphore of the system, which a process that is killed would leave behind; each bar
# is drawn by one process.
tqdm.set_lock(threading.RLock())


def bar(what: str, total: float | None, unit: str, show: bool = True) -> Bar:
    """A progress bar on stderr; rare lines where stderr is not a terminal.

    Parameters
    ----------
    what : str
        What is going on.
    total : float or None
        How many units there will be, or None where nobody knows.
    unit : str
        What is counted.
    show : bool, default True
        False for a bar that prints nothing.
    """
    on_screen = sys.stderr is not None and sys.stderr.isatty()
    return tqdm(
        desc=what,
        total=total,
        unit=f" {unit}",
        disable=not show or sys.stderr is None,
        leave=total is None,  # what took how many is worth keeping where nobody knew
        file=sys.stderr,
        mininterval=0.2 if on_screen else 10.0,
        delay=0.0 if on_screen or total is None else 2.0,
        bar_format="{l_bar}{bar}| {n:.0f}/{total:.0f}{unit} [{elapsed}]" if total is not None else None,
    )
