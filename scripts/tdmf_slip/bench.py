"""The unit's two solvers on the same stride, each at the loosest tolerance that is accurate enough."""

import platform
import time
from dataclasses import asdict, dataclass

from . import progress, reference
from .errors import RunError
from .instance import opened
from .section import COORDINATES, scales, start_values
from .text import table
from .unit import Unit, load

FRICTION = 0.6
WANTED_ERROR = 1e-8
TOLERANCES = tuple(digit * 10.0**-power for power in range(6, 13) for digit in (10, 5, 2))
STRIDES = {"native": 2000, "cvode": 50}
REPEATS = 5


@dataclass(frozen=True)
class Measurement:
    """One solver at the loosest tolerance that reaches the wanted error."""

    solver: str
    tolerance: float
    error: float
    """Of the apex after one stride from the reference gait, the largest coordinate over its scale."""
    evaluations: float
    """Of the right-hand side, a stride."""
    microseconds: float
    """A stride, the fastest of the repeats."""


@dataclass(frozen=True)
class Bench:
    """What was measured, and on what."""

    measurements: tuple[Measurement, ...]
    machine: str

    @property
    def ratio(self) -> float:
        """How many times faster the native solver is than CVODE."""
        native, cvode = self.measurements
        return cvode.microseconds / native.microseconds

    def as_json(self) -> dict[str, object]:
        """The measurements as a plain object."""
        rows = [asdict(measurement) for measurement in self.measurements]
        return {"measurements": rows, "ratio": self.ratio, "machine": self.machine}

    def as_text(self) -> str:
        """The measurements as a table."""
        header = ("solver", "tolerance", "error", "evaluations/stride", "us/stride")
        rows = [
            (
                m.solver,
                f"{m.tolerance:.0e}",
                f"{m.error:.1e}",
                f"{m.evaluations:.0f}",
                f"{m.microseconds:.1f}",
            )
            for m in self.measurements
        ]
        return f"{table(header, rows)}\nnative is {self.ratio:.0f} times as fast as CVODE on {self.machine}"


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


def stride_error(unit: Unit, solver: str, tolerance: float) -> tuple[float, int]:
    """Error of the apex after one stride, and the evaluations that took."""
    gait = known_gait()
    with opened(unit, "cs") as runner:
        runner.start(starts(unit, solver, tolerance))
        runner.advance(0.0, 1.001 * gait["period"])
        found = runner.read(f"apex.{name}" for name in COORDINATES).values()
        pairs = zip(found, gait["apex"], scales(unit), strict=True)
        error = max(abs(value - known) / scale for value, known, scale in pairs)
        return error, runner.value("solver.evaluations")


def loosest_tolerance(unit: Unit, solver: str) -> tuple[float, float]:
    """The loosest tolerance from which on all tighter ones are accurate enough, and its error.

    Raises:
        RunError: no tolerance is.
    """
    found = None
    for tolerance in reversed(TOLERANCES):
        error, _ = stride_error(unit, solver, tolerance)
        if error > WANTED_ERROR:
            break
        found = tolerance, error
    if found is None:
        raise RunError(
            f"{solver}: no tolerance down to {TOLERANCES[-1]:g} reaches an error of {WANTED_ERROR:g}"
        )
    return found


def measure(unit: Unit, solver: str, strides: int, repeats: int) -> Measurement:
    """Time a solver over many strides of the gait, several times."""
    tolerance, error = loosest_tolerance(unit, solver)
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
    """Measure both solvers on this machine, single-threaded.

    Args:
        effort: scales the number of strides.
        show_progress: a bar on stderr.
        unit: the unit to measure; by default that of `fmu_path`.

    Raises:
        InputError: the unit was built without CVODE.
        RunError: a solver does not reach the wanted error.
    """
    unit = load() if unit is None else unit
    measurements = []
    with progress.bar("bench", len(STRIDES), "solvers", show_progress) as bar:
        for solver, strides in STRIDES.items():
            measurements.append(measure(unit, solver, max(1, round(effort * strides)), REPEATS))
            bar.update(1)
    return Bench(tuple(measurements), f"{_processor()}, {platform.system()} {platform.machine()}")


def _processor() -> str:
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            return next(line.split(":", 1)[1].strip() for line in file if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or "unknown processor"
