"""The steps that all strides of one search share, whichever calls of the library make them.

A search is a function with `@shares_steps`. The first stride of a search may take `TDMF_STEP_LIMIT` steps.
Each further one may take those that are left over and a share more, by the rule in the C library's
`solver.h`. A search has a largest number of strides, so it ends, however short the steps become.
"""

from collections.abc import Callable
from contextvars import ContextVar
from functools import wraps
from typing import Any, ParamSpec, TypeVar

from ..uninterrupted import check_stop
from .binding import c

Given = ParamSpec("Given")
Result = TypeVar("Result")


class SharedSteps:
    """Work of a search so far."""

    def __init__(self) -> None:
        """A search that has done nothing yet."""
        self._left = float(c.TDMF_STEP_LIMIT)
        self._done = [0, 0, 0]
        self._last: Any | None = None

    def hand_out(self, solver: Any) -> None:
        """Limit a new solver to the steps that the ones before it have left over.

        In a thread whose flag is raised, the search stops here.
        """
        check_stop()
        self._count()
        solver.step_limit = int(self._left)
        self._last = solver

    def done(self) -> tuple[int, int, int]:
        """Strides closed, steps made, and events taken."""
        self._count()
        strides, steps, events = self._done
        return strides, steps, events

    def _count(self) -> None:
        if self._last is None:
            return
        work = self._last.strides, self._last.steps, self._last.events
        self._done = [before + more for before, more in zip(self._done, work, strict=True)]
        share = c.TDMF_STEP_LIMIT / c.TDMF_STEP_SHARE
        earned = share * max(1, self._last.strides)
        self._left = min(max(self._left - self._last.steps + earned, share), float(c.TDMF_STEP_LIMIT))
        self._last = None


_SEARCH: ContextVar[SharedSteps | None] = ContextVar("search", default=None)


def search_under_way() -> SharedSteps:
    """The search that this thread is in; outside of any search, a new one for a single call."""
    return _SEARCH.get() or SharedSteps()


def joins_search(search: Callable[Given, Result]) -> Callable[Given, Result]:
    """Make a function part of the search that calls it, and by itself a search."""
    alone = shares_steps(search)

    @wraps(search)
    def joining(*given: Given.args, **named: Given.kwargs) -> Result:
        return (search if _SEARCH.get() else alone)(*given, **named)

    return joining


def shares_steps(search: Callable[Given, Result]) -> Callable[Given, Result]:
    """Make a function a search. A search within it has steps of its own."""

    @wraps(search)
    def sharing(*given: Given.args, **named: Given.kwargs) -> Result:
        token = _SEARCH.set(SharedSteps())
        try:
            return search(*given, **named)
        finally:
            _SEARCH.reset(token)

    return sharing
