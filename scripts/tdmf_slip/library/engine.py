"""A request to the C ensemble engine, with the memory that it points to."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..errors import StoppedError
from ..uninterrupted import stop_flag, uninterrupted
from .binding import c, check_accepted, ffi, text_of
from .c_structs import END, STATE, STRIDE, WIDTH, address, dtype_of
from .own_model import EVENT_ROOM, OwnModel

if TYPE_CHECKING:
    from .batch_given import Given
    from .runner import Runner

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


def instruction_sets() -> tuple[str, ...]:
    """Instruction sets that can be used here, the slowest first."""
    return tuple(name for name, number in INSTRUCTIONS.items() if c.tdmf_has_instructions(number))


def map_of(runner: Runner) -> int:
    """The map that takes a runner from apex to apex."""
    of: int = c.TDMF_REDUCED_MAP if runner.reduced else c.TDMF_RETURN_MAP
    return of


class Notes:
    """States and events of a model of one's own that the engine notes where strides close."""

    def __init__(self, model: OwnModel, strides: int) -> None:
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


class AffineSettings:
    """An affine law as the library takes it."""

    def __init__(
        self,
        numbers: Sequence[int],
        apex: Sequence[float],
        rows: Mapping[str, Any],
        gain: Any,
        noise: Sequence[float],
        seed: int,
    ) -> None:
        size, wide = len(apex), np.zeros((len(numbers), WIDTH))
        wide[:, :size] = gain
        self._arrays: dict[str, NDArray[Any]] = {
            "settings": np.array(numbers, np.intc),
            "gain": wide,
            **{name: np.array(row, float) for name, row in rows.items()},
        }
        self.struct = np.zeros(1, dtype_of("tdmf_affine_law"))
        for name, array in self._arrays.items():
            self.struct[name] = address(array)
        self.struct["count"], self.struct["seed"] = len(numbers), seed
        self.struct["apex"][0, :size], self.struct["noise"][0, :size] = apex, noise

    def at(self, apices: NDArray[np.float64], runners: NDArray[np.int64], stride: int) -> NDArray[np.float64]:
        """Settings of the law at apices of runners with these numbers, shape (runners, settings)."""
        sections = np.zeros((len(apices), WIDTH))
        sections[:, : apices.shape[1]] = apices
        values = np.empty((len(apices), len(self._arrays["settings"])))
        law = ffi.from_buffer("tdmf_affine_law *", self.struct)
        for runner, section, row in zip(runners.tolist(), sections, values, strict=True):
            begin, out = ffi.from_buffer("double[]", section), ffi.from_buffer("double[]", row)
            c.tdmf_affine_settings(law, begin, runner, stride, out)
        return values


class Engine:
    """A request to the ensemble engine, which goes on from call to call.

    `ends` and, where strides are recorded, `recorded` are what the engine writes, over runners.
    """

    def __init__(self, batch: Given, threads: int) -> None:
        models, held, starts, foot_x = batch.models, batch.held, batch.starts, batch.foot_x
        self.model, count = batch.model, len(starts)
        self.library = self.model.library if isinstance(self.model, OwnModel) else c
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
        if isinstance(self.model, OwnModel):
            request.page, request.section = self.model.page, self.model.checked_section
            cases["parameters"], cases["states"] = self._rows(models), self._rows(held)
        else:
            request.map = map_of(batch.runner)
            cases["model"], cases["inputs"] = self._rows(models), held.view(cases.dtype["inputs"])
        request.cases, request.case_count = self._pointer("tdmf_ensemble_case[]", cases), len(cases)
        if len(cases) > 1:
            request.case_of = self._pointer("int[]", np.arange(count, dtype=np.intc))
        wide = f"double (*)[{WIDTH}]"
        request.starts, request.count = ffi.cast(wide, self._pointer("double[]", starts)), count
        if foot_x is not None:
            request.foot_x = self._pointer("double[]", foot_x)
        request.first_number, request.relative_tolerance = batch.first_number, batch.tolerance
        request.step_limit, request.threads = batch.step_limit or 0, threads
        request.instructions = ONE_BY_ONE if batch.is_single else BEST
        if batch.instructions is not None:
            request.instructions = INSTRUCTIONS[batch.instructions]
        self._ends = ffi.from_buffer("tdmf_ensemble_end[]", self.ends)
        if batch.ground.is_drawn:
            self._run_on(batch.ground.rules, batch.ground.terrain)

    def _rows(self, array: NDArray[Any]) -> Any:
        """Address of each row of an array that lives as long as the request, or of the only one."""
        begin, size = address(array), array.nbytes // max(1, len(array))
        return begin + size * np.arange(len(array), dtype=np.uintp) if len(array) > 1 else begin

    @property
    def fates(self) -> NDArray[np.int32]:
        """Fates of the runners, the engine's own array."""
        fates: NDArray[np.int32] = self.ends["fate"]
        return fates

    def _pointer(self, kind: str, array: NDArray[Any]) -> Any:
        """A pointer to an array that lives as long as the request."""
        pointer = ffi.from_buffer(kind, array)
        self._kept.append(pointer)
        return pointer

    def _address(self, array: NDArray[Any]) -> int:
        """The address of an array that lives as long as the request."""
        self._kept.append(array)
        return address(array)

    def settle_on(
        self, gaits: NDArray[np.float64], distance: float, balls: NDArray[np.float64] | None = None
    ) -> None:
        """Have runs end at gaits, shape (cases or 1, gaits, `WIDTH`), or in balls, (gaits, size, size)."""
        begin = self._address(gaits)
        step = gaits[0].nbytes * np.arange(len(gaits), dtype=np.uintp) if len(gaits) > 1 else 0
        self.rules["gaits"], self.rules["gait_count"] = begin + step, gaits.shape[1]
        self.rules["distance"] = distance
        if balls is not None:
            wide = np.zeros((len(balls), WIDTH, WIDTH))
            wide[:, : balls.shape[1], : balls.shape[2]] = balls
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

    def obey(self, law: AffineSettings) -> None:
        """Have the engine follow an affine law."""
        self._kept.append(law)
        self.rules["law"] = address(law.struct)

    def set_by(self, numbers: Sequence[int], values: NDArray[np.float64]) -> None:
        """Have settings read from `values`, shape (runners, strides, settings), where they may change."""
        given = ffi.new("tdmf_given_settings *")
        given.count, given.strides = len(numbers), values.shape[1]
        given.settings = self._pointer("int[]", np.array(numbers, np.intc))
        given.values = self._pointer("double[]", values)
        self._request.given = self._given = given

    def set_from(self, stride: int) -> None:
        """Set the stride that the first of the settings are for."""
        self._given.first = stride

    def record(self, strides: int) -> NDArray[Any]:
        """Have strides recorded, shape (runners, strides), from the next one on."""
        self.recorded = recorded = np.zeros((len(self.ends), strides), STRIDE)
        self._request.strides = self._pointer("tdmf_ensemble_stride[]", recorded)
        self._request.first_stride, self._request.stride_count = self.made, strides
        if isinstance(self.model, OwnModel):
            self.notes = Notes(self.model, len(self.ends) * strides)
            self._request.notes = self.notes.struct
        return recorded

    def record_next(self) -> None:
        """Have the next stride recorded over the last one."""
        self._request.first_stride = self.made

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

    def advance(self, strides: int) -> Any:
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
