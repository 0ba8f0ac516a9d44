"""The unit's two solvers and their peers on the same stride, each at the loosest accurate tolerance."""

import platform
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass

import numpy as np

from . import progress, reference
from .errors import RunError
from .instance import opened
from .section import COORDINATES, scales, start_values
from .text import table
from .unit import Unit, load

FRICTION = 0.6
WANTED_ERROR = 1e-8
TOLERANCES = tuple(digit * 10.0**-power for power in range(6, 13) for digit in (10, 5, 2))
PEER_STRIDES = 200
INTEGRATORS_ALONE = ", integrators alone"
"""Without the transitions between modes, which a user of heyoka writes in Python."""
STRIDES = {"native": 2000, "cvode": 50}
REPEATS = 5


@dataclass(frozen=True)
class Measurement:
    """One solver at the loosest tolerance that reaches the wanted error."""

    solver: str
    tolerance: float
    error: float
    """Of the apex after one stride from the reference gait, the largest coordinate over its scale."""
    evaluations: float | None
    """Of the right-hand side, or of a coefficient of its series, a stride; None where nobody says."""
    microseconds: float
    """A stride, the fastest of the repeats."""


@dataclass(frozen=True)
class Bench:
    """What was measured, and on what."""

    measurements: tuple[Measurement, ...]
    """The native solver first."""
    machine: str
    missing: tuple[str, ...] = ()
    """Peers that are not installed."""

    @property
    def ratios(self) -> dict[str, float]:
        """How many times faster the native solver is than each other."""
        native = self.measurements[0]
        return {m.solver: m.microseconds / native.microseconds for m in self.measurements[1:]}

    def as_json(self) -> dict[str, object]:
        """The measurements as a plain object."""
        rows = [asdict(measurement) for measurement in self.measurements]
        return {"measurements": rows, "ratios": self.ratios, "missing": self.missing, "machine": self.machine}

    def as_text(self) -> str:
        """The measurements as a table."""
        header = ("solver", "tolerance", "error", "evaluations/stride", "us/stride")
        rows = [
            (
                m.solver,
                f"{m.tolerance:.0e}",
                f"{m.error:.1e}",
                "" if m.evaluations is None else f"{m.evaluations:.0f}",
                f"{m.microseconds:.1f}",
            )
            for m in self.measurements
        ]
        lines = [f"native is {ratio:.1f} times as fast as {name}" for name, ratio in self.ratios.items()]
        lines += [f"{name} is not installed: pip install 'tdmf-slip[bench]'" for name in self.missing]
        return "\n".join([table(header, rows), *lines, f"on {self.machine}"])


def known_gait() -> dict:
    """The reference gait that is run."""
    return next(gait for gait in reference.gaits() if gait["friction"] == FRICTION)


def starts(unit: Unit, solver: str, tolerance: float) -> dict[str, float | int]:
    """Start values of a run from the gait's apex by a solver."""
    methods = unit.variables["solver.method"].items
    return {
        **start_values(unit, known_gait()["apex"]),
        "ground.friction": FRICTION,
        "solver.method": {name: number for number, name in methods.items()}[solver],
        "solver.relative_tolerance": tolerance,
    }


def stride_error(unit: Unit, solver: str, tolerance: float) -> float:
    """Error of the apex after one stride."""
    gait = known_gait()
    with opened(unit, "cs") as runner:
        runner.start(starts(unit, solver, tolerance))
        runner.advance(0.0, 1.001 * gait["period"])
        found = runner.read(f"apex.{name}" for name in COORDINATES).values()
        pairs = zip(found, gait["apex"], scales(unit), strict=True)
        return max(abs(value - known) / scale for value, known, scale in pairs)


def loosest_tolerance(what: str, error_at: Callable[[float], float]) -> tuple[float, float]:
    """The loosest tolerance from which on all tighter ones are accurate enough, and its error.

    Raises:
        RunError: no tolerance is.
    """
    found = None
    for tolerance in reversed(TOLERANCES):
        error = error_at(tolerance)
        if error > WANTED_ERROR:
            break
        found = tolerance, error
    if found is None:
        raise RunError(
            f"{what}: no tolerance down to {TOLERANCES[-1]:g} reaches an error of {WANTED_ERROR:g}"
        )
    return found


def measure_heyoka(repeats: int, effort: float) -> list[Measurement]:
    """Time heyoka over the same stride: as a whole, and its integrators alone.

    Raises:
        ImportError: it is not installed.
    """
    from .peers.heyoka_peer import Peer

    apex = np.array(known_gait()["apex"])
    tolerance, error = loosest_tolerance(
        Peer.name, lambda tolerance: float(np.max(np.abs(Peer(tolerance).stride(apex) - apex)))
    )
    peer, strides = Peer(tolerance), max(1, round(effort * PEER_STRIDES))
    whole, alone = [], []
    for _ in range(repeats):
        peer.seconds = 0.0
        start = time.perf_counter()
        for _ in range(strides):
            peer.stride(apex)
        whole.append(1e6 * (time.perf_counter() - start) / strides)
        alone.append(1e6 * peer.seconds / strides)
    return [
        Measurement(Peer.name, tolerance, error, None, min(whole)),
        Measurement(Peer.name + INTEGRATORS_ALONE, tolerance, error, None, min(alone)),
    ]


def measure(unit: Unit, solver: str, strides: int, repeats: int) -> Measurement:
    """Time a solver over many strides of the gait, several times."""
    tolerance, error = loosest_tolerance(solver, lambda tolerance: stride_error(unit, solver, tolerance))
    duration = strides * known_gait()["period"]
    times, evaluations = [], 0
    for _ in range(repeats):
        with opened(unit, "cs") as runner:
            runner.start(starts(unit, solver, tolerance))
            start = time.perf_counter()
            runner.advance(0.0, duration)
            times.append(time.perf_counter() - start)
            evaluations = runner.value("solver.evaluations")
    return Measurement(solver, tolerance, error, evaluations / strides, 1e6 * min(times) / strides)


def bench(*, effort: float = 1.0, show_progress: bool = False, unit: Unit | None = None) -> Bench:
    """Measure both solvers, and heyoka where it is installed, on this machine, single-threaded.

    Args:
        effort: scales the number of strides.
        show_progress: a bar on stderr.
        unit: the unit to measure; by default that of `fmu_path`.

    Raises:
        InputError: the unit was built without CVODE.
        RunError: a solver does not reach the wanted error.
    """
    unit = load() if unit is None else unit
    measurements, missing = [], []
    with progress.bar("bench", len(STRIDES) + 1, "solvers", show_progress) as bar:
        for solver, strides in STRIDES.items():
            measurements.append(measure(unit, solver, max(1, round(effort * strides)), REPEATS))
            bar.update(1)
        try:
            measurements += measure_heyoka(REPEATS, effort)
        except ImportError:
            missing.append("heyoka")
        bar.update(1)
    machine = f"{_processor()}, {platform.system()} {platform.machine()}"
    return Bench(tuple(measurements), machine, tuple(missing))


def _processor() -> str:
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            return next(line.split(":", 1)[1].strip() for line in file if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or "unknown processor"
