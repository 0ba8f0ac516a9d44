"""One stride from apex to apex, by the return map or the reduced one, with its exact derivatives.

The library has two maps from apex to apex. The return map is that of the full model. The reduced map places
the leg in flight as if by itself, so that the height and the speed of the centre of mass are all that an apex
has.
"""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from ..checks import checked
from ..errors import InputError, RunError
from ..variables.table import Model, by_full_name
from ..variables.variable import Given
from .members import Along as Along
from .members import at_friction, check_varied
from .page_strides import Strides
from .runner import Runner
from .section import Apex, checked_apex

PATCH = ("ground.patch_begin", "ground.patch_end")
"""Beginning and end of a part of the ground with its own friction, along the ground."""


def refuse_patch(values: Mapping[str, float]) -> None:
    """Refuse a patch of ground: an apex does not determine where the foot is."""
    begin, end = (values.get(name, 0.0) for name in PATCH)
    if begin < end:
        raise InputError(
            f"ground.patch_end = {end:g}: a runner on a patch has no periodic gait, because its next apex "
            f"depends on the foot's position; allowed: ground.patch_begin, {begin:g}, for no patch; "
            "simulate, strides_to_fall and stride_map without derivatives take a patch"
        )


LARGEST_SHARE = 1e100
"""Largest share of a parameter in a direction."""


def stride_from(
    runner: Runner | Mapping[str, Given], apex: Apex, along: Along
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """One stride from an apex: the next apex, and how it changes."""
    runner = Runner(runner)
    refuse_patch(runner)
    stride = runner.stride(checked_apex(apex, runner.coordinates), np.inf, varied=True, along=along)
    why_not = stride.why_not()
    if why_not:
        raise RunError(f"no stride closes{at_friction(runner)}: {why_not}")
    return stride.next_points[0], *derivatives(runner, stride)


def derivatives(runner: Runner, stride: Strides) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The Jacobian of a stride, and the next apex's change along the parameter asked for, else zero."""
    by, count = stride.next_points_by[0], len(runner.coordinates)
    if not np.isfinite(by).all():
        raise RunError(
            f"a stride{at_friction(runner)} is on the edge of an event or of a law, where it has no "
            "derivatives"
        )
    return by[:, :count], by[:, count] if by.shape[1] > count else np.zeros(count)


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
