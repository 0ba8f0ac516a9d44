"""Solvers and the ensemble engine against peers: the same strides, each at the loosest accurate tolerance."""

import datetime
import os
import platform
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from functools import cached_property
from importlib.metadata import version

import numpy as np

from . import ensemble, interrupts, progress, reference
from .errors import RunError
from .instance import opened
from .library import c, ffi
from .orbit import Runner
from .section import COORDINATES, start_values
from .simulation import checked
from .text import table
from .unit import Unit, load

FRICTION = 0.6
ACCURACIES = (1e-8, 1e-5)
"""Wanted of the apex after one stride, over its scales, from the gait's apex and all around it."""
TOLERANCES = tuple(digit * 10.0**-power for power in range(3, 13) for digit in (10, 5, 2))
REPEATS = 5
STRIDES = {"native": 2000, "cvode": 50, "scipy": 5, "numba": 100, "heyoka": 200}
"""Timed in each repeat."""
ALONE = ", integrators alone"
"""Without the transitions between modes, which a user of heyoka writes in Python."""
RUNNERS, STRIDES_EACH = 4096, 4
SPREAD = 0.05
"""Of starts about the gait's apex, either way; all make the gait's word."""
JUDGED = 64
"""Starts by which each solver's error is judged, besides the gait's apex."""
TIGHT = 1e-13
"""Tolerance of the native solver that the others are held against."""
ONE, MANY = "one runner", "ensemble, on one processor"


@dataclass(frozen=True)
class Measurement:
    """One solver at the loosest tolerance that reaches an accuracy."""

    group: str
    solver: str
    accuracy: float
    tolerance: float
    error: float
    """Of the apex after one stride, the largest coordinate over its scale; from the worst of the starts."""
    evaluations: float | None
    """Of the right-hand side, or of a coefficient of its series, a stride; None where nobody says."""
    microseconds: float
    """A stride, the fastest of the repeats."""


@dataclass(frozen=True)
class Bench:
    """What was measured, and on what."""

    measurements: tuple[Measurement, ...]
    ours: Mapping[str, str]
    """By group, the solver of ours that the others are compared with."""
    threads: int
    scaling: float
    """Of the ensemble over so many threads: strides a second each, over those of one alone."""
    versions: Mapping[str, str]
    missing: tuple[str, ...] = ()
    """Peers that are not installed."""

    def ratio(self, measurement: Measurement) -> float:
        """How many times faster our solver of its group is than a solver."""
        ours = next(
            m
            for m in self.measurements
            if (m.group, m.accuracy, m.solver)
            == (measurement.group, measurement.accuracy, self.ours[measurement.group])
        )
        return measurement.microseconds / ours.microseconds

    def as_json(self) -> dict[str, object]:
        """The measurements as a plain object."""
        rows = [asdict(m) | {"ratio": self.ratio(m)} for m in self.measurements]
        return {
            "measurements": rows,
            "threads": self.threads,
            "scaling": self.scaling,
            "versions": dict(self.versions),
            "missing": list(self.missing),
        }

    def as_text(self) -> str:
        """The measurements as tables."""
        parts = []
        for group, ours in self.ours.items():
            for accuracy in ACCURACIES:
                rows = [m for m in self.measurements if (m.group, m.accuracy) == (group, accuracy)]
                parts += [f"{group}, to {accuracy:g}; ratios to {ours}", self._rows_text(rows), ""]
        parts.append(f"{self.threads} threads: each makes {self.scaling:.2f} times the strides of one alone")
        parts += [f"{name} is not installed: pip install 'tdmf-slip[bench]'" for name in self.missing]
        parts += [f"{name}: {what}" for name, what in self.versions.items()]
        return "\n".join(parts)

    def _rows_text(self, rows: list[Measurement]) -> str:
        header = ("solver", "tolerance", "error", "evaluations", "ns each", "us/stride", "strides/s", "ratio")
        return table(
            header,
            [
                (
                    m.solver,
                    f"{m.tolerance:.0e}",
                    f"{m.error:.1e}",
                    "" if m.evaluations is None else f"{m.evaluations:.0f}",
                    "" if m.evaluations is None else f"{1e3 * m.microseconds / m.evaluations:.1f}",
                    f"{m.microseconds:.2f}" if m.microseconds < 100 else f"{m.microseconds:.0f}",
                    f"{1e6 / m.microseconds:.0f}",
                    f"{self.ratio(m):.3g}",
                )
                for m in rows
            ],
        )


