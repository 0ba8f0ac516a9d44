"""Blocks of work on executors: the same results wherever they are computed, and none lost."""

import concurrent.futures
import contextlib
import gc
import json
import multiprocessing
import os
import signal
import socket
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
import tdmf_slip
import xarray
from conftest import HANGS, assert_same, run_python
from tdmf_slip import InputError, RunError
from tdmf_slip.analysis import attraction, basin, first_passage
from tdmf_slip.blocks import InTurn, run_blocks
from tdmf_slip.cli import interrupts
from tdmf_slip.cli import workers as options
from tdmf_slip.fmu import batch
from tdmf_slip.fmu.instance import Experiment, opened
from tdmf_slip.library.batch import Batch
from tdmf_slip.terminal import in_blocks
from tdmf_slip.uninterrupted import check_stop
from tdmf_slip.viable_sets import grid, viability

FRICTION, DAMPING = "ground.friction", "leg.damping"
KINDS = ("in turn", "threads", "processes", "dask")
AXES = {"com_height": (1.2, 2.9), "com_speed": (0.9, 1.6)}
PLACES = {
    "axes": {"com_height": (1.0, 2.0), "com_speed": (0.6, 1.6)},
    "vary": {"hip.touchdown_angle": (0.3, 1.1, 12)},
}


@pytest.fixture(scope="module")
def executors(tmp_path_factory):
    """Gives an executor of each kind, which is started once: one cluster serves all tests."""
    with contextlib.ExitStack() as stack:

        def dask():
            import dask
            from distributed import Client, LocalCluster

            stack.enter_context(
                dask.config.set({"temporary-directory": str(tmp_path_factory.mktemp("dask"))})
            )
            two = {"n_workers": 1, "threads_per_worker": 2, "dashboard_address": "127.0.0.1:0"}
            cluster = stack.enter_context(LocalCluster(**two))
            return stack.enter_context(Client(cluster, set_as_default=False)).get_executor()

        def processes():
            spawn = multiprocessing.get_context("spawn")
            return stack.enter_context(concurrent.futures.ProcessPoolExecutor(2, spawn))

        def threads():
            return stack.enter_context(concurrent.futures.ThreadPoolExecutor(3))

        started = {}
        kinds = {"in turn": InTurn, "threads": threads, "processes": processes, "dask": dask}

        def executor(kind):
            if kind not in started:
                started[kind] = kinds[kind]()
            return started[kind]

        yield executor


ANALYSES = {
    "runs of the unit": lambda _, how: batch.simulate_many(
        [{FRICTION: mu} for mu in (1.2, 0.6, 0.2)], strides=3, **how
    ),
    "basin": lambda _, how: basin.basin({}, AXES, (6, 5), **how),
    "preview of a basin": lambda _, how: basin.basin({}, AXES, 20, refine="preview", **how),
    "volume": lambda gait, how: attraction.attraction_volume(gait, 60, **how),
    "grid of gaits": lambda _, how: tdmf_slip.sweep({}, {FRICTION: [0.6, 0.5], DAMPING: [0.2, 0.22]}, **how),
    "strides to a fall": lambda gait, how: first_passage.strides_to_fall(gait, 0.4, 200, 1, 60, **how),
    "strides": lambda gait, how: tdmf_slip.stride_map(
        gait,
        gait.apex + np.linspace(0, 0.1, 9)[:, None] * gait.runner.scales,
        strides=30,
        roughness=0.1,
        **how,
    ),
    "viability": lambda _, how: tdmf_slip.viability(None, n=12, **PLACES, **how),
    "proof": lambda _, how: proved(how),
}
SIZES = (
    (basin, "STARTS_AT_ONCE", 5),
    (basin, "POINTS_AT_ONCE", 7),
    (attraction, "STARTS_AT_ONCE", 4096),  # a block's number decides what is drawn
    (in_blocks, "MIN_RUNNERS", 1),
    (in_blocks, "MAX_RUNNERS", 2),
    (viability, "STRIDES_IN_A_BLOCK", 1),
    (grid, "STRIDES_IN_A_CALL", 50),
)
"""Sizes of blocks that tests make smaller."""


def proved(how):
    pytest.importorskip("flint")
    proof = tdmf_slip.prove({FRICTION: "10"}, vary={FRICTION: ("10", "10.04")}, **how)
    assert proof.proved and len(proof.subintervals) > 1
    return proof.as_json()


@pytest.fixture(scope="module")
def expected(gait):
    """Result of each analysis without an executor, computed once."""
    found = {}

    def result(name):
        if name not in found:
            found[name] = ANALYSES[name](gait, {})
        return found[name]

    return result


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        *((name, "processes") for name in ANALYSES),
        *(("strides", kind) for kind in KINDS if kind != "processes"),
    ],
)
def test_a_result_does_not_depend_on_the_executor(executors, expected, gait, name, kind):
    """All blocks go to other processes, and those of one analysis to executors of every kind."""
    assert_same(ANALYSES[name](gait, {"executor": executors(kind)}), expected(name))


