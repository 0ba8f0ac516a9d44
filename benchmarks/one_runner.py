"""One runner: the solvers of the unit, through Co-Simulation, and peers that make one stride at a time."""

import functools
import time
from collections.abc import Iterator
from typing import Protocol

import numpy as np
from numpy.typing import NDArray
from tdmf_slip.fmu.fmu import Fmu
from tdmf_slip.fmu.instance import Experiment, Instance, opened
from tdmf_slip.library.section import COORDINATES, Apex
from tdmf_slip.uninterrupted import uninterrupted

from .accuracy import REPEATS, fastest, loosest
from .results import ALONE, ONE, Measurement
from .runners import Runners

STRIDES = {"native": 2000, "cvode": 50, "scipy": 5, "numba": 100, "heyoka": 200}
"""Timed in each repeat."""


def run(instance: Instance, many: Runners, solver: str, tolerance: float, apex: Apex, end: float) -> None:
    """Run an instance from an apex by a solver of the unit, in one communication step."""
    methods = instance.fmu.variables["solver.method"].items
    starts = {
        **many.runner.start_values(apex),
        "solver.method": {name: number for number, name in methods.items()}[solver],
        "solver.relative_tolerance": tolerance,
    }
    instance.simulate(Experiment(end, tolerance, end, starts), lambda *_: True)


def stride_error(fmu: Fmu, many: Runners, solver: str, tolerance: float) -> float:
    """Error of the apex after one stride by a solver of the unit, from the worst start."""
    names = [f"apex.{name}" for name in COORDINATES]
    apices = []
    for apex, duration in zip(many.judged, many.exact.time, strict=True):
        with opened(fmu, "cs") as runner:
            run(runner, many, solver, tolerance, apex, 1.001 * duration)
            apices.append([runner.value(name) for name in names])
    return many.error(np.array(apices))


def measure_fmu(fmu: Fmu, many: Runners, solver: str, effort: float) -> Iterator[Measurement]:
    """Time a solver of the unit, through Co-Simulation, over many strides of the gait."""
    strides = max(1, round(effort * STRIDES[solver]))
    duration = strides * many.gait.period
    for accuracy, tolerance, error in loosest(solver, lambda t: stride_error(fmu, many, solver, t)):
        times, evaluations = [], 0
        for _ in range(REPEATS):
            with opened(fmu, "cs") as runner:
                start = time.perf_counter()
                run(runner, many, solver, tolerance, many.gait.apex, duration)
                times.append(time.perf_counter() - start)
                evaluations = runner.value("solver.evaluations")
        yield Measurement(
            ONE, solver, accuracy, tolerance, error, evaluations / strides, 1e6 * min(times) / strides
        )


class Peer(Protocol):
    """Makes one stride at a time, at a tolerance."""

    name: str
    """Name in the table."""
    seconds: float
    """Seconds spent in integrators so far; 0 if the peer does not measure them."""
    evaluations: int | None
    """Evaluations of the right-hand side so far; None if the peer does not count them."""

    def __init__(self, tolerance: float, swing_clamp: bool) -> None:
        """Prepare the solver for runners with this `hip.swing_clamp`."""
        ...

    def stride(self, section: Apex) -> NDArray[np.float64]:
        """The apex after one stride from an apex."""
        ...


def _strides(peer: Peer, apex: Apex, count: int) -> None:
    for _ in range(count):
        peer.stride(apex)


def peer_error(peer_of: type[Peer], many: Runners, tolerance: float) -> float:
    """Error of the apex after one stride by a peer, from the worst start."""
    peer = peer_of(tolerance, many.swing_clamp)
    uninterrupted(lambda: peer.stride(many.gait.apex))  # a compiler may lose an interrupt
    return many.error(np.array([peer.stride(start) for start in many.judged]))


def measure_peer(peer_of: type[Peer], many: Runners, strides: int) -> Iterator[Measurement]:
    """Time a peer that makes one stride at a time."""
    apex = many.gait.apex
    for accuracy, tolerance, error in loosest(peer_of.name, functools.partial(peer_error, peer_of, many)):
        peer = peer_of(tolerance, many.swing_clamp)
        peer.stride(apex)
        counted = peer.evaluations
        alone, whole = [], []
        for _ in range(REPEATS):
            peer.seconds = 0.0
            whole.append(fastest(functools.partial(_strides, peer, apex, strides), 1))
            alone.append(peer.seconds)
        for name, seconds in ((peer_of.name, min(whole)), (peer_of.name + ALONE, min(alone))):
            if seconds > 0.0:
                yield Measurement(ONE, name, accuracy, tolerance, error, counted, 1e6 * seconds / strides)
