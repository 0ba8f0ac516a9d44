"""Processes that prove side by side."""

import math
import os
import subprocess
import sys

import pytest
from conftest import HANGS

pytest.importorskip("flint")

from tdmf_slip.proof.workers import side_by_side

PROGRAM = """
import math, os
from tdmf_slip.proof.workers import side_by_side
print("begun")
print(list(side_by_side(math.sqrt, [(k * k,) for k in range(5)], 2)))
"""


def test_a_plain_program_needs_no_main_guard(tmp_path):
    program = tmp_path / "program.py"
    program.write_text(PROGRAM, encoding="utf-8")
    ran = subprocess.run([sys.executable, program], capture_output=True, text=True, timeout=HANGS)
    assert ran.stdout.splitlines() == ["begun", "[0.0, 1.0, 2.0, 3.0, 4.0]"]
    assert not ran.stderr


def test_values_come_in_the_order_of_the_tasks_from_other_processes():
    assert list(side_by_side(math.factorial, [(k,) for k in (900, 1, 5)], 2)) == [
        math.factorial(900), 1, 120
    ]  # fmt: skip
    assert os.getpid() not in set(side_by_side(os.getpid, [()] * 3, 2))
    assert set(side_by_side(os.getpid, [()] * 3, 1)) == {os.getpid()}


def test_what_goes_wrong_there_is_raised_here():
    with pytest.raises(ValueError, match="math domain"):
        list(side_by_side(math.sqrt, [(4,), (-1,)], 2))


def test_workers_end_when_nobody_waits_for_them():
    found = side_by_side(os.getpid, [()] * 4, 2)
    worker = next(found)
    found.close()
    with pytest.raises(ProcessLookupError):
        os.kill(worker, 0)
