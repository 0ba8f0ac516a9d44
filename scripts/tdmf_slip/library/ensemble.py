"""Many runners at once, by the C library's ensemble engine: threads, and several runners to each processor.

ends, work = run_ensemble([Case(runner)], starts, most_strides=100)
ends["fate"] == FATES.index("settled")
"""

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from numbers import Real

import numpy as np

from ..checks import check_kind
from ..errors import InputError
from ..unit.section import COORDINATES
from .binding import c, ffi
from .runner import Runner

TOLERANCE = 2e-10
"""Relative tolerance of a step by default."""
ACCURACY = 1e-8
"""By which a stride errs at the most at `TOLERANCE`: its apex over the scales of the section; its time,
distance and energies over sqrt(m/k), l0 and k l0^2. Held by starts anywhere in `attraction.BOX`, and by
runners whose parameters differ from the default ones by factors of up to e."""
LEAST_TOLERANCE = 1e-30
"""Steps for less are so many that no stride closes, and rounding has long decided."""
NEAR = 1e-2
"""Distance from a gait's apex, over the scales, at which a runner counts as settled."""
FATES = ("settled", "fell", "undecided", "no_start", "unsolved")
"""By the library's numbers. Unsolved is what the solver did not get through: it may fall or not."""


@dataclass(frozen=True)
class Case:
    """Whose parameters runners have, and what they may settle on.

    Start values by name stand for the runner that they make.
    """

    runner: Runner | Mapping[str, object]
    gaits: Sequence[Sequence[float]] = field(default=())
    """Apices; without any, runners make the most strides or fall."""

    def __post_init__(self) -> None:
        """Make the runner; refuse gaits that are none."""
        object.__setattr__(self, "runner", Runner.of(self.runner))
        check_kind(self.gaits, (Sequence, np.ndarray), "gaits", f"rows of {', '.join(COORDINATES)}")


@dataclass(frozen=True)
class Work:
    """What a run of the engine took."""

    strides: int
    events: int
    steps: int
    places: int
    """Lanes stepped, with or without a runner in them."""
    evaluations: int
    """Coefficients of series."""


def instruction_sets() -> tuple[str, ...]:
    """What this processor and this build have, the slowest first: `one by one` is the native solver."""
    every = range(1, c.TDMF_INSTRUCTIONS_COUNT)
    return tuple(_name(number) for number in every if c.tdmf_has_instructions(number))


def run_ensemble(
    cases: Sequence[Case | Runner | Mapping[str, object]],
    starts: np.ndarray,
    case_of: np.ndarray | None = None,
    *,
    most_strides: int,
    near: float = NEAR,
    tolerance: float = TOLERANCE,
    threads: int | None = None,
    instructions: str | None = None,
) -> tuple[np.ndarray, Work]:
    """Follow runners from their starts until they settle, fall, or have made the most strides.

    Parameters
    ----------
    cases : Sequence[Case | Runner | Mapping[str, object]]
        Parameters, inputs and gaits; a runner alone, or its start values, stand for a case without gaits.
    starts : ndarray
        Apices, one to a row, in the order of `section.COORDINATES`.
    case_of : ndarray, optional
        The number of each runner's case; by default all have the first.
    most_strides : int
        A runner that has closed as many is undecided, as is one whose stride takes longer than 1e4 sqrt(m/k).
    near : float, default NEAR
        Distance from a gait's apex, over the scales, at which a runner counts as settled.
    tolerance : float, default TOLERANCE
        Relative tolerance of a step.
    threads : int, optional
        By default one for each processor. Results do not depend on it.
    instructions : str, optional
        One of `instruction_sets()`; by default the fastest. Results differ by rounding.

    Returns
    -------
    tuple[ndarray, Work]
        A row for each runner with the fields of the library's `tdmf_ensemble_end`: `fate` (a number into
        `FATES`), `gait` (-1 for none), `strides`, `word_code`, and of the strides closed the last `apex`,
        `time`, `distance`, `work`, `damper_loss`, `friction_loss` and `impact_loss`; and the work that was
        done.

    Raises
    ------
    InputError
        An array of another shape, or a value that is not allowed.
    """
    sections = _apices("starts", starts)
    check_kind(cases, Sequence, "cases", "one or more cases in a list")
    if not len(cases):
        raise InputError("cases: none; allowed: one or more")
    cases = [case if isinstance(case, Case) else Case(case) for case in cases]
    ensemble = ffi.new("tdmf_ensemble *")
    ensemble.starts = ffi.cast("double (*)[6]", ffi.from_buffer(sections))
    ensemble.count = len(sections)
    ensemble.relative_tolerance = _within("tolerance", tolerance, LEAST_TOLERANCE, 1.0)
    ensemble.threads = _whole("threads", (os.cpu_count() or 1) if threads is None else threads)
    ensemble.instructions = _number(instructions)
    c_cases, kept = _c_cases(cases, _whole("most_strides", most_strides), _within("near", near, 0.0, np.inf))
    ensemble.cases = c_cases
    ensemble.case_count = len(cases)
    if case_of is not None:
        numbers = _case_numbers(case_of, len(sections), len(cases))
        ensemble.case_of = ffi.cast("int *", ffi.from_buffer(numbers))
    ends = np.zeros(len(sections), dtype=END)
    work = ffi.new("tdmf_ensemble_work *")
    if not c.tdmf_run_ensemble(ensemble, ffi.cast("tdmf_ensemble_end *", ffi.from_buffer(ends)), work):
        raise MemoryError("the ensemble engine found no memory")
    del kept
    return ends, Work(work.strides, work.events, work.steps, work.places, work.evaluations)


