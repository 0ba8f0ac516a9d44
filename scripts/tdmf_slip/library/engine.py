"""A request to the C ensemble engine, with the memory that it points to, and what is set in each stride."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import checked_between
from ..errors import InputError, StoppedError
from ..given import numbers_by, numbers_of
from ..uninterrupted import in_block, stop_flag, uninterrupted
from .binding import c, check_accepted, ffi, text_of
from .c_structs import END, STATE, STRIDE, WIDTH, address, dtype_of
from .laws import AffineLaw, CheckedLaw, Law
from .page_model import EVENT_ROOM, PageModel
from .settings import setting_number

if TYPE_CHECKING:
    from .batch_given import Given

FEW = 64
"""Strides that run without a thread of their own: they take milliseconds."""
LAST_STRIDE = 2**31 - 1
FATES = ("settled", "fell", "undecided", "no_start", "unsolved", "no_stride", "stopped")
"""Fates of runners, by the library's numbers. The solver could not follow an unsolved runner, which may fall
or not. Only the reduced map has apices without a stride. An interrupt ended the runs that are stopped."""
SETTLED, FELL, UNDECIDED, UNSOLVED, STOPPED = (
    FATES.index(name) for name in ("settled", "fell", "undecided", "unsolved", "stopped")
)
INSTRUCTIONS: Mapping[str, int] = {
    text_of(c.tdmf_instructions_name(number)): number for number in range(1, c.TDMF_INSTRUCTIONS_COUNT)
}
"""Instruction sets that the library knows, by name."""
BEST: int = c.TDMF_BEST_INSTRUCTIONS
ONE_BY_ONE: int = c.TDMF_ONE_BY_ONE
LARGEST_BALL = 1e100
"""Largest number in a ball's matrix."""
WORK = ("strides", "events", "steps", "lane_steps", "evaluations", "layer_steps")
"""Counters of the engine: strides closed, events taken and steps of all runners; lanes stepped, occupied or
not; coefficients of series; steps shortened by a friction that falls with speed."""


def instruction_sets() -> tuple[str, ...]:
    """Instruction sets that can be used here, the slowest first."""
    return tuple(name for name, number in INSTRUCTIONS.items() if c.tdmf_has_instructions(number))


class Notes:
    """States and events of a model of one's own that the engine notes where strides close."""

    def __init__(self, model: PageModel, strides: int) -> None:
        states = np.array(list(model.noted), np.intc)
        room = 0 if model.letters else EVENT_ROOM
        self.values = np.zeros((strides, len(states)))
        self.events = np.zeros((strides, room), np.uint8)
        self.struct = ffi.new("tdmf_ensemble_notes *")
        self.struct.count, self.struct.event_room = len(states), room
        self._pointers = [
            ffi.from_buffer(kind, array)
            for kind, array in zip(
                ("int[]", "double[]", "unsigned char[]"), (states, self.values, self.events), strict=True
            )
        ]
        self.struct.states, self.struct.values, self.struct.events = self._pointers


