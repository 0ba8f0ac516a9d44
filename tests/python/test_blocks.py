"""Blocks of work on Dask: the same results wherever they are computed, and none lost with a worker."""

import functools
import json
import os
import pathlib
import signal
import socket
import subprocess
import sys
import time

import numpy as np
import pytest
import xarray
from tdmf_slip import InputError, RunError, basin, batch, blocks, interrupts, sweep
from tdmf_slip.orbit import Runner

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
        env={**os.environ, "PYTHONPATH": str(pathlib.Path(__file__).parent)},  # for `note`
    )
    dask = (sys.executable, "-m", "dask")
    options = ("--scheduler-file", str(file))
    scheduler = run([*dask, "scheduler", *options, "--port", "0", "--no-dashboard"])
    command = [*dask, "worker", *options, "--nthreads", "1", "--no-dashboard", "--no-nanny"]
    workers = [run(command) for _ in range(2)]
    try:
        yield _address(file), scheduler, workers
    finally:
        for process in (*workers, scheduler):
            process.kill()
            process.wait()


def _address(file):
    for _ in range(300):
        if file.exists() and file.read_text():
            return json.loads(file.read_text())["address"]
        time.sleep(0.1)
    raise AssertionError("the scheduler did not start")


@pytest.mark.skipif(sys.platform == "win32", reason="workers are killed by a POSIX signal")
def test_a_killed_worker_costs_only_its_block(cluster, tmp_path):
    address, _, workers = cluster
    folder = tmp_path / "done"
    folder.mkdir()
    results = {}
    work = functools.partial(note, folder)
    with blocks.run(work, list(range(BLOCKS)), scheduler=address) as found:
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
        blocks.run(work, list(range(BLOCKS)), scheduler=address) as found,
    ):
        assert next(found)[1] >= 0
        scheduler.kill()
        list(found)


def test_a_block_that_kills_its_workers_is_said(monkeypatch):
    with pytest.raises(RunError, match="killed every worker"), blocks.run(die, [0, 1], workers=2) as found:
        list(found)


def test_a_script_without_a_guard_is_told(tmp_path):
    script = tmp_path / "script.py"
    script.write_text(
        "from tdmf_slip import blocks\nwith blocks.run(abs, [1, 2], workers=2) as found: print(list(found))\n"
    )
    done = subprocess.run([sys.executable, script], capture_output=True, text=True, timeout=100)
    assert done.returncode != 0 and '__name__ == "__main__"' in done.stderr.splitlines()[-1]


def test_a_cluster_gives_the_same_map(cluster, unit):
    address, *_ = cluster
    runner = Runner.of({}, unit)
    ranges = np.linspace(1.2, 2.9, 6), np.linspace(0.9, 1.6, 5)
    here = basin.basin(runner, ("com_height", "com_speed"), ranges, workers=1, unit=unit)
    there = basin.basin(runner, ("com_height", "com_speed"), ranges, scheduler=address, unit=unit)
    xarray.testing.assert_identical(here, there)


def test_a_grid_of_gaits_is_the_same_by_two_workers(unit, tmp_path):
    runner, frictions, dampings = Runner.of({}, unit), [0.6, 0.5], [0.2, 0.22, 0.25]
    grids = [
        sweep.grid(
            runner, frictions, "leg.damping", dampings, tmp_path / f"{workers}.nc", workers=workers, unit=unit
        )
        for workers in (1, 2)
    ]
    xarray.testing.assert_identical(*grids)


def test_a_batch_of_units_is_the_same_by_two_workers(unit):
    table = [{"ground.friction": mu} for mu in (1.2, 0.6, 0.2)]
    one, two = (batch.run(table, strides=3, workers=workers, unit=unit) for workers in (1, 2))
    xarray.testing.assert_identical(one, two)
    assert list(one["count"].values) == [3, 3, 3]
    assert list(one["ground.friction"].values) == [1.2, 0.6, 0.2]
    assert one["period"].attrs["units"] == "s"
    assert (one["problem"].values == "").all()