def _c_cases(cases: Sequence[Case], most_strides: int, near: float) -> tuple[object, list]:
    """The cases as the library takes them, and what has to live as long."""
    made = ffi.new("tdmf_ensemble_case[]", len(cases))
    kept: list[object] = []
    for case, its in zip(cases, made, strict=True):
        apices = _apices("gaits", case.gaits if len(case.gaits) else np.empty((0, len(COORDINATES))))
        if not np.isfinite(apices).all():
            raise InputError(f"gaits: {apices.tolist()}: allowed: finite numbers")
        gaits = ffi.new("double[][6]", apices.tolist())
        its.model, its.inputs = case.runner.model, case.runner.inputs[0]
        its.rules.gaits, its.rules.gait_count = gaits, len(case.gaits)
        its.rules.distance, its.rules.most_strides = near, most_strides
        kept += [gaits, case.runner]
    return made, kept


def _case_numbers(case_of: np.ndarray, runners: int, cases: int) -> np.ndarray:
    given = np.asarray(case_of)
    numbers = given.astype(np.intc) if given.dtype.kind in "iu" else None
    if numbers is None or given.shape != (runners,) or not np.all((given >= 0) & (given < cases)):
        raise InputError(f"case_of: allowed: {runners} numbers from 0 to {cases - 1}, one for each runner")
    return np.ascontiguousarray(numbers)


def _apices(name: str, given: object) -> np.ndarray:
    try:
        apices = np.ascontiguousarray(np.asarray(given).astype(float, casting="same_kind"))
    except (TypeError, ValueError) as problem:
        raise InputError(f"{name}: {problem}; allowed: rows of {', '.join(COORDINATES)}") from None
    if apices.ndim != 2 or apices.shape[1] != len(COORDINATES):
        raise InputError(f"{name} of shape {apices.shape}: allowed: rows of {', '.join(COORDINATES)}")
    return apices


def _within(name: str, value: float, low: float, high: float) -> float:
    if not isinstance(value, Real) or not low < value < high:
        raise InputError(f"{name} = {value!r}: allowed: a number above {low:g} and below {high:g}")
    return float(value)


def _whole(name: str, value: int) -> int:
    if not isinstance(value, Real) or not 1 <= value < 2**31 or value % 1:
        raise InputError(f"{name} = {value!r}: allowed: a whole number from 1 to {2**31 - 1}")
    return int(value)


def _name(number: int) -> str:
    return ffi.string(c.tdmf_instructions_name(number)).decode()


def _number(instructions: str | None) -> int:
    if instructions is None:
        return c.TDMF_BEST_INSTRUCTIONS
    known = {_name(number): number for number in range(1, c.TDMF_INSTRUCTIONS_COUNT)}
    if instructions not in instruction_sets():
        raise InputError(f"instructions {instructions}: allowed here: {', '.join(instruction_sets())}")
    return known[instructions]


def _dtype_of(name: str) -> np.dtype:
    """A C struct of numbers and arrays of numbers as NumPy sees it."""
    struct = ffi.typeof(name)
    codes = {"int": "i4", "double": "f8"}

    def code(kind: object) -> object:
        return (codes[kind.item.cname], kind.length) if kind.kind == "array" else codes[kind.cname]

    return np.dtype(
        {
            "names": [name for name, _ in struct.fields],
            "formats": [code(member.type) for _, member in struct.fields],
            "offsets": [member.offset for _, member in struct.fields],
            "itemsize": ffi.sizeof(struct),
        }
    )


END = _dtype_of("tdmf_ensemble_end")