class Engine:
    """A request to the ensemble engine for a batch, which goes on from call to call, and what is set there.

    `ends` and, where strides are recorded, `recorded` are what the engine writes, over runners.
    """

    def __init__(self, batch: Given) -> None:
        models, held, starts, foot_x = batch.models, batch.held, batch.starts, batch.foot_x
        self.batch, self.model, count = batch, batch.model, len(starts)
        self.library = self.model.library if isinstance(self.model, PageModel) else c
        self.made = 0
        self.ends = np.zeros(count, END)
        self.recorded: NDArray[Any] | None = None
        self.notes: Notes | None = None
        self.checkpoints: NDArray[Any] | None = None
        self._kept: list[Any] = [models, held, starts, foot_x]
        self._cases = cases = np.zeros(max(len(models), len(held)), dtype_of("tdmf_ensemble_case"))
        self.rules = cases["rules"]
        self._most = self.rules["max_strides"]
        self._work = ffi.new("tdmf_ensemble_work *")
        self._request = request = ffi.new("tdmf_ensemble *")
        if isinstance(self.model, PageModel):
            request.page, request.section = self.model.page, self.model.checked_section
            cases["parameters"], cases["states"] = self._rows(models), self._rows(held)
        else:
            request.map = c.TDMF_REDUCED_MAP if batch.runner.reduced else c.TDMF_RETURN_MAP
            cases["model"], cases["inputs"] = self._rows(models), held.view(cases.dtype["inputs"])
        request.cases, request.case_count = self._pointer("tdmf_ensemble_case[]", cases), len(cases)
        if len(cases) > 1:
            request.case_of = self._pointer("int[]", np.arange(count, dtype=np.intc))
        wide = f"double (*)[{WIDTH}]"
        request.starts, request.count = ffi.cast(wide, self._pointer("double[]", starts)), count
        if foot_x is not None:
            request.foot_x = self._pointer("double[]", foot_x)
        request.first_number, request.relative_tolerance = batch.first_number, batch.tolerance
        request.step_limit = batch.step_limit or 0
        request.threads = batch.threads or (1 if batch.is_single or in_block() else os.cpu_count() or 1)
        request.instructions = ONE_BY_ONE if batch.is_single else BEST
        if batch.instructions is not None:
            request.instructions = INSTRUCTIONS[batch.instructions]
        self._ends = ffi.from_buffer("tdmf_ensemble_end[]", self.ends)
        if batch.ground.is_drawn:
            self._run_on(batch.ground.rules, batch.ground.terrain)
        self._names: tuple[str, ...] = ()
        self._values = np.empty((count, 1, 0))
        self._set_so_far: list[NDArray[np.float64]] = []
        self._follow(batch.law)

    # ---- what runs are subject to

    def _follow(self, law: Law | None) -> None:
        """Set each stride by inputs and by a law: the engine itself, or a function before each call."""
        batch = self.batch
        self._function: CheckedLaw | None = None
        if isinstance(law, AffineLaw):
            self._kept.append(law)
            self.rules["law"] = int(ffi.cast("uintptr_t", law.in_c[0]))
        elif law is not None:
            names = tuple(batch.varied), tuple(batch.inputs)
            self._function = CheckedLaw(law, batch.runner, batch.ground, *names)
            self.keep_checkpoints()
        if batch.inputs and self._function is None:
            width = max(rows.shape[1] for rows in batch.inputs.values())
            self._make_room(tuple(batch.inputs), width)
            for number, rows in enumerate(batch.inputs.values()):
                self._values[..., number] = np.pad(rows, ((0, 0), (0, width - rows.shape[1])), "edge")

    def _make_room(self, names: tuple[str, ...], strides: int) -> None:
        """Have settings of some strides read from `_values`, shape (runners, strides, settings)."""
        numbers = [setting_number(name, "settings", self.model) for name in names]
        self._names, self._values = names, np.empty((len(self.ends), strides, len(names)))
        given = ffi.new("tdmf_given_settings *")
        given.count, given.strides = len(names), strides
        given.settings = self._pointer("int[]", np.array(numbers, np.intc))
        given.values = self._pointer("double[]", self._values)
        self._request.given = self._given = given

    def settle(self, until: Any, near: float, balls: ArrayLike | None) -> None:
        """Have runs end on gaits, or in their balls."""
        batch, size = self.batch, self.batch.size
        if batch.ground.segment_length:
            raise InputError(
                f"gaits on a terrain (segment_length = {batch.ground.segment_length:g} m), where no apex "
                "comes back; allowed: one of the two"
            )
        batch.refuse_patches()
        gaits = numbers_by("until", getattr(until, "apex", until), batch.runner.coordinates)
        gaits = gaits.reshape(*[1] * (3 - gaits.ndim), *gaits.shape)
        if gaits.ndim != 3 or gaits.shape[2] != size or gaits.shape[0] not in (1, len(batch)):
            raise InputError(
                f"until of shape {gaits.shape}; allowed: rows of {', '.join(batch.runner.coordinates)}"
            )
        if not np.isfinite(gaits).all():
            raise InputError(f"until: {gaits.tolist()}: allowed: finite numbers")
        wide = np.zeros((*gaits.shape[:2], WIDTH))
        wide[..., :size] = gaits
        self.rules["gaits"], self.rules["gait_count"] = self._rows(wide), gaits.shape[1]
        self.rules["distance"] = checked_between("near", near, 0.0, np.inf)
        if balls is None:
            return
        matrices = numbers_of("balls", balls)
        fits = matrices.shape == (gaits.shape[1], size, size)
        if not fits or not np.all(np.abs(matrices) <= LARGEST_BALL):
            raise InputError(
                f"balls: of shape {matrices.shape}; allowed: one for each gait, {size} by {size}, up to "
                f"{LARGEST_BALL:g}"
            )
        wide = np.zeros((len(matrices), WIDTH, WIDTH))
        wide[:, :size, :size] = matrices
        self.rules["balls"] = self._address(wide)

    def _run_on(self, ground: Mapping[str, Any], terrain: Mapping[str, Any]) -> None:
        """Write uneven ground into the rules: numbers, and rows of weights and heights."""
        for fields, rules in ((ground, self.rules), (terrain, self.rules["terrain"])):
            for name, value in fields.items():
                if isinstance(value, tuple):
                    rules[_COUNTS[name]] = len(value)
                    rules[name] = self._address(np.array(value, float)) if value else 0
                else:
                    rules[name] = value

    # ---- memory

    def _pointer(self, kind: str, array: NDArray[Any]) -> Any:
        """A pointer to an array that lives as long as the request."""
        pointer = ffi.from_buffer(kind, array)
        self._kept.append(pointer)
        return pointer

    def _address(self, array: NDArray[Any]) -> int:
        """The address of an array that lives as long as the request."""
        self._kept.append(array)
        return address(array)

    def _rows(self, array: NDArray[Any]) -> Any:
        """The address of each row of an array that lives as long as the request, or of its only one."""
        begin, size = self._address(array), array.nbytes // max(1, len(array))
        return begin + size * np.arange(len(array), dtype=np.uintp) if len(array) > 1 else begin

    # ---- records

    @property
    def fates(self) -> NDArray[np.int32]:
        """Fates of the runners, the engine's own array."""
        fates: NDArray[np.int32] = self.ends["fate"]
        return fates

    def record(self, strides: int) -> None:
        """Have strides recorded, shape (runners, strides), from the next one on."""
        self.recorded = np.zeros((len(self.ends), strides), STRIDE)
        self._request.strides = self._pointer("tdmf_ensemble_stride[]", self.recorded)
        self._request.first_stride, self._request.stride_count = self.made, strides
        if isinstance(self.model, PageModel):
            self.notes = Notes(self.model, len(self.ends) * strides)
            self._request.notes = self.notes.struct

    def keep_checkpoints(self) -> NDArray[Any]:
        """Have the engine keep where runners stand, so that they can go on."""
        if self.checkpoints is None:
            self.checkpoints = np.zeros(len(self.ends), STATE["checkpoint"])
            pointer = self._pointer("tdmf_ensemble_checkpoint[]", self.checkpoints)
            self._request.checkpoints = pointer
        return self.checkpoints

    def resume(self, states: NDArray[Any], stride: int) -> None:
        """Put every runner where a state was saved, at the apex where a stride of this number begins."""
        self.ends[:], self.keep_checkpoints()[:] = states["end"], states["checkpoint"]
        self.ends["strides"] = stride
        self.made = stride
        self._request.goes_on = True

    def save(self) -> NDArray[Any]:
        """States of all runners, shape (runners,)."""
        states = np.empty(len(self.ends), STATE)
        states["end"], states["checkpoint"] = self.ends, self.keep_checkpoints()
        return states

    # ---- strides

    def make(self, strides: int) -> dict[str, int]:
        """Make strides, all at once or, by a function, one after the other."""
        if self._function is None:
            work = self._advance(strides)
            return {name: getattr(work, name) for name in WORK}
        done = dict.fromkeys(WORK, 0)
        for _ in range(strides):
            self._set(self._asked(self._function))
            self._set_so_far.append(self._values[:, 0].copy())
            work = self._advance(1)
            done = {name: count + getattr(work, name) for name, count in done.items()}
            if not self.keep_checkpoints()["stands"].any():
                break
        return done

    def step(self, settings: Mapping[str, ArrayLike] | None) -> None:
        """One stride, without checks, which is recorded over the last one."""
        if self._function is not None:
            settings = {**self._asked(self._function), **(settings or {})}
        if settings:
            self._set(settings)
        self._request.first_stride = self.made
        self._advance(1)

    def settings_made(self, strides: int) -> dict[str, NDArray[np.float64]]:
        """Settings of each stride, by name, shape (runners, strides)."""
        if not self._names:
            return {}
        values = np.stack(self._set_so_far, axis=1) if self._set_so_far else self._values
        values = np.pad(values, ((0, 0), (0, max(0, strides - values.shape[1])), (0, 0)), "edge")
        return {name: values[:, :strides, number] for number, name in enumerate(self._names)}

    def _asked(self, function: CheckedLaw) -> dict[str, NDArray[np.float64]]:
        """Settings of the next stride, from the inputs and from the function."""
        batch, stride = self.batch, self.made
        if stride == 0:
            apices, runs = batch.starts[:, : batch.size].copy(), np.full(len(batch), True)
        else:
            runs = self.keep_checkpoints()["stands"]
            apices = np.where(runs[:, None], self.ends["apex"][:, : batch.size], np.nan)
        given = {name: rows[:, min(stride, rows.shape[1] - 1)] for name, rows in batch.inputs.items()}
        return given | function(apices, stride, runs)

    def _set(self, settings: Mapping[str, ArrayLike]) -> None:
        """Set the next stride, by names that the first call decides."""
        if not self._names:
            self._make_room(tuple(settings), 1)
        elif set(settings) != set(self._names):
            raise InputError(
                f"settings: {', '.join(map(str, settings))}; allowed: {', '.join(self._names)}, as in the "
                "first call"
            )
        values = self._values[:, 0]
        for number, name in enumerate(self._names):
            values[:, number] = settings[name]
        self._given.first = self.made

    def _advance(self, strides: int) -> Any:
        """Make more strides of all runners that still run; the work done, as the library counts it."""
        self._most[...] = self.made + strides
        flag, request = stop_flag(), self._request

        def engine() -> Any:
            request.stop = ffi.from_buffer("int[]", flag)
            try:
                refused = self.library.tdmf_run_ensemble(request, self._ends, self._work)
            finally:
                request.stop = ffi.NULL
            if flag[0]:
                raise KeyboardInterrupt
            return refused

        try:
            few = len(self.ends) * strides <= FEW
            refused = engine() if few else uninterrupted(engine, flag)
        except KeyboardInterrupt:
            raise StoppedError(self.ends[: self._work.begun]) from None
        check_accepted(refused)
        self.made += strides
        request.goes_on = True
        return self._work


_COUNTS = {
    "step_weights": "step_weight_count",
    "friction_weights": "friction_weight_count",
    "heights": "height_count",
}
"""Numbers of elements of rows in the rules."""
