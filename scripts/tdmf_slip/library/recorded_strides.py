"""Strides of many runners by the ensemble engine, each of them noted, with settings that change at apices."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..contents import ByContents
from .affine_law import AffineLaw
from .binding import ffi
from .engine import run
from .ensemble import END, dtype_of, ensemble_of
from .gait import LEDGER
from .measures import STRIDE_QUANTITIES
from .population import Population
from .rough_ground import RoughGround
from .section import COORDINATES
from .settings import setting_number

STRIDE_FATES = ("closed", "fell", "too_long", "no_start", "unsolved", "no_stride")
"""Of a stride: the fates of the engine's runners, who have nothing to settle on. One that is undecided before
its last stride is in one that takes too long."""
RECORDED = dtype_of(ffi.typeof("tdmf_ensemble_stride"))
CLOSED = STRIDE_FATES.index("closed")
GROUND = "ground.height"
FOOT_X = "foot.x"

Columns: TypeAlias = dict[str, NDArray[Any]]
"""By name: of each runner and stride, of apices also of each coordinate."""
Law: TypeAlias = Callable[[int, NDArray[np.float64], NDArray[np.bool_]], Mapping[str, NDArray[np.float64]]]
"""From a stride's number, apices, and which runners are under way: settings, shape (runners,)."""


@dataclass(frozen=True, eq=False)
class Request(ByContents):
    """Strides to make: a block of work."""

    population: Population
    """Who makes them."""
    apices: NDArray[np.float64]
    """Where they begin, shape (runners, n)."""
    strides: int
    """Of each."""
    given: Mapping[str, NDArray[np.float64]]
    """Settings by name, shape (runners, strides) or (runners, 1)."""
    law: AffineLaw | None = None
    """Or none."""
    ground: RoughGround = field(default_factory=RoughGround)
    """What they run on."""
    first_number: int = 0
    """Of the first runner."""
    tolerance: float = 2e-10
    """Of a step."""
    instructions: str | None = None
    """One of `instruction_sets()`; by default the fastest."""
    foot_x: NDArray[np.float64] | None = None
    """Where the feet are at the first apex, m, shape (runners,); by default all at 0."""

    def part(self, first: int, count: int) -> "Request":
        """Some of the runners."""
        some = slice(first, first + count)
        return replace(
            self,
            population=self.population.part(first, count),
            apices=self.apices[some],
            given={name: values[some] for name, values in self.given.items()},
            first_number=self.first_number + first,
            foot_x=None if self.foot_x is None else self.foot_x[some],
        )


def recorded_strides(request: Request, law: Law | None = None) -> Columns:
    """All strides of a block of runners."""
    engine = _Engine(request, goes_on=law is not None)
    if law is None:
        return engine.run(0, request.strides, request.given)
    parts: list[Columns] = []
    for stride in range(request.strides):
        apices, under_way = engine.where(stride)
        given = {name: values[:, min(stride, values.shape[1] - 1)] for name, values in request.given.items()}
        given |= law(stride, apices, under_way)
        parts.append(engine.run(stride, 1, {name: values[:, None] for name, values in given.items()}))
    return {name: np.concatenate([part[name] for part in parts], axis=1) for name in parts[0]}


