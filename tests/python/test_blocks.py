"""Blocks of work on Dask: the same results wherever they are computed, and none lost with a worker."""

import concurrent.futures
import contextlib
import functools
import json
import math
import os
import pathlib
import signal
import socket
import subprocess
import sys
import threading
import time

import pytest
import xarray
from conftest import HANGS
from tdmf_slip import InputError, RunError, Runner
from tdmf_slip.analysis import basin, grid
from tdmf_slip.blocks import cluster as clusters
from tdmf_slip.blocks import running as blocks
from tdmf_slip.blocks.running import run_blocks
from tdmf_slip.fmu import batch
from tdmf_slip.terminal import interrupts

BLOCKS = 12


def note(folder, number):
    """A block that leaves a trace of who did it."""
    time.sleep(0.3)
    (folder / f"{number}-{os.getpid()}").touch()
    return number * number


def die(_):
    os.kill(os.getpid(), signal.SIGKILL)


@pytest.fixture
def cluster(tmp_path):
    """A scheduler and two workers, processes of their own; yields its address and all three."""
    file = tmp_path / "scheduler.json"
    run = functools.partial(
        subprocess.Popen,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        env={
            **os.environ,
            "PYTHONPATH": str(pathlib.Path(__file__).parent),  # for `note`
            "DASK_TEMPORARY_DIRECTORY": str(tmp_path),
        },
    )
    dask = (sys.executable, "-m", "dask")
    options = ("--scheduler-file", str(file))
    scheduler = run([*dask, "scheduler", *options, "--port", "0", "--no-dashboard"])
    command = [*dask, "worker", *options, "--nthreads", "1", "--no-dashboard", "--no-nanny"]
    workers = [run(command) for _ in range(2)]
    try:
        yield _address(file, scheduler), scheduler, workers
    finally:
        for process in (*workers, scheduler):
            process.kill()
            process.wait()


def _address(file, scheduler):
    while not (file.exists() and file.read_text()):
        assert scheduler.poll() is None, "the scheduler did not start"
        time.sleep(0.1)
    return json.loads(file.read_text())["address"]


@pytest.mark.skipif(sys.platform == "win32", reason="workers are killed by a POSIX signal")
def test_a_killed_worker_costs_only_its_block(cluster, tmp_path):
    address, _, workers = cluster
    folder = tmp_path / "done"
    folder.mkdir()
    results = {}
    work = functools.partial(note, folder)
    with run_blocks(work, list(range(BLOCKS)), scheduler=address) as found:
        for number, result in found:
            results[number] = result
            if len(results) == 3:
                workers[0].kill()
    assert results == {number: number * number for number in range(BLOCKS)}
    # What the dead worker had begun, and what it had done but not handed over, is all that is done again.
    assert BLOCKS <= len(list(folder.iterdir())) <= BLOCKS + 2


def test_a_scheduler_that_dies_is_said(cluster, tmp_path):
    address, scheduler, _ = cluster
    work = functools.partial(note, tmp_path)
    with (
        pytest.raises(RunError, match="scheduler is gone"),
        run_blocks(work, list(range(BLOCKS)), scheduler=address) as found,
    ):
        assert next(found)[1] >= 0
        scheduler.kill()
        list(found)


def test_a_block_that_kills_its_workers_is_said(tmp_path):
    """Here the second one that dies ends it, by a setting of Dask's; a worker takes seconds to begin."""
    import dask
    from distributed import LocalCluster

    two = {"n_workers": 2, "threads_per_worker": 1, "dashboard_address": "127.0.0.1:0"}
    with (
        dask.config.set({"distributed.scheduler.allowed-failures": 1, "temporary-directory": str(tmp_path)}),
        LocalCluster(**two) as cluster,
        pytest.raises(RunError, match="killed every worker"),
        run_blocks(die, [0, 1], scheduler=cluster.scheduler_address) as found,
    ):
        list(found)


def test_a_script_needs_no_guard(tmp_path):
    """Nor does it start a process or open a port, with as many threads as there are processors."""
    script = tmp_path / "script.py"
    script.write_text(
        "import socket, subprocess, sys\n"
        "import fmpy, tdmf_slip\n"  # FMPy asks ldconfig where libraries are
        "def refused(*given, **named): raise SystemExit('a process or a port')\n"
        "socket.socket.bind = subprocess.Popen.__init__ = refused\n"
        "found = tdmf_slip.strides_to_fall({'ground.friction': 0.2}, roughness=0.5, runners=20, threads=2)\n"
        "print(found.falls > 0, {'distributed', 'concurrent.futures.process'} & set(sys.modules))\n"
    )
    done = subprocess.run([sys.executable, script], capture_output=True, text=True, timeout=HANGS)
    assert (done.returncode, done.stdout.strip()) == (0, "True set()"), done.stderr


