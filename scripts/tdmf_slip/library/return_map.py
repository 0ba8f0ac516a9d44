"""One stride from apex to apex, by the return map or the reduced one, with its exact derivatives.

The library has two maps from apex to apex. The return map is that of the full model. The reduced map places
the leg in flight as if by itself, so that the height and the speed of the centre of mass are all that an apex
has.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..checks import checked
from ..errors import InputError, RunError
from ..variables.table import Model, by_full_name
from ..variables.variable import Given
from .binding import c, ffi, text_of
from .c_structs import RETURN, viewed
from .gait import recorded
from .members import Along as Along
from .members import at_friction, check_varied, seed_of
from .quantities import LEDGER, MEASURES, STRIDE_QUANTITIES, Quantities, weight_of
from .runner import Runner
from .section import Apex, checked_apex

PATCH = ("ground.patch_begin", "ground.patch_end")
"""Beginning and end of a part of the ground with its own friction, along the ground."""


class Map:
    """The map of a runner of the package's own models, by the functions of the library."""

    def __init__(self, runner: Runner) -> None:
        refuse_patch(runner)
        self.runner = runner

    def stride(
        self,
        apex: NDArray[np.float64],
        until: float,
        *,
        varied: bool = False,
        along: Along | None = None,
        log: Any = None,
    ) -> Any:
        """One stride, the library's `tdmf_return`; with a log of events, also what is measured along it.

        A stride is differentiated by the coordinates, and along a direction, where it is `varied`.
        """
        runner, measured = self.runner, log is not None
        function = c.tdmf_measured_return_map if measured else c.tdmf_return_map
        if runner.reduced:
            function = c.tdmf_reduced_map
        seed = seed_of(along if varied else None)
        return function(
            runner.solver(log), runner.c_system, list(apex), until, varied, seed, seed != ffi.NULL
        )

    def settle(self, apex: NDArray[np.float64], strides: int) -> tuple[NDArray[np.float64], int]:
        """The last apex of some strides from an apex, and how many of them closed."""
        function = c.tdmf_settle_reduced if self.runner.reduced else c.tdmf_settle
        section = ffi.new("double[]", apex.tolist())
        closed: int = function(self.runner.solver(), self.runner.c_system, strides, section)
        return np.array(list(section)), closed

    def next_apex(self, stride: Any) -> NDArray[np.float64]:
        """The apex at which a stride closes."""
        return np.array(list(stride.apex)[: len(self.runner.coordinates)])

    def derivatives(self, stride: Any) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Derivatives of the next apex by the apex, and along the direction of the stride, else zero."""
        count = len(self.runner.coordinates)
        columns = [list(stride.variations[k].apex)[:count] for k in range(count + 1)]
        return np.array(columns[:count]).T, np.array(columns[count])

    def word(self, stride: Any) -> str:
        """Word of a stride."""
        return text_of(stride.stride.word)

    def reported(self, apex: NDArray[np.float64], stride: Any, log: Any) -> dict[str, Any]:
        """Word, angle at lift-off, quantities by name, and events of a stride that was logged."""
        runner, struct = self.runner, viewed(ffi.addressof(stride), RETURN)[0]
        quantities = Quantities(struct, apex, weight_of(runner), is_measured=not runner.reduced)
        names = (*STRIDE_QUANTITIES, *LEDGER, *(() if runner.reduced else MEASURES))
        return {
            "word": self.word(stride),
            "liftoff_angle": stride.liftoff_angle,
            "stride": {name: float(quantities[name]) for name in names},
            "events": recorded(log),
        }

    def why_not(self, stride: Any) -> str | None:
        """Reason why a stride did not close, in words; None where it did."""
        return why_no_return(stride)

    def is_unsolved(self, stride: Any) -> bool:
        """Whether the solver gave the stride up."""
        unsolved: bool = stride.outcome == c.TDMF_RETURN_UNSOLVED
        return unsolved


def map_of(runner: Runner) -> Map:
    """The map that a runner goes by."""
    made: Map = (runner.model.map_class or Map)(runner)
    return made


def refuse_patch(values: Mapping[str, float]) -> None:
    """Refuse a patch of ground: an apex does not determine where the foot is."""
    begin, end = (values.get(name, 0.0) for name in PATCH)
    if begin < end:
        raise InputError(
            f"ground.patch_end = {end:g}: gaits and maps of apices have no place for a patch of ground; "
            f"allowed: ground.patch_begin = {begin:g}, which is none; simulate, and "
            "stride_map by the full model without derivatives, take a patch"
        )


def why_no_return(stride: Any) -> str | None:
    """Reason why a stride ended, in words for a message; None where it closed."""
    own: str | None = getattr(stride, "why_not", None)  # of a model of one's own
    if own is not None:
        return str(own) or None
    if stride.outcome == c.TDMF_RETURN_CLOSED:
        return None
    if stride.outcome == c.TDMF_RETURN_UNSOLVED:
        return text_of(c.tdmf_outcome_text(stride.solver))
    return text_of(c.tdmf_return_outcome_text(stride.outcome))


LARGEST_SHARE = 1e100
"""Largest share of a parameter in a direction."""


def stride_from(
    runner: Runner | Mapping[str, Given], apex: Apex, along: Along
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """One stride from an apex: the next apex, and how it changes."""
    runner = Runner(runner)
    map = map_of(runner)
    stride = map.stride(checked_apex(apex, runner.coordinates), np.inf, varied=True, along=along)
    why_not = map.why_not(stride)
    if why_not is not None:
        raise RunError(f"no stride closes{at_friction(runner)}: {why_not}")
    return map.next_apex(stride), *derivatives(map, stride)


def derivatives(map: Map, stride: Any) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The Jacobian of a stride, and the next apex's change along the parameter asked for, else zero."""
    jacobian, by_parameter = map.derivatives(stride)
    if not (np.isfinite(jacobian).all() and np.isfinite(by_parameter).all()):
        raise RunError(
            f"a stride{at_friction(map.runner)} is on the edge of an event or of a law, where it has no "
            "derivatives"
        )
    return jacobian, by_parameter


def checked_direction(given: object, model: Model) -> Along:
    """A direction by the variables' own names; refused unless it is a name, or finite numbers by name."""
    if not isinstance(given, Mapping):
        name = model.full_name(given)
        check_varied(name, "along", model)
        return str(name)
    shares = by_full_name(given, "along", "numbers by name", model.aliases)
    for name, share in shares.items():
        check_varied(name, "along", model)
        shares[name] = checked(f"along: {name}", share, -LARGEST_SHARE, LARGEST_SHARE)
    return shares
