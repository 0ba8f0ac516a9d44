"""Solvers and the ensemble engine against peers: the same strides, each at the loosest accurate tolerance."""

import contextlib
import functools
import importlib
import os
from collections.abc import Callable, Iterator

from tdmf_slip.checks import checked
from tdmf_slip.fmu.fmu import Fmu, load_fmu
from tdmf_slip.library.engine import instruction_sets
from tdmf_slip.terminal.progress import progress_bar

from .accuracy import check_agrees
from .ensembles import batch_error, lane_error, measure_batches, measure_lanes, measure_scaling
from .one_runner import STRIDES, Peer, measure_fmu, measure_peer, peer_error, stride_error
from .results import MANY, MOTION, ONE, REDUCED, Bench, Measurement, versions_here
from .runners import CLAMP, Runners, runners_about_the_gait

PEERS = ("heyoka", "numba", "scipy")
"""Peers that simulate one runner at a time; heyoka also simulates batches."""


def _peer_of(name: str) -> type[Peer]:
    peer: type[Peer] = importlib.import_module(f".peers.{name}_peer", __package__).Peer
    return peer


def _peer_error(name: str, many: Runners, tolerance: float) -> float:
    return peer_error(_peer_of(name), many, tolerance)


def _measure_peer(name: str, many: Runners, effort: float) -> Iterator[Measurement]:
    yield from measure_peer(_peer_of(name), many, max(1, round(effort * STRIDES[name])))


def _errors(fmu: Fmu, many: Runners) -> Iterator[tuple[str, Callable[[float], float]]]:
    """The error of each solver at a tolerance, by its name."""
    for solver in ("native", "cvode"):
        yield solver, functools.partial(stride_error, fmu, many, solver)
    for name in PEERS:
        yield name, functools.partial(_peer_error, name, many)
    yield "heyoka in batches", functools.partial(batch_error, many)
    for instructions in instruction_sets():
        yield instructions, functools.partial(lane_error, many, instructions)


def check_agreement(fmu: Fmu, done: Callable[[], object] = lambda: None) -> None:
    """Refuse to time anything unless all solvers make the same strides, in both readings of (12)."""
    for swing_clamp in (False, True):
        many = runners_about_the_gait(swing_clamp=swing_clamp)
        for name, error_at in _errors(fmu, many):
            what = f"{name}, {CLAMP} = {str(swing_clamp).lower()}"
            with contextlib.suppress(ImportError):  # bench reports which peers are missing
                check_agrees(what, error_at)
            done()


def bench(
    *, effort: float = 1.0, swing_clamp: bool | None = None, progress: bool = False, fmu: Fmu | None = None
) -> Bench:
    """Measure everything on this machine; all but the scaling over threads in one thread.

    `swing_clamp` is the runners' `hip.swing_clamp`; by default the unit's own value.
    """
    checked("effort", effort, 1e-3, 1e3)
    fmu = load_fmu(fmu)
    many = runners_about_the_gait(swing_clamp=swing_clamp)
    reduced = runners_about_the_gait(swing_clamp=swing_clamp, reduced=True)
    sets = instruction_sets()
    jobs: list[tuple[str, Callable[[], Iterator[Measurement]]]] = [
        *(
            (solver, functools.partial(measure_fmu, fmu, many, solver, effort))
            for solver in ("native", "cvode")
        ),
        ("native", functools.partial(measure_lanes, many, "one by one", effort, ONE, MOTION)),
        *((name, functools.partial(_measure_peer, name, many, effort)) for name in PEERS),
        *((name, functools.partial(measure_lanes, many, name, effort)) for name in reversed(sets)),
        ("heyoka", functools.partial(measure_batches, many, effort)),
        *(
            (name, functools.partial(measure_lanes, reduced, name, effort, REDUCED))
            for name in (sets[-1], sets[0])
        ),
    ]
    measurements: list[Measurement] = []
    missing: dict[str, None] = {}
    with progress_bar("agreement", 2 * (3 + len(PEERS) + len(sets)), "solvers", progress) as bar:
        check_agreement(fmu, bar.update)
    with progress_bar("bench", len(jobs) + 1, "solvers", progress) as bar:
        for name, measure in jobs:
            try:
                measurements += measure()
            except ImportError:
                missing[name] = None
            bar.update(1)
        threads = os.cpu_count() or 1
        scaling = measure_scaling(many, threads, effort)
        bar.update(1)
    ours = {ONE: "native", MANY: sets[-1], REDUCED: sets[-1]}
    return Bench(many.runner, tuple(measurements), ours, threads, scaling, versions_here(), tuple(missing))
