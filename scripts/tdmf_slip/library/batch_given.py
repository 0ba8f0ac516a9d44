"""Arguments of a batch: runners, apices, ground, a law and settings, all checked once."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import (
    check_kind,
    check_size,
    checked_between,
    checked_threads,
    checked_whole,
    is_one_of,
    reading,
    shown,
)
from ..errors import InputError, counted
from ..given import is_series, numbers_by, row_of
from ..variables.parameters import RunnerLike
from ..variables.table import Model, by_full_name, model_of
from . import c_structs
from .c_structs import WIDTH
from .engine import LAST_STRIDE, instruction_sets
from .ground import LAST_RUNNER, RoughGround, check_has_ground
from .laws import AffineLaw, Law, check_law, numbers_up_to
from .members import INPUTS
from .page_model import PageModel
from .return_map import PATCH, refuse_patch
from .runner import Runner
from .settings import check_settings, checked_values, setting_number

TOLERANCE = 2e-10
"""Relative tolerance of a step of the engine by default."""
MIN_TOLERANCE = 1e-30
"""Smaller tolerances need so many steps that no stride closes, and rounding has long decided."""
MAX_RUNNERS = 10_000_000
"""Runners in a batch: start and end of one take 300 bytes. More go in several batches, with first numbers."""


LEVEL = RoughGround()
"""Ground as the runner's inputs say."""


