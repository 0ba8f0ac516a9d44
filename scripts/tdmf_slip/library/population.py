"""Runners that differ in some of their parameters and inputs, as the ensemble engine takes them."""

import os
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..contents import ByContents
from ..errors import InputError
from ..given import is_series, numbers_of, row_of
from ..variables.table import VARIABLES, by_full_name
from .affine_law import AffineLaw
from .binding import c, ffi
from .maps import PATCH, refuse_patch
from .members import FLAGS, MOVING, PARAMETERS, names_of
from .refusals import check_accepted
from .rough_ground import RoughGround
from .runner import Runner
from .settings import checked_values


@dataclass(frozen=True, eq=False)
class Population(ByContents):
    """A runner, and the values in which the members of a population differ from it."""

    runner: Runner
    """Runner whose other values all members have."""
    varied: Mapping[str, NDArray[np.float64]] = field(default_factory=dict)
    """Values of each member by name, shape (runners,)."""

    @classmethod
    def of(cls, given: Any, model: str | None = None) -> "Population":
        """A runner, or start values by name of which some are one for each runner."""
        if given is None or isinstance(given, str | os.PathLike | Runner) or hasattr(given, "runner"):
            return cls(Runner(given, model=model))
        by_name = by_full_name(given, "runner", "a Runner, or numbers or arrays by name")
        rows = {name: value for name, value in by_name.items() if _is_row(value)}
        runner = Runner({name: value for name, value in by_name.items() if name not in rows}, model=model)
        varied: dict[str, NDArray[np.float64]] = {}
        for name, row in rows.items():
            variable = VARIABLES.find(name, "runner")
            if name not in MOVING:
                raise InputError(
                    f"runner: {name} of shape {np.shape(row)}; allowed in an array: a parameter or input "
                    "of the model"
                )
            if name in FLAGS:
                flags = row_of(row, f"runner: {name}", "true or false for each runner")
                varied[name] = np.array(
                    [variable.value_of(flag, f"runner: runner {k}") for k, flag in enumerate(flags)],
                    dtype=float,
                )
            else:
                varied[name] = numbers(f"runner: {name}", row, 1)
                checked_values(name, varied[name], "runner", {"runner": 0})
            if len(varied[name]) != len(next(iter(varied.values()))):
                first = next(iter(varied))
                raise InputError(
                    f"runner: {name} of {len(varied[name])} runners, {first} of {len(varied[first])}; "
                    "allowed: as many of each"
                )
        return cls(runner, varied)

    @property
    def size(self) -> int | None:
        """How many runners; None where all are alike."""
        return len(next(iter(self.varied.values()))) if self.varied else None

    def part(self, first: int, count: int) -> "Population":
        """Some of the runners."""
        return replace(self, varied={name: row[first : first + count] for name, row in self.varied.items()})

    def c_cases(self, ground: RoughGround, law: AffineLaw | None) -> tuple[Any, list[object]]:
        """A case for each runner, or one for all, and what has to live as long."""
        count = self.size or 1
        if self.runner.reduced:
            self._refuse_patch(count)
        cases = ffi.new("tdmf_ensemble_case[]", count)
        models = ffi.new("tdmf_model[]", count)
        parameters = np.repeat(self.runner.parameters, count)
        inputs = np.repeat(self.runner.inputs, count)
        for name, values in self.varied.items():
            (parameters if name in names_of(PARAMETERS) else inputs)[name] = values
        c_parameters = ffi.from_buffer("tdmf_parameters[]", parameters)
        c_inputs = ffi.from_buffer("tdmf_inputs[]", inputs)
        kept: list[object] = [models, self.runner]
        c_law = ffi.NULL
        if law is not None:
            c_law, arrays = law.c_law()
            kept += [c_law, arrays]
        for k in range(count):
            check_accepted(c.tdmf_model_create(models + k, c_parameters + k), f"runner: runner {k}: ")
            cases[k].model, cases[k].inputs, cases[k].rules.law = models + k, c_inputs[k], c_law
            kept += ground.write(cases[k].rules)
        return cases, kept

    def _refuse_patch(self, count: int) -> None:
        begin, end = (np.broadcast_to(self.varied.get(name, self.runner[name]), count) for name in PATCH)
        longest = np.argmax(end - begin)
        refuse_patch(dict(zip(PATCH, (begin[longest], end[longest]), strict=True)))


def _is_row(value: object) -> bool:
    """Whether a value is one for each runner."""
    return is_series(value) or isinstance(value, list | tuple) or getattr(value, "ndim", 0) > 0


def numbers(what: str, given: object, dimensions: int) -> NDArray[np.float64]:
    """An array of numbers, of so many dimensions at the most."""
    values = numbers_of(what, given)
    if values.ndim > dimensions or not values.size:
        raise InputError(
            f"{what} of shape {values.shape}; allowed: one or more numbers, {dimensions} dimensions"
        )
    return values
