"""Strides of models of pages, with derivatives and many at a time, and requests for their maps."""

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..uninterrupted import stop_flag
from .binding import c, ffi
from .c_structs import dtype_of
from .events import Event
from .members import Along
from .page_model import EVENT_ROOM, WORD, PageModel
from .returns import RunnerStrides

LONGEST = 1e4
"""Longest stride, s. The package's own models allow as many of their units of time."""
SEEDS = 8
"""Parameters and inputs by which one call differentiates."""
END, EVENT = dtype_of("tdmf_page_end"), dtype_of("tdmf_page_event")
OUTCOMES = np.full(7, c.TDMF_RETURN_UNSOLVED)
"""Outcomes of strides, by those of runs."""
OUTCOMES[[c.TDMF_PAGE_CROSSED, c.TDMF_PAGE_ENDED]] = c.TDMF_RETURN_CLOSED, c.TDMF_RETURN_FELL
OUTCOMES[[c.TDMF_PAGE_TOO_LONG, c.TDMF_PAGE_REFUSED]] = c.TDMF_RETURN_TOO_LONG, c.TDMF_RETURN_REFUSED


def seeds_of(model: PageModel, along: Sequence[Along]) -> NDArray[np.float64]:
    """Directions as changes of parameters and then of states, shape (seeds, parameters + states)."""
    rows = [model.seed({one: 1.0} if isinstance(one, str) else one) for one in along]
    width = len(model.table["parameters"]) + len(model.table["states"])
    return np.array([np.concatenate(row) for row in rows]).reshape(len(rows), width)


class PageStrides:
    """Strides of models of pages: where they begin, their ends, states with derivatives, and events."""

    def __init__(
        self,
        model: PageModel,
        points: NDArray[np.float64],
        ends: NDArray[Any],
        states: NDArray[np.float64],
        d_states: NDArray[np.float64] | None,
        rows: NDArray[Any],
    ) -> None:
        self.model, self.points, self.ends, self.states = model, points, ends, states
        self.d_states, self.rows = d_states, rows
        self.names = self.differentiable = tuple(model.quantities)
        self.outcome = OUTCOMES[ends["outcome"]]
        self.next_points = states[:, list(model.coordinate_numbers)]

    @property
    def next_points_by(self) -> NDArray[np.float64]:
        """Derivatives of `next_points`, shape (runners, n, by)."""
        assert self.d_states is not None
        return self.d_states[:, :, list(self.model.coordinate_numbers)].swapaxes(1, 2)

    def quantity(self, name: str) -> NDArray[np.float64]:
        """A quantity of the strides, shape (runners,)."""
        if name == "frequency":
            return 1.0 / self.quantity("period")
        if coordinate := self.model.quantities[name].coordinate:
            return self.points[:, self.model.coordinates.index(coordinate)]
        state = self.model.quantity_states[name]
        return self.ends["time"] if state is None else self.states[:, state]

    def derivative(self, name: str) -> NDArray[np.float64]:
        """Derivatives of a quantity by coordinates and seeds, shape (runners, by)."""
        assert self.d_states is not None
        if name == "frequency":
            return -self.derivative("period") / self.quantity("period")[:, None] ** 2
        if coordinate := self.model.quantities[name].coordinate:
            row = np.zeros(self.d_states.shape[:2])
            row[:, self.model.coordinates.index(coordinate)] = 1.0
            return row
        state = self.model.quantity_states[name]
        at = self.model.clock if state is None else state
        return np.full(self.d_states.shape[:2], np.nan) if at is None else self.d_states[:, :, at]

    @property
    def words(self) -> list[str]:
        """Words of the strides: that of the page, or the names of their events."""
        counts = np.minimum(self.ends["event_count"], EVENT_ROOM)
        events = (row["event"][:count] for row, count in zip(self.rows, counts, strict=True))
        return self.model.words(self.states[:, self.model.state_numbers.get(WORD, 0)], events)

    @property
    def events(self) -> tuple[Event, ...]:
        """Events of the first stride."""
        rows = self.rows[0, : min(self.ends["event_count"][0], EVENT_ROOM)]
        return tuple(
            Event(float(row["time"]), int(row["event"]), int(row["before"]), int(row["after"]), ())
            for row in rows
        )

    def why_not(self, number: int = 0) -> str:
        """Reason why a stride did not close, in words; empty where it did."""
        end, table = self.ends[number], self.model.table
        mode, event = " ".join(table["modes"][end["mode"]]), table["sections"][self.model.section]["event"]
        at = f"in the mode `{mode}` after {end['time']:.6g} s"
        return {
            c.TDMF_PAGE_CROSSED: "",
            c.TDMF_PAGE_ENDED: f"the run ends {at}",
            c.TDMF_PAGE_TOO_LONG: f"the run has not reached `{event}` and is {at}",
            c.TDMF_PAGE_REFUSED: self.model.why_refused(end["requirement"], self.states[number]),
        }.get(end["outcome"], f"the run cannot be followed {at}")