@pytest.mark.parametrize("name", [name for name in ANALYSES if name != "proof"])
def test_a_result_does_not_depend_on_the_size_of_blocks(expected, gait, monkeypatch, name):
    whole = expected(name)
    for module, constant, size in SIZES:
        assert hasattr(module, constant)
        monkeypatch.setattr(module, constant, size)
    assert_same(ANALYSES[name](gait, {}), whole)


def work(number):
    """A block that other processes can import."""
    if number == 3:
        raise ValueError("three")
    time.sleep(0.01)
    return number * number


@pytest.mark.parametrize("kind", KINDS)
def test_a_block_that_fails_is_said_after_what_is_ready(executors, kind):
    """Waiting blocks are not begun after a failure."""
    results = {}
    with pytest.raises(ValueError, match="three"), run_blocks(work, range(500), executors(kind)) as found:
        results.update(found)
    assert all(result == number * number for number, result in results.items())
    assert {0, 1, 2} <= results.keys() if kind == "in turn" else len(results) < 490


def test_no_thread_and_no_block_is_left_after_a_failure():
    """The blocks run for ever; the flag ends them."""
    before, begun = set(threading.enumerate()), []

    def endless(number):
        begun.append(number)
        if number == 0:
            while len(begun) < 2 and (os.cpu_count() or 1) > 1:
                time.sleep(0.001)
            raise ValueError("zero")
        while True:
            check_stop()
            time.sleep(0.001)

    with pytest.raises(ValueError, match="zero"), run_blocks(endless, range(100)) as found:
        list(found)
    assert len(begun) < 100 and set(threading.enumerate()) == before


@pytest.mark.parametrize("endless", ["engine", "gaits", "unit"])
def test_what_computes_without_end_stops(gait, endless):
    """Endless work in C, in a search, and in a run of the unit."""

    def compute(number):
        if number == 0:
            raise ValueError("zero")
        if endless == "engine":
            Batch(gait, np.tile(gait.apex, (64, 1))).run(2**31 - 1)
        while endless == "gaits":
            tdmf_slip.find_gait({FRICTION: 0.5})
        tdmf_slip.simulate(strides=50_000)

    with (
        pytest.raises(ValueError, match="zero"),
        concurrent.futures.ThreadPoolExecutor(2) as pool,
        run_blocks(compute, [1, 0], pool) as found,
    ):
        list(found)


def test_blocks_within_a_block_use_its_thread():
    def outer(_):
        with run_blocks(lambda _: threading.get_ident(), range(3)) as found:
            return {thread for _, thread in found} == {threading.get_ident()}

    with run_blocks(outer, range(4)) as found:
        assert all(alone for _, alone in found)
    with run_blocks(lambda _: threading.get_ident(), [0]) as found:
        assert next(found)[1] != threading.get_ident()


class Cancelling(InTurn):
    """An executor that is shut down under way."""

    def submit(self, *_):
        future = concurrent.futures.Future()
        future.cancel()
        return future


class Broken(InTurn):
    def submit(self, *_):
        future = concurrent.futures.Future()
        future.set_exception(concurrent.futures.BrokenExecutor("a worker died"))
        return future


class FirstFails(InTurn):
    """An executor whose first call fails when the second one is submitted."""

    first = None

    def submit(self, *given):
        if self.first is None:
            self.first = concurrent.futures.Future()
            return self.first
        self.first.set_exception(ValueError("the first"))
        return super().submit(*given)


def test_a_result_that_is_ready_behind_a_failure_is_not_lost():
    results = {}
    with pytest.raises(ValueError, match="the first"), run_blocks(abs, [-1, -2], FirstFails()) as found:
        results.update(found)
    assert results == {1: 2}


@pytest.mark.parametrize(("kind", "said"), [(Cancelling, "cancelled a block"), (Broken, "a worker died")])
def test_an_executor_that_ends_is_said(kind, said):
    with pytest.raises(RunError, match=said), run_blocks(abs, [1], kind()) as found:
        list(found)


def test_a_script_needs_no_guard(tmp_path):
    """A script starts no process and opens no port."""
    script = tmp_path / "script.py"
    script.write_text(
        "import socket, subprocess, sys\n"
        "import fmpy, tdmf_slip\n"  # FMPy asks ldconfig where libraries are
        "def refused(*given, **named): raise SystemExit('a process or a port')\n"
        "socket.socket.bind = subprocess.Popen.__init__ = refused\n"
        "found = tdmf_slip.strides_to_fall({'ground.friction': 0.2}, roughness=0.5, runners=20)\n"
        "print(found.falls > 0, {'distributed', 'concurrent.futures.process'} & set(sys.modules))\n"
    )
    done = run_python(script)
    assert (done.returncode, done.stdout.strip()) == (0, "True set()"), done.stderr


