"""Structs of the C library as Python sees them: by the members that are read or written here.

Types only: what the library gives is told by its headers, see `binding`. Arrays in a struct are sequences.
"""

from collections.abc import Sequence
from typing import Protocol


class Struct(Protocol):
    """A struct, or a pointer to structs, that is only handed on to the library."""

    def __getitem__(self, index: int, /) -> "Struct":
        """The struct that a pointer points to."""
        ...


class Scales(Protocol):
    """`tdmf_scales`: a runner's own units, m, s, m/s, N and J."""

    length: float
    time: float
    speed: float
    force: float
    energy: float


class Model(Struct, Protocol):
    """`tdmf_model *`: accepted parameters with what is derived from them."""

    scales: Scales


class Center(Protocol):
    """`tdmf_point`: place, m, and velocity, m/s, of a centre of mass."""

    x: float
    y: float
    vx: float
    vy: float


class Measures(Protocol):
    """`tdmf_stride_measures`: what is measured along a stride, or the change of it; read by its names."""


class Measured(Protocol):
    """`tdmf_return` or `tdmf_stride_variation` as far as it is measured; in the reduced map it is not."""

    foot_clearance: float
    measures: Measures


class StrideVariation(Measured, Protocol):
    """`tdmf_stride_variation`: how next apex and stride change with something."""

    apex: Sequence[float]
    period: float
    length: float
    work: float
    stance_time: float
    slip_distance: float
    peak_force: float
    peak_vertical_force: float


class Stride(Protocol):
    """`tdmf_stride`: a completed stride; its quantities are read by their names."""

    length: float
    word: object


class Return(Measured, Protocol):
    """`tdmf_return`: what became of a stride; how it ended, `maps` can tell."""

    apex: Sequence[float]
    stride: Stride
    liftoff_angle: float
    outcome: int
    solver: int
    variations: Sequence[StrideVariation]
    """Along the coordinates of the start, and after them along the seeds."""


class FoundGait(Protocol):
    """`tdmf_orbit`: a gait, or where the search for it ended."""

    outcome: int
    iterations: int
    error: float
    apex: Sequence[float]
    """Of the reduced map the first two coordinates."""
    stride: Return


class Mode(Protocol):
    """`tdmf_mode`: a contact mode, by the library's number."""

    contact: int


class RecordedEvent(Protocol):
    """`tdmf_event`: an event that the solver took."""

    time: float
    guard: int
    before: Mode
    after: Mode
    state: Sequence[float]


class EventLog(Protocol):
    """`tdmf_event_log *`: events that the solver noted."""

    count: int
    events: Sequence[RecordedEvent]


class Solver(Protocol):
    """`tdmf_solver *`: the native solver's settings, and the work that it has done."""

    relative_tolerance: float
    step_limit: int
    log: EventLog
    strides: int
    steps: int
    events: int


class Refusal(Protocol):
    """`tdmf_refusal`: why a value was refused."""

    variable: object


class Ensemble(Protocol):
    """`tdmf_ensemble *`: runners that are to be run; what is left as it was made is not told here."""

    cases: object
    case_count: int
    case_of: object
    step_limit: int
    foot_x: object
    given: object
    strides: object
    first_stride: int
    stride_count: int
    checkpoints: object
    goes_on: bool
    stop: object


class Classic(Protocol):
    """`tdmf_classic *`: parameters of the classic SLIP."""

    mass: float
    gravity: float
    free_length: float
    touchdown_angle: float
    friction: float
    ground_slope: float
    retraction_rate: float


class ClassicPoint(Protocol):
    """`tdmf_classic_point`: the mass as seen from the foot, m and m/s."""

    x: float
    y: float
    vx: float
    vy: float


class ClassicVariation(Protocol):
    """`tdmf_classic_change`: how the next apex and the length of a step change with something."""

    height: float
    energy: float
    length: float


class ClassicStep(Protocol):
    """`tdmf_classic_step`: one step of the classic SLIP."""

    outcome: int
    touchdown: ClassicPoint
    take_off: ClassicPoint
    stance_time: float
    stance_friction: float
    impact_friction: float
    length: float
    next_height: float
    next_speed: float
    next_energy: float
    by_height: ClassicVariation
    by_energy: ClassicVariation
    by_touchdown_angle: ClassicVariation
    by_ground_slope: ClassicVariation
    by_retraction_rate: ClassicVariation