def known_gait() -> dict:
    """The reference gait that is run."""
    return next(gait for gait in reference.gaits() if gait["friction"] == FRICTION)


def loosest(what: str, error_at: Callable[[float], float]) -> Iterator[tuple[float, float, float]]:
    """For each accuracy the loosest tolerance from which on all tighter ones reach it, with its error.

    Raises:
        RunError: no tolerance does.
    """
    errors: dict[float, float] = {}
    for accuracy in ACCURACIES:
        found = None
        for tolerance in reversed(TOLERANCES):
            if tolerance not in errors:
                errors[tolerance] = error_at(tolerance)
            if not errors[tolerance] <= accuracy:
                break
            found = tolerance
        if found is None:
            raise RunError(
                f"{what}: no tolerance down to {TOLERANCES[-1]:g} reaches an error of {accuracy:g}"
            )
        yield accuracy, found, errors[found]


def _fastest(work: Callable[[], object], repeats: int = REPEATS) -> float:
    """Seconds of the fastest of some repeats."""
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times)


# ---- starts -----------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Crowd:
    """Runners that start about the gait's apex."""

    case: ensemble.Case
    starts: np.ndarray

    @cached_property
    def judged(self) -> np.ndarray:
        """The starts by which errors are judged: the gait's apex, and some about it."""
        return np.vstack([known_gait()["apex"], self.starts[:JUDGED]])

    @cached_property
    def exact(self) -> np.ndarray:
        """What one stride from each of them comes to, by the native solver at `TIGHT`."""
        return self.ends("one by one", TIGHT)

    def ends(self, instructions: str, tolerance: float) -> np.ndarray:
        """What one stride of the ensemble engine from each of them comes to, see `ensemble.run`."""
        return ensemble.run(
            [self.case],
            self.judged,
            most_strides=1,
            tolerance=tolerance,
            threads=1,
            instructions=instructions,
        )[0]

    def error(self, apices: np.ndarray) -> float:
        """The largest difference from the exact apices, over the scales; infinite where one is no number."""
        differences = np.abs(apices - self.exact["apex"]) / self.case.runner.scales
        return float(np.max(np.where(np.isnan(differences), np.inf, differences)))

    def run(
        self, instructions: str | None, tolerance: float, threads: int, effort: float
    ) -> tuple[float, ensemble.Work]:
        """Seconds for all, making some strides, and the work that was done."""
        count = max(JUDGED, round(effort * len(self.starts))) * threads
        runners = np.resize(self.starts, (count, len(COORDINATES)))
        work: list[ensemble.Work] = []

        def once() -> None:
            _, done = ensemble.run(
                [self.case],
                runners,
                most_strides=STRIDES_EACH,
                tolerance=tolerance,
                threads=threads,
                instructions=instructions,
            )
            work.append(done)

        return _fastest(once), work[0]


def crowd(unit: Unit) -> Crowd:
    """Starts drawn about the gait's apex."""
    source = np.random.default_rng(0)
    runner = Runner.of({"ground.friction": FRICTION}, unit)
    spread = source.uniform(-SPREAD, SPREAD, (RUNNERS, len(COORDINATES)))
    return Crowd(ensemble.Case(runner), np.array(known_gait()["apex"]) + spread)


# ---- one runner -------------------------------------------------------------------------------------------


def starts(unit: Unit, solver: str, tolerance: float, apex: Sequence[float]) -> dict[str, float | int]:
    """Start values of a run from an apex by a solver of the unit."""
    methods = unit.variables["solver.method"].items
    return {
        **start_values(unit, apex),
        "ground.friction": FRICTION,
        "solver.method": {name: number for number, name in methods.items()}[solver],
        "solver.relative_tolerance": tolerance,
    }