class Given:
    """Runners side by side with their starts, as C takes them, and what they run on and by: see `Batch`."""

    def __init__(
        self,
        runners: RunnerLike | Sequence[RunnerLike] = None,
        apices: ArrayLike | None = None,
        ground: RoughGround | None = None,
        law: Law | None = None,
        *,
        vary: Mapping[str, ArrayLike] | None = None,
        inputs: Mapping[str, ArrayLike] | None = None,
        model: str | Model | None = None,
        foot_x: ArrayLike | None = None,
        first_number: int = 0,
        tolerance: float = TOLERANCE,
        step_limit: int | None = None,
        threads: int | None = None,
        instructions: str | None = None,
    ) -> None:
        self.varied: dict[str, NDArray[np.float64]] = {}
        with reading("runners", runners, "a runner, or one or more in a list"):
            first = runners[0] if isinstance(runners, list | tuple) and runners else runners
        self.model = model_of(first, model)
        aliases = self.model.aliases
        self._read_runners(
            runners, model, {} if vary is None else by_full_name(vary, "vary", "arrays by name", aliases)
        )
        self.size = len(self.runner.coordinates)
        self._read_apices(runners, apices, foot_x, inputs)
        self.ground, self.law = LEVEL if ground is None else ground, law
        self.threads, self.instructions, self.step_limit = threads, instructions, step_limit
        self.first_number = checked_whole("first_number", first_number, 0, LAST_RUNNER)
        if step_limit is not None:
            self.step_limit = checked_whole("step_limit", step_limit, 1, LAST_STRIDE)
        if threads is not None:
            checked_threads(threads)
        if instructions is not None and not is_one_of(instructions, instruction_sets()):
            allowed = ", ".join(instruction_sets())
            raise InputError(f"instructions {shown(instructions)}: allowed here: {allowed}")
        self.tolerance = checked_between("tolerance", tolerance, MIN_TOLERANCE, 1.0)
        if ground is not None or law is not None or self.inputs:
            self._check_law_and_ground()

    def _read_runners(self, given: Any, model: str | Model | None, vary: dict[str, Any]) -> None:
        """Models and inputs of all runners, or of one for all."""
        self._read_varied(vary)
        if given is None or isinstance(given, Runner | Model | str | os.PathLike) or hasattr(given, "runner"):
            runners = [_runner_of(given, model)]
        elif isinstance(given, Sequence) and not is_series(given):
            several = row_of(given, "runners", "one or more runners in a list", MAX_RUNNERS)
            if not several:
                raise InputError("runners: none; allowed: one or more")
            runners = [_runner_of(one, model) for one in several]
            other = next((runner.model for runner in runners if runner.model is not self.model), None)
            if other is not None:
                both = f"of the models {self.model.name} and {other.name}"
                raise InputError(f"runners: {both}; allowed: all of one model")
        else:
            allowed = "a Runner, or numbers or arrays by name"
            by_name = by_full_name(given, "runner", allowed, self.model.aliases)
            rows = {name: value for name, value in by_name.items() if _is_row(value)}
            self._read_varied({name: row for name, row in rows.items() if name not in vary})
            first = {name: float(row[0]) for name, row in self.varied.items()}
            runners = [Runner({**by_name, **first}, model=model)]
        if vary and len(runners) > 1:
            raise InputError("vary with a list of runners; allowed: with one runner")
        self.runner, self.runners = runners[0], runners
        self.models: NDArray[Any]
        self.held: NDArray[Any]
        if isinstance(self.model, PageModel):
            self.models, self.held = page_numbers(runners, self.varied)
            return
        if len(runners) == 1:
            self.models = c_structs.viewed(self.runner.c_model, c_structs.MODEL)
            self.held = self.runner.inputs
        else:
            self.models = c_structs.copied([runner.c_model for runner in runners])
            self.held = np.array([runner.inputs[0] for runner in runners], INPUTS)
        if self.varied:
            self.models = c_structs.models_of(c_structs.written(self.runner.parameters, self.varied))
            self.held = c_structs.written(self.held, self.varied)
        if self.runner.reduced:
            self.refuse_patches()

    def _read_varied(self, vary: Mapping[str, Any]) -> None:
        """Values of each runner by name."""
        for name, row in vary.items():
            variable = self.model.variables.find(name, "runner")
            is_flag = variable.type == "Boolean"
            if name not in self.model.varied and not (is_flag and variable.causality == "parameter"):
                raise InputError(
                    f"runner: {name} of shape {np.shape(row)}; allowed in an array: a parameter or input "
                    "of the model"
                )
            if is_flag:
                flags = row_of(row, f"runner: {name}", "true or false for each runner")
                values = [variable.value_of(flag, f"runner: runner {k}") for k, flag in enumerate(flags)]
                self.varied[name] = np.array(values, float)
            else:
                self.varied[name] = np.atleast_1d(numbers_up_to(f"runner: {name}", row, 1))
                checked_values(name, self.varied[name], "runner", {"runner": 0}, self.model)
            first = next(iter(self.varied))
            if len(self.varied[name]) != len(self.varied[first]):
                raise InputError(
                    f"runner: {name} of {counted(len(self.varied[name]), 'runner')}, {first} of "
                    f"{len(self.varied[first])}; allowed: as many of each"
                )

    def _read_apices(self, runners: Any, apices: Any, foot_x: Any, inputs: Any) -> None:
        """Starts, shape (runners, `WIDTH`), settings and feet of as many runners."""
        names = self.runner.coordinates
        if apices is None:
            if len(self.runners) > 1:
                pairs = zip(runners, self.runners, strict=True)
                rows = np.array([_start_of(given, runner) for given, runner in pairs])
            else:
                rows = _start_of(runners[0] if isinstance(runners, list | tuple) else runners, self.runner)
        else:
            rows = numbers_by("apices", apices, names)
        if rows.ndim not in (1, 2) or rows.shape[-1] != self.size:
            raise InputError(f"apices of shape {rows.shape}; allowed: rows of {', '.join(names)}")
        self.inputs: dict[str, NDArray[np.float64]] = {}
        counts = {
            "apices": len(rows) if rows.ndim == 2 else 1,
            "runner's values": max(len(self.models), len(self.held)),
        }
        feet = None if foot_x is None else self._read_feet(foot_x)
        if feet is not None:
            counts["foot_x"] = len(feet)
        if inputs is not None:
            self._read_inputs(inputs, counts)
        count = 0 if counts["apices"] == 0 else max(counts.values())
        check_size("runners", count, "runners", MAX_RUNNERS)
        for what, number in counts.items():
            if number not in (1, count):
                most = max(counts, key=lambda name: counts[name])
                raise InputError(
                    f"{what} of {counted(number, 'runner')}, {most} of {count}; "
                    "allowed: as many, or one for all"
                )
        self.is_single = rows.ndim == 1 and count == 1
        self.starts = np.zeros((count, WIDTH))
        self.starts[:, : self.size] = rows
        self.foot_x = None if feet is None else np.broadcast_to(feet, count).copy()

    def _read_inputs(self, inputs: Any, counts: dict[str, int]) -> None:
        aliases = self.model.aliases
        for name, asked in by_full_name(inputs, "inputs", "numbers or arrays by name", aliases).items():
            setting_number(name, "inputs", self.model)
            values = np.atleast_2d(numbers_up_to(f"inputs: {name}", asked, 2))
            self.inputs[name] = checked_values(name, values, "inputs", {"runner": 0, "stride": 0}, self.model)
            counts[f"inputs: {name}"] = len(values)

    def _read_feet(self, foot_x: Any) -> NDArray[np.float64]:
        check_has_ground(self.model, "foot_x")
        feet = np.atleast_1d(numbers_up_to("foot_x", foot_x, 1))
        return checked_values("foot.x", feet, "foot_x", {"runner": 0})

    def _check_law_and_ground(self) -> None:
        """Refuse what does not go together."""
        check_kind(self.ground, RoughGround, "ground", "a RoughGround")
        if self.ground.is_drawn:
            check_has_ground(self.model, "ground")
        for runner in self.runners:
            self.ground.check_runner(runner, runner.scales)
        check_law(self.law, self.runner)
        names, too = tuple(self.inputs), tuple(self.varied)
        check_settings(names, self.runner, self.ground, "inputs", set_too=too)
        if isinstance(self.law, AffineLaw):
            check_settings(
                tuple(self.law.inputs), self.runner, self.ground, "law", set_too=(*names, *too), inputs=names
            )

    def refuse_patches(self) -> None:
        """Refuse a patch of ground: an apex does not say where the foot stands."""
        for runner in self.runners:
            refuse_patch(runner)
        if any(name in self.varied for name in PATCH):
            count = len(self.models)
            begin, end = (np.broadcast_to(self.varied.get(name, self.runner[name]), count) for name in PATCH)
            longest = np.argmax(end - begin)
            refuse_patch(dict(zip(PATCH, (float(begin[longest]), float(end[longest])), strict=True)))

    def value_of(self, name: str) -> float | NDArray[np.float64]:
        """A parameter's or input's value, or one for each runner, shape (runners,)."""
        if name in self.varied:
            return self.varied[name]
        if len(self.runners) > 1:
            return np.array([runner[name] for runner in self.runners])
        return self.runner[name]

    def __len__(self) -> int:
        """The number of runners."""
        return len(self.starts)

    def __repr__(self) -> str:
        """The number of runners, their model, and what varies among them, in one line."""
        count = counted(len(self), "runner")
        among = f", over {', '.join(self.varied)}" if self.varied else ""
        ground = ", on rough ground" if self.ground.is_drawn else ""
        law = "" if self.law is None else ", with a law"
        return f"<{type(self).__name__} of {count}, model {self.model.name}{among}{ground}{law}>"

    def part(self, first: int, count: int) -> Self:
        """Some of the runners as a batch of their own, with the same numbers."""
        some = slice(first, first + count)
        part = type(self).__new__(type(self))
        part.__dict__.update(self.__getstate__())
        part.starts, part.first_number = self.starts[some], self.first_number + first
        part.varied = {name: row[some] for name, row in self.varied.items()}
        part.runners = self.runners[some] if len(self.runners) > 1 else self.runners
        part.models, part.held = (
            structs[some] if len(structs) > 1 else structs for structs in (self.models, self.held)
        )
        part.inputs = {name: row[some] if len(row) > 1 else row for name, row in self.inputs.items()}
        part.foot_x = None if self.foot_x is None else self.foot_x[some].copy()
        part.is_single = False
        return part

    def __getstate__(self) -> dict[str, Any]:
        """Everything that was given, for another process too."""
        return self.__dict__.copy()