def test_each_instance_keeps_its_own_messages(fmu):
    """An older instance keeps its messages when a newer one has been freed."""
    with opened(fmu, "cs") as older:
        with opened(fmu, "cs") as newer:
            pass
        kept = newer.messages
        del newer
        gc.collect()
        with pytest.raises(InputError, match=r"leg\.length = 0\.01"):
            older.simulate(Experiment(1.0, 1e-6, 0.1, {"leg.length": 0.01}), lambda *_: True)
    assert "leg.length" in older.messages[0] and "leg.length" not in str(kept)


def test_a_run_that_fails_leaves_the_others(fmu):
    """A runner that falls is a result; one that closes no stride has its reason written beside it."""
    table = [{"leg.angle": 1.0}, {"hip.touchdown_angle": 0.2}]
    runs = batch.simulate_many(table, strides=2, fmu=fmu)
    together = batch.simulate_many([{"leg.length": 1.0}, {"leg.length": 0.01}], strides=1, fmu=fmu)
    ran, refused = together["problem"].values
    assert ran == "" and "leg.length" in refused
    assert runs["problem"][0] == "" and runs["period"][0] > 0.0
    assert runs["fallen"][1] or runs["problem"][1]


def test_the_command_runs_on_a_cluster(executors, command):
    address = executors("dask")._client.scheduler.address
    asked = ("viability", "--n", 8, "--axes", "com_height=1:2", "--axes", "com_speed=0.6:1.6", "--vary")
    printed = [
        command(*asked, "hip.touchdown_angle=0.3:1.1:12", "--json", *where)
        for where in ((), ("--scheduler", address), ("--workers", 2))
    ]
    assert printed[0] == printed[1] == printed[2] and json.loads(printed[0][1])


def test_who_listens_and_is_no_scheduler_is_not_waited_for(command, monkeypatch):
    monkeypatch.setattr(options, "CONNECTING", 1.0)
    with socket.create_server(("127.0.0.1", 0)) as silent:
        address = f"tcp://127.0.0.1:{silent.getsockname()[1]}"
        assert "no answer within 1 s" in command.refusal("rough", "--roughness", 0.1, "--scheduler", address)


INTERRUPT_AT = """
import os, signal, sys
from tdmf_slip import blocks
from tdmf_slip.files import netcdf
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
        interrupting({"blocks": blocks, "netcdf": netcdf, "os": os}[module], name)
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


GRID = ("sweep", "--friction", "0.5:0.6:2", "--vary", "leg.damping=0.1:0.3:500", "--output", "grid.nc")
MAP = ("basin", "--n", "48", "--samples", "0", "--output", "map.nc")
PROOF = ("prove", "--vary", "ground.friction=0.47:0.58", "--workers", "2")


@pytest.mark.skipif(sys.platform == "win32", reason="the interrupt is a POSIX signal")
@pytest.mark.parametrize(
    ("function", "arguments", "left"),
    [
        ("blocks.ThreadPoolExecutor", GRID, []),
        ("os.replace", GRID, ["grid.nc.parts"]),
        ("blocks._next_done", MAP, None),
        ("blocks._next_done", PROOF, None),
    ],
    ids=["threads start", "a row is written", "blocks are waited for", "processes prove"],
)
def test_an_interrupt_ends_a_command_and_leaves_whole_rows(function, arguments, left, tmp_path):
    if arguments is PROOF:
        pytest.importorskip("flint")
    folder = tmp_path / "folder"
    folder.mkdir()
    status, said = interrupted(INTERRUPT_AT, folder, function, *arguments)
    assert status == 130
    assert said[-1].endswith(INTERRUPTED) and no_more_than_a_bar(said[:-1], arguments[0]), said
    assert left is None or [path.name for path in folder.iterdir()] == left
    blocks = list((folder / "grid.nc.parts").glob("*"))
    assert (function != "os.replace" or blocks) and len(blocks) < 500
    assert all(xarray.load_dataset(block)["period"].notnull().all() for block in blocks)


def test_an_interrupt_that_is_held_back_is_passed_on_once():
    with pytest.raises(KeyboardInterrupt), interrupts.deferred():
        with interrupts.deferred():
            signal.raise_signal(signal.SIGINT)
        held_by_the_outer = True
    assert held_by_the_outer


def test_wrong_arguments_are_said(fmu):
    with (
        pytest.raises(InputError, match=r"executor.*a concurrent\.futures\.Executor"),
        run_blocks(abs, [1], 4),
    ):
        pass
    with pytest.raises(InputError, match=r"executor = 3 .*a concurrent\.futures\.Executor"):
        tdmf_slip.sweep(None, {FRICTION: [0.6, 0.5]}, executor=3)
    with pytest.raises(InputError, match="runners: none; allowed"):
        batch.simulate_many([], strides=1, fmu=fmu)
    with pytest.raises(InputError, match="runner 1"):
        batch.simulate_many([{FRICTION: 0.6}, {FRICTION: -1.0}], strides=1, fmu=fmu)