def stride_error(unit: Unit, many: Crowd, solver: str, tolerance: float) -> float:
    """Error of the apex after one stride by a solver of the unit, from the worst start."""
    names = [f"apex.{name}" for name in COORDINATES]
    apices = []
    for apex, exact in zip(many.judged, many.exact, strict=True):
        with opened(unit, "cs") as runner:
            runner.start(starts(unit, solver, tolerance, apex))
            runner.advance(0.0, 1.001 * exact["time"])
            apices.append(list(runner.read(names).values()))
    return many.error(np.array(apices))


def measure_unit(unit: Unit, many: Crowd, solver: str, effort: float) -> Iterator[Measurement]:
    """Time a solver of the unit, through Co-Simulation, over many strides of the gait."""
    strides = max(1, round(effort * STRIDES[solver]))
    duration = strides * known_gait()["period"]
    for accuracy, tolerance, error in loosest(solver, lambda t: stride_error(unit, many, solver, t)):
        times, evaluations = [], 0
        for _ in range(REPEATS):
            with opened(unit, "cs") as runner:
                runner.start(starts(unit, solver, tolerance, known_gait()["apex"]))
                start = time.perf_counter()
                runner.advance(0.0, duration)
                times.append(time.perf_counter() - start)
                evaluations = runner.value("solver.evaluations")
        yield Measurement(
            ONE, solver, accuracy, tolerance, error, evaluations / strides, 1e6 * min(times) / strides
        )


def measure_peer(peer_of: type, many: Crowd, strides: int) -> Iterator[Measurement]:
    """Time a peer that makes one stride at a time."""
    apex = np.array(known_gait()["apex"])
    with interrupts.held():  # a compiler may lose one
        peer_of(max(TOLERANCES)).stride(apex)

    def error_at(tolerance: float) -> float:
        peer = peer_of(tolerance)
        return many.error(np.array([peer.stride(start) for start in many.judged]))

    for accuracy, tolerance, error in loosest(peer_of.name, error_at):
        peer = peer_of(tolerance)
        peer.stride(apex)
        counted = getattr(peer, "evaluations", None)
        alone, whole = [], []
        for _ in range(REPEATS):
            peer.seconds = 0.0
            whole.append(_fastest(lambda peer=peer: [peer.stride(apex) for _ in range(strides)], 1))
            alone.append(peer.seconds)
        for name, seconds in ((peer_of.name, min(whole)), (peer_of.name + ALONE, min(alone))):
            if seconds > 0.0:
                yield Measurement(ONE, name, accuracy, tolerance, error, counted, 1e6 * seconds / strides)


# ---- ensembles --------------------------------------------------------------------------------------------


def measure_lanes(many: Crowd, instructions: str, effort: float) -> Iterator[Measurement]:
    """Time the engine by one instruction set, in one thread."""

    def error_at(tolerance: float) -> float:
        return many.error(many.ends(instructions, tolerance)["apex"])

    for accuracy, tolerance, error in loosest(instructions, error_at):
        seconds, work = many.run(instructions, tolerance, 1, effort)
        yield Measurement(
            MANY,
            instructions,
            accuracy,
            tolerance,
            error,
            work.evaluations / work.strides,
            1e6 * seconds / work.strides,
        )


