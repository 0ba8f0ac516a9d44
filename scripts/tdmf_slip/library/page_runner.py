"""Runners of models of pages, and the maps that they go by."""

import math
from collections.abc import Sequence
from functools import cached_property
from typing import Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from ..errors import GaitNotFoundError, InputError, RunError
from ..variables.table import DIMENSIONS
from .binding import c, ffi
from .members import Along
from .page_model import PageModel
from .page_strides import MapRequest, PageStrides, seeds_of, strides_of
from .runner import Runner
from .section import Apex, checked_apex


class PageRunner(Runner):
    """A runner of the model of a page."""

    model: PageModel
    """The model."""
    parameters: NDArray[np.float64]  # type: ignore[assignment]
    """Parameters in the order of their numbers, shape (1, number of them)."""
    states: NDArray[np.float64]
    """States at the start in the order of their numbers, shape (1, number of them)."""

    def _prepared(self) -> dict[str, object]:
        """Parameters and states as the library takes them."""
        self.model.check_current()
        numbers = zip(("parameters", "states"), self.model.numbers(self._values), strict=True)
        return {name: row[None] for name, row in numbers}

    @cached_property
    def request(self) -> MapRequest:
        """The map of the runner as its library takes it."""
        return MapRequest(self.model, self.parameters, self.states, self.tolerance)

    @cached_property
    def state_scales(self) -> NDArray[np.float64]:
        """Typical sizes of all states."""
        found = np.zeros(self.states.shape[1])
        arrays = (ffi.from_buffer("double[]", array) for array in (self.parameters, found))
        self.model.library.tdmf_page_scales(self.model.page, *arrays)
        return found

    @cached_property
    def scales(self) -> NDArray[np.float64]:
        """Scales of the coordinates of the section."""
        return self.state_scales[list(self.model.coordinate_numbers)]

    def scale_of(self, unit: str) -> float:
        """The scale of quantities in a unit: that of the page's first state in the unit, else 1."""
        units = [state["unit"] for state in self.model.table["states"]]
        return float(self.state_scales[units.index(unit)]) if unit in units else 1.0

    def label(self, unit: str) -> str:
        """The label of a unit: that of the paper's only for runners of the paper's kind."""
        return super().label(unit) if unit in DIMENSIONS else unit

    def start_apex(self) -> NDArray[np.float64]:
        """The first crossing of the section by a run from the start values; refused if there is none."""
        states = np.zeros(self.states.shape[1])
        end: Any = self.model.library.tdmf_page_begin(
            self.request.map, ffi.from_buffer("double[]", states), ffi.NULL, ffi.NULL
        )
        if end.outcome == c.TDMF_PAGE_REFUSED:
            raise InputError(f"start values: {self.model.why_refused(end.requirement, states)}")
        if end.outcome != c.TDMF_PAGE_CROSSED:
            mode = " ".join(self.model.table["modes"][end.mode])
            raise GaitNotFoundError(
                f"no gait: the run from the start values does not reach the section; it is in the mode "
                f"`{mode}` after {end.time:.6g} s"
            )
        return states[list(self.model.coordinate_numbers)]

    apex = start_apex

    def stride(
        self,
        apex: NDArray[np.float64],
        until: float,
        *,
        varied: bool = False,
        along: Along | None = None,
        is_reported: bool = False,
    ) -> PageStrides:
        """One stride from a point of the section, always with its events."""
        return strides_of(
            self.model,
            self.parameters,
            self.states,
            np.asarray(apex, float)[None],
            tolerance=self.tolerance,
            longest=until if math.isfinite(until) else None,
            seeds=seeds_of(self.model, [] if along is None else [along]) if varied else None,
        )

    def settle(self, apex: NDArray[np.float64], strides: int) -> tuple[NDArray[np.float64], int]:
        """The last point of some strides, and how many of them closed."""
        for closed in range(strides):
            stride = self.stride(apex, np.inf)
            if stride.outcome[0]:
                return apex, closed
            apex = stride.next_points[0]
        return apex, strides

    def state_at(self, apex: Apex) -> dict[str, float]:
        """The states that take a start value at a point of the section, by their names in a unit."""
        point, states = checked_apex(apex, self.coordinates), np.zeros(self.states.shape[1])
        arrays = (ffi.from_buffer("double[]", array) for array in (point, states))
        if not self.model.library.tdmf_page_place(self.request.map, *arrays):
            raise InputError(f"an apex {point.tolist()}: allowed: finite numbers")
        places = zip(self.model.names, self.model.value_places, strict=True)
        found = {name: float(states[number]) for name, (is_state, number) in places if is_state}
        return {name: value for name, value in found.items() if name not in self.model.varied}

    def sampled(
        self,
        times: NDArray[np.float64],
        point: NDArray[np.float64] | None,
        along: Sequence[str],
        is_varied: bool,
    ) -> tuple[dict[str, NDArray[np.float64]], dict[str, NDArray[np.float64]], NDArray[np.intc], bool]:
        """States and outputs along a run at times, their derivatives, modes, and whether the run has ended.

        Derivatives are by the coordinates of the point, if the run begins at one, and then along seeds.
        """
        times, table, count = np.ascontiguousarray(times, float), self.model.table, ffi.new("int *")
        by = (0 if point is None else len(point)) + len(along)
        sizes = {name: len(table[name]) for name in ("states", "outputs")}
        rows = {name: np.zeros((len(times), size)) for name, size in sizes.items()}
        varied = {name: np.zeros((len(times), by, size)) for name, size in sizes.items()}
        modes, end = np.zeros(len(times), np.intc), np.zeros(self.states.shape[1])
        samples = ffi.new("tdmf_page_samples *")
        samples.count, samples.times = len(times), ffi.from_buffer("double[]", times)
        samples.point = ffi.NULL if point is None else ffi.from_buffer("double[]", point)
        samples.states, samples.outputs = (ffi.from_buffer("double[]", array) for array in rows.values())
        if is_varied:
            samples.d_states, samples.d_outputs = (
                ffi.from_buffer("double[]", array) for array in varied.values()
            )
        samples.modes = ffi.from_buffer("int[]", modes)
        request = MapRequest(
            self.model,
            self.parameters,
            self.states,
            self.tolerance,
            seeds=seeds_of(self.model, along),
            is_section_needed=point is not None,
        )
        found: Any = self.model.library.tdmf_page_begin(
            request.map, ffi.from_buffer("double[]", end), samples, count
        )
        if found.outcome == c.TDMF_PAGE_REFUSED:
            raise InputError(f"the start: {self.model.why_refused(found.requirement, end)}")
        if count[0] < len(times):
            mode = " ".join(table["modes"][found.mode])
            raise RunError(f"at {found.time:g} s: the run cannot be followed in the mode `{mode}`")
        return rows, varied, modes, found.outcome == c.TDMF_PAGE_ENDED

    def _refuse(self, what: str) -> NoReturn:
        raise InputError(f"{what}: is for the package's own models; this is the model {self.model.name}")

    @property
    def c_system(self) -> Any:
        """Refuse: the package's library does not take the runner."""
        self._refuse("a system of the package's library")

    def solver(self, log: Any | None = None) -> Any:
        """Refuse: the package's solver does not follow the runner."""
        self._refuse("the package's solver")