def page_numbers(
    runners: Sequence[Any], varied: Mapping[str, NDArray[np.float64]]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Parameters and states of runners of a model of one's own, a row for each, or one for all."""
    parameters, states = (
        np.concatenate([getattr(runner, kind) for runner in runners]) for kind in ("parameters", "states")
    )
    for name, row in varied.items():
        model = runners[0].model
        is_state, place = model.value_places[model.positions[name]]
        numbers = states if is_state else parameters
        if len(numbers) != len(row):
            numbers = np.repeat(numbers[:1], len(row), axis=0)
        numbers[:, place] = row
        parameters, states = (parameters, numbers) if is_state else (numbers, states)
    return parameters, states


def _runner_of(given: Any, model: str | Model | None) -> Runner:
    """The runner that is given, with what it has made of itself, unless it has to be made."""
    runner = given if isinstance(given, Runner) else getattr(given, "runner", None)
    return runner if model is None and isinstance(runner, Runner) else Runner(given, model=model)


def _start_of(given: Any, runner: Runner) -> NDArray[np.float64]:
    """The apex of a gait; of anything else, where the runner starts."""
    at = getattr(given, "apex", None)
    return runner.start_apex() if at is None or callable(at) else np.asarray(at, float)


def _is_row(value: object) -> bool:
    """True if a value has an element for each runner."""
    return is_series(value) or isinstance(value, list | tuple) or getattr(value, "ndim", 0) > 0