def test_a_run_that_fails_leaves_the_others(unit):
    """A runner that falls is a result; one that closes no stride has its reason written beside it."""
    table = [{"leg.angle": 1.0}, {"leg.angle": -1.2}]
    runs = batch.run(table, strides=2, workers=1, unit=unit)
    together = batch.run([{"leg.length": 1.0}, {"leg.length": 0.01}], strides=1, workers=1, unit=unit)
    assert together["problem"].values[0] == "" and "leg.length" in together["problem"].values[1]
    assert runs["problem"].values[0] == "" and runs["period"].values[0] > 0.0
    assert runs["fallen"].values[1] or runs["problem"].values[1]


def test_who_listens_and_is_no_scheduler_is_not_waited_for(monkeypatch):
    monkeypatch.setattr(blocks, "CONNECTING", 1.0)
    with socket.create_server(("127.0.0.1", 0)) as silent:
        address = f"tcp://127.0.0.1:{silent.getsockname()[1]}"
        began = time.monotonic()
        with pytest.raises(InputError, match="no answer within 1 s"), blocks.run(abs, [1], scheduler=address):
            pass
        assert time.monotonic() - began < 30.0


@pytest.mark.skipif(sys.platform == "win32", reason="the interrupt is a POSIX signal")
@pytest.mark.parametrize("pauses", [[0.3], [0.7, 0.2], [1.2, 0.05], [2.0, 0.2]])
def test_an_interrupt_ends_a_grid_and_leaves_whole_rows(pauses, tmp_path):
    """Sent to all processes, as a terminal does, and twice: while workers start, compute, or write."""
    grid = str(tmp_path / "grid.nc")
    command = ["sweep", "--friction", "0.3:1:20", "--over", "leg.damping=0.1:0.3:2000", "--output", grid]
    program = (
        "import sys; from tdmf_slip import command; print('begins', file=sys.stderr, flush=True);"
        f"sys.exit(command.main({command}))"
    )
    with subprocess.Popen(
        [sys.executable, "-c", program],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    ) as running:
        assert running.stderr.readline() == "begins\n"
        for pause in pauses:
            time.sleep(pause)
            os.killpg(running.pid, signal.SIGINT)
        said = running.communicate(timeout=60)[1].strip()
    assert running.returncode == 130
    assert said.splitlines()[-1].endswith("tdmf-slip: interrupted") and len(said.splitlines()) <= 2, said
    assert [path.name for path in tmp_path.iterdir()] in ([], ["grid.nc"])


def test_an_interrupt_is_delivered_once_and_where_it_is_asked_for():
    with interrupts.held() as interrupt:
        signal.raise_signal(signal.SIGINT)
        with pytest.raises(KeyboardInterrupt):
            interrupt.deliver()
        interrupt.deliver()
    with pytest.raises(KeyboardInterrupt), interrupts.held():
        with interrupts.held():
            signal.raise_signal(signal.SIGINT)
        held_by_the_outer = True
    assert held_by_the_outer


def test_wrong_arguments_are_said(unit):
    with (
        pytest.raises(InputError, match="no Dask scheduler answers"),
        blocks.run(abs, [1, 2], scheduler="nonsense://here"),
    ):
        pass
    with (
        pytest.raises(InputError, match="one of them"),
        blocks.run(abs, [1], scheduler="tcp://a:1", workers=2),
    ):
        pass
    with pytest.raises(InputError, match="workers 0"), blocks.run(abs, [1, 2], workers=0):
        pass
    with pytest.raises(InputError, match="table: allowed"):
        batch.run([], strides=1, unit=unit)
    with pytest.raises(InputError, match="row 1"):
        batch.run([{"ground.friction": 0.6}, {"ground.friction": -1.0}], strides=1, unit=unit)
