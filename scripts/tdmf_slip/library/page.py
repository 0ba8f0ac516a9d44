"""Return maps of the library's models that are written as pages of equations."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import count, takewhile
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InputError
from .binding import c, ffi, text_of

LONGEST = 1e6
"""Time to the next crossing at the most, s."""
TOLERANCE = 1e-14
"""Tolerance of a step, relative to the scales of the states."""


@cache
def names(page: str, kind: int) -> tuple[str, ...]:
    """Names of all parameters, states, modes, events or sections of a page, in the order of their numbers."""
    found = c.tdmf_page_named(page.encode())
    of_numbers = (c.tdmf_page_name(found, kind, number) for number in count())
    return tuple(text_of(name) for name in takewhile(lambda name: name != ffi.NULL, of_numbers))


def _checked(page: Any, parameter: int, value: float) -> float:
    least, most = ffi.new("double *"), ffi.new("double *")
    c.tdmf_page_range(page, parameter, least, most)
    if not least[0] <= value <= most[0]:
        name = text_of(c.tdmf_page_name(page, c.TDMF_PAGE_PARAMETER, parameter))
        raise InputError(f"{name} = {value:g}; allowed: from {least[0]:g} to {most[0]:g}")
    return value


@dataclass(frozen=True, eq=False)
class Run:
    """A run from a point of a section."""

    crossed: bool
    """True if the run reached the next crossing of the section."""
    mode: str
    """Mode at the end of the run."""
    time: float
    """Duration of the run, s."""
    states: Mapping[str, float]
    """States at the end of the run, by name."""
    derivatives: NDArray[np.float64]
    """Derivatives of the states by the coordinates of the point, then by seeds: a row for each."""

    def derivatives_of(self, state: str) -> NDArray[np.float64]:
        """Derivatives of a state by the coordinates of the point, then by seeds."""
        return self.derivatives[:, list(self.states).index(state)]


class PageMap:
    """The return map of a page's section, for a runner whose parameters are given by name.

    `seeds` are parameters by which a run is differentiated besides the coordinates of its point.
    """

    def __init__(
        self, page: str, section: str, given: Mapping[str, float], seeds: Sequence[str] = ()
    ) -> None:
        of, states = names(page, c.TDMF_PAGE_PARAMETER), names(page, c.TDMF_PAGE_STATE)
        self._page, self._states = page, states
        values, start = ffi.new("double[]", len(of)), ffi.new("double[]", len(states))
        self._map: Any = ffi.new("tdmf_page_map *")
        self._map.page = c.tdmf_page_named(page.encode())
        self._map.section = names(page, c.TDMF_PAGE_SECTION).index(section)
        c.tdmf_page_defaults(self._map.page, values, start)
        for name, value in given.items():
            values[of.index(name)] = _checked(self._map.page, of.index(name), value)
        along = ffi.new("double[]", max(1, len(seeds) * len(of)))
        for number, name in enumerate(seeds):
            along[number * len(of) + of.index(name)] = 1.0
        self._alive = values, start, along
        self._map.parameters, self._map.states, self._map.d_parameters = self._alive
        self._map.seed_count = len(seeds)
        self._map.tolerance, self._map.longest = TOLERANCE, LONGEST
        self.parameters: Mapping[str, float] = dict(zip(of, values, strict=True))

    def run(self, point: ArrayLike, until: float = LONGEST) -> Run:
        """Run from a point to the next crossing, or until a time, s, after the start."""
        at = np.atleast_1d(np.asarray(point, dtype=float))
        states = np.zeros(len(self._states))
        derivatives = np.zeros((len(at) + self._map.seed_count, len(states)))
        self._map.longest = until
        arrays = (ffi.from_buffer("double[]", array) for array in (at, states, derivatives))
        end: Any = c.tdmf_page_stride(self._map, *arrays)
        if end.outcome == c.TDMF_PAGE_REFUSED:
            raise InputError(f"{self._page}: a run from {at} until {until} s; allowed: finite numbers")
        return Run(
            end.outcome == c.TDMF_PAGE_CROSSED,
            names(self._page, c.TDMF_PAGE_MODE)[end.mode],
            end.time,
            dict(zip(self._states, states.tolist(), strict=True)),
            derivatives,
        )

    def fixed_point(self, guess: ArrayLike) -> NDArray[np.float64] | None:
        """A fixed point near a guess, by Newton's method; None if none is found."""
        self._map.longest = LONGEST
        point = np.array(guess, dtype=float, ndmin=1)
        return point if c.tdmf_page_fixed_point(self._map, ffi.from_buffer("double[]", point)) else None
