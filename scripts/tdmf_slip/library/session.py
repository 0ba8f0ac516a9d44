"""A batch under way: a request to the engine that goes on, and what is set in each stride."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import checked_between
from ..errors import InputError
from ..given import numbers_by, numbers_of
from ..uninterrupted import in_block
from . import engine
from .batch_given import Given
from .c_structs import WIDTH
from .engine import Engine
from .laws import AffineLaw, CheckedLaw
from .settings import setting_number

LARGEST_BALL = 1e100
"""Largest number in a ball's matrix."""
WORK = ("strides", "events", "steps", "lane_steps", "evaluations", "layer_steps")
"""Counters of the engine: strides closed, events taken and steps of all runners; lanes stepped, occupied or
not; coefficients of series; steps shortened by a friction that falls with speed."""


class Session:
    """A request to the engine for a batch, which goes on, and what is set in each stride."""

    def __init__(self, batch: Given) -> None:
        self.batch = batch
        law, ground, single = batch.law, batch.ground, batch.is_single
        number = engine.ONE_BY_ONE if single else engine.BEST
        self.engine = Engine(
            batch.models,
            batch.held,
            batch.starts,
            reduced=batch.runner.reduced,
            tolerance=batch.tolerance,
            threads=batch.threads or (1 if single or in_block() else os.cpu_count() or 1),
            instructions=number if batch.instructions is None else engine.INSTRUCTIONS[batch.instructions],
            first_number=batch.first_number,
            step_limit=batch.step_limit or 0,
            foot_x=batch.foot_x,
        )
        if ground.is_drawn:
            self.engine.run_on(ground.rules, ground.terrain)
        self.function: CheckedLaw | None = None
        if isinstance(law, AffineLaw):
            self.engine.obey(law.settings)
        elif law is not None:
            self.function = CheckedLaw(law, batch.runner, ground, tuple(batch.varied), tuple(batch.inputs))
            self.engine.keep_checkpoints()
        self.names: tuple[str, ...] = ()
        self.values = np.empty((len(batch), 1, 0))
        self.made: list[NDArray[np.float64]] = []
        if batch.inputs and self.function is None:
            width = max(rows.shape[1] for rows in batch.inputs.values())
            self._set_by(tuple(batch.inputs), width)
            for number, rows in enumerate(batch.inputs.values()):
                self.values[..., number] = np.pad(rows, ((0, 0), (0, width - rows.shape[1])), "edge")

    def _set_by(self, names: tuple[str, ...], width: int) -> None:
        self.names = names
        self.values = np.empty((len(self.batch), width, len(names)))
        self.engine.set_by([setting_number(name, "settings") for name in names], self.values)

    def settle(self, until: Any, near: float, balls: ArrayLike | None) -> None:
        """Have runs end on gaits."""
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
        matrices = None if balls is None else numbers_of("balls", balls)
        if matrices is not None:
            fits = matrices.shape == (gaits.shape[1], size, size)
            if not fits or not np.all(np.abs(matrices) <= LARGEST_BALL):
                raise InputError(
                    f"balls: of shape {matrices.shape}; allowed: one for each gait, {size} by {size}, up to "
                    f"{LARGEST_BALL:g}"
                )
        self.engine.settle_on(wide, checked_between("near", near, 0.0, np.inf), matrices)

    def make(self, strides: int) -> dict[str, int]:
        """Make strides, all at once or, by a function, one after the other."""
        if self.function is None:
            work = self.engine.advance(strides)
            return {name: getattr(work, name) for name in WORK}
        done = dict.fromkeys(WORK, 0)
        for _ in range(strides):
            self._set(self._asked(self.function))
            self.made.append(self.values[:, 0].copy())
            work = self.engine.advance(1)
            done = {name: count + getattr(work, name) for name, count in done.items()}
            if not self.engine.keep_checkpoints()["stands"].any():
                break
        return done

    def _asked(self, function: CheckedLaw) -> dict[str, NDArray[np.float64]]:
        """Settings of the next stride, from the inputs and from the function."""
        engine, batch, stride = self.engine, self.batch, self.engine.made
        if stride == 0:
            apices, runs = batch.starts[:, : batch.size].copy(), np.full(len(batch), True)
        else:
            runs = engine.keep_checkpoints()["stands"]
            apices = np.where(runs[:, None], engine.ends["apex"][:, : batch.size], np.nan)
        given = {name: rows[:, min(stride, rows.shape[1] - 1)] for name, rows in batch.inputs.items()}
        return given | function(apices, stride, runs)

    def _set(self, settings: Mapping[str, ArrayLike]) -> None:
        """Set the next stride, by names that the first call decides."""
        if not self.names:
            self._set_by(tuple(settings), 1)
        elif set(settings) != set(self.names):
            raise InputError(
                f"settings: {', '.join(map(str, settings))}; allowed: {', '.join(self.names)}, as in the "
                "first call"
            )
        values = self.values[:, 0]
        for number, name in enumerate(self.names):
            values[:, number] = settings[name]
        self.engine.set_from(self.engine.made)

    def step(self, settings: Mapping[str, ArrayLike] | None) -> None:
        """One stride, without checks."""
        if self.function is not None:
            settings = {**self._asked(self.function), **(settings or {})}
        if settings:
            self._set(settings)
        self.engine.record_next()
        self.engine.advance(1)

    def settings_made(self, strides: int) -> dict[str, NDArray[np.float64]]:
        """Settings of each stride, by name, shape (runners, strides)."""
        if not self.names:
            return {}
        values = np.stack(self.made, axis=1) if self.made else self.values
        values = np.pad(values, ((0, 0), (0, max(0, strides - values.shape[1])), (0, 0)), "edge")
        return {name: values[:, :strides, number] for number, name in enumerate(self.names)}