def test_what_a_thread_raises_is_raised_here():
    with run_blocks(math.sqrt, [4.0, 9.0], threads=2) as found:
        assert sorted(found) == [(0, 2.0), (1, 3.0)]
    with (
        pytest.raises(ValueError, match="math domain"),
        run_blocks(math.sqrt, [4.0, -1.0], threads=2) as found,
    ):
        list(found)


def test_a_cluster_gives_the_same_map(cluster, fmu):
    address, *_ = cluster
    runner = Runner.of({}, fmu)
    axes = {"com_height": (1.2, 2.9), "com_speed": (0.9, 1.6)}
    here = basin.basin(runner, axes, (6, 5), threads=1, fmu=fmu)
    there = basin.basin(runner, axes, (6, 5), scheduler=address, fmu=fmu)
    assert here == there


def test_a_grid_of_gaits_is_the_same_by_two_threads(fmu, tmp_path):
    runner, frictions, dampings = Runner.of({}, fmu), [0.6, 0.5], [0.2, 0.22, 0.25]
    grids = [
        grid.grid(
            runner,
            {"ground.friction": frictions, "leg.damping": dampings},
            tmp_path / f"{threads}.nc",
            threads=threads,
            fmu=fmu,
        )
        for threads in (1, 2)
    ]
    xarray.testing.assert_identical(*grids)


def test_a_batch_of_units_is_the_same_by_two_threads(fmu):
    table = [{"ground.friction": mu} for mu in (1.2, 0.6, 0.2)]
    one, two = (batch.simulate_many(table, strides=3, threads=threads, fmu=fmu) for threads in (1, 2))
    assert one == two
    assert list(one["count"]) == [3, 3, 3]
    assert list(one["ground.friction"]) == [1.2, 0.6, 0.2]
    assert one.variables["period"].attributes["units"] == "s"
    assert (one["problem"] == "").all()


def test_a_run_that_fails_leaves_the_others(fmu):
    """A runner that falls is a result; one that closes no stride has its reason written beside it."""
    table = [{"leg.angle": 1.0}, {"hip.touchdown_angle": 0.2}]
    runs = batch.simulate_many(table, strides=2, threads=1, fmu=fmu)
    together = batch.simulate_many([{"leg.length": 1.0}, {"leg.length": 0.01}], strides=1, threads=1, fmu=fmu)
    assert together["problem"][0] == "" and "leg.length" in together["problem"][1]
    assert runs["problem"][0] == "" and runs["period"][0] > 0.0
    assert runs["fallen"][1] or runs["problem"][1]


def test_who_listens_and_is_no_scheduler_is_not_waited_for(monkeypatch):
    monkeypatch.setattr(clusters, "CONNECTING", 1.0)
    with socket.create_server(("127.0.0.1", 0)) as silent:
        address = f"tcp://127.0.0.1:{silent.getsockname()[1]}"
        with (
            pytest.raises(InputError, match="no answer within 1 s"),
            run_blocks(abs, [1], scheduler=address),
        ):
            pass


INTERRUPT_AT = """
import os, signal, sys
from tdmf_slip.analysis import grid
from tdmf_slip.blocks import running
from tdmf_slip.cli import main as command

def interrupting(module, name):
    honest = getattr(module, name)
    calls = []
    def function(*given, **named):
        calls.append(name)
        if len(calls) == 1:
            os.killpg(0, signal.SIGINT)  # to all processes, as a terminal does
        return honest(*given, **named)
    setattr(module, name, function)

def main():
    for place in sys.argv[1].split():
        module, name = place.split(".")
        interrupting({"running": running, "grid": grid, "os": os}[module], name)
    return command.main(sys.argv[2:])

if __name__ == "__main__":
    sys.exit(main())
"""
INTERRUPTED = "tdmf-slip: interrupted"


def no_more_than_a_bar(lines, what):
    """A bar of progress, drawn again every ten seconds and wiped out at the end, and nothing else."""
    return all(line.startswith(f"{what}: ") or not line.strip() for line in lines)