class _Engine:
    """The library's request, which goes on from call to call."""

    def __init__(self, request: Request, goes_on: bool) -> None:
        self.request = request
        runner, count = request.population.runner, len(request.apices)
        self.coordinates = len(runner.coordinates)
        self.sections = np.zeros((count, len(COORDINATES)))
        self.sections[:, : self.coordinates] = request.apices
        self.ensemble = ensemble_of(
            runner,
            self.sections,
            request.first_number,
            request.tolerance,
            None,
            request.instructions,
        )
        self.foot_x = None if request.foot_x is None else np.ascontiguousarray(request.foot_x)
        if self.foot_x is not None:
            self.ensemble.foot_x = ffi.cast("double *", ffi.from_buffer(self.foot_x))
        self.cases, self.kept = request.population.c_cases(request.ground, request.law)
        self.case_of = (
            np.arange(count, dtype=np.intc) if request.population.varied else np.zeros(count, np.intc)
        )
        self.ensemble.cases, self.ensemble.case_count = self.cases, len(self.cases)
        self.ensemble.case_of = ffi.cast("int *", ffi.from_buffer(self.case_of))
        self.ends = np.zeros(count, END)
        self.checkpoints = ffi.new("tdmf_ensemble_checkpoint[]", count) if goes_on else ffi.NULL
        self.ensemble.checkpoints = self.checkpoints

    def where(self, stride: int) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
        """Apices at which a stride begins, NaN of runners whose run is over, and who is under way."""
        if stride == 0:
            return self.sections[:, : self.coordinates].copy(), np.full(len(self.ends), True)
        under_way = self.ends["strides"] == stride
        apices = np.where(under_way[:, None], self.ends["apex"][:, : self.coordinates], np.nan)
        return apices, under_way

    def run(self, first: int, count: int, given: Mapping[str, NDArray[np.float64]]) -> Columns:
        """So many strides from one on, with these settings."""
        recorded = np.zeros((len(self.ends), count), RECORDED)
        begin = self.where(first)[0]
        settings = given_settings(given, first) if given else None
        self.ensemble.given = ffi.NULL if settings is None else settings[0]
        self.ensemble.strides = ffi.cast("tdmf_ensemble_stride *", ffi.from_buffer(recorded))
        self.ensemble.first_stride, self.ensemble.stride_count = first, count
        self.ensemble.goes_on = first > 0
        for case in self.cases:
            case.rules.max_strides = first + count
        run(self.ensemble, self.ends, count)
        return self._columns(recorded, begin, first, given)

    def _columns(
        self,
        recorded: NDArray[np.void],
        begin: NDArray[np.float64],
        first: int,
        given: Mapping[str, NDArray[np.float64]],
    ) -> Columns:
        made = first + np.arange(recorded.shape[1]) - self.ends["strides"][:, None]
        closed = made < 0
        begun = recorded["began"] == 1
        next_apex = np.where(closed[..., None], recorded["apex"][..., : self.coordinates], np.nan)
        apex = np.concatenate([begin[:, None], next_apex[:, :-1]], axis=1)
        columns: Columns = {
            "fate": np.where(closed, CLOSED, self.ends["fate"][:, None]).astype(np.int8),
            "apex": apex,
            "next_apex": next_apex,
            **{name: _where(closed, recorded["stride"][name]) for name in STRIDE_QUANTITIES},
            **{name: _where(closed, recorded[name]) for name in (*LEDGER, "liftoff_angle")},
            "word": _words(recorded["stride"]["word"]),
        }
        if not self.request.population.runner.reduced:
            columns[FOOT_X] = _where(closed, recorded["foot_x"])
        if self.request.ground.roughness:
            columns[GROUND] = _where(begun, recorded["ground_height"])
        law = self.request.law
        for number, name in enumerate(law.inputs if law is not None else ()):
            columns[name] = _where(begun, recorded["set"][..., number])
        return columns | {name: _where(begun, values) for name, values in given.items()}


def given_settings(given: Mapping[str, NDArray[np.float64]], first: int) -> tuple[Any, object]:
    """Settings as the library takes them."""
    values = np.ascontiguousarray(np.stack(list(given.values()), axis=-1))
    settings = ffi.new("int[]", [setting_number(name, "settings") for name in given])
    made = ffi.new("tdmf_given_settings *")
    made.count, made.settings = len(given), settings
    made.first, made.strides = first, values.shape[1]
    made.values = ffi.cast("double *", ffi.from_buffer(values))
    return made, (settings, values)


def _where(there: NDArray[np.bool_], values: NDArray[Any]) -> NDArray[np.float64]:
    return np.where(there, values, np.nan)


def _words(words: NDArray[np.bytes_]) -> NDArray[np.str_]:
    """As short as the longest of them."""
    different, numbers = np.unique(words, return_inverse=True)
    texts = np.array([word.decode() for word in different])
    return texts[numbers.reshape(words.shape)]
