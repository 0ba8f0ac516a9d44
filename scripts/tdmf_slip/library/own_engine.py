"""The engine of batches for models of one's own: strides of many runners, stride by stride, in lanes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import StoppedError
from ..uninterrupted import stop_flag, uninterrupted
from .batch_given import Given
from .binding import c, ffi
from .engine import FATES, FELL, FEW, SETTLED, STOPPED, UNDECIDED, UNSOLVED
from .own_model import OwnModel
from .own_runs import OwnStrides, strides_of

NO_START = FATES.index("no_start")
RUNNING = -1
"""Fate of runners that still run."""
_FATES = np.full(7, UNSOLVED)
"""Fates of runners, by outcomes of runs."""
_FATES[[c.TDMF_PAGE_CROSSED, c.TDMF_PAGE_ENDED, c.TDMF_PAGE_TOO_LONG]] = RUNNING, FELL, UNDECIDED
_FATES[[c.TDMF_PAGE_REFUSED, c.TDMF_PAGE_CANCELLED]] = NO_START, STOPPED


class OwnEngine:
    """Runners of a model of one's own, which make strides from call to call, see `engine.Engine`."""

    def __init__(self, batch: Given, threads: int) -> None:
        model, count, size = batch.model, len(batch), batch.size
        assert isinstance(model, OwnModel)
        self.model, self.scales, self.made = model, batch.runner.scales, 0
        self.parameters, self.states, self.threads = batch.models, batch.held, threads
        self.tolerance, self.step_limit = batch.tolerance, batch.step_limit or 0
        self.names = tuple(n for n, of in model.quantities.items() if not of.coordinate and n != "frequency")
        ends = [("fate", "i4"), ("gait", "i4"), ("strides", "i4"), ("apex", "f8", (size,)), ("time", "f8")]
        self.ends = np.zeros(count, ends)
        self.ends["fate"], self.ends["gait"], self.ends["apex"] = RUNNING, -1, batch.starts[:, :size]
        self.recorded: NDArray[Any] | None = None
        self._first_recorded = 0
        self._gaits: NDArray[np.float64] | None = None
        self._balls: NDArray[np.float64] | None = None
        self._distance = 0.0
        self._given: tuple[Sequence[int], NDArray[np.float64]] = (), np.empty((count, 1, 0))
        self._given_from = 0
        self.fates = self.ends["fate"]

    # ---- what runs are subject to

    def settle_on(
        self, gaits: NDArray[np.float64], distance: float, balls: NDArray[np.float64] | None = None
    ) -> None:
        """Have runs end at gaits, shape (runners or 1, gaits, n), or in balls, (gaits, n, n)."""
        self._gaits, self._distance, self._balls = gaits[..., : self.ends["apex"].shape[1]], distance, balls
        self._settle(np.full(len(self.ends), True), balls_only=True)

    def set_by(self, numbers: Sequence[int], values: NDArray[np.float64]) -> None:
        """Have settings read from `values`, shape (runners, strides, settings), where they may change."""
        self._given, self._given_from = (numbers, values), 0

    def set_from(self, stride: int) -> None:
        """Set the stride that the first of the settings are for."""
        self._given_from = stride

    # ---- records

    def record(self, strides: int) -> NDArray[Any]:
        """Have strides recorded, shape (runners, strides), from the next one on."""
        numbers = [(name, "f8") for name in self.names]
        fields = [("began", "?"), ("apex", "f8", self.ends["apex"].shape[1:]), *numbers, ("word", "U160")]
        self.recorded, self._first_recorded = np.zeros((len(self.ends), strides), fields), self.made
        return self.recorded

    def record_next(self) -> None:
        """Have the next stride recorded over the last one."""
        self._first_recorded = self.made

    def keep_checkpoints(self) -> Mapping[str, NDArray[Any]]:
        """Mask of the runners that still run."""
        return {"stands": self.ends["fate"] == RUNNING}

    def save(self) -> NDArray[Any]:
        """States of all runners, shape (runners,)."""
        return self.ends.copy()

    def resume(self, states: NDArray[Any], stride: int) -> None:
        """Put every runner where a state was saved, at the apex where a stride of this number begins."""
        self.ends[:] = states
        self.ends["strides"] = self.made = stride

    # ---- strides

    def advance(self, strides: int) -> Any:
        """Make more strides of all runners that still run, and return the work done, without lanes."""
        work, flag = ffi.new("tdmf_ensemble_work *"), stop_flag()

        def engine() -> None:
            for _ in range(strides):
                runs = np.flatnonzero(self.ends["fate"] == RUNNING)
                if not len(runs):
                    break
                self._make(runs, work)
                self.made += 1

        try:
            if len(self.ends) * strides <= FEW:
                engine()
            else:
                uninterrupted(engine, flag)
        except KeyboardInterrupt:
            self.ends["fate"][self.ends["fate"] == RUNNING] = STOPPED
            raise StoppedError(self.ends) from None
        self.fates = np.where(self.ends["fate"] == RUNNING, UNDECIDED, self.ends["fate"]).astype(np.int32)
        return work

    def _make(self, runs: NDArray[np.int64], work: Any) -> None:
        """One stride of some runners."""
        parameters, states = self._numbers(runs)
        begin = self.ends["apex"][runs]
        if self.recorded is not None:
            self.recorded["began"][runs, self.made - self._first_recorded] = True
        made = strides_of(
            self.model,
            parameters,
            states,
            begin,
            tolerance=self.tolerance,
            step_limit=self.step_limit,
            threads=min(self.threads, max(1, len(runs) // 8)),
            is_reported=self.recorded is not None,
        )
        fates = _FATES[made.ends["outcome"]]
        self.ends["fate"][runs] = fates
        closed = fates == RUNNING
        done = runs[closed]
        self.ends["apex"][done] = made.next_points[closed]
        self.ends["time"][done] += made.ends["time"][closed]
        self.ends["strides"][done] += 1
        work.strides += len(done)
        work.events += int(made.ends["event_count"].sum())
        work.steps += int(made.ends["steps"].sum())
        work.begun = len(self.ends)
        if self.recorded is not None:
            self._write(made, runs, closed, self.made - self._first_recorded)
        is_running = np.full(len(self.ends), False)
        is_running[done] = True
        self._settle(is_running)

    def _numbers(self, runs: NDArray[np.int64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Parameters and states of some runners, with what is set for their next stride."""
        parameters, states = (of[runs] if len(of) > 1 else of for of in (self.parameters, self.states))
        numbers, values = self._given
        column = min(max(self.made - self._given_from, 0), values.shape[1] - 1)
        if numbers:
            parameters, states = (
                np.array(np.broadcast_to(o, (len(runs), o.shape[1]))) for o in (parameters, states)
            )
        for k, number in enumerate(numbers):
            is_state, place = self.model.value_places[number]
            (states if is_state else parameters)[:, place] = values[runs, column, k]
        return parameters, states

    def _write(
        self, made: OwnStrides, runs: NDArray[np.int64], closed: NDArray[np.bool_], column: int
    ) -> None:
        """Record strides."""
        assert self.recorded is not None
        done = runs[closed]
        self.recorded["apex"][done, column] = made.next_points[closed]
        for name in self.names:
            self.recorded[name][done, column] = made.quantity(name)[closed]
        self.recorded["word"][runs, column] = made.words

    def _settle(self, some: NDArray[np.bool_], *, balls_only: bool = False) -> None:
        """End runs that have come near a gait, or into its ball."""
        if self._gaits is None or not some.any():
            return
        runs = np.flatnonzero(some)
        gaits = self._gaits[runs] if len(self._gaits) > 1 else self._gaits
        off = self.ends["apex"][runs, None] - gaits
        reached = np.full(off.shape[:2], False)
        if not balls_only:
            reached |= (np.abs(off) <= self._distance * self.scales).all(axis=-1)
        if self._balls is not None:
            reached |= (np.einsum("gij,rgj->rgi", self._balls, off) ** 2).sum(axis=-1) <= 1.0
        settled = reached.any(axis=1)
        self.ends["fate"][runs[settled]] = SETTLED
        self.ends["gait"][runs[settled]] = reached[settled].argmax(axis=1)