Strides: TypeAlias = RunnerStrides | PageStrides
"""One stride of each of some runners. Numbers of a stride that has not closed mean nothing."""


def strides_of(
    model: PageModel,
    parameters: NDArray[np.float64],
    states: NDArray[np.float64],
    points: NDArray[np.float64],
    *,
    tolerance: float,
    longest: float | None = None,
    seeds: NDArray[np.float64] | None = None,
    step_limit: int = 0,
    threads: int = 1,
    is_reported: bool = True,
) -> PageStrides:
    """One stride of each of many runners from points of the section, shape (runners, n).

    Parameters and states have a row for each runner, or one for all. With `seeds`, shape (seeds, parameters
    + states), strides are differentiated by the coordinates and along these directions. `longest` is the
    duration of a stride at the most, s. Strides that are not reported have points and ends alone, and take
    less time: their events are not kept, and nothing is observed along them.
    """
    count, width = len(points), len(states[0])
    request = MapRequest(model, parameters, states, tolerance, longest, seeds)
    room = EVENT_ROOM if is_reported else 0
    request.map.step_limit, request.map.event_room = step_limit, room
    request.map.is_unobserved = not is_reported
    ends, rows = np.zeros(count, END), np.zeros((count, room), EVENT)
    if is_reported:
        request.map.events = ffi.from_buffer("tdmf_page_event[]", rows)
    made, by = np.zeros((count, width)), None
    points = np.ascontiguousarray(points, float)
    flag = stop_flag()
    batch = ffi.new("tdmf_page_batch *")
    batch.map, batch.count, batch.threads = request.map, count, threads
    batch.parameters_of_each = parameters.shape[1] if len(parameters) > 1 else 0
    batch.states_of_each = width if len(states) > 1 else 0
    batch.points, batch.states = (ffi.from_buffer("double[]", array) for array in (points, made))
    batch.ends, batch.cancel = ffi.from_buffer("tdmf_page_end[]", ends), ffi.from_buffer("int[]", flag)
    if seeds is not None:
        by = np.zeros((count, points.shape[1] + len(seeds), width))
        batch.d_states = ffi.from_buffer("double[]", by)
    if not model.library.tdmf_page_strides(batch):
        raise MemoryError("the engine found no memory, or its request was not sound")
    if flag[0]:
        raise KeyboardInterrupt
    return PageStrides(model, points, ends, made, by, rows)


class MapRequest:
    """A return map as the library takes it, with the memory that it points to."""

    def __init__(
        self,
        model: PageModel,
        parameters: NDArray[np.float64],
        states: NDArray[np.float64],
        tolerance: float,
        longest: float | None = None,
        seeds: NDArray[np.float64] | None = None,
        *,
        is_section_needed: bool = True,
    ) -> None:
        section = model.checked_section if is_section_needed else model.section
        self.map = ffi.new("tdmf_page_map *")
        self._kept = [np.ascontiguousarray(array, float) for array in (parameters, states)]
        self.map.page, self.map.section = model.page, section
        self.map.parameters, self.map.states = (ffi.from_buffer("double[]", array) for array in self._kept)
        self.map.tolerance = tolerance
        self.map.longest = LONGEST if longest is None else longest
        if seeds is not None and len(seeds):
            columns = np.split(seeds, [parameters.shape[1]], axis=1)
            of_seeds = [np.ascontiguousarray(part) for part in columns]
            self._kept += of_seeds
            self.map.seed_count = len(seeds)
            self.map.d_parameters, self.map.d_states = (ffi.from_buffer("double[]", a) for a in of_seeds)
