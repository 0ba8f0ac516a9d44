"""An interrupt from the keyboard ends a run of many runners at once, and keeps what is complete."""

import signal
import sys

import numpy as np
import pytest
from conftest import succeed
from tdmf_slip import Batch, find_gait
from tdmf_slip.errors import StoppedError
from tdmf_slip.library.engine import FELL, STOPPED

BETWEEN = 0.02
"""Seconds between looks whether the engine runs."""
LOOKS = 5
"""Looks that see the engine run before the interrupt comes."""

INTERRUPTED = """
import signal

import numpy as np
from tdmf_slip import Batch, find_gait
from tdmf_slip import uninterrupted

gait = find_gait({"ground.friction": 0.6})
starts = np.tile(gait.apex, (10_000, 1))
stopped = left = 0
WAIT = uninterrupted.uninterrupted.__code__


def interrupt(_number, frame):
    global left
    while frame is not None and frame.f_code is not WAIT:
        frame = frame.f_back
    if frame is not None:
        left -= 1
        if left == 0:
            signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.raise_signal(signal.SIGINT)


signal.signal(signal.SIGALRM, interrupt)
for _ in range(20):
    left = 20
    signal.setitimer(signal.ITIMER_REAL, 1e-4, 1e-4)
    try:
        Batch(gait, starts, threads=2).run(2**31 - 1)
    except KeyboardInterrupt:
        stopped += 1
signal.setitimer(signal.ITIMER_REAL, 0.0)
print("stopped", stopped, "times")
"""
"""A program that is interrupted again and again while the engine's thread begins and is waited for."""


def works_beside():
    """True if a thread does work that the main thread waits for."""
    return any(
        frame.f_code.co_name == "engine" and frame.f_back.f_code.co_name == "beside"
        for frame in sys._current_frames().values()
    )


@pytest.fixture
def interrupt_of_the_engine():
    """SIGINT, as from the keyboard, once the engine's thread has been seen at work; nothing else is timed."""
    seen = []

    def look(_number, _frame):
        if works_beside():
            seen.append(True)
        if len(seen) == LOOKS:
            signal.setitimer(signal.ITIMER_REAL, 0.0)
            signal.raise_signal(signal.SIGINT)

    before = signal.signal(signal.SIGALRM, look)
    signal.setitimer(signal.ITIMER_REAL, BETWEEN, BETWEEN)
    yield
    signal.setitimer(signal.ITIMER_REAL, 0.0)
    signal.signal(signal.SIGALRM, before)


@pytest.mark.usefixtures("interrupt_of_the_engine")
@pytest.mark.parametrize("instructions", [None, "one by one"])
def test_an_interrupt_ends_runs_that_have_no_end(instructions):
    """Half of the runners fall at once, the others run for ever; of a hundred thousand few have begun."""
    gait = find_gait({"ground.friction": 0.6, "hip.swing_clamp": True})
    starts = np.tile(gait.apex, (100_000, 1))
    starts[::2, 3] = -1.2
    starts[::2, 0] = 0.6
    with pytest.raises(StoppedError) as stopped:
        Batch(gait, starts, threads=2, instructions=instructions).run(2**31 - 1)
    assert isinstance(stopped.value, KeyboardInterrupt)
    ends = stopped.value.ends
    fell, not_complete = ends["fate"] == FELL, ends["fate"] == STOPPED
    assert (fell | not_complete).all()
    assert fell[::2].any() and not fell[1::2].any() and len(ends) < len(starts)
    whole = Batch(gait, starts[: len(ends)][fell], threads=1, instructions=instructions).run(10)
    for name in ("fate", "strides", "word_code"):
        np.testing.assert_array_equal(ends[fell][name], whole[name])
    assert not_complete.any()
    assert not works_beside()


def test_interrupts_in_quick_succession_leave_nothing_waiting():
    """An exception in the middle of a wait of Python's `threading` could leave a lock held for ever."""
    assert succeed(sys.executable, "-c", INTERRUPTED) == "stopped 20 times\n"
