"""Results of a benchmark: a measurement for each solver and accuracy, as an object and as tables."""

import datetime
import platform
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from importlib.metadata import version

from tdmf_slip.library.binding import c, ffi
from tdmf_slip.library.runner import Runner
from tdmf_slip.terminal.text import table

ACCURACIES = (1e-8, 1e-5)
"""Wanted of the apex after one stride, over its scales, from the gait's apex and all around it."""
ALONE = ", integrators alone"
"""Without the transitions between modes, which a user of heyoka writes in Python."""
MOTION = "native, without peaks and positive work"
"""The native solver by the ensemble engine, which makes the peaks of the ground force and the hip's positive
work only for whoever asks for its strides. Peers make neither."""
ONE, MANY = "one runner", "ensemble, on one processor"
REDUCED = "reduced map, on one processor"
"""The groups."""


@dataclass(frozen=True)
class Measurement:
    """One solver at the loosest tolerance that reaches an accuracy."""

    group: str
    """One runner, or many."""
    solver: str
    """Its name."""
    accuracy: float
    """Accuracy that was asked for."""
    tolerance: float
    """Loosest tolerance that reaches the accuracy."""
    error: float
    """Largest scaled error of a coordinate of the apex after one stride, from the worst start."""
    evaluations: float | None
    """Evaluations of the right-hand side, or of a coefficient of its series, per stride; None if unknown."""
    microseconds: float
    """Time of a stride, in the fastest of the repeats."""


@dataclass(frozen=True, eq=False)
class Bench:
    """Measurements, with the runner and the libraries that they were made with."""

    runner: Runner
    """Runner whose strides were timed."""
    measurements: tuple[Measurement, ...]
    """Measurements in the order of the table."""
    ours: Mapping[str, str]
    """Our solver that the others are compared with, by group."""
    threads: int
    """Number of threads of the ensemble."""
    scaling: float
    """Strides per second and thread of the ensemble, over those of a single thread."""
    versions: Mapping[str, str]
    """Versions by library."""
    missing: tuple[str, ...] = ()
    """Peers that are not installed."""

    def ratio(self, measurement: Measurement) -> float:
        """Time of a solver over the time of our own solver in its group."""
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
            **self.runner.record(),
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
        parts += [f"{name} is not installed: pip install {name.lower()}" for name in self.missing]
        parts += [f"{name}: {what}" for name, what in self.versions.items()]
        parts.append(f"hip.swing_clamp: {str(self.runner['hip.swing_clamp']).lower()}")
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


def versions_here() -> dict[str, str]:
    """The day, this machine, and what was measured."""
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