def interrupted(program, folder, *arguments):
    """Runs a program that interrupts itself; returns its status and what it said, line by line."""
    script = folder.parent / "interrupted.py"
    script.write_text(program)
    with subprocess.Popen(
        [sys.executable, script, *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        cwd=folder,
        start_new_session=True,
    ) as running:
        try:
            out, said = running.communicate(timeout=HANGS)
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(running.pid, signal.SIGKILL)  # nothing is left of it, whatever happens
    assert out == ""
    assert "Traceback" not in said and "resource_tracker" not in said, said
    return running.returncode, said.strip().splitlines()


@pytest.mark.skipif(sys.platform == "win32", reason="the interrupt is a POSIX signal")
@pytest.mark.parametrize(
    ("functions", "left"),
    [
        ("running.Threads", []),
        ("running._next_done", []),
        ("grid.write_dataset", []),
        ("os.replace", ["grid.nc"]),
    ],
)
def test_an_interrupt_ends_a_grid_and_leaves_whole_rows(functions, left, tmp_path):
    """While threads start, compute, or a row is written."""
    folder = tmp_path / "folder"
    folder.mkdir()
    grid = ("sweep", "--friction", "0.5:0.6:2", "--vary", "leg.damping=0.1:0.3:500", "--output", "grid.nc")
    status, said = interrupted(INTERRUPT_AT, folder, functions, *grid, "--threads", "2")
    assert status == 130
    assert said[-1].endswith(INTERRUPTED) and no_more_than_a_bar(said[:-1], "sweep"), said
    assert [path.name for path in folder.iterdir()] == left
    for name in left:
        rows = xarray.load_dataset(folder / name)
        assert 1 <= rows["done"].sum() < 500
        assert (rows["period"].notnull().all("ground.friction") == (rows["done"] == 1)).all()


@pytest.mark.skipif(sys.platform == "win32", reason="the interrupt is a POSIX signal")
@pytest.mark.parametrize("functions", ["running.Threads", "running._next_done"])
def test_an_interrupt_ends_a_map(functions, tmp_path):
    folder = tmp_path / "folder"
    folder.mkdir()
    options = ("--n", "128", "--samples", "0", "--output", "map.nc", "--threads", "2")
    status, said = interrupted(INTERRUPT_AT, folder, functions, "basin", *options)
    assert status == 130
    assert said[-1].endswith(INTERRUPTED) and no_more_than_a_bar(said[:-1], "basin"), said
    assert list(folder.iterdir()) == []


ENDLESS_BLOCKS = """
import os, pathlib, signal, sys, threading, time
from tdmf_slip.blocks.running import run_blocks

def endless(number):
    pathlib.Path(f"begun-{number}").touch()
    while True:
        time.sleep(0.01)

def interrupt():
    while len(list(pathlib.Path().glob("begun-*"))) < 2:
        time.sleep(0.01)
    os.killpg(0, signal.SIGINT)

def main():
    threading.Thread(target=interrupt).start()
    try:
        with run_blocks(endless, range(10), threads=2) as found:
            list(found)
    except KeyboardInterrupt:
        sys.exit("ended")

if __name__ == "__main__":
    main()
"""


@pytest.mark.skipif(sys.platform == "win32", reason="the interrupt is a POSIX signal")
def test_an_interrupt_waits_for_no_block(tmp_path):
    """Of threads that are at one, Python's end is not kept waiting either."""
    folder = tmp_path / "folder"
    folder.mkdir()
    assert interrupted(ENDLESS_BLOCKS, folder) == (1, ["ended"])


def test_threads_are_left_before_their_blocks_are_done():
    """Without an interrupt, too: what is not wanted any more is not waited for, and what waits not begun."""
    end, begun = threading.Event(), []

    def work(number):
        begun.append(number)
        if number:
            end.wait()
        return number

    with run_blocks(work, range(20), threads=2) as found:
        assert next(found) == (0, 0)
    assert set(begun) <= {0, 1, 2}
    end.set()


def test_no_more_blocks_are_in_hand_than_are_needed(tmp_path, monkeypatch):
    handed = []

    def submit(block, **_):
        future = concurrent.futures.Future()
        future.release = lambda: None
        future.set_result(block * block)
        handed.append(block)
        return future

    pending = {}
    results = blocks._as_they_come(submit, list(range(10)), 3, pending)
    assert next(results) == (0, 0) and handed == [0, 1, 2] and len(pending) == 2
    assert next(results) == (1, 1) and handed == [0, 1, 2, 3] and len(pending) == 2
    assert list(results) == [(number, number * number) for number in range(2, 10)]
    assert handed == list(range(10)) and not pending


def test_an_interrupt_is_delivered_once_and_where_it_is_asked_for():
    with interrupts.deferred() as interrupt:
        signal.raise_signal(signal.SIGINT)
        with pytest.raises(KeyboardInterrupt):
            interrupt.deliver()
        interrupt.deliver()
    with pytest.raises(KeyboardInterrupt), interrupts.deferred():
        with interrupts.deferred():
            signal.raise_signal(signal.SIGINT)
        held_by_the_outer = True
    assert held_by_the_outer


def test_wrong_arguments_are_said(fmu):
    with (
        pytest.raises(InputError, match="no Dask scheduler answers"),
        run_blocks(abs, [1, 2], scheduler="nonsense://here"),
    ):
        pass
    with (
        pytest.raises(InputError, match="one of them"),
        run_blocks(abs, [1], scheduler="tcp://a:1", threads=2),
    ):
        pass
    with pytest.raises(InputError, match="threads = 0 is not allowed"), run_blocks(abs, [1, 2], threads=0):
        pass
    with pytest.raises(InputError, match="runners: none; allowed"):
        batch.simulate_many([], strides=1, fmu=fmu)
    with pytest.raises(InputError, match="runner 1"):
        batch.simulate_many([{"ground.friction": 0.6}, {"ground.friction": -1.0}], strides=1, fmu=fmu)
