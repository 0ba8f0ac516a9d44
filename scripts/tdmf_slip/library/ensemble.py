"""Many runners at once, by the C library's ensemble engine: threads, and several runners to each processor.

::

    ends, work = run_ensemble([Case(runner)], apices, max_strides=100)
    ends["fate"] == FATES.index("settled")
"""

from collections.abc import Mapping, Sequence, Sized
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import check_size, checked_threads, checked_whole, is_one_of, number_of, refusal, shown
from ..errors import InputError
from ..given import numbers_of, row_of, rows_of
from ..uninterrupted import in_block
from ..variables.variable import Given
from .binding import c, ffi
from .cases import Case as Case
from .cases import c_cases, check_alike, sections_of
from .engine import run
from .refusals import text_of
from .rough_ground import LAST_RUNNER
from .runner import Runner
from .settings import checked_values
from .structs import Ensemble

TOLERANCE = 2e-10
"""Relative tolerance of a step by default."""
ACCURACY = 1e-8
"""By which a stride errs at the most at `TOLERANCE`: its apex over the scales of the section; its time,
distance and energies over sqrt(m/k), l0 and k l0^2. Held by starts anywhere in `analysis.volume.BOX`, and by
runners whose parameters differ from the default ones by factors of up to e."""
MIN_TOLERANCE = 1e-30
"""Steps for less are so many that no stride closes, and rounding has long decided."""
LAST_STRIDE = 2**31 - 1
MAX_RUNNERS = 10_000_000
"""In a call: start and end of one take 300 bytes. More go in several calls, with their first numbers."""
NEAR = 1e-2
"""Distance from a gait's apex, over the scales, at which a runner counts as settled."""
FATES = ("settled", "fell", "undecided", "no_start", "unsolved", "no_stride", "stopped")
"""By the library's numbers. Unsolved is what the solver did not get through: it may fall or not. The reduced
map alone has apices without a stride: nothing of it is then known but that it is over. An interrupt has ended
what is stopped."""
SETTLED = FATES.index("settled")
STOPPED = FATES.index("stopped")


@dataclass(frozen=True)
class Work:
    """What a run of the engine took."""

    strides: int
    """Closed by all runners."""
    events: int
    """Taken by all runners."""
    steps: int
    """Of all runners."""
    positions: int
    """Lanes stepped, with or without a runner in them."""
    evaluations: int
    """Coefficients of series."""
    layer_steps: int
    """Of the steps, those that might be no longer because friction falls with speed."""


def instruction_sets() -> tuple[str, ...]:
    """What this processor and this build have, the slowest first: `one by one` is the native solver."""
    return tuple(name for name, number in _INSTRUCTIONS.items() if c.tdmf_has_instructions(number))


def run_ensemble(
    cases: Sequence[Case | Runner | Mapping[str, Given]],
    apices: ArrayLike,
    case_of: ArrayLike | None = None,
    *,
    max_strides: int,
    first_number: int = 0,
    near: float = NEAR,
    tolerance: float = TOLERANCE,
    step_limit: int | None = None,
    threads: int | None = None,
    instructions: str | None = None,
    foot_x: NDArray[np.float64] | None = None,
) -> tuple[NDArray[np.void], Work]:
    """Follow runners from their starts until they settle, fall, or have made the most strides.

    Parameters
    ----------
    cases : sequence of Case
        Parameters, inputs and gaits; a runner alone, or its start values, stand for a case without gaits.
    apices : array_like of float, shape (runners, n)
        Where they start, one to a row, in the order of `library.section.COORDINATES`: m, m/s, m, rad, m/s,
        rad/s; of runners by the reduced map the first two.
    case_of : array_like of int, shape (runners,), optional
        The number of each runner's case; by default all have the first.
    max_strides : int
        A runner that has closed as many is undecided, as is one whose stride takes longer than 1e4 sqrt(m/k).
    first_number : int, default 0
        Of the first runner; by their numbers rough ground is drawn.
    near : float, default 1e-2
        Distance from a gait's apex, over the scales, at which a runner counts as settled.
    tolerance : float, default 2e-10
        Relative tolerance of a step.
    step_limit : int, optional
        Steps of a runner's first stride, at the most; each further one has those left over and a fortieth of
        them more. By default the library's `TDMF_STEP_LIMIT`. A runner that needs more is unsolved.
    threads : int, optional
        By default one for each processor, and one alone within a block of `run_blocks`. Results do not depend
        on it.
    instructions : str, optional
        One of `instruction_sets()`; by default the fastest. Results differ by rounding.
    foot_x : ndarray of float, shape (runners,), optional
        Where the feet are at the start, m, by default at 0; the ground may have a patch.

    Returns
    -------
    ends : structured ndarray, shape (runners,)
        With the fields of the library's `tdmf_ensemble_end`: `fate` (a number into `FATES`), `gait` (-1 for
        none), `strides`, `word_code`, and of the strides closed the last `apex` (all six coordinates), `time`
        (s), `distance` (m), `work` (of hip and leg), `hip_work`, `leg_work`, `external_work`, `damper_loss`,
        `friction_loss` and `impact_loss` (J).
    work : Work
        What was done.

    Raises
    ------
    InputError
        An array of another shape, or a value that is not allowed.
    StoppedError
        An interrupt from the keyboard came: a `KeyboardInterrupt` with the `ends` of all that had begun, the
        first ones; those that are not complete have the fate `stopped`.

    Examples
    --------
    >>> import tdmf_slip
    >>> from tdmf_slip.library.ensemble import run_ensemble
    >>> gait = tdmf_slip.find_gait({"ground.friction": 0.6})
    >>> faster = gait.apex.copy()
    >>> faster[1] *= 1.1
    >>> ends, work = run_ensemble([gait.runner], [gait.apex, faster], max_strides=20)
    >>> print(ends["strides"], ends["apex"][:, 1].round(3))
    [20 20] [1.063 1.068]
    """
    given = row_of(rows_of(cases, "cases"), "cases", "one or more cases in a list")
    if not len(given):
        raise InputError("cases: none; allowed: one or more")
    all_cases = [case if isinstance(case, Case) else Case(Runner(case)) for case in given]
    check_alike(all_cases)
    runner = all_cases[0].runner
    check_size("apices", len(apices) if isinstance(apices, Sized) else 1, "runners", MAX_RUNNERS)
    sections = sections_of("apices", apices, runner.coordinates)
    ensemble = ensemble_of(runner, sections, first_number, tolerance, threads, instructions)
    positions = None if foot_x is None else np.ascontiguousarray(numbers_of("foot_x", foot_x))
    if positions is not None:
        checked_values("foot.x", np.atleast_1d(positions), "foot_x", {"runner": 0})
        if positions.shape != (len(sections),):
            raise InputError(
                f"foot_x of shape {positions.shape}; allowed: finite numbers, ({len(sections)},), for each "
                "runner one"
            )
        ensemble.foot_x = ffi.cast("double *", ffi.from_buffer(positions))
    ensemble.step_limit = 0 if step_limit is None else checked_whole("step_limit", step_limit, 1, LAST_STRIDE)
    max_strides = checked_whole("max_strides", max_strides, 1, LAST_STRIDE)
    near = _within("near", near, 0.0, np.inf)
    made, kept = c_cases(all_cases, max_strides, near)
    ensemble.cases = made
    ensemble.case_count = len(all_cases)
    if case_of is not None:
        numbers = _case_numbers(case_of, len(sections), len(all_cases))
        ensemble.case_of = ffi.cast("int *", ffi.from_buffer(numbers))
    ends = np.zeros(len(sections), dtype=END)
    work = run(ensemble, ends, max_strides)
    del made, kept
    performed = Work(
        work.strides, work.events, work.steps, work.lane_steps, work.evaluations, work.layer_steps
    )
    return ends, performed