def measure_batches(many: Crowd, effort: float) -> Iterator[Measurement]:
    """Time heyoka's batch integrators over the same starts: as a whole, and the integrators alone.

    Raises:
        ImportError: it is not installed.
    """
    from .peers.heyoka_peer import BatchPeer

    full = -(-len(many.judged) // BatchPeer.lanes) * BatchPeer.lanes  # the last batch is filled up
    judged = np.resize(many.judged, (full, len(COORDINATES))).reshape(-1, BatchPeer.lanes, len(COORDINATES))
    batches = many.starts[:JUDGED].reshape(-1, BatchPeer.lanes, len(COORDINATES))

    def error_at(tolerance: float) -> float:
        peer = BatchPeer(tolerance)
        found = np.concatenate([peer.strides(batch) for batch in judged])
        return many.error(found[: len(many.judged)])

    for accuracy, tolerance, error in loosest(BatchPeer.name, error_at):
        peer = BatchPeer(tolerance)
        rounds = [*batches] * max(1, round(effort * STRIDES["heyoka"] / len(batches)))
        strides = len(rounds) * BatchPeer.lanes
        whole, alone = [], []
        for _ in range(REPEATS):
            peer.seconds = 0.0
            whole.append(_fastest(lambda peer=peer, rounds=rounds: [peer.strides(b) for b in rounds], 1))
            alone.append(peer.seconds)
        for name, seconds in ((BatchPeer.name, min(whole)), (BatchPeer.name + ALONE, min(alone))):
            yield Measurement(MANY, name, accuracy, tolerance, error, None, 1e6 * seconds / strides)


def measure_scaling(many: Crowd, threads: int, effort: float) -> float:
    """Strides a second of each of many threads, over those of one alone."""
    alone, _ = many.run(None, ensemble.TOLERANCE, 1, effort)
    together, _ = many.run(None, ensemble.TOLERANCE, threads, effort)
    return alone / together


# ---- all --------------------------------------------------------------------------------------------------


def _peers(many: Crowd, effort: float) -> Iterator[tuple[str, Callable[[], Iterator[Measurement]]]]:
    """What may not be installed, by name."""

    def of(name: str) -> Iterator[Measurement]:
        if name == "heyoka":
            from .peers.heyoka_peer import Peer
        elif name == "numba":
            from .peers.numba_peer import Peer
        else:
            from .peers.scipy_peer import Peer
        yield from measure_peer(Peer, many, max(1, round(effort * STRIDES[name])))

    for name in ("heyoka", "numba", "scipy"):
        yield name, lambda name=name: of(name)


def bench(*, effort: float = 1.0, show_progress: bool = False, unit: Unit | None = None) -> Bench:
    """Measure everything on this machine; all but the scaling over threads in one thread.

    Args:
        effort: scales how long is measured.
        show_progress: a bar on stderr.
        unit: the unit to measure; by default that of `fmu_path`.

    Raises:
        InputError: the unit was built without CVODE, or the effort is out of range.
        RunError: a solver does not reach the wanted error.
    """
    checked("effort", effort, 1e-3, 1e3)
    unit = load(unit)
    many = crowd(unit)
    sets = ensemble.instruction_sets()
    jobs = [
        *(
            (solver, lambda solver=solver: measure_unit(unit, many, solver, effort))
            for solver in ("native", "cvode")
        ),
        *_peers(many, effort),
        *((name, lambda name=name: measure_lanes(many, name, effort)) for name in reversed(sets)),
        ("heyoka", lambda: measure_batches(many, effort)),
    ]
    measurements: list[Measurement] = []
    missing: dict[str, None] = {}
    with progress.bar("bench", len(jobs) + 1, "solvers", show_progress) as bar:
        for name, measure in jobs:
            try:
                measurements += measure()
            except ImportError:
                missing[name] = None
            bar.update(1)
        threads = os.cpu_count() or 1
        scaling = measure_scaling(many, threads, effort)
        bar.update(1)
    ours = {ONE: "native", MANY: sets[-1]}
    return Bench(tuple(measurements), ours, threads, scaling, _versions(), tuple(missing))


def _versions() -> dict[str, str]:
    return {
        "date": datetime.date.today().isoformat(),
        "processor": f"{_processor()}, {platform.system()} {platform.machine()}",
        "compiler": ffi.string(c.tdmf_compiler()).decode(),
        "tdmf-slip": version("tdmf-slip"),
        "python": platform.python_version(),
    }


def _processor() -> str:
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            return next(line.split(":", 1)[1].strip() for line in file if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or "unknown processor"
