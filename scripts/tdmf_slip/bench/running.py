"""Solvers and the ensemble engine against peers: the same strides, each at the loosest accurate tolerance."""

import functools
import importlib
import os
from collections.abc import Callable, Iterator

from ..checks import checked
from ..fmu.fmu import Fmu, load_fmu
from ..library import ensemble
from ..terminal.progress import progress_bar
from .ensembles import measure_batches, measure_lanes, measure_scaling
from .one_runner import STRIDES, measure_fmu, measure_peer
from .results import MANY, MOTION, ONE, REDUCED, Bench, Measurement, versions_here
from .runners import Runners, runners_about_the_gait


def _peers(many: Runners, effort: float) -> Iterator[tuple[str, Callable[[], Iterator[Measurement]]]]:
    """What may not be installed, by name."""

    def of(name: str) -> Iterator[Measurement]:
        module = importlib.import_module(f".peers.{name}_peer", __package__)
        yield from measure_peer(module.Peer, many, max(1, round(effort * STRIDES[name])))

    for name in ("heyoka", "numba", "scipy"):
        yield name, functools.partial(of, name)


def bench(*, effort: float = 1.0, progress: bool = False, fmu: Fmu | None = None) -> Bench:
    """Measure everything on this machine; all but the scaling over threads in one thread."""
    checked("effort", effort, 1e-3, 1e3)
    fmu = load_fmu(fmu)
    many, reduced = runners_about_the_gait(fmu), runners_about_the_gait(fmu, reduced=True)
    sets = ensemble.instruction_sets()
    jobs: list[tuple[str, Callable[[], Iterator[Measurement]]]] = [
        *(
            (solver, functools.partial(measure_fmu, fmu, many, solver, effort))
            for solver in ("native", "cvode")
        ),
        ("native", functools.partial(measure_lanes, many, "one by one", effort, ONE, MOTION)),
        *_peers(many, effort),
        *((name, functools.partial(measure_lanes, many, name, effort)) for name in reversed(sets)),
        ("heyoka", functools.partial(measure_batches, many, effort)),
        *(
            (name, functools.partial(measure_lanes, reduced, name, effort, REDUCED))
            for name in (sets[-1], sets[0])
        ),
    ]
    measurements: list[Measurement] = []
    missing: dict[str, None] = {}
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
    return Bench(tuple(measurements), ours, threads, scaling, versions_here(), tuple(missing))