def ensemble_of(
    runner: Runner,
    sections: NDArray[np.float64],
    first_number: int,
    tolerance: float,
    threads: int | None,
    instructions: str | None,
) -> Ensemble:
    """A request of the library that is complete but for its cases."""
    ensemble: Ensemble = ffi.new("tdmf_ensemble *")
    settings = {
        "map": c.TDMF_REDUCED_MAP if runner.reduced else c.TDMF_RETURN_MAP,
        "starts": ffi.cast("double (*)[6]", ffi.from_buffer(sections)),
        "count": len(sections),
        "first_number": checked_whole("first_number", first_number, 0, LAST_RUNNER),
        "relative_tolerance": _within("tolerance", tolerance, MIN_TOLERANCE, 1.0),
        "threads": 1 if threads is None and in_block() else checked_threads(threads),
        "instructions": _number(instructions),
    }
    for name, value in settings.items():
        setattr(ensemble, name, value)
    return ensemble


def _case_numbers(case_of: ArrayLike, runners: int, cases: int) -> NDArray[np.intc]:
    given = numbers_of("case_of", case_of)
    if given.shape != (runners,) or not np.all((given >= 0) & (given < cases) & (given % 1 == 0)):
        raise InputError(f"case_of: allowed: {runners} numbers from 0 to {cases - 1}, one for each runner")
    return np.ascontiguousarray(given.astype(np.intc))


def _within(name: str, value: object, low: float, high: float) -> float:
    number = number_of(value)
    if number is None or not low < number < high:
        raise refusal(name, value, f"a number above {low:g} and below {high:g}")
    return number


def _number(instructions: str | None) -> int:
    if instructions is None:
        best: int = c.TDMF_BEST_INSTRUCTIONS
        return best
    if not is_one_of(instructions, instruction_sets()):
        raise InputError(f"instructions {shown(instructions)}: allowed here: {', '.join(instruction_sets())}")
    return _INSTRUCTIONS[instructions]


def dtype_of(struct: Any) -> np.dtype[np.void]:
    """A C struct of numbers, structs and arrays as NumPy sees it."""
    codes = {"int": "i4", "double": "f8"}

    def code(kind: Any) -> Any:
        if kind.kind == "struct":
            return dtype_of(kind)
        if kind.kind == "array":
            text = kind.item.cname == "char"
            return f"S{kind.length}" if text else (codes[kind.item.cname], kind.length)
        return codes[kind.cname]

    return np.dtype(
        {
            "names": [name for name, _ in struct.fields],
            "formats": [code(member.type) for _, member in struct.fields],
            "offsets": [member.offset for _, member in struct.fields],
            "itemsize": ffi.sizeof(struct),
        }
    )


END = dtype_of(ffi.typeof("tdmf_ensemble_end"))
"""Of a row that `run_ensemble` gives."""
_INSTRUCTIONS: Mapping[str, int] = {
    text_of(c.tdmf_instructions_name(number)): number for number in range(1, c.TDMF_INSTRUCTIONS_COUNT)
}
"""All that the library knows, by name."""
