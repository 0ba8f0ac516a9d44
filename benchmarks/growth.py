"""Time that whole analyses take, against their size; each size is timed once."""

import functools
import os
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict, dataclass
from typing import NamedTuple

import numpy as np
from tdmf_slip.analysis.basin import basin
from tdmf_slip.analysis.branches import continue_branch
from tdmf_slip.checks import checked
from tdmf_slip.fitting.fitted import fit
from tdmf_slip.fitting.measurements import Measured, Measurements
from tdmf_slip.library.batch import Batch
from tdmf_slip.library.runner import Runner
from tdmf_slip.optimization.optimize import optimize
from tdmf_slip.terminal.progress import progress_bar
from tdmf_slip.terminal.text import table

from .results import versions_here
from .runners import FRICTION, Runners, runners_about_the_gait

STRIDES_EACH = 4
"""Strides of each runner in an ensemble."""
RUNNER = {"ground.friction": FRICTION}
TORQUE, ANGLE = "hip.stance_torque", "hip.touchdown_angle"


@dataclass(frozen=True)
class Timing:
    """One question of one size."""

    question: str
    """Name of the question."""
    size: str
    """Size of the question, in words."""
    threads: int
    """Number of threads that it may use."""
    seconds: float
    """Time by the wall clock, s."""
    processor_seconds: float
    """Time of all processors together, s."""


@dataclass(frozen=True, eq=False)
class Growth:
    """Timings, with the machine and the libraries that they were made with."""

    timings: tuple[Timing, ...]
    """Timings in the order of the table."""
    versions: Mapping[str, str]
    """Machine, and versions of the libraries."""

    def as_json(self) -> dict[str, object]:
        """The timings as a plain object."""
        timings = [asdict(timing) for timing in self.timings]
        return {**Runner(RUNNER).record(), "timings": timings, "versions": dict(self.versions)}

    def as_text(self) -> str:
        """The timings as a table."""
        rows = [
            (t.question, t.size, str(t.threads), f"{t.seconds:.3g}", f"{t.processor_seconds:.3g}")
            for t in self.timings
        ]
        header = ("question", "size", "threads", "seconds", "processor seconds")
        return "\n".join(
            [table(header, rows), "", *(f"{key}: {what}" for key, what in self.versions.items())]
        )


class _Question(NamedTuple):
    """A question, its size, the number of threads, and the function that answers it."""

    question: str
    size: str
    threads: int
    answer: Callable[[], object]


def _timed(asked: _Question) -> Timing:
    wall, own = time.perf_counter(), time.process_time()
    asked.answer()
    return Timing(
        asked.question, asked.size, asked.threads, time.perf_counter() - wall, time.process_time() - own
    )


def _basins(effort: float, threads: int) -> Iterator[_Question]:
    for cells in (128, 256, 512, 1024):
        n = max(2, round(cells * effort**0.5))
        yield _Question("basin", f"{n} x {n} starts", threads, functools.partial(basin, RUNNER, n=n))


def _run(many: Runners, count: int, threads: int) -> None:
    starts = np.resize(many.starts, (count, many.starts.shape[1]))
    Batch(many.runner, starts, threads=threads).run(STRIDES_EACH)


def _ensembles(effort: float, threads: int) -> Iterator[_Question]:
    many = runners_about_the_gait()
    for exponent in (4, 5, 6):
        count = max(1, round(effort * 10**exponent))
        for used in dict.fromkeys((1, threads)):
            size = f"{count:,} runners, {STRIDES_EACH} strides each"
            yield _Question("ensemble", size, used, functools.partial(_run, many, count, used))


def _optima() -> Iterator[_Question]:
    bounds = {TORQUE: (0.1, 0.3), ANGLE: (0.5, 0.9)}
    for count in (1, 2):
        vary = dict(list(bounds.items())[:count])
        search = functools.partial(optimize, RUNNER, vary, minimize="cost_of_transport", starts=1)
        yield _Question("optimize", f"{count} parameters, from one start", 1, search)


def _fits() -> Iterator[_Question]:
    for rows in (1, 4):
        speeds = np.linspace(0.95, 1.05, rows) if rows > 1 else np.array([1.0])
        data = Measurements(tuple({"speed": Measured(float(v), 0.01)} for v in speeds), "speeds")
        search = functools.partial(fit, RUNNER, data, vary_each=[TORQUE])
        yield _Question("fit", f"{rows} gaits, a torque each", 1, search)


def _branches() -> Iterator[_Question]:
    for end in (0.5, 0.2):
        follow = functools.partial(continue_branch, None, {"ground.friction": (FRICTION, end)})
        yield _Question("continue", f"friction {FRICTION} to {end}", 1, follow)


def growth(*, effort: float = 1.0, progress: bool = False) -> Growth:
    """Time whole questions by their size on this machine."""
    checked("effort", effort, 1e-4, 1.0)
    threads = os.cpu_count() or 1
    questions = [
        *_basins(effort, threads),
        *_ensembles(effort, threads),
        *_optima(),
        *_fits(),
        *_branches(),
    ]
    timings = []
    with progress_bar("growth", len(questions), "questions", progress) as bar:
        for question in questions:
            timings.append(_timed(question))
            bar.update(1)
    return Growth(tuple(timings), versions_here())
